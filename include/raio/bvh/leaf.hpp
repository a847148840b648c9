#pragma once

#include <raio/push_macros.hpp>

#include <optional>
#include <vector>

#include <raio/bvh/collapse.hpp>
#include <raio/bvh/gather.hpp>
#include <raio/compose/quick.hpp>

/// \file
/// The shapes at the leaves of a tree, and what a ray finds there.
///
/// Shapes that fit in packs stand in blocks, and a block is tested together, in the precision of the pack. Its
/// crossings state their errors: so the answer of a lane is a fact, or it is open, and then the plain shape is asked.

namespace raio::inline RAIO_ABI {

template <real T>
struct sphere;
template <real T>
struct box;
template <real T>
struct parallelogram;

}  // namespace raio::inline RAIO_ABI

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// Are eight shapes tested about as fast as the boxes of a node?
template <class Shape>
inline constexpr bool tested_quickly = three_cornered<Shape> || brings_lanes<Shape>;
template <class T>
inline constexpr bool tested_quickly<sphere<T>> = true;
template <class T>
inline constexpr bool tested_quickly<box<T>> = true;
template <class T>
inline constexpr bool tested_quickly<parallelogram<T>> = true;
template <class P>
inline constexpr bool tested_quickly<quick<P>> = tested_quickly<P>;

/// The lanes of a block: as many as a register has, but no more than are worth it. A block of sixteen takes twice as
/// long as one of eight, and most of its shapes are missed. Of shapes that take longer each has a leaf of its own: a
/// ray that enters the box around eight meets the boxes of one or none of them, and a node tests all of these at once.
template <class Shape>
inline constexpr std::size_t block_lanes = tested_quickly<Shape>
                                               ? std::clamp<std::size_t>(native_lanes<number_t<Shape>>, 2, 8)
                                               : 1;

/// What is known of the crossings of N lanes: those of which a bit is set in `sure` lie in [low, high], and that in
/// the window; those in `open` may do anything.
template <class T, std::size_t N>
struct findings {
    std::uint32_t sure, open;
    pack<T, N> low, high;
};

/// What the lanes of a block compute with, and the ray in them. Quick shapes are believed in their own numbers. Floats
/// only sieve: in their own numbers, or in what holds those of a ray that was mapped. Doubles are what plain ones are
/// in the first precision.
template <class Shape, class Ray, std::size_t N, class T = number_t<Shape>>
using lanes_for = std::conditional_t<
    is_quick<Shape>, plain<pack<T, N>>,
    pack<std::conditional_t<keeps_all_digits<T>, strict_double, std::conditional_t<is_mapped<Ray>, double, T>>, N>>;

/// A ray in every lane. One that was mapped is so already.
template <class W, class T>
ray<W> in_every_lane(const ray<T>& r) {
    return {vec3<W>(r.origin), vec3<W>(r.direction)};
}
template <class W, class T>
const mapped_ray<T>& in_every_lane(const mapped_ray<T>& r) {
    return r;
}

/// Shapes in blocks of packs.
template <class Shape>
class leaf_blocks {
public:
    using T = number_t<Shape>;
    using shape_type = Shape;
    static constexpr std::size_t lanes = block_lanes<Shape>;

    void resize(std::span<const leaf_range> ranges) { blocks_.resize(ranges.size()); }
    std::uint32_t size() const { return static_cast<std::uint32_t>(blocks_.size()); }
    std::size_t bytes() const { return blocks_.size() * sizeof(block); }

