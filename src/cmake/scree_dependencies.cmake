# The libraries that scree stands on. Debian's packages give all of them. The core needs the first two; what else is
# missing leaves out the components that need it, and no more.

find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(Qhull CONFIG REQUIRED)

set(SCREE_LACKS "")  # what is missing, in words
foreach(package assimp nlohmann_json CLI11)
    set(least_assimp "")
    set(least_nlohmann_json 3.11)
    set(least_CLI11 2)
    find_package(${package} ${least_${package}} CONFIG QUIET)
    if(NOT ${package}_FOUND)
        list(APPEND SCREE_LACKS ${package})
    endif()
endforeach()
find_path(XXHASH_INCLUDE_DIR xxhash.h)  # used as headers alone
mark_as_advanced(XXHASH_INCLUDE_DIR)
if(NOT XXHASH_INCLUDE_DIR)
    list(APPEND SCREE_LACKS xxHash)
endif()
find_package(VTK 9 QUIET COMPONENTS CommonCore CommonDataModel IOXML)  # without it no frames for ParaView
include(scree_bullet)
if(scree_bullet_missing)
    list(APPEND SCREE_LACKS Bullet)
    message(STATUS "scree: ${scree_bullet_missing}")
endif()
