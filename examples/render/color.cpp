#include "color.hpp"

#include <array>
#include <cmath>

namespace render {

double decoded(std::uint8_t level) {
    static const auto light = [] {
        std::array<double, 256> table;
        for (std::size_t i = 0; i < table.size(); ++i) {
            const double share = static_cast<double>(i) / 255;
            table[i] = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
        }
        return table;
    }();
    return light[level];
}

color encoded(const color& light) {
    const auto channel = [](double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; };
    return {channel(light.x), channel(light.y), channel(light.z)};
}

}  // namespace render
