# cmake -DSOURCE=<folder> -DBUILD=<folder> -P optional_packages.cmake
# A package that is missing leaves out what needs it, and nothing else: configures without each in turn.

cmake_policy(VERSION 3.25)
set(all world mesh_io output scenes reports program)
set(without_assimp mesh_io output scenes reports program)
set(without_nlohmann_json output scenes reports program)
set(without_CLI11 program)
set(without_Bullet world scenes reports program)

foreach(package assimp nlohmann_json CLI11 Bullet)
    set(folder ${BUILD}/${package})
    file(REMOVE_RECURSE ${folder})
    execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${folder} -DSCREE_TESTS=OFF
        -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder} --target help OUTPUT_VARIABLE targets
        COMMAND_ERROR_IS_FATAL ANY)
    if(NOT targets MATCHES "scree_core")
        message(FATAL_ERROR "without ${package} there is no core")
    endif()
    foreach(component IN LISTS all)
        set(expected TRUE)
        if(component IN_LIST without_${package})
            set(expected FALSE)
        endif()
        set(found FALSE)
        if(targets MATCHES "scree_${component}[\n: ]")
            set(found TRUE)
        endif()
        if(NOT found STREQUAL expected)
            message(FATAL_ERROR "without ${package}: scree_${component} is there: ${found}, expected: ${expected}")
        endif()
    endforeach()
endforeach()
