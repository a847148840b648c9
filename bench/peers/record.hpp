#pragma once

#include <raio/ray.hpp>

namespace peers {

/// The hit record of the textbooks: no uv, no error bound.
template <class T>
struct record {
    raio::vec3<T> point, normal;
    T t;
    bool front_face;

    /// Turns the unit vector that points out of the shape against the ray.
    void face(const raio::ray<T>& ray, const raio::vec3<T>& outward_normal) {
        front_face = raio::dot(ray.direction, outward_normal) < T(0);
        normal = front_face ? outward_normal : -outward_normal;
    }
};

/// A peer that finds t only, followed by what a renderer would have to compute itself: the textbook record. It needs
/// `outward_normal(point)` of the peer.
template <class Peer>
struct with_record : Peer {
    static constexpr const char* name = Peer::name_with_record;
    using Peer::Peer;
    using T = typename Peer::number;
    using result = record<T>;

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        typename Peer::result found;
        if (!Peer::operator()(ray, t_min, t_max, found)) return false;
        rec.t = found.t;
        rec.point = ray.origin + ray.direction * rec.t;
        rec.face(ray, this->outward_normal(rec.point));
        return true;
    }
};

}  // namespace peers
