#pragma once
// SPDX-License-Identifier: Apache-2.0
// The passes of a camera on the device: fragments, one half-float layer of radiance per light and its bounced
// light. The passes are not needed afterwards. Main thread; the device must outlive it.

#include "passes/passes.h"
#include "render/geometry/fragments.h"
#include "shared/types.h"

#include <string>

namespace ghost::render {

struct PassImages {
    Fragments fragments;
    gpu::Texture radiance; // rgba16f: laid out as fragments.places; the last layer is dark
    gpu::Texture bounces;  // rgba16f, picture only; empty where no pass has bounced light
};

// What they need and this device has not (gpu::beyond_limits); "" where it fits.
std::string beyond_device(const gpu::Device& device, const scene::Passes& passes);

// Of passes that fit.
PassImages make_pass_images(const gpu::Device& device, const scene::Passes& passes, const glm::vec3& ambient,
                            const shared::Haze& haze);

} // namespace ghost::render
