#include <cstdio>
#include <cstdlib>
#include <string_view>

// Runs a program that was compiled for an instruction set, unless the processor has not got it:
//
//     raio-tests-packs-run <instruction set> <program>

namespace {

bool processor_has(std::string_view set) {
#if defined(__x86_64__)
    if (set == "avx2") return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (set == "avx512") return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
#endif
    return set == "native" || set == "one-lane";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 1;
    if (!processor_has(argv[1])) {
        std::printf("skipped: this processor has no %s\n", argv[1]);
        return 77;
    }
    return std::system(argv[2]) == 0 ? 0 : 1;
}
