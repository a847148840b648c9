# path_tracer draws the same picture on one thread and on three: the sky above, a ground below that is darker. PATH_TRACER is the
# program, FOLDER one that may be emptied.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
foreach(threads IN ITEMS 1 3)
    execute_process(COMMAND ${PATH_TRACER} ${threads}.ppm 96 4 ${threads} WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "path_tracer ends with ${status}")
    endif()
    file(READ ${FOLDER}/${threads}.ppm picture_${threads} HEX)
endforeach()
if(NOT picture_1 STREQUAL picture_3)
    message(SEND_ERROR "one thread draws another picture than three")
endif()

string(LENGTH "${picture_1}" digits)
math(EXPR expected "2 * (13 + 3 * 96 * 54)")  # P6, 96 54, 255, and three bytes a pixel
if(NOT digits EQUAL expected)
    message(SEND_ERROR "${digits} digits, expected ${expected}")
endif()

# mean(VARIABLE ROW): the mean of a row's bytes.
function(mean variable row)
    math(EXPR begin "26 + 2 * 3 * 96 * ${row}")
    string(SUBSTRING "${picture_1}" ${begin} 576 bytes)
    string(REGEX REPLACE "(..)" "+0x\\1" sum "${bytes}")
    math(EXPR mean "(0${sum}) / 288")
    set(${variable} ${mean} PARENT_SCOPE)
endfunction()
mean(sky 0)
mean(ground 53)
if(NOT (sky GREATER 215 AND ground LESS 200 AND ground GREATER 80))
    message(SEND_ERROR "the sky is ${sky}, the ground ${ground}")
endif()

foreach(arguments IN ITEMS "" "--help")  # of which neither is a picture's name
    execute_process(COMMAND ${PATH_TRACER} ${arguments} WORKING_DIRECTORY ${FOLDER} TIMEOUT 60 RESULT_VARIABLE status
        ERROR_VARIABLE error)
    if(NOT (status EQUAL 1 AND error MATCHES "^usage: "))
        message(SEND_ERROR "'${arguments}': ${status}, ${error}")
    endif()
endforeach()
# A picture that cannot be written is refused before it is drawn, which would take the test's time and longer.
execute_process(COMMAND ${PATH_TRACER} ${FOLDER}/none/picture.ppm 9999 9999 TIMEOUT 60 RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT (status EQUAL 1 AND error MATCHES "none/picture.ppm cannot be written"))
    message(SEND_ERROR "a folder that is not there: ${status}, ${error}")
endif()
