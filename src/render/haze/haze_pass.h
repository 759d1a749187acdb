#pragma once
// SPDX-License-Identifier: Apache-2.0
// Haze: what the beams of a chunk scatter towards the camera, by one of three integrators. cone is the
// paper's, march the thesis's: samples of the beam (haze.comp). gate is ours: segments from a table per light
// and frame, without noise (fan.comp, gate.comp, shared/fan.h). Main thread; the device must outlive it.

#include "render/haze/distance_images.h"
#include "render/haze/fan.h"
#include "render/haze/grid_pass.h"
#include "render/haze/light_chunk.h"
#include "render/haze/memory_order.h"
#include "render/haze/quality.h"
#include "shared/optics.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace ghost::render {

enum class Beams {
    gate,  // segments of the gate, from prefix sums; no noise
    cone,  // the paper: samples only inside the cone, jittered
    march, // the thesis: equal steps along the whole ray
};

struct HazeIntegrator {
    Beams beams = Beams::gate;
    int march_steps = 110;
    float curvature = 0.12f;          // of gate: how much phase and transmittance may bend over one segment
    int most_segments = 24;           // of gate
    bool uneven = false;              // shared::Air has swirls or plumes
    std::uint32_t most_wide_step = 1; // of gate: HazeQuality::wide_beam_step may go up to this
    bool grid = false;                // of gate: HazeQuality::grid may be on
};

// Single lights whose tables are kept, at most.
constexpr std::uint32_t kKeptFans = 64;

// Bytes that the fans of a chunk of so many lights take, and that those of all chunks of a frame may: each
// light is a chunk of its own, at worst, kMostDraws times.
std::uint64_t fan_room(std::uint32_t lights);
std::uint64_t fan_buffer_bytes(std::uint32_t light_count);

class HazePass {
public:
    // light_count: of the show; at most so many fans are needed at a time. distances: null: nothing throws
    // shadows into haze; gate only. Must outlive this. detail: of its tables at rest; those of many lights,
    // and of a moment, are plain. most_kept: see kKeptFans.
    HazePass(const gpu::Device& device, const HazeIntegrator& settings, const Fragments& fragments,
             std::uint32_t batch_size, std::uint32_t light_count, const DistanceImages* distances,
             FanDetail detail, std::uint32_t most_kept = kKeptFans);

    // Of gate: segments, from the next frame on.
    void set_quality(const HazeQuality& quality);
    // Of gate: tables are plain, for the next picture is seen from elsewhere.
    void set_flies(bool flies) { flies_ = flies; }
    // Shadows changed: no table holds what it did.
    void forget() { std::fill(filled_.begin(), filled_.end(), Filled{}); }
    // As if nothing had been drawn: filtering touches texels beyond those that a fan fills, and what it finds
    // there of an earlier one turns a pixel's last bit now and then.
    void reset();
    // Forgets the fans of the frame before.
    void begin_frame() { fans_used_ = 0; }
    // Adds to layer 1 of the chunk's drawn image, or to the rays of its wide beams.
    void record(gpu::Commands& commands, const LightChunk& chunk);
    // Of a chunk: each has its table at the same time where many share a dispatch.
    std::uint32_t most_lights() const { return batch_size_ == 1 ? shared::kLightsPerChunk : tables_; }
    Shortage shortage() const {
        return {batch_size_ == 1 ? Kept::tables : Kept::batch, tables_, wanted_tables_};
    }
    std::uint64_t memory_bytes() const {
        return table_.bytes() + shade_.bytes() + fans_.bytes() + (grid_ ? grid_->memory_bytes() : 0);
    }

private:
    bool is_of_moment() const;
    ShadeDetail shade_detail() const;
    void record_samples(gpu::Commands& commands, const LightChunk& chunk);
    void record_gate(gpu::Commands& commands, const LightChunk& chunk);
    // False: the grid does not pay for this light, or is off.
    bool record_grid(gpu::Commands& commands, const LightChunk& chunk, const shared::GatePush& push,
                     const shared::Fan& fan, std::uint32_t focus, std::uint64_t fans_offset);
    // Along a beam, from its apex, beyond which nothing of it is lit.
    float reach_m(const shared::Light& light, const Fragments& fragments) const;

    HazeIntegrator settings_;
    std::uint32_t batch_size_;
    std::uint32_t wanted_tables_, tables_; // the second is less where memory is short
    std::array<gpu::LateProgram, shared::kBeamClasses> samples_, fill_;
    std::array<gpu::LateProgram, 3> gate_, wide_gate_, thin_gate_; // by kFocus of gate.comp
    gpu::LateProgram panel_gate_, wide_panel_gate_;                // which have nothing in focus
    std::unique_ptr<gpu::Program> shade_fill_;
    std::unique_ptr<GridPass> grid_; // null: HazeIntegrator::grid is off, or many lights share a dispatch
    bool uses_grid_ = false;
    bool flies_ = false;
    const DistanceImages* distances_;
    FanDetail detail_;
    // What a layer of the tables holds: a light that changed in nothing but its weight finds its own again.
    struct Filled {
        shared::Light light{}; // at no weight
        shared::Fan fan{};     // of layer 0
        shared::HazeGrid grid{};
        std::uint64_t used = 0;
    };
    // The layer for a light, and whether it must be filled.
    std::pair<std::uint32_t, bool> layer_for(const shared::Light& light, const shared::Fan& fan);
    std::vector<Filled> filled_; // empty: many lights share a dispatch
    std::uint64_t uses_ = 0;
    bool is_clean_ = true; // table_ and shade_ hold nothing of before
    gpu::Buffer fans_;
    std::uint64_t fans_used_ = 0; // bytes
    gpu::Texture table_, shade_;
    gpu::Texture no_rays_, no_lonely_; // where no beam is wide
};

} // namespace ghost::render
