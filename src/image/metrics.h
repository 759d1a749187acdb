#pragma once
// SPDX-License-Identifier: Apache-2.0
// How far a picture is from a reference: relative errors, bias, PSNR behind a tone curve. Formulas:
// docs/reference/compare.md. Pictures are linear Rec.2020 of any one unit, or display values 0..1 where the
// function says so. FLIP stands in flip.h. Pure, any thread.

#include "base/result.h"
#include "image/image.h"

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::image {

struct Circle {
    float x = 0; // pixels from the left edge; the middle of the first pixel is 0.5
    float y = 0; // pixels from the top edge
    float radius = 0;
};

// Two pictures of 3 channels and one size, with what is to be compared. Pixels that do not count hold the
// same finite values in both, so that no filter carries them into their neighbours.
struct PicturePair {
    ImageF test;
    ImageF reference;
    std::vector<std::uint8_t> counts; // per pixel: 1 takes part
    std::size_t counted = 0;
    std::size_t non_finite = 0; // outside the masked circles; left out

    bool takes_part(std::size_t pixel) const { return counts[pixel] != 0; }
    glm::vec3 test_at(std::size_t pixel) const;
    glm::vec3 reference_at(std::size_t pixel) const;
};

// Leaves out the pixels whose middle is in one of the circles, and those with a value that is not finite in
// one of the pictures. Error: sizes differ, or no pixel is left.
Result<PicturePair> pair_up(ImageF test, ImageF reference, const std::vector<Circle>& masked_out);

struct RelativeErrors {
    double relmse = 0;         // mean (x - r)^2 / (r^2 + 0.01 mean(r)^2) of all pixels and channels
    double relmse_trimmed = 0; // without the worst 0.1 % of the pixels
    double bias = 0;           // mean(x) / mean(r) - 1
    double max_error = 0;      // relative error of a pixel: root of its own term of relmse
    double p99_error = 0;      // 99 % of the pixels have no more
};

// Infinite where the reference is black and the test is not.
RelativeErrors relative_errors(const PicturePair& pair);

// Linear Rec.2020 to display values 0..1.
using ToneCurve = std::function<glm::vec3(const glm::vec3&)>;

// 10 log10(1 / mean square difference) of curve(x) and curve(r); infinity where they are equal.
double psnr_db(const PicturePair& pair, const ToneCurve& curve);

// 1 - exp(-L / (2 p75)) per channel; p75: 75th percentile of the luminance of the lit pixels of the
// reference, which are those above 1 % of its mean luminance. A black reference takes p75 from the test,
// else 1.
ToneCurve p75_curve(const PicturePair& pair);

} // namespace ghost::image
