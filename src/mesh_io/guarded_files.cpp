#include "guarded_files.hpp"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <assimp/IOStream.hpp>

namespace scree {

namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 30;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

class GuardedStream : public Assimp::IOStream {
  public:
    GuardedStream(std::FILE* file, std::uintmax_t size) : file_(file), size_(size) {}

    std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
        constexpr int most_in_vain = 100;
        const std::size_t got = std::fread(buffer, size, count, file_.get());
        in_vain_ = got == 0 ? in_vain_ + 1 : 0;
        if (in_vain_ > most_in_vain) {
            throw std::runtime_error("the file ends too early");
        }
        return got;
    }
    std::size_t Write(const void* /*buffer*/, std::size_t /*size*/, std::size_t /*count*/) override {
        return 0;
    }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const int from = origin == aiOrigin_SET ? SEEK_SET : origin == aiOrigin_CUR ? SEEK_CUR : SEEK_END;
        return std::fseek(file_.get(), static_cast<long>(offset), from) == 0 ? aiReturn_SUCCESS
                                                                             : aiReturn_FAILURE;
    }
    [[nodiscard]] std::size_t Tell() const override {
        return static_cast<std::size_t>(std::ftell(file_.get()));
    }
    [[nodiscard]] std::size_t FileSize() const override { return size_; }
    void Flush() override {}

  private:
    std::unique_ptr<std::FILE, CloseFile> file_;
    std::uintmax_t size_;
    int in_vain_ = 0;  // reads in a row that gave nothing
};

}  // namespace

std::string GuardedFiles::obstacle(const std::string& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        return "found no such file";
    }
    if (!std::filesystem::is_regular_file(status)) {
        return "found something that is no file";
    }
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) {
        return "it cannot be read (" + error.message() + ")";
    }
    if (size == 0) {
        return "found an empty file";
    }
    if (size > largest_file) {
        return "found " + std::to_string(size) + " bytes, more than " + std::to_string(largest_file);
    }
    const std::unique_ptr<std::FILE, CloseFile> opened(std::fopen(file.c_str(), "rb"));
    return opened ? "" : "it cannot be read (" + std::generic_category().message(errno) + ")";
}

bool GuardedFiles::Exists(const char* file) const {
    return obstacle(file).empty();
}

char GuardedFiles::getOsSeparator() const {
    return '/';
}

Assimp::IOStream* GuardedFiles::Open(const char* file, const char* mode) {
    if (std::string_view(mode).find_first_of("wa+") != std::string_view::npos || !Exists(file)) {
        return nullptr;
    }
    std::FILE* opened = std::fopen(file, "rb");
    return opened != nullptr ? new GuardedStream(opened, std::filesystem::file_size(file)) : nullptr;
}

void GuardedFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

}  // namespace scree
