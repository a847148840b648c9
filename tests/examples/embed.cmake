# embed draws the sky, a red ring, a yellow block and a checkered floor. EMBED is the program, FOLDER one that may be emptied.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${EMBED} ${FOLDER}/picture.ppm COMMAND_ERROR_IS_FATAL ANY)
file(READ ${FOLDER}/picture.ppm picture HEX)
string(LENGTH "${picture}" digits)
math(EXPR expected "2 * (15 + 3 * 640 * 360)")  # P6, 640 360, 255, and three bytes a pixel
if(NOT digits EQUAL expected)
    message(FATAL_ERROR "${digits} digits, expected ${expected}")
endif()

# expect(X Y RED GREEN BLUE): the pixel's colour, to a few parts of 255.
function(expect x y)
    foreach(channel IN ITEMS 0 1 2)
        math(EXPR begin "2 * (15 + 3 * (640 * ${y} + ${x}) + ${channel})")
        string(SUBSTRING "${picture}" ${begin} 2 byte)
        list(GET ARGN ${channel} wanted)
        math(EXPR off "0x${byte} - ${wanted}")
        if(off LESS -3 OR off GREATER 3)
            message(SEND_ERROR "pixel ${x} ${y}: channel ${channel} is 0x${byte}, expected ${wanted}")
        endif()
    endforeach()
endfunction()
expect(320 5 180 213 255)  # sky
expect(298 200 194 183 112)  # the block
expect(260 275 154 89 72)  # the ring
expect(100 320 215 215 215)  # the floor, light
expect(60 340 143 143 143)  # and dark
expect(202 212 108 108 108)  # in shade

execute_process(COMMAND ${EMBED} RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT (status EQUAL 2 AND error MATCHES "^usage: "))
    message(SEND_ERROR "without a picture's name: ${status}, ${error}")
endif()
execute_process(COMMAND ${EMBED} ${FOLDER}/none/picture.ppm RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT (status EQUAL 1 AND error MATCHES "none/picture.ppm cannot be written"))
    message(SEND_ERROR "a folder that is not there: ${status}, ${error}")
endif()
