// SPDX-License-Identifier: Apache-2.0
// Physical values of a fixture -> shared::Light. Order of the optics: source and its correction
// (beam_colour.h), dimmer and shutter, flags, colour wheels, gate (gate.h), zoom, focus, frost.
#include "light/beam_shape.h"
#include "light/frame_lights.h"
#include "light/private/beam_colour.h"
#include "light/private/gate.h"
#include "photometry/photometry.h"
#include "shared/beam.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace ghost::scene {
namespace {

using glm::vec3;

constexpr std::uint32_t kOpenSamples = 4; // Screen Space Re-Rendering, section 2.2
constexpr std::uint32_t kGoboSamples = 10;
constexpr float kMinLens_m = 0.01f;
constexpr float kMostLens_m = 100.0f; // a beam that hardly widens

// Gate radius that leaves through the rim of the lens: the field, also where frost made it wider.
float rim_of(const Profile& profile) {
    const float field = std::pow(std::log2(10.0f) / profile.scale, 0.5f / profile.power);
    return std::clamp(field, 1.0f, std::max(profile.cut_radius, 1.0f));
}

// From the apex to the lens, so that the beam is as wide as its lens there.
float apex_distance_m(const fixture::Beam& source, const Profile& profile) {
    if (source.beam_type == fixture::BeamType::area) return kMinLens_m; // shared::near_fraction has its size
    return source.beam_radius_m / (profile.tan_field * rim_of(profile));
}

// The picture of a photometric file in place of the profile, wider or narrower as the zoom is. Lumens per
// candela.
float put_shape(const BeamShape& shape, const fixture::Beam& source, const fixture::Optics& optics,
                shared::Light& light) {
    const auto tan_half = [](float deg) {
        return std::tan(0.5f * glm::radians(std::clamp(deg, 0.1f, kWidestShape_deg)));
    };
    const float zoom = tan_half(optics.zoom_deg) / tan_half(source.field_angle_deg);
    light.tan_field = std::min(shape.tan_field * zoom, tan_half(kWidestShape_deg));
    // A laboratory measures from the lens, and the light comes from all over it and widens less (spread_of).
    const float even_tan = std::sqrt(shape.solid_angle(light.tan_field) / shared::kPi);
    light.tan_field *= lens_fraction(even_tan, source.beam_radius_m);
    light.profile_power = 1.0f;
    light.profile_scale = 0.0f;
    light.cut_radius = 1.0f;
    light.iris_radius = optics.iris < kOpenIris ? std::max(optics.iris, kLeastIris) : 2.0f;
    light.lens_radius_m = 0.0f;
    light.edge = shared::kGoboBlurUnit +
                 2.0f * std::tan(glm::radians(optics.frost * optics.frost_full_deg)) / light.tan_field;
    return shape.solid_angle(light.tan_field);
}

void add_shape(std::uint32_t layer, shared::Light& light) {
    if (light.wheel_count >= std::size(light.wheel)) return; // three gobos of the fixture's own are in
    shared::Wheel wheel{};
    wheel.layer_a = wheel.layer_b = layer;
    wheel.cosine = 1.0f;
    light.wheel[light.wheel_count++] = wheel;
    if (light.wheel_count > 2 && light.shaped == 0) light.shaped = 1;
}

} // namespace

shared::Light light_from(const fixture::Type& type, const fixture::BeamState& beam, const glm::mat4& to_world,
                         const GoboStack& gobos) {
    ProfileTable profiles;
    return light_from(type, beam, to_world, gobos, profiles, nullptr);
}

