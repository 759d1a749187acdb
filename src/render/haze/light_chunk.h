#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the passes that draw lights share while a frame is recorded: the lights of one uniform buffer, which
// tiles they reach, where the light goes. Refers, owns nothing.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/geometry/fragments.h"
#include "render/haze/wide_beams.h"
#include "shared/push.h"
#include "shared/types.h"

#include <cstddef>
#include <vector>

namespace ghost::render {

// Of a light in one frame, at most.
constexpr std::uint64_t kMostDraws = 3;

// Workgroups that share out the lights of a unit whose visibility is made (shared/visibility.h): where there
// are fewer units than a device can draw at once. On an H200 it takes half of the time in small pictures, and
// twice as long in large ones.
inline std::uint32_t visibility_slices(const Fragments& fragments, std::uint32_t batch_size) {
    constexpr std::uint32_t kFewTiles = 4096, kSlices = 16;
    static_assert(32 % (shared::kLightsPerChunk / kSlices) == 0); // of a word of a mask (visibility.comp)
    return batch_size > 1 && fragments.tiles_x * fragments.tiles_y <= kFewTiles ? kSlices : 1;
}

struct LightChunk {
    const std::vector<shared::Light>& lights; // all of one class
    std::uint32_t beam_class;                 // shared::beam_class
    const Fragments& fragments;
    const gpu::Texture& gobos;
    const gpu::Texture& slides; // moving pictures
    const gpu::Texture& drawn;
    const gpu::Buffer& air; // shared::Air
    const gpu::Buffer& light_buffer;
    std::uint64_t light_offset;
    const gpu::Buffer& masks;
    const gpu::Buffer& lists;
    const gpu::Buffer& groups;
    std::uint32_t batch_size; // lights of one dispatch, see shared/push.h
    const WideBeams* wide;    // where wide beams go; null: they have every ray, as narrow ones

    std::uint32_t count() const { return static_cast<std::uint32_t>(lights.size()); }
    std::uint32_t batches() const { return (count() + batch_size - 1) / batch_size; }
    std::uint32_t tiles() const { return fragments.tiles_x * fragments.tiles_y; }
    std::uint64_t surface_groups(std::uint32_t batch) const {
        return batch * sizeof(shared::TileGroups) + offsetof(shared::TileGroups, surface);
    }
    std::uint64_t made_groups(std::uint32_t batch) const {
        return batch * sizeof(shared::TileGroups) + offsetof(shared::TileGroups, made);
    }
    std::uint64_t direct_groups(std::uint32_t batch) const {
        return batch * sizeof(shared::TileGroups) + offsetof(shared::TileGroups, direct);
    }
    std::uint64_t haze_groups(std::uint32_t batch) const {
        return batch * sizeof(shared::TileGroups) + offsetof(shared::TileGroups, haze);
    }
};

} // namespace ghost::render
