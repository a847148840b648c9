# cmake -D COMPILER=<path> -D INCLUDES=<folders> -D FOLDER=<for what is written> -P refused.cmake
# Programs that cannot be right: each is refused by an error at the line that is wrong, says there which requirement is
# not met, and no header of raio has an error of its own.
cmake_minimum_required(VERSION 3.25)

list(TRANSFORM INCLUDES PREPEND "-I")

function(compile name line)
    set(trees "")
    if(line MATCHES "bvh")
        set(trees "#include <raio/bvh/bvh.hpp>")
    endif()
    file(WRITE ${FOLDER}/${name}.cpp "${trees}
#include <raio/raio.hpp>

int main() {
    using namespace raio;
    const sphere<float> ball{{0, 0, 0}, 1};
    const sphere<double> other_ball{{0, 0, 0}, 1};
    const disc<float> flat{{0, 0, 0}, {0, 0, 1}, 1};
    const ray<float> ray{{0, 0, 5}, {0, 0, -1}};
    hit_record<float> rec;
    struct { float distance; } without_t{};
    return sizeof(other_ball) + sizeof(flat) + sizeof(rec) + sizeof(without_t) + ball.occluded(ray, 0, 1);
}
void asked() {
    using namespace raio;
    [[maybe_unused]] const sphere<float> ball{{0, 0, 0}, 1};
    [[maybe_unused]] const sphere<double> other_ball{{0, 0, 0}, 1};
    [[maybe_unused]] const disc<float> flat{{0, 0, 0}, {0, 0, 1}, 1};
    [[maybe_unused]] const ray<float> ray{{0, 0, 5}, {0, 0, -1}};
    [[maybe_unused]] hit_record<float> rec;
    [[maybe_unused]] struct { float distance; } without_t{};
#line 1000
    ${line}
}
")
    execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${INCLUDES} ${FOLDER}/${name}.cpp
        RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    set(result ${result} PARENT_SCOPE)
    set(said "${said}" PARENT_SCOPE)
endfunction()

function(check_refused name line requirement)
    compile(${name} "${line}")
    string(REGEX MATCHALL "[^\n;]*error:[^\n;]*" errors "${said}")
    set(elsewhere ${errors})
    list(FILTER elsewhere EXCLUDE REGEX "${name}\\.cpp:1000:")
    list(FILTER elsewhere EXCLUDE REGEX "error: template constraint failure")  # which is a note to g++ 12, but in name
    if(result EQUAL 0 OR NOT errors OR elsewhere OR NOT said MATCHES "${requirement}")
        message(SEND_ERROR "`${line}` is not refused there, for `${requirement}`:\n${said}")
    endif()
endfunction()

compile(nothing_wrong "ball.hit(ray, 0, 1, rec);")
if(NOT result EQUAL 0)
    message(SEND_ERROR "what is right is refused:\n${said}")
endif()

check_refused(mixed_difference "difference_of(ball, other_ball);" "of_one_number_type")
check_refused(mixed_union "union_of(&ball, &other_ball);" "of_one_number_type")
check_refused(mixed_csg "csg<set_operation::intersect, sphere<float>, sphere<double>> both{ball, other_ball};"
    "of_one_number_type")
check_refused(mixed_group "group both{ball, other_ball};" "of_one_number_type|constraints not satisfied")
check_refused(mixed_tree "bvh<sphere<float>, sphere<double>> both;" "of_one_number_type")
check_refused(mixed_map "transformed moved{ball, transform<double>{}};" "transform")
check_refused(mixed_ray "ball.occluded(raio::ray<double>{}, 0, 1);" "ray<double>")
check_refused(mixed_any "any_primitive<float> any{other_ball};" "sphere<double>")
check_refused(mixed_mesh "bvh<triangle<float>> tree(mesh<double>{});" "mesh<double>")
check_refused(whole_numbers "sphere<int> whole{{0, 0, 0}, 1};" "real")
check_refused(flat_difference "difference_of(ball, flat);" "solid")
check_refused(flat_spans "group{flat}.spans(ray);" "all_solid")
check_refused(flat_any "any_solid<float> any{flat};" "solid")
check_refused(no_shapes "bvh<int> tree;" "bounded")
foreach(shape IN ITEMS "ball" "heightfield<float>{}" "group{ball}" "union_of(ball, ball)" "any_primitive<float>(ball)"
        "transformed{ball, transform<float>{}}" "bvh<sphere<float>>{}" "mesh<float>{}" "signed_distance<float, float (*)(vec3<float>)>{}")
    string(MAKE_C_IDENTIFIER "no_t_${shape}" name)
    check_refused(${name} "${shape}.hit(ray, 0, 1, without_t);" "rec\\.t")
endforeach()
