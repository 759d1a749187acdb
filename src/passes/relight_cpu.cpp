// SPDX-License-Identifier: Apache-2.0
#include "passes/relight_cpu.h"

#include "shared/beam.h"
#include "shared/haze.h"

#include <glm/gtc/packing.hpp>

namespace ghost::scene {
namespace {

// Black where the pass is missing.
glm::vec3 radiance_at(const Passes& passes, std::uint32_t pass, std::size_t fragment) {
    if (pass >= passes.lights.size() || passes.lights[pass].radiance.empty()) return glm::vec3(0.0f);
    const std::uint16_t* half = passes.lights[pass].radiance.data() + 4 * fragment;
    return glm::vec3(glm::unpackHalf1x16(half[0]), glm::unpackHalf1x16(half[1]),
                     glm::unpackHalf1x16(half[2])) *
           (1.0f / kRadianceScale);
}

} // namespace

image::ImageF relight_cpu(const Passes& passes, std::span<const shared::Light> lights,
                          const shared::Gobos& gobos, const shared::Haze& haze) {
    const glm::vec3 eye(passes.camera_to_world[3]);
    const auto lit = [&](std::size_t fragment) {
        const glm::vec4& place = passes.fragments[fragment];
        glm::vec3 sum(0.0f);
        if (place.w < 0.0f) return sum;
        const glm::vec3 at(place);
        const float seen = shared::haze_transmittance(haze, glm::length(at - eye));
        for (const shared::Light& light : lights) {
            const glm::vec3 way = at - light.position_m;
            const glm::vec3 q = shared::to_gate(light, way);
            const glm::vec3 candela = shared::beam_candela(light, q, gobos);
            if (candela == glm::vec3(0.0f)) continue;
            const glm::vec3 radiance = radiance_at(passes, light.pass, fragment);
            sum += candela * radiance *
                   (seen * shared::pass_fraction(light, way) *
                    shared::haze_transmittance(haze, shared::way_from_lens_m(light, q)));
        }
        return sum;
    };
    image::ImageF picture(passes.width, passes.height, 3);
    const std::size_t pixels = passes.pixel_count();
    for (std::size_t p = 0; p < pixels; ++p) {
        glm::vec3 sum = lit(p);
        for (std::uint32_t k = passes.extra_first[p]; k < passes.extra_first[p + 1]; ++k)
            sum += lit(pixels + k);
        for (std::size_t c = 0; c < 3; ++c) picture.samples[3 * p + c] = sum[static_cast<int>(c)];
    }
    return picture;
}

} // namespace ghost::scene
