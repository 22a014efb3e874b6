#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace scree {

/// A file that grows at its end. Throws OutputError for whatever goes wrong.
class AppendedFile {
  public:
    /// An empty one, in place of what is there.
    explicit AppendedFile(std::filesystem::path file);
    /// What is there, cut back to its first `kept` bytes, which it must have.
    AppendedFile(std::filesystem::path file, std::uint64_t kept);
    ~AppendedFile();
    AppendedFile(const AppendedFile&) = delete;
    AppendedFile& operator=(const AppendedFile&) = delete;

    /// Hands all of the bytes to the system.
    void append(std::string_view bytes);
    /// Returns when all of it is on the disk.
    void sync();
    /// For when nothing more may go wrong.
    void close();

    /// [bytes]
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// Where it is.
    [[nodiscard]] const std::filesystem::path& path() const { return file_; }

  private:
    void open(int flags);
    [[noreturn]] void fail() const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace scree
