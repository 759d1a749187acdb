#pragma once
// SPDX-License-Identifier: Apache-2.0
// Haze: what the beams of a chunk scatter towards the camera, by one of three integrators. cone is the
// paper's, march the thesis's: samples of the beam (haze.comp). gate is ours: segments from a table per light
// and frame, without noise (fan.comp, gate.comp, shared/fan.h). Main thread; the device must outlive it.

#include "render/light_chunk.h"

#include <array>
#include <memory>

namespace ghost::render {

enum class Beams {
    gate,  // segments of the gate, from prefix sums; no noise
    cone,  // the paper: samples only inside the cone, jittered
    march, // the thesis: equal steps along the whole ray
};

struct HazeSettings {
    Beams beams = Beams::gate;
    int march_steps = 110;
    float curvature = 0.12f; // of gate: how much phase and transmittance may bend over one segment
    int most_segments = 24;  // of gate
    bool uneven = false;     // shared::Air has swirls or plumes
};

class HazePass {
public:
    // light_count: of the show; at most so many fans are needed at a time. distance_maps: layers by
    // Light::map (render/distance_images.h), null: nothing throws shadows into haze; gate only. Must outlive
    // this.
    HazePass(const gpu::Device& device, const HazeSettings& settings, std::uint32_t batch_size,
             std::uint32_t light_count, const gpu::Texture* distance_maps);

    // Forgets the fans of the frame before.
    void begin_frame() { fans_used_ = 0; }
    // Adds to layer 1 of the chunk's drawn image.
    void record(gpu::Commands& commands, const LightChunk& chunk);
    std::uint64_t memory_bytes() const { return table_.bytes() + shade_.bytes() + fans_.bytes(); }

private:
    void record_samples(gpu::Commands& commands, const LightChunk& chunk);
    void record_gate(gpu::Commands& commands, const LightChunk& chunk);

    HazeSettings settings_;
    std::uint32_t batch_size_;
    static constexpr std::uint32_t kClasses = 3; // 0, 1, 2 gobo wheels
    std::array<std::unique_ptr<gpu::Program>, kClasses> samples_, fill_;
    std::array<std::unique_ptr<gpu::Program>, 2> gate_; // without and with focus
    std::unique_ptr<gpu::Program> shade_fill_;
    const gpu::Texture* distance_maps_;
    gpu::Buffer fans_;
    std::uint64_t fans_used_ = 0; // bytes
    gpu::Texture table_, shade_;
};

} // namespace ghost::render
