#include "import_file.hpp"

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include <assimp/config.h>
#include <assimp/importerdesc.h>

#include <scree/mesh_io/load_mesh.hpp>

#include "check_ply.hpp"
#include "collada_asset.hpp"
#include "guarded_files.hpp"
#include "shown.hpp"

// Debian builds assimp with its assertions on. They end the program, where a damaged file should end in an
// error, so this definition takes the place of assimp's. The importer catches what it throws.
namespace Assimp {

ASSIMP_API void aiAssertViolation(const char* expression, const char* file, int line);

void aiAssertViolation(const char* expression, const char* /*file*/, int /*line*/) {
    throw std::runtime_error(std::string("assimp's check failed: ") + expression);
}

}  // namespace Assimp

namespace scree {

namespace {

// We triangulate ourselves: assimp's own step aborts the program on faces without corners.
constexpr unsigned no_processing = 0;

/// One line, without the full stop at its end.
std::string sentence(std::string_view text) {
    constexpr std::size_t longest = 200;
    std::string line = shown(text, longest);
    while (!line.empty() && (line.back() == '.' || line.back() == ' ')) {
        line.pop_back();
    }
    return line.empty() ? "no reason given" : line;
}

/// Whether the file was read as the kind that has this ending.
bool read_as(const Assimp::Importer& importer, std::string_view ending) {
    const int index = importer.GetPropertyInteger("importerIndex", -1);
    if (index < 0) {
        return false;
    }
    const aiImporterDesc* kind = importer.GetImporterInfo(static_cast<std::size_t>(index));
    const std::string_view endings = kind != nullptr ? kind->mFileExtensions : "";
    return endings.find(ending) != std::string_view::npos;
}

}  // namespace

ImportedFile::ImportedFile(const std::filesystem::path& file) {
    check_ply(file);
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);  // none is a part of a surface
    importer_.SetIOHandler(new GuardedFiles);                              // the importer owns it
    std::string reason;
    try {
        scene_ = importer_.ReadFile(file.string(), no_processing);
        reason = importer_.GetErrorString();
    } catch (const std::exception& error) {
        reason = error.what();
    }
    if (scene_ == nullptr) {
        throw MeshError(file.string() + ": found no mesh in it (" + sentence(reason) +
                        "), expected a kind of mesh file that assimp reads");
    }
    if (read_as(importer_, "dae")) {
        check_collada_asset(file);
    }
    // Assimp hands these two on with y up and in metres, and other kinds as they are.
    if (read_as(importer_, "dae") || read_as(importer_, "gltf")) {
        to_z_up_ << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    }
}

}  // namespace scree
