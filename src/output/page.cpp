#include <scree/output/page.hpp>

#include <charconv>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include <scree/output/output_folder.hpp>

#include "base64.hpp"
#include "glb_file.hpp"
#include "page_template.hpp"

namespace scree {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string text_of(const fs::path& file, const std::string& expected) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || fs::is_directory(file)) {
        throw OutputError(file, "no such file", expected);
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

double number_of(const std::string& cell) {
    double value = 0;
    std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return value;
}

/// The columns of a table of numbers, the first of them the times of all others.
Json columns_of(const fs::path& file) {
    std::ifstream stream(file);
    Json columns = Json::array();
    std::string line;
    std::getline(stream, line);
    for (const std::string& name : cells_of(line)) {
        columns.push_back({{"name", name}, {"times", Json::array()}, {"values", Json::array()}});
    }
    while (std::getline(stream, line)) {
        const std::vector<std::string> cells = cells_of(line);
        for (std::size_t i = 1; i < cells.size() && i < columns.size(); ++i) {
            columns[i]["times"].push_back(number_of(cells[0]));
            columns[i]["values"].push_back(number_of(cells[i]));
        }
    }
    if (!columns.empty()) {
        columns.erase(columns.begin());
    }
    return columns;
}

/// Meshes of one square are ground.
bool is_ground(const GlbFile& replay, const Json& node) {
    constexpr std::size_t square = 6;  // indices
    if (!node.contains("mesh")) {
        return false;
    }
    const Json& part = replay.json.at("meshes").at(node.at("mesh").get<std::size_t>()).at("primitives").at(0);
    return replay.json.at("accessors").at(part.at("indices").get<std::size_t>()).at("count") == square;
}

/// three.js drops some characters from names, and then takes some for the same.
std::vector<std::string> rename_nodes(GlbFile& replay) {
    std::vector<std::string> ground;
    std::size_t number = 0;
    for (Json& node : replay.json.at("nodes")) {
        const std::string name = "node_" + std::to_string(number++);
        if (is_ground(replay, node)) {
            ground.push_back(name);
        }
        node["name"] = name;
    }
    return ground;
}

Json data_of(const fs::path& folder) {
    const Json summary = Json::parse(text_of(folder / "summary.json", "that of a run"));
    GlbFile replay(text_of(folder / "replay.glb", "the replay of a run"));
    Json data;
    data["ground"] = rename_nodes(replay);
    data["duration"] = summary.at("reached");
    data["contacts"] = {{"times", Json::array()}, {"values", Json::array()}};
    if (replay.json.contains("animations")) {
        const Json& animation = replay.json["animations"].at(0);
        const Json& sampler = animation.at("samplers").at(0);
        data["contacts"] = {{"times", replay.numbers(sampler.at("input").get<std::size_t>())},
                            {"values", animation.at("extras").at("contacts")}};
    }
    data["energy"] = columns_of(folder / "energy.csv");
    std::ostringstream facts;
    facts << summary.at("bodies").size() << " bodies, " << summary.at("steps").at("accepted") << " steps in "
          << summary.at("time").at("wall").get<double>() << " s";
    data["facts"] = facts.str();
    data["name"] = summary.at("scene");
    data["replay"] = base64(replay.bytes());
    return data;
}

void replace(const std::string& mark, const std::string& with, std::string& page) {
    for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + with.size())) {
        page.replace(at, mark.size(), with);
    }
}

/// No text may end the script that it is in.
std::string in_script(std::string text) {
    replace("</", "<\\/", text);
    return text;
}

std::string in_html(std::string text) {
    replace("&", "&amp;", text);
    replace("<", "&lt;", text);
    return text;
}

}  // namespace

std::string page_of_run(const fs::path& folder, const fs::path& scripts) {
    const std::string three = "three.js, as Debian's libjs-three has it";
    try {
        const Json data = data_of(folder);
        std::string page = page_template;
        replace("@name@", in_html(data.at("name")), page);
        replace("@three@", text_of(scripts / "three.min.js", three), page);
        replace("@loader@", text_of(scripts / "examples/js/loaders/GLTFLoader.js", three), page);
        replace("@controls@", text_of(scripts / "examples/js/controls/OrbitControls.js", three), page);
        replace("@data@", in_script(data.dump(-1, ' ', false, Json::error_handler_t::replace)), page);
        return page;
    } catch (const Json::exception&) {
        throw OutputError(folder, "files that are not those of a run", "what scree run writes");
    }
}

}  // namespace scree
