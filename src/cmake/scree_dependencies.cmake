# The libraries that scree stands on. Debian's packages give all of them.

find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(Qhull CONFIG REQUIRED)
find_package(assimp CONFIG REQUIRED)
find_package(nlohmann_json 3.11 CONFIG REQUIRED)
find_package(CLI11 2 CONFIG REQUIRED)
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)  # used as headers alone
mark_as_advanced(XXHASH_INCLUDE_DIR)
find_package(VTK 9 QUIET COMPONENTS CommonCore CommonDataModel IOXML)  # without it no frames for ParaView
include(scree_bullet)
if(scree_bullet_missing)
    message(FATAL_ERROR "${scree_bullet_missing}")
endif()
