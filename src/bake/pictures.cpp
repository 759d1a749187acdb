// SPDX-License-Identifier: Apache-2.0
#include "bake/private/pictures.h"

#include "image/exr.h"

#include <algorithm>

namespace ghost::bake {
namespace {

template <class T>
std::vector<float> flat(const std::vector<T>& values, int count) {
    std::vector<float> result;
    result.reserve(values.size() * static_cast<std::size_t>(count));
    for (const T& value : values)
        for (int c = 0; c < count; ++c) result.push_back(value[c]);
    return result;
}

} // namespace

scene::FragmentTable take_table(Frame& frame) {
    return {frame.width, frame.height, std::move(frame.extra_first), std::move(frame.fragments)};
}

scene::TextAttributes attributes(const std::string& key) {
    return {{"ghost.key", key}, {"software", "Ghostlight"}};
}

bool any_light(const Layer& layer) {
    return std::any_of(layer.begin(), layer.end(),
                       [](const glm::vec3& value) { return value != glm::vec3(0.0f); });
}

Result<void> write_floats(const std::filesystem::path& path, int width, int height,
                          const std::vector<float>& samples, const std::vector<std::string>& channels,
                          const std::string& key) {
    image::ExrFile file;
    file.channels = channels;
    file.pixels = image::ImageF(width, height, static_cast<int>(channels.size()));
    file.pixels.samples = samples;
    file.text = attributes(key);
    if (channels[0] == "R") file.chromaticities = image::kRec2020;
    return image::write_exr(path, file, image::ExrSample::full);
}

const std::array<CentrePicture, 4>& centre_pictures() {
    static const std::array<CentrePicture, 4> all{{
        {"P", {"R", "G", "B", "A"}, [](const Frame& f) { return flat(f.centre_position, 4); }},
        {"N", {"R", "G", "B"}, [](const Frame& f) { return flat(f.centre_normal, 3); }},
        {"albedo", {"R", "G", "B"}, [](const Frame& f) { return flat(f.centre_albedo, 3); }},
        {"depth", {"Z"}, [](const Frame& f) { return f.centre_distance_m; }},
    }};
    return all;
}

} // namespace ghost::bake
