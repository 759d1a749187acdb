#pragma once
// SPDX-License-Identifier: Apache-2.0
// The parts of show.toml about moving pictures: [[media]], and the projector of a [[fixture]]. Values out of
// range are left out, with a message. Pure; part of show_toml.

#include "scene/show.h"
#include "scene/toml_reader.h"

#include <optional>
#include <string>

namespace ghost::scene {

// Show::media.
void read_media(TableReader& top, const std::string& file, Show& show, Report& report);

// table: projector = { .. } of a fixture. target: where it is aimed at, if it says so.
Projector read_projector(const toml::table& table, const std::string& section, const std::string& file,
                         Show& show, std::optional<glm::vec3>& target_m, Report& report);

} // namespace ghost::scene
