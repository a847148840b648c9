#pragma once

#include <raio/push_macros.hpp>

#include <raio/bvh/leaf_kinds.hpp>
#include <raio/compose/group.hpp>

namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {

/// The nearest of all shapes that have been seen so far.
///
/// As long as packs can tell who is nearer, nobody else is asked. Where two may be equally near, or a lane is open, the
/// plain shapes decide: of equally near ones that which shows its front, and of these the lowest id. So what is found
/// is what a loop over `hit` finds; and of the one that is left, `hit` says the rest. Open lanes wait until all has
/// been seen, since to ask a plain shape sweeps the ray out of the registers.
template <class T, class Leaves, class Ray, record Record>
class nearest {
public:
    /// \param rec  is left as it is if there is nothing to be found
    nearest(const Leaves& leaves, const Ray& ray, T t_min, T t_max, Record& rec)
        : leaves_(leaves), ray_(ray), t_min_(t_min), t_max_(t_max), low_(t_max), high_(t_max), rec_(rec) {}

    /// Nothing beyond that can be nearest.
    T farthest() const { return high_; }

    template <std::size_t Kind>
    void visit(std::uint32_t block) {
        if constexpr (Leaves::template filters<Kind, Ray>) {
            sift<Kind>(block);
        } else {
            // Nobody knows but the plain shapes. They are asked at once: what is found shortens the way.
            auto found = leaves_.template find<Kind>(block, ray_, t_min_, high_);
            for (; found.open != 0; found.open &= found.open - 1) {
                ask<Kind>(leaves_.template place<Kind>(block, static_cast<unsigned>(std::countr_zero(found.open))));
            }
        }
    }

    /// Takes in what packs say of a shape: that it is hit between `low` and `high`.
    void consider(place_in_leaves at, T low, T high) {
        if constexpr (Leaves::are_quick) {
            if (!exists_ || low < low_ || (low == low_ && comes_first(at))) take(at, low, high);
            return;
        }
        if (exists_ && high_ < low) return;
        if (!exists_ || high < low_) {
            take(at, low, high);
        } else {
            wait(at);
        }
    }

    /// Lets a shape wait that packs leave open.
    void wait(place_in_leaves at) {
        if (open_count_ == open_.size()) settle_open();
        open_[open_count_++] = at;
    }

    /// The nearest so far, if it has yet to be recorded.
    const place_in_leaves* unrecorded() const { return exists_ && !exact_ ? &at_ : nullptr; }
    /// Where it is at the earliest.
    T low() const { return low_; }

    /// Takes in what it records.
    void take_in(const Record& found) {
        rec_ = found;
        put_index(rec_, at_.id);
        exact_ = true;
        low_ = high_ = rec_.t;
    }

    /// Answers the question, once everything has been seen.
    bool finish() {
        if constexpr (!Leaves::are_quick) {
            if (open_count_ != 0) settle_open();
        }
        if (exists_ && !exact_) make_exact();
        return exists_;
    }

private:
    /// Takes what packs are certain of, and lets wait what they leave open.
    template <std::size_t Kind>
    void sift(std::uint32_t block) {
        auto found = leaves_.template find<Kind>(block, ray_, t_min_, high_);
        for (; found.sure != 0; found.sure &= found.sure - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(found.sure));
            consider(leaves_.template place<Kind>(block, lane), found.low[lane], found.high[lane]);
        }
        if constexpr (Leaves::are_quick) return;
        for (; found.open != 0; found.open &= found.open - 1) {
            wait(leaves_.template place<Kind>(block, static_cast<unsigned>(std::countr_zero(found.open))));
        }
    }

    void take(place_in_leaves at, T low, T high) {
        at_ = at, low_ = low, high_ = high;
        exists_ = true, exact_ = false;
    }

    void make_exact() {
        exact_ = true;
        leaves_.record_at(at_, ray_, t_min_, t_max_, low_, rec_);
        low_ = high_ = rec_.t;
    }

    /// Asks the plain shapes of all lanes that wait.
    [[gnu::noinline]] void settle_open() {
        for (std::size_t i = 0; i < open_count_; ++i) {
            Leaves::with_kind(static_cast<std::uint32_t>(open_[i].kind), [&](auto kind) {
                if constexpr (Leaves::template filters<kind(), Ray>) settle<kind()>(open_[i]);
            });
        }
        open_count_ = 0;
    }

    /// Asks the plain shape, of which packs know.
    template <std::size_t Kind>
    void settle(const place_in_leaves& at) {
        if (exists_ && at.id == at_.id) return;  // a shape may stand in several leaves
        Record candidate;
        if (!leaves_.template hit<Kind>(at, ray_, t_min_, high_, candidate)) return;
        if (exists_ && !exact_ && !(candidate.t < low_)) make_exact();
        if (exists_ && !(candidate.t < low_ || (candidate.t == low_ && comes_first(at)))) return;
        take(at, candidate.t, candidate.t);
        assign(true, rec_, candidate);
        exact_ = true;
    }

    /// Asks the plain shape, whatever it is, which may write into the record what is not known here: it is given the
    /// record itself, and a window in which none is nearer.
    template <std::size_t Kind>
    void ask(const place_in_leaves& at) {
        if (exists_ && at.id == at_.id) return;
        if (exists_ && !exact_) make_exact();
        if (!leaves_.template hit<Kind>(at, ray_, t_min_, exists_ ? low_ : t_max_, rec_)) return;
        if (exists_ && rec_.t == low_ && !comes_first(at)) [[unlikely]]
            return record_again();
        take(at, rec_.t, rec_.t);
        exact_ = true;
    }

    /// Is a shape that is as near as the nearest to be preferred?
    bool comes_first(place_in_leaves at) const {
        return at.id != at_.id && comes_before(leaves_, ray_, t_min_, low_, at, at_, rec_);
    }

    /// Does one of two that are hit at t come before the other? (Not asked of the query itself, whose members stay in
    /// registers.)
    RAIO_RARELY static bool comes_before(const Leaves& leaves, const Ray& ray, T t_min, T t, place_in_leaves one,
                                         place_in_leaves other, [[maybe_unused]] const Record& rec) {
        const auto shows_front = [&](const place_in_leaves& at) {
            if constexpr (Leaves::are_quick) {  // nothing has been recorded yet
                return leaves.shows_front(at, ray, t_min, t, decltype(with_side<T>(rec)){});
            } else {
                return leaves.shows_front(at, ray, t_min, t, with_side<T>(rec));
            }
        };
        const bool front = shows_front(one);
        return front == shows_front(other) ? one.id < other.id : front;
    }

    /// Another one has written into the record.
    RAIO_RARELY void record_again() {
        Leaves::with_kind(static_cast<std::uint32_t>(at_.kind),
                          [&](auto kind) { leaves_.template hit<kind()>(at_, ray_, t_min_, low_, rec_); });
    }

    const Leaves& leaves_;
    const Ray& ray_;
    T t_min_, t_max_;
    T low_, high_;  ///< where the nearest is, once there is one
    place_in_leaves at_{};
    std::array<place_in_leaves, 8> open_;  ///< lanes that wait
    std::size_t open_count_ = 0;
    bool exists_ = false, exact_ = false;
    Record& rec_;  ///< of the nearest, if that is exact
};

}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS

#include <raio/pop_macros.hpp>
