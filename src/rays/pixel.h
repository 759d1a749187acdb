#pragma once
// SPDX-License-Identifier: Apache-2.0
// The samples of one pixel: camera rays, light through shadow rays in packets of eight. Shared by the passes
// and by the direct reference picture, so both see the same samples. Any thread, with DenormalsOff.

#include "rays/camera_rays.h"
#include "rays/sampling.h"
#include "rays/tracer.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ghost::bake {

inline std::uint32_t pixel_seed(int x, int y, std::uint32_t seed) {
    return hash_u32(hash_u32(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)), seed);
}

// First hits of samples.size() rays through the pixel.
void trace_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y, std::uint32_t seed,
                 std::span<Surface> samples, std::uint64_t& rays);

// radiance[k] of samples[k] under an isotropic point source of 1 cd. Nearer than nearest_m it gets no
// brighter.
void light_samples(const Tracer& tracer, std::span<const Surface> samples, const glm::vec3& light_m,
                   std::span<glm::vec3> radiance, std::uint64_t& rays, float nearest_m = 1e-3f);

} // namespace ghost::bake
