#pragma once
// SPDX-License-Identifier: Apache-2.0
// What is wrong with a file that is not TOML, in words of who writes it instead of the parser's. Pure.

#include "base/result.h"

#include <string>
#include <toml++/toml.h>

namespace ghost::scene {

// line: of the fault, to be put behind the file's name.
struct TomlProblem {
    std::string what; // "is not TOML: a quotation mark is missing ..."
    int line = 0;
};
TomlProblem toml_problem(const toml::parse_error& problem);

} // namespace ghost::scene
