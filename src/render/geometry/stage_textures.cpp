// SPDX-License-Identifier: Apache-2.0
// The part of StageModel that brings textures to the device.
#include "render/geometry/stage_model.h"

#include "gpu/device_memory.h"

#include <algorithm>
#include <string>
#include <utility>

namespace ghost::render {
namespace {

constexpr int kLevelsLost = 6; // at most, of textures that are too large

bool there(const scene::Stage& stage, int texture) {
    if (texture < 0 || texture >= static_cast<int>(stage.textures.size())) return false;
    const image::Image8& pixels = stage.textures[static_cast<std::size_t>(texture)].pixels;
    return pixels.channels == 4 && !pixels.empty();
}

std::uint64_t bytes_of(const image::Image8& pixels, int lost) {
    const auto width = static_cast<std::uint64_t>(std::max(pixels.width >> lost, 1));
    const auto height = static_cast<std::uint64_t>(std::max(pixels.height >> lost, 1));
    return width * height * 4 * 4 / 3;
}

int lost_levels(const image::Image8& pixels, int most_side) {
    int lost = 0;
    while (std::max(pixels.width, pixels.height) >> lost > most_side) ++lost;
    return lost;
}

} // namespace

std::array<int, 4> StageModel::textures_of(const scene::Material& material) {
    return {material.base_texture, material.normal_texture, material.surface_texture,
            material.emission_texture};
}

TextureUse StageModel::use_of(const scene::Stage& stage, int texture, std::size_t slot) {
    if (slot == 1) return TextureUse::bumps;
    const bool seen = slot == 0 || slot == 3;
    return seen && there(stage, texture) && stage.textures[static_cast<std::size_t>(texture)].is_colour
               ? TextureUse::colour
               : TextureUse::data;
}

void StageModel::add_textures(const scene::Stage& stage, Report& report, std::uint64_t texture_bytes) {
    textures_.emplace_back(device_,
                           gpu::TextureShape{1, 1, 1, 1, VK_FORMAT_R8G8B8A8_UNORM, false, true, true});
    constexpr std::uint32_t kWhite = 0xffffffffu;
    textures_.back().write(0, &kWhite, sizeof kWhite);

    std::uint64_t whole_bytes = 0;
    int most_side = 1;
    const auto want = [&](int texture, TextureUse use) {
        if (!there(stage, texture) || !texture_of_.emplace(std::pair{texture, use}, 0).second) return;
        const image::Image8& pixels = stage.textures[static_cast<std::size_t>(texture)].pixels;
        whole_bytes += bytes_of(pixels, 0);
        most_side = std::max({most_side, pixels.width, pixels.height});
    };
    for (const scene::Material& material : stage.materials)
        for (std::size_t k = 0; k < 4; ++k) {
            const int texture = textures_of(material)[k];
            want(texture, use_of(stage, texture, k));
        }
    const std::uint64_t budget = std::min(texture_bytes, device_.memory().local_bytes() / 4);
    const int whole_side = most_side;
    std::uint64_t bytes = whole_bytes;
    for (int lost = 0; bytes > budget && lost < kLevelsLost; ++lost) {
        most_side = std::max(most_side / 2, 1);
        bytes = 0;
        for (const auto& entry : texture_of_) {
            const image::Image8& pixels = stage.textures[static_cast<std::size_t>(entry.first.first)].pixels;
            bytes += bytes_of(pixels, lost_levels(pixels, most_side));
        }
    }
    if (most_side < whole_side)
        report.add(Severity::warning, "textures",
                   "they need " + std::to_string(whole_bytes >> 20) + " MiB on the device, more than " +
                       std::to_string(budget >> 20) + " MiB: drawn with at most " +
                       std::to_string(most_side) + " texels a side");
    for (auto& [key, index] : texture_of_) {
        const image::Image8& pixels = stage.textures[static_cast<std::size_t>(key.first)].pixels;
        const std::vector<image::Image8> levels =
            mip_levels(pixels, key.second, lost_levels(pixels, most_side));
        index = textures_.size();
        textures_.emplace_back(device_,
                               gpu::TextureShape{static_cast<std::uint32_t>(levels[0].width),
                                                 static_cast<std::uint32_t>(levels[0].height), 1,
                                                 static_cast<std::uint32_t>(levels.size()),
                                                 key.second == TextureUse::colour ? VK_FORMAT_R8G8B8A8_SRGB
                                                                                  : VK_FORMAT_R8G8B8A8_UNORM,
                                                 false, true, true});
        for (std::size_t k = 0; k < levels.size(); ++k)
            textures_.back().write(static_cast<std::uint32_t>(k), levels[k].samples.data(),
                                   levels[k].samples.size());
    }
}

} // namespace ghost::render
