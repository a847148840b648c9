#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "light.hpp"
#include "material.hpp"
#include "pigment.hpp"

namespace render {

world::world(render::scene scene) : scene_(std::move(scene)) {
    // A group counts its members type by type; sorted by type, objects have the same numbers.
    std::ranges::stable_sort(scene_.objects, {}, [](const object& o) { return o.shape.index(); });
    for (std::uint32_t index = 0; index < scene_.objects.size(); ++index) {
        const object& o = scene_.objects[index];
        std::visit([&]<class Shape>(const Shape& s) { std::get<std::vector<Shape>>(shapes_.members).push_back(s); },
                   o.shape);
        if (shines(scene_.materials[o.material]) && area(o.shape) > 0) emitters_.push_back(index);
    }
}

color world::color_at(const hit_record& rec) const {
    return render::color_at(scene_.pigments[scene_.objects[rec.index].pigment], rec.point);
}

const material& world::material_at(const hit_record& rec) const {
    return scene_.materials[scene_.objects[rec.index].material];
}

color world::background_in(const vec3& direction) const {
    const number height = (raio::normalize(direction).y + 1) / 2;
    return scene_.background.bottom * (1 - height) + scene_.background.top * height;
}

number world::clarity(number distance) const {
    return scene_.fog.density > 0 ? std::exp(-scene_.fog.density * distance) : 1;
}

}  // namespace render
