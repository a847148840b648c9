// `import raio;`: every shape, what is composed of them, trees and packs, from the same headers. Macros do not come
// with a module: who asks for the version includes <raio/config.hpp>.

module;

// What others have made is not attached to this module: whatever raio's headers include comes here first.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <numbers>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#if defined(__STDCPP_THREADS__) && !defined(RAIO_NO_THREADS)
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#endif
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

// Clang's intrinsics are static, which before version 20 is what no template may call that another file instantiates
// (https://github.com/llvm/llvm-project/issues/98021). Here they are inline and nothing else.
#if defined(__clang__) && __clang_major__ < 20
#define static
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif
#undef static
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <raio/abi.hpp>       // macros only
#undef RAIO_OPTIMISES_ITSELF  // by a pragma, which g++ has not in modules
#define RAIO_OPTIMISES_ITSELF 0

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#if RAIO_HAS_XSIMD
#include <xsimd/xsimd.hpp>
#endif

export module raio;

// Points and directions are GLM's vectors, and so the operators of these are raio's words as well.
export namespace glm {
using glm::operator+;
using glm::operator-;
using glm::operator*;
using glm::operator/;
using glm::operator%;
using glm::operator&;
using glm::operator|;
using glm::operator^;
using glm::operator<<;
using glm::operator>>;
using glm::operator~;
using glm::operator==;
using glm::operator!=;
using glm::operator&&;
using glm::operator||;
}  // namespace glm

#if RAIO_HAS_XSIMD
// What packs ask of their registers: compilers look for these where a pack's own functions are instantiated.
export namespace xsimd {
using xsimd::abs;
using xsimd::bitofsign;
using xsimd::copysign;
using xsimd::floor;
using xsimd::select;
using xsimd::sqrt;
}  // namespace xsimd
#endif

// Not attached to the module either: files that import raio and files that include it are of one program. (Clang 16
// exports nothing that is not attached: there they are two libraries that do not meet.)
#if defined(__clang__) && __clang_major__ < 17
export {
#else
export extern "C++" {
#endif
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wunknown-warning-option"
#pragma clang diagnostic ignored "-Winclude-angled-in-module-purview"
#endif
#include <raio/bvh/bvh.hpp>
#include <raio/number/simd.hpp>
#include <raio/raio.hpp>
#if defined(__clang__)
#pragma clang diagnostic pop
#endif
}

#if RAIO_HAS_XSIMD
namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS {
template struct trigonometry<register_of<float, 4>>;
template struct trigonometry<register_of<double, 2>>;
#if defined(__AVX__)
template struct trigonometry<register_of<float, 8>>;
template struct trigonometry<register_of<double, 4>>;
#endif
#if defined(__AVX512F__)
template struct trigonometry<register_of<float, 16>>;
template struct trigonometry<register_of<double, 8>>;
#endif
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ < 15
// g++ 14 forgets specialisations of others that nothing here names.
template <class S>
struct constants_of_xsimd {
    S sign = xsimd::constants::signmask<S>(), whole = xsimd::constants::maxflint<S>();
};
inline constants_of_xsimd<float> constants_of_floats() { return {}; }
inline constants_of_xsimd<double> constants_of_doubles() { return {}; }
#endif
}  // namespace raio::inline RAIO_ABI::detail::inline RAIO_REGISTERS
#endif
