#pragma once
// SPDX-License-Identifier: Apache-2.0
// LightPainter: what lights are drawn with on one device: programs, lists of tiles, tables of the haze, and
// the image that lights add up in. The relighter has one on its device and, where that has workers
// (gpu/workers.h), one on each of them, which draw other lights at the same time. Main thread; the device
// must outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/geometry/fragments.h"
#include "render/haze/haze_pass.h"
#include "render/haze/wide_beams.h"
#include "render/relight/tile_lists.h"
#include "shared/optics.h"
#include "shared/push.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

namespace ghost::render {

// What a painter is made for.
struct PainterShape {
    HazeIntegrator beams;
    const Fragments& fragments;
    const DistanceImages* distances = nullptr; // of a G-buffer; or null
    bool from_passes = false;                  // instead of a G-buffer
    bool illuminance = false;
    bool air = true;
    bool coarse = false;
    std::uint32_t batch_size = 1;
    std::uint32_t light_count = 0;
    std::uint32_t most_fans = 0; // of kept tables (HazePass)
};

struct LightPainter {
    // commands: where it records; null: its own.
    LightPainter(const gpu::Device& device, const PainterShape& shape, gpu::Commands* commands);
    LightPainter(const LightPainter&) = delete;
    LightPainter& operator=(const LightPainter&) = delete;

    // Of sum.comp: with these parts and so many addends.
    const gpu::Program& sum_of(std::uint32_t parts, std::uint32_t addends);
    void begin_frame();
    // Nothing is recorded that reads what was uploaded of lights so far.
    void begin_lights();
    // Nothing is marked of what is drawn from here on.
    void begin_marks();
    std::uint32_t mark_words() const; // of a light
    // Makes `patch`, the first time.
    void expect_patches();
    void forget_stage() { wide_prepared = silhouettes_known = false; }
    std::uint64_t picture_bytes() const; // what a picture of another size has more or less of
    std::uint64_t memory_bytes() const;  // all but that

    static constexpr std::uint64_t kChunkAlign = 256; // offset of a uniform buffer, at most, on every device
    // Room that a light takes where it begins a chunk.
    static constexpr std::uint64_t kLightRoom =
        (sizeof(shared::Light) + kChunkAlign - 1) / kChunkAlign * kChunkAlign;
    static constexpr std::uint64_t kAddendBytes = shared::kMostAddends * sizeof(shared::Addend);
    static constexpr std::uint64_t kChunkBytes = shared::kLightsPerChunk * sizeof(shared::Light);

    const gpu::Device& device;
    std::unique_ptr<gpu::Commands> own; // or null
    gpu::Commands& commands;
    bool is_recording = false; // of its own commands
    bool has_drawn = false;    // likewise, in this frame
    gpu::Program cull, clear, bounce, silhouettes, fold;
    std::array<gpu::LateProgram, shared::kBeamClasses> surface, thin_surface,
        direct_surface; // the last: where no visibility is kept
    gpu::LateProgram visible;
    HazePass haze;
    std::unique_ptr<WideBeams> wide;    // null: HazeIntegrator::most_wide_step is 1
    std::unique_ptr<TileLists> mending; // the parts that are drawn again; null: from passes
    std::uint32_t mended_tiles = 0;     // above 0: only those are drawn now
    bool wide_prepared = false;
    bool silhouettes_known = false; // haze_sources are those of the picture
    gpu::Buffer lights, addends, masks, lists, groups, work;
    // Lights whose surfaces render/pixels lights when this is done, and where: a bit each tile, then block.
    struct Left {
        int light;
        shared::Light shown;
        std::uint32_t place; // of its kept visibility, + 1; 0: none
        std::size_t marks;   // words, of masks
        bool to_patch;
    };
    std::vector<Left> left;
    gpu::Texture drawn, patch, haze_sources; // patch: of lights that rest, where the frame is patched
    const gpu::Texture* into = &drawn;       // which of the two is drawn to
    std::uint64_t lights_used = 0;           // bytes, in this frame
    std::uint64_t addends_used = 0;          // likewise

private:
    PainterShape shape_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::unique_ptr<gpu::Program>> sums_;
};

} // namespace ghost::render
