#include "ply_header.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <scree/mesh_io/load_mesh.hpp>

namespace scree {

namespace {

/// The next line, cut short: what follows a header may have no ends of lines.
bool next_line(std::istream& stream, std::string& line) {
    constexpr std::size_t longest = 1000;
    line.clear();
    char c = 0;
    while (line.size() < longest && stream.get(c) && c != '\n') {
        line.push_back(c);
    }
    return static_cast<bool>(stream);
}

}  // namespace

void check_ply_header(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string line;
    if (!next_line(stream, line) || !line.starts_with("ply")) {
        return;
    }
    const double bytes = static_cast<double>(std::filesystem::file_size(file));
    while (next_line(stream, line) && !line.starts_with("end_header")) {
        std::istringstream words(line);
        std::string keyword;
        std::string name;
        double count = 0;
        if (words >> keyword >> name >> count && keyword == "element" && !(count >= 0 && count <= bytes)) {
            throw MeshError(file.string() + ": found a header that announces " + line.substr(8) +
                            ", expected no more than the file's " +
                            std::to_string(std::filesystem::file_size(file)) + " bytes hold");
        }
    }
}

}  // namespace scree
