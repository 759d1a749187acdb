// SPDX-License-Identifier: Apache-2.0
#include "reference/trace_lit.h"

#include "rays/pixel.h"

#include "shared/beam.h"
#include "shared/haze.h"

#include <tbb/parallel_for.h>

namespace ghost::bake {

image::ImageF trace_lit(const scene::Stage& stage, const scene::Camera& camera,
                        std::span<const shared::Light> lights, const shared::Gobos& gobos, int spp,
                        const shared::Haze& haze, std::uint32_t seed) {
    const Tracer tracer(stage);
    const CameraRays rays_of(camera);
    image::ImageF picture(camera.width, camera.height, 3);
    tbb::parallel_for(0, camera.height, [&](int y) {
        const DenormalsOff mode;
        std::vector<Surface> samples(static_cast<std::size_t>(spp));
        std::vector<glm::vec3> radiance(samples.size());
        std::uint64_t rays = 0;
        for (int x = 0; x < camera.width; ++x) {
            trace_pixel(tracer, rays_of, x, y, seed, samples, rays);
            glm::vec3 sum(0.0f);
            for (const shared::Light& light : lights) {
                light_samples(tracer, samples, light.position_m - light.off_map_m, radiance, rays);
                for (std::size_t k = 0; k < samples.size(); ++k) {
                    if (radiance[k] == glm::vec3(0.0f)) continue;
                    const glm::vec3 way = samples[k].position - light.position_m;
                    const glm::vec3 q = shared::to_gate(light, way);
                    sum += radiance[k] * shared::beam_candela(light, q, gobos) *
                           (shared::pass_fraction(light, way) *
                            shared::haze_transmittance(haze, shared::way_from_lens_m(light, q) +
                                                                 samples[k].distance_m));
                }
            }
            for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = sum[c] / static_cast<float>(spp);
        }
    });
    return picture;
}

} // namespace ghost::bake
