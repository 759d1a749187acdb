#pragma once
// SPDX-License-Identifier: Apache-2.0
// OpenEXR files: linear images with named channels and chromaticities. Reading is limited to 16384 x 16384 pixels and 16
// channels; errors name the file and what was expected. Writing is atomic. Any thread.

#include "base/result.h"
#include "image/image.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::image {

enum class ExrSample { half, full };

// CIE xy of red, green, blue, white.
using Chromaticities = std::array<float, 8>;
inline constexpr Chromaticities kRec709{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
inline constexpr Chromaticities kRec2020{0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};

struct ExrFile {
    ImageF pixels;
    std::vector<std::string> channels; // name of each channel of pixels, e.g. R G B (this order where all are there)
    std::optional<Chromaticities> chromaticities;
    std::map<std::string, std::string> text; // string attributes
};

Result<ExrFile> read_exr(const std::filesystem::path& path);

// Channel k of file.pixels is written as file.channels[k]. ZIP compression (lossless).
Result<void> write_exr(const std::filesystem::path& path, const ExrFile& file, ExrSample sample);

} // namespace ghost::image
