#include <raio/number/bounded_number.hpp>

#include "support/proven.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("bounded_number: what an operation is off by is within its bound, and close", W, RAIO_PRECISIONS) {
    check_binary<W>("sum", {0.9, 0.9}, [](auto a, auto b) { return a + b; });
    check_binary<W>("difference", {0.9, 0.9}, [](auto a, auto b) { return a - b; });
    check_binary<W>("product", {0.7, 0.9}, [](auto a, auto b) { return a * b; });
    check_unary<W>("square", {0.7, 0.9}, [](auto a) { return square(a); });
    check_unary<W>("inverse", {0.6, 0.9}, [](auto a) { return inverse(a); });
    check_unary<W>("magnitude", {0.9, 0}, [](auto a) { return abs(a); });
    check_binary<W>("maximum", {0.9, 0}, [](auto a, auto b) { return raio::max(a, b); });
    check_binary<W>("minimum", {0.9, 0}, [](auto a, auto b) { return raio::min(a, b); });
    check_unary<W>("root", {0.4, 0.6}, [](auto a) { return root_of(abs(a)); });
}

TEST_CASE_TEMPLATE("bounded_number: the root of what may be negative", W, RAIO_PRECISIONS) {
    random_numbers random(2);
    worst seen;
    for (int i = 0; i < share_of_lanes<W>(1000); ++i) {
        const auto a = maker<bounded_number<W>>::any(random, 10);
        seen.see(sqrt(a.number), exactly_in_lanes<W>([](auto x) { return root_of(x); }, a.exact));
    }
    CHECK(seen.part > 0.7);
    // The last precision knows something of each.
    CHECK((seen.open == 0) == last_precision<W>);
}

TEST_CASE_TEMPLATE("bounded_number: small products that lose digits are known to", W, RAIO_PRECISIONS) {
    // To the end of the range, at both ends.
    const double most = std::same_as<scalar_t<W>, float> ? 74 : 536;
    const closeness any{0, 0};
    check_binary<W>(
        "product", any, [](auto a, auto b) { return a * b; }, most);
    check_unary<W>(
        "square", any, [](auto a) { return square(a); }, most);
    check_unary<W>(
        "inverse of a square", any, [](auto a) { return inverse(square(a)); }, most);
    check_binary<W>(
        "root of a product", any, [](auto a, auto b) { return root_of(abs(a * b)); }, most);
    check_binary<W>(
        "sum of products", any, [](auto a, auto b) { return a * b - square(a); }, most);
}

/// A random formula of so many steps, and what it makes of exact numbers.
template <class W>
known<bounded_number<W>> formula_of(random_numbers& random, int depth, double most) {
    using bounded = bounded_number<W>;
    if (depth == 0 || random.one_in(8)) {
        if (random.one_in(2)) return maker<bounded>::any(random, most);
        const auto given = maker<given_number<W>>::any(random, most);
        return {given.number, given.exact};
    }
    const auto a = formula_of<W>(random, depth - 1, most);
    const auto unary = [&](auto f) { return known<bounded>{f(a.number), exactly_in_lanes<W>(f, a.exact)}; };
    switch (random.integer(0, 11)) {
        case 0:
            return unary([](auto x) { return square(x); });
        case 1:
            return unary([](auto x) { return inverse(x); });
        case 2:
            return unary([](auto x) { return root_of(x); });
        case 3:
            return unary([](auto x) { return abs(x); });
        default:
            break;
    }
    // Every other one is all but the first.
    auto b = formula_of<W>(random, random.integer(0, depth - 1), most);
    if (random.one_in(2)) b = {a.number + b.number, exactly_in_lanes<W>(std::plus<>{}, a.exact, b.exact)};
    const auto binary = [&](auto f) {
        return known<bounded>{f(a.number, b.number), exactly_in_lanes<W>(f, a.exact, b.exact)};
    };
    switch (random.integer(0, 5)) {
        case 0:
            return binary([](auto x, auto y) { return x + y; });
        case 1:
            return binary([](auto x, auto y) { return x - y; });
        case 2:
            return binary([](auto x, auto y) { return raio::max(x, y); });
        case 3:
            return binary([](auto x, auto y) { return raio::min(x, y); });
        case 4:
            return binary([](auto x, auto y) { return select(x >= y, y * y, x + x); });
        default:
            return binary([](auto x, auto y) { return x * y; });
    }
}

TEST_CASE_TEMPLATE("bounded_number: a random formula is within its bound", W, RAIO_PRECISIONS) {
    random_numbers random(3);
    worst seen;
    for (int i = 0; i < share_of_lanes<W>(20'000); ++i) {
        const auto made = formula_of<W>(random, random.integer(1, 6), std::same_as<scalar_t<W>, float> ? 10 : 40);
        seen.see(made.number, made.exact);
    }
    CHECK(seen.known > seen.open);
    CHECK(seen.part > 0.9);
}

}  // namespace raio::test
