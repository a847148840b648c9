#include "shapes.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <stdexcept>

#include <raio/bvh/bvh.hpp>

#include "support/properties.hpp"

/// One input of the fuzzer, and of replay.cpp: any bits as shape, ray and window. Whatever they are, the answer is no,
/// or a crossing within the window whose record is sound; occluded says the same; spans are in order; and a tree
/// answers as the loop does.
///
/// The first byte chooses the shape (with --shape=NAME all that is invented is about that one), the second what numbers
/// are: float or double, and the next bits as they are, or one byte that stands for an eighth, or that, but for some
/// bytes which stand for numbers at which things go wrong. Among eighths the point lies within the bounds, too, and the
/// normal is against the ray. (A shape with sizes of 1e-300 and 1e300 at once does not promise that.)
namespace raio::test {

namespace {

enum class number_kind { bits, eighths_and_hard, eighths };

/// What shapes are made of.
enum class field { point, number };
using enum field;

/// The bytes, taken for numbers of T one after the other. Behind the end there are only zeros.
template <class T>
class numbers {
public:
    numbers(std::span<const std::uint8_t> bytes, number_kind kind) : bytes_(bytes), kind_(kind) {}

    T number() {
        taken_.push_back(kind_ == number_kind::bits ? some_bits() : one_of_few(byte()));
        return taken_.back();
    }
    vec2<T> pair() {
        const T x = number();
        return {x, number()};
    }
    vec3<T> point() {
        const T x = number(), y = number();
        return {x, y, number()};
    }
    template <field Field>
    auto next() {
        if constexpr (Field == field::point) {
            return point();
        } else {
            return number();
        }
    }
    number_kind kind() const { return kind_; }
    /// One of 0, 1, ..., most.
    unsigned count(unsigned most) { return byte() % (most + 1); }

    /// Ends the program, unless this holds, and says what is wrong and of which numbers.
    void check(bool holds, const std::string& wrong) const {
        if (holds) return;
        std::fprintf(stderr, "%s, from", wrong.c_str());
        for (const T x : taken_) std::fprintf(stderr, " %s", literal(x).c_str());
        std::fprintf(stderr, "\n");
        std::abort();
    }

private:
    std::uint8_t byte() {
        if (bytes_.empty()) return 0;
        const std::uint8_t first = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return first;
    }

    T some_bits() {
        std::array<std::uint8_t, sizeof(T)> bits;
        for (std::uint8_t& b : bits) b = byte();
        return std::bit_cast<T>(bits);
    }
    T one_of_few(std::uint8_t b) const {
        using limits = std::numeric_limits<T>;
        constexpr T hard[] = {
            -T(0),       limits::denorm_min(), limits::min(),       limits::max(),     limits::lowest(),
            infinity<T>, -infinity<T>,         limits::quiet_NaN(), limits::epsilon(), 1 + limits::epsilon()};
        if (kind_ == number_kind::eighths_and_hard && b >= 128 && b < 128 + std::size(hard)) return hard[b - 128];
        return T(static_cast<std::int8_t>(b)) / 8;
    }

