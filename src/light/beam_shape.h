#pragma once
// SPDX-License-Identifier: Apache-2.0
// BeamShape: measured light in place of the profile that beam and field angle make: the candela of a
// photometric file as a picture in the gate (256 x 256, 8 bits of the peak), so that ovals, rings and hot
// spots are as they were measured. Pure. docs/reference/photometry.md.

#include "base/result.h"
#include "fixture_files/ies_ldt/photometric.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ghost::scene {

struct BeamShape {
    std::string file;                 // for messages
    float tan_field = 0;              // tangent of half the angle at which the picture ends
    double flux_lm = 0;               // within that
    double lost_lm = 0;               // beyond: not drawn
    std::vector<std::uint8_t> texels; // fraction of the peak, kGoboSize a side, top row first; linear
    std::vector<double> rings;        // sums of the fractions by squared gate radius, 0..1

    // Lumens per candela of the peak, if the picture is stretched to another angle.
    float solid_angle(float tan_of_field) const;
};

// Nothing of a beam is drawn beyond half this angle.
inline constexpr float kWidestShape_deg = 160.0f;

BeamShape shape_of(const fixture::Photometric& light, const std::string& file);

} // namespace ghost::scene
