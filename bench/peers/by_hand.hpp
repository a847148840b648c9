#pragma once

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include <cstddef>
#include <utility>

#include <raio/ray.hpp>

/// \file
/// The kernels that one would write by hand for one ray against many shapes: no bound of an error, no care for what is
/// degenerate, every product fused with its sum, everything about the ray alone computed once. What a compiler makes of
/// the shapes' own source is measured against these.

namespace peers {

/// The instructions of one set.
#if defined(__AVX512F__)
struct avx512 {
    using number = __m512;
    using mask = __mmask16;
    static constexpr std::size_t lanes = 16;

    static number all(float x) { return _mm512_set1_ps(x); }
    static number load(const float* from) { return _mm512_loadu_ps(from); }
    static number add(number a, number b) { return _mm512_add_ps(a, b); }
    static number sub(number a, number b) { return _mm512_sub_ps(a, b); }
    static number mul(number a, number b) { return _mm512_mul_ps(a, b); }
    static number div(number a, number b) { return _mm512_div_ps(a, b); }
    static number fma(number a, number b, number c) { return _mm512_fmadd_ps(a, b, c); }
    static number fms(number a, number b, number c) { return _mm512_fmsub_ps(a, b, c); }
    static number fnma(number a, number b, number c) { return _mm512_fnmadd_ps(a, b, c); }
    static number min(number a, number b) { return _mm512_min_ps(a, b); }
    static number max(number a, number b) { return _mm512_max_ps(a, b); }
    static number sqrt(number a) { return _mm512_sqrt_ps(a); }
    static mask less_equal(number a, number b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
    static mask both(mask a, mask b) { return a & b; }
    static bool none(mask a) { return a == 0; }
    static number select(mask m, number a, number b) { return _mm512_mask_blend_ps(m, b, a); }
    static void store(float* to, number a) { _mm512_storeu_ps(to, a); }
};
#endif
#if defined(__AVX2__) && defined(__FMA__)
struct avx2 {
    using number = __m256;
    using mask = __m256;
    static constexpr std::size_t lanes = 8;

    static number all(float x) { return _mm256_set1_ps(x); }
    static number load(const float* from) { return _mm256_loadu_ps(from); }
    static number add(number a, number b) { return _mm256_add_ps(a, b); }
    static number sub(number a, number b) { return _mm256_sub_ps(a, b); }
    static number mul(number a, number b) { return _mm256_mul_ps(a, b); }
    static number div(number a, number b) { return _mm256_div_ps(a, b); }
    static number fma(number a, number b, number c) { return _mm256_fmadd_ps(a, b, c); }
    static number fms(number a, number b, number c) { return _mm256_fmsub_ps(a, b, c); }
    static number fnma(number a, number b, number c) { return _mm256_fnmadd_ps(a, b, c); }
    static number min(number a, number b) { return _mm256_min_ps(a, b); }
    static number max(number a, number b) { return _mm256_max_ps(a, b); }
    static number sqrt(number a) { return _mm256_sqrt_ps(a); }
    static mask less_equal(number a, number b) { return _mm256_cmp_ps(a, b, _CMP_LE_OQ); }
    static mask both(mask a, mask b) { return _mm256_and_ps(a, b); }
    static bool none(mask a) { return _mm256_movemask_ps(a) == 0; }
    static number select(mask m, number a, number b) { return _mm256_blendv_ps(b, a, m); }
    static void store(float* to, number a) { _mm256_storeu_ps(to, a); }
};
#endif

/// A vector of numbers of the instruction set, or of what it broadcasts.
template <class I>
struct vector_by_hand {
    using number = typename I::number;
    number x, y, z;

    static vector_by_hand load(const float* from) {
        return {I::load(from), I::load(from + I::lanes), I::load(from + 2 * I::lanes)};
    }
    static vector_by_hand all(const raio::vec3<float>& v) { return {I::all(v.x), I::all(v.y), I::all(v.z)}; }
    vector_by_hand operator-(const vector_by_hand& b) const { return {I::sub(x, b.x), I::sub(y, b.y), I::sub(z, b.z)}; }
    static number dot(const vector_by_hand& a, const vector_by_hand& b) {
        return I::fma(a.z, b.z, I::fma(a.y, b.y, I::mul(a.x, b.x)));
    }
    static vector_by_hand cross(const vector_by_hand& a, const vector_by_hand& b) {
        return {I::fms(a.y, b.z, I::mul(a.z, b.y)), I::fms(a.z, b.x, I::mul(a.x, b.z)),
                I::fms(a.x, b.y, I::mul(a.y, b.x))};
    }
};

/// Each kernel is made for a ray, and asked for the t of I::lanes shapes, whose numbers stand as in the shape: all the
/// first ones, all the second ones and so on. `t` is of use where the mask is set.
template <class I>
struct kernel_by_hand {
    using vector = vector_by_hand<I>;
    using number = typename I::number;
    struct answer {
        typename I::mask hit;
        number t;
    };

