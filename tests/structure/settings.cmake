# cmake -D COMPILER=<path> -D INCLUDES=<folders> -D FOLDER=<for what is written> -P settings.cmake
# Two files of a program whose settings differ in what changes layouts or answers do not link; others do.
cmake_minimum_required(VERSION 3.25)

list(TRANSFORM INCLUDES PREPEND "-I")
file(MAKE_DIRECTORY ${FOLDER})

# \param object  is made of settings.cpp, with these flags
function(compile object)
    execute_process(COMMAND ${COMPILER} -std=gnu++20 ${INCLUDES} ${ARGN} -c ${CMAKE_CURRENT_LIST_DIR}/settings.cpp
        -o ${FOLDER}/${object}.o COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# \param result  0 if the two link and agree, else what the linker says
function(link asking asked result)
    execute_process(COMMAND ${COMPILER} ${FOLDER}/${asking}.o ${FOLDER}/${asked}.o -o ${FOLDER}/program
        RESULT_VARIABLE failed ERROR_VARIABLE said OUTPUT_VARIABLE said)
    if(NOT failed)
        execute_process(COMMAND ${FOLDER}/program RESULT_VARIABLE said)
    endif()
    set(${result} "${said}" PARENT_SCOPE)
endfunction()

# \param expected  `together` or `apart`: may a file with these flags share shapes with one without?
function(check expected)
    compile(other ${ARGN})
    link(asking other said)
    if(expected STREQUAL "together" AND NOT said EQUAL 0)
        message(SEND_ERROR "with and without `${ARGN}` do not go together: ${said}")
    elseif(expected STREQUAL "apart" AND NOT said MATCHES "undefined")
        message(SEND_ERROR "with and without `${ARGN}` link: ${said}")
    endif()
endfunction()

execute_process(COMMAND ${COMPILER} -std=gnu++20 ${INCLUDES} -E -dM ${CMAKE_CURRENT_LIST_DIR}/settings.cpp
    OUTPUT_VARIABLE macros COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "define __SSE2__ 1" has_sse "${macros}")
string(REGEX MATCH "define RAIO_HAS_XSIMD 1" has_xsimd "${macros}")

compile(asking -DASKING)
check(together -DRAIO_FLATTEN= -O2)
check(together -DRAIO_WITHOUT_XSIMD)
check(apart -ffast-math -DRAIO_ALLOW_FAST_MATH)
check(apart -fno-exceptions)
if(has_sse)
    check(together -mavx)
    check(apart -DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES -DGLM_FORCE_INTRINSICS)
endif()

compile(asking -DASKING -DTREES)
check(together -DTREES -DRAIO_FLATTEN=)
if(has_xsimd)
    check(apart -DTREES -DRAIO_WITHOUT_XSIMD)
endif()
if(has_xsimd AND has_sse)
    check(apart -DTREES -mavx512f)
endif()
