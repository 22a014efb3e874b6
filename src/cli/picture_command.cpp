#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <scree/output/gltf.hpp>
#include <scree/output/output_folder.hpp>

#include "commands.hpp"

namespace scree {

namespace {

namespace fs = std::filesystem;

constexpr double brightness = 1.6;  // of colours, for f3d has one weak lamp

std::string still(const fs::path& replay, double time) {
    std::ifstream stream(replay, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (bytes.empty()) {
        throw OutputError(replay, "no replay", "that of a run with \"replay\": true");
    }
    try {
        return still_of_replay(bytes, time);
    } catch (const std::runtime_error& error) {
        throw OutputError::unreadable(replay, error.what());
    }
}

/// Runs a program with its output thrown away; its exit status.
int run_program(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files{};
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    const int error = posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    int status = 0;
    return error == 0 && waitpid(process, &status, 0) == process && WIFEXITED(status) ? WEXITSTATUS(status)
                                                                                      : -1;
}

std::string listed(const Vec3& v) {
    return std::to_string(v.x()) + "," + std::to_string(v.y()) + "," + std::to_string(v.z());
}

/// By f3d, on a display of its own where there is none.
void render(const fs::path& model, const StillView& view, const fs::path& picture) {
    // From the front, the right and above; all of it within the 30 degrees that f3d sees.
    constexpr double distance = 3.9;
    const Vec3 from = view.centre + distance * view.radius * Vec3(0.42, 0.44, 0.79).normalized();
    std::vector<std::string> words = {"f3d",
                                      model.string(),
                                      "--output",
                                      picture.string(),
                                      "--resolution=960,600",
                                      "--up=+Y",
                                      "--camera-position=" + listed(from),
                                      "--camera-focal-point=" + listed(view.centre),
                                      "--camera-view-up=0,1,0",
                                      "--fxaa",
                                      "--bg-color=0.96,0.96,0.95"};
    if (std::getenv("DISPLAY") == nullptr) {
        words.insert(words.begin(), {"xvfb-run", "-a"});
    }
    if (run_program(words) != 0 || !fs::exists(picture)) {
        throw OutputError(
            picture, "no picture made by f3d",
            "it to run, from Debian's packages f3d and xvfb; a file that ends in .glb needs neither");
    }
}

}  // namespace

int picture_command(const PictureRequest& request) {
    const OutputFolder folder(request.folder, OutputFolder::Contents::kept);
    const fs::path file = request.out.empty() ? folder.file("picture.png") : fs::path(request.out);
    const std::string model = still(folder.file("replay.glb"), request.at);
    if (file.extension() == ".glb") {
        write_whole(file, model);
    } else {
        const fs::path between = file.string() + ".glb";
        write_whole(between, brightened(model, brightness));
        std::error_code ignored;
        fs::remove(file, ignored);
        render(between, view_of_still(model), file);
        fs::remove(between, ignored);
    }
    if (!request.quiet) {
        std::printf("%s\n", file.c_str());
    }
    return exit_done;
}

}  // namespace scree
