#pragma once
// SPDX-License-Identifier: Apache-2.0
// Colour at the borders: sRGB, Rec.709, CIE xyY and black bodies into the working space, linear Rec.2020 D65, and back.
// Pure.

#include <glm/glm.hpp>

namespace ghost::image {

float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);

glm::vec3 rec709_to_rec2020(const glm::vec3& rgb);
glm::vec3 rec2020_to_rec709(const glm::vec3& rgb);
glm::vec3 xyz_to_rec2020(const glm::vec3& xyz);
glm::vec3 rec2020_to_xyz(const glm::vec3& rgb);

// xyY with Y on the scale of the caller; y = 0 gives black. Components may be negative outside the gamut.
glm::vec3 xyy_to_rec2020(const glm::vec3& xyy);

// Chromaticity of a source of this correlated colour temperature: Planckian below 5000 K, CIE daylight above (both
// clamped to 1667..25000 K), as Rec.2020 with luminance 1.
glm::vec3 cct_to_rec2020(float temperature_k);

} // namespace ghost::image
