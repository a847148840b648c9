#pragma once

#include <raio/push_macros.hpp>

#include <algorithm>
#include <span>
#include <vector>

#include <raio/concepts.hpp>

/// \file
/// Crossings in order along the ray: the nearest few, or all. Of equally near ones the front faces come first, and of
/// these the lowest index.

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

template <class T>
bool is_same_crossing(const hit_record<T>& a, const hit_record<T>& b) {
    return a.t == b.t && a.index == b.index;
}

/// As many of the nearest as there is room for.
template <class T>
class nearest_few {
public:
    nearest_few(std::span<hit_record<T>> room, T t_max) : room_(room), t_max_(t_max) {}

    std::size_t count() const { return count_; }
    T farthest() const { return count_ < room_.size() ? t_max_ : room_[count_ - 1].t; }

    void add(const hit_record<T>& rec) {
        std::size_t at = count_;
        while (at > 0 && comes_before(rec, room_[at - 1])) --at;
        if (at == room_.size() || (at > 0 && is_same_crossing(rec, room_[at - 1]))) return;
        if (count_ < room_.size()) ++count_;
        for (std::size_t i = count_ - 1; i > at; --i) room_[i] = room_[i - 1];
        room_[at] = rec;
    }

private:
    std::span<hit_record<T>> room_;
    T t_max_;
    std::size_t count_ = 0;
};

/// All of them, in no order yet.
template <class T>
class all_hits {
public:
    explicit all_hits(T t_max) : t_max_(t_max) {}

    T farthest() const { return t_max_; }
    void add(const hit_record<T>& rec) { hits_.push_back(rec); }

    std::vector<hit_record<T>> sorted() && {
        std::sort(hits_.begin(), hits_.end(), comes_before<T>);
        // A shape may stand in several leaves.
        hits_.erase(std::unique(hits_.begin(), hits_.end(), is_same_crossing<T>), hits_.end());
        return std::move(hits_);
    }

private:
    T t_max_;
    std::vector<hit_record<T>> hits_;
};

/// Calls `visit` with all crossings of one shape in the window, in order, until it answers false. Crossings whose t
/// round to the same number are one.
template <class Shape, class T, class Visit>
void for_each_crossing(const Shape& shape, const ray<T>& ray, T t_min, T t_max, std::uint32_t index, Visit visit) {
    hit_record<T> rec;
    while (shape.hit(ray, t_min, t_max, rec)) {
        rec.index = index;
        if (!visit(rec)) return;
        t_min = after(rec.t);
    }
}

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
