// SPDX-License-Identifier: Apache-2.0
// read_exr on anything.
#include "image/exr.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

using namespace ghost;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("fuzz-" + std::to_string(getpid()) + ".exr");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    const auto file = image::read_exr(path);
    std::filesystem::remove(path);
    if (!file.ok()) return 0;
    const image::ImageF& pixels = file->pixels;
    if (pixels.samples.size() != static_cast<std::size_t>(pixels.width) *
                                     static_cast<std::size_t>(pixels.height) *
                                     static_cast<std::size_t>(pixels.channels) ||
        file->channels.size() != static_cast<std::size_t>(pixels.channels))
        std::abort();
    return 0;
}
