#pragma once
// SPDX-License-Identifier: Apache-2.0
// A camera that sees nothing of the stage, for it stands behind a wall or looks past it: told by a few rays
// and what hides the heads that its picture should have. Engine thread.

#include "image/image.h"
#include "rays/tracer.h"
#include "show/camera.h"

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {

// The body that is before all of it; empty: nothing is in the picture; nothing: something is seen. heads_m:
// of the rig, now. is_black: nothing in the picture is brighter than black, though nobody asked for that.
// is_unlit: no lamp shines, so that a wall which fills the picture is no picture of light.
std::optional<std::string> unseen_stage(const scene::Camera& camera, const std::vector<glm::vec3>& heads_m,
                                        const bake::Tracer& tracer, bool is_black, bool is_unlit);

// No sample of it is brighter than black.
bool is_black(const image::Image8& picture);

} // namespace ghost::app
