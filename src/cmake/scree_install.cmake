# The installed package: find_package(scree COMPONENTS core world mesh_io scenes output).

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/scree)

foreach(component IN LISTS SCREE_COMPONENTS)
    install(TARGETS scree_${component} EXPORT scree_${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(EXPORT scree_${component} NAMESPACE scree:: DESTINATION ${package_dir})
    get_target_property(component_folders scree_${component} SCREE_FOLDERS)
    foreach(folder IN LISTS component_folders)
        if(EXISTS ${PROJECT_SOURCE_DIR}/include/scree/${folder})
            install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/scree/${folder}
                DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree FILES_MATCHING PATTERN *.hpp)
        endif()
    endforeach()
endforeach()
if(TARGET scree_program)
    install(TARGETS scree_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    # The scenes that come with it, which find their meshes as they do in the source tree.
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/demos ${PROJECT_SOURCE_DIR}/meshes
        DESTINATION ${CMAKE_INSTALL_DATADIR}/scree FILES_MATCHING PATTERN scene.json PATTERN *.obj PATTERN bad EXCLUDE)
    install(FILES ${PROJECT_SOURCE_DIR}/src/scenes/scene.schema.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/scree)
endif()

# For those who build without CMake: pkg-config scree-world.
set(pc_requires_core eigen3)
set(pc_libs_core " -lqhull_r -pthread")
set(pc_requires_world scree-core)
if(TARGET scree::bullet)
    get_target_property(bullet_include scree::bullet INTERFACE_INCLUDE_DIRECTORIES)
endif()
set(pc_cflags_world " -isystem ${bullet_include} -DBT_USE_DOUBLE_PRECISION")
set(pc_libs_world " -lBulletDynamics-float64 -lBulletCollision-float64 -lLinearMath-float64")
set(pc_requires_mesh_io scree-core)
set(pc_libs_mesh_io " -lassimp")
set(pc_requires_output scree-core)
set(pc_requires_vtk scree-output)
set(pc_requires_scenes "scree-world, scree-mesh_io")
foreach(pc_component IN LISTS SCREE_COMPONENTS)
    set(pc_requires "${pc_requires_${pc_component}}")
    set(pc_libs "${pc_libs_${pc_component}}")
    set(pc_cflags "${pc_cflags_${pc_component}}")
    get_target_property(pc_folders scree_${pc_component} SCREE_FOLDERS)
    list(JOIN pc_folders ", " pc_folders)
    # The prefix is known when it is installed, not before.
    install(CODE "set(pc_component ${pc_component})
        set(pc_requires [[${pc_requires}]])
        set(pc_libs [[${pc_libs}]])
        set(pc_cflags [[${pc_cflags}]])
        set(pc_folders [[${pc_folders}]])
        set(PROJECT_DESCRIPTION [[${PROJECT_DESCRIPTION}]])
        set(PROJECT_VERSION ${PROJECT_VERSION})
        set(CMAKE_INSTALL_LIBDIR ${CMAKE_INSTALL_LIBDIR})
        set(CMAKE_INSTALL_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR})
        configure_file([[${PROJECT_SOURCE_DIR}/src/cmake/scree.pc.in]]
            [[${PROJECT_BINARY_DIR}/scree-${pc_component}.pc]] @ONLY)")
    install(FILES ${PROJECT_BINARY_DIR}/scree-${pc_component}.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/scree-config.cmake.in
    ${PROJECT_BINARY_DIR}/scree-config.cmake INSTALL_DESTINATION ${package_dir})
# Below 1.0 a minor version may break a user's program.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scree-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scree-config.cmake ${PROJECT_BINARY_DIR}/scree-config-version.cmake
    ${PROJECT_SOURCE_DIR}/src/cmake/scree_bullet.cmake DESTINATION ${package_dir})
install(FILES ${PROJECT_BINARY_DIR}/include/scree/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
