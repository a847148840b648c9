#include "reader.hpp"

#include <cctype>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <utility>

#include "reading.hpp"
#include "shape_reader.hpp"

namespace render {
namespace {

camera_description read_camera(tokens& in) {
    constexpr requirement opening{"an angle above 0 and below 180", [](double x) { return x > 0 && x < 180; }};
    camera_description camera;
    camera.eye = vector(in, "the camera's eye");
    camera.look_at = vector(in, "the point to look at");
    if (camera.look_at == camera.eye) in.fail("the eye again", "another point to look at");
    camera.up = direction(in, "the camera's up");

    // The sine of their angle; what is below some roundings is zero with coordinates that could not be written exactly.
    const vec3 view = raio::normalize(camera.look_at - camera.eye), up = raio::normalize(camera.up);
    if (raio::length(raio::cross(up, view)) < 16 * raio::unit_roundoff<number>) {
        in.fail("an up along the view", "another direction for the camera's up");
    }
    camera.vertical_field_of_view = in.expect_number("the vertical field of view", opening);
    return camera;
}

point_light read_light(tokens& in) {
    const vec3 position = vector(in, "the position of a light");
    const color intensity = rgb(in, "the colour of a light");
    const auto attenuation = numbers<3>(in, "the attenuation of a light", not_negative);
    if (attenuation == std::array<number, 3>{}) in.fail("0 0 0", "an attenuation that is not 0 everywhere");
    return {position, intensity, attenuation};
}

/// The pictures of a scene, each loaded once however often it is named.
class pictures {
public:
    pictures(std::filesystem::path folder, const texture_loader& load) : folder_(std::move(folder)), load_(load) {}

    std::shared_ptr<const texture> read(tokens& in) {
        const std::string name(in.expect_word("the file of a texture"));
        std::shared_ptr<const texture>& picture = loaded_[name];
        if (picture) return picture;
        try {
            return picture = std::make_shared<const texture>(load_(folder_ / name));
        } catch (const std::bad_alloc&) {
            throw;  // which says nothing of the file
        } catch (const std::exception& error) {
            in.fail(
                joined({"no picture in the texture '", printable(name, 200), "' (", printable(error.what(), 200), ")"}),
                "a picture file, named from the scene's folder");
        }
    }

private:
    std::filesystem::path folder_;
    const texture_loader& load_;
    std::map<std::string, std::shared_ptr<const texture>> loaded_;
};

const by_name<pigment (*)(tokens&, pictures&)> pigments{
    {"solid", [](tokens& in, pictures&) -> pigment { return solid{rgb(in, "the colour of a pigment")}; }},
    {"checker",
     [](tokens& in, pictures&) -> pigment {
         return checker{rgb(in, "the first colour of a checker"), rgb(in, "the second colour of a checker"),
                        in.expect_number("the size of a checker", positive)};
     }},
    {"texture",
     [](tokens& in, pictures& known) -> pigment {
         return textured{known.read(in), numbers<4>(in, "P of a texture"), numbers<4>(in, "Q of a texture")};
     }},
};

const by_name<material (*)(tokens&)> named_materials{
    {"lambertian", [](tokens&) -> material { return lambertian{}; }},
    {"metal", [](tokens& in) -> material { return metal{in.expect_number("the fuzz of a metal", fraction)}; }},
    {"dielectric",
     [](tokens& in) -> material {
         return dielectric{in.expect_number("the refractive index of a dielectric", positive)};
     }},
    {"emissive",
     [](tokens& in) -> material { return emissive{rgb(in, "the radiance of an emissive material", not_negative)}; }},
};

/// The course's materials have no name: they are seven numbers.
material read_material(tokens& in) {
    if (!in.peek().empty() && std::isalpha(static_cast<unsigned char>(in.peek().front()))) {
        return choose(in, named_materials, "seven numbers or a material by name")(in);
    }
    phong finish{};
    finish.ambient = in.expect_number("ka of a material");
    finish.diffuse = in.expect_number("kd of a material");
    finish.specular = in.expect_number("ks of a material");
    finish.exponent = in.expect_number("alpha of a material", not_negative);
    finish.reflected = in.expect_number("kr of a material");
    finish.transmitted = in.expect_number("kt of a material");
    finish.refractive_index = in.expect_number("ior of a material", finish.transmitted == 0 ? any_number : positive);
    return finish;
}

/// One object of the file, which are several if it is a mesh.
std::vector<object> read_object(tokens& in, const scene& s, const meshes& known) {
    const std::size_t pigment = in.expect_index("pigment", s.pigments.size());
    const std::size_t material = in.expect_index("material", s.materials.size());
    std::vector<object> objects;
    for (shape& each : read_shapes(in, known)) objects.push_back({pigment, material, std::move(each)});
    return objects;
}

/// What may follow the objects; each sets one thing, and nothing is set twice.
struct statement {
    std::string_view sets;
    void (*read)(tokens&, scene&);
};

const by_name<statement> statements{
    {"background",
     {"the background",
      [](tokens& in, scene& s) {
          s.background.bottom = s.background.top = rgb(in, "the colour of the background", not_negative);
      }}},
    {"sky",
     {"the background",
      [](tokens& in, scene& s) {
          s.background.bottom = rgb(in, "the lower colour of the sky", not_negative);
          s.background.top = rgb(in, "the upper colour of the sky", not_negative);
      }}},
    {"fog",
     {"the fog",
      [](tokens& in, scene& s) {
          s.fog.value = rgb(in, "the colour of the fog", not_negative);
          s.fog.density = in.expect_number("the density of the fog", not_negative);
      }}},
    {"aperture",
     {"the aperture",
      [](tokens& in, scene& s) {
          s.camera.aperture = in.expect_number("the diameter of the aperture", not_negative);
          s.camera.focus_distance = in.expect_number("the distance of the focus", positive);
      }}},
};

/// Scenes of the course may list more objects than they count, and mean the count: the others are checked and left out.
void read_statements(tokens& in, scene& s, const meshes& known) {
    std::set<std::string_view> set;
    while (!in.peek().empty()) {
        if (std::isdigit(static_cast<unsigned char>(in.peek().front()))) {
            read_object(in, s, known);
            continue;
        }
        const statement& next = choose(in, statements, "the end of the file or a statement");
        if (!set.insert(next.sets).second) in.fail(joined({"a second statement that sets ", next.sets}), "one at most");
        next.read(in, s);
    }
}

}  // namespace

scene read_scene(const std::filesystem::path& file, const loaders& load) {
    return parse_scene(read_text(file, "a scene file"), file, load);
}

scene parse_scene(std::string_view text, const std::filesystem::path& file, const loaders& load) {
    tokens in(text, file.string());
    pictures known(file.parent_path(), load.texture);
    const meshes known_meshes{file.parent_path(), load.mesh};
    scene s;
    s.camera = read_camera(in);
    s.lights = section(in, "lights", [&] { return read_light(in); });
    s.pigments = section(in, "pigments", [&] { return choose(in, pigments, "a pigment")(in, known); });
    s.materials = section(in, "materials", [&] { return read_material(in); });
    for (auto& o : section(in, "objects", [&] { return read_object(in, s, known_meshes); })) {
        s.objects.insert(s.objects.end(), o.begin(), o.end());
    }
    read_statements(in, s, known_meshes);
    return s;
}

}  // namespace render
