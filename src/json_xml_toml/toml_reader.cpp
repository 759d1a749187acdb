// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/toml_reader.h"

#include "base/suggest.h"
#include "image/colour.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxTextBytes = 1000;

std::string number_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string range_text(double low, double high) {
    return number_text(low) + " to " + number_text(high);
}

// A value as it stands in the file, shortened.
std::string shown(const toml::node& node) {
    std::ostringstream stream;
    node.visit([&](const auto& value) { stream << value; });
    std::string text; // with every run of white space as one blank
    for (const char c : stream.str()) {
        const bool blank = c == ' ' || c == '\n' || c == '\t';
        if (!blank)
            text += c;
        else if (!text.empty() && text.back() != ' ')
            text += ' ';
    }
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

std::optional<double> finite_number(const toml::node& node, double low, double high) {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value) || *value < low || *value > high) return std::nullopt;
    return value;
}

std::optional<std::vector<double>> number_list(const toml::node& node, std::size_t count, double low,
                                               double high) {
    const toml::array* array = node.as_array();
    if (!array || array->size() != count) return std::nullopt;
    std::vector<double> values;
    for (const toml::node& element : *array) {
        const auto value = finite_number(element, low, high);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

std::optional<glm::vec3> vec3_from(const toml::node& node, double limit) {
    const auto values = number_list(node, 3, -limit, limit);
    if (!values) return std::nullopt;
    return glm::vec3((*values)[0], (*values)[1], (*values)[2]);
}

// "#rrggbb" -> linear Rec.709
std::optional<glm::vec3> screen_colour(const toml::node& node) {
    const std::string text = node.value<std::string>().value_or("");
    if (text.size() != 7 || text[0] != '#' ||
        text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        return std::nullopt;
    glm::vec3 colour;
    for (int k = 0; k < 3; ++k) {
        const std::string digits = text.substr(1 + 2 * static_cast<std::size_t>(k), 2);
        colour[k] = image::srgb_to_linear(static_cast<float>(std::stoi(digits, nullptr, 16)) / 255.0f);
    }
    return colour;
}

} // namespace

std::string file_line(const std::string& file, int line) {
    return file + ":" + std::to_string(line);
}

int TableReader::line() const {
    return static_cast<int>(table_.source().begin.line);
}

int TableReader::line_of(const std::string& key) const {
    const toml::node* node = table_.get(key);
    return node ? static_cast<int>(node->source().begin.line) : line();
}

std::string TableReader::where(const std::string& key) const {
    return file_line(file_, line_of(key));
}

const toml::node* TableReader::find(const std::string& key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
    return table_.get(key);
}

bool TableReader::has(const std::string& key) {
    return find(key) != nullptr;
}

bool TableReader::is_number(const std::string& key) {
    const toml::node* node = find(key);
    return node && node->is_number();
}

void TableReader::problem(Severity severity, const std::string& key, const std::string& what) {
    report_.add(severity, where(key), section_ + " " + key + " " + what);
}

void TableReader::wrong(const std::string& key, const std::string& expectation) {
    problem(Severity::error, key, "is " + shown(*table_.get(key)) + ", expected " + expectation);
}

void TableReader::missing(const std::string& key, const std::string& expectation) {
    problem(Severity::error, key, "is missing, expected " + expectation);
}

std::optional<double> TableReader::number(const std::string& key, double low, double high) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = finite_number(*node, low, high);
    if (!value) wrong(key, "a number from " + range_text(low, high));
    return value;
}

std::optional<int> TableReader::integer(const std::string& key, int low, int high) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    if (value && *value >= low && *value <= high) return static_cast<int>(*value);
    wrong(key, "a whole number from " + range_text(low, high));
    return std::nullopt;
}

std::optional<bool> TableReader::boolean(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_boolean()) wrong(key, "true or false");
    return node->is_boolean() ? node->value<bool>() : std::nullopt;
}

std::optional<glm::vec3> TableReader::colour(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    std::optional<glm::vec3> rec709 = screen_colour(*node);
    if (const auto values = number_list(*node, 3, 0, 1))
        rec709 = glm::vec3((*values)[0], (*values)[1], (*values)[2]);
    if (rec709) return image::rec709_to_rec2020(*rec709);
    wrong(key, "a colour: [red, green, blue], each from 0 to 1, or \"#rrggbb\"");
    return std::nullopt;
}

std::optional<std::string> TableReader::text(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = node->is_string() ? node->value<std::string>() : std::nullopt;
    const bool clean = value && value->size() <= kMaxTextBytes &&
                       std::none_of(value->begin(), value->end(),
                                    [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    if (clean) return value;
    wrong(key, "a text of at most 1000 bytes without control characters");
    return std::nullopt;
}

std::optional<glm::vec3> TableReader::vec3(const std::string& key, double limit) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto value = vec3_from(*node, limit);
    if (!value) wrong(key, "three numbers [x, y, z], each from " + range_text(-limit, limit));
    return value;
}

std::optional<glm::vec3> TableReader::light_colour(const std::string& key) {
    const auto colour = vec3(key, 1000);
    if (!colour || std::min({colour->x, colour->y, colour->z}) >= 0) return colour;
    problem(Severity::error, key, "has a component below 0, expected three shares of light");
    return std::nullopt;
}

std::map<std::string, float> TableReader::fractions(const std::string& key, std::size_t at_most) {
    std::map<std::string, float> fractions;
    const toml::table* const inside = table(key);
    if (inside == nullptr) return fractions;
    if (inside->size() > at_most) {
        problem(Severity::error, key,
                "has more than " + std::to_string(at_most) + " entries; all are left out");
        return fractions;
    }
    TableReader reader(*inside, section_ + " " + key, file_, report_);
    for (const auto& [name, value] : *inside)
        if (const auto fraction = reader.number(std::string(name.str()), 0, 1))
            fractions[std::string(name.str())] = static_cast<float>(*fraction);
    return fractions;
}

std::optional<std::vector<double>> TableReader::numbers(const std::string& key, std::size_t count, double low,
                                                        double high) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    auto values = number_list(*node, count, low, high);
    if (!values)
        wrong(key, std::to_string(count) + " numbers in brackets, each from " + range_text(low, high));
    return values;
}

