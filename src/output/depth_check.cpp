#include "depth_check.hpp"

#include <nlohmann/json.hpp>

namespace scree {

namespace {

using Json = nlohmann::json;

/// Stops the parser where it goes too deep.
class DepthCheck final : public nlohmann::json_sax<Json> {
  public:
    explicit DepthCheck(std::size_t most) : most_(most) {}

    [[nodiscard]] bool too_deep() const { return depth_ > most_; }

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t /*value*/) override { return true; }
    bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool key(string_t& /*name*/) override { return true; }
    bool start_object(std::size_t /*count*/) override { return ++depth_ <= most_; }
    bool start_array(std::size_t /*count*/) override { return ++depth_ <= most_; }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t /*where*/, const std::string& /*token*/,
                     const Json::exception& /*error*/) override {
        return false;
    }

  private:
    bool close() {
        --depth_;
        return true;
    }

    std::size_t most_;
    std::size_t depth_ = 0;
};

}  // namespace

bool nests_deeper(std::string_view cbor, std::size_t most) {
    DepthCheck check(most);
    Json::sax_parse(cbor.begin(), cbor.end(), &check, Json::input_format_t::cbor);
    return check.too_deep();
}

}  // namespace scree
