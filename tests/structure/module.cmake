# cmake -D COMPILER=<path> -D INCLUDES=<folders> [-D FLAGS=<list>] -D FOLDER=<for what is written> -P module.cmake
# A program that says `import raio;` has what one has that includes raio, and both may be one. Clang 16 and later,
# g++ 14 and later.
cmake_minimum_required(VERSION 3.25)

list(TRANSFORM INCLUDES PREPEND "-I")
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

function(run)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(module ${CMAKE_CURRENT_LIST_DIR}/../../include/raio/raio.cppm)
set(program ${CMAKE_CURRENT_LIST_DIR}/module.cpp)
set(compile ${COMPILER} -std=c++20 ${FLAGS} -Wall -Wextra -Wconversion -Wshadow -Werror -Wno-deprecated-declarations
    ${INCLUDES})

execute_process(COMMAND ${COMPILER} -x c++ -E -dM /dev/null OUTPUT_VARIABLE macros COMMAND_ERROR_IS_FATAL ANY)
set(beside -DHAS_FILE_BESIDE)
if(macros MATCHES "define __clang_major__ ([0-9]+)")
    if(CMAKE_MATCH_1 LESS 17)
        set(beside "")  # see raio.cppm
    endif()
    run(${compile} --precompile ${module} -o raio.pcm)
    run(${COMPILER} ${FLAGS} -c raio.pcm -o raio.o)
    list(APPEND compile -fmodule-file=raio=raio.pcm)
else()
    list(APPEND compile -fmodules-ts)
    run(${compile} -x c++ -c ${module} -o raio.o)
endif()

run(${compile} ${beside} -c ${program} -o program.o)
set(objects program.o raio.o)
if(beside)
    run(${compile} -DBESIDE -c ${program} -o beside.o)
    list(APPEND objects beside.o)
endif()
run(${COMPILER} ${objects} -o program)
run(./program)
