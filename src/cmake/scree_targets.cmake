# Our libraries and the program: which folders each holds and what it stands on. Sources are collected by folder.

configure_file(${PROJECT_SOURCE_DIR}/include/scree/version.hpp.in
    ${PROJECT_BINARY_DIR}/include/scree/version.hpp @ONLY)
set(SCREE_COMPONENTS "")  # the libraries that exist, in order of dependence

# Sets `result` to whether all of the named packages and targets of ours are there.
function(scree_has result)
    set(${result} TRUE PARENT_SCOPE)
    foreach(need IN LISTS ARGN)
        if(need IN_LIST SCREE_LACKS OR (need MATCHES "^scree_" AND NOT TARGET ${need}))
            set(${result} FALSE PARENT_SCOPE)
        endif()
    endforeach()
endfunction()

# scree_library(<name> FOLDERS <folder>... [NEEDS <package or target>...] [PUBLIC <target>...] [PRIVATE <target>...]
#               [PCH <header>...])
# A library that lacks what it needs, or whose folders are not built, is skipped, and so are links to it.
function(scree_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FOLDERS;NEEDS;PUBLIC;PRIVATE;PCH")
    scree_glob(sources ${PROJECT_SOURCE_DIR}/src *.cpp ${arg_FOLDERS})
    scree_has(complete ${arg_NEEDS})
    if(sources AND NOT complete)
        message(STATUS "scree: left out ${name}, for want of ${SCREE_LACKS}")
    endif()
    if(NOT sources OR NOT complete)
        return()
    endif()
    add_library(scree_${name} ${sources})
    add_library(scree::${name} ALIAS scree_${name})
    set_target_properties(scree_${name} PROPERTIES EXPORT_NAME ${name} SCREE_FOLDERS "${arg_FOLDERS}")
    scree_settings(scree_${name})
    target_include_directories(scree_${name} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    scree_link(scree_${name} PUBLIC ${arg_PUBLIC})
    scree_link(scree_${name} PRIVATE ${arg_PRIVATE})
    if(arg_PCH)
        target_precompile_headers(scree_${name} PRIVATE ${arg_PCH})
    endif()
    set(SCREE_COMPONENTS ${SCREE_COMPONENTS} ${name} PARENT_SCOPE)
endfunction()

# Links the targets of ours that exist, and all others.
function(scree_link target scope)
    foreach(library IN LISTS ARGN)
        string(REGEX REPLACE "^scree::(core|world|mesh_io|output|vtk|scenes|reports)$" "scree_\\1" library ${library})
        if(TARGET ${library} OR NOT library MATCHES "^scree_")
            target_link_libraries(${target} ${scope} ${library})
        endif()
    endforeach()
endfunction()

set(eigen_pch <Eigen/Core> <Eigen/Geometry> <vector> <string>)
scree_library(core FOLDERS mesh overlap contact dynamics bdf
    PUBLIC Eigen3::Eigen PRIVATE Qhull::qhull_r PCH ${eigen_pch})
scree_library(world FOLDERS detect world NEEDS scree_core Bullet
    PUBLIC scree::core scree::bullet PCH ${eigen_pch} <btBulletDynamicsCommon.h>)
scree_library(mesh_io FOLDERS mesh_io NEEDS scree_core assimp
    PUBLIC scree::core PRIVATE assimp::assimp)
scree_library(output FOLDERS output NEEDS scree_core assimp nlohmann_json xxHash
    PUBLIC scree::core PRIVATE assimp::assimp nlohmann_json::nlohmann_json PCH ${eigen_pch})
if(TARGET scree_output)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/output/page.html)
    file(READ ${PROJECT_SOURCE_DIR}/src/output/page.html SCREE_PAGE)
    configure_file(${PROJECT_SOURCE_DIR}/src/output/page_template.hpp.in
        ${PROJECT_BINARY_DIR}/generated/output/page_template.hpp @ONLY)
    target_include_directories(scree_output PRIVATE ${PROJECT_BINARY_DIR}/generated/output)
endif()
if(VTK_FOUND)
    scree_library(vtk FOLDERS vtk NEEDS scree_output
        PUBLIC scree::output PRIVATE VTK::CommonCore VTK::CommonDataModel VTK::IOXML)
endif()
if(TARGET scree_vtk)
    set_source_files_properties(${PROJECT_SOURCE_DIR}/src/scenes/not_in_build.cpp
        ${PROJECT_SOURCE_DIR}/src/cli/frame_writer.cpp PROPERTIES COMPILE_DEFINITIONS SCREE_HAS_VTK
        SKIP_PRECOMPILE_HEADERS ON)
endif()
scree_library(scenes FOLDERS scenes NEEDS scree_world scree_mesh_io nlohmann_json
    PUBLIC scree::world scree::mesh_io nlohmann_json::nlohmann_json
    PCH ${eigen_pch} <btBulletDynamicsCommon.h> <nlohmann/json.hpp>)
if(TARGET scree_scenes AND TARGET scree::hacd)
    target_link_libraries(scree_scenes PRIVATE scree::hacd)
    set_source_files_properties(${PROJECT_SOURCE_DIR}/src/scenes/decomposition.cpp PROPERTIES
        COMPILE_DEFINITIONS SCREE_HAS_HACD SKIP_PRECOMPILE_HEADERS ON)
endif()

# The scenes that come with scree, for a program that runs from its build folder.
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/scenes/find_scene.cpp PROPERTIES
    COMPILE_DEFINITIONS SCREE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" SKIP_PRECOMPILE_HEADERS ON)

scree_library(reports FOLDERS reports NEEDS scree_scenes scree_output
    PUBLIC scree::scenes scree::output
    PCH ${eigen_pch} <btBulletDynamicsCommon.h>)
if(TARGET scree_reports)
    set(build_facts ${PROJECT_BINARY_DIR}/reports/build_facts.hpp)
    string(TOUPPER "${CMAKE_BUILD_TYPE}" SCREE_UPPER_BUILD_TYPE)
    string(STRIP "${CMAKE_BUILD_TYPE}, ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${SCREE_UPPER_BUILD_TYPE}}" build_options)
    set(component_links "")
    foreach(component IN LISTS SCREE_COMPONENTS)
        get_target_property(links scree_${component} LINK_LIBRARIES)
        string(REPLACE "scree_" "scree::" links "${links}")
        string(REPLACE ";" " " links "${links}")
        string(APPEND component_links "{\"${component}\", \"${links}\"},")
    endforeach()
    add_custom_target(scree_build_facts BYPRODUCTS ${build_facts}
        COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${build_facts}
        -DCMAKE_CXX_COMPILER_ID=${CMAKE_CXX_COMPILER_ID} -DCMAKE_CXX_COMPILER_VERSION=${CMAKE_CXX_COMPILER_VERSION}
        "-DSCREE_BUILD_OPTIONS=${build_options}" -DBULLET_VERSION_STRING=${BULLET_VERSION_STRING}
        "-DSCREE_COMPONENT_LINKS=${component_links}"
        -DEigen3_VERSION=${Eigen3_VERSION} -DQhull_VERSION=${Qhull_VERSION} -Dassimp_VERSION=${assimp_VERSION}
        -P ${PROJECT_SOURCE_DIR}/src/cmake/build_facts.cmake VERBATIM)
    add_dependencies(scree_reports scree_build_facts)
    target_include_directories(scree_reports PRIVATE ${PROJECT_BINARY_DIR}/reports)
endif()

scree_glob(program_sources ${PROJECT_SOURCE_DIR}/src *.cpp cli)
scree_has(complete scree_reports CLI11)
if(program_sources AND complete)
    add_executable(scree_program ${program_sources})
    set_target_properties(scree_program PROPERTIES OUTPUT_NAME scree)
    scree_settings(scree_program)
    target_include_directories(scree_program PRIVATE
        ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include)
    scree_link(scree_program PRIVATE scree::reports scree::scenes scree::vtk scree::output scree::world scree::mesh_io scree::core
        CLI11::CLI11 nlohmann_json::nlohmann_json)
endif()
