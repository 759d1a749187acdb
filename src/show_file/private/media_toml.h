#pragma once
// SPDX-License-Identifier: Apache-2.0
// The parts of show.toml about moving pictures: [[media]], the projector and the wall of a [[fixture]], and
// [[wall]]. Values out of range are left out, with a message. Pure; part of show_toml.

#include "json_xml_toml/toml_reader.h"
#include "show/show.h"

#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

// Show::media.
void read_media(TableReader& top, const std::string& file, Show& show, Report& report);

// table: projector = { .. } of a fixture. target: where it is aimed at, if it says so.
Projector read_projector(const toml::table& table, const std::string& section, const std::string& file,
                         Show& show, std::optional<glm::vec3>& target_m, Report& report);

// table: wall = { .. } of a fixture, with its size; or a [[wall]], which has none (of_plot).
LedWall read_wall(TableReader& reader, const std::string& section, const std::string& file, bool of_plot,
                  Show& show, Report& report);

// [[wall]]: what LED walls of the plot are like.
std::vector<WallSettings> read_walls(TableReader& top, const std::string& file, Show& show, Report& report);

} // namespace ghost::scene
