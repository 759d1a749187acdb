// SPDX-License-Identifier: Apache-2.0
#include "render/haze/grid_pass.h"

#include "shaders/grid_doubt.h"
#include "shaders/grid_fill.h"
#include "shaders/grid_left.h"
#include "shaders/grid_look_up.h"

namespace ghost::render {
namespace {

constexpr std::uint32_t kGroupWidth = 16, kGroupHeight = 8; // grid_fill.comp, grid_doubt.comp

gpu::TextureShape shape_of(std::uint32_t count) {
    return {shared::kMostGridColumns,
            shared::kMostGridRows,
            shared::kGridLayers * count,
            1,
            VK_FORMAT_R16G16B16A16_SFLOAT,
            true,
            true};
}

} // namespace

GridPass::GridPass(const gpu::Device& device, std::uint32_t width, std::uint32_t height, std::uint32_t count,
                   bool shadows, bool uneven)
    : doubt_(device, shaders::kShader_grid_doubt), look_up_(device, shaders::kShader_grid_look_up),
      filled_(device, shape_of(1)), grid_(device, shape_of(count)),
      left_(device, sizeof(shared::LeftHead) + std::uint64_t{4} * width * height, gpu::Access::device) {
    for (std::uint32_t focus = 0; focus < fill_.size(); ++focus) {
        const std::vector<std::uint32_t> constants{focus, 1u, shadows ? 1u : 0u, uneven ? 1u : 0u, 0u,
                                                   0u,    0u};
        fill_[focus] = gpu::LateProgram(device, shaders::kShader_grid_fill, constants);
        draw_left_[focus] = gpu::LateProgram(device, shaders::kShader_grid_left, constants);
        fill_[focus].expect();
        draw_left_[focus].expect();
    }
}

void GridPass::record(gpu::Commands& commands, const LightChunk& chunk, const shared::GridPush& push,
                      bool fill, std::uint32_t focus, const GatherTables& tables) {
    const Fragments& f = chunk.fragments;
    const gpu::Binding view = gpu::uniform(f.view),
                       lights = gpu::uniform(chunk.light_buffer, chunk.light_offset),
                       fans = gpu::uniform(tables.fans, tables.fans_offset), places = gpu::stored(f.places),
                       drawn = gpu::stored(chunk.drawn), table = gpu::sampled(tables.table),
                       shade = gpu::sampled(tables.shade), air = gpu::uniform(chunk.air);
    const std::uint32_t groups_x = gpu::groups(push.grid.columns, kGroupWidth),
                        groups_y = gpu::groups(push.grid.rows, kGroupHeight);
    commands.begin_span("haze fill");
    commands.write(left_, std::vector<shared::LeftHead>{{{0, 1, 1}, 0}});
    if (fill) {
        commands.dispatch(fill_[focus].get(), push,
                          shaders::GridFillBindings{.view = view,
                                                    .lights = lights,
                                                    .fans = fans,
                                                    .places = places,
                                                    .grid = gpu::stored(filled_),
                                                    .table = table,
                                                    .shade = shade,
                                                    .air = air},
                          groups_x, groups_y);
        commands.barrier();
        commands.dispatch(
            doubt_, push,
            shaders::GridDoubtBindings{.filled = gpu::stored(filled_), .grid = gpu::stored(grid_)}, groups_x,
            groups_y);
        commands.barrier();
    }
    commands.begin_span("haze look-up");
    commands.dispatch_indirect(look_up_, push,
                               shaders::GridLookUpBindings{.view = view,
                                                           .lights = lights,
                                                           .fans = fans,
                                                           .places = places,
                                                           .grid = gpu::sampled(grid_),
                                                           .lists = gpu::storage(chunk.lists),
                                                           .drawn = drawn,
                                                           .left = gpu::storage(left_)},
                               chunk.groups, chunk.haze_groups(push.gate.batch));
    commands.barrier();
    commands.begin_span("haze left");
    commands.dispatch_indirect(draw_left_[focus].get(), push,
                               shaders::GridLeftBindings{.view = view,
                                                         .lights = lights,
                                                         .fans = fans,
                                                         .places = places,
                                                         .drawn = drawn,
                                                         .table = table,
                                                         .shade = shade,
                                                         .air = air,
                                                         .left = gpu::storage(left_)},
                               left_, 0);
    commands.barrier();
}

} // namespace ghost::render
