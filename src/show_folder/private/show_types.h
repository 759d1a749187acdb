#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the fixtures of a show's text name: fixture files and photometry, each read once. Reads files; any
// thread.

#include "base/report.h"
#include "show_file/show_toml.h"
#include "show_folder/load_show.h"

#include <filesystem>
#include <string>

namespace ghost {
class Suggestions; // base/suggest.h
} // namespace ghost

namespace ghost::scene {

// Types and modes of the text's fixtures. known: need not be read again.
void load_types(ParsedShow& parsed, KnownTypes known, Report& report);
// Shapes of beams, of those of a plot, too.
void load_shapes(ParsedShow& parsed, Report& report);

bool is_file(const std::filesystem::path& path);
// "no such file x.glb, did you mean 'y.glb'?"
std::string missing_file(const std::filesystem::path& path);
std::string missing_file(const std::filesystem::path& path, Suggestions& suggestions); // of many files

} // namespace ghost::scene
