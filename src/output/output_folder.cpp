#include <scree/output/output_folder.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include <scree/output/appended_file.hpp>
#include <scree/output/checkpoint.hpp>
#include <scree/output/pose_spool.hpp>

namespace scree {

namespace {

namespace fs = std::filesystem;

// All that a run may write. Other files in the folder are the user's.
constexpr const char* run_files[] = {"summary.json", "bodies.csv",          "energy.csv",
                                     "contacts.csv", "replay.glb",          "frames",
                                     "frames.pvd",   Checkpoint::file_name, PoseSpool::file_name};

// So that the name is on the disk as well.
void sync_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    if (descriptor >= 0) {
        ::close(descriptor);
    }
    if (!synced) {
        throw OutputError(folder, std::strerror(errno));
    }
}

}  // namespace

OutputError::OutputError(const fs::path& file, const std::string& found, const std::string& expected)
    : std::runtime_error(file.string() + ": found " + found + ", expected " + expected) {}

OutputError OutputError::unreadable(const fs::path& file, const std::string& why) {
    return OutputError(file.string() + ": " + why);
}

OutputFolder::OutputFolder(fs::path folder, Contents contents) : folder_(std::move(folder)) {
    std::error_code error;
    if (contents == Contents::kept) {
        if (!fs::is_directory(folder_, error)) {
            throw OutputError(folder_, "no such folder", "that of a run");
        }
        return;
    }
    fs::create_directories(folder_, error);
    if (error) {
        throw OutputError(folder_, error.message());
    }
    clear();
}

void OutputFolder::clear() const {
    std::error_code error;
    for (const char* name : run_files) {
        fs::remove_all(folder_ / name, error);
        if (error) {
            throw OutputError(folder_ / name, error.message());
        }
    }
}

void write_whole(const fs::path& file, std::string_view bytes) {
    const fs::path temporary = file.string() + ".part";
    try {
        AppendedFile part(temporary);
        part.append(bytes);
        part.sync();
        part.close();
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
    if (std::rename(temporary.c_str(), file.c_str()) != 0) {
        throw OutputError(file, std::strerror(errno));
    }
    sync_folder(file.parent_path());
}

}  // namespace scree
