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
        DESTINATION ${CMAKE_INSTALL_DATADIR}/scree FILES_MATCHING PATTERN scene.json PATTERN *.obj)
    install(FILES ${PROJECT_SOURCE_DIR}/src/scenes/scene.schema.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/scree)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/scree-config.cmake.in
    ${PROJECT_BINARY_DIR}/scree-config.cmake INSTALL_DESTINATION ${package_dir})
# Below 1.0 a minor version may break a user's program.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scree-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/scree-config.cmake ${PROJECT_BINARY_DIR}/scree-config-version.cmake
    ${PROJECT_SOURCE_DIR}/src/cmake/scree_bullet.cmake DESTINATION ${package_dir})
install(FILES ${PROJECT_BINARY_DIR}/include/scree/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
