#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "scene.hpp"
#include "tokens.hpp"

/// \file
/// What all sections of a scene are read with.

namespace render {

/// What can stand in one place of a file: the word, and how to read what follows it.
template <class Reading>
using by_name = std::map<std::string_view, Reading>;

template <class Reading>
std::string names_of(const by_name<Reading>& known) {
    std::string names;
    for (const auto& [name, reading] : known) names += joined({names.empty() ? "" : ", ", name});
    return names;
}

/// \param otherwise  what else could stand there, for the error
template <class Reading>
const Reading& choose(tokens& in, const by_name<Reading>& known, std::string_view expected,
                      std::string_view otherwise = "") {
    if (const auto entry = known.find(in.peek()); entry != known.end()) {
        in.expect_word(expected);
        return entry->second;
    }
    in.fail(joined({expected, ": ", names_of(known), otherwise}));
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

inline vec3 vector(tokens& in, std::string_view what, const requirement& must_be = any_number) {
    const auto [x, y, z] = numbers<3>(in, what, must_be);
    return {x, y, z};
}

/// Is this #rgb or #rrggbb, with or without a hexadecimal alpha?
inline bool is_web_color(std::string_view word) {
    constexpr std::string_view digits = "0123456789abcdefABCDEF";
    const bool is_that_long = word.size() == 4 || word.size() == 5 || word.size() == 7 || word.size() == 9;
    return is_that_long && word.front() == '#' && word.find_first_not_of(digits, 1) == word.npos;
}

/// Three numbers. `#ff0000` in their place would begin a comment, and the next ones that come be taken for the colour.
inline color rgb(tokens& in, std::string_view what, const requirement& must_be = any_number) {
    color c;
    for (double* channel : {&c.x, &c.y, &c.z}) {
        if (is_web_color(in.comment())) {
            in.fail(joined({"'", in.comment(), "', which begins a comment"}), joined({must_be.words, " for ", what}));
        }
        *channel = in.expect_number(what, must_be);
    }
    return c;
}

inline vec3 direction(tokens& in, std::string_view what) {
    const vec3 v = vector(in, what);
    if (v == vec3(0)) in.fail("0 0 0", joined({"a direction for ", what}));
    return v;
}

}  // namespace render
