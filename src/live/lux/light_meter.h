#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a light meter would show. lux_picture: illuminance of every surface that a free camera sees, with the
// shadows of its distance maps and the haze between lamp and surface; drawn on the device. lux_at: the same
// at one place, by rays. Even light is added to both, and where light bounces, what bounced. Lux; main
// thread.

#include "image/image.h"
#include "live/session/session.h"
#include "rays/tracer.h"

#include <functional>
#include <glm/glm.hpp>
#include <span>

namespace ghost::app {

// One channel; of the live picture that the session has now. lit: what Session::lit gives. rests: nothing
// moves, so that nothing is kept for the next one.
image::ImageF lux_picture(Session& session, const scene::FrameLights& lit, bool rests = true);

// cd/m^2 of each pixel, from what Relighter::frame gives; one channel.
image::ImageF luminance_of(const image::ImageF& frame);

// What an eye sees on its way (a unit vector), or a camera through a point of its picture, (0, 0) its top
// left corner; instance -1: nothing but air.
bake::Surface surface_on(const glm::vec3& from_m, const glm::vec3& way, const bake::Tracer& tracer);
// The same, but for a set piece that stands before it and is so near the way, by the tangent of the angle:
// through a lattice the way itself most often goes on.
bake::Surface surface_near(const glm::vec3& from_m, const glm::vec3& way, float beside,
                           const bake::Tracer& tracer);
bake::Surface surface_at(const scene::Camera& camera, const glm::vec2& place, const bake::Tracer& tracer);
struct Lux {
    float all = 0;
    float bounced = 0; // of that
};
// tracer: null: nothing throws a shadow. bounced: null: no light bounces.
Lux lux_at(const bake::Surface& surface, std::span<const shared::Light> lights, const Atmosphere& air,
           const scene::GoboStack& gobos, const bake::Tracer* tracer,
           const scene::BounceVolumes* bounced = nullptr);
// For an Explainer.
std::function<float(const glm::vec3& place_m, const glm::vec3& normal)>
bounced_lx_in(const scene::BounceVolumes* bounced);
Lux lux_at(const bake::Surface& surface, const scene::FrameLights& lit, const Session& session,
           const bake::Tracer& tracer);

} // namespace ghost::app
