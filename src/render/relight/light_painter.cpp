// SPDX-License-Identifier: Apache-2.0
#include "render/relight/light_painter.h"

#include "shaders/bounce.h"
#include "shaders/clear_tiles.h"
#include "shaders/cull.h"
#include "shaders/fold.h"
#include "shaders/silhouettes.h"
#include "shaders/sum.h"
#include "shaders/surface.h"
#include "shaders/surface_live.h"
#include "shaders/visibility.h"

#include <algorithm>
#include <vector>

namespace ghost::render {
namespace {

constexpr std::uint32_t kCullLanes = 8;  // of cull.comp, as far as a workgroup has room for
constexpr std::uint32_t kCullTiles = 64; // its tiles

std::uint32_t cull_lanes(const gpu::Device& device) {
    return std::min(kCullLanes, device.limits().work_group_invocations / kCullTiles);
}

} // namespace

LightPainter::LightPainter(const gpu::Device& on, const PainterShape& shape, gpu::Commands* with)
    : device(on), own(with ? nullptr : std::make_unique<gpu::Commands>(on)), commands(with ? *with : *own),
      cull(on, shaders::kShader_cull,
           {0u, shape.distances ? 1u : 0u, shape.batch_size == 1 ? 1u : cull_lanes(on)}),
      clear(on, shaders::kShader_clear_tiles), bounce(on, shaders::kShader_bounce),
      silhouettes(on, shaders::kShader_silhouettes),
      fold(on, shaders::kShader_fold, {shape.air ? 1u : 0u, shape.beams.beams == Beams::gate ? 0u : 1u}),
      visible(on, shaders::kShader_visibility, {0u, shape.batch_size == 1 ? 1u : 0u}),
      haze(on, shape.beams, shape.fragments, shape.batch_size, shape.light_count, shape.distances,
           shape.coarse ? FanDetail::plain : FanDetail::fine, shape.most_fans),
      shape_(shape) {
    if (!shape.from_passes) mending = std::make_unique<TileLists>(on, shape.fragments);
    visible.expect();
    const std::uint32_t single = shape.batch_size == 1 ? 1 : 0;
    for (std::uint32_t kind = 0; kind < shared::kBeamClasses; ++kind) {
        const auto program = [&](std::uint32_t thin, std::uint32_t keeps) {
            return shape.from_passes ? gpu::LateProgram(on, shaders::kShader_surface, {kind, single, thin})
                                     : gpu::LateProgram(on, shaders::kShader_surface_live,
                                                        {kind, single, shape.distances ? 1u : 0u,
                                                         shape.illuminance ? 1u : 0u, thin, keeps});
        };
        surface[kind] = program(0, 1);
        thin_surface[kind] = program(1, 1);
        direct_surface[kind] = program(1, 0);
        if (kind < shared::kPlanesClass) (void)surface[kind].get();
        for (const auto* programs : {&surface, &thin_surface, &direct_surface})
            if (shared::may_be_of_wheels(kind)) (*programs)[kind].expect();
    }
    const Fragments& f = shape.fragments;
    if (shape.beams.beams == Beams::gate && shape.beams.most_wide_step > 1)
        wide = std::make_unique<WideBeams>(on, f.width, f.height);
    // In one frame every light is drawn at most three times, into an image to keep, into the frame and where
    // that is patched; each draw begins a chunk.
    const std::uint64_t draws = kMostDraws * std::uint64_t{shape.light_count} + shared::kBeamClasses;
    lights = gpu::Buffer(on, draws * kLightRoom + kChunkBytes, gpu::Access::upload);
    // Every image is an addend three times at most, of the one above it, of what rests or the frame, and of
    // the patch.
    const std::uint64_t sums = 2 * std::uint64_t{shape.light_count} + 1;
    addends = gpu::Buffer(on, 3 * sums * kChunkAlign + kAddendBytes, gpu::Access::upload);
    const std::uint64_t batches =
        shape.batch_size == 1 ? std::min<std::uint64_t>(shared::kLightsPerChunk, draws) : 1;
    groups = gpu::Buffer(on, batches * sizeof(shared::TileGroups), gpu::Access::device);
    work = gpu::Buffer(on, sizeof(shared::FrameWork), gpu::Access::device);
    drawn = gpu::Texture(
        on, {f.width, f.places.shape().height, 2, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    haze_sources = gpu::Texture(
        on, {f.edges.shape().width, f.edges.shape().height, 1, 1, VK_FORMAT_R16_UINT, true, false});
    const std::uint64_t tiles = std::uint64_t{f.tiles_x} * f.tiles_y;
    // A G-buffer has another number of them each time; there is room for so many.
    const std::uint64_t blocks =
        std::uint64_t{f.places.shape().height - f.height} * f.width / shared::kTilePixels + 1;
    const std::uint64_t mask_words = shape.batch_size == 1 ? shape.light_count * ((tiles + blocks) / 32 + 1)
                                                           : 2 * (tiles + blocks) * shared::kMaskWords;
    masks = gpu::Buffer(on, mask_words * sizeof(std::uint32_t), gpu::Access::device);
    lists = gpu::Buffer(
        on,
        (shared::kListCounts + batches * shared::lists_length(static_cast<std::uint32_t>(tiles),
                                                              static_cast<std::uint32_t>(blocks))) *
            sizeof(std::uint32_t),
        gpu::Access::device);
}

void LightPainter::begin_lights() {
    lights_used = 0;
    haze.begin_frame();
}

void LightPainter::begin_marks() {
    commands.fill_zero(masks);
    commands.barrier();
}

std::uint32_t LightPainter::mark_words() const {
    const Fragments& f = shape_.fragments;
    return (f.tiles_x * f.tiles_y + f.blocks + 31) / 32;
}

void LightPainter::expect_patches() {
    if (patch.bytes() == 0) patch = gpu::Texture(device, drawn.shape());
}

void LightPainter::begin_frame() {
    begin_lights();
    addends_used = 0;
    is_recording = has_drawn = false;
}

const gpu::Program& LightPainter::sum_of(std::uint32_t parts, std::uint32_t count) {
    // A shader for each number pays where a loop loads its values for every lane.
    if (!device.is_cpu() && count > 0) count = shared::kManyAddends;
    std::unique_ptr<gpu::Program>& program = sums_[{parts, count}];
    if (!program)
        program = std::make_unique<gpu::Program>(
            device, shaders::kShader_sum,
            std::vector{shape_.beams.beams == Beams::gate ? 0u : 1u, shape_.coarse ? 1u : 0u, parts, count});
    return *program;
}

std::uint64_t LightPainter::picture_bytes() const {
    std::uint64_t sum = (wide ? wide->memory_bytes() : 0) + (mending ? mending->memory_bytes() : 0);
    for (const gpu::Buffer* buffer : {&masks, &lists}) sum += buffer->bytes();
    for (const gpu::Texture* texture : {&drawn, &patch, &haze_sources}) sum += texture->bytes();
    return sum;
}

std::uint64_t LightPainter::memory_bytes() const {
    std::uint64_t sum = haze.memory_bytes();
    for (const gpu::Buffer* buffer : {&lights, &addends, &groups, &work}) sum += buffer->bytes();
    return sum;
}

} // namespace ghost::render
