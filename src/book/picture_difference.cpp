// SPDX-License-Identifier: Apache-2.0
#include "book/difference.h"

#include "image/colour.h"
#include "image/flip.h"

#include <algorithm>

namespace ghost::scene {
namespace {

constexpr double kSeenMost = 0.05;  // no pixel differs by more: nobody sees it
constexpr float kFarApart = 0.1f;   // a pixel that everybody sees
constexpr double kLargeShare = 0.1; // so much of the picture: another look

image::ImageF linear(const image::Image8& picture) {
    image::ImageF result(picture.width, picture.height, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto value = [&](int k) {
                return image::srgb_to_linear(static_cast<float>(picture.at(x, y)[k]) / 255.0f);
            };
            const glm::vec3 colour = image::rec709_to_rec2020({value(0), value(1), value(2)});
            for (int k = 0; k < 3; ++k) result.at(x, y)[k] = colour[k];
        }
    return result;
}

} // namespace

std::string words_of(PictureDifference::Seen seen, const PrintStyle& style) {
    switch (seen) {
    case PictureDifference::Seen::same_pixels:
        return style("the same");
    case PictureDifference::Seen::not_seen:
        return style("not seen");
    case PictureDifference::Seen::seen:
        return style("seen");
    case PictureDifference::Seen::large:
        break;
    }
    return style("large");
}

Result<PictureDifference> compare_pictures(const image::Image8& old, const image::Image8& now,
                                           image::Image8& map) {
    PictureDifference difference;
    if (old.width == now.width && old.height == now.height && old.samples == now.samples) return difference;
    TRY(const image::PicturePair pair, image::pair_up(linear(now), linear(old), {}));
    const image::FlipMap flip = image::ldr_flip(pair, image::kFlipPixelsPerDegree);
    difference.mean = flip.mean;
    difference.p99 = flip.p99;
    difference.max = flip.max;
    const auto far = std::count_if(flip.errors.samples.begin(), flip.errors.samples.end(),
                                   [](float error) { return error > kFarApart; });
    difference.share = static_cast<double>(far) / static_cast<double>(flip.errors.samples.size());
    difference.seen = flip.max < kSeenMost              ? PictureDifference::Seen::not_seen
                      : difference.share >= kLargeShare ? PictureDifference::Seen::large
                                                        : PictureDifference::Seen::seen;
    map = image::flip_picture(flip.errors);
    return difference;
}

void sort_by_difference(std::vector<ComparedPicture>& pictures) {
    std::stable_sort(
        pictures.begin(), pictures.end(), [](const ComparedPicture& a, const ComparedPicture& b) {
            // What could not be compared is looked at first.
            const auto of = [](const ComparedPicture& picture) {
                return picture.difference ? std::pair(picture.difference->p99, picture.difference->max)
                                          : std::pair(2.0, 2.0);
            };
            return of(a) > of(b);
        });
}

} // namespace ghost::scene
