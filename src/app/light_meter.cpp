// SPDX-License-Identifier: Apache-2.0
#include "app/light_meter.h"

#include "scene/illuminance.h"
#include "shared/develop.h"

#include <cmath>

namespace ghost::app {
namespace {

constexpr std::uint64_t kFewImages = 1; // bytes: it keeps none

// Even light comes from everywhere.
float even_lux(const scene::Show& show) {
    return shared::luminance_of(show.ambient_colour) * show.ambient_lux;
}

} // namespace

LightMeter::LightMeter(const Session& session) : session_(session) {
    render::Settings settings = draw_settings(*session.show, session.live->camera(), session.options);
    settings.illuminance = true;
    settings.air = false;
    settings.lens.on = false;
    settings.glare.strength = 0;
    settings.reuse = false;
    settings.beams.most_wide_step = 1;
    settings.image_memory_bytes = kFewImages;
    relighter_ = std::make_unique<render::Relighter>(*session.device, session.live->g_buffer(),
                                                     session.live->distances(), session.gobos.images,
                                                     static_cast<int>(session.lit().lights.size()), settings);
}

image::ImageF LightMeter::lux_picture(const scene::Lit& lit) {
    relighter_->set_air(air_of(*session_.show, 0));
    relighter_->set_slides(session_.gobos.images.slides);
    relighter_->draw(lit);
    image::ImageF lux = luminance_of(relighter_->frame());
    const float even = even_lux(*session_.show);
    for (float& value : lux.samples) value += even;
    return lux;
}

image::ImageF luminance_of(const image::ImageF& frame) {
    image::ImageF luminance(frame.width, frame.height, 1);
    for (std::size_t i = 0; i < luminance.samples.size(); ++i)
        luminance.samples[i] =
            shared::luminance_of({frame.samples[3 * i], frame.samples[3 * i + 1], frame.samples[3 * i + 2]});
    return luminance;
}

bake::Surface surface_at(const scene::Camera& camera, const glm::vec2& place, const bake::Tracer& tracer) {
    const glm::mat4 to_world = scene::camera_to_world(camera);
    const float tan_y = std::tan(glm::radians(camera.fov_y_deg) * 0.5f);
    const float tan_x = tan_y * static_cast<float>(camera.width) / static_cast<float>(camera.height);
    const glm::vec3 way = -glm::vec3(to_world[2]) + glm::vec3(to_world[0]) * (tan_x * (2 * place.x - 1)) +
                          glm::vec3(to_world[1]) * (tan_y * (1 - 2 * place.y));
    // Half of what blended surfaces cover is seen.
    return tracer.first_hit(camera.position_m, glm::normalize(way), 0.5f, bake::Sees::everything);
}

float lux_at(const bake::Surface& surface, const scene::Lit& lit, const Session& session,
             const bake::Tracer& tracer) {
    const scene::LitAir air{haze_of(*session.show),
                            {session.show->attenuation.constant, session.show->attenuation.linear,
                             session.show->attenuation.quadratic}};
    glm::vec3 sum(0);
    for (const shared::Light& light : lit.lights) {
        const glm::vec3 arrives =
            scene::illuminance(light, surface.position, surface.facet_normal, session.gobos.images, air);
        if (arrives == glm::vec3(0)) continue;
        float share = 1;
        const bake::Surface* const one = &surface;
        // The light's own shadow begins where its distance map was made.
        if (session.shadows) tracer.visibility(&one, 1, light.position_m - light.off_map_m, &share);
        sum += arrives * share;
    }
    return shared::luminance_of(sum) + even_lux(*session.show);
}

} // namespace ghost::app
