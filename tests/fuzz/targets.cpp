#include <tests/fuzz/targets.hpp>

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include <scree/mesh_io/describe_mesh.hpp>
#include <scree/output/checkpoint.hpp>
#include <scree/scenes/describe_scene.hpp>
#include <scree/scenes/read_scene.hpp>

#include <src/mesh_io/check_ply.hpp>
#include <src/mesh_io/collada_asset.hpp>

#include <tests/scenes/small_scene.hpp>

namespace scree::test {

namespace {

constexpr std::size_t most_bodies = 100;
constexpr std::size_t longest_message = 600;
constexpr const char* endings[] = {"obj", "stl", "ply", "dae", "gltf", "glb"};

void check_message(const std::string& message) {
    const bool one_line = message.find('\n') == std::string::npos;
    if (!one_line || message.size() > longest_message || message.find("expected") == std::string::npos) {
        std::fprintf(stderr, "a bad error message: %s\n", message.c_str());
        std::abort();
    }
}

bool is_small(const SceneDescription& scene) {
    std::size_t bodies = scene.bodies.size();
    for (const FillDescription& fill : scene.fill) {
        bodies += fill.count;
    }
    for (const auto& [name, shape] : scene.shapes) {
        if (std::holds_alternative<MeshShape>(shape)) {
            return false;  // the file may be any
        }
    }
    return bodies <= most_bodies;
}

/// Runs `work`, which may refuse with one line.
template <class Error, class Work>
void refusing(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        check_message(error.what());
    }
}

/// A file that goes away.
class File {
  public:
    File(const std::string& ending, std::string_view bytes)
        : path_(std::filesystem::temp_directory_path() /
                ("scree_fuzz_" + std::to_string(::getpid()) + "." + ending)) {
        std::ofstream(path_, std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    ~File() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// The state of a small run after two ticks.
SavedState small_state() {
    Simulation simulation(small_scene_with({"output.replay=false"}));
    simulation.advance();
    simulation.advance();
    return simulation.save();
}

/// Each ten bytes are a place and what is put there.
SavedState changed(SavedState state, std::string_view bytes) {
    struct Change {
        std::uint16_t place;
        std::uint64_t value;
    };
    constexpr std::size_t size = 10;
    for (; bytes.size() >= size; bytes.remove_prefix(size)) {
        Change change{};
        std::memcpy(&change.place, bytes.data(), sizeof change.place);
        std::memcpy(&change.value, bytes.data() + sizeof change.place, sizeof change.value);
        if (const std::size_t place = change.place / 2; change.place % 2 == 0) {
            state.counts[place % state.counts.size()] = change.value;
        } else {
            std::memcpy(&state.numbers[place % state.numbers.size()], &change.value, sizeof change.value);
        }
    }
    return state;
}

}  // namespace

void try_scene(std::string_view bytes) {
    refusing<SceneError>([&] {
        const SceneDescription scene = parse_scene(bytes, "fuzz.json");
        if (is_small(scene)) {
            describe_scene(Simulation(scene));
        }
    });
}

void try_mesh(std::string_view bytes) {
    if (bytes.empty()) {
        return;
    }
    const auto kind = static_cast<unsigned char>(bytes.front()) % std::size(endings);
    const File file(endings[kind], bytes.substr(1));
    // In this process too what has no need of another.
    refusing<MeshError>([&] { check_ply(file.path()); });
    refusing<MeshError>([&] { check_collada_asset(file.path()); });
    refusing<MeshError>([&] { describe_mesh(file.path()); });
}

void try_checkpoint(std::string_view bytes) {
    static const SavedState good = small_state();
    refusing<CheckpointError>([&] { parse_checkpoint(bytes); });
    refusing<CheckpointError>([&] { parse_checkpoint(sealed_checkpoint(bytes)); });
    Simulation simulation(small_scene_with({"output.replay=false"}));
    try {
        simulation.restore(changed(good, bytes));
    } catch (const StateError&) {
    }
}

}  // namespace scree::test
