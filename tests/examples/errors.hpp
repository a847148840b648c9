#pragma once

#include <string>

#include <render/tokens.hpp>

namespace render {

/// What reading says is wrong.
template <class Read>
std::string error_of(Read read) {
    try {
        read();
    } catch (const scene_error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace render
