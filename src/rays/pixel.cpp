// SPDX-License-Identifier: Apache-2.0
#include "rays/pixel.h"

#include <algorithm>

namespace ghost::bake {

void trace_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y, std::uint32_t seed,
                 std::span<Surface> samples, std::uint64_t& rays) {
    const std::uint32_t pixel = pixel_seed(x, y, seed);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const auto index = static_cast<std::uint32_t>(k);
        const glm::vec2 at = sobol_2d(index, pixel);
        const float blend = to_unit(owen_scramble(reverse_bits(index), hash_u32(pixel, 3)));
        samples[k] = tracer.first_hit(
            camera.eye, camera.direction(static_cast<float>(x) + at.x, static_cast<float>(y) + at.y), blend,
            Sees::everything);
    }
    rays += samples.size();
}

void light_samples(const Tracer& tracer, std::span<const Surface> samples, const glm::vec3& light_m,
                   std::span<glm::vec3> radiance, std::uint64_t& rays, float nearest_m) {
    const Surface* packet[8] = {};
    std::size_t target[8] = {};
    int count = 0;
    const auto flush = [&] {
        if (count == 0) return;
        float fractions[8];
        tracer.visibility(packet, count, light_m, fractions);
        rays += static_cast<std::uint64_t>(count);
        for (int k = 0; k < count; ++k) {
            if (fractions[k] <= 0.0f) continue;
            const Surface& surface = *packet[k];
            const glm::vec3 way = light_m - surface.position;
            const float distance2 = std::max(glm::dot(way, way), nearest_m * nearest_m);
            radiance[target[k]] = shared::brdf_times_cosine(surface.brdf, surface.normal, surface.to_viewer,
                                                            way / std::sqrt(distance2)) *
                                  (fractions[k] / distance2);
        }
        count = 0;
    };
    for (std::size_t k = 0; k < samples.size(); ++k) {
        radiance[k] = glm::vec3(0.0f);
        const Surface& surface = samples[k];
        if (surface.instance < 0 || glm::dot(surface.normal, light_m - surface.position) <= 0.0f) continue;
        packet[count] = &surface;
        target[count] = k;
        if (++count == 8) flush();
    }
    flush();
}

} // namespace ghost::bake
