#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <raio/bvh/bvh.hpp>
#include <raio/compose/group.hpp>

#include "material.hpp"
#include "pigment.hpp"

namespace render {

namespace {

/// What holds shapes of every type that a variant can be.
template <class Variant>
struct kinds_of;
template <class... Shapes>
struct kinds_of<std::variant<Shapes...>> {
    using group = raio::group<std::vector<Shapes>...>;
    using tree = raio::bvh<Shapes...>;
};

bool is_finite(const object& o) {
    const auto ends = [](const auto& s) {
        const raio::aabb<number> box = s.bounds();
        return raio::is_finite(box.min) && raio::is_finite(box.max);
    };
    return std::visit(ends, o.shape);
}

}  // namespace

struct world::surfaces {
    kinds_of<shape>::tree tree;
    std::uint32_t tree_size = 0;
    kinds_of<shape>::group endless;
};

world::world(render::scene scene) : scene_(std::move(scene)) {
    // Trees and groups count their members type by type; sorted by type, objects have the same numbers.
    auto& objects = scene_.objects;
    std::ranges::stable_sort(objects, {}, [](const object& o) { return std::pair(!is_finite(o), o.shape.index()); });
    surfaces all;
    all.tree_size = static_cast<std::uint32_t>(std::ranges::count_if(objects, is_finite));

    kinds_of<shape>::group finite;
    for (std::uint32_t index = 0; index < objects.size(); ++index) {
        const object& o = objects[index];
        auto& members = (index < all.tree_size ? finite : all.endless).members;
        std::visit([&]<class Shape>(const Shape& s) { std::get<std::vector<Shape>>(members).push_back(s); }, o.shape);
        if (!shines(scene_.materials[o.material])) continue;
        const auto* any = std::get_if<any_shape>(&o.shape);
        auto surface = any ? any->sampler() : sampler_of(std::get<raio::triangle<number>>(o.shape));
        if (surface) emitters_.push_back({index, std::move(surface)});
    }
    all.tree = raio::bvh(finite);
    surfaces_ = std::make_shared<const surfaces>(std::move(all));
}

bool world::hit(const ray& r, number t_min, number t_max, hit_record& rec) const {
    const auto& [tree, tree_size, endless] = *surfaces_;
    const bool in_tree = tree.hit(r, t_min, t_max, rec);
    hit_record other;
    // What stands on a plane does not show through it.
    if (!endless.hit(r, t_min, in_tree ? rec.t : t_max, other)) return in_tree;
    rec = other;
    rec.index += tree_size;
    return true;
}

bool world::occluded(const ray& r, number t_min, number t_max) const {
    return surfaces_->endless.occluded(r, t_min, t_max) || surfaces_->tree.occluded(r, t_min, t_max);
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
