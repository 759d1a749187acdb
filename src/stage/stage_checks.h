#pragma once
// SPDX-License-Identifier: Apache-2.0
// What is odd about the meshes of a stage, though it can be drawn: said by name, so that whoever made the
// model can find it. Nothing is changed. Pure; any thread.

#include "base/report.h"
#include "stage/stage.h"

#include <string>

namespace ghost::scene {

// Of the object, or where it has none of its mesh.
std::string name_of(const Stage& stage, int instance);

// Triangles without area, edges of more than two triangles, mirrored objects, very large meshes. One line
// each, with the names. file: for messages.
void check_geometry(const Stage& stage, const std::string& file, Report& report);

} // namespace ghost::scene
