#pragma once

#include <raio/push_macros.hpp>

#include <type_traits>

#include <raio/number/real.hpp>

namespace raio::inline RAIO_ABI {

/// A number that is believed: what a formula finds in it is the answer, as a textbook takes it, and no closer look
/// follows. It is one T, and compiles to what that does: bounds of errors are reckoned only where they are recorded.
template <class T>
class plain {
public:
    plain() = default;
    template <class Number>
    requires std::is_arithmetic_v<Number> RAIO_FN constexpr plain(Number value) : value_(static_cast<T>(value)) {}
    RAIO_FN constexpr plain(const T& value) requires(!std::is_arithmetic_v<T>) : value_(value) {}
    template <class Number>
    requires(!std::is_arithmetic_v<Number> && !std::same_as<Number, T> &&
             requires(const Number& x) { static_cast<T>(x); }) RAIO_FN constexpr explicit plain(const Number& value)
        : value_(static_cast<T>(value)) {}

    RAIO_FN constexpr explicit operator T() const { return value_; }
    /// As another number of raio's, or built in.
    template <class Number>
    requires(!std::same_as<Number, T> && std::is_arithmetic_v<T> &&
             requires(const T& x) { static_cast<Number>(x); }) RAIO_FN constexpr explicit
    operator Number() const {
        return static_cast<Number>(value_);
    }

    RAIO_FN constexpr plain operator-() const { return -value_; }
    RAIO_FN friend constexpr plain operator+(const plain& a, const plain& b) { return a.value_ + b.value_; }
    RAIO_FN friend constexpr plain operator-(const plain& a, const plain& b) { return a.value_ - b.value_; }
    RAIO_FN friend constexpr plain operator*(const plain& a, const plain& b) { return a.value_ * b.value_; }
    RAIO_FN friend constexpr plain operator/(const plain& a, const plain& b) { return a.value_ / b.value_; }
    RAIO_FN constexpr plain& operator+=(const plain& b) { return *this = *this + b; }
    RAIO_FN constexpr plain& operator-=(const plain& b) { return *this = *this - b; }
    RAIO_FN constexpr plain& operator*=(const plain& b) { return *this = *this * b; }
    RAIO_FN constexpr plain& operator/=(const plain& b) { return *this = *this / b; }

    RAIO_FN friend constexpr mask_t<T> operator==(const plain& a, const plain& b) { return a.value_ == b.value_; }
    RAIO_FN friend constexpr mask_t<T> operator!=(const plain& a, const plain& b) { return a.value_ != b.value_; }
    RAIO_FN friend constexpr mask_t<T> operator<(const plain& a, const plain& b) { return a.value_ < b.value_; }
    RAIO_FN friend constexpr mask_t<T> operator<=(const plain& a, const plain& b) { return a.value_ <= b.value_; }
    RAIO_FN friend constexpr mask_t<T> operator>(const plain& a, const plain& b) { return a.value_ > b.value_; }
    RAIO_FN friend constexpr mask_t<T> operator>=(const plain& a, const plain& b) { return a.value_ >= b.value_; }

    RAIO_FN friend constexpr plain select(const mask_t<T>& where, const plain& a, const plain& b) {
        return select(where, a.value_, b.value_);
    }
    RAIO_FN static constexpr plain min(const plain& a, const plain& b) { return raio::min(a.value_, b.value_); }
    RAIO_FN static constexpr plain max(const plain& a, const plain& b) { return raio::max(a.value_, b.value_); }
    RAIO_FN static constexpr plain flip(const plain& x, const plain& sign) { return raio::flip(x.value_, sign.value_); }
    RAIO_FN friend constexpr plain sqrt(const plain& x) { return sqrt(x.value_); }
    RAIO_FN friend constexpr plain abs(const plain& x) { return abs(x.value_); }
    RAIO_FN friend constexpr plain floor(const plain& x) { return floor(x.value_); }
    RAIO_FN friend constexpr plain sin(const plain& x) { return sin(x.value_); }
    RAIO_FN friend constexpr plain cos(const plain& x) { return cos(x.value_); }
    RAIO_FN friend constexpr plain copysign(const plain& magnitude, const plain& sign) {
        return copysign(magnitude.value_, sign.value_);
    }
    RAIO_FN friend constexpr plain atan2(const plain& y, const plain& x) { return atan2(y.value_, x.value_); }

private:
    T value_;
};

template <class T>
struct real_traits<plain<T>> : detail::one_number<plain<T>> {
    using scalar = plain<scalar_t<T>>;
    using mask = mask_t<T>;
    using index = index_t<T>;
};

// One number that converts to it, which the compiler knows of packs as well.
template <class T>
inline constexpr scalar_t<T> infinity<plain<T>> = infinity<scalar_t<T>>;
template <class T>
inline constexpr scalar_t<T> pi<plain<T>> = pi<scalar_t<T>>;

/// Is it a number that is believed?
template <class W>
inline constexpr bool is_believed = false;
template <class T>
inline constexpr bool is_believed<plain<T>> = true;

}  // namespace raio::inline RAIO_ABI

template <class T>
class std::numeric_limits<raio::plain<T>> : public std::numeric_limits<T> {};

#include <raio/pop_macros.hpp>
