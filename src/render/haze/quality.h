#pragma once
// SPDX-License-Identifier: Apache-2.0
// HazeQuality: what of the haze may be lowered to draw a frame sooner. Values.

#include <cstdint>

namespace ghost::render {

struct HazeQuality {
    float curvature = 0.12f;          // see HazeIntegrator
    int most_segments = 24;           // see HazeIntegrator
    std::uint32_t wide_beam_step = 1; // pixels from one ray to the next in beams that are wide: 1, 2 or 4
    bool grid =
        false; // rays take what their neighbours agree on from a grid (render/haze/private/haze_grid.h)

    bool operator==(const HazeQuality&) const = default;
};

} // namespace ghost::render
