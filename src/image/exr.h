#pragma once
// SPDX-License-Identifier: Apache-2.0
// OpenEXR files: linear images with named channels and chromaticities. Reading is limited to 16384 pixels a
// side, 64 channels and 512 Mi samples; errors name the file and what was expected. Writing is atomic. Any
// thread.

#include "base/result.h"
#include "image/colour.h"
#include "image/image.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::image {

inline constexpr int kMaxSide = 16384; // pixels

enum class ExrSample { half, full };

struct ExrFile {
    ImageF pixels; // the display window; black where the file has no data
    // Name of each channel of pixels: R G B A first, then the others by name. A layer prefix is taken off
    // ("ViewLayer.Combined.R" is R) unless two channels would then have one name: a layer called Combined has
    // the short names, the others keep their long ones.
    std::vector<std::string> channels;
    std::optional<Chromaticities> chromaticities;
    std::map<std::string, std::string> text; // string attributes

    // Index of the channel of this name in pixels, or -1.
    int find_channel(const std::string& name) const;
};

// What a reader expects; 0: anything.
struct ExrShape {
    int width = 0;
    int height = 0;
    int channels = 0;
};
// Error, too, where the header says another shape, or pixels beyond 16 times its picture: before there is
// memory for any.
Result<ExrFile> read_exr(const std::filesystem::path& path, const ExrShape& expected = {});

// Channel k of file.pixels is written as file.channels[k]. ZIP compression (lossless). Finite values beyond
// the range of half are stored as its largest, 65504.
Result<void> write_exr(const std::filesystem::path& path, const ExrFile& file, ExrSample sample);

} // namespace ghost::image
