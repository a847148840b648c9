#pragma once

#include <cmath>

#include <raio/shape/bilinear_patch.hpp>

#include "peers/record.hpp"

namespace peers {

/// Reshetov, Ray Tracing Gems ch. 8 (2019), as it is printed there: the quadratic in T as it stands.
template <class T>
struct cool_patch {
    static constexpr const char* name = "cool_patch";
    using result = record<T>;

    raio::vec3<T> q00, q10, q01, q11, normal;

    explicit cool_patch(const raio::bilinear_patch<T>& s)
        : q00(s.p00), q10(s.p10), q01(s.p01), q11(s.p11), normal(raio::cross(q10 - q00, q01 - q11)) {}

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        using raio::cross, raio::dot, std::sqrt;
        const raio::vec3<T> e10 = q10 - q00, e11 = q11 - q10, e00 = q01 - q00, d = ray.direction;
        const raio::vec3<T> from00 = q00 - ray.origin, from10 = q10 - ray.origin;
        const T a = dot(cross(from00, d), e00), c = dot(normal, d);
        T b = dot(cross(from10, d), e11);
        b -= a + c;
        const T square = b * b - 4 * a * c;
        if (square < T(0)) return false;
        const T root = sqrt(square);
        T u1, u2;
        if (c == T(0)) {
            u1 = -a / b, u2 = T(-1);
        } else {
            u1 = (-b - std::copysign(root, b)) / 2, u2 = a / u1, u1 /= c;
        }
        T nearest = t_max, u = T(0), v = T(0);
        bool found = false;
        for (const T at : {u1, u2}) {
            if (!(T(0) <= at && at <= T(1))) continue;
            const raio::vec3<T> start = from00 + (from10 - from00) * at, along = e00 + (e11 - e00) * at;
            const raio::vec3<T> n = cross(d, along);
            const T det = dot(n, n);
            const raio::vec3<T> m = cross(n, start);
            const T t = dot(m, along), across = dot(m, d);
            if (!(T(0) <= across && across <= det && t_min * det <= t && t <= nearest * det)) continue;
            nearest = t / det, u = at, v = across / det, found = true;
        }
        if (!found) return false;
        rec.t = nearest;
        rec.point = ray.origin + d * nearest;
        rec.face(ray, raio::normalize(cross(e10 + (q11 - q01 - e10) * v, e00 + (e11 - e00) * u)));
        return true;
    }
};

}  // namespace peers
