#include <scree/output/appended_file.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <scree/output/output_folder.hpp>

namespace scree {

AppendedFile::AppendedFile(std::filesystem::path file) : file_(std::move(file)) {
    open(O_CREAT | O_TRUNC);
}

AppendedFile::AppendedFile(std::filesystem::path file, std::uint64_t kept)
    : file_(std::move(file)), size_(kept) {
    open(0);
    struct stat found {};
    if (::fstat(descriptor_, &found) != 0) {
        fail();
    }
    if (static_cast<std::uint64_t>(found.st_size) < kept) {
        throw OutputError(file_, std::to_string(found.st_size) + " bytes",
                          "at least " + std::to_string(kept) + ", as of the checkpoint");
    }
    if (::ftruncate(descriptor_, static_cast<off_t>(kept)) != 0) {
        fail();
    }
}

AppendedFile::~AppendedFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

void AppendedFile::open(int flags) {
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | flags, 0666);
    if (descriptor_ < 0) {
        fail();
    }
}

void AppendedFile::fail() const {
    throw OutputError(file_, std::strerror(errno));
}

void AppendedFile::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            fail();
        }
        if (written > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
            size_ += static_cast<std::uint64_t>(written);
        }
    }
}

void AppendedFile::sync() {
    if (::fsync(descriptor_) != 0) {
        fail();
    }
}

void AppendedFile::close() {
    if (::close(std::exchange(descriptor_, -1)) != 0) {
        fail();
    }
}

}  // namespace scree
