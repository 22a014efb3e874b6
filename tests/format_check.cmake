# All sources are laid out as .clang-format says. Run with cmake -DCLANG_FORMAT=<program> -P.

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set(patterns "")
foreach(folder IN ITEMS include src tests demos)
    list(APPEND patterns ${root}/${folder}/*.hpp ${root}/${folder}/*.cpp)
endforeach()
file(GLOB_RECURSE files ${patterns})
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files} RESULT_VARIABLE failed)
if(failed)
    message(FATAL_ERROR "run clang-format -i on the files named above")
endif()
