#pragma once
// SPDX-License-Identifier: Apache-2.0
// The judge of bounced light: particles that leave the lamps as their beams send them (reference_beam.h),
// meet surfaces and haze, and are counted by order. Order 0 is the light straight from the lamps; what it
// becomes where it lands is order 1 when it lands again. Every meeting is also joined to the camera (light
// tracing), so that the same walk gives pictures. Surfaces scatter by their whole reflection, with their
// textures, from the normal of the facet; haze is even, with both lobes. Fixture bodies neither stop nor
// reflect anything; surfaces that shine by themselves send nothing. Lumens and cd/m^2, linear Rec.2020. The
// same input gives the same bytes on any number of threads. Nothing here is shared with what it judges
// (bounce/bounce.h).

#include "base/result.h"
#include "image/image.h"
#include "rays/tracer.h"
#include "reference/reference_beam.h"
#include "show/camera.h"

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::bake {

inline constexpr std::size_t kWalkOrders = 32;

struct WalkOptions {
    std::int64_t particles = 1'000'000; // rounded up to whole batches
    std::uint32_t seed = 1;
    int threads = 0; // 0: one per core
    // Where there is haze; light that leaves it and meets nothing more is lost.
    glm::vec3 air_low_m{-1e6f};
    glm::vec3 air_high_m{1e6f};
    const scene::Camera* camera = nullptr; // null: no picture
    int first_order = 1;                   // what the picture shows: orders from .. to
    int last_order = static_cast<int>(kWalkOrders) - 1;
    // Haze that bends light by an angle of a greater cosine begins no new order and counts nowhere.
    double straight_cosine = 2;
    BeamOverride beam;                             // candela of every light, for tests
    std::function<bool()> stop;                    // asked from any thread
    std::function<void(double fraction)> progress; // never two calls at once
};

// Lumens (luminance) of one order.
struct OrderPower {
    double on_surfaces = 0; // arrives
    double reflected = 0;   // of that, leaves again
    double in_air = 0;      // is scattered
    double absorbed_in_air = 0;
    double escaped = 0;
};

struct Walk {
    double sent_lm = 0;
    std::array<OrderPower, kWalkOrders> orders{};
    // Lumens that leave each instance of the stage, by order up to 4.
    std::vector<std::array<double, 5>> reflected_by_instance;
    image::ImageF picture; // 3 channels, or none
    image::ImageF error;   // likewise: standard deviation of the picture
};

// Errors: options out of range, stopped.
Result<Walk> walk_light(const Tracer& tracer, const std::vector<shared::Light>& lights,
                        const shared::Gobos& gobos, const shared::Haze& haze, const WalkOptions& options);

} // namespace ghost::bake
