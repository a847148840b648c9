#pragma once

#include <raio/push_macros.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <raio/number/simd_register.hpp>

namespace raio::inline RAIO_ABI::inline RAIO_REGISTERS {

/// What a comparison of packs answers: yes or no in each of N lanes. One type for all packs of numbers as large as S,
/// which is `float` or `double`.
///
/// Where the processor has masks of bits, it is one bit a lane, whatever the numbers and however many registers they
/// take: masks of any two packs of N lanes go together then without a conversion.
template <std::floating_point S, std::size_t N>
class pack_mask {
public:
    pack_mask() = default;
    /// The same in every lane.
    RAIO_FN constexpr pack_mask(std::same_as<bool> auto value) {
        if constexpr (is_bits) {
            parts_[0] = value ? every_bit : 0;
        } else {
            detail::fill(parts_, [&](std::size_t) { return part(value); });
        }
    }

    /// The same lanes, of packs of numbers of another size.
    template <std::floating_point Other>
    requires(!std::same_as<Other, S>) RAIO_FN constexpr pack_mask(const pack_mask<Other, N>& other);

    RAIO_FN constexpr bool operator[](std::size_t lane) const { return (bits(*this) >> lane & 1) != 0; }

    RAIO_FN friend constexpr pack_mask operator&(const pack_mask& a, const pack_mask& b) {
        return made([&](std::size_t i) { return a.parts_[i] & b.parts_[i]; });
    }
    RAIO_FN friend constexpr pack_mask operator|(const pack_mask& a, const pack_mask& b) {
        return made([&](std::size_t i) { return a.parts_[i] | b.parts_[i]; });
    }
    RAIO_FN constexpr pack_mask operator!() const {
        return made([&](std::size_t i) {
            if constexpr (is_bits) {
                return parts_[i] ^ every_bit;
            } else if constexpr (std::same_as<part, bool>) {
                return !parts_[i];
            } else {
                return ~parts_[i];  // one instruction; xsimd's ! compares with zero, by halves where there is no AVX2
            }
        });
    }
    RAIO_FN friend constexpr pack_mask operator!=(const pack_mask& a, const pack_mask& b) { return (a | b) & !(a & b); }
    RAIO_FN friend constexpr pack_mask operator==(const pack_mask& a, const pack_mask& b) { return !(a != b); }
    RAIO_FN friend constexpr pack_mask operator&&(const pack_mask& a, const pack_mask& b) { return a & b; }
    RAIO_FN friend constexpr pack_mask operator||(const pack_mask& a, const pack_mask& b) { return a | b; }

    RAIO_FN friend constexpr pack_mask select(const pack_mask& where, const pack_mask& a, const pack_mask& b) {
        return (where && a) || (!where && b);
    }

    /// Takes these lanes over from another mask. The rest stays as it is, and need have no value.
    RAIO_FN constexpr void take(const pack_mask& where, const pack_mask& from) {
        if constexpr (std::same_as<part, bool>) {
            for (std::size_t i = 0; i < count; ++i) {
                if (where.parts_[i]) parts_[i] = from.parts_[i];
            }
        } else {
            *this = select(where, from, *this);
        }
    }

    RAIO_FN friend constexpr bool any(const pack_mask& mask) { return bits(mask) != 0; }
    RAIO_FN friend constexpr bool none(const pack_mask& mask) { return bits(mask) == 0; }
    RAIO_FN friend constexpr bool all(const pack_mask& mask) { return bits(mask) == every_bit; }

    /// One bit for each lane, the lowest for the first.
    RAIO_FN friend constexpr std::uint32_t bits(const pack_mask& mask) {
        std::uint32_t all = 0;
        detail::repeat<count>([&](std::size_t i) { all |= detail::bits_of(mask.parts_[i]) << (i * (N / count)); });
        return all;
    }

private:
    template <class, std::size_t>
    friend class pack;
    template <std::floating_point, std::size_t>
    friend class pack_mask;

    static constexpr std::uint32_t every_bit = ~std::uint32_t{0} >> (32 - N);

    using numbers = detail::register_of<S, N>;
    static constexpr std::size_t registers = N * sizeof(S) / sizeof(numbers);
    static constexpr bool is_bits = detail::has_bit_masks<numbers>;
    using part = std::conditional_t<is_bits, std::uint32_t, detail::register_mask<numbers>>;
    static constexpr std::size_t count = is_bits ? 1 : registers;

    template <class F>
    RAIO_FN static constexpr pack_mask made(F f) {
        pack_mask mask;
        detail::fill(mask.parts_, f);
        return mask;
    }

    /// What a comparison of registers answers; `f` compares those of a number.
    template <class F>
    RAIO_FN static constexpr pack_mask compared(F f) {
        if constexpr (is_bits) {
            pack_mask mask(false);
            detail::repeat<registers>(
                [&](std::size_t i) { mask.parts_[0] |= detail::bits_of(f(i)) << (i * (N / registers)); });
            return mask;
        } else {
            return made([&](std::size_t i) { return std::bit_cast<part>(f(i)); });
        }
    }

    /// The mask of a register.
    RAIO_FN constexpr detail::register_mask<numbers> of_register(std::size_t i) const {
        if constexpr (is_bits) {
            using bits_of_register = decltype(detail::register_mask<numbers>::data);
            return detail::register_mask<numbers>(static_cast<bits_of_register>(parts_[0] >> (i * (N / registers))));
        } else {
            return parts_[i];
        }
    }

    part parts_[count];
};

}  // namespace raio::inline RAIO_ABI::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
