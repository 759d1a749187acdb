#pragma once
// SPDX-License-Identifier: Apache-2.0
// The sections of show.toml that say how the scene looks: [scene], [haze], [[hazer]], [light], [attenuation],
// [shadows], [[object]]. Values out of range are left out, with a message. Pure; part of show_toml.

#include "base/report.h"
#include "json_xml_toml/toml_reader.h"

#include <string>

namespace ghost::scene {

struct Show;

inline constexpr double kMaxAmbient_lux = 200'000;

// ambient_where: file:line of [show] ambient_lux, which show has already; empty where there is none.
void read_scene_sections(TableReader& top, const std::string& file, const std::string& ambient_where,
                         Show& show, Report& report);

// [[model]]: Show::models. One without a file is left out, with a message.
void read_models(TableReader& top, const std::string& file, Show& show, Report& report);

} // namespace ghost::scene
