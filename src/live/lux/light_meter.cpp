// SPDX-License-Identifier: Apache-2.0
#include "live/lux/light_meter.h"

#include "light/illuminance.h"
#include "shared/develop.h"
#include "show/camera_moves.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace ghost::app {
namespace {

constexpr int kRings = 4, kRaysOfRing = 12; // of surface_near
constexpr float kBefore_m = 0.1f;           // what is less before another thing is at it
constexpr std::uint64_t kFewImages = 1;     // bytes: it keeps none

// One more relighter of the session, for it has to hear of what moves in the picture as the others do.
void make_lux_light(Session& session) {
    render::Settings settings = draw_settings(session.atmosphere(), session.live->camera(), session.options);
    settings.illuminance = true;
    settings.air = false;
    settings.lens.on = false;
    settings.glare.strength = 0;
    settings.beams.most_wide_step = 1;
    settings.image_memory_bytes = kFewImages;
    session.lux_light = std::make_unique<render::Relighter>(
        *session.device, session.live->g_buffer(), session.live->distances(), session.gobos.images,
        static_cast<int>(session.lit().lights.size()), settings);
    session.lux_light->set_flies(session.flies);
    session.lux_light->set_room_light(session.bounced);
}

} // namespace

image::ImageF lux_picture(Session& session, const scene::FrameLights& lit, bool rests) {
    if (!session.lux_light) make_lux_light(session);
    const Atmosphere air = session.atmosphere();
    session.lux_light->set_air(air.field());
    session.lux_light->set_slides(session.gobos.images.slides);
    session.lux_light->draw(lit, rests ? std::function<bool()>([] { return false; }) : nullptr);
    image::ImageF lux = luminance_of(session.lux_light->frame());
    const float even = shared::luminance_of(air.ambient); // it comes from everywhere
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

bake::Surface surface_on(const glm::vec3& from_m, const glm::vec3& way, const bake::Tracer& tracer) {
    // Half of what blended surfaces cover is seen.
    return tracer.first_hit(from_m, way, 0.5f, bake::Sees::everything);
}

bake::Surface surface_near(const glm::vec3& from_m, const glm::vec3& way, float beside,
                           const bake::Tracer& tracer) {
    const bake::Surface met = surface_on(from_m, way, tracer);
    const glm::vec3 along = std::abs(way.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    const glm::vec3 u = glm::normalize(glm::cross(way, along)), v = glm::cross(u, way);
    const float before_m =
        met.instance < 0 ? std::numeric_limits<float>::infinity() : met.distance_m - kBefore_m;
    for (int ring = 1; ring <= kRings && beside > 0; ++ring) {
        const float radius = beside * static_cast<float>(ring) / kRings;
        bake::Surface nearest = met;
        float nearest_m = before_m;
        for (int k = 0; k < kRaysOfRing; ++k) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kRaysOfRing;
            const glm::vec3 ray = glm::normalize(way + radius * (std::cos(turn) * u + std::sin(turn) * v));
            const bake::Surface one = surface_on(from_m, ray, tracer);
            if (one.instance < 0 || one.instance == met.instance || one.distance_m >= nearest_m) continue;
            if (tracer.stage().instances[static_cast<std::size_t>(one.instance)].fixture >= 0) continue;
            nearest = one;
            nearest_m = one.distance_m;
        }
        if (nearest_m < before_m) return nearest;
    }
    return met;
}

bake::Surface surface_at(const scene::Camera& camera, const glm::vec2& place, const bake::Tracer& tracer) {
    return surface_on(camera.position_m, scene::way_through(camera, place), tracer);
}

Lux lux_at(const bake::Surface& surface, std::span<const shared::Light> lights, const Atmosphere& air,
           const scene::GoboStack& gobos, const bake::Tracer* tracer, const scene::BounceVolumes* bounced) {
    shared::Haze haze = air.medium();
    if (bounced) haze.extinction_per_m = bounced->extinction_per_m;
    const scene::LitAir between{haze, air.field().attenuation};
    glm::vec3 sum(0);
    for (const shared::Light& light : lights) {
        const glm::vec3 arrives =
            scene::illuminance(light, surface.position, surface.facet_normal, gobos.images, between);
        if (arrives == glm::vec3(0)) continue;
        float share = 1;
        const bake::Surface* const one = &surface;
        // The light's own shadow begins where its distance map was made.
        if (tracer) tracer->visibility(&one, 1, light.position_m - light.off_map_m, &share);
        sum += arrives * share;
    }
    Lux lux;
    if (bounced) lux.bounced = shared::luminance_of(lux_on(*bounced, surface.position, surface.facet_normal));
    lux.all = shared::luminance_of(sum) + shared::luminance_of(air.ambient) + lux.bounced;
    return lux;
}

Lux lux_at(const bake::Surface& surface, const scene::FrameLights& lit, const Session& session,
           const bake::Tracer& tracer) {
    return lux_at(surface, lit.lights, session.atmosphere(), session.gobos,
                  session.shadows ? &tracer : nullptr, session.bounced.get());
}

std::function<float(const glm::vec3& place_m, const glm::vec3& normal)>
bounced_lx_in(const scene::BounceVolumes* bounced) {
    if (!bounced) return {};
    return [bounced](const glm::vec3& place_m, const glm::vec3& normal) {
        return shared::luminance_of(lux_on(*bounced, place_m, normal));
    };
}

} // namespace ghost::app
