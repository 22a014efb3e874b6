# scree::bullet: Bullet in double precision. Debian ships it as a library of its own beside the float one, with a
# configuration file that names neither targets nor absolute paths. The installed package includes this file too.
# scree_bullet_missing says what there is not, and is empty when all is.

set(scree_bullet_missing "")
if(NOT TARGET scree::bullet)
    find_package(Bullet CONFIG QUIET CONFIGS BulletConfig-float64.cmake)
    if(NOT Bullet_FOUND)
        set(scree_bullet_missing "scree needs Bullet in double precision (BulletConfig-float64.cmake)")
    elseif(BULLET_VERSION_STRING VERSION_LESS 3.24)
        set(scree_bullet_missing "scree needs Bullet 3.24 or newer, found ${BULLET_VERSION_STRING}")
    elseif(NOT BULLET_DEFINITIONS MATCHES BT_USE_DOUBLE_PRECISION)
        set(scree_bullet_missing "scree needs Bullet in double precision, found ${Bullet_CONFIG}")
    endif()
endif()

if(NOT TARGET scree::bullet AND NOT scree_bullet_missing)
    get_filename_component(bullet_include ${BULLET_INCLUDE_DIR} ABSOLUTE BASE_DIR ${BULLET_ROOT_DIR})
    get_filename_component(bullet_library_dir ${BULLET_LIBRARY_DIRS} ABSOLUTE BASE_DIR ${BULLET_ROOT_DIR})

    add_library(scree::bullet INTERFACE IMPORTED)
    target_include_directories(scree::bullet SYSTEM INTERFACE ${bullet_include})
    target_compile_definitions(scree::bullet INTERFACE BT_USE_DOUBLE_PRECISION)
    # The file lists libraries that Debian does not build, so only those in use are named here, users first.
    foreach(bullet_name IN ITEMS BulletDynamics BulletCollision LinearMath)
        find_library(SCREE_${bullet_name} ${bullet_name}-float64 HINTS ${bullet_library_dir} REQUIRED)
        mark_as_advanced(SCREE_${bullet_name})
        target_link_libraries(scree::bullet INTERFACE ${SCREE_${bullet_name}})
    endforeach()

    # One of Bullet's extras, which decomposes meshes; scree does without it where it is missing.
    find_library(SCREE_HACD HACD-float64 HINTS ${bullet_library_dir})
    find_path(SCREE_HACD_INCLUDE HACD/hacdHACD.h HINTS ${bullet_include})
    mark_as_advanced(SCREE_HACD SCREE_HACD_INCLUDE)
    if(SCREE_HACD AND SCREE_HACD_INCLUDE)
        add_library(scree::hacd INTERFACE IMPORTED)
        target_include_directories(scree::hacd SYSTEM INTERFACE ${SCREE_HACD_INCLUDE})
        target_link_libraries(scree::hacd INTERFACE ${SCREE_HACD})
    endif()
endif()
