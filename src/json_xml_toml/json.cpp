// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/json.h"

#include <nlohmann/json.hpp>

#include <set>
#include <vector>

namespace ghost {
namespace {

constexpr std::size_t kShownBytes = 60; // of a key

class Guard : public nlohmann::json_sax<nlohmann::json> {
public:
    explicit Guard(const JsonLimits& limits) : limits_(limits) {}

    std::string problem;

    bool null() override { return count(); }
    bool boolean(bool) override { return count(); }
    bool number_integer(number_integer_t) override { return count(); }
    bool number_unsigned(number_unsigned_t) override { return count(); }
    bool number_float(number_float_t, const string_t&) override { return count(); }
    bool string(string_t&) override { return count(); }
    bool binary(binary_t&) override { return count(); }
    bool start_object(std::size_t) override { return open(); }
    bool start_array(std::size_t) override { return open(); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        if (!keys_.back().insert(name).second)
            return fail("has the key '" + name.substr(0, kShownBytes) + "' twice in one object");
        return keys_.back().size() <= limits_.members ||
               fail("has an object of more than " + std::to_string(limits_.members) + " members");
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
        const std::string words = error.what();
        const std::size_t at = words.find("parse error");
        return fail("is not JSON: " + (at == std::string::npos ? words : words.substr(at)).substr(0, 300));
    }

private:
    bool fail(std::string words) {
        problem = std::move(words);
        return false;
    }
    bool count() {
        return ++values_ <= limits_.values ||
               fail("has more than " + std::to_string(limits_.values) + " values");
    }
    bool open() {
        if (keys_.size() == limits_.depth)
            return fail("is nested deeper than " + std::to_string(limits_.depth));
        keys_.emplace_back();
        return count();
    }
    bool close() {
        keys_.pop_back();
        return true;
    }

    const JsonLimits& limits_;
    std::vector<std::set<std::string>> keys_; // of the objects around
    std::size_t values_ = 0;
};

} // namespace

Result<void> check_json(std::string_view text, const std::string& where, const JsonLimits& limits) {
    if (text.size() > limits.bytes)
        return Error{"is " + std::to_string(text.size()) + " bytes of JSON, at most " +
                         std::to_string(limits.bytes) + " are read",
                     where};
    Guard guard(limits);
    if (!nlohmann::json::sax_parse(text.begin(), text.end(), &guard)) return Error{guard.problem, where};
    return {};
}

Result<nlohmann::json> read_json(std::string_view text, const std::string& where, const JsonLimits& limits) {
    TRY_VOID(check_json(text, where, limits));
    return nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
}

Result<nlohmann::ordered_json> read_ordered_json(std::string_view text, const std::string& where,
                                                 const JsonLimits& limits) {
    TRY_VOID(check_json(text, where, limits));
    return nlohmann::ordered_json::parse(text.begin(), text.end(), nullptr, false);
}

} // namespace ghost
