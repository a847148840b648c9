#include <algorithm>
#include <cmath>
#include <string>

#include <raio/shape/algebraic.hpp>
#include <raio/shape/blob.hpp>
#include <raio/shape/quadric.hpp>
#include <raio/shape/steiner.hpp>
#include <raio/shape/teardrop.hpp>
#include <raio/shape/torus.hpp>

#include "shape_readings.hpp"

namespace render {
namespace {

template <bool Closed>
shape read_quadric(tokens& in, int) {
    const auto [min, max] = read_clip(in, "the box of a quadric");
    constexpr auto what = "the coefficients of a quadric";
    const vec3 squares = vector(in, what), products = vector(in, what), linear = vector(in, what);
    const number constant = in.expect_number(what);
    if (squares == vec3(0) && products == vec3(0) && linear == vec3(0)) {
        in.fail("a quadric that is the same everywhere", "coefficients that are not all 0");
    }
    return raio::quadric<number, Closed>{min, max, squares, products, linear, constant};
}

template <bool Closed>
shape read_algebraic(tokens& in, int) {
    constexpr unsigned highest = 8;
    const auto [min, max] = read_clip(in, "the box of an algebraic surface");
    unsigned degree = 0;
    const auto terms = section(in, "terms of an algebraic surface", [&] {
        raio::algebraic_term<number> term{};
        term.coefficient = in.expect_number("a coefficient of an algebraic surface");
        for (unsigned* power : {&term.x, &term.y, &term.z}) {
            constexpr requirement whole{"a whole number from 0 to 8",
                                        [](double x) { return x >= 0 && x <= highest && x == std::floor(x); }};
            *power = static_cast<unsigned>(in.expect_number("a power of an algebraic surface", whole));
        }
        const unsigned sum = term.x + term.y + term.z;
        if (sum > highest) in.fail("a term of degree " + std::to_string(sum), "at most 8");
        if (term.coefficient != 0) degree = std::max(degree, sum);
        return term;
    });
    if (degree == 0) in.fail("an algebraic surface that is the same everywhere", "a term with a power above 0");
    if (degree <= 4) return raio::algebraic<number, 4, Closed>{min, max, terms};
    return raio::algebraic<number, highest, Closed>{min, max, terms};
}

shape read_teardrop(tokens& in, int) {
    const vec3 bottom = vector(in, "the bottom of a teardrop"), tip = vector(in, "the tip of a teardrop");
    if (bottom == tip) in.fail("the bottom again", "another tip of a teardrop");
    return raio::teardrop<number>{bottom, tip, in.expect_number("the radius of a teardrop", positive)};
}

shape read_blob(tokens& in, int) {
    raio::blob<number, 16> blob{{}, in.expect_number("the threshold of a blob", positive)};
    const auto components = section(in, "components of a blob", [&] {
        const bool is_capsule = in.peek() == "capsule";
        if (is_capsule) in.expect_word("a capsule");
        raio::metaball<number> m{vector(in, "the centre of a blob's component"), {}};
        if (is_capsule) m.axis = vector(in, "the other end of a blob's capsule") - m.center;
        m.radius = in.expect_number("the radius of a blob's component", positive);
        m.strength = in.expect_number("the strength of a blob's component");
        return m;
    });
    if (components.empty() || components.size() > blob.components.size()) {
        in.fail(std::to_string(components.size()) + " components", "a blob of 1 to 16");
    }
    std::ranges::copy(components, blob.components.begin());
    return blob;
}

}  // namespace

shape_readings algebraic_shapes() {
    return {
        {"quadric", read_quadric<true>},
        {"open_quadric", read_quadric<false>},
        {"algebraic", read_algebraic<true>},
        {"open_algebraic", read_algebraic<false>},
        {"steiner", plain<raio::steiner<number>>("a Steiner surface", point{"centre"}, measure{"size"})},
        {"teardrop", read_teardrop},
        {"blob", read_blob},
        {"torus", plain<raio::torus<number>>("a torus", point{"centre"}, axis{"axis"}, measure{"major radius"},
                                             measure{"minor radius"})},
    };
}

}  // namespace render
