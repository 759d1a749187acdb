#pragma once
// SPDX-License-Identifier: Apache-2.0
// Colour at the borders: sRGB, Rec.709, CIE xyY and black bodies into the working space, linear Rec.2020 D65,
// and back. Pure.

#include <array>
#include <glm/glm.hpp>

namespace ghost::image {

// CIE xy of red, green, blue, white.
using Chromaticities = std::array<float, 8>;
inline constexpr Chromaticities kRec709{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
inline constexpr Chromaticities kRec2020{0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};

float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);

glm::vec3 rec709_to_rec2020(const glm::vec3& rgb);
glm::vec3 rec2020_to_rec709(const glm::vec3& rgb);
glm::vec3 xyz_to_rec2020(const glm::vec3& xyz);
glm::vec3 rec2020_to_xyz(const glm::vec3& rgb);

// From linear RGB with these primaries. Another white point is not adapted: it stays the colour it is.
glm::mat3 rgb_to_rec2020(const Chromaticities& from);

// xyY with Y on the scale of the caller; y = 0 gives black. Components may be negative outside the gamut.
glm::vec3 xyy_to_rec2020(const glm::vec3& xyy);

// Chromaticity of a source of this correlated colour temperature: Planckian below 4000 K, CIE daylight above
// 5000 K, mixed between (IES TM-30), clamped to 1667..25000 K, as Rec.2020 with luminance 1.
glm::vec3 cct_to_rec2020(float temperature_k);

// The same, off that line by duv in CIE 1960 uv at right angles to it: above 0 greener, below more magenta.
glm::vec3 cct_to_rec2020(float temperature_k, float duv);

// CIE xy and luminance; black has the chromaticity of D65.
glm::vec3 rec2020_to_xyy(const glm::vec3& rgb);

// A colour outside of Rec.2020 at the border: no component below 0, the luminance as it was.
glm::vec3 into_gamut(const glm::vec3& rgb);

} // namespace ghost::image
