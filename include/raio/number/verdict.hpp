#pragma once

#include <raio/push_macros.hpp>

#include <raio/number/real.hpp>

namespace raio::inline RAIO_ABI {

/// The answer to a comparison of numbers that are known up to an error: in exact arithmetic it holds, or it does not,
/// or that is in doubt.
///
/// Verdicts are combined as Kleene's logic of three values does (Introduction to Metamathematics, 1952): one `no`
/// beyond doubt settles `every`, whatever the others are.
template <class Mask>
struct verdict {
    Mask certainly;  ///< does it hold, whatever the errors were?
    Mask possibly;   ///< may it hold?
    Mask yes;        ///< what the last precision, which has nobody to ask, answers: a tie holds where it says >=
};

template <class Mask>
RAIO_FN constexpr verdict<Mask> operator!(const verdict<Mask>& a) {
    return {!a.possibly, !a.certainly, !a.yes};
}

/// Is it beyond doubt?
template <class Mask>
RAIO_FN constexpr Mask is_settled(const verdict<Mask>& a) {
    return some(a.certainly, !a.possibly);
}

/// Does it hold in every lane, whatever the errors were? May it hold in any?
template <class Mask>
RAIO_FN constexpr bool all(const verdict<Mask>& a) {
    return all(a.certainly);
}
template <class Mask>
RAIO_FN constexpr bool any(const verdict<Mask>& a) {
    return any(a.possibly);
}

template <class Mask, std::same_as<verdict<Mask>>... More>
RAIO_FN constexpr verdict<Mask> every(const verdict<Mask>& a, const More&... more) {
    return {every(a.certainly, more.certainly...), every(a.possibly, more.possibly...), every(a.yes, more.yes...)};
}
template <class Mask, std::same_as<verdict<Mask>>... More>
RAIO_FN constexpr verdict<Mask> some(const verdict<Mask>& a, const More&... more) {
    return {some(a.certainly, more.certainly...), some(a.possibly, more.possibly...), some(a.yes, more.yes...)};
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
