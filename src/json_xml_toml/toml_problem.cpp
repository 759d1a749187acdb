// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/toml_problem.h"

#include <string_view>
#include <utility>

namespace ghost::scene {
namespace {

// What the parser says, by a part of it, and what a person did.
constexpr std::pair<std::string_view, std::string_view> kInWords[] = {
    {"parsing string: unescaped control", "a quotation mark is missing"},
    {"parsing string: encountered end-of-file", "a quotation mark is missing"},
    {"could not determine value type",
     "the value is neither a number nor true nor false; text needs quotation marks around it"},
    {"parsing table header: expected ']'", "a bracket ] is missing"},
    {"parsing array: encountered end-of-file", "a list [ ... ] has no end, a bracket ] is missing"},
    {"cannot redefine existing", "it is there twice"},
};

} // namespace

TomlProblem toml_problem(const toml::parse_error& problem) {
    const std::string_view said = problem.description();
    std::string what = "is not TOML: ";
    for (const auto& [part, words] : kInWords)
        if (said.find(part) != std::string_view::npos) {
            what += words;
            return {what + " (" + std::string(said) + ")", static_cast<int>(problem.source().begin.line)};
        }
    return {what + std::string(said), static_cast<int>(problem.source().begin.line)};
}

} // namespace ghost::scene
