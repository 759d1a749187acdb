#pragma once
// SPDX-License-Identifier: Apache-2.0
// What is odd about where cameras and lights of a show are, though it can be drawn: said by name, so that
// whoever made it can find it. Nothing is changed. World metres. Pure; any thread.

#include "base/report.h"
#include "show/camera.h"
#include "stage/stage.h"

#include <glm/glm.hpp>
#include <span>
#include <string>

namespace ghost::scene {

struct Show;

// How often the surface goes round the point, by its normals (Jacobson et al. 2013): 1 inside a closed solid,
// 0 outside, between the two where the surface has holes.
double winding_number(const Mesh& mesh, const glm::mat4& world, const glm::vec3& point_m);

// The first shown instance with the point inside, or kNone. Bodies of fixtures do not count.
int instance_around(const Stage& stage, const glm::vec3& point_m);

// Cameras and lights that stand inside an object, lenses without size, zooms and fields wider or narrower
// than can be drawn. cameras: those that are asked about; the show need not have them. stage:
// stage_with_bodies or the model alone.
void check_places(const Show& show, const Stage& stage, std::span<const Camera> cameras, Report& report);

} // namespace ghost::scene