    vector origin, direction;
    number zero = I::all(0);

    explicit kernel_by_hand(const raio::ray<float>& ray)
        : origin(vector::all(ray.origin)), direction(vector::all(ray.direction)) {}
};

template <class I>
struct sphere_by_hand : kernel_by_hand<I> {
    using typename kernel_by_hand<I>::number, typename kernel_by_hand<I>::vector, typename kernel_by_hand<I>::answer;
    number a = vector::dot(this->direction, this->direction), over_a = I::div(I::all(1), a);

    using kernel_by_hand<I>::kernel_by_hand;

    /// The squared distance from the closest approach to the centre is no difference of large squares.
    answer operator()(const float* s, number t_min) const {
        const vector& d = this->direction;
        const vector l = vector::load(s) - this->origin;
        const number r = I::load(s + 3 * I::lanes), closest = I::mul(vector::dot(l, d), over_a);
        const vector passed{I::fnma(closest, d.x, l.x), I::fnma(closest, d.y, l.y), I::fnma(closest, d.z, l.z)};
        const number s2 = I::fms(r, r, vector::dot(passed, passed));
        const auto meets = I::less_equal(this->zero, s2);
        if (I::none(meets)) return {meets, s2};
        const number half_chord = I::sqrt(I::mul(I::max(s2, this->zero), over_a));
        const number near = I::sub(closest, half_chord), far = I::add(closest, half_chord);
        const number t = I::select(I::less_equal(t_min, near), near, far);
        return {I::both(meets, I::less_equal(t_min, t)), t};
    }
};

template <class I>
struct plane_by_hand : kernel_by_hand<I> {
    using typename kernel_by_hand<I>::number, typename kernel_by_hand<I>::vector, typename kernel_by_hand<I>::answer;
    using kernel_by_hand<I>::kernel_by_hand;

    answer operator()(const float* s, number t_min) const {
        const vector point = vector::load(s), n = vector::load(s + 3 * I::lanes);
        const number t = I::div(vector::dot(n, point - this->origin), vector::dot(n, this->direction));
        return {I::less_equal(t_min, t), t};
    }
};

/// Moeller and Trumbore 1997.
template <class I>
struct triangle_by_hand : kernel_by_hand<I> {
    using typename kernel_by_hand<I>::number, typename kernel_by_hand<I>::vector, typename kernel_by_hand<I>::answer;
    using kernel_by_hand<I>::kernel_by_hand;
    number one = I::all(1);

    answer operator()(const float* s, number t_min) const {
        const vector a = vector::load(s), b = vector::load(s + 3 * I::lanes), c = vector::load(s + 6 * I::lanes);
        const vector e1 = b - a, e2 = c - a, from_a = this->origin - a;
        const vector p = vector::cross(this->direction, e2), q = vector::cross(from_a, e1);
        const number over_det = I::div(one, vector::dot(e1, p));
        const number u = I::mul(vector::dot(from_a, p), over_det),
                     v = I::mul(vector::dot(this->direction, q), over_det);
        const number t = I::mul(vector::dot(e2, q), over_det);
        const auto inside = I::both(I::less_equal(this->zero, I::min(u, v)), I::less_equal(I::add(u, v), one));
        return {I::both(inside, I::less_equal(t_min, t)), t};
    }
};

template <class I>
struct box_by_hand : kernel_by_hand<I> {
    using typename kernel_by_hand<I>::number, typename kernel_by_hand<I>::vector, typename kernel_by_hand<I>::answer;
    vector over_d{I::div(I::all(1), this->direction.x), I::div(I::all(1), this->direction.y),
                  I::div(I::all(1), this->direction.z)};

    using kernel_by_hand<I>::kernel_by_hand;

    answer operator()(const float* s, number t_min) const {
        const vector low = vector::load(s) - this->origin, high = vector::load(s + 3 * I::lanes) - this->origin;
        number near, far;
        const auto slab = [](number l, number h, number over) {
            const number to_low = I::mul(l, over), to_high = I::mul(h, over);
            return std::pair(I::min(to_low, to_high), I::max(to_low, to_high));
        };
        const auto [x0, x1] = slab(low.x, high.x, over_d.x);
        const auto [y0, y1] = slab(low.y, high.y, over_d.y);
        const auto [z0, z1] = slab(low.z, high.z, over_d.z);
        near = I::max(I::max(x0, y0), z0);
        far = I::min(I::min(x1, y1), z1);
        const number t = I::select(I::less_equal(t_min, near), near, far);
        return {I::both(I::less_equal(near, far), I::less_equal(t_min, t)), t};
    }
};

}  // namespace peers
