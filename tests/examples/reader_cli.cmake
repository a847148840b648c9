# raio-render refuses what it cannot do: exit status 2, one line on standard error, nothing on standard output, and no file made,
# changed or left behind. RENDER is the program, README its manual, FOLDER one that may be emptied.
cmake_minimum_required(VERSION 3.25)

if(NOT EXISTS "${RENDER}")
    message(FATAL_ERROR "There is no program ${RENDER}")
endif()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/folder)
file(WRITE ${FOLDER}/kept.ppm "kept")
set(camera "0 0 5\n0 0 0\n0 1 0\n60\n")
set(looks "1 solid 1 0 0\n1 1 0 0 0 0 0 0\n")
set(good "${camera}0\n${looks}1\n0 0 sphere 0 0 0 1\n")
file(WRITE ${FOLDER}/good.txt "${good}")

# Runs raio-render in FOLDER.
macro(render)
    file(GLOB before RELATIVE ${FOLDER} ${FOLDER}/*)
    execute_process(COMMAND ${RENDER} ${ARGN} WORKING_DIRECTORY ${FOLDER}
        RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error TIMEOUT 60)
    file(GLOB after RELATIVE ${FOLDER} ${FOLDER}/*)
    file(READ ${FOLDER}/kept.ppm kept)
endmacro()

# expect_refusal(PATTERN ARGUMENT...): the one line matches the pattern.
function(expect_refusal pattern)
    render(${ARGN})
    if(NOT (status STREQUAL "2" AND error MATCHES "^[^\n]+\n$" AND error MATCHES "${pattern}" AND output STREQUAL ""
            AND after STREQUAL before AND kept STREQUAL "kept"))
        message(SEND_ERROR "raio-render ${ARGN}: expected status 2, a line that matches ${pattern}, and no file touched\n"
            "status: ${status}\nstandard error: ${error}\nstandard output: ${output}\nfiles: ${after}\nkept.ppm: ${kept}")
    endif()
endfunction()

# expect_bad_scene(TEXT PATTERN): the text is refused, whether the picture exists or not.
function(expect_bad_scene text pattern)
    file(WRITE ${FOLDER}/scene.txt "${text}")
    expect_refusal("^scene.txt:${pattern}" scene.txt -o kept.ppm)
    expect_refusal("^scene.txt:${pattern}" scene.txt -o new.png)
endfunction()

expect_bad_scene("" "1: found the end of the file, expected a number for the camera's eye\n$")
expect_bad_scene("${camera}1\n0 9" "5: .* end of the file|6: found the end of the file, expected a number")
expect_bad_scene("0 zero 5" "1: found 'zero', expected a number for the camera's eye\n$")
expect_bad_scene("0 nan 5" "1: found 'nan', expected a number")
expect_bad_scene("0 1e999 5" "1: found '1e999', expected 0 or a magnitude")
expect_bad_scene("${camera}-1" "5: found '-1', expected a whole number")
expect_bad_scene("${camera}4000000000" "5: found '4000000000', expected at most 0 lights")
expect_bad_scene("${camera}0\n${looks}1\n0 0 teapot 1" "9: found 'teapot', expected a shape: [a-z_, ]*box, [a-z_, ]*sphere, ")
expect_bad_scene("${camera}0\n${looks}1\n1 0 sphere 0 0 0 1" "9: found '1', expected the index of a pigment, from 0 to 0\n$")
expect_bad_scene("${camera}0\n${looks}1\n0 0 sphere 0 0 0 0" "9: found '0', expected a number above 0 for the radius")
expect_bad_scene("${camera}0\n1 texture none.png 0 0 0 0 0 0 0 0" "6: found no picture in the texture 'none.png' ")
expect_bad_scene("${camera}0\n1 texture folder 0 0 0 0 0 0 0 0" "6: found no picture in the texture 'folder' ")
expect_bad_scene("${camera}0\n1 texture good.txt 0 0 0 0 0 0 0 0" "6: found no picture in the texture 'good.txt' ")
expect_bad_scene("${good}and more" "10: found 'and', expected the end of the file or a statement")
string(REPEAT "x" 100000 long)
expect_bad_scene("0 ${long}" "1: found 'xxxx[x]*...', expected a number")

expect_refusal("^missing.txt:1: found no such file, expected a scene file\n$" missing.txt)
expect_refusal("^folder:1: found a directory, expected a scene file\n$" folder)
expect_refusal("^.*:1: found '.x7fELF|:1: found '" ${RENDER})  # a program is no scene

foreach(size IN ITEMS 0x10 10x0 -1x10 10 x 10x10x10 tenxten 99999999999x1 1.5x2)
    expect_refusal("expected " good.txt -o kept.ppm --size=${size})
endforeach()
expect_refusal("--samples" good.txt -o kept.ppm --samples 0)
expect_refusal("--threads" good.txt -o kept.ppm --threads 0)
expect_refusal("--depth" good.txt -o kept.ppm --depth -1)
expect_refusal("--integrator" good.txt -o kept.ppm --integrator guess)
expect_refusal("--unknown" good.txt -o kept.ppm --unknown)
expect_refusal("SCENE")
expect_refusal("kept.txt" good.txt -o kept.txt)
expect_refusal("no-folder" good.txt -o no-folder/new.png --size 8x6)
expect_refusal("kept.ppm" good.txt -o kept.ppm/new.png --size 8x6)
expect_refusal("folder" good.txt -o folder --size 8x6)

# No picture overwrites what it is made of, under whatever name.
file(WRITE ${FOLDER}/scene.ppm "${good}")
file(CREATE_LINK scene.ppm ${FOLDER}/link.ppm SYMBOLIC)
foreach(name IN ITEMS scene.ppm ./scene.ppm link.ppm ${FOLDER}/scene.ppm)
    expect_refusal("scene.ppm|link.ppm: is a file that the scene is made of" scene.ppm -o ${name} --size 8x6)
    file(READ ${FOLDER}/scene.ppm scene)
    if(NOT scene STREQUAL good)
        message(SEND_ERROR "-o ${name} has overwritten the scene")
    endif()
endforeach()

# Where memory runs out, one is told what for. (Sanitizers need more of it themselves.)
find_program(SH sh)
execute_process(COMMAND ${SH} -c "ulimit -v 2000000; exec ${RENDER} --help"
    RESULT_VARIABLE limited OUTPUT_QUIET ERROR_QUIET)
if(limited STREQUAL "0")
    execute_process(
        COMMAND ${SH} -c "ulimit -v 2000000; exec ${RENDER} good.txt -o kept.ppm --size 16384x16384 --threads 1"
        WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE status ERROR_VARIABLE error TIMEOUT 60)
    if(NOT (status STREQUAL "2" AND error STREQUAL "raio-render: out of memory for a picture of 16384x16384 pixels\n"))
        message(SEND_ERROR "Out of memory: status ${status}, standard error ${error}")
    endif()
endif()

# A signal ends the work and keeps what there is of it, under the picture's name.
foreach(signal IN ITEMS "INT 130" "TERM 143")
    string(REGEX MATCHALL "[^ ]+" signal ${signal})
    list(GET signal 0 name)
    list(GET signal 1 expected)
    # A shell without jobs has what runs in the background ignore SIGINT: so the one that sends it is there.
    execute_process(
        COMMAND ${SH} -c "(sleep 3; kill -s ${name} $$) & exec ${RENDER} good.txt -o stopped.ppm --size 64x2000 --samples 2000 --integrator flat --threads 1"
        WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE status ERROR_VARIABLE error TIMEOUT 60)
    set(wanted "^raio-render: interrupted; stopped.ppm has [0-9]+ of 2000 rows, and is black where it is not rendered\n$")
    if(NOT (status STREQUAL expected AND error MATCHES "${wanted}" AND EXISTS ${FOLDER}/stopped.ppm))
        message(SEND_ERROR "SIG${name}: status ${status}, standard error ${error}")
    endif()
    file(REMOVE ${FOLDER}/stopped.ppm)
endforeach()

# That nothing lights a scene is no mistake, but said.
string(REPLACE "1 1 0 0 0 0 0 0" "1 0 1 0 0 0 0 0" dark "${good}")
file(WRITE ${FOLDER}/dark.txt "${dark}")
render(dark.txt -o dark.ppm --size 8x6)
if(NOT (status STREQUAL "0" AND error MATCHES "^dark.txt: nothing lights the scene [^\n]+: all is black\n$"))
    message(SEND_ERROR "A dark scene: status ${status}, standard error ${error}")
endif()
render(dark.txt -o dark.ppm --size 8x6 --integrator normals)
if(NOT (status STREQUAL "0" AND error STREQUAL ""))
    message(SEND_ERROR "A dark scene's normals: status ${status}, standard error ${error}")
endif()

# What is right is done, in silence where standard error is no terminal: here the first scene of the README.
file(READ ${README} readme)
if(NOT readme MATCHES "```text\n(# first.txt[^`]+)```")
    message(FATAL_ERROR "${README} has no first scene")
endif()
file(WRITE ${FOLDER}/first.txt "${CMAKE_MATCH_1}")
render(first.txt -o new.ppm --size 8x6)
list(APPEND before new.ppm)
list(SORT before)
file(SIZE ${FOLDER}/new.ppm bytes)
if(NOT (status STREQUAL "0" AND error STREQUAL "" AND output STREQUAL "" AND after STREQUAL before AND bytes EQUAL 155))
    message(SEND_ERROR "A good scene: status ${status}, standard error ${error}, files ${after}, new.ppm of ${bytes} bytes")
endif()

# How light is followed when nobody says: along paths where there are no lamps, by Phong's model where there are.
foreach(choice IN ITEMS "good.txt path" "first.txt whitted")
    string(REGEX MATCHALL "[^ ]+" choice ${choice})
    list(GET choice 0 scene)
    list(GET choice 1 integrator)
    render(${scene} -o as_it_is_lit.ppm --size 16x12)
    render(${scene} -o as_told.ppm --size 16x12 --integrator ${integrator})
    file(SHA256 ${FOLDER}/as_it_is_lit.ppm as_it_is_lit)
    file(SHA256 ${FOLDER}/as_told.ppm as_told)
    if(NOT as_it_is_lit STREQUAL as_told)
        message(SEND_ERROR "${scene} is not rendered by ${integrator} unless told otherwise")
    endif()
endforeach()
