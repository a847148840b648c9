#include "mesh.hpp"

#include <algorithm>
#include <istream>
#include <span>
#include <streambuf>
#include <utility>

#include <tiny_obj_loader.h>

#include "ply.hpp"
#include "tokens.hpp"

namespace render {
namespace {

/// Hands a text out line by line, and so knows at which line its reader is.
class lines : public std::streambuf {
public:
    explicit lines(std::string_view text) : rest_(text) {}

    std::string_view current() const { return current_; }
    std::size_t number() const { return number_; }  ///< of the current line, from 1

private:
    int_type underflow() override {
        if (rest_.empty()) return traits_type::eof();
        current_ = rest_.substr(0, rest_.find('\n') + 1);
        if (current_.empty()) current_ = rest_;  // the last line has no end
        rest_.remove_prefix(current_.size());
        ++number_;
        char* begin = const_cast<char*>(current_.data());  // which is only read
        setg(begin, begin, begin + current_.size());
        return traits_type::to_int_type(*begin);
    }

    std::string_view rest_, current_;
    std::size_t number_ = 0;
};

/// What the loader calls back with, line by line.
class mesh_builder {
public:
    mesh_builder(std::string_view text, std::string file) : lines_(text), file_(std::move(file)) {}

    std::vector<raio::triangle<double>> build() {
        tinyobj::callback_t calls;
        calls.vertex_cb = [](void* self, double, double, double, double) {
            static_cast<mesh_builder*>(self)->add_vertex();
        };
        calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            static_cast<mesh_builder*>(self)->add_face({corners, static_cast<std::size_t>(count)});
        };
        std::istream in(&lines_);
        tinyobj::LoadObjWithCallback(in, calls, this);
        if (triangles_.empty()) line().fail("no face", "a Wavefront OBJ or PLY file with faces");
        return std::move(triangles_);
    }

private:
    tokens line() const { return {lines_.current(), file_, std::max<std::size_t>(lines_.number(), 1)}; }

    /// The loader takes what is no number for 0: the line is read again.
    void add_vertex() {
        tokens in = line();
        in.expect_word("a vertex");
        raio::vec3<double> vertex;
        for (double* coordinate : {&vertex.x, &vertex.y, &vertex.z}) {
            if (in.peek().empty()) in.fail("the end of the line", "three coordinates of a vertex");
            *coordinate = in.expect_number("a coordinate of a vertex");
        }
        vertices_.push_back(vertex);
    }

    void add_face(std::span<const tinyobj::index_t> corners) {
        if (corners.size() < 3) line().fail("a face with fewer than three corners", "three or more");
        const auto& first = vertex(corners[0]);
        for (std::size_t i = 2; i < corners.size(); ++i) {
            triangles_.push_back({first, vertex(corners[i - 1]), vertex(corners[i])});
        }
    }

    /// Vertices are counted from 1, or backwards from -1, the latest.
    const raio::vec3<double>& vertex(const tinyobj::index_t& corner) const {
        const auto index = static_cast<std::ptrdiff_t>(corner.vertex_index);
        const auto count = static_cast<std::ptrdiff_t>(vertices_.size());
        const std::ptrdiff_t at = index < 0 ? count + index : index - 1;
        if (at < 0 || at >= count) {
            line().fail(joined({"a face with the corner ", std::to_string(index)}),
                        joined({"the number of one of the ", std::to_string(count), " vertices above"}));
        }
        return vertices_[static_cast<std::size_t>(at)];
    }

    lines lines_;
    std::string file_;
    std::vector<raio::vec3<double>> vertices_;
    std::vector<raio::triangle<double>> triangles_;
};

}  // namespace

std::vector<raio::triangle<double>> read_mesh(const std::filesystem::path& file) {
    return parse_mesh(read_text(file, "a Wavefront OBJ or PLY file"), file.string());
}

std::vector<raio::triangle<double>> parse_mesh(std::string_view text, const std::string& file) {
    return is_ply(text) ? parse_ply(text, file) : mesh_builder(text, file).build();
}

}  // namespace render
