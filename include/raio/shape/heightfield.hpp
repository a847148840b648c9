#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <raio/failure.hpp>
#include <raio/shape/triangle.hpp>

namespace raio::inline RAIO_ABI {

/// Heights along z over a rectangular grid in the xy plane, two triangles to a cell: from the corner with the least x
/// and y to the opposite one runs the edge between them. Above is the front. (For other planes there is `transformed`.)
///
/// It is a range of triangles, made as they are asked for, and its answer is that of the loop over them, bit for bit.
/// But only cells that the ray passes over are asked: the grid is walked strip by strip along the larger component of
/// the direction (Amanatides and Woo 1987, by strips), in each strip all cells whose sides the ray can have reached,
/// rounding errors included. A step too many costs a triangle, none is skipped.
///
/// A height that is no number leaves a hole. `index` counts the triangles: cells row by row, in each first the triangle
/// at greater x. uv: the position over the whole rectangle.
template <real T>
struct heightfield {
    using number = T;

    vec2<T> min, max;        ///< opposite corners of the rectangle; the field is missed unless max is the greater one
    std::uint32_t columns;   ///< how many heights there are along x, at least 2
    std::vector<T> heights;  ///< row by row, that with the least y first, each from the least x on; at least two rows

    /// How many triangles there are.
    std::size_t size() const { return std::size_t(2) * cells(0) * cells(1); }

    triangle<T> operator[](std::size_t i) const {
        const std::size_t column = i / 2 % cells(0), row = i / 2 / cells(0);
        vec3<T> low = vertex(column, row), high = vertex(column + 1, row + 1);
        if (i % 2 == 0) return {low, vertex(column + 1, row), high};
        return {low, high, vertex(column, row + 1)};
    }

    template <record Record>
    mask_t<T> hit(const ray<T>& ray, T t_min, T t_max, Record& rec) const {
        bool found = false;
        hit_record<T> nearest;
        walk(ray, t_min, t_max, [&](std::size_t i) {
            hit_record<T> candidate;
            if ((*this)[i].hit(ray, t_min, found ? nearest.t : t_max, candidate)) {
                candidate.index = static_cast<std::uint32_t>(i);
                if (!found || detail::comes_before(candidate, nearest)) nearest = candidate;
                found = true;
            }
            return found ? nearest.t : t_max;
        });
        if (!found) return false;
        nearest.uv = position(nearest.index, nearest.uv);
        assign(rec, nearest);
        return true;
    }

    mask_t<T> occluded(const ray<T>& ray, T t_min, T t_max) const {
        bool found = false;
        walk(ray, t_min, t_max, [&](std::size_t i) {
            found = found || (*this)[i].occluded(ray, t_min, t_max);
            return found ? -infinity<T> : t_max;
        });
        return found;
    }

    /// \throws std::invalid_argument  for heights that do not fill whole rows, or fewer than two rows or columns
    void check() const {
        if (columns < 2 || heights.size() / columns < 2 || heights.size() % columns != 0) {
            detail::fail(std::invalid_argument("raio::heightfield: " + std::to_string(heights.size()) +
                                               " heights are not two rows or more of " + std::to_string(columns) +
                                               " columns, of which there must be two"));
        }
    }

    /// Holes have none. (NaN, if that is what the rectangle has.)
    aabb<T> bounds() const {
        aabb<T> all;
        for (std::size_t i = 0; i < size(); ++i) {
            if (const aabb<T> box = (*this)[i].bounds(); !is_nan(box)) all = hull(all, box);
        }
        return unless_nan(all, vec3<T>(min, T(0)), vec3<T>(max, T(0)));
    }

private:
    using W = working_t<T>;  // of the walk

    /// Cells along x, or y.
    std::uint32_t cells(glm::length_t axis) const {
        const auto rows = columns > 0 ? static_cast<std::uint32_t>(heights.size() / columns) : 0;
        const std::uint32_t lines = axis == 0 ? columns : rows;
        return lines > 1 ? lines - 1 : 0;
    }

    /// Where the i-th line of the grid crosses an axis: never below the line before it.
    T line(glm::length_t axis, std::size_t i) const {
        return T(W(min[axis]) + (W(max[axis]) - W(min[axis])) * (W(i) / W(cells(axis))));
    }

    vec3<T> vertex(std::size_t column, std::size_t row) const {
        return {line(0, column), line(1, row), heights[row * columns + column]};
    }

