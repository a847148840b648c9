#include "mesh.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <istream>
#include <set>
#include <span>
#include <streambuf>
#include <utility>

#include <tiny_obj_loader.h>

#include "ply.hpp"
#include "polygon.hpp"
#include "tokens.hpp"

namespace render {
namespace {

/// Statements that no surface is made of, besides vertices. Those of free-form surfaces are not among them: what they
/// describe would be missing.
const std::set<std::string_view> passed_over{
    "vn",     "vt",    "vp",         "p",         "l",   "g",   "o",    "s",    "mg",   "mtllib", "usemtl", "maplib",
    "usemap", "bevel", "c_interp",   "d_interp",  "lod", "deg", "bmat", "step", "curv", "curv2",  "cstype", "parm",
    "end",    "ctech", "shadow_obj", "trace_obj", "con", "sp",  "hole", "trim", "scrv", "stech"};

/// Hands a text out statement by statement, each as a line of its own, without its comment.
class statements : public std::streambuf {
public:
    /// `begun` is called when there is another one.
    statements(std::string_view text, std::function<void()> begun) : rest_(text), begun_(std::move(begun)) {}

    std::string_view current() const { return current_; }
    std::size_t line() const { return line_; }  ///< on which the current one begins, from 1

private:
    /// A backslash at the end of a line says that the next line goes on.
    int_type underflow() override {
        if (rest_.empty()) return traits_type::eof();
        current_.clear();
        line_ = next_line_;
        for (bool goes_on = true; goes_on;) {
            std::string_view part = without_comment(take_line(rest_));
            ++next_line_;
            goes_on = part.ends_with('\\') && !rest_.empty();
            if (goes_on) part.remove_suffix(1);
            current_.append(part).append(goes_on ? " " : "\n");
        }
        std::ranges::replace_if(
            current_, [](char c) { return c == '\v' || c == '\f'; }, ' ');  // no space to the loader
        begun_();
        setg(current_.data(), current_.data(), current_.data() + current_.size());
        return traits_type::to_int_type(current_.front());
    }

    static std::string_view without_comment(std::string_view line) {
        for (std::size_t i = 0; (i = line.find('#', i)) != line.npos; ++i) {
            if (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t') return line.substr(0, i);
        }
        return line;
    }

    std::string_view rest_;
    std::function<void()> begun_;
    std::string current_;
    std::size_t line_ = 0, next_line_ = 1;
};

/// What the loader calls back with, statement by statement.
class mesh_builder {
public:
    mesh_builder(std::string_view text, std::string file)
        : statements_(text, [this] { check_statement(); }), file_(std::move(file)) {}

    std::vector<raio::triangle<double>> build() {
        tinyobj::callback_t calls;
        calls.vertex_cb = [](void* self, double, double, double, double) {
            static_cast<mesh_builder*>(self)->add_vertex();
        };
        calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            static_cast<mesh_builder*>(self)->add_face({corners, static_cast<std::size_t>(count)});
        };
        std::istream in(&statements_);
        in.exceptions(std::ios::badbit);  // passes on what `check_statement` throws
        tinyobj::LoadObjWithCallback(in, calls, this);
        if (triangles_.empty()) statement().fail("no face", "a Wavefront OBJ or PLY file with faces");
        return std::move(triangles_);
    }

private:
    tokens statement() const { return {statements_.current(), file_, std::max<std::size_t>(statements_.line(), 1)}; }

    /// The loader passes over what it does not know, and takes of a corner what it can: both are refused before.
    void check_statement() const {
        tokens in = statement();
        const std::string_view name = in.peek();
        if (name.empty() || passed_over.contains(name)) return;
        if (name != "v" && name != "f") in.fail("a statement of a polygonal Wavefront OBJ file, such as v or f");
        in.expect_word("a statement");
        if (name == "v") {
            if (in.peek().empty()) in.fail("the end of the line", "three coordinates of a vertex");
            return;
        }
        if (in.peek().empty()) in.fail("a face without corners", "three or more");
        for (; !in.peek().empty(); in.expect_word("a corner")) {
            if (!is_corner(in.peek())) in.fail("a corner of a face: the number of a vertex, alone or before slashes");
        }
    }

    /// One of 1, 1/2, 1//3 and 1/2/3.
    static bool is_corner(std::string_view word) {
        for (int slashes = 0;; ++slashes) {
            int index = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
            if (error == std::errc{}) word.remove_prefix(static_cast<std::size_t>(end - word.data()));
            const bool may_lack = slashes == 1 && word.starts_with('/');
            if (error != std::errc{} && !may_lack) return false;
            if (word.empty()) return true;
            if (slashes == 2 || !word.starts_with('/')) return false;
            word.remove_prefix(1);
        }
    }

    /// The loader takes what is no number for 0: the statement is read again. A weight or a colour may follow.
    void add_vertex() {
        tokens in = statement();
        in.expect_word("a vertex");
        raio::vec3<double> vertex;
        for (double* coordinate : {&vertex.x, &vertex.y, &vertex.z}) {
            if (in.peek().empty()) in.fail("the end of the line", "three coordinates of a vertex");
            *coordinate = in.expect_number("a coordinate of a vertex");
        }
        while (!in.peek().empty()) in.expect_number("what follows the coordinates of a vertex");
        vertices_.push_back(vertex);
    }

    void add_face(std::span<const tinyobj::index_t> corners) {
        if (corners.size() < 3) statement().fail("a face with fewer than three corners", "three or more");
        face_.clear();
        for (const tinyobj::index_t& corner : corners) face_.push_back(vertex(corner));
        append_triangles(face_, triangles_);
    }

    /// Vertices are counted from 1, or backwards from -1, the latest.
    const raio::vec3<double>& vertex(const tinyobj::index_t& corner) const {
        const auto index = static_cast<std::ptrdiff_t>(corner.vertex_index);
        const auto count = static_cast<std::ptrdiff_t>(vertices_.size());
        const std::ptrdiff_t at = index < 0 ? count + index : index - 1;
        if (at < 0 || at >= count) {
            statement().fail(joined({"a face with the corner ", std::to_string(index)}),
                             joined({"the number of one of the ", std::to_string(count), " vertices above"}));
        }
        return vertices_[static_cast<std::size_t>(at)];
    }

    statements statements_;
    std::string file_;
    std::vector<raio::vec3<double>> vertices_, face_;
    std::vector<raio::triangle<double>> triangles_;
};

}  // namespace

std::vector<raio::triangle<double>> read_mesh(const std::filesystem::path& file) {
    return parse_mesh(read_text(file, "a Wavefront OBJ or PLY file"), file.string());
}

std::vector<raio::triangle<double>> parse_mesh(std::string_view text, const std::string& file) {
    skip_byte_order_mark(text);
    return is_ply(text) ? parse_ply(text, file) : mesh_builder(text, file).build();
}

}  // namespace render
