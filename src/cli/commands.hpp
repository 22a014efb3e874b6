#pragma once

#include <optional>
#include <string>
#include <vector>

namespace scree {

// What a command's process ends with.
enum ExitStatus {
    exit_done = 0,
    exit_bad_input = 2,    ///< nothing was run
    exit_failed = 3,       ///< the run could not hold its tolerances
    exit_not_written = 4,  ///< reading or writing failed
    exit_interrupted = 130,
};

/// What the user typed.
struct RunRequest {
    std::string scene;
    std::string out;              ///< empty: out/<scene name>
    std::optional<double> until;  ///< [s]
    std::vector<std::string> settings;
    int threads = 1;
    bool quiet = false;
};

struct ResumeRequest {
    std::string folder;
    std::optional<double> until;  ///< [s]
    int threads = 1;
    bool quiet = false;
};

struct PictureRequest {
    std::string folder;
    double at = 0;    ///< [s]
    std::string out;  ///< empty: picture.png in the folder
    bool quiet = false;
};

struct PageRequest {
    std::string folder;
    std::string out;  ///< empty: page.html in the folder
    bool quiet = false;
};

struct MeshRequest {
    std::string file;
    double scale = 1;
    bool json = false;
    bool quiet = false;
};

struct ReportOrder {
    std::string part;  ///< accuracy, stability, cost or all
    std::string out = "out/report";
    std::vector<std::string> only;
    bool quick = false;
    bool quiet = false;
};

// The commands. Each returns its exit status, and throws SceneError or OutputError.
int run_command(const RunRequest& request);
int resume_command(const ResumeRequest& request);
int picture_command(const PictureRequest& request);
int page_command(const PageRequest& request);
int check_command(const RunRequest& request);
int mesh_command(const MeshRequest& request);
int list_command(bool quiet);
int report_command(const ReportOrder& order);

}  // namespace scree