std::optional<std::vector<int>> TableReader::integers(const std::string& key, std::size_t count, int low,
                                                      int high) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const auto values = number_list(*node, count, low, high);
    const toml::array* array = node->as_array();
    if (values &&
        std::all_of(array->begin(), array->end(), [](const toml::node& n) { return n.is_integer(); }))
        return std::vector<int>(values->begin(), values->end());
    wrong(key, std::to_string(count) + " whole numbers in brackets, each from " + range_text(low, high));
    return std::nullopt;
}

std::optional<std::vector<std::uint8_t>> TableReader::bytes(const std::string& key, std::size_t at_most) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    std::vector<std::uint8_t> values;
    const toml::array* array = node->as_array();
    bool good = array && array->size() <= at_most;
    for (std::size_t k = 0; good && k < array->size(); ++k) {
        const auto value = array->get(k)->is_integer() ? array->get(k)->value<std::int64_t>() : std::nullopt;
        good = value && *value >= 0 && *value <= 255;
        if (good) values.push_back(static_cast<std::uint8_t>(*value));
    }
    if (good) return values;
    wrong(key, "a list of at most " + std::to_string(at_most) + " whole numbers, each from 0 to 255");
    return std::nullopt;
}

std::optional<std::vector<glm::vec3>> TableReader::vec3_list(const std::string& key, std::size_t at_least,
                                                             std::size_t at_most, double limit) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    std::vector<glm::vec3> values;
    const toml::array* array = node->as_array();
    bool good = array && array->size() >= at_least && array->size() <= at_most;
    for (std::size_t k = 0; good && k < array->size(); ++k) {
        const auto value = vec3_from(*array->get(k), limit);
        good = value.has_value();
        if (good) values.push_back(*value);
    }
    if (good) return values;
    wrong(key, "a list of " + std::to_string(at_least) + " to " + std::to_string(at_most) +
                   " points [x, y, z], each number from " + range_text(-limit, limit));
    return std::nullopt;
}

std::optional<std::vector<std::string>> TableReader::texts(const std::string& key, std::size_t at_most) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    std::vector<std::string> values;
    const toml::array* array = node->as_array();
    bool good = array && array->size() <= at_most;
    for (std::size_t k = 0; good && k < array->size(); ++k) {
        const auto value = array->get(k)->is_string() ? array->get(k)->value<std::string>() : std::nullopt;
        good = value && value->size() <= kMaxTextBytes;
        if (good) values.push_back(*value);
    }
    if (good) return values;
    wrong(key, "a list of at most " + std::to_string(at_most) + " texts");
    return std::nullopt;
}

std::optional<std::vector<glm::ivec2>> TableReader::pairs(const std::string& key, std::size_t at_most,
                                                          glm::ivec2 low, glm::ivec2 high) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    std::vector<glm::ivec2> values;
    const toml::array* array = node->as_array();
    bool good = array && array->size() <= at_most;
    for (std::size_t k = 0; good && k < array->size(); ++k) {
        const toml::array* pair = array->get(k)->as_array();
        good = pair && pair->size() == 2;
        glm::ivec2 value(0);
        for (int i = 0; good && i < 2; ++i) {
            const toml::node& item = *pair->get(static_cast<std::size_t>(i));
            const auto number = item.is_integer() ? item.value<std::int64_t>() : std::nullopt;
            good = number && *number >= low[i] && *number <= high[i];
            if (good) value[i] = static_cast<int>(*number);
        }
        values.push_back(value);
    }
    if (good) return values;
    wrong(key, "a list of at most " + std::to_string(at_most) + " pairs [" + range_text(low.x, high.x) +
                   ", " + range_text(low.y, high.y) + "]");
    return std::nullopt;
}

const toml::table* TableReader::table(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) return nullptr;
    if (!node->is_table()) wrong(key, "a table");
    return node->as_table();
}

std::vector<const toml::table*> TableReader::tables(const std::string& key, std::size_t at_most) {
    std::vector<const toml::table*> result;
    const toml::node* node = find(key);
    if (!node) return result;
    const toml::array* array = node->as_array();
    if (!array) {
        problem(Severity::error, key, "is one value, expected a list: write [[" + key + "]]");
        return result;
    }
    for (const toml::node& element : *array) {
        if (result.size() == at_most) {
            problem(Severity::error, key,
                    "has more than " + std::to_string(at_most) + " entries; the rest is left out");
            break;
        }
        if (element.is_table())
            result.push_back(element.as_table());
        else
            report_.add(Severity::error, file_line(file_, static_cast<int>(element.source().begin.line)),
                        section_ + " " + key + " has an entry that is no table: write [[" + key + "]]");
    }
    return result;
}

std::string TableReader::did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    return report_.suggestions.did_you_mean(word, candidates);
}

void TableReader::finish() {
    for (const auto& [key, node] : table_) {
        const std::string name(key.str());
        if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
        std::string text =
            section_ + " " + kUnknownKey + " '" + name.substr(0, 80) + "'" + did_you_mean(name, known_);
        if (text.back() == '\'') {
            text += ", expected one of";
            for (const std::string& known : known_) text += " " + known;
        }
        report_.add(Severity::warning, file_line(file_, static_cast<int>(node.source().begin.line)), text);
    }
}

} // namespace ghost::scene
