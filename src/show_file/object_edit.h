#pragma once
// SPDX-License-Identifier: Apache-2.0
// An edit of show.toml: where an object of the stage stands ([[object]] move_m). As in show_edit.h: the rest
// of the text stays byte for byte. Pure, any thread.

#include "base/result.h"

#include <glm/glm.hpp>

#include <string>

namespace ghost::scene {

// move_m: from where the model has it. The entry of just that name gets it, unless a later one moves the
// object; else there is one more at the end. Error: no TOML, or written in a way that cannot be edited.
Result<std::string> set_object_move(const std::string& text, const std::string& name,
                                    const glm::vec3& move_m);

} // namespace ghost::scene
