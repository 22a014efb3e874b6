#include <CLI/CLI.hpp>
#include <charconv>
#include <functional>
#include <iostream>

#include <scree/output/output_folder.hpp>
#include <scree/scenes/scene_error.hpp>
#include <scree/version.hpp>

#include "commands.hpp"

namespace {

using namespace scree;

constexpr int most_threads = 1024;
constexpr double largest_number = 1e30;   // as in a scene
constexpr double smallest_scale = 1e-30;  // likewise

/// Exactly one line, whatever a name or a library put into the text.
int report_error(std::string text, int status) {
    for (char& c : text) {
        c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    std::cerr << "scree: " << text << std::endl;
    return status;
}

/// The command line, and the command that it asks for.
class CommandLine {
  public:
    CommandLine() {
        app_.set_version_flag("--version", std::string("scree ") + version);
        app_.require_subcommand(1);
        add_run();
        add_resume();
        add_picture();
        add_page();
        add_check();
        add_mesh();
        add_list();
        add_report();
    }

    int run(int count, char** words) {
        try {
            app_.parse(count, words);
        } catch (const CLI::ParseError& error) {
            if (error.get_exit_code() == 0) {
                return app_.exit(error);  // help or the version was asked for
            }
            const bool without = app_.get_subcommands().empty();
            return report_error(without ? without_command(count, words) : error.what(), exit_bad_input);
        }
        return command_();
    }

  private:
    std::string without_command(int count, char** words) const {
        std::string names;
        for (const CLI::App* sub : app_.get_subcommands(nullptr)) {
            names += (names.empty() ? "" : ", ") + sub->get_name();
        }
        const std::string found = count > 1 ? std::string("\"") + words[1] + "\"" : "no command";
        return "found " + found + ", expected one of " + names;
    }

    /// A plain number from `least` to what a scene may have at most.
    static CLI::Validator number(double least, const std::string& name, const std::string& expected) {
        return {[least, expected](const std::string& text) {
                    double value = 0;
                    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
                    const bool whole = error == std::errc() && end == text.data() + text.size();
                    const bool good = whole && value >= least && value <= largest_number;
                    return good ? "" : "found " + text + ", expected " + expected;
                },
                name};
    }

    CLI::App* add(const char* name, const char* purpose, std::function<int()> command) {
        CLI::App* sub = app_.add_subcommand(name, purpose);
        sub->add_flag("--quiet", run_.quiet, "No progress and no closing line");
        sub->callback([this, command = std::move(command)] { command_ = command; });
        return sub;
    }

    void add_scene(CLI::App& sub) {
        sub.add_option("SCENE", run_.scene, "A scene file, or the name of a scene that comes with scree")
            ->required();
        sub.add_option("--set", run_.settings, "Change the scene: KEY=VALUE with a dotted path")
            ->allow_extra_args(false)
            ->take_all();
    }

    void add_run() {
        CLI::App* sub = add("run", "Run a scene", [this] { return run_command(run_); });
        add_scene(*sub);
        sub->add_option("--out", run_.out, "The folder to write to (out/<scene name>)");
        add_limits(*sub);
    }

    void add_limits(CLI::App& sub) {
        sub.add_option("--until", run_.until, "Stop at the last output time up to this one [s]")
            ->check(number(0, "SECONDS", "seconds, not below 0"));
        sub.add_option("--threads", run_.threads, "Threads to use; the results are the same for any number")
            ->check(CLI::Range(1, most_threads));
    }

    void add_resume() {
        CLI::App* sub = add("resume", "Go on with a run from its last checkpoint", [this] {
            return resume_command({run_.out, run_.until, run_.threads, run_.quiet});
        });
        sub->add_option("DIR", run_.out, "The folder that the run writes to")->required();
        add_limits(*sub);
    }

    void add_picture() {
        CLI::App* sub = add("picture", "Take a picture of a run, by f3d, or a model of one moment", [this] {
            picture_.quiet = run_.quiet;
            return picture_command(picture_);
        });
        sub->add_option("DIR", picture_.folder, "The folder that the run has written")->required();
        sub->add_option("--at", picture_.at, "The time that it shows [s]")
            ->check(number(0, "SECONDS", "seconds, not below 0"));
        sub->add_option("--out", picture_.out, "The file to write, .png or .glb (DIR/picture.png)");
    }

    void add_page() {
        CLI::App* sub = add("page", "Make one HTML file of a run, which plays it in a browser", [this] {
            page_.quiet = run_.quiet;
            return page_command(page_);
        });
        sub->add_option("DIR", page_.folder, "The folder that the run has written")->required();
        sub->add_option("--out", page_.out, "The file to write (DIR/page.html)");
    }

    void add_check() {
        add_scene(*add("check", "Load a scene, say what it will use and leave out, and run nothing",
                       [this] { return check_command(run_); }));
    }

    void add_mesh() {
        CLI::App* sub = add("mesh", "Say what a mesh file holds", [this] {
            mesh_.quiet = run_.quiet;
            return mesh_command(mesh_);
        });
        sub->add_option("FILE", mesh_.file, "A mesh file")->required();
        sub->add_option("--scale", mesh_.scale, "Multiply all lengths")
            ->check(number(smallest_scale, "FACTOR", "a number above 0"));
        sub->add_flag("--json", mesh_.json, "Print JSON");
    }

    void add_list() {
        add("list", "List the scenes that come with scree", [this] { return list_command(run_.quiet); });
    }

    void add_report() {
        CLI::App* sub =
            add("report", "Measure accuracy, stability and cost, and write tables and pages", [this] {
                report_.quiet = run_.quiet;
                return report_command(report_);
            });
        sub->add_option("PART", report_.part, "accuracy, stability, cost or all")
            ->required()
            ->check(CLI::IsMember({"accuracy", "stability", "cost", "all"}));
        sub->add_flag("--quick", report_.quick, "Fewer cases and shorter runs");
        sub->add_option("--out", report_.out,
                        "The folder to write to (out/report); what it has is gone on with");
        sub->add_option("--only", report_.only, "Measure this problem, axis or table alone")
            ->allow_extra_args(false)
            ->take_all();
    }

    void add_absent(const char* name, const char* purpose) {
        add(name, purpose, [name] {
            return report_error(std::string(name) + ": not in this build", exit_bad_input);
        })->allow_extras();
    }

    CLI::App app_{"scree: discrete elements of polyhedra, loaded from meshes, over Bullet", "scree"};
    RunRequest run_;
    MeshRequest mesh_;
    PictureRequest picture_;
    PageRequest page_;
    ReportOrder report_;
    std::function<int()> command_;
};

}  // namespace

int main(int count, char** words) {
    try {
        return CommandLine().run(count, words);
    } catch (const SceneError& error) {
        return report_error(error.what(), exit_bad_input);
    } catch (const std::exception& error) {
        return report_error(error.what(), exit_not_written);
    }
}
