#pragma once
// SPDX-License-Identifier: Apache-2.0
// TableReader: typed, range-checked reading of one TOML table. Whatever is wrong (type, range, missing or
// unknown key) goes to the report with file and line, and the caller keeps its default. Call finish() last:
// it reports the keys nobody asked for, with the nearest one that was.

#include "base/report.h"

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <vector>

namespace ghost::scene {

class TableReader {
public:
    // section: for messages, "[haze]". The table must outlive the reader.
    TableReader(const toml::table& table, std::string section, std::string file, Report& report)
        : table_(table), section_(std::move(section)), file_(std::move(file)), report_(report) {}

    bool has(const std::string& key);
    bool is_number(const std::string& key); // there, and one number

    // Nothing where the key is absent or its value is no use. Limits are inclusive; NaN and infinity are
    // refused.
    std::optional<double> number(const std::string& key, double low, double high);
    std::optional<int> integer(const std::string& key, int low, int high);
    std::optional<bool> boolean(const std::string& key);
    // [red, green, blue], each 0 to 1, linear in Rec.709 primaries (as glTF has it), or "#rrggbb", sRGB as on
    // a screen. Comes back as linear Rec.2020.
    std::optional<glm::vec3> colour(const std::string& key);
    std::optional<std::string> text(const std::string& key); // at most 1000 bytes, no control characters
    std::optional<glm::vec3> vec3(const std::string& key, double limit); // components in -limit .. limit
    // Linear Rec.2020 and not below 0; a filter, or light of any strength up to 1000.
    std::optional<glm::vec3> light_colour(const std::string& key);
    // A table of names, each with a number from 0 to 1: { "Iris" = 0.5 }. Empty: there is none, or too many.
    std::map<std::string, float> fractions(const std::string& key, std::size_t at_most);
    std::optional<std::vector<double>> numbers(const std::string& key, std::size_t count, double low,
                                               double high);
    std::optional<std::vector<int>> integers(const std::string& key, std::size_t count, int low, int high);
    // A list of whole numbers from 0 to 255.
    std::optional<std::vector<std::uint8_t>> bytes(const std::string& key, std::size_t at_most);
    std::optional<std::vector<glm::vec3>> vec3_list(const std::string& key, std::size_t at_least,
                                                    std::size_t at_most, double limit);
    std::optional<std::vector<std::string>> texts(const std::string& key, std::size_t at_most);
    // [[universe, address], ...], each at least low and at most high.
    std::optional<std::vector<glm::ivec2>> pairs(const std::string& key, std::size_t at_most, glm::ivec2 low,
                                                 glm::ivec2 high);
    const toml::table* table(const std::string& key);
    std::vector<const toml::table*> tables(const std::string& key, std::size_t at_most); // [[key]]

    // The key is missing and the picture needs it.
    void missing(const std::string& key, const std::string& expectation);
    void problem(Severity severity, const std::string& key, const std::string& what);
    void finish();
    // As of all that goes to this report: base/suggest.h, Suggestions.
    std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

    int line() const;                                // of the table
    int line_of(const std::string& key) const;       // of the key's value, or of the table
    std::string where(const std::string& key) const; // file:line

private:
    const toml::node* find(const std::string& key);
    void wrong(const std::string& key, const std::string& expectation);

    const toml::table& table_;
    std::string section_;
    std::string file_;
    Report& report_;
    std::vector<std::string> known_;
};

std::string file_line(const std::string& file, int line);

} // namespace ghost::scene
