#pragma once
// SPDX-License-Identifier: Apache-2.0
// The value types of an MVR description (DIN SPEC 15801, "Generic value types"): text to numbers and back,
// independent of the locale. Matrices come in metres. Pure; nothing where the text is not what the standard
// says, is no number or is larger than any stage (kMaxMvrDistance_m).

#include "fixture/patch.h"
#include "mvr/plot.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace ghost::scene {

inline constexpr double kMaxMvrDistance_m = 1e8; // survey coordinates reach 1e7 m
inline constexpr double kMaxMvrScale = 1e6;
inline constexpr int kMaxUniverse = 63'999; // of sACN

std::optional<double> parse_mvr_number(std::string_view text);
// "{u1,u2,u3}{v1,v2,v3}{w1,w2,w3}{o1,o2,o3}", o in millimetres.
std::optional<glm::dmat4> parse_mvr_matrix(std::string_view text);
std::string mvr_matrix_text(const glm::dmat4& matrix);
// "513", "2.1"; 0 and -1 are not patched.
std::optional<fixture::Address> parse_mvr_address(std::string_view text);
std::optional<glm::dvec3> parse_mvr_vector(std::string_view text); // "0,0,-1"
PlotCommand parse_mvr_command(std::string text);
std::optional<PictureScale> parse_picture_scale(std::string_view text);

// All numbers finite and no further away than kMaxMvrDistance_m.
bool is_usable(const glm::dmat4& matrix);

} // namespace ghost::scene
