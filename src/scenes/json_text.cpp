#include "json_text.hpp"

#include <algorithm>
#include <fstream>

#include <scree/scenes/scene_error.hpp>

namespace scree {

namespace {

constexpr std::size_t deepest = 16;             // a scene needs six
constexpr std::size_t largest_file = 32 << 20;  // bytes
constexpr std::size_t longest_shown = 60;       // bytes

/// Builds the value while the parser reads, so that what a plain parser lets pass can be refused.
class Builder final : public nlohmann::json_sax<Json> {
  public:
    explicit Builder(Json& root) : root_(root) {}

    std::string found, expected, key_path;  ///< of what was refused
    std::size_t position = 0;               ///< where the syntax is wrong; 0: it is not the syntax

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t& /*text*/) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t& /*value*/) override { return false; }
    bool start_object(std::size_t /*count*/) override { return open(Json::object()); }
    bool start_array(std::size_t /*count*/) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        if (open_.back()->contains(name)) {
            return refuse(name, "the key twice", "it once");
        }
        keys_.back() = name;
        return true;
    }

    bool parse_error(std::size_t where, const std::string& /*token*/, const Json::exception& error) override {
        position = std::max<std::size_t>(where, 1);
        explain(error.what());
        return false;
    }

  private:
    bool add(Json value) {
        place(std::move(value));
        return true;
    }

    bool open(Json container) {
        if (open_.size() == deepest) {
            return refuse("", "a value nested " + std::to_string(deepest + 1) + " deep",
                          std::to_string(deepest) + " at most");
        }
        open_.push_back(place(std::move(container)));
        keys_.emplace_back();
        return true;
    }

    bool close() {
        open_.pop_back();
        keys_.pop_back();
        return true;
    }

    Json* place(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Json& parent = *open_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[keys_.back()] = std::move(value));
    }

    bool refuse(const std::string& key, const std::string& what, const std::string& instead) {
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const bool last = i + 1 == open_.size();
            std::string part = last ? key : keys_[i];
            if (open_[i]->is_array()) {
                part = std::to_string(open_[i]->size() - (last ? 0 : 1));
            }
            key_path += (i > 0 && !part.empty() ? "." : "") + part;
        }
        found = what;
        expected = instead;
        return false;
    }

    /// From the parser's "… while parsing value - unexpected end of input; expected string literal", or
    /// "… - invalid literal; last read: 'tru}'", where what was read may be anything.
    void explain(const std::string& reason) {
        constexpr std::string_view unexpected = "unexpected ";
        const std::size_t dash = reason.find(" - ");
        const std::string what = reason.substr(dash == std::string::npos ? 0 : dash + 3);
        const std::size_t instead = what.find("; expected ");
        if (what.starts_with(unexpected) && instead != std::string::npos) {
            found = what.substr(unexpected.size(), instead - unexpected.size());
            expected = what.substr(instead + 11);
        } else if (reason.find("number overflow") != std::string::npos && dash == std::string::npos) {
            found = "a number that is too large";
            expected = "a double";
        } else {
            found = what;
            expected = "JSON";
        }
    }

    Json& root_;
    std::vector<Json*> open_;        ///< containers not yet closed
    std::vector<std::string> keys_;  ///< the key last seen in each
};

std::string one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return line;
}

std::string shortened(std::string text) {
    if (text.size() > longest_shown) {
        text.resize(longest_shown);
        while (!text.empty() && (text.back() & 0xC0) == 0x80) {  // never half a character
            text.pop_back();
        }
        text += "…";
    }
    return text;
}

}  // namespace

Json parse_json(std::string_view text, const std::string& place, bool lines) {
    Json root;
    Builder builder(root);
    if (Json::sax_parse(text.begin(), text.end(), &builder, Json::input_format_t::json, true, true)) {
        return root;
    }
    std::string where = place;
    if (builder.position > 0 && lines) {
        const std::size_t end = std::min(builder.position - 1, text.size());
        where += ":" + std::to_string(1 + std::count(text.begin(), text.begin() + end, '\n'));
    } else if (!builder.key_path.empty()) {
        where += ": " + shortened(one_line(builder.key_path));
    }
    throw SceneError(where, shortened(one_line(builder.found)), one_line(builder.expected));
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (std::filesystem::is_directory(file) || !stream) {
        throw SceneError(file.string(), "no file that can be read", "a scene");
    }
    std::string text;
    std::string block(1 << 16, '\0');
    while (stream && text.size() <= largest_file) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        text.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad() || text.size() > largest_file) {
        throw SceneError(file.string(), "more than 32 MiB", "a scene");
    }
    return text;
}

std::string shown(const Json& value) {
    if (value.is_object()) {
        return "an object";
    }
    if (value.is_array() && value.size() > 8) {
        return "a list of " + std::to_string(value.size());
    }
    return shortened(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string in_quotes(std::string_view word) {
    return shown(Json(std::string(word)));
}

}  // namespace scree
