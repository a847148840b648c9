#include "reader.hpp"

#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include <glm/vector_relational.hpp>

namespace render {
namespace {

/// What can stand in one place of a file: the word, and how to read what follows it.
template <class Reading>
using by_name = std::map<std::string_view, Reading>;

template <class Reading>
const Reading& choose(tokens& in, const by_name<Reading>& known, std::string_view expected) {
    if (const auto entry = known.find(in.peek()); entry != known.end()) {
        in.expect_word(expected);
        return entry->second;
    }
    std::string names;
    for (const auto& [name, reading] : known) names += joined({names.empty() ? ": " : ", ", name});
    in.fail(joined({expected, names}));
}

template <class Reading>
auto section(tokens& in, std::string_view what, Reading read_one) {
    std::vector<decltype(read_one())> items;
    for (std::size_t left = in.expect_count(what); left > 0; --left) items.push_back(read_one());
    return items;
}

template <std::size_t N>
std::array<number, N> numbers(tokens& in, std::string_view what, const requirement& must_be = any_number) {
    std::array<number, N> values;
    for (number& value : values) value = in.expect_number(what, must_be);
    return values;
}

vec3 vector(tokens& in, std::string_view what, const requirement& must_be = any_number) {
    const auto [x, y, z] = numbers<3>(in, what, must_be);
    return {x, y, z};
}

vec3 direction(tokens& in, std::string_view what) {
    const vec3 v = vector(in, what);
    if (v == vec3(0)) in.fail("0 0 0", joined({"a direction for ", what}));
    return v;
}

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
    const color intensity = vector(in, "the colour of a light");
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
    {"solid", [](tokens& in, pictures&) -> pigment { return solid{vector(in, "the colour of a pigment")}; }},
    {"checker",
     [](tokens& in, pictures&) -> pigment {
         return checker{vector(in, "the first colour of a checker"), vector(in, "the second colour of a checker"),
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
     [](tokens& in) -> material { return emissive{vector(in, "the radiance of an emissive material", not_negative)}; }},
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

shape read_disc(tokens& in) {
    return raio::disc<number>{vector(in, "the centre of a disc"), direction(in, "the normal of a disc"),
                              in.expect_number("the radius of a disc", positive)};
}

template <class Cylinder>
shape read_cylinder(tokens& in) {
    const vec3 base = vector(in, "the base of a cylinder"), axis = direction(in, "the axis of a cylinder");
    const number radius = in.expect_number("the radius of a cylinder", positive);
    const number height = in.expect_number("the height of a cylinder", positive);
    const vec3 top = base + raio::normalize(axis) * height;
    if (top == base) in.fail("a height that is lost in the rounding of the base", "a higher cylinder");
    return Cylinder{base, top, radius};
}

shape read_triangle(tokens& in) {
    constexpr auto what = "the corners of a triangle";
    const raio::triangle<number> triangle{vector(in, what), vector(in, what), vector(in, what)};
    if (triangle.area() == 0) in.fail("a triangle without area", "corners that are not on one line");
    return triangle;
}

shape read_box(tokens& in) {
    const raio::box<number> box{vector(in, "the minimum of a box"), vector(in, "the maximum of a box")};
    if (!glm::all(glm::lessThanEqual(box.min, box.max))) {
        in.fail("a minimum above the maximum of a box", "the lesser coordinates first");
    }
    if (box.area() == 0) in.fail("a box without area", "sizes that are 0 along one axis at most");
    return box;
}

shape read_polyhedron(tokens& in) {
    raio::convex_polyhedron<number> polyhedron;
    polyhedron.planes = section(in, "planes of a polyhedron", [&] {
        return raio::half_space<number>{direction(in, "the normal of a polyhedron's plane"),
                                        in.expect_number("the offset of a polyhedron's plane")};
    });
    if (polyhedron.planes.empty()) in.fail("a polyhedron without planes", "at least one");
    return polyhedron;
}

const by_name<shape (*)(tokens&)> shapes{
    {"sphere",
     [](tokens& in) -> shape {
         return raio::sphere<number>{vector(in, "the centre of a sphere"),
                                     in.expect_number("the radius of a sphere", positive)};
     }},
    {"plane",
     [](tokens& in) -> shape {
         return raio::plane<number>{vector(in, "the point of a plane"), direction(in, "the normal of a plane")};
     }},
    {"circle", read_disc},
    {"disc", read_disc},
    {"triangle", read_triangle},
    {"box", read_box},
    {"cylinder", read_cylinder<raio::cylinder<number>>},
    {"open_cylinder", read_cylinder<raio::open_cylinder<number>>},
    {"polyhedron", read_polyhedron},
};

object read_object(tokens& in, const scene& s) {
    return {in.expect_index("pigment", s.pigments.size()), in.expect_index("material", s.materials.size()),
            choose(in, shapes, "a shape")(in)};
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
          s.background.bottom = s.background.top = vector(in, "the colour of the background", not_negative);
      }}},
    {"sky",
     {"the background",
      [](tokens& in, scene& s) {
          s.background.bottom = vector(in, "the lower colour of the sky", not_negative);
          s.background.top = vector(in, "the upper colour of the sky", not_negative);
      }}},
    {"fog",
     {"the fog",
      [](tokens& in, scene& s) {
          s.fog.value = vector(in, "the colour of the fog", not_negative);
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
void read_statements(tokens& in, scene& s) {
    std::set<std::string_view> set;
    while (!in.peek().empty()) {
        if (std::isdigit(static_cast<unsigned char>(in.peek().front()))) {
            read_object(in, s);
            continue;
        }
        const statement& next = choose(in, statements, "the end of the file or a statement");
        if (!set.insert(next.sets).second) in.fail(joined({"a second statement that sets ", next.sets}), "one at most");
        next.read(in, s);
    }
}

std::string read_file(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    const auto fail = [&](std::string_view found) {
        throw scene_error(joined({file.string(), ":1: found ", found, ", expected a scene file"}));
    };
    if (!std::filesystem::exists(status)) fail("no such file");
    if (std::filesystem::is_directory(status)) fail("a directory");
    if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status)) fail("a device");
    try {
        std::ifstream stream(file, std::ios::binary);
        if (!stream) fail("a file that may not be opened");
        return {std::istreambuf_iterator<char>(stream), {}};
    } catch (const std::ios_base::failure&) {
        fail("a file that cannot be read to its end");
    }
    return {};
}

}  // namespace

scene read_scene(const std::filesystem::path& file, const texture_loader& load) {
    return parse_scene(read_file(file), file, load);
}

scene parse_scene(std::string_view text, const std::filesystem::path& file, const texture_loader& load) {
    tokens in(text, file.string());
    pictures known(file.parent_path(), load);
    scene s;
    s.camera = read_camera(in);
    s.lights = section(in, "lights", [&] { return read_light(in); });
    s.pigments = section(in, "pigments", [&] { return choose(in, pigments, "a pigment")(in, known); });
    s.materials = section(in, "materials", [&] { return read_material(in); });
    s.objects = section(in, "objects", [&] { return read_object(in, s); });
    read_statements(in, s);
    return s;
}

}  // namespace render
