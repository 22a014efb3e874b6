# Each demos/<name>/<program>.cpp is a program of its own, built where the libraries that it needs exist.

function(scree_demos)
    if(NOT TARGET scree_scenes)
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/demos/*/*.cpp)
    foreach(source IN LISTS sources)
        get_filename_component(name ${source} NAME_WE)
        add_executable(demo_${name} ${source})
        scree_settings(demo_${name})
        target_include_directories(demo_${name} PRIVATE ${PROJECT_SOURCE_DIR})
        target_compile_definitions(demo_${name} PRIVATE SCREE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
        scree_link(demo_${name} PRIVATE scree::scenes)
    endforeach()
endfunction()

scree_demos()
