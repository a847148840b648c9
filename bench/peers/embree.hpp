#pragma once

#include <embree3/rtcore.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <raio/aabb.hpp>
#include <raio/math/transform.hpp>
#include <raio/ray.hpp>

/// \file
/// Embree 3, one ray at a time and sixteen side by side: the triangles of a mesh, instances of one, its own spheres,
/// and whatever has a test in plain floats, as its user geometry.

namespace peers {

struct embree_options {
    const char* isa = "";  ///< "avx2", say; empty: the best that the processor has
    RTCBuildQuality quality = RTC_BUILD_QUALITY_MEDIUM;
    bool robust = false;
    unsigned threads = 1;
};

/// One scene. Nothing is hit before `build`.
class embree {
public:
    using vec3 = raio::vec3<float>;
    using ray = raio::ray<float>;
    using index3 = std::array<std::uint32_t, 3>;

    explicit embree(const embree_options& options);
    ~embree();
    embree(const embree&) = delete;
    embree& operator=(const embree&) = delete;

    void add_triangles(std::span<const vec3> vertices, std::span<const index3> triangles);

    /// The same mesh once for each map, which instances share.
    void add_instances(std::span<const vec3> vertices, std::span<const index3> triangles,
                       std::span<const raio::transform<float>> maps);

    /// Embree's own spheres: centre and radius.
    void add_spheres(std::span<const std::array<float, 4>> spheres);

    /// Shapes as one geometry, which is numbered after those before it. `Kernel` is made from a shape and is called
    /// with a ray, a window and a record of t and normal, as in the benchmark of the shape; what it finds outside the
    /// window does not count.
    template <class Kernel, class Shape>
    void add(std::span<const Shape> shapes);

    void build();

    /// What the tree takes, the vertices and indices not included.
    std::int64_t bytes() const { return bytes_; }

    /// Finds t, the normal (of any length), two coordinates, and which primitive of which geometry.
    bool hit(const ray& r, float t_min, float t_max, RTCRayHit& rec) const {
        rec.ray = from(r, t_min, t_max);
        rec.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &rec);
        return rec.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

    bool occluded(const ray& r, float t_min, float t_max) const {
        RTCRay shadow = from(r, t_min, t_max);
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_, &context, &shadow);
        return shadow.tfar < 0;
    }

    /// The same for rays that begin at one place and run side by side.
    void hit_coherent(std::span<const ray, 16> rays, float t_min, float t_max, RTCRayHit16& rec) const;

private:
    static RTCRay from(const ray& r, float t_min, float t_max) {
        return {.org_x = r.origin.x,
                .org_y = r.origin.y,
                .org_z = r.origin.z,
                .tnear = t_min,
                .dir_x = r.direction.x,
                .dir_y = r.direction.y,
                .dir_z = r.direction.z,
                .time = 0,
                .tfar = t_max,
                .mask = ~0u,
                .id = 0,
                .flags = 0};
    }

    template <class Kernel>
    struct user_geometry;

    RTCScene new_scene() const;
    RTCGeometry geometry(RTCGeometryType type) const { return rtcNewGeometry(device_, type); }
    RTCGeometry mesh(std::span<const vec3> vertices, std::span<const index3> triangles);
    void attach(RTCGeometry geometry, RTCScene to) const;
    void attach(RTCGeometry geometry) const { attach(geometry, scene_); }

    std::atomic<std::int64_t> bytes_ = 0;  // every thread of Embree counts
    RTCBuildQuality quality_;
    bool robust_;
    RTCDevice device_;
    RTCScene scene_;
    // What Embree reads where it lies, and what the callbacks read.
    std::vector<std::vector<float>> vertices_;
    std::vector<std::vector<index3>> indices_;
    std::vector<std::shared_ptr<void>> user_geometries_;
};

/// The shapes of one geometry, and what Embree calls for them with a single ray.
template <class Kernel>
struct embree::user_geometry {
    std::vector<Kernel> kernels;
    std::vector<raio::aabb<float>> boxes;

    static const user_geometry& of(const void* user) { return *static_cast<const user_geometry*>(user); }

    static void bounds(const RTCBoundsFunctionArguments* asked) {
        const auto& box = of(asked->geometryUserPtr).boxes[asked->primID];
        *asked->bounds_o = {.lower_x = box.min.x,
                            .lower_y = box.min.y,
                            .lower_z = box.min.z,
                            .align0 = 0,
                            .upper_x = box.max.x,
                            .upper_y = box.max.y,
                            .upper_z = box.max.z,
                            .align1 = 0};
    }

    static bool meets(const user_geometry& shapes, unsigned index, const RTCRay& r, typename Kernel::result& found) {
        const ray asked{{r.org_x, r.org_y, r.org_z}, {r.dir_x, r.dir_y, r.dir_z}};
        return shapes.kernels[index](asked, r.tnear, r.tfar, found) && found.t >= r.tnear && found.t <= r.tfar;
    }

    static void hit(const RTCIntersectFunctionNArguments* asked) {
        auto& rec = *reinterpret_cast<RTCRayHit*>(asked->rayhit);
        typename Kernel::result found;
        if (asked->valid[0] == 0 || !meets(of(asked->geometryUserPtr), asked->primID, rec.ray, found)) return;
        rec.ray.tfar = found.t;
        rec.hit = {.Ng_x = found.normal.x,
                   .Ng_y = found.normal.y,
                   .Ng_z = found.normal.z,
                   .u = 0,
                   .v = 0,
                   .primID = asked->primID,
                   .geomID = asked->geomID,
                   .instID = {asked->context->instID[0]}};
    }

    static void occluded(const RTCOccludedFunctionNArguments* asked) {
        auto& r = *reinterpret_cast<RTCRay*>(asked->ray);
        typename Kernel::result found;
        if (asked->valid[0] != 0 && meets(of(asked->geometryUserPtr), asked->primID, r, found)) {
            r.tfar = -raio::infinity<float>;
        }
    }
};

template <class Kernel, class Shape>
void embree::add(std::span<const Shape> shapes) {
    auto own = std::make_shared<user_geometry<Kernel>>();
    for (const Shape& shape : shapes) {
        own->kernels.emplace_back(shape);
        own->boxes.push_back(shape.bounds());
    }
    RTCGeometry user = geometry(RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(user, static_cast<unsigned>(shapes.size()));
    rtcSetGeometryUserData(user, own.get());
    rtcSetGeometryBoundsFunction(user, user_geometry<Kernel>::bounds, nullptr);
    rtcSetGeometryIntersectFunction(user, user_geometry<Kernel>::hit);
    rtcSetGeometryOccludedFunction(user, user_geometry<Kernel>::occluded);
    user_geometries_.push_back(std::move(own));
    attach(user);
}

}  // namespace peers
