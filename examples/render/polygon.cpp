#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace render {
namespace {

using point2 = raio::vec2<double>;

/// The corners without the coordinate along which their area is largest, counter-clockwise.
std::vector<point2> flattened(std::span<const raio::vec3<double>> corners) {
    raio::vec3<double> normal(0);  // times twice the area: Newell's method
    for (std::size_t i = 2; i < corners.size(); ++i) {
        normal += raio::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    const raio::vec3<double> size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const glm::length_t axis = size.z >= std::max(size.x, size.y) ? 2 : size.y >= size.x ? 1 : 0;
    glm::length_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(u, v);
    std::vector<point2> flat;
    flat.reserve(corners.size());
    for (const auto& corner : corners) flat.push_back({corner[u], corner[v]});
    return flat;
}

/// Above 0 where a, b, c turn to the left. The sign is right, so that what one triangle takes for outside is inside of
/// the next: a corner on a diagonal would be in neither, or in both.
double turn(const point2& a, const point2& b, const point2& c) {
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x), difference = left - right;
    if (std::abs(difference) > 4 * raio::unit_roundoff<double> * (std::abs(left) + std::abs(right))) return difference;
    using exact = raio::double_double;
    const exact precise =
        (exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y)) - (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x));
    return static_cast<double>(precise);
}

/// The corners of a polygon that are left, in a ring.
class ring {
public:
    explicit ring(std::span<const point2> corners)
        : corners_(corners), before_(corners.size()), after_(corners.size()) {
        const auto count = static_cast<std::uint32_t>(corners.size());
        for (std::uint32_t i = 0; i < count; ++i) before_[i] = (i + count - 1) % count, after_[i] = (i + 1) % count;
    }

    std::uint32_t before(std::uint32_t i) const { return before_[i]; }
    std::uint32_t after(std::uint32_t i) const { return after_[i]; }
    double turn_at(std::uint32_t i) const { return turn(corners_[before_[i]], corners_[i], corners_[after_[i]]); }
    bool is_left(std::uint32_t i) const { return after_[i] != i; }

    /// Is the triangle of this corner and its neighbours inside the polygon, and empty? Only a corner that is not
    /// convex can be in the way; where a face reaches its hole, several corners are in one place, and are not.
    bool is_ear(std::uint32_t i) const {
        const point2 &a = corners_[before_[i]], &b = corners_[i], &c = corners_[after_[i]];
        if (!(turn(a, b, c) > 0)) return false;
        for (std::uint32_t other = after_[after_[i]]; other != before_[i]; other = after_[other]) {
            const point2& p = corners_[other];
            const bool in_triangle = turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
            if (in_triangle && turn_at(other) <= 0 && p != a && p != b && p != c) return false;
        }
        return true;
    }

    void remove(std::uint32_t i) {
        after_[before_[i]] = after_[i];
        before_[after_[i]] = before_[i];
        after_[i] = i;
    }

private:
    std::span<const point2> corners_;
    std::vector<std::uint32_t> before_, after_;
};

/// Corners that may be the tip of an ear wait in a stack: all at first, and again those whose neighbour was clipped.
template <class Use>
void clip_ears(std::span<const point2> corners, Use use) {
    ring left(corners);
    auto count = static_cast<std::uint32_t>(corners.size());
    std::vector<std::uint32_t> waiting(count);
    for (std::uint32_t i = 0; i < count; ++i) waiting[i] = count - 1 - i;
    std::uint32_t last = 0;  // which is left
    while (count > 3) {
        std::uint32_t tip = last;
        if (!waiting.empty()) {
            tip = waiting.back();
            waiting.pop_back();
            if (!left.is_left(tip) || !left.is_ear(tip)) continue;
        } else {
            // Where edges cross, or all but touch, there may be no ear: any convex corner is as good.
            for (std::uint32_t i = left.after(last); i != last && !(left.turn_at(tip) > 0); i = left.after(i)) tip = i;
        }
        const std::uint32_t before = left.before(tip), after = left.after(tip);
        use(before, tip, after);
        left.remove(tip);
        waiting.push_back(before), waiting.push_back(after);
        last = after;
        --count;
    }
    use(left.before(last), last, left.after(last));
}

}  // namespace

void append_triangles(std::span<const raio::vec3<double>> corners, std::vector<raio::triangle<double>>& triangles) {
    const auto append = [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back({corners[a], corners[b], corners[c]});
    };
    if (corners.size() > 3) {
        const std::vector<point2> flat = flattened(corners);
        const ring whole(flat);
        for (std::uint32_t i = 0; i < flat.size(); ++i) {
            if (whole.turn_at(i) < 0) return clip_ears(flat, append);
        }
    }
    for (std::size_t i = 2; i < corners.size(); ++i) append(0, i - 1, i);
}

}  // namespace render
