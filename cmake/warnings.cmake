# For our own targets only: who includes raio keeps his own warnings.
add_library(raio_warnings INTERFACE)
target_compile_options(raio_warnings INTERFACE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra -Wconversion -Wshadow -Werror>
    $<$<CXX_COMPILER_ID:MSVC>:/W4 /WX>)
