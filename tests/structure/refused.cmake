# cmake -D COMPILER=<path> -D ALL_ERRORS=<option for no limit> -D INCLUDES=<folders> -D FOLDER=<for what is written>
#     -P refused.cmake
# Programs that cannot be right: each is refused by an error at the line that is wrong, says there which requirement is
# not met, and no header of raio has an error of its own. All are functions of one file, so that raio is parsed once.
cmake_minimum_required(VERSION 3.25)

list(TRANSFORM INCLUDES PREPEND "-I")
set(source "#include <raio/bvh/bvh.hpp>\n#include <raio/raio.hpp>\n")
set(cases 0)

# The function that has `line` in it.
macro(add_program line number)
    string(APPEND source "void asked_${number}() {
    using namespace raio;
    [[maybe_unused]] const sphere<float> ball{{0, 0, 0}, 1};
    [[maybe_unused]] const sphere<double> other_ball{{0, 0, 0}, 1};
    [[maybe_unused]] const disc<float> flat{{0, 0, 0}, {0, 0, 1}, 1};
    [[maybe_unused]] const ray<float> ray{{0, 0, 5}, {0, 0, -1}};
    [[maybe_unused]] hit_record<float> rec;
    [[maybe_unused]] struct { float distance; } without_t{};
#line ${number}
    ${line}
}
")
endmacro()

macro(add_refused line requirement)
    math(EXPR number "1000 + ${cases}")
    add_program("${line}" ${number})
    set(line_${number} "${line}")
    set(requirement_${number} "${requirement}")
    math(EXPR cases "${cases} + 1")
endmacro()

# What is right is let in.
add_program("ball.hit(ray, 0, 1, rec);" 900)
string(APPEND source "#if !defined(RIGHT)\n")
add_refused("difference_of(ball, other_ball);" "of_one_number_type")
add_refused("union_of(&ball, &other_ball);" "of_one_number_type")
add_refused("csg<set_operation::intersect, sphere<float>, sphere<double>> both{ball, other_ball};" "of_one_number_type")
add_refused("group both{ball, other_ball};" "of_one_number_type|constraints not satisfied")
add_refused("bvh<sphere<float>, sphere<double>> both;" "of_one_number_type")
add_refused("transformed moved{ball, transform<double>{}};" "transform")
add_refused("ball.occluded(raio::ray<double>{}, 0, 1);" "ray<double>")
add_refused("any_primitive<float> any{other_ball};" "sphere<double>")
add_refused("bvh<triangle<float>> tree(mesh<double>{});" "mesh<double>")
add_refused("sphere<int> whole{{0, 0, 0}, 1};" "real")
add_refused("difference_of(ball, flat);" "solid")
add_refused("group{flat}.spans(ray);" "all_solid")
add_refused("any_solid<float> any{flat};" "solid")
add_refused("bvh<int> tree;" "bounded")
foreach(shape IN ITEMS "ball" "heightfield<float>{}" "group{ball}" "union_of(ball, ball)" "any_primitive<float>(ball)"
        "transformed{ball, transform<float>{}}" "bvh<sphere<float>>{}" "mesh<float>{}" "signed_distance<float, float (*)(vec3<float>)>{}")
    add_refused("${shape}.hit(ray, 0, 1, without_t);" "rec\\.t")
endforeach()
string(APPEND source "#endif\n")
file(WRITE ${FOLDER}/refused.cpp "${source}")

execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -DRIGHT ${INCLUDES} ${FOLDER}/refused.cpp
    RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT result EQUAL 0)
    message(SEND_ERROR "what is right is refused:\n${said}")
endif()

# Each error, with the notes that follow it: which are about the line that it names.
execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${ALL_ERRORS} ${INCLUDES} ${FOLDER}/refused.cpp
    ERROR_VARIABLE said)
string(REPLACE ";" "," said "${said}")
string(REGEX REPLACE "\n([^\n]*error:)" ";\\1" errors "${said}")
foreach(error IN LISTS errors)
    if(error MATCHES "^[^\n]*refused\\.cpp:(1[0-9][0-9][0-9]):[^\n]*error:")
        string(APPEND said_${CMAKE_MATCH_1} "${error}\n")
        set(last ${CMAKE_MATCH_1})
    elseif(error MATCHES "error: template constraint failure")  # which is a note to g++ 12, but in name
        string(APPEND said_${last} "${error}\n")
    elseif(error MATCHES "error:")
        message(SEND_ERROR "an error elsewhere:\n${error}")
    endif()
endforeach()
math(EXPR last "999 + ${cases}")
foreach(number RANGE 1000 ${last})
    if(NOT "${said_${number}}" MATCHES "${requirement_${number}}")
        message(SEND_ERROR "`${line_${number}}` is not refused there, for `${requirement_${number}}`:\n${said_${number}}")
    endif()
endforeach()
