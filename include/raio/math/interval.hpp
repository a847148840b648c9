#pragma once

#include <raio/push_macros.hpp>

#include <array>
#include <cstddef>

#include <raio/number/real.hpp>

namespace raio::inline RAIO_ABI {

/// The parameters `min <= t <= max` of a ray. Empty where `min > max`, as it is when it is new. T is a number, or
/// whatever is compared by one.
template <class T>
struct interval {
    T min = infinity<T>;
    T max = -infinity<T>;

    RAIO_FN constexpr mask_t<T> empty() const { return !(min <= max); }
    RAIO_FN constexpr mask_t<T> contains(const T& t) const { return every(min <= t, t <= max); }
    RAIO_FN constexpr T length() const { return select(min <= max, max - min, T(0)); }
    RAIO_FN friend constexpr bool operator==(const interval& a, const interval& b) {
        return a.min == b.min && a.max == b.max;
    }
};

/// The room of spans that grow as they must.
inline constexpr std::size_t any_number = static_cast<std::size_t>(-1);

/// The room for two lists together.
template <std::size_t N, std::size_t M>
inline constexpr std::size_t room = N == any_number || M == any_number ? any_number : N + M;

namespace detail {

/// What N intervals stand in. For any_number there is math/any_number_of_spans.hpp.
template <class T, std::size_t N>
struct span_storage {
    using type = std::array<interval<T>, N>;
};

}  // namespace detail

/// Where a ray is inside a solid: at most N intervals, in order along the ray, none of them empty, no two with a point
/// in common. The room is part of the type, so that a solid's spans need no memory of their own, on a graphics card
/// neither. Only what is not known before the program runs has room for any_number.
template <class T, std::size_t N>
struct spans {
    typename detail::span_storage<T, N>::type intervals{};
    std::size_t count = 0;

    constexpr spans() = default;
    RAIO_FN constexpr spans(const interval<T>& one) requires(N >= 1) { append(one); }

    RAIO_FN constexpr const interval<T>* begin() const { return intervals.data(); }
    RAIO_FN constexpr const interval<T>* end() const { return intervals.data() + count; }
    RAIO_FN constexpr bool empty() const { return count == 0; }
    RAIO_FN constexpr bool contains(const T& t) const {
        for (const interval<T>& i : *this) {
            if (i.contains(t)) return true;
        }
        return false;
    }

    /// What `f` makes of each of the intervals, which stay apart and in order.
    template <class F>
    RAIO_FN constexpr auto each(F f) const {
        using U = decltype(f(intervals[0]).min);
        spans<U, N> made;
        made.count = count;
        if constexpr (N == any_number) made.intervals.resize(count);
        for (std::size_t i = 0; i < count; ++i) made.intervals[i] = f(intervals[i]);
        return made;
    }

    /// Adds an interval that starts no earlier than the last one; where the two meet they become one.
    RAIO_FN constexpr void append(const interval<T>& next) {
        if (next.empty()) return;
        if (count > 0 && next.min <= intervals[count - 1].max) {
            intervals[count - 1].max = max(intervals[count - 1].max, next.max);
            return;
        }
        if constexpr (N == any_number) {
            intervals.push_back(next);
            ++count;
        } else {
            intervals[count++] = next;
        }
    }

    /// Adds an interval that may start anywhere; it becomes one with all that it meets.
    RAIO_FN constexpr void insert(interval<T> next) {
        if (next.empty()) return;
        std::size_t first = 0;
        while (first < count && intervals[first].max < next.min) ++first;
        std::size_t last = first;
        for (; last < count && intervals[last].min <= next.max; ++last) {
            next = {min(next.min, intervals[last].min), max(next.max, intervals[last].max)};
        }
        if (first == last) {
            if constexpr (N == any_number) intervals.push_back(next);
            for (std::size_t i = count++; i > first; --i) intervals[i] = intervals[i - 1];
        } else {
            for (std::size_t i = last; i < count; ++i) intervals[i - last + first + 1] = intervals[i];
            count -= last - first - 1;
            if constexpr (N == any_number) intervals.resize(count);
        }
        intervals[first] = next;
    }
};

template <class T>
spans(interval<T>) -> spans<T, 1>;

/// The room of an interval is one, that of spans is their own.
template <class Inside>
inline constexpr std::size_t room_in = 1;
template <class T, std::size_t N>
inline constexpr std::size_t room_in<spans<T, N>> = N;

/// Inside either.
template <class T, std::size_t N, std::size_t M>
RAIO_FN constexpr spans<T, room<N, M>> unite(const spans<T, N>& a, const spans<T, M>& b) {
    spans<T, room<N, M>> both;
    for (std::size_t i = 0, j = 0; i < a.count || j < b.count;) {
        const bool from_a = j == b.count || (i < a.count && a.intervals[i].min <= b.intervals[j].min);
        both.append(from_a ? a.intervals[i++] : b.intervals[j++]);
    }
    return both;
}

/// Inside both. Of two lists that are walked together, the interval that ends first has met all it can.
template <class T, std::size_t N, std::size_t M>
RAIO_FN constexpr spans<T, room<N, M>> intersect(const spans<T, N>& a, const spans<T, M>& b) {
    spans<T, room<N, M>> both;
    for (std::size_t i = 0, j = 0; i < a.count && j < b.count;) {
        const interval<T>&p = a.intervals[i], &q = b.intervals[j];
        both.append({max(p.min, q.min), min(p.max, q.max)});
        p.max < q.max ? ++i : ++j;
    }
    return both;
}

/// Inside `a` and not in the interior of `b`: what is left keeps the ends where `b` was cut off. An interval that is
/// cut down to a single point is gone, and so is one that was a point, if `b` has it. Of equal ends that of `a` stays.
template <class T, std::size_t N, std::size_t M>
RAIO_FN constexpr spans<T, room<N, M>> subtract(const spans<T, N>& a, const spans<T, M>& b) {
    spans<T, room<N, M>> rest;
    std::size_t j = 0;
    for (interval<T> left : a) {
        while (j < b.count && left.min > b.intervals[j].max) ++j;
        std::size_t k = j;
        for (; k < b.count && b.intervals[k].min <= left.max; ++k) {
            if (left.min < b.intervals[k].min) rest.append({left.min, min(left.max, b.intervals[k].min)});
            left.min = max(left.min, b.intervals[k].max);
        }
        if (k == j || left.min < left.max) rest.append(left);
    }
    return rest;
}

}  // namespace raio::inline RAIO_ABI

#include <raio/pop_macros.hpp>
