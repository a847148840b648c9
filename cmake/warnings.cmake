# For our own targets only: who includes raio keeps his own warnings.
add_library(raio_warnings INTERFACE)
target_compile_options(raio_warnings INTERFACE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Werror>
    $<$<CXX_COMPILER_ID:GNU>:-Wuseless-cast>
    $<$<CXX_COMPILER_ID:MSVC>:/W4 /WX>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 takes the undefined lanes in its own AVX-512 intrinsics for a mistake (GCC bug 105593).
    target_compile_options(raio_warnings INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized)
endif()
