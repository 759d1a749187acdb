#pragma once
// SPDX-License-Identifier: Apache-2.0
// Material files (.mtl) of .obj models, made fit for Assimp. Pure.

#include "base/byte_reader.h"

#include <cstdint>
#include <vector>

namespace ghost::scene {

// Without what stands before the first newmtl, which Assimp 5.2 writes into a material that is not there, and
// without aniso, of which it takes the letters for a number and gives the model up.
std::vector<std::uint8_t> mtl_for_assimp(Bytes mtl);

} // namespace ghost::scene
