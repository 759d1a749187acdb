#pragma once
// SPDX-License-Identifier: Apache-2.0
// Entries of show.toml that say what becomes of objects of a plot and of fixture files: [[change]],
// [[substitute]],
// [[photometry]]. Values, and how they are read.

#include "fixture/patch.h"

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace ghost::scene {

class TableReader;

// [[change]]: what the user changes about an object of a plot. Places are world metres and degrees.
struct ChangeEntry {
    std::string uuid;
    std::string where; // file:line, for messages
    std::optional<fixture::Address> address;
    int dmx_break = 1; // as GDTF counts
    std::optional<std::string> mode;
    std::optional<std::string> name;
    std::optional<glm::vec3> position_m;
    std::optional<glm::vec3> rotation_deg;
    std::optional<bool> hidden;
    std::optional<std::string> circuit; // that feeds it (show/circuits.h)
};

ChangeEntry read_change(TableReader& reader);

// [[substitute]] of show.toml: another fixture file for all fixtures of a plot that ask for some file,
// because the plot has none, or one that says nothing of its light.
struct SubstituteEntry {
    std::string spec;           // pattern: * any letters, ? one letter; case does not count
    std::filesystem::path gdtf; // in the show's folder
    std::string mode;           // empty: the one whose name is nearest to the plot's
    std::string where;          // file:line
};

SubstituteEntry read_substitute(TableReader& reader);

// [[photometry]]: the file for all fixtures of some type.
struct PhotometryEntry {
    std::string spec;           // pattern, as for a [[substitute]]
    std::filesystem::path file; // in the show's folder
    std::string where;          // file:line
};
PhotometryEntry read_photometry(TableReader& reader);

} // namespace ghost::scene
