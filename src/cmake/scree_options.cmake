# What can be chosen when configuring, and what holds for every target of ours.

include(GNUInstallDirs)

option(SCREE_TESTS "Build the tests and benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(SCREE_JOIN_TESTS "Compile test files six at a time, in a third of the time from nothing" ON)
option(SCREE_WERROR "Treat warnings in our own code as errors" ${PROJECT_IS_TOP_LEVEL})
option(SCREE_NATIVE "Compile for this machine's processor only" OFF)
option(SCREE_FUZZ "Build the fuzz targets of tests/fuzz; needs Clang" OFF)
set(SCREE_SANITIZE "" CACHE STRING "Sanitizers, such as address,undefined")
set(SCREE_FOLDERS "" CACHE STRING "Build only these folders of src and tests, such as mesh;overlap (empty: all)")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

set(SCREE_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wold-style-cast
    -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough -Wcast-qual)

# The settings of one of our targets. Nothing here is handed on to a user's program, but for the processor:
# Eigen's alignment depends on it.
function(scree_settings target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE ${SCREE_WARNINGS} $<$<BOOL:${SCREE_WERROR}>:-Werror>)
    # No contraction into fused multiply-adds: the same source gives the same bytes with any processor option.
    target_compile_options(${target} PRIVATE -ffp-contract=off)
    if(SCREE_NATIVE)
        target_compile_options(${target} PUBLIC -march=native)
    endif()
    if(SCREE_FUZZ)
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    if(SCREE_SANITIZE)
        target_compile_options(${target} PUBLIC -fsanitize=${SCREE_SANITIZE} -fno-sanitize-recover=all
            -fno-omit-frame-pointer)
        # With sanitizers GCC sees uninitialized variables in the standard library where there are none.
        target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
        target_link_options(${target} PUBLIC -fsanitize=${SCREE_SANITIZE})
    endif()
endfunction()

# The files that match `pattern` in the named folders under `root`, limited to SCREE_FOLDERS.
function(scree_glob result root pattern)
    set(found "")
    foreach(folder IN LISTS ARGN)
        if(NOT SCREE_FOLDERS OR folder IN_LIST SCREE_FOLDERS)
            file(GLOB files CONFIGURE_DEPENDS ${root}/${folder}/${pattern})
            list(APPEND found ${files})
        endif()
    endforeach()
    set(${result} ${found} PARENT_SCOPE)
endfunction()