    vec2<T> position(std::size_t i, const vec2<T>& uv) const {
        const W x(uv.x), y(uv.y), both = x + y, column(i / 2 % cells(0)), row(i / 2 / cells(0));
        const W across = (column + (i % 2 == 0 ? both : x)) / W(cells(0));
        const W along = (row + (i % 2 == 0 ? y : both)) / W(cells(1));
        return {raio::min(T(1), T(across)), raio::min(T(1), T(along))};
    }

    /// The first cell along an axis that reaches up to x, or the last one.
    std::uint32_t first_cell(glm::length_t axis, const W& x) const {
        const std::uint32_t last = cells(axis) - 1;
        const W low(min[axis]), guess = (x - low) / (W(max[axis]) - low) * W(last + 1);
        std::uint32_t i = guess > W(0) ? static_cast<std::uint32_t>(static_cast<double>(raio::min(guess, W(last)))) : 0;
        while (i > 0 && W(line(axis, i)) >= x) --i;
        while (i < last && W(line(axis, i + 1)) < x) ++i;
        return i;
    }

    /// Is all of the cell, whose first height is at `corner`, above the ray or below it? (A hole is not: every
    /// comparison with it is false.)
    bool passes(std::size_t corner, const interval<W>& z) const {
        const T *front = &heights[corner], *back = front + columns;
        const W a(front[0]), b(front[1]), c(back[0]), d(back[1]);
        return (a < z.min && b < z.min && c < z.min && d < z.min) || (a > z.max && b > z.max && c > z.max && d > z.max);
    }

    /// Calls `visit` with every triangle that the ray may meet in the window, at least. It answers how far along the
    /// ray others are still of interest.
    template <class Visit>
    void walk(const ray<T>& ray, T t_min, T t_max, Visit visit) const {
        if (size() == 0 || !(min.x < max.x && min.y < max.y && t_min <= t_max)) return;
        const bool along_x = abs(ray.direction.x) >= abs(ray.direction.y);
        const glm::length_t a = along_x ? 0 : 1, b = along_x ? 1 : 0;
        const W a_from(ray.origin[a]), a_speed(ray.direction[a]), zero(0);
        const W slack(8 * unit_roundoff<W>);  // of places and of t, which are found with five roundings at most
        const W earliest = detail::widened<W>(t_min, -1);
        W latest = detail::widened<W>(t_max, 1);

        // Between which coordinates the ray may be from one t to another.
        const auto reach = [&](glm::length_t axis, const W& from, const W& to) {
            const W origin(ray.origin[axis]), speed(ray.direction[axis]);
            if (speed == zero) return interval<W>{origin, origin};
            const W one = speed * from, other = speed * to,
                    around = slack * (abs(origin) + raio::max(abs(one), abs(other)));
            return interval<W>{origin + raio::min(one, other) - around, origin + raio::max(one, other) + around};
        };
        // How far the t of a line of the grid may be off, and that of a crossing on it.
        const W farthest = abs(a_from) + raio::max(abs(W(min[a])), abs(W(max[a])));
        const W off = quotient(slack * farthest, abs(a_speed), zero);

        // The strip to begin with; backwards, the last of those that end where it begins.
        const bool backwards = a_speed < zero;
        const std::uint32_t strips = cells(a);
        const interval<W> start = reach(a, earliest, earliest);
        std::uint32_t strip = backwards ? std::min(first_cell(a, start.max) + 1, strips - 1) : first_cell(a, start.min);
        for (std::uint32_t left = backwards ? strip + 1 : strips - strip; left > 0;
             --left, strip += backwards ? -1u : 1u) {
            const W low(line(a, strip)), high(line(a, strip + 1));
            W from = earliest, to = latest;
            if (a_speed == zero) {
                if (a_from < low) return;
                if (a_from > high) continue;
            } else {
                const W enter = ((backwards ? high : low) - a_from) / a_speed,
                        leave = ((backwards ? low : high) - a_from) / a_speed;
                from = raio::max(from, enter - off), to = raio::min(to, leave + off);
                if (enter - off > latest) return;
                if (from > to) continue;
            }
            const interval<W> across = reach(b, from, to), height = reach(2, from, to);
            for (std::uint32_t i = first_cell(b, across.min); i < cells(b) && W(line(b, i)) <= across.max; ++i) {
                const std::size_t column = along_x ? strip : i, row = along_x ? i : strip,
                                  cell = row * cells(0) + column;
                if (passes(row * columns + column, height)) continue;
                visit(2 * cell);
                latest = raio::min(latest, detail::widened<W>(visit(2 * cell + 1), 1));
            }
        }
    }
};

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
