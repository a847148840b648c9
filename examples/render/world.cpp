#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "material.hpp"
#include "pigment.hpp"

namespace render {

namespace {

bool is_finite(const object& o) {
    const auto ends = [](const auto& s) {
        const raio::aabb<number> box = s.bounds();
        return raio::is_finite(box.min) && raio::is_finite(box.max);
    };
    return std::visit(ends, o.shape);
}

}  // namespace

world::world(render::scene scene) : scene_(std::move(scene)) {
    // Trees and groups count their members type by type; sorted by type, objects have the same numbers.
    auto& objects = scene_.objects;
    std::ranges::stable_sort(objects, {}, [](const object& o) { return std::pair(!is_finite(o), o.shape.index()); });
    tree_size_ = static_cast<std::uint32_t>(std::ranges::count_if(objects, is_finite));

    kinds_of<shape>::group finite;
    for (std::uint32_t index = 0; index < objects.size(); ++index) {
        const object& o = objects[index];
        auto& members = (index < tree_size_ ? finite : endless_).members;
        std::visit([&]<class Shape>(const Shape& s) { std::get<std::vector<Shape>>(members).push_back(s); }, o.shape);
        if (!shines(scene_.materials[o.material])) continue;
        const auto* any = std::get_if<any_shape>(&o.shape);
        auto surface = any ? any->sampler() : sampler_of(std::get<raio::triangle<number>>(o.shape));
        if (surface) emitters_.push_back({index, std::move(surface)});
    }
    tree_ = raio::bvh(finite);
}

bool world::hit(const ray& r, number t_min, number t_max, hit_record& rec) const {
    const bool in_tree = tree_.hit(r, t_min, t_max, rec);
    hit_record other;
    // What stands on a plane does not show through it.
    if (!endless_.hit(r, t_min, in_tree ? rec.t : t_max, other)) return in_tree;
    rec = other;
    rec.index += tree_size_;
    return true;
}

bool world::occluded(const ray& r, number t_min, number t_max) const {
    return endless_.occluded(r, t_min, t_max) || tree_.occluded(r, t_min, t_max);
}

color world::color_at(const hit_record& rec, coding as) const {
    return render::color_at(scene_.pigments[scene_.objects[rec.index].pigment], rec.point, as);
}

const material& world::material_at(const hit_record& rec) const {
    return scene_.materials[scene_.objects[rec.index].material];
}

const emitter* world::emitter_at(const hit_record& rec) const {
    const auto at = std::ranges::lower_bound(emitters_, rec.index, {}, &emitter::object);
    return at != emitters_.end() && at->object == rec.index ? &*at : nullptr;
}

color world::background_in(const vec3& direction) const {
    const number height = (raio::normalize(direction).y + 1) / 2;
    return scene_.background.bottom * (1 - height) + scene_.background.top * height;
}

number world::clarity(number distance) const {
    return scene_.fog.density > 0 ? std::exp(-scene_.fog.density * distance) : 1;
}

}  // namespace render
