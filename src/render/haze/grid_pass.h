#pragma once
// SPDX-License-Identifier: Apache-2.0
// The haze of one light by its grid (render/haze/private/haze_grid.h): fill, doubt, look up, and ray by ray
// what is left. One light at a time; its fan must be filled. Main thread; the device must outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/haze/light_chunk.h"
#include "shared/push.h"

#include <array>

namespace ghost::render {

// What the haze of a light is gathered from: its fan (shared::Fan of each light of the chunk, from the offset
// on) and the tables of fans.
struct GatherTables {
    const gpu::Buffer& fans;
    std::uint64_t fans_offset;
    const gpu::Texture& table;
    const gpu::Texture& shade;
};

class GridPass {
public:
    // width, height: of the picture. count: grids that are kept. shadows, uneven: as in HazePass.
    GridPass(const gpu::Device& device, std::uint32_t width, std::uint32_t height, std::uint32_t count,
             bool shadows, bool uneven);

    // fill: else the grid is as it was filled before. focus: kFocus of gate_scatter.glsl.
    void record(gpu::Commands& commands, const LightChunk& chunk, const shared::GridPush& push, bool fill,
                std::uint32_t focus, const GatherTables& tables);
    std::uint64_t memory_bytes() const { return filled_.bytes() + grid_.bytes() + left_.bytes(); }

private:
    std::array<gpu::LateProgram, 3> fill_, draw_left_; // by kFocus
    gpu::Program doubt_, look_up_;
    gpu::Texture filled_, grid_;
    gpu::Buffer left_;
};

} // namespace ghost::render
