#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/build_box.hpp>
#include <raio/bvh/large_pages.hpp>
#include <raio/number/simd.hpp>
#include <raio/proof/mapped_ray.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// How many children a node has: as many floats as there are in a register.
inline constexpr std::size_t node_width = std::max<std::size_t>(4, native_lanes<float>);

/// What a child is: another node, or a block of shapes of one kind.
struct child {
    static constexpr std::uint32_t leaf_bit = 1u << 31;
    static constexpr unsigned kind_shift = 27;

    static constexpr std::uint32_t leaf(std::uint32_t kind, std::uint32_t block) {
        return leaf_bit | kind << kind_shift | block;
    }
    static constexpr bool is_leaf(std::uint32_t c) { return (c & leaf_bit) != 0; }
    static constexpr std::uint32_t kind(std::uint32_t c) { return (c & ~leaf_bit) >> kind_shift; }
    static constexpr std::uint32_t block(std::uint32_t c) { return c & ((1u << kind_shift) - 1); }
};

/// The boxes of all children, coordinate by coordinate, and the children. A place without a child holds a box without
/// points, which no ray meets.
///
/// Leaves have the first places. The nodes after them stand side by side in the tree, so that a ray that goes on to one
/// need not wait until its number has been read.
struct alignas(64) wide_node {
    std::array<std::array<float, node_width>, 6> planes;  ///< low x, high x, low y, high y, low z, high z
    std::array<std::uint32_t, node_width> leaves{};
    std::uint32_t leaf_count = 0;
    std::uint32_t first_node = 0;  ///< the node at place `leaf_count`, if there is one

    std::uint32_t child_at(std::size_t place) const {
        if (place < leaf_count) [[unlikely]]
            return leaves[place];
        return first_node + (static_cast<std::uint32_t>(place) - leaf_count);
    }

    wide_node() {
        for (unsigned i = 0; i < 6; ++i) planes[i].fill(i % 2 == 0 ? build_box::none : -build_box::none);
    }

    void set(std::size_t i, const build_box& box) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            planes[2 * axis][i] = box.low(axis);
            planes[2 * axis + 1][i] = box.high(axis);
        }
    }

    build_box box(std::size_t i) const {
        build_box b;
        for (unsigned axis = 0; axis < 3; ++axis) {
            b.v.set(axis, planes[2 * axis][i]);
            b.v.set(axis + 4, -planes[2 * axis + 1][i]);
        }
        return b;
    }
};

/// What becomes of a ray along an axis: the axes side by side, or many rays along one.
///
/// The ray passes the plane x = p at t = p r - o r with r = 1 / d, one fused multiply-add. All roundings together, that
/// of r included, are off by no more than 5 u (|p| + |o|) |r| (compare Ize, Robust BVH ray traversal, JCGT 2(2), 2013):
/// with 8 u (size + |o|) |r| taken off where a box is entered and added where it is left, |p| <= size, no box is missed
/// that the exact ray meets, nor one that holds a crossing whose t was rounded. These constants are found once for each
/// ray, so that it costs the nodes nothing.
///
/// A direction's component below 2^-30 of all of them is taken for that much: within the scene this moves the ray by
/// less than the above. So no component is zero.
template <class Numbers>
struct slab_numbers {
    Numbers over_direction, enter, leave;
    Numbers slack;

    /// \param length  of the direction: its components' sizes, added up
    /// \param reach   the largest coordinate of all boxes, and the sizes of the origin's components, added up
    slab_numbers(const Numbers& origin, const Numbers& direction, const Numbers& length, const Numbers& reach) {
        Numbers least = length * Numbers(0x1p-30f), divisor = direction;
        const mask_t<Numbers> small = abs(direction) < least;
        if (any(small)) [[unlikely]]
            divisor = select(small, copysign(least, direction), direction);
        over_direction = Numbers(1) / divisor;
        slack = reach * Numbers(0x1p-20f) * abs(over_direction) + Numbers(std::numeric_limits<float>::min());
        Numbers k = origin * over_direction;
        enter = k + slack, leave = k - slack;
    }

