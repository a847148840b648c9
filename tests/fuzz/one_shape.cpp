#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include "shapes.hpp"

/// With --shape=NAME all inputs that libFuzzer invents are about that shape. (It passes over what begins with two
/// dashes. That the byte is written into the input lets whatever is found be replayed without a name.)

namespace {
std::optional<std::uint8_t> chosen;
}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    constexpr std::string_view option = "--shape=";
    for (int i = 1; i < *argc; ++i) {
        const std::string_view argument = (*argv)[i];
        if (!argument.starts_with(option)) continue;
        chosen = raio::test::first_byte_for(argument.substr(option.size()));
        if (!chosen) {
            std::fprintf(stderr, "%s: there is no such shape\n", (*argv)[i]);
            std::exit(2);
        }
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned) {
    const std::size_t length = LLVMFuzzerMutate(data, size, most);
    if (chosen && length > 0) data[0] = *chosen;
    return length;
}
