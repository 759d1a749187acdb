#pragma once
// SPDX-License-Identifier: Apache-2.0
// Bodies for models without a mesh: the primitive types of GDTF (DIN SPEC 15800, Model), shaped by ourselves.
// Pure.

#include "stage/stage.h"

#include <string_view>

namespace ghost::scene {

// In a box of 1 x 1 x 1, which lies about the origin as GDTF's own primitives do; unknown types are a box.
Mesh primitive_mesh(std::string_view type);

} // namespace ghost::scene
