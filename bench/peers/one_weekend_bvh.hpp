#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "peers/one_weekend.hpp"

/// \file
/// The worlds of *Ray Tracing in One Weekend* and *The Next Week* (Shirley, Black and Hollasch), in the books' manner:
/// objects behind shared pointers with a virtual `hit`, once in a list, and once in a binary tree of nodes that are
/// such objects themselves, each split in the middle of its longest axis.

namespace peers::one_weekend {

/// A material is known by a shared pointer as well, which is copied into the record.
template <class T, class Material>
struct hit_record : record<T> {
    std::shared_ptr<const Material> material;
};

template <class T, class Material>
struct hittable {
    using hit_record = one_weekend::hit_record<T, Material>;
    virtual ~hittable() = default;
    virtual bool hit(const raio::ray<T>& ray, T t_min, T t_max, hit_record& rec) const = 0;
    virtual raio::aabb<T> bounding_box() const = 0;
};

template <class T, class Material>
using objects = std::vector<std::shared_ptr<const hittable<T, Material>>>;

template <class T, class Material>
class sphere final : public hittable<T, Material> {
public:
    using typename hittable<T, Material>::hit_record;

    sphere(const raio::sphere<T>& shape, std::shared_ptr<const Material> material)
        : shape_(shape), material_(std::move(material)) {}

    bool hit(const raio::ray<T>& ray, T t_min, T t_max, hit_record& rec) const override {
        if (!shape_(ray, t_min, t_max, rec)) return false;
        rec.material = material_;
        return true;
    }

    raio::aabb<T> bounding_box() const override {
        const raio::vec3<T> reach(std::fabs(shape_.radius));
        return {shape_.center - reach, shape_.center + reach};
    }

private:
    one_weekend_sphere<T> shape_;
    std::shared_ptr<const Material> material_;
};

template <class T, class Material>
class hittable_list final : public hittable<T, Material> {
public:
    using typename hittable<T, Material>::hit_record;

    explicit hittable_list(one_weekend::objects<T, Material> objects) : objects_(std::move(objects)) {}

    bool hit(const raio::ray<T>& ray, T t_min, T t_max, hit_record& rec) const override {
        hit_record candidate;
        bool found = false;
        for (const auto& object : objects_) {
            if (!object->hit(ray, t_min, t_max, candidate)) continue;
            found = true;
            t_max = candidate.t;
            rec = candidate;
        }
        return found;
    }

    raio::aabb<T> bounding_box() const override {
        raio::aabb<T> box;
        for (const auto& object : objects_) box = hull(box, object->bounding_box());
        return box;
    }

private:
    one_weekend::objects<T, Material> objects_;
};

template <class T, class Material>
class bvh_node final : public hittable<T, Material> {
public:
    using typename hittable<T, Material>::hit_record;
    using objects = one_weekend::objects<T, Material>;

    explicit bvh_node(objects all) : bvh_node(all, 0, all.size()) {}

    /// Of the objects from `start` to before `end`, at least one, which are reordered.
    bvh_node(objects& all, std::size_t start, std::size_t end) {
        for (std::size_t i = start; i < end; ++i) box_ = hull(box_, all[i]->bounding_box());
        const raio::vec3<T> size = box_.max - box_.min;
        const glm::length_t axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        if (end - start <= 2) {
            left_ = all[start];
            right_ = all[end - 1];
            return;
        }
        std::ranges::sort(all.begin() + static_cast<std::ptrdiff_t>(start),
                          all.begin() + static_cast<std::ptrdiff_t>(end), {},
                          [=](const auto& object) { return object->bounding_box().min[axis]; });
        const std::size_t middle = start + (end - start) / 2;
        left_ = std::make_shared<bvh_node>(all, start, middle);
        right_ = std::make_shared<bvh_node>(all, middle, end);
    }

    bool hit(const raio::ray<T>& ray, T t_min, T t_max, hit_record& rec) const override {
        if (!meets_box(ray, t_min, t_max)) return false;
        const bool hit_left = left_->hit(ray, t_min, t_max, rec);
        const bool hit_right = right_->hit(ray, t_min, hit_left ? rec.t : t_max, rec);
        return hit_left || hit_right;
    }

    raio::aabb<T> bounding_box() const override { return box_; }

private:
    bool meets_box(const raio::ray<T>& ray, T t_min, T t_max) const {
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const T over_d = 1 / ray.direction[axis];
            T enter = (box_.min[axis] - ray.origin[axis]) * over_d,
              leave = (box_.max[axis] - ray.origin[axis]) * over_d;
            if (over_d < 0) std::swap(enter, leave);
            t_min = enter > t_min ? enter : t_min;
            t_max = leave < t_max ? leave : t_max;
            if (t_max <= t_min) return false;
        }
        return true;
    }

    std::shared_ptr<const hittable<T, Material>> left_, right_;
    raio::aabb<T> box_;
};

}  // namespace peers::one_weekend
