#pragma once

#include <raio/push_macros.hpp>

#include <raio/shape/triangle.hpp>

namespace raio::inline RAIO_ABI {

/// The triangle of a mesh: one question per edge, asked with the edge's two corners only, so that the two triangles at
/// an edge hear the same answer in any precision, and no ray slips between them.
///
/// Woop, Benthin and Wald, JCGT 2(1), 2013: the corners are moved so that the ray starts at the origin, and sheared so
/// that it runs along its largest axis z. In the xy plane the ray is then a point, and the edge functions
///
///     u = cx by - cy bx,   v = ax cy - ay cx,   w = bx ay - by ax,   det = u + v + w
///
/// say on which side of each edge it lies. The ray hits where none of the three differs in sign from the others, at
///
///     t = (u az + v bz + w cz) / (det dz)
///
/// Corners, front and uv are those of `triangle`, which is exact as well, but whose `crossings` in other precisions may
/// disagree with those of a neighbour.
template <real T>
struct watertight_triangle {
    using number = T;

    vec3<T> a, b, c;

    template <record Record>
    RAIO_FN constexpr mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        return first_hit(*this, ray, t_min, t_max, rec);
    }

    RAIO_FN constexpr mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        return any_hit(*this, ray, t_min, t_max);
    }

    RAIO_FN constexpr aabb<T> bounds() const { return as_triangle().bounds(); }
    RAIO_FN constexpr T area() const { return as_triangle().area(); }
    RAIO_FN constexpr surface_sample<T> sample(const vec2<T>& u) const { return as_triangle().sample(u); }

    template <class Line>
    RAIO_FORMULA constexpr crossing<typename Line::number> crossings(const Line& line) const {
        // A rotation of the coordinates that makes the largest component of the direction the last one.
        using W = typename Line::number;
        const auto direction = line.direction();
        const vec3<W> along_axes = abs(vec3<W>(direction.x, direction.y, direction.z));
        const mask_t<W> last_is_x = along_axes.x > along_axes.y && along_axes.x > along_axes.z;
        const mask_t<W> last_is_y = !last_is_x && along_axes.y > along_axes.z;
        const auto turned = [&](auto v) {
            const W x = v.x, y = v.y;
            v.x = select(last_is_x, y, select(last_is_y, v.z, x));
            v.y = select(last_is_x, v.z, select(last_is_y, x, y));
            v.z = select(last_is_x, x, select(last_is_y, y, v.z));
            return v;
        };
        const auto d = turned(direction);
        const auto over_z = inverse(z_of(d));
        const auto slope = d * over_z;
        const auto sheared = [&](const vec3<T>& corner) { return shear(turned(line.to(corner)), slope); };
        const auto p = sheared(a);
        const auto q = sheared(b);
        const auto r = sheared(c);
        // Where the shear leaves too few digits, the volumes between edges and ray say the same.
        const auto volume = [&](const auto& first, const auto& second) {
            return determinant(direction, first, second) * over_z;
        };
        const auto side = [&](const auto& of_shear, const vec3<T>& from, const vec3<T>& to) {
            return closer(of_shear, [&] { return volume(line.to(from), line.to(to)); });
        };
        const auto u = side(cross_z(r, q), c, b);
        const auto v = side(cross_z(p, r), a, c);
        const auto w = side(cross_z(q, p), b, a);
        const auto sides = vector_of(u, v, w);
        const auto e1 = line.between(a, b);
        const auto e2 = line.between(a, c);
        const auto det = closer(sum_of(sides), [&] { return volume(e2, e1); });

        const auto left = [&](const auto& x) { return is_not_negative(x, det); };
        const auto right = [&](const auto& x) { return is_not_positive(x, det); };
        const auto inside = some(every(left(u), left(v), left(w)), every(right(u), right(v), right(w)));
        if (all(!inside)) return no_crossing<W>();

        const auto speed = det * z_of(d);
        const auto height =
            closer(dot(sides, vector_of(z_of(p), z_of(q), z_of(r))), [&] { return determinant(line.to(a), e2, e1); });
        crossing<W> at = crossing_at(every(inside, is_not_zero(speed)), height / speed, speed.value > W(0));
        const W over_det = d.z * inverse(speed).value;
        at.u = v.value * over_det, at.v = w.value * over_det;
        return at;
    }

    template <class Point>
    RAIO_FN constexpr void surface(Point& at) const {
        as_triangle().surface(at);
    }

private:
    RAIO_FN constexpr triangle<T> as_triangle() const { return {a, b, c}; }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
