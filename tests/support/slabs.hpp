#pragma once

#include <raio/bvh/ray_bundle.hpp>
#include <raio/math/interval.hpp>

#include <doctest/doctest.h>

#include <vector>

#include "support/random.hpp"

/// \file
/// Nodes of random boxes, rays among them, and which boxes these meet: in double, and by division alone.

namespace raio::test {

using detail::build_box;
using detail::node_width;
using detail::wide_node;

/// From where to where a ray is within a box, all of its sides moved outwards; empty if it is not.
template <class T>
interval<double> within_box(const ray<T>& r, const build_box& box, interval<double> window, double outwards = 0) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<glm::length_t>(axis);
        const double o = double(r.origin[at]), d = double(r.direction[at]);
        const double low = double(box.low(axis)) - outwards, high = double(box.high(axis)) + outwards;
        if (d == 0) {
            if (!(low <= o && o <= high)) return {};
        } else {
            const double a = (low - o) / d, b = (high - o) / d;
            window = {std::max(window.min, std::min(a, b)), std::min(window.max, std::max(a, b))};
        }
    }
    return window;
}

inline build_box random_box(random_numbers& random) {
    aabb<float> box;
    const auto whole = [&] { return static_cast<float>(random.integer(-8, 8)); };
    box = hull(box, vec3<float>(whole(), whole(), whole()));
    box.max = box.min;
    for (glm::length_t axis = 0; axis < 3; ++axis) {  // some without a thickness
        if (!random.one_in(5)) box.max[axis] += static_cast<float>(random.uniform(0, 8));
    }
    return detail::to_build_box(box);
}

/// The largest coordinate of these boxes.
inline constexpr float random_box_reach = 16;

/// A node of so many children, nodes all, by their places.
inline wide_node random_node(random_numbers& random, std::size_t children) {
    wide_node node;
    for (std::size_t i = 0; i < children; ++i) node.set(i, random_box(random));
    return node;
}

/// A ray that runs between whole numbers now and then, along sides and through edges, and along an axis as well, or all
/// but along it.
template <class T>
ray<T> random_ray(random_numbers& random) {
    ray<T> r;
    const bool along_axis = random.one_in(4);
    const int along = random.integer(0, 2);
    const T length = static_cast<T>(random.log_uniform(1e-3, 1e3));
    const auto place = [&](int size) {
        return static_cast<T>(random.one_in(2) ? random.integer(-size, size) : random.uniform(-size, size));
    };
    for (int axis = 0; axis < 3; ++axis) {
        r.origin[axis] = place(random.one_in(2) ? 9 : 20);
        r.direction[axis] = (place(9) - r.origin[axis]) * length;
        if (along_axis && axis != along) r.direction[axis] = random.one_in(2) ? T(0) : T(-0.0);
        if (random.one_in(20)) r.direction[axis] *= random.one_in(2) ? T(1e-12) : std::numeric_limits<T>::denorm_min();
    }
    if (norm1(r.direction) < T(1e-30)) r.direction[along] = length;
    if (random.one_in(8)) r.origin = vec3<T>(0);
    return r;
}

}  // namespace raio::test