shared::Light light_from(const fixture::Type& type, const fixture::BeamState& beam, const glm::mat4& to_world,
                         const GoboStack& gobos, ProfileTable& profiles, const Projector* projector,
                         const BeamShape* shape) {
    const fixture::Optics& optics = beam.optics;
    const fixture::Beam& source = *type.geometries[static_cast<std::size_t>(beam.geometry)].beam;
    const bool hard_edge =
        source.beam_type == fixture::BeamType::spot || source.beam_type == fixture::BeamType::rectangle;

    const Spread spread =
        spread_of(optics.zoom_deg * source.beam_angle_deg / std::max(source.field_angle_deg, 0.01f),
                  optics.zoom_deg, source.beam_radius_m);
    const float iris = hard_edge ? std::clamp(optics.iris, 0.02f, 1.0f) : 1.0f;
    const MeasuredProfile& measured = source.beam_type == fixture::BeamType::area
                                          ? area_profile()
                                          : profiles.find(spread.beam_deg, spread.field_deg, hard_edge, iris,
                                                          optics.frost * optics.frost_full_deg);
    const Profile& profile = measured.profile;

    const glm::mat3 axes(to_world * beam.to_fixture);
    shared::Light light{};
    light.axis_u = glm::normalize(axes[0]);
    light.axis_v = glm::normalize(axes[1]);
    light.axis_w = -glm::normalize(axes[2]);
    light.tan_field = profile.tan_field;
    light.cut_radius = profile.cut_radius;
    light.profile_power = profile.power;
    light.profile_scale = profile.scale;
    light.edge = profile.edge;
    light.iris_radius = measured.aperture;
    light.rim_fraction = optics.frost > 0 ? -1.0f : rim_fraction(profile, measured.aperture);
    light.lens_radius_m = hard_edge ? source.beam_radius_m : 0.0f;
    light.disc_radius_m = source.beam_radius_m;
    light.focus_per_m = 1.0f / std::max(optics.focus_m, 0.1f);
    float apex_m = apex_distance_m(source, profile);

    vec3 colour = source_colour(type, source, optics) * flags_colour(type, source, optics);
    light.colour_b = vec3(1.0f);
    light.split = shared::kNoSplit;
    for (const fixture::WheelState& wheel : optics.color_wheels) {
        const SlotPair pair = slots_at(type, wheel);
        if (!pair.a) continue;
        const vec3 a = glm::max(slot_colour(type, source, *pair.a), vec3(1e-4f));
        colour *= a;
        if (pair.shift == 0.0f) continue;
        // One wheel at a time stands between two slots in practice; the last one wins.
        light.colour_b = slot_colour(type, source, *pair.b) / a;
        light.split = shared::kSlotSpacing * (0.5f - pair.shift);
    }
    float open_sr = measured.open_sr, lumens = source.luminous_flux_lm;
    const bool projects = projector && projector->media >= 0 &&
                          static_cast<std::size_t>(projector->media) < gobos.showing.size();
    if (projects) {
        light.lens_radius_m = source.beam_radius_m;
        open_sr = project(*projector, optics, gobos.showing[static_cast<std::size_t>(projector->media)],
                          static_cast<std::uint32_t>(projector->media), light);
        if (projector->lumens > 0) lumens = projector->lumens;
        light.rim_fraction = 1.0f; // an even field
        // The throw is measured from the lens.
        apex_m = kMinLens_m;
    }
    const auto measured_light = gobos.shapes.find(projects ? nullptr : shape);
    const bool is_measured = shape && measured_light != gobos.shapes.end();
    if (is_measured) {
        open_sr = put_shape(*shape, source, optics, light);
        lumens = static_cast<float>(shape->flux_lm);
        // As bright on the axis as a lens is that sends its light out evenly.
        apex_m = source.beam_radius_m * std::sqrt(shared::kPi / std::max(open_sr, 1e-9f));
    }
    if (source.beam_type == fixture::BeamType::area && !projects && !is_measured)
        light.panel_m = source.beam_radius_m;
    light.lens_m = std::clamp(apex_m, kMinLens_m, kMostLens_m);
    light.position_m = vec3(to_world * beam.to_fixture[3]) - light.lens_m * light.axis_w;
    const float peak_cd = open_sr > 0 ? lumens / open_sr : 0.0f;
    light.intensity_cd = colour * (peak_cd * optics.lamp * optics.dimmer * optics.shutter);

    const float sigma = std::tan(glm::radians(optics.frost * optics.frost_full_deg)) / profile.tan_field;
    // Standard deviation of a disc, or of a Gaussian that is half at the beam angle.
    const float width = hard_edge
                            ? 0.5f * iris
                            : std::tan(0.5f * glm::radians(spread.beam_deg)) / profile.tan_field / 1.17741f;
    const float pull = frost_pull(sigma, width);
    set_gate(type, optics, gobos, projects || is_measured ? 1.0f : pull, light);
    if (!projects && !is_measured && light.split < shared::kNoSplit) {
        // What comes from either side of the split mixes: where light of a place comes from is normal, too.
        const float soft = sigma / std::sqrt(pull);
        light.split_soft =
            std::sqrt(3.0f * soft * soft + shared::kSplitHalf * shared::kSplitHalf) - shared::kSplitHalf;
    }
    light.bounce_cd = light.intensity_cd *
                      ((projects || is_measured ? open_sr : measured.iris_sr) / (4.0f * shared::kPi)) *
                      gate_transmittance(light, gobos.images);
    if (projects)
        light.bounce_cd *=
            picture_transmittance(*projector, gobos.showing[static_cast<std::size_t>(projector->media)]);
    if (is_measured) add_shape(measured_light->second, light);
    // Frost spreads what the gate lets through.
    const bool is_split = light.split < shared::kNoSplit;
    if (!projects && optics.frost > 0 && (light.wheel_count > 0 || light.shaped != 0 || is_split)) {
        const auto clear = [&] {
            fixture::BeamState unfrosted = beam;
            unfrosted.optics.frost = 0;
            return light_from(type, unfrosted, to_world, gobos, profiles, projector, shape);
        };
        light.intensity_cd *=
            profiles.frost.correction(clear, light, gobos.images, light.lens_m + optics.focus_m);
    } else if (!projects && !is_measured && measured.sent_sr > 0) {
        light.intensity_cd *= measured.iris_sr / measured.sent_sr;
    }
    light.haze_samples = light.wheel_count > 0 || light.shaped != 0 || projects ? kGoboSamples : kOpenSamples;
    return light;
}

} // namespace ghost::scene
