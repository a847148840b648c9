#include "ply.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "polygon.hpp"
#include "reading.hpp"

namespace render {
namespace {

/// A number as the file stores it.
struct scalar {
    std::size_t bytes;
    double (*decode)(const char* from);  ///< bytes in this machine's order
};

template <class Number>
double decoded(const char* from) {
    Number value;
    std::memcpy(&value, from, sizeof(Number));
    return static_cast<double>(value);
}
template <class Number>
constexpr scalar scalar_of{sizeof(Number), decoded<Number>};

const by_name<scalar> scalars{
    {"char", scalar_of<std::int8_t>},     {"int8", scalar_of<std::int8_t>},     {"uchar", scalar_of<std::uint8_t>},
    {"uint8", scalar_of<std::uint8_t>},   {"short", scalar_of<std::int16_t>},   {"int16", scalar_of<std::int16_t>},
    {"ushort", scalar_of<std::uint16_t>}, {"uint16", scalar_of<std::uint16_t>}, {"int", scalar_of<std::int32_t>},
    {"int32", scalar_of<std::int32_t>},   {"uint", scalar_of<std::uint32_t>},   {"uint32", scalar_of<std::uint32_t>},
    {"float", scalar_of<float>},          {"float32", scalar_of<float>},        {"double", scalar_of<double>},
    {"float64", scalar_of<double>},
};

struct property {
    std::string name;
    scalar type;
    std::optional<scalar> count;  ///< of a list: what says how long it is
};

struct element {
    std::string name;
    std::size_t line, count;
    std::vector<property> properties;
};

enum class encoding { ascii, little_endian, big_endian };
const by_name<encoding> encodings{{"ascii", encoding::ascii},
                                  {"binary_little_endian", encoding::little_endian},
                                  {"binary_big_endian", encoding::big_endian}};

class ply_file {
public:
    ply_file(std::string_view text, const std::string& file)
        : rest_(text),
          line_end_(text.starts_with("ply\r") && !text.starts_with("ply\r\n") ? '\r' : '\n'),
          file_(file) {}

    std::vector<raio::triangle<double>> triangles() {
        read_header();
        if (encoding_ == encoding::ascii) words_.emplace(rest_, file_, line_ + 1);
        for (const element& e : elements_) {
            if (e.name == "vertex") {
                read_vertices(e);
            } else if (e.name == "face") {
                read_faces(e);
            } else if (e.name == "tristrips") {
                read_strips(e);
            } else {
                read_items(e, [](const auto&, std::size_t) {});
            }
        }
        if (triangles_.empty()) header_line("").fail("no face", "a PLY file with faces");
        return std::move(triangles_);
    }

private:
    /// One line of the header as words; `line_` counts it.
    tokens header_line(std::string_view text) const { return {text, file_, std::max<std::size_t>(line_, 1)}; }
    std::string_view next_line() {
        if (rest_.empty()) header_line("").fail("the end of the file", "end_header");
        ++line_;
        const std::string_view line = rest_.substr(0, rest_.find(line_end_));
        rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
        return line;
    }

    void read_header() {
        next_line();  // which says ply
        bool has_format = false;
        for (;;) {
            const std::string_view line = next_line();
            tokens in = header_line(line);
            const std::string_view word = in.peek();
            if (word == "comment" || word == "obj_info" || word.empty()) continue;
            in.expect_word("a statement of the header");
            if (word == "end_header") break;
            if (word == "format") {
                encoding_ = choose(in, encodings, "a format");
                has_format = true;
            } else if (word == "element") {
                read_element(in);
            } else if (word == "property") {
                read_property(in);
            } else {
                in.fail(joined({"'", printable(word, 40), "'"}), "a comment, element, end_header, format or property");
            }
        }
        if (!has_format) header_line("").fail("no format", "a line that says which, before end_header");
    }

    void read_element(tokens& in) {
        element e;
        e.name = in.expect_word("the name of an element");
        e.line = line_;
        const double count = in.expect_number("the count of an element", not_negative);
        // Every item takes a byte at least.
        if (count != std::floor(count) || count > static_cast<double>(rest_.size())) {
            in.fail("a count of " + printable(e.name, 40) + " that the file has no room for",
                    "at most " + std::to_string(rest_.size()));
        }
        e.count = static_cast<std::size_t>(count);
        elements_.push_back(std::move(e));
    }

    void read_property(tokens& in) {
        if (elements_.empty()) in.fail("a property of nothing", "an element before it");
        property p;
        if (in.peek() == "list") {
            in.expect_word("a list");
            p.count = choose(in, scalars, "a type");
        }
        p.type = choose(in, scalars, "a type");
        p.name = in.expect_word("the name of a property");
        elements_.back().properties.push_back(std::move(p));
    }

    /// The next number of the data, the item and its element for errors.
    double number(const scalar& type, const element& e, std::size_t item) {
        if (words_) return words_->expect_number(joined({"a property of the ", e.name, " ", std::to_string(item)}));
        if (rest_.size() < type.bytes) fail(e, item, "the end of the file", "more of it");
        std::array<char, sizeof(double)> bytes;
        const auto end = std::copy_n(rest_.begin(), type.bytes, bytes.begin());
        rest_.remove_prefix(type.bytes);
        if ((encoding_ == encoding::big_endian) != (std::endian::native == std::endian::big)) {
            std::reverse(bytes.begin(), end);
        }
        return type.decode(bytes.data());
    }

