#include "peers/embree.hpp"

#include <stdexcept>
#include <string>

namespace peers {
namespace {

RTCDevice new_device(const embree_options& options) {
    const std::string isa = options.isa, how = "threads=" + std::to_string(options.threads);
    RTCDevice device = rtcNewDevice((isa.empty() ? how : how + ",isa=" + isa).c_str());
    if (!device) throw std::runtime_error("Embree cannot start with isa=" + isa);
    return device;
}

}  // namespace

embree::embree(const embree_options& options)
    : quality_(options.quality), robust_(options.robust), device_(new_device(options)), scene_(new_scene()) {
    const auto count_bytes = [](void* counter, ssize_t bytes, bool) {
        *static_cast<std::atomic<std::int64_t>*>(counter) += bytes;
        return true;
    };
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    rtcSetDeviceErrorFunction(
        device_, [](void*, RTCError, const char* what) { throw std::runtime_error(what); }, nullptr);
}

embree::~embree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

RTCScene embree::new_scene() const {
    RTCScene scene = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene, quality_);
    rtcSetSceneFlags(scene, robust_ ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    return scene;
}

RTCGeometry embree::mesh(std::span<const vec3> vertices, std::span<const index3> triangles) {
    // Embree loads four floats at each vertex: the last one needs something behind it.
    auto& coordinates = vertices_.emplace_back();
    coordinates.reserve(3 * vertices.size() + 1);
    for (const vec3& v : vertices) coordinates.insert(coordinates.end(), {v.x, v.y, v.z});
    coordinates.push_back(0);
    const auto& own = indices_.emplace_back(triangles.begin(), triangles.end());
    RTCGeometry mesh = geometry(RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, coordinates.data(), 0,
                               3 * sizeof(float), vertices.size());
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, own.data(), 0, sizeof(index3),
                               own.size());
    return mesh;
}

void embree::add_triangles(std::span<const vec3> vertices, std::span<const index3> triangles) {
    attach(mesh(vertices, triangles));
}

void embree::add_instances(std::span<const vec3> vertices, std::span<const index3> triangles,
                           std::span<const raio::transform<float>> maps) {
    RTCScene shared = new_scene();
    attach(mesh(vertices, triangles), shared);
    rtcCommitScene(shared);
    for (const auto& [x, y, z, origin] : maps) {
        const float columns[] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, origin.x, origin.y, origin.z};
        RTCGeometry instance = geometry(RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(instance, shared);
        rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
        attach(instance);
    }
    rtcReleaseScene(shared);
}

void embree::add_spheres(std::span<const std::array<float, 4>> spheres) {
    auto& own = vertices_.emplace_back();
    for (const auto& sphere : spheres) own.insert(own.end(), sphere.begin(), sphere.end());
    RTCGeometry points = geometry(RTC_GEOMETRY_TYPE_SPHERE_POINT);
    rtcSetSharedGeometryBuffer(points, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, own.data(), 0, 4 * sizeof(float),
                               spheres.size());
    attach(points);
}

void embree::attach(RTCGeometry geometry, RTCScene to) const {
    rtcSetGeometryBuildQuality(geometry, quality_);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(to, geometry);
    rtcReleaseGeometry(geometry);
}

void embree::build() { rtcCommitScene(scene_); }

void embree::hit_coherent(std::span<const ray, 16> rays, float t_min, float t_max, RTCRayHit16& rec) const {
    alignas(64) static constexpr int all[16] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        const auto& [origin, direction] = rays[lane];
        rec.ray.org_x[lane] = origin.x, rec.ray.org_y[lane] = origin.y, rec.ray.org_z[lane] = origin.z;
        rec.ray.dir_x[lane] = direction.x, rec.ray.dir_y[lane] = direction.y, rec.ray.dir_z[lane] = direction.z;
        rec.ray.tnear[lane] = t_min, rec.ray.tfar[lane] = t_max;
        rec.ray.time[lane] = 0, rec.ray.mask[lane] = ~0u, rec.ray.flags[lane] = 0;
        rec.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(all, scene_, &context, &rec);
}

}  // namespace peers
