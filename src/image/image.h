#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pixels in memory: row-major, top row first, channels interleaved. Plain values.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ghost::image {

template <class Sample>
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<Sample> samples; // width * height * channels

    Image() = default;
    Image(int width_px, int height_px, int channel_count)
        : width(width_px), height(height_px), channels(channel_count),
          samples(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
                  static_cast<std::size_t>(channel_count)) {}

    Sample* at(int x, int y) { return samples.data() + offset(x, y); }
    const Sample* at(int x, int y) const { return samples.data() + offset(x, y); }
    bool empty() const { return samples.empty(); }

private:
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};

using Image8 = Image<std::uint8_t>; // sRGB or data, as its owner says
using ImageF = Image<float>;        // scene-linear

// Mean over blocks of factor x factor pixels; what is left at the right and below is cut off.
ImageF averaged(const ImageF& picture, int factor);

} // namespace ghost::image
