#pragma once

#include <raio/push_macros.hpp>

#include <cstring>

#include <raio/concepts.hpp>
#include <raio/number/simd.hpp>
#include <raio/proof/lanes.hpp>

/// \file
/// N shapes in one shape of packs, which stand in the leaves of a tree.

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// What a shape says of its crossings: one, a chord, or two.
template <class Found, class W>
concept crossings_of =
    std::same_as<Found, crossing<W>> || std::same_as<Found, chord<W>> || std::same_as<Found, chord_pair<W>>;

template <class Shape, class W>
concept gatherable_as = aggregate_of_packs<rebind_t<Shape, W>, W> &&
    requires(const rebind_t<Shape, W> packed, const ray<W> ray) {
    { packed.crossings(line_in<W>(ray)) } -> crossings_of<W>;
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

/// A shape that is the hull of three corners.
template <class Shape>
concept three_cornered = requires(const Shape s) {
    { s.a } -> std::convertible_to<vec3<number_t<Shape>>>;
    { s.b } -> std::convertible_to<vec3<number_t<Shape>>>;
    { s.c } -> std::convertible_to<vec3<number_t<Shape>>>;
    s.area();
};

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

    Shape get(std::size_t lane) const { return in_lane<pack<T, N>>(shapes(), lane); }

    const packed& shapes() const { return *reinterpret_cast<const packed*>(bytes_); }

private:
    static constexpr std::size_t numbers = sizeof(Shape) / sizeof(T);
    static constexpr std::size_t offset(std::size_t k, std::size_t lane) { return (k * N + lane) * sizeof(T); }

    alignas(packed) std::byte bytes_[sizeof(packed)];
};

/// The same shapes as packs P, number by number.
template <class P, class Packed>
decltype(auto) as_packs_of(const Packed& packed) {
    using own = number_t<Packed>;
    if constexpr (std::same_as<P, own>) {
        return packed;
    } else {
        rebind_t<Packed, P> wide;
        for (std::size_t k = 0; k < sizeof(Packed) / sizeof(own); ++k) {
            own numbers;
            std::memcpy(&numbers, reinterpret_cast<const std::byte*>(&packed) + k * sizeof(own), sizeof(own));
            const P converted(numbers);
            std::memcpy(reinterpret_cast<std::byte*>(&wide) + k * sizeof(P), &converted, sizeof(P));
        }
        return wide;
    }
}

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

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
