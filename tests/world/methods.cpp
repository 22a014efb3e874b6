#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
    std::ifstream file(path);
    REQUIRE(file.good());
    std::ostringstream all;
    all << file.rdbuf();
    return all.str();
}

std::string without_comments(const std::string& text) {
    const std::string lines = std::regex_replace(text, std::regex("//[^\n]*"), "");
    return std::regex_replace(lines, std::regex("/\\*[^*]*\\*+([^/*][^*]*\\*+)*/"), "");
}

// The name before the first parenthesis of a declaration; empty for what is no method of its own.
std::string declared_name(const std::string& declaration) {
    std::smatch found;
    if (!std::regex_search(declaration, found, std::regex("(~?\\w+)\\s*\\("))) {
        return "";
    }
    const std::string name = found[1];
    return name.front() == '~' || name.substr(0, 3) == "BT_" ? "" : name;
}

// The public methods of a class, but for constructors and the destructor.
std::set<std::string> public_methods(const fs::path& header, const std::string& name) {
    const std::string text = without_comments(contents(header));
    std::smatch head;
    REQUIRE(std::regex_search(text, head, std::regex("\\b" + name + "\\b[^;{}()]*\\{")));
    std::set<std::string> methods;
    std::string declaration;
    bool open = false;
    int depth = 1;
    for (auto at = head[0].second; depth > 0; ++at) {
        REQUIRE(at != text.end());
        const bool own = depth == 1;
        depth += *at == '{' ? 1 : (*at == '}' ? -1 : 0);
        if (!own) {
            continue;
        }
        declaration += *at;
        if (std::smatch access;
            std::regex_search(declaration, access, std::regex("(public|protected|private)\\s*:$"))) {
            open = access[1] == "public";
            declaration.clear();
        } else if (*at == ';' || *at == '{') {
            if (open && declared_name(declaration) != name) {
                methods.insert(declared_name(declaration));
            }
            declaration.clear();
        }
    }
    methods.erase("");
    return methods;
}

struct Row {
    std::string here, how, test;
};

std::map<std::string, Row> table() {
    std::map<std::string, Row> rows;
    std::istringstream text(contents(fs::path(SCREE_SOURCE_DIR) / "demos/guide/bullet_methods.md"));
    const std::regex form("^\\| (\\w+) \\| (works|differs|refused) \\| (.*?) ?\\| (.+) \\|$");
    for (std::string line; std::getline(text, line);) {
        if (std::smatch found; std::regex_match(line, found, form)) {
            CHECK(rows.emplace(found[1], Row{found[2], found[3], found[4]}).second);
        }
    }
    return rows;
}

}  // namespace

TEST_CASE("the table of methods has all of Bullet's public ones and no others") {
    const fs::path include(SCREE_BULLET_INCLUDE);
    std::set<std::string> methods;
    for (const auto& [header, name] :
         {std::pair("BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h", "btDiscreteDynamicsWorld"),
          std::pair("BulletDynamics/Dynamics/btDynamicsWorld.h", "btDynamicsWorld"),
          std::pair("BulletCollision/CollisionDispatch/btCollisionWorld.h", "btCollisionWorld")}) {
        methods.merge(public_methods(include / header, name));
    }
    CHECK(methods.size() > 60);
    const std::map<std::string, Row> rows = table();
    for (const std::string& method : methods) {
        INFO(method);
        CHECK(rows.contains(method));
    }
    for (const auto& [method, row] : rows) {
        INFO(method);
        CHECK(methods.contains(method));
        CHECK((row.here == "works" || !row.how.empty()));
    }
}

TEST_CASE("every row of the table of methods names a test that there is") {
    std::string tests;
    for (const auto& entry : fs::directory_iterator(fs::path(SCREE_SOURCE_DIR) / "tests/world")) {
        if (entry.path().extension() == ".cpp" && entry.path().filename() != "methods.cpp") {
            tests += contents(entry.path());
        }
    }
    tests = std::regex_replace(tests, std::regex("\"\\s*\n\\s*\""), "");  // names broken over lines
    for (const auto& [method, row] : table()) {
        INFO(method << ": " << row.test);
        CHECK(tests.find("TEST_CASE(\"" + row.test + "\"") != std::string::npos);
    }
}
