#include <scree/scenes/find_scene.hpp>

#include <algorithm>
#include <fstream>

#include <scree/scenes/scene_error.hpp>

namespace scree {

namespace {

namespace fs = std::filesystem;

/// Where scenes may lie: beside the program when it is installed, then in the source tree.
std::vector<fs::path> scene_folders() {
    std::vector<fs::path> folders;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        folders.push_back(program.parent_path().parent_path() / "share/scree/demos");
    }
#ifdef SCREE_SOURCE_DIR
    folders.emplace_back(fs::path(SCREE_SOURCE_DIR) / "demos");
#endif
    return folders;
}

std::string first_comment(const fs::path& file) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (const std::size_t mark = line.find("// "); mark != std::string::npos) {
            return line.substr(mark + 3);
        }
    }
    return "";
}

}  // namespace

std::vector<ShippedScene> shipped_scenes() {
    std::vector<ShippedScene> scenes;
    for (const fs::path& folder : scene_folders()) {
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(folder, error)) {
            const fs::path file = entry.path() / "scene.json";
            const std::string name = entry.path().filename().string();
            const auto same = [&](const ShippedScene& scene) { return scene.name == name; };
            if (fs::exists(file, error) && std::none_of(scenes.begin(), scenes.end(), same)) {
                scenes.push_back({name, first_comment(file), file});
            }
        }
    }
    std::sort(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return scenes;
}

fs::path find_scene(const std::string& scene) {
    std::error_code error;
    if (fs::is_regular_file(scene, error)) {
        return scene;
    }
    std::string names;
    for (const ShippedScene& shipped : shipped_scenes()) {
        if (shipped.name == scene) {
            return shipped.file;
        }
        names += ", " + shipped.name;
    }
    throw SceneError(scene, "no such file", "a scene file or one of the scenes that come with scree" + names);
}

std::string scene_name(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
    const std::string stem = file.stem().string();
    const std::string folder = whole.parent_path().filename().string();
    return stem == "scene" && !folder.empty() ? folder : stem;
}

}  // namespace scree