    std::span<const std::uint8_t> bytes_;
    number_kind kind_;
    std::vector<T> taken_;
};

template <class T>
ray<T> some_ray(numbers<T>& n) {
    const vec3<T> origin = n.point();
    return {origin, n.point()};
}

template <class T, class Shape>
void ask(numbers<T>& n, const Shape& shape) {
    const ray<T> ray = some_ray(n);
    const T t_min = n.number(), t_max = n.number();
    for (const probe<Shape>& p : {probe<Shape>{shape, ray}, probe<Shape>{shape, ray, t_min, t_max}}) {
        std::string wrong = unsound_answer(p);
        if (n.kind() == number_kind::eighths) wrong += inconsistent_record(p, 0.125);
        n.check(wrong.empty(), wrong);
    }
    shape.bounds();
    if constexpr (solid<Shape>) {
        T last = -infinity<T>;
        for (const interval<T>& i : spans(shape.spans(ray))) {
            n.check(last <= i.min && i.min <= i.max, "spans not in order");
            last = i.max;
        }
    }
}

template <class T>
std::array<vec3<T>, 4> corners(numbers<T>& n) {
    const vec3<T> a = n.point(), b = n.point(), c = n.point();
    return {a, b, c, n.point()};
}

/// Asks a shape that is made of such fields, in their order.
template <class Shape, field... Fields>
void ask_made_of(numbers<number_t<Shape>>& n) {
    ask(n, Shape{n.template next<Fields>()...});  // braces read their numbers in order
}

/// Asks a tree of them for what the loop says.
template <class Shape, field... Fields>
void ask_tree_of(numbers<number_t<Shape>>& n) {
    using T = number_t<Shape>;
    std::vector<Shape> shapes;
    for (unsigned left = n.count(12); left > 0; --left) shapes.push_back(Shape{n.template next<Fields>()...});
    const ray<T> ray = some_ray(n);
    const T t_min = n.number(), t_max = n.number();
    try {
        const bvh<Shape> tree(shapes, {.threads = 1});
        for (const interval<T>& window : {interval<T>{T(0), infinity<T>}, interval<T>{t_min, t_max}}) {
            hit_record<T> expected{}, found{};
            const bool hit = group{shapes}.hit(ray, window.min, window.max, expected);
            n.check(tree.hit(ray, window.min, window.max, found) == hit && same_record(found, expected),
                    "another hit in the tree");
            n.check(tree.occluded(ray, window.min, window.max) == hit, "occluded otherwise in the tree");
        }
    } catch (const std::invalid_argument&) {
    }
}

/// What an input may be about, by the name that the fuzzer is told.
template <class T>
struct question {
    std::string_view name;
    void (*ask)(numbers<T>&);
};

/// Every shape, and every way to put shapes together. The corpus counts on their order, tests/fuzz/CMakeLists.txt on a
/// line for each name.
template <class T>
constexpr question<T> questions[] = {
    {"sphere", ask_made_of<sphere<T>, point, number>},
    {"ellipsoid", ask_made_of<ellipsoid<T>, point, point>},
    {"plane", ask_made_of<plane<T>, point, point>},
    {"disc", ask_made_of<disc<T>, point, point, number>},
    {"ring", ask_made_of<ring<T>, point, point, number, number>},
    {"parallelogram", ask_made_of<parallelogram<T>, point, point, point>},
    {"bilinear_patch", ask_made_of<bilinear_patch<T>, point, point, point, point>},
    {"triangle", ask_made_of<triangle<T>, point, point, point>},
    {"watertight_triangle", ask_made_of<watertight_triangle<T>, point, point, point>},
    {"box", ask_made_of<box<T>, point, point>},
    {"cylinder", ask_made_of<cylinder<T>, point, point, number>},
    {"open_cylinder", ask_made_of<open_cylinder<T>, point, point, number>},
    {"capsule", ask_made_of<capsule<T>, point, point, number>},
    {"round_cone", ask_made_of<round_cone<T>, point, point, number, number>},
    {"cone", ask_made_of<cone<T>, point, point, number>},
    {"open_cone", ask_made_of<open_cone<T>, point, point, number>},
    {"frustum", ask_made_of<frustum<T>, point, point, number, number>},
    {"open_frustum", ask_made_of<open_frustum<T>, point, point, number, number>},
    {"paraboloid", ask_made_of<paraboloid<T>, point, point, number>},
    {"open_paraboloid", ask_made_of<open_paraboloid<T>, point, point, number>},
    {"hyperboloid", ask_made_of<hyperboloid<T>, point, point, number, number>},
    {"open_hyperboloid", ask_made_of<open_hyperboloid<T>, point, point, number, number>},
    {"two_sheet_hyperboloid", ask_made_of<two_sheet_hyperboloid<T>, point, point, number, number>},
    {"open_two_sheet_hyperboloid", ask_made_of<open_two_sheet_hyperboloid<T>, point, point, number, number>},
    {"quadric", ask_made_of<quadric<T>, point, point, point, point, point, number>},
    {"open_quadric", ask_made_of<open_quadric<T>, point, point, point, point, point, number>},
    {"torus", ask_made_of<torus<T>, point, point, number, number>},
    {"steiner", ask_made_of<steiner<T>, point, number>},
    {"teardrop", ask_made_of<teardrop<T>, point, point, number>},
    {"algebraic",
     [](numbers<T>& n) {
         algebraic<T, 4> some{n.point(), n.point(), {}};
         for (unsigned left = n.count(6); left > 0; --left) {
             const T coefficient = n.number();
             const unsigned x = n.count(4), y = n.count(4 - x);
             some.terms.push_back({coefficient, x, y, n.count(4 - x - y)});
         }
         ask(n, some);
     }},
    {"blob",
     [](numbers<T>& n) {
         blob<T, 3> some{};
         for (metaball<T>& ball : some.components) ball = {n.point(), n.number(), n.number(), n.point()};
         some.threshold = n.number();
         ask(n, some);
     }},
    {"surface_of_revolution",
     [](numbers<T>& n) {
         surface_of_revolution<T> some{n.point(), n.point(), {}};
         for (unsigned left = n.count(5); left > 0; --left) some.profile.push_back(n.pair());
         ask(n, some);
     }},
    {"heightfield",
     [](numbers<T>& n) {
         heightfield<T> some{n.pair(), n.pair(), 2 + n.count(2), {}};
         for (unsigned left = some.columns * (2 + n.count(2)); left > 0; --left) some.heights.push_back(n.number());
         ask(n, some);
     }},
    {"convex_polyhedron",
     [](numbers<T>& n) {
         convex_polyhedron<T> some;
         for (unsigned left = n.count(7); left > 0; --left) some.planes.push_back({n.point(), n.number()});
         ask(n, some);
     }},
    {"oriented_box",
     [](numbers<T>& n) {
         const auto [center, x, y, z] = corners(n);
         ask(n, oriented_box(center, x, y, z));
     }},
    {"tetrahedron",
     [](numbers<T>& n) {
         const auto [a, b, c, d] = corners(n);
         ask(n, tetrahedron(a, b, c, d));
     }},
    {"pyramid",
     [](numbers<T>& n) {
         const std::array<vec3<T>, 4> base = corners(n);
         ask(n, pyramid(base, n.point()));
     }},
    {"prism",
     [](numbers<T>& n) {
         const std::array<vec3<T>, 4> base = corners(n);
         ask(n, prism(base, n.point()));
     }},
    {"regular_solid",
     [](numbers<T>& n) {
         const vec3<T> center = n.point();
         ask(n, regular_solid<12>(center, n.number()));
     }},
    {"signed_distance",
     [](numbers<T>& n) {
         const sphere<T> ball{n.point(), n.number()};
         const auto distance = [=](const vec3<T>& p) { return length(p - ball.center) - ball.radius; };
         const aabb<T> bounds{n.point(), n.point()};
         const T tolerance = n.number();
         ask(n, signed_distance{bounds, tolerance, n.number(), distance});
     }},
    {"transformed",
     [](numbers<T>& n) {
         const sphere<T> ball{n.point(), n.number()};
         ask(n, transformed{ball, transform<T>{n.point(), n.point(), n.point(), n.point()}});
     }},
    {"csg",
     [](numbers<T>& n) {
         const torus<T> tube{n.point(), n.point(), n.number(), n.number()};
         const box<T> block{n.point(), n.point()};
         const sphere<T> ball{n.point(), n.number()};
         switch (n.count(2)) {
             case 0:
                 ask(n, union_of(difference_of(tube, block), ball));
                 break;
             case 1:
                 ask(n, difference_of(block, intersection_of(tube, ball)));
                 break;
             default:
                 ask(n, intersection_of(union_of(tube, ball), block));
                 break;
         }
     }},
    {"group",
     [](numbers<T>& n) {
         const sphere<T> ball{n.point(), n.number()};
         const disc<T> round{n.point(), n.point(), n.number()};
         ask(n, group{ball, round, std::array{any_primitive<T>(ball), any_primitive<T>(round)}});
     }},
    {"mesh",
     [](numbers<T>& n) {
         mesh<T> some;
         for (const vec3<T>& vertex : corners(n)) some.vertices.push_back(vertex);
         for (unsigned left = n.count(4); left > 0; --left)
             some.triangles.push_back({n.count(3), n.count(3), n.count(3)});
         ask(n, some);
     }},
    {"bvh", ask_tree_of<sphere<T>, point, number>},
    {"bezier_curve",
     [](numbers<T>& n) {
         const auto [a, b, c, d] = corners(n);
         ask(n, bezier_curve<T>{a, b, c, d, n.number(), n.number(), n.number(), n.number()});
     }},
    {"curved_surface_of_revolution",
     [](numbers<T>& n) {
         curved_surface_of_revolution<T> some{n.point(), n.point(), {}};
         for (unsigned left = 3 * n.count(2); left > 0; --left) some.profile.push_back(n.pair());
         some.profile.push_back(n.pair());
         ask(n, some);
     }},
    {"bvh_of_triangles", ask_tree_of<triangle<T>, point, point, point>},
    {"bvh_of_boxes", ask_tree_of<box<T>, point, point>},
    {"bvh_of_cylinders", ask_tree_of<cylinder<T>, point, point, number>},
};

}  // namespace

std::optional<std::uint8_t> first_byte_for(std::string_view name) {
    const auto found = std::ranges::find(questions<float>, name, &question<float>::name);
    if (found == std::end(questions<float>)) return {};
    return static_cast<std::uint8_t>(found - std::begin(questions<float>));
}

}  // namespace raio::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace raio::test;
    if (size < 2) return 0;
    const std::span<const std::uint8_t> bytes(data + 2, size - 2);
    const auto kind = static_cast<number_kind>((data[1] >> 1) % 3);
    if ((data[1] & 1) != 0) {
        numbers<double> n(bytes, kind);
        questions<double>[data[0] % std::size(questions<double>)].ask(n);
    } else {
        numbers<float> n(bytes, kind);
        questions<float>[data[0] % std::size(questions<float>)].ask(n);
    }
    return 0;
}
