# tinyobjloader's own CMake project makes a library of floats or one of doubles, and installs it. From the sources that
# were fetched: both of them, named as Debian names them, and nothing to install.
find_path(tinyobjloader_INCLUDE_DIR tiny_obj_loader.cc HINTS ${tinyobjloader_SOURCE_DIR} NO_DEFAULT_PATH)
mark_as_advanced(tinyobjloader_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(tinyobjloader REQUIRED_VARS tinyobjloader_INCLUDE_DIR)

if(tinyobjloader_FOUND AND NOT TARGET tinyobjloader::tinyobjloader)
    foreach(library IN ITEMS tinyobjloader tinyobjloader_double)
        add_library(${library} STATIC EXCLUDE_FROM_ALL ${tinyobjloader_INCLUDE_DIR}/tiny_obj_loader.cc)
        add_library(tinyobjloader::${library} ALIAS ${library})
        target_include_directories(${library} SYSTEM INTERFACE ${tinyobjloader_INCLUDE_DIR})
    endforeach()
    target_compile_definitions(tinyobjloader_double PUBLIC TINYOBJLOADER_USE_DOUBLE)
endif()
