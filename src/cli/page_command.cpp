#include <cstdio>

#include <scree/output/output_folder.hpp>
#include <scree/output/page.hpp>

#include "commands.hpp"

namespace scree {

int page_command(const PageRequest& request) {
    const OutputFolder folder(request.folder, OutputFolder::Contents::kept);
    const std::filesystem::path file =
        request.out.empty() ? folder.file("page.html") : std::filesystem::path(request.out);
    write_whole(file, page_of_run(folder.path()));
    if (!request.quiet) {
        std::printf("%s\n", file.c_str());
    }
    return exit_done;
}

}  // namespace scree
