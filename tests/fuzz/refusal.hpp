#pragma once

#include <cstdlib>
#include <string_view>

#include <render/tokens.hpp>

/// A reader may refuse its input, in one line of a sensible length that names the file and says what was expected.
template <class Read>
void check_read_or_refused(std::string_view file, Read read) {
    const auto check = [](bool holds) {
        if (!holds) std::abort();
    };
    try {
        read();
    } catch (const render::scene_error& error) {
        const std::string_view message = error.what();
        check(message.starts_with(file) && message.substr(file.size()).starts_with(':'));
        check(message.find(", expected ") != message.npos);
        check(message.find('\n') == message.npos && message.size() < 1000);
    }
}
