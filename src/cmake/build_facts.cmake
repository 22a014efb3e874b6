# Writes build_facts.hpp: what the reports say of this build. Run with cmake -P at every build, so that the commit is the
# present one; the file changes only when they do.

set(SCREE_COMMIT unknown)
find_program(GIT git)
if(GIT)
    execute_process(COMMAND ${GIT} describe --always --dirty --abbrev=12 --exclude=* WORKING_DIRECTORY ${SOURCE}
        OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    if(NOT failed)
        set(SCREE_COMMIT ${described})
    endif()
endif()
configure_file(${SOURCE}/src/reports/build_facts.hpp.in ${OUTPUT} @ONLY)
