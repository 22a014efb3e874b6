#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace scree::test {

inline std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// A folder of one test's own, which goes when the test ends.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "scree_test_XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file and returns its path.
    [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name) << text;
        return *this / name;
    }

  private:
    std::filesystem::path path_;
};

/// The program, running; what it prints goes to files in a folder.
class Child {
  public:
    enum class Words {
        arguments,  ///< of the program
        whole,      ///< another program first
    };
    Child(const Folder& folder, std::vector<std::string> words, Words kind = Words::arguments)
        : folder_(folder) {
        if (kind == Words::arguments) {
            words.insert(words.begin(), program());
        }
        std::vector<char*> arguments;
        arguments.reserve(words.size() + 1);
        for (std::string& word : words) {
            arguments.push_back(word.data());
        }
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t files{};
        posix_spawn_file_actions_init(&files);
        constexpr int create = O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, 1, (folder / "stdout").c_str(), create, 0600);
        posix_spawn_file_actions_addopen(&files, 2, (folder / "stderr").c_str(), create, 0600);
        posix_spawn(&process_, arguments[0], &files, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&files);
    }

    /// Waits for it; its exit status, or minus the signal that ended it.
    int wait() const {
        int status = 0;
        waitpid(process_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    void send(int signal) const { kill(process_, signal); }
    [[nodiscard]] std::string output() const { return text_of(folder_ / "stdout"); }
    [[nodiscard]] std::string errors() const { return text_of(folder_ / "stderr"); }

    /// The build puts it into the folder above that of the tests.
    static std::string program() {
        const auto self = std::filesystem::read_symlink("/proc/self/exe");
        return (self.parent_path().parent_path() / "scree").string();
    }

  private:
    const Folder& folder_;
    pid_t process_ = 0;
};

}  // namespace scree::test
