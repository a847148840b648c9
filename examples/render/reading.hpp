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

inline vec3 vector(tokens& in, std::string_view what, const requirement& must_be = any_number) {
    const auto [x, y, z] = numbers<3>(in, what, must_be);
    return {x, y, z};
}

inline vec3 direction(tokens& in, std::string_view what) {
    const vec3 v = vector(in, what);
    if (v == vec3(0)) in.fail("0 0 0", joined({"a direction for ", what}));
    return v;
}

}  // namespace render
