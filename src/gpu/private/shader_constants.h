#pragma once
// SPDX-License-Identifier: Apache-2.0
// The words of a shader (SPIR-V) with values for its specialisation constants 0, 1, ..: plain constants from
// then on, and so is what is worked out of them. The validation layer remembers modules that it has seen
// whole; where constants come beside a module, it works them out and checks the outcome anew for every
// pipeline, which takes it longer than the driver takes to compile. Values only, any thread.
#include "gpu/shader.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ghost::gpu {

// values: as many as are given, 32 bits each (0 and 1: false and true); those beyond keep what the shader
// says.
std::vector<std::uint32_t> with_constants(const Shader& shader, std::span<const std::uint32_t> values);

} // namespace ghost::gpu