    [[noreturn]] void fail(const element& e, std::size_t item, std::string_view found,
                           std::string_view expected) const {
        const std::string where = joined({" in the ", printable(e.name, 40), " ", std::to_string(item)});
        if (words_) words_->fail(joined({found, where}), expected);
        tokens("", file_, e.line).fail(joined({found, where}), expected);
    }

    /// Reads every item of an element, and hands `use` the numbers of each of its properties.
    template <class Use>
    void read_items(const element& e, Use use) {
        std::vector<std::vector<double>> values(e.properties.size());
        if (e.properties.empty() && e.count > 0)
            tokens("", file_, e.line).fail("an element without properties", "some");
        for (std::size_t item = 0; item < e.count; ++item) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                const property& p = e.properties[i];
                std::size_t length = 1;
                if (p.count) {
                    const double said = number(*p.count, e, item);
                    if (!(said >= 0 && said == std::floor(said) && said <= static_cast<double>(rest_.size()))) {
                        fail(e, item, "a list that the file has no room for", "a count of what follows");
                    }
                    length = static_cast<std::size_t>(said);
                }
                values[i].clear();
                for (; length > 0; --length) values[i].push_back(number(p.type, e, item));
            }
            use(values, item);
        }
    }

    /// Where an element has the property; fails where it has not.
    static std::size_t place_of(const element& e, std::initializer_list<std::string_view> names, const tokens& in) {
        for (std::size_t i = 0; i < e.properties.size(); ++i) {
            if (std::ranges::find(names, e.properties[i].name) != names.end()) return i;
        }
        in.fail(joined({"a ", e.name, " without the property ", *names.begin()}), "that one");
    }

    void read_vertices(const element& e) {
        const tokens at("", file_, e.line);
        const std::array<std::size_t, 3> places{place_of(e, {"x"}, at), place_of(e, {"y"}, at), place_of(e, {"z"}, at)};
        for (const std::size_t i : places) {
            if (e.properties[i].count) at.fail("a list of coordinates", "one number for each");
        }
        read_items(e, [&](const auto& values, std::size_t item) {
            std::array<double, 3> at_axis;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double x = at_axis[axis] = values[places[axis]].front();
                if (!(x == 0 || (std::abs(x) >= 1e-50 && std::abs(x) <= 1e50))) {
                    fail(e, item, "a coordinate out of range", "0 or a magnitude from 1e-50 to 1e50");
                }
            }
            vertices_.push_back({at_axis[0], at_axis[1], at_axis[2]});
        });
    }

    void read_faces(const element& e) {
        const std::size_t place = place_of_corners(e);
        std::vector<raio::vec3<double>> corners;
        read_items(e, [&](const auto& values, std::size_t item) {
            corners.clear();
            for (const double index : values[place]) corners.push_back(vertex(index, e, item));
            if (corners.size() < 3) fail(e, item, "fewer than three corners", "three or more");
            append_triangles(corners, triangles_);
        });
    }

    /// Each corner makes a triangle with the two before it, every second one the other way round. -1 ends a strip; what
    /// is without area only leads from one place to another.
    void read_strips(const element& e) {
        const std::size_t place = place_of_corners(e);
        read_items(e, [&](const auto& values, std::size_t item) {
            std::size_t length = 0;  // of the strip so far
            double before = -1, last = -1;
            for (const double index : values[place]) {
                if (index == -1) {
                    length = 0;
                    continue;
                }
                const auto& corner = vertex(index, e, item);
                if (++length > 2 && before != last && last != index && index != before) {
                    const bool turned = length % 2 == 0;
                    triangles_.push_back(
                        {vertex(turned ? last : before, e, item), vertex(turned ? before : last, e, item), corner});
                }
                before = std::exchange(last, index);
            }
        });
    }

    std::size_t place_of_corners(const element& e) const {
        return place_of(e, {"vertex_indices", "vertex_index"}, tokens("", file_, e.line));
    }

    const raio::vec3<double>& vertex(double index, const element& e, std::size_t item) const {
        const auto count = static_cast<double>(vertices_.size());
        if (!(index >= 0 && index < count && index == std::floor(index))) {
            fail(
                e, item, "a corner that is no vertex",
                joined({"the number of one of the ", std::to_string(vertices_.size()), " vertices before it, from 0"}));
        }
        return vertices_[static_cast<std::size_t>(index)];
    }

    std::string_view rest_;
    char line_end_;  ///< of the header; what follows the last one is data, whatever it begins with
    const std::string& file_;
    std::size_t line_ = 0;
    encoding encoding_ = encoding::ascii;
    std::vector<element> elements_;
    std::optional<tokens> words_;  ///< the data, if they are text
    std::vector<raio::vec3<double>> vertices_;
    std::vector<raio::triangle<double>> triangles_;
};

}  // namespace

bool is_ply(std::string_view text) { return text.starts_with("ply\n") || text.starts_with("ply\r"); }

std::vector<raio::triangle<double>> parse_ply(std::string_view text, const std::string& file) {
    return ply_file(text, file).triangles();
}

}  // namespace render
