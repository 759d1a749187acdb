#pragma once
// SPDX-License-Identifier: Apache-2.0
// How like two pictures are, by image/metrics.h, behind the tone curves of the tests.

#include "image/colour.h"
#include "image/metrics.h"
#include "support/must.h"

#include <algorithm>
#include <cstddef>
#include <gtest/gtest.h>
#include <vector>

namespace ghost {

// Every value must be a number.
inline image::PicturePair pair_of(image::ImageF picture, image::ImageF reference,
                                  const std::vector<image::Circle>& left_out = {}) {
    image::PicturePair pair = must(image::pair_up(std::move(picture), std::move(reference), left_out));
    EXPECT_EQ(pair.non_finite, 0u);
    return pair;
}

// What an sRGB display shows of scale times the picture.
inline image::ToneCurve srgb_curve(float scale) {
    return [scale](const glm::vec3& value) {
        const auto shown = [&](float v) { return image::linear_to_srgb(std::clamp(v * scale, 0.0f, 1.0f)); };
        return glm::vec3(shown(value.x), shown(value.y), shown(value.z));
    };
}

// On a display on which the reference's brightest hundredth clips.
inline double display_psnr(const image::ImageF& picture, const image::ImageF& reference) {
    std::vector<float> sorted = reference.samples;
    const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 99 / 100);
    std::nth_element(sorted.begin(), place, sorted.end());
    return image::psnr_db(pair_of(picture, reference), srgb_curve(1.0f / std::max(*place, 1e-9f)));
}

struct Likeness {
    double psnr_db = 0; // behind 1 - exp(-L / (2 p75)), as the beams' papers measure it
    double bias = 0;    // of the means
};

inline Likeness likeness(const image::PicturePair& pair) {
    return {image::psnr_db(pair, image::p75_curve(pair)), image::relative_errors(pair).bias};
}

inline Likeness likeness(const image::ImageF& picture, const image::ImageF& reference) {
    return likeness(pair_of(picture, reference));
}

} // namespace ghost
