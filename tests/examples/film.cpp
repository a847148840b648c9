#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <render/film.hpp>
#include <render/texture.hpp>

using namespace render;

namespace {

/// An empty folder that vanishes.
class folder {
public:
    folder() : path_(std::filesystem::temp_directory_path() / ("raio-film-" + std::to_string(std::random_device{}()))) {
        std::filesystem::create_directory(path_);
    }
    folder(const folder&) = delete;
    folder& operator=(const folder&) = delete;
    ~folder() { std::filesystem::remove_all(path_); }

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            result.push_back(entry.path().filename().string());
        std::ranges::sort(result);
        return result;
    }

private:
    std::filesystem::path path_;
};

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

film small_picture() {
    film picture(3, 2);
    picture.at(0, 0) = {0, 0.5, 1};
    picture.at(1, 0) = {-1, 2, 1e300};
    picture.at(2, 0) = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 0.999999};
    picture.at(0, 1) = {1 / 255.0, 0.9 / 255, 254.9 / 255};
    return picture;
}

const std::string small_bytes{
    "\x00\x7f\xff"
    "\x00\xff\xff"
    "\x00\xff\xfe"
    "\x01\x00\xfe"
    "\x00\x00\x00"
    "\x00\x00\x00",
    18};

std::string failure(const auto& act) {
    try {
        act();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a PPM holds min(int(255 c), 255) for every channel, from the top left") {
    const folder folder;
    write_image(small_picture(), folder / "picture.ppm");
    CHECK(content(folder / "picture.ppm") == "P6\n3 2\n255\n" + small_bytes);
}

TEST_CASE("every level of a texture is written as it was read: 185 / 255 * 255 is below 185") {
    for (int i = 0; i < 256; ++i) {
        const auto texel = static_cast<std::uint8_t>(i);
        CHECK(level(texture{1, 1, {texel, texel, texel}}.at(0, 0, coding::encoded).x) == i);
    }
}

TEST_CASE("a PNG is read back with the same pixels") {
    const folder folder;
    write_image(small_picture(), folder / "picture.png");
    const texture read = read_texture(folder / "picture.png");
    CHECK(read.width == 3);
    CHECK(read.height == 2);
    CHECK(std::string(read.texels.begin(), read.texels.end()) == small_bytes);
}

TEST_CASE("a folder is no texture, and neither is a device without end") {
    const folder folder;
    CHECK_THROWS_WITH(read_texture(folder / "."), "is not a file");
    if (std::filesystem::exists("/dev/zero")) CHECK_THROWS_WITH(read_texture("/dev/zero"), "is not a file");
}

TEST_CASE("nothing but the picture is left, and a picture that was there is replaced") {
    const folder folder;
    for (int i = 0; i < 2; ++i) {
        expect_writable(folder / "picture.png");
        write_image(film(2, 2), folder / "picture.png");
        CHECK(folder.names() == std::vector<std::string>{"picture.png"});
    }
}

TEST_CASE("to ask whether a picture can be written changes nothing") {
    const folder folder;
    expect_writable(folder / "new.png");
    CHECK(folder.names().empty());
    std::ofstream(folder / "old.png") << "old";
    expect_writable(folder / "old.png");
    CHECK(content(folder / "old.png") == "old");
    CHECK(folder.names() == std::vector<std::string>{"old.png"});
}

TEST_CASE("a path that cannot be written is refused before and after rendering, by its name, and leaves nothing") {
    const folder folder;
    std::filesystem::create_directory(folder / "folder.png");
    for (const std::string name : {"missing/picture.png", "picture.jpg", "picture", "folder.png"}) {
        CAPTURE(name);
        const std::string path = (folder / name).string();
        CHECK(failure([&] { expect_writable(path); }).starts_with(path + ": "));
        CHECK(failure([&] { write_image(film(1, 1), path); }).starts_with(path + ": "));
        CHECK(folder.names() == std::vector<std::string>{"folder.png"});
    }
}

TEST_CASE("a symbolic link is followed, be there a file or not") {
    const folder folder;
    std::filesystem::create_directory(folder / "elsewhere");
    std::filesystem::create_symlink("elsewhere/target.ppm", folder / "link.ppm");
    std::filesystem::create_symlink(folder / "link.ppm", folder / "second.ppm");
    for (int i = 0; i < 2; ++i) {
        expect_writable(folder / "second.ppm");
        write_image(small_picture(), folder / "second.ppm");
        CHECK(std::filesystem::is_symlink(folder / "link.ppm"));
        CHECK(std::filesystem::is_symlink(folder / "second.ppm"));
        CHECK(content(folder / "elsewhere/target.ppm") == "P6\n3 2\n255\n" + small_bytes);
    }
    std::filesystem::create_symlink("loop.ppm", folder / "loop.ppm");
    CHECK(failure([&] { write_image(film(1, 1), folder / "loop.ppm"); }) != "");
    CHECK(folder.names() == std::vector<std::string>{"elsewhere", "link.ppm", "loop.ppm", "second.ppm"});
}

TEST_CASE("a name may end in capitals") {
    const folder folder;
    write_image(small_picture(), folder / "picture.PNG");
    write_image(small_picture(), folder / "picture.Ppm");
    CHECK(read_texture(folder / "picture.PNG").width == 3);
    CHECK(content(folder / "picture.Ppm") == "P6\n3 2\n255\n" + small_bytes);
}

TEST_CASE("a picture overwrites none of the files that it is made of, whatever their name there") {
    const folder folder;
    std::ofstream(folder / "scene.ppm") << "scene";
    std::filesystem::create_symlink("scene.ppm", folder / "link.ppm");
    const std::vector<std::filesystem::path> used{folder / "none.png", folder / "scene.ppm"};
    for (const std::string name : {"scene.ppm", "link.ppm", "./scene.ppm"}) {
        CHECK(failure([&] { expect_other_file(folder / name, used); }) ==
              (folder / name).string() +
                  ": is a file that the scene is made of, expected another name for the picture");
    }
    expect_other_file(folder / "other.ppm", used);
    expect_other_file(folder / "none.png", used);
}

TEST_CASE("a texture shows its nearest texel and is repeated") {
    const texture t{2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};
    for (const coding as : {coding::encoded, coding::linear}) {
        CHECK(t.at(0.25, 0.25, as) == color(1, 0, 0));
        CHECK(t.at(0.75, 0.25, as) == color(0, 1, 0));
        CHECK(t.at(0.25, 0.75, as) == color(0, 0, 1));
        CHECK(t.at(-0.25, 7.75, as) == color(1, 1, 1));
        CHECK(t.at(-1e-20, 0, as) == color(0, 1, 0));  // s - floor(s) rounds to 1
        const double infinity = std::numeric_limits<double>::infinity();
        CHECK(t.at(std::numeric_limits<double>::quiet_NaN(), infinity, as) == color(1, 0, 0));
    }
}

TEST_CASE("what is no picture is refused with a reason") {
    const folder folder;
    std::ofstream(folder / "words.png") << "words";
    std::ofstream(folder / "empty.png");
    for (const std::string name : {"words.png", "empty.png", "missing.png", "."}) {
        CHECK(failure([&] { read_texture(folder / name); }) != "");
    }
}
