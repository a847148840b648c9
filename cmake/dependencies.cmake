# What raio is built from, and where it comes from when the system does not have it:
#
#   raio_source(PACKAGE DEBIAN_PACKAGE URL SHA256)
#
# glm is all that the library needs; the rest is for its tests, benchmarks and examples.

macro(raio_source package system_package url sha256)
    set(raio_${package}_system_package ${system_package})
    set(raio_${package}_url ${url})
    set(raio_${package}_sha256 ${sha256})
endmacro()

raio_source(glm libglm-dev
    https://github.com/g-truc/glm/archive/refs/tags/1.0.1.tar.gz
    9f3174561fd26904b23f0db5e560971cbf9b3cbda0b280f04d5c379d03bf234c)
raio_source(doctest doctest-dev
    https://github.com/doctest/doctest/archive/refs/tags/v2.4.11.tar.gz
    632ed2c05a7f53fa961381497bf8069093f0d6628c5f26286161fbd32a560186)
raio_source(benchmark libbenchmark-dev
    https://github.com/google/benchmark/archive/refs/tags/v1.8.3.tar.gz
    6bc180a57d23d4d9515519f92b0c83d61b05b5bab188961f36ac7b06b0d9e9ce)
raio_source(CLI11 libcli11-dev
    https://github.com/CLIUtils/CLI11/archive/refs/tags/v2.4.2.tar.gz
    f2d893a65c3b1324c50d4e682c0cdc021dd0477ae2c048544f39eed6654b699a)
raio_source(stb libstb-dev
    https://github.com/nothings/stb/archive/5736b15f7ea0ffb08dd38af21067c314d6a3aae9.tar.gz
    d00921d49b06af62aa6bfb97c1b136bec661dd11dd4eecbcb0da1f6da7cedb4c)
raio_source(tinyobjloader libtinyobjloader-dev
    https://github.com/tinyobjloader/tinyobjloader/archive/refs/tags/v2.0.0rc10.tar.gz
    e1bc2e5547b562d33ca4a90b581717984a70d58113d83208dbc97c82e137b9fe)
raio_source(Boost libboost-dev "" "")  # too large to fetch
raio_source(MPFR libmpfr-dev "" "")  # has a configure script of its own

# Finds the package on the system, or fetches it. Either way its headers are system headers, without warnings.
function(raio_dependency package)
    list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_FUNCTION_LIST_DIR})  # FindMPFR.cmake and others
    set(CMAKE_FIND_PACKAGE_PREFER_CONFIG ON)
    find_package(${package} QUIET GLOBAL)
    if(${package}_FOUND)
        return()
    endif()

    set(advice "${package} is not installed. On Debian and Ubuntu: apt-get install ${raio_${package}_system_package}")
    if(NOT raio_${package}_url)
        message(FATAL_ERROR "raio: ${advice}")
    endif()
    message(NOTICE "raio: ${advice}\nraio: fetching ${raio_${package}_url} instead")

    set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)  # these are options there
    set(GLM_BUILD_LIBRARY OFF)
    set(GLM_BUILD_TESTS OFF)
    set(DOCTEST_WITH_TESTS OFF)
    set(DOCTEST_NO_INSTALL ON)
    set(BENCHMARK_ENABLE_TESTING OFF)
    set(BENCHMARK_ENABLE_WERROR OFF)
    set(BENCHMARK_ENABLE_INSTALL OFF)
    set(CLI11_BUILD_TESTS OFF)
    set(CLI11_INSTALL OFF)

    set(own_find_module ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/Find${package}.cmake)
    if(EXISTS ${own_find_module})
        set(without_its_project SOURCE_SUBDIR none)
    endif()

    include(FetchContent)
    FetchContent_Declare(${package} SYSTEM ${without_its_project}
        URL ${raio_${package}_url}
        URL_HASH SHA256=${raio_${package}_sha256}
        DOWNLOAD_EXTRACT_TIMESTAMP OFF
        SOURCE_DIR ${FETCHCONTENT_BASE_DIR}/${package})
    FetchContent_MakeAvailable(${package})
    if(EXISTS ${own_find_module})
        find_package(${package} REQUIRED GLOBAL)
    endif()
endfunction()
