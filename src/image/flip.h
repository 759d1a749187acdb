#pragma once
// SPDX-License-Identifier: Apache-2.0
// FLIP: the difference a viewer sees when two pictures alternate, per pixel 0 (none) .. 1. After Andersson et
// al., "FLIP: A Difference Evaluator for Alternating Images" (2020), and "Visualizing Errors in Rendered High
// Dynamic Range Images" (2021). Pictures are linear Rec.2020; FLIP itself works in Rec.709, what lies outside
// is clipped. Pixels that do not count are 0 in the map. Formulas: docs/reference/compare.md. Pure, any
// thread.

#include "image/image.h"
#include "image/metrics.h"

namespace ghost::image {

inline constexpr float kFlipPixelsPerDegree = 67.0f; // 0.7 m in front of a monitor 0.7 m wide, of 3840 pixels

struct FlipMap {
    ImageF errors; // 1 channel
    double mean = 0;
    double p99 = 0;
    double max = 0;
};

// Of pictures as a display shows them: linear light, 0..1.
FlipMap ldr_flip(const PicturePair& pair, float pixels_per_degree);

// Exposures that HDR-FLIP looks at, in stops, evenly spaced.
struct FlipExposures {
    float first = 0;
    float last = 0;
    int count = 1;
};

// From the reference alone: its brightest pixel and its median are mapped to 85 % of white. Where most of it
// is black, the median is that of the other pixels; where all of it is, the test stands in. At most 24 stops.
FlipExposures flip_exposures(const PicturePair& pair);

// The greatest ldr_flip of the exposures, per pixel, behind an ACES-like tone curve.
FlipMap hdr_flip(const PicturePair& pair, float pixels_per_degree);

// The map as a picture: black, violet, orange, light yellow (like magma), sRGB.
Image8 flip_picture(const ImageF& errors);

} // namespace ghost::image
