#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <raio/math/double_double.hpp>

/// \file
/// A number of 50 digits, in which a shape is its own oracle: floats and doubles go in without any error, and what
/// comes out is right far beyond their last bit.

namespace raio::test {

using oracle = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// The nearest T, of two equally near ones the even one.
template <class T>
T rounded(const oracle& x) {
    return x.convert_to<T>();
}

inline oracle exactly(double x) { return oracle(x); }
inline oracle exactly(strict_double x) { return oracle(static_cast<double>(x)); }

/// The double that it rounds to, and what is left.
inline oracle exactly(double_double x) {
    const double high = static_cast<double>(x);
    if (!std::isfinite(high)) return oracle(high);
    return oracle(high) + oracle(static_cast<double>(x - double_double(high)));
}

}  // namespace raio::test
