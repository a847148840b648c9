#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace raio::test {

/// What an input begins with that is about the shape of this name, if there is one.
std::optional<std::uint8_t> first_byte_for(std::string_view name);

}  // namespace raio::test