    /// \param shape_of  the shape of an id
    template <class ShapeOf>
    void fill(std::size_t i, std::span<const std::uint32_t> ids, ShapeOf shape_of) {
        // In order, without asking which of two is larger: that is guessed wrong as often as not.
        std::array<std::uint32_t, lanes> given, sorted, own;
        given.fill(no_id), sorted.fill(no_id);
        std::ranges::copy(ids, given.begin());
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            std::size_t before = 0;
            for (const std::uint32_t other : given) before += other < given[lane] ? 1u : 0u;
            sorted[before] = given[lane];
        }
        // Several pieces of one shape have come to one place.
        std::size_t count = 0;
        for (const std::uint32_t id : sorted) {
            own[count] = id;
            count += id != no_id ? 1 : 0;
        }
        block& b = blocks_[i];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            // A lane without a shape repeats the last one.
            b.shapes.set(lane, shape_of(own[std::min(lane, count - 1)]));
            b.ids[lane] = lane < count ? own[lane] : no_id;
        }
    }

    std::uint32_t used(std::uint32_t i) const { return blocks_[i].used(); }
    std::uint32_t id(std::uint32_t i, unsigned lane) const { return blocks_[i].ids[lane]; }
    Shape shape(std::uint32_t i, unsigned lane) const { return Shape{blocks_[i].shapes.get(lane)}; }
    decltype(auto) shapes(std::uint32_t i) const { return blocks_[i].shapes.shapes(); }
    void set(std::uint32_t i, unsigned lane, const Shape& shape) { blocks_[i].shapes.set(lane, shape); }

    /// What packs know of the crossings with a ray, as it is or mapped.
    template <class Ray>
    findings<T, lanes> find(std::uint32_t i, const Ray& along, T t_min, T t_max) const {
        using W = lanes_for<Shape, Ray, lanes>;
        using S = scalar_t<W>;
        const block& b = blocks_[i];
        const auto& ray = in_every_lane<pack<T, lanes>>(along);
        t_min = within_numbers(t_min), t_max = within_numbers(t_max);
        S from = t_min, to = t_max;
        // More digits than T has may be rounded into the window.
        if constexpr (unit_roundoff<S> < unit_roundoff<T>) from = widened<S>(t_min, -1), to = widened<S>(t_max, 1);
        using numbers = pack<T, lanes>;
        const auto crossings = [&] {
            if constexpr (keeps_all_digits<T> || is_quick<Shape>) {
                return crossings_for<W, question::where>(b.shapes.shapes(), ray, W(from), W(to));
            } else {
                return crossings_for<W, question::where>(as_packs_of<W>(b.shapes.shapes()), ray, W(from), W(to));
            }
        };
        const sifted<numbers> is = sift(crossings(), numbers(t_min), numbers(t_max));
        findings<T, lanes> found{bits(is.sure), is_quick<Shape> ? 0 : bits(is.open), is.low, is.high};
        constexpr std::uint32_t all = ~std::uint32_t{0} >> (32 - lanes);
        if (((found.sure | found.open) & all) != 0) {
            const std::uint32_t used = b.used();
            found.sure &= used, found.open &= used;
        } else {
            found.open = 0;
        }
        return found;
    }

private:
    static constexpr std::uint32_t no_id = ~std::uint32_t{0};

    struct block {
        gathered<Shape, lanes> shapes;
        std::array<std::uint32_t, lanes> ids;

        std::uint32_t used() const {
            using numbers = pack<std::uint32_t, lanes>;
            return bits(numbers::load(ids.data()) != numbers(no_id));
        }
    };

    large_vector<block> blocks_;
};

/// Shapes that have no shape of packs, each a leaf: what is found in it is open.
template <class Shape>
class leaf_list {
public:
    using T = number_t<Shape>;
    using shape_type = Shape;
    static constexpr std::size_t lanes = 1;

    void resize(std::span<const leaf_range> ranges) { shapes_.resize(ranges.size()), ids_.resize(ranges.size()); }
    std::uint32_t size() const { return static_cast<std::uint32_t>(ids_.size()); }
    std::size_t bytes() const { return size() * (sizeof(shapes_[0]) + sizeof(std::uint32_t)); }

    template <class ShapeOf>
    void fill(std::size_t i, std::span<const std::uint32_t> ids, ShapeOf shape_of) {
        shapes_[i] = shape_of(ids[0]), ids_[i] = ids[0];
    }

    static std::uint32_t used(std::uint32_t) { return 1; }
    std::uint32_t id(std::uint32_t i, unsigned) const { return ids_[i]; }
    const Shape& shape(std::uint32_t i, unsigned) const { return *shapes_[i]; }
    void set(std::uint32_t i, unsigned, const Shape& shape) { shapes_[i] = shape; }

private:
    std::vector<std::optional<Shape>> shapes_;  // not every shape can be empty; all of these are set by `fill`
    std::vector<std::uint32_t> ids_;
};

template <class Shape>
using leaves_of = std::conditional_t<gatherable<Shape>, leaf_blocks<Shape>, leaf_list<Shape>>;

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
