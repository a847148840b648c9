# cmake -D ROOT=<checkout> -D HELLO=<program> -P readme.cmake
# The README's program is examples/hello.cpp, letter by letter, it prints what the README says, the next is a part of
# examples/path_tracer.cpp, and every file that the README links to is there.
cmake_minimum_required(VERSION 3.25)

file(READ ${ROOT}/README.md readme)
file(READ ${ROOT}/examples/hello.cpp hello)

string(FIND "${readme}" "```cpp\n" begin)
string(FIND "${readme}" "```cpp\n${hello}```\n" same)
if(begin EQUAL -1 OR NOT begin EQUAL same)
    message(SEND_ERROR "the first program of README.md is not examples/hello.cpp")
endif()

execute_process(COMMAND ${HELLO} OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${readme}" "`${output}`" same)
if(output STREQUAL "" OR same EQUAL -1)
    message(SEND_ERROR "examples/hello.cpp prints \"${output}\", README.md says otherwise")
endif()

# The second program is a part of another.
file(READ ${ROOT}/examples/path_tracer.cpp path_tracer)
string(FIND "${readme}" "```cpp\n// The light" begin)
string(SUBSTRING "${readme}" ${begin} -1 part)
string(REGEX REPLACE "^```cpp\n([^`]*)```.*" "\\1" part "${part}")
string(FIND "${path_tracer}" "\n${part}" found)
if(begin EQUAL -1 OR found EQUAL -1)
    message(SEND_ERROR "what README.md shows of examples/path_tracer.cpp is not there")
endif()

string(REPLACE "](" "link(" readme "${readme}")  # a lone bracket would glue list elements together
string(REGEX MATCHALL "link\\([^)#: ]+\\)" links "${readme}")
foreach(link IN LISTS links)
    string(REGEX REPLACE "^link\\((.*)\\)$" "\\1" path ${link})
    if(NOT EXISTS ${ROOT}/${path})
        message(SEND_ERROR "README.md links to ${path}, which is not there")
    endif()
endforeach()
