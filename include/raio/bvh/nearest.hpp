#pragma once

#include <raio/bvh/leaf_kinds.hpp>

namespace raio::detail {

/// The nearest of all shapes that have been seen so far.
///
/// As long as packs can tell who is nearer, nobody else is asked. Where two may be equally near, or a lane is open, the
/// plain shapes decide, and of equally near ones the lowest id. So what is found is what a loop over `hit` finds; and
/// of the one that is left, `hit` says the rest. Open lanes wait until all has been seen, since to ask a plain shape
/// sweeps the ray out of the registers.
template <class T, class Leaves, class R, class N>
class nearest {
public:
    /// \param rec  is left as it is if there is nothing to be found
    nearest(const Leaves& leaves, const ray<R>& ray, T t_min, T t_max, hit_record<T, N>& rec)
        : leaves_(leaves), ray_(ray), t_min_(t_min), t_max_(t_max), low_(t_max), high_(t_max), rec_(rec) {}

    /// Nothing beyond that can be nearest.
    T farthest() const { return high_; }

    template <std::size_t Kind>
    void visit(std::uint32_t block) {
        if constexpr (Leaves::template filters<Kind, R>) {
            sift<Kind>(block);
        } else {
            // Nobody knows but the plain shapes. They are asked at once: what is found shortens the way.
            auto found = leaves_.template find<Kind>(block, ray_, t_min_, high_);
            for (; found.open != 0; found.open &= found.open - 1) {
                settle<Kind>(place_of<Kind>(block, static_cast<unsigned>(std::countr_zero(found.open))));
            }
        }
    }

    /// Answers the question, once everything has been seen.
    bool finish() {
        if (open_count_ != 0) settle_open();
        if (exists_ && !exact_) make_exact();
        return exists_;
    }

private:
    struct place {
        std::size_t kind;
        std::uint32_t block;
        unsigned lane;
        std::uint32_t id;
    };

    template <std::size_t Kind>
    place place_of(std::uint32_t block, unsigned lane) const {
        return {Kind, block, lane, std::get<Kind>(leaves_.all).id(block, lane)};
    }

    /// Takes what packs are certain of, and lets wait what they leave open.
    template <std::size_t Kind>
    void sift(std::uint32_t block) {
        auto found = leaves_.template find<Kind>(block, ray_, t_min_, high_);
        for (; found.sure != 0; found.sure &= found.sure - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(found.sure));
            const T low = found.low[lane], high = found.high[lane];
            if (exists_ && high_ < low) continue;
            if (!exists_ || high < low_) {
                take(place_of<Kind>(block, lane), low, high);
            } else {
                found.open |= 1u << lane;
            }
        }
        for (; found.open != 0; found.open &= found.open - 1) {
            if (open_count_ == open_.size()) settle_open();
            open_[open_count_++] = place_of<Kind>(block, static_cast<unsigned>(std::countr_zero(found.open)));
        }
    }

    void take(const place& at, T low, T high) {
        at_ = at, low_ = low, high_ = high;
        exists_ = true, exact_ = false;
    }

    void make_exact() {
        exact_ = true;
        Leaves::with_kind(static_cast<std::uint32_t>(at_.kind), [&](auto kind) {
            const auto& shape = std::get<kind()>(leaves_.all).shape(at_.block, at_.lane);
            if constexpr (gatherable<std::remove_cvref_t<decltype(shape)>>) {
                first_hit<question::only_where>(shape, ray_, t_min_, t_max_, rec_);  // packs are certain of it
            } else {
                detail::hit(shape, ray_, t_min_, t_max_, rec_);
            }
        });
        rec_.index = at_.id;
        low_ = high_ = rec_.t;
    }

    /// Asks the plain shapes of all lanes that wait.
    [[gnu::noinline]] void settle_open() {
        for (std::size_t i = 0; i < open_count_; ++i) {
            Leaves::with_kind(static_cast<std::uint32_t>(open_[i].kind), [&](auto kind) { settle<kind()>(open_[i]); });
        }
        open_count_ = 0;
    }

    /// Asks the plain shape.
    template <std::size_t Kind>
    void settle(const place& at) {
        if (exists_ && at.id == at_.id) return;  // a shape may stand in several leaves
        hit_record<T, N> candidate;
        if (!detail::hit(std::get<Kind>(leaves_.all).shape(at.block, at.lane), ray_, t_min_, high_, candidate)) return;
        if (exists_ && !exact_ && !(candidate.t < low_)) make_exact();
        if (exists_ && !(candidate.t < low_ || (candidate.t == low_ && at.id < at_.id))) return;
        take(at, candidate.t, candidate.t);
        rec_ = candidate;
        rec_.index = at.id;
        exact_ = true;
    }

    const Leaves& leaves_;
    const ray<R>& ray_;
    T t_min_, t_max_;
    T low_, high_;  ///< where the nearest is, once there is one
    place at_{};
    std::array<place, 8> open_;  ///< lanes that wait
    std::size_t open_count_ = 0;
    bool exists_ = false, exact_ = false;
    hit_record<T, N>& rec_;  ///< of the nearest, if that is exact
};

}  // namespace raio::detail
