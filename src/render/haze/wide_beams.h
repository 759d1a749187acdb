#pragma once
// SPDX-License-Identifier: Apache-2.0
// WideBeams: haze of beams that are wide in the picture, drawn at every 2nd or 4th ray and spread to the
// pixels between where their surfaces are as far away (shared/wide.h). The rays are those of gate.comp. Main
// thread; the device must outlive it.

#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/geometry/fragments.h"
#include "shared/types.h"

namespace ghost::render {

// Beams that are narrower than this a few metres before their lens keep every ray.
inline constexpr float kWideBeam_px = 48;

class WideBeams {
public:
    WideBeams(const gpu::Device& device, std::uint32_t width, std::uint32_t height);

    // Which pixels take what from which ray; again when the fragments or the step changed.
    void prepare(gpu::Commands& commands, const Fragments& fragments, std::uint32_t step);
    // Adds the rays to layer 1 of drawn.
    void spread(gpu::Commands& commands, const gpu::Texture& drawn);

    const gpu::Texture& rays() const { return rays_; } // rgba16f: clear before the first beam
    const gpu::Texture& lonely() const {
        return lonely_;
    }                                            // r16ui: pixels that get a ray of their own, by tile
    std::uint32_t step() const { return step_; } // as prepared
    std::uint64_t memory_bytes() const { return rays_.bytes() + weights_.bytes() + lonely_.bytes(); }

private:
    gpu::Program prepare_, spread_;
    gpu::Texture rays_, weights_, lonely_;
    std::uint32_t step_ = 2;
};

bool is_wide(const shared::Light& light, const glm::vec3& eye_m, float pixels_per_rad);

} // namespace ghost::render
