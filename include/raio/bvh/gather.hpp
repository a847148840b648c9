#pragma once

#include <cstring>

#include <raio/concepts.hpp>
#include <raio/math/simd.hpp>

/// \file
/// N shapes in one shape of packs. A shape is an aggregate of numbers, and so is the shape of packs: where the one has
/// its k-th number, the other has its k-th pack. So a shape goes into a lane, and comes out again, number by number,
/// and nothing needs to be known of its fields.

namespace raio::detail {

/// The same shape, made of another number type.
template <class Shape, class U>
struct rebind;
template <template <real> class Shape, real T, class U>
struct rebind<Shape<T>, U> {
    using type = Shape<U>;
};
template <class Shape, class U>
using rebind_t = typename rebind<Shape, U>::type;

/// What a shape says of its crossings: one, or a chord.
template <class Found, class W>
concept crossings_of = std::same_as<Found, crossing<W>> || std::same_as<Found, chord<W>>;

template <class Shape, class W, class T = number_t<Shape>>
concept gatherable_as = std::is_trivially_copyable_v<Shape> && sizeof(Shape) % sizeof(T) == 0 &&
                        sizeof(rebind_t<Shape, W>) == sizeof(Shape) / sizeof(T) * sizeof(W) &&
                        requires(const rebind_t<Shape, W> packed, const ray<W> ray) {
    { packed.template crossings<W>(ray) } -> crossings_of<W>;
};

/// Does the shape bring its own room for N of it, since it is no aggregate of numbers?
template <class Shape>
concept brings_lanes = requires {
    typename Shape::template lanes<4>;
};

/// Has the shape a shape of packs?
template <class Shape>
concept gatherable = std::floating_point<number_t<Shape>> &&
    (brings_lanes<Shape> || gatherable_as<Shape, pack<number_t<Shape>, 4>>);

/// Room for N shapes, lane by lane.
template <gatherable Shape, std::size_t N>
class gathered_numbers {
public:
    using T = number_t<Shape>;
    using packed = rebind_t<Shape, pack<T, N>>;

    void set(std::size_t lane, const Shape& shape) {
        for (std::size_t k = 0; k < numbers; ++k) {
            std::memcpy(bytes_ + offset(k, lane), reinterpret_cast<const std::byte*>(&shape) + k * sizeof(T),
                        sizeof(T));
        }
    }

    Shape get(std::size_t lane) const {
        // Put together in place, number by number: as a whole it would have to wait for the numbers to reach memory.
        Shape shape;
        for (std::size_t k = 0; k < numbers; ++k) {
            std::memcpy(reinterpret_cast<std::byte*>(&shape) + k * sizeof(T), bytes_ + offset(k, lane), sizeof(T));
        }
        return shape;
    }

    const packed& shapes() const { return *reinterpret_cast<const packed*>(bytes_); }

private:
    static constexpr std::size_t numbers = sizeof(Shape) / sizeof(T);
    static constexpr std::size_t offset(std::size_t k, std::size_t lane) { return (k * N + lane) * sizeof(T); }

    alignas(packed) std::byte bytes_[sizeof(packed)];
};

template <class Shape, std::size_t N>
struct find_gathered {
    using type = gathered_numbers<Shape, N>;
};
template <brings_lanes Shape, std::size_t N>
struct find_gathered<Shape, N> {
    using type = typename Shape::template lanes<N>;
};
template <gatherable Shape, std::size_t N>
using gathered = typename find_gathered<Shape, N>::type;

}  // namespace raio::detail
