#pragma once

#include <memory>
#include <vector>

#include "peers/moeller_trumbore.hpp"
#include "peers/one_weekend.hpp"

namespace peers {

/// The world of *Ray Tracing in One Weekend*: a list of pointers to objects with a virtual `hit`, the nearest kept. Its
/// spheres are the book's, its triangles `moeller_trumbore`.
template <class T>
class virtual_list {
public:
    static constexpr const char* name = "virtual_list";
    using result = record<T>;

    template <class Group>
    explicit virtual_list(const Group& group) {
        for (const auto& sphere : std::get<0>(group.members)) add<one_weekend_sphere<T>>(sphere);
        for (const auto& triangle : std::get<1>(group.members)) add<with_record<moeller_trumbore<T>>>(triangle);
    }

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        record<T> candidate;
        bool found = false;
        for (const auto& each : objects_) {
            if (!each->hit(ray, t_min, t_max, candidate)) continue;
            found = true;
            t_max = candidate.t;
            rec = candidate;
        }
        return found;
    }

private:
    struct hittable {
        virtual ~hittable() = default;
        virtual bool hit(const raio::ray<T>& ray, T t_min, T t_max, record<T>& rec) const = 0;
    };

    template <class Object>
    struct object final : hittable {
        Object shape;

        template <class Shape>
        explicit object(const Shape& from) : shape(from) {}
        bool hit(const raio::ray<T>& ray, T t_min, T t_max, record<T>& rec) const override {
            return shape(ray, t_min, t_max, rec);
        }
    };

    template <class Object, class Shape>
    void add(const Shape& shape) {
        objects_.push_back(std::make_shared<object<Object>>(shape));
    }

    std::vector<std::shared_ptr<const hittable>> objects_;
};

}  // namespace peers
