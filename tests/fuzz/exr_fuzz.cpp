// SPDX-License-Identifier: Apache-2.0
// read_exr on anything.
#include "fuzz_folder.h"

#include "image/exr.h"

#include <cstdlib>

using namespace ghost;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto file = image::read_exr(fuzz_file("a.exr", {data, size}));
    if (!file.ok()) return 0;
    const image::ImageF& pixels = file->pixels;
    if (pixels.samples.size() != static_cast<std::size_t>(pixels.width) *
                                     static_cast<std::size_t>(pixels.height) *
                                     static_cast<std::size_t>(pixels.channels) ||
        file->channels.size() != static_cast<std::size_t>(pixels.channels))
        std::abort();
    return 0;
}
