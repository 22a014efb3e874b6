# The figures in README.md are those of the reference run. Run with cmake -P.
cmake_policy(VERSION 3.25)

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
file(READ ${root}/README.md readme)
file(READ ${root}/demos/reports/headline.md figures)
string(FIND "${readme}" "<!-- figures of demos/reports -->\n${figures}<!-- end of figures -->\n" found)
if(found EQUAL -1)
    message(FATAL_ERROR "README.md has other figures than demos/reports/headline.md: run demos/reports/run --figures")
endif()