    /// Out of range the formula is no good. What is not a number is out of range.
    template <class Number>
    static auto fits(const Number& length, const Number& reach) {
        return every(length > Number(0x1p-90f), length < Number(0x1p100f), reach < length * Number(0x1p90f));
    }
};

/// A mapped ray without its errors.
template <class T>
ray<double> values_of(const mapped_ray<T>& ray) {
    const auto in_double = [](const auto& v) {
        return vec3<double>(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
    };
    return {in_double(line_in<strict_double>(ray).origin()), in_double(line_in<strict_double>(ray).direction())};
}

/// A ray as the nodes want it.
class node_ray {
public:
    using numbers = pack<float, node_width>;

    /// \param scale  of the boxes, a power of two, over what they stand for
    /// \param size   the largest coordinate of all boxes
    template <class T>
    node_ray(const ray<T>& ray, T scale, float size) {
        using four = pack<float, 4>;  // x, y, z, and x once more
        const auto in_lanes = [&](const vec3<T>& v) {
            const vec3<T> w = v * scale;
            const float lanes[] = {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z),
                                   static_cast<float>(w.x)};
            return four::load(lanes);
        };
        const auto sum_of = [](const four& v) { return v[0] + v[1] + v[2]; };
        four o = in_lanes(ray.origin), d = in_lanes(ray.direction);
        const float length = sum_of(abs(d)), reach = size + sum_of(abs(o));
        four r(1), enter(std::numeric_limits<float>::max()), leave = -enter;
        fits_ = slab_numbers<four>::fits(length, reach);
        if (fits_) [[likely]] {
            const slab_numbers<four> slabs(o, d, four(length), four(reach));
            r = slabs.over_direction, enter = slabs.enter, leave = slabs.leave;
        }
        const std::uint32_t backward = bits(r < four(0));
        for (unsigned i = 0; i < 3; ++i) {
            near_[i] = 2 * i + (backward >> i & 1);
            over_direction_[i] = numbers(r[i]), enter_[i] = numbers(enter[i]), leave_[i] = numbers(leave[i]);
        }
    }

    /// A ray that was mapped. Half of what the formula is off by is left for its errors; if they are larger, every box
    /// is taken for met.
    template <class T>
    node_ray(const mapped_ray<T>& ray, T scale, float size)
        : node_ray(values_of(ray), static_cast<double>(scale), size) {
        const auto line = line_in<strict_double>(ray);
        const auto reach = strict_double(size) / strict_double(scale) + size_of(line.origin());
        fits_ = fits_ && line.origin().error <= reach * strict_double(0x1p-26) &&
                line.direction().error <= size_of(line.direction()) * strict_double(0x1p-31);
    }

    /// Is the ray in the range of the formula? Of one that is not, which may be no ray at all, every box is taken for
    /// met.
    bool fits() const { return fits_; }

    /// Which children are met between `t_min` and `t_max`, one bit for each, and where the ray enters them.
    std::uint32_t meets(const wide_node& node, const numbers& t_min, const numbers& t_max, numbers& entry) const {
        const auto at = [&](unsigned plane, unsigned axis, const numbers& k) {
            return numbers::load(node.planes[plane].data()) * over_direction_[axis] - k;
        };
        numbers x = at(near_[0], 0, enter_[0]), y = at(near_[1], 1, enter_[1]), z = at(near_[2], 2, enter_[2]);
        numbers u = at(near_[0] ^ 1, 0, leave_[0]), v = at(near_[1] ^ 1, 1, leave_[1]);
        numbers w = at(near_[2] ^ 1, 2, leave_[2]);
        entry = numbers::max(numbers::max(x, y), numbers::max(z, t_min));
        return bits(entry <= numbers::min(numbers::min(u, v), numbers::min(w, t_max)));
    }

private:
    std::array<numbers, 3> over_direction_, enter_, leave_;
    std::array<unsigned, 3> near_;
    bool fits_;
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
