# cmake -DFOLDER=<build folder> -DTARGET=<program> -DNEVER=<regex> -P: fails when the command that links the
# program names what it must not.
cmake_policy(VERSION 3.25)

set(link_file ${FOLDER}/CMakeFiles/${TARGET}.dir/link.txt)
if(EXISTS ${link_file})
    file(READ ${link_file} line)
else()
    execute_process(COMMAND ninja -C ${FOLDER} -t commands ${TARGET} OUTPUT_VARIABLE line COMMAND_ERROR_IS_FATAL ANY)
endif()
if(NOT line MATCHES "scree_core")
    message(FATAL_ERROR "this is no link line: ${line}")
endif()
if(line MATCHES "${NEVER}")
    message(FATAL_ERROR "linked with ${CMAKE_MATCH_0}: ${line}")
endif()
