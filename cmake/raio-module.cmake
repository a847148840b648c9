# raio::module, which is what to link for `import raio;`. The project that asks for it compiles it once, with its own
# compiler and settings, since what a compiler makes of a module is of no use to another.
if(CMAKE_VERSION VERSION_LESS 3.28)
    message(FATAL_ERROR "raio::module needs CMake 3.28, the first that builds modules; this is ${CMAKE_VERSION}")
endif()
if(NOT TARGET raio-module)
    add_library(raio-module STATIC)
    add_library(raio::module ALIAS raio-module)
    target_sources(raio-module PUBLIC FILE_SET CXX_MODULES
        BASE_DIRS ${raio_include_dir} FILES ${raio_include_dir}/raio/raio.cppm)
    target_link_libraries(raio-module PUBLIC raio::raio)
endif()
