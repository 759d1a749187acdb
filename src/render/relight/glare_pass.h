#pragma once
// SPDX-License-Identifier: Apache-2.0
// Glare: light that the camera's lens, or an eye, scatters around whatever is bright (docs/design/glare.md).
// An energy-conserving sum of ever wider blurs with the weights of the CIE's general disability glare
// function (CIE 146:2002; after Spencer et al. 1995). The result is a texture of its own: kept images never
// contain glare. Main thread; the device must outlive it.

#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/pixels/develop.h"
#include "shared/develop.h"
#include "shared/glare.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ghost::render {

struct GlareSettings {
    // Fraction of the light that is scattered farther than kGlareInner_deg, 0..1; 0: off. An eye: about 0.25
    float strength = 0.05f;
};

// Shares of the levels, finest first (a texel is 2 pixels, 4 pixels, ..); the coarsest has all that goes
// farther. Their sum is 1, less what goes no farther than a texel of the first: no pixel can show that.
std::vector<float> glare_weights(std::size_t levels, float pixels_per_rad);

class GlarePass {
public:
    GlarePass(const gpu::Device& device, std::uint32_t width, std::uint32_t height,
              const GlareSettings& settings);

    bool on() const { return settings_.strength > 0; }
    // The glare of a frame, where it is on. frame: layer 0, rgba16f, is the picture (light_of_frame in
    // shared/glare.h). brightest: what its pixels reach at most, cd/m^2.
    void record(gpu::Commands& commands, const gpu::Texture& frame, float brightest, float pixels_per_rad);
    // After record: makes seen(). What is to be developed: the picture with glare, or frame itself where
    // glare is off. Its alpha as the frame's.
    void see(gpu::Commands& commands, const gpu::Texture& frame);
    const gpu::Texture& seen(const gpu::Texture& frame) const { return on() ? seen_ : frame; }
    // After record, where it is on: develops what see() would make, without making it.
    void develop(gpu::Commands& commands, const gpu::Texture& frame, const gpu::Buffer& exposure,
                 const gpu::Texture& picture, std::uint32_t tone);
    // The same as record on this processor, whose memory all textures lie in.
    SeenFrame on_processor(const Plane& frame, float brightest, float pixels_per_rad);
    std::uint64_t memory_bytes() const;

private:
    float prepare(float brightest, float pixels_per_rad);
    // What adds to a level k - 1, of 0 to the picture: level k with all that is scattered farther, at last
    // the far one; and its weight.
    const gpu::Texture& scattered(std::size_t k) const { return k + 1 < levels_.size() ? levels_[k] : far_; }
    float scattered_weight(std::size_t k) const { return k + 1 < levels_.size() ? 1.0f : weights_.back(); }

    GlareSettings settings_;
    std::array<gpu::LateProgram, 2> down_; // from a level, from the frame
    gpu::LateProgram tail_, up_;
    std::array<gpu::LateProgram, shared::kToneCount> develop_;
    std::vector<gpu::Texture> levels_; // half the picture, a quarter, ..
    gpu::Texture far_;                 // the coarsest level, scattered
    gpu::Texture seen_;
    float pixels_per_rad_ = 0; // of weights_ and tail_weight_
    std::vector<float> weights_;
    shared::GlareUpPush last_up_{}; // from the finest level to the picture
    float tail_weight_ = 0;
};

} // namespace ghost::render
