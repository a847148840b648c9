# cmake -D ROOT=<checkout> -P headers.cmake
# Who includes whom, and what else every header keeps to.
cmake_minimum_required(VERSION 3.25)

# The floors of the library, lowest first. A header includes headers of lower floors, and of its own without a cycle.
set(floors
    "(config|abi|failure|push_macros|pop_macros)\\.hpp"
    "number/.*"
    "math/.*"
    "(ray|aabb|hit_record|surface_sample)\\.hpp"
    "proof/.*"
    "formula/.*"
    "concepts\\.hpp"
    "shape/.*"
    "compose/.*"
    "bvh/.*"
    "raio\\.hpp")

function(problem text)
    set_property(GLOBAL APPEND_STRING PROPERTY problems "\n  ${text}")
endfunction()

function(find_floor header result)
    set(floor -1)
    foreach(pattern IN LISTS floors)
        math(EXPR floor "${floor} + 1")
        if(header MATCHES "^${pattern}$")
            set(${result} ${floor} PARENT_SCOPE)
            return()
        endif()
    endforeach()
    problem("${header} stands on no floor")
    set(${result} -1 PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE headers RELATIVE ${ROOT}/include/raio ${ROOT}/include/raio/*)
if(NOT headers)
    message(FATAL_ERROR "no headers in ${ROOT}/include/raio")
endif()

foreach(header IN LISTS headers)
    set(path ${ROOT}/include/raio/${header})
    find_floor(${header} floor)

    # Who is included.
    set(includes_${header} "")
    file(STRINGS ${path} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
        if(line MATCHES "<raio/(.*)>")
            set(included ${CMAKE_MATCH_1})
            list(APPEND includes_${header} ${included})
            find_floor(${included} included_floor)
            if(included_floor GREATER floor)
                problem("${header} includes ${included}, which stands above it")
            endif()
        elseif(line MATCHES "\"")
            problem("${header} includes by a relative path: ${line}")
        elseif(line MATCHES "<glm/glm\\.hpp>|<glm/gtx/|<iostream>")
            problem("${header} includes more than it needs: ${line}")
        endif()
    endforeach()

    # What else no header does.
    file(STRINGS ${path} lines REGEX "using namespace")
    if(lines)
        problem("${header} says `using namespace`")
    endif()
    file(STRINGS ${path} lines REGEX "^[ \t]*#[ \t]*define[ \t]")
    foreach(line IN LISTS lines)
        if(NOT header MATCHES "^(config|abi)\\.hpp$" OR NOT line MATCHES "define[ \t]+RAIO_[A-Z_]+([ \t(]|$)")
            problem("${header} defines a macro: ${line}")
        endif()
    endforeach()

    # Every name says the settings that it depends on: see abi.hpp.
    set(opened "raio::inline RAIO_ABI(::detail)?")
    if(header MATCHES "^bvh/|^number/(simd|pack)" AND NOT header STREQUAL "bvh/options.hpp")
        file(STRINGS ${path} lines REGEX "^namespace ${opened}::inline RAIO_REGISTERS {$")
        if(NOT lines)
            problem("${header} opens no inline RAIO_REGISTERS")
        endif()
        string(APPEND opened "(::inline RAIO_REGISTERS)?")
    endif()
    file(STRINGS ${path} lines REGEX "^namespace raio")
    foreach(line IN LISTS lines)
        if(NOT line MATCHES "^namespace ${opened} {$")
            problem("${header} does not open the namespace that says the settings: ${line}")
        endif()
    endforeach()

    if(NOT header MATCHES "^(push|pop)_macros\\.hpp$")
        file(STRINGS ${path} lines REGEX "^#pragma once$")
        if(NOT lines)
            problem("${header} has no #pragma once")
        endif()
        # Macros of others are put aside first of all, and are back at its end.
        file(READ ${path} text)
        if(NOT header MATCHES "^(raio|config|abi)\\.hpp$" AND
           NOT text MATCHES "^#pragma once\n\n#include <raio/push_macros\\.hpp>\n.*\n#include <raio/pop_macros\\.hpp>\n$")
            problem("${header} does not include push_macros.hpp first and pop_macros.hpp last")
        endif()
    endif()

    # Who goes with it.
    set(companions "")
    if(header MATCHES "^(number|math|shape|compose|bvh)/")
        list(APPEND companions tests)
    endif()
    if(header MATCHES "^(shape|compose)/")
        list(APPEND companions bench)
    endif()
    string(REGEX REPLACE "\\.hpp$" ".cpp" source ${header})
    foreach(folder IN LISTS companions)
        if(NOT EXISTS ${ROOT}/${folder}/${source})
            problem("${header} has no ${folder}/${source}")
        endif()
    endforeach()
endforeach()

# Takes away, again and again, the headers that include none of those that are left. A cycle is what remains.
set(left ${headers})
set(progress TRUE)
while(progress)
    set(progress FALSE)
    foreach(header IN LISTS left)
        set(blocked FALSE)
        foreach(included IN LISTS includes_${header})
            if(included IN_LIST left)
                set(blocked TRUE)
            endif()
        endforeach()
        if(NOT blocked)
            list(REMOVE_ITEM left ${header})
            set(progress TRUE)
        endif()
    endforeach()
endwhile()
if(left)
    problem("these headers stand in a cycle of includes, or above one: ${left}")
endif()

# The umbrella holds includes and nothing else: every shape and every composition. (Trees are much to compile.)
set(wanted ${headers})
list(FILTER wanted INCLUDE REGEX "^(shape|compose)/")
foreach(header IN LISTS wanted)
    if(NOT header IN_LIST includes_raio.hpp)
        problem("raio.hpp does not include ${header}")
    endif()
endforeach()
file(STRINGS ${ROOT}/include/raio/raio.hpp lines)
foreach(line IN LISTS lines)
    if(NOT line MATCHES "^(//.*|#pragma once|#include <raio/.*>)?$")
        problem("raio.hpp holds more than includes: ${line}")
    endif()
endforeach()

get_property(problems GLOBAL PROPERTY problems)
if(problems)
    message(FATAL_ERROR "The house is not in order:${problems}")
endif()
