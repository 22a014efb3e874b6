#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <tests/support/mesh_files.hpp>

namespace scree::test {

/// A file that is no solid, and a part of the line that refuses it.
struct BadMesh {
    std::filesystem::path file;
    std::string message;
};

/// Files of every kind that are damaged, empty, hostile or flat, written to the folder.
std::vector<BadMesh> bad_meshes(const MeshFiles& files);

}  // namespace scree::test
