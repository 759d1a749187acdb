#pragma once
// SPDX-License-Identifier: Apache-2.0
// What is odd about a stage, its cameras and its lights, though it can be drawn: said by name, so that
// whoever made the model can find it. Nothing is changed. World metres. Pure; any thread.

#include "scene/report.h"
#include "scene/show.h"
#include "scene/stage.h"

#include <glm/glm.hpp>
#include <span>
#include <string>

namespace ghost::scene {

// Triangles without area, edges of more than two triangles, mirrored objects, very large meshes. One line
// each, with the names. file: for messages.
void check_geometry(const Stage& stage, const std::string& file, Report& report);

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
