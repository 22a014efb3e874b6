#include <scree/output/output_folder.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace scree {

namespace {

namespace fs = std::filesystem;

// All that a run may write. Other files in the folder are the user's.
constexpr const char* run_files[] = {"summary.json", "bodies.csv", "energy.csv", "contacts.csv",
                                     "replay.glb",   "frames",     "frames.pvd", "checkpoint.cbor"};

void write_all(int descriptor, const std::string& text, const fs::path& file) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
        if (written < 0 && errno != EINTR) {
            throw OutputError(file, std::strerror(errno));
        }
        done += written < 0 ? 0 : static_cast<std::size_t>(written);
    }
    if (::fsync(descriptor) != 0) {
        throw OutputError(file, std::strerror(errno));
    }
}

}  // namespace

OutputError::OutputError(const fs::path& file, const std::string& found)
    : std::runtime_error(file.string() + ": found " + found + ", expected to write it") {}

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) {
        throw OutputError(folder_, error.message());
    }
    for (const char* name : run_files) {
        fs::remove_all(folder_ / name, error);
        if (error) {
            throw OutputError(folder_ / name, error.message());
        }
    }
}

void write_whole(const fs::path& file, const std::string& text) {
    const fs::path temporary = file.string() + ".part";
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        throw OutputError(temporary, std::strerror(errno));
    }
    try {
        write_all(descriptor, text, temporary);
    } catch (...) {
        ::close(descriptor);
        ::unlink(temporary.c_str());
        throw;
    }
    if (::close(descriptor) != 0 || std::rename(temporary.c_str(), file.c_str()) != 0) {
        throw OutputError(file, std::strerror(errno));
    }
}

}  // namespace scree
