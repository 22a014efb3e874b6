# The figures in README.md are those that were measured last. Run with cmake -P.
cmake_policy(VERSION 3.25)

# check_figures(<file> <opening> <closing> <command>): README.md has the file between its two marks.
function(check_figures file opening closing command)
    file(READ ${root}/README.md readme)
    file(READ ${root}/${file} figures)
    string(FIND "${readme}" "${opening}\n${figures}${closing}\n" found)
    if(found EQUAL -1)
        message(FATAL_ERROR "README.md has other figures than ${file}: run ${command}")
    endif()
endfunction()

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
check_figures(demos/reports/headline.md "<!-- figures of demos/reports -->" "<!-- end of figures -->"
    "demos/reports/run --figures")
check_figures(demos/gallery/results.md "<!-- figures of demos/gallery -->" "<!-- end of figures of the gallery -->"
    "demos/gallery/run --figures")
