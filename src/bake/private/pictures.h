#pragma once
// SPDX-License-Identifier: Apache-2.0
// From a Frame to the files of passes/passes_file.h. Any thread.

#include "bake/frame.h"
#include "passes/passes_file.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace ghost::bake {

// The frame keeps its layers and loses its fragments.
scene::FragmentTable take_table(Frame& frame);

// What every picture carries: the key of what it depends on.
scene::TextAttributes attributes(const std::string& key);

bool any_light(const Layer& layer);

struct CentrePicture {
    const char* name;
    std::vector<std::string> channels;
    std::vector<float> (*samples)(const Frame&);
};

// P N albedo depth: values of the pixels' centres.
const std::array<CentrePicture, 4>& centre_pictures();

// Full floats.
Result<void> write_floats(const std::filesystem::path& path, int width, int height,
                          const std::vector<float>& samples, const std::vector<std::string>& channels,
                          const std::string& key);

} // namespace ghost::bake
