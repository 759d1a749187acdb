#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of the air in show.toml: [haze], [[hazer]], and whether light bounces in it, [light]. As in
// show_edit.h: each function gives the whole new text, of which the rest stays byte for byte. Units as in
// docs/reference/show-file.md. Error, of all of them: no TOML, or written in a way that cannot be edited.
// Pure, any thread.

#include "base/result.h"
#include "show/bounce_detail.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct Hazer;

// What is set is written, anything else stays.
struct HazeEdit {
    std::optional<std::string> preset;     // how thick: by name,
    std::optional<float> extinction_per_m; // or like this; other ways to say it go
    std::optional<float> unevenness;
    std::optional<float> patch_m;
    std::optional<glm::vec3> wind_m_s;
};
Result<std::string> edit_haze(const std::string& text, const HazeEdit& edit);

struct HazerEdit {
    std::optional<glm::vec3> position_m;
    std::optional<glm::vec3> direction;
    std::optional<float> rate;
    std::optional<float> spread_deg;
    std::optional<float> reach_m;
};
// hazers: those of the show that was read from the text; index: of them. Error: there is no such one, or the
// text has one that could not be read, so that which is which is not known.
Result<std::string> edit_hazer(const std::string& text, const std::vector<Hazer>& hazers, std::size_t index,
                               const HazerEdit& edit);
// Behind the last one. Error: the show has as many as it may have.
Result<std::string> add_hazer(const std::string& text, const Hazer& hazer);
Result<std::string> remove_hazer(const std::string& text, const std::vector<Hazer>& hazers,
                                 std::size_t index);

Result<std::string> edit_bounce(const std::string& text, BounceDetail detail);

} // namespace ghost::scene
