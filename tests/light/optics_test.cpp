// SPDX-License-Identifier: Apache-2.0
// The optics of a gate: prisms keep the light, blades cut along their half planes, focus picks the plane that
// is sharp, blur is that of a lens. Frost: frost_test.cpp.
#include "dmx/wire/universes.h"
#include "light/private/gate.h"
#include "light/rig.h"
#include "photometry/photometry.h"
#include "support/optics_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

namespace ghost::scene {
namespace {

// All its light comes out of the lens, and 10 m before it a meter reads what a data sheet says: lumens over
// the solid angle of its angles, over 10 m squared.
TEST(Lens, ABeamLeavesItWholeAndHasItsAngleOnAWall) {
    for (const float zoom_deg : {1.5f, 4.0f, 8.0f, 20.0f, 40.0f}) {
        fixture::BeamState beam = open_beam();
        beam.optics.zoom_deg = zoom_deg;
        const shared::Light light = light_of(beam);
        const fixture::Beam& source =
            *profile_type().geometries[static_cast<std::size_t>(beam.geometry)].beam;
        EXPECT_NEAR(light.lens_m * light.tan_field, source.beam_radius_m, 1e-5f) << zoom_deg;
        EXPECT_NEAR(flux_lm(light, 8.0) / static_cast<double>(source.luminous_flux_lm), 1.0, 0.01);
        const vec3 lens_m = light.position_m + light.lens_m * light.axis_w;
        EXPECT_LT(glm::length(lens_m - vec3(beam.to_fixture[3])), 1e-4f);
        const auto lux = [&](float from_lens_m) {
            const float z = light.lens_m + from_lens_m;
            return shared::beam_candela(light, {0, 0, z}, gobos().images).y / (z * z);
        };
        // Even over the lens as near as this, but for a profile that is brighter in its middle.
        const double even_lx = static_cast<double>(source.luminous_flux_lm) /
                               (3.14159265 * std::pow(static_cast<double>(source.beam_radius_m), 2));
        EXPECT_GT(static_cast<double>(lux(1e-3f)), 0.45 * even_lx) << zoom_deg;
        EXPECT_LT(static_cast<double>(lux(1e-3f)), 2.5 * even_lx) << zoom_deg;
        EXPECT_EQ(lux(-1e-3f), 0.0f) << "dark behind the lens";
        if (source.beam_radius_m > kMeasured_m * std::tan(glm::radians(zoom_deg) / 2) * 0.66f) continue;
        const float beam_deg = zoom_deg * source.beam_angle_deg / source.field_angle_deg;
        const float sheet_cd = peak_candela(make_profile(beam_deg, zoom_deg, true), source.luminous_flux_lm);
        EXPECT_NEAR(lux(kMeasured_m) * 100.0f / sheet_cd, 1.0f, 0.02f) << zoom_deg;
        EXPECT_NEAR(light.intensity_cd.y * measured_fraction(light) / sheet_cd, 1.0f, 0.02f) << zoom_deg;
    }
}

TEST(Prism, ConservesTheFlux) {
    const double open_lm = flux_lm(open_beam());
    EXPECT_NEAR(open_lm, 10000.0, 50.0);
    for (const float in : {1.0f, 0.4f})
        for (const int slot : {1, 2})
            for (const bool stacked : {false, true}) {
                fixture::BeamState beam = open_beam();
                beam.optics.prisms.push_back(
                    {.number = 1, .wheel = wheel_number("Prism 1"), .slot = slot, .in = in, .deg = 33});
                if (stacked)
                    beam.optics.prisms.push_back(
                        {.number = 2, .wheel = wheel_number("Prism 2"), .slot = 1, .in = 1, .deg = 10});
                const double lm = flux_lm(beam);
                std::printf("prism slot %d, in %.1f%s: %.2f %% of the open beam\n", slot,
                            static_cast<double>(in), stacked ? ", stacked" : "", 100 * lm / open_lm);
                EXPECT_NEAR(lm / open_lm, 1.0, 0.005);
            }
}

TEST(Prism, StandsWhereItsFacetsSay) {
    fixture::BeamState beam = open_beam();
    beam.optics.prisms.push_back(
        {.number = 1, .wheel = wheel_number("Prism 1"), .slot = 1, .in = 1, .deg = 90});
    const std::vector<Copy> copies = copies_of(profile_type(), beam.optics, kMostCopies);
    ASSERT_EQ(copies.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(copies[k].aside.x, 0.0f, 1e-5f) << "a line along u, a quarter turn further";
        EXPECT_NEAR(copies[k].aside.y, 1.25f * (static_cast<float>(k) - 2.5f), 1e-5f);
        EXPECT_NEAR(copies[k].fraction.y, 1.0f / 6.0f, 1e-5f);
    }
    const shared::Light light = light_of(beam);
    const shared::Light one = copied(light, copies[5]);
    const vec3 aim = shared::to_gate(light, one.axis_w);
    EXPECT_NEAR(aim.y / (aim.z * light.tan_field), 3.125f, 1e-4f);
    EXPECT_NEAR(glm::distance(one.position_m + one.lens_m * one.axis_w,
                              light.position_m + light.lens_m * light.axis_w),
                0.0f, 1e-5f)
        << "it turns about the lens";
    EXPECT_EQ(one.position_m - one.off_map_m, light.position_m - light.off_map_m)
        << "and keeps its distance map";
}

// A prism with a hundred facets, one that is broken, one that stretches.
TEST(Prism, StaysRightWithWhateverAFileSays) {
    fixture::Type type = profile_type();
    fixture::Wheel wheel;
    fixture::Slot many{.name = "many"}, broken{.name = "broken"}, cylinder{.name = "cylinder"},
        named{.name = "P01 (6F Linear)"};
    for (int k = 0; k < 100; ++k) {
        fixture::Facet facet;
        facet.rotation[6] = 3.0f * std::cos(static_cast<float>(k)) * std::sqrt(static_cast<float>(k) / 100);
        facet.rotation[7] = 3.0f * std::sin(static_cast<float>(k)) * std::sqrt(static_cast<float>(k) / 100);
        many.facets.push_back(facet);
    }
    fixture::Facet facet;
    facet.rotation = {0, 0, 0, 0, 0, 0, NAN, INFINITY, 1};
    broken.facets.push_back(facet);
    facet.rotation = {14.5f, 0, 0, 0, 1.5f, 0, 0, 0, 1};
    cylinder.facets.push_back(facet);
    wheel.slots = {many, broken, cylinder, named};
    type.wheels.push_back(wheel);
    for (int slot = -1; slot < 5; ++slot) {
        Optics optics = open_beam().optics;
        optics.prisms.push_back(
            {.number = 1, .wheel = static_cast<int>(type.wheels.size()) - 1, .slot = slot, .in = 1});
        for (int stacked = 0; stacked < 2; ++stacked) {
            const std::vector<Copy> copies = copies_of(type, optics, kMostCopies);
            EXPECT_LE(copies.size(), static_cast<std::size_t>(kMostCopies));
            EXPECT_GE(copies.size(), 1u);
            vec3 fraction(0.0f);
            for (const Copy& copy : copies) {
                fraction += copy.fraction;
                EXPECT_TRUE(std::isfinite(copy.aside.x) && std::isfinite(copy.aside.y));
                EXPECT_GT(copy.scale, 0.0f);
            }
            EXPECT_NEAR(fraction.y, 1.0f, 1e-3f) << "slot " << slot;
            optics.prisms.push_back(optics.prisms[0]);
        }
    }
    EXPECT_EQ(facets_of(named).size(), 6u) << "by its name";
    EXPECT_EQ(facets_of(fixture::Slot{.name = "Prism"}).size(), 3u);
    EXPECT_GT(facets_of(cylinder).size(), 5u);
}

TEST(Prism, AFixtureKeepsTheNumberOfItsLights) {
    const Show show = profile_show();
    Rig rig(show);
    dmx::Levels levels{};
    levels[0] = 255;
    std::size_t count = 0;
    for (const int prism : {0, 100, 200}) {
        levels[18] = static_cast<std::uint8_t>(prism);
        dmx::Universes universes;
        universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
        rig.step(universes, 10.0);
        const FrameLights lit = rig.lit(gobos(), DistanceMaps{});
        if (count == 0) count = lit.lights.size();
        EXPECT_EQ(lit.lights.size(), count);
        const auto shining =
            std::count_if(lit.lights.begin(), lit.lights.end(),
                          [](const shared::Light& light) { return light.intensity_cd.x > 0.0f; });
        EXPECT_EQ(shining, prism == 0 ? 1 : (prism == 100 ? 6 : 8));
        EXPECT_EQ(lit.faces.size(), prism == 0 ? 1u : (prism == 100 ? 7u : 9u));
    }
}

TEST(Blades, CutAlongTheLineOfTheirCorners) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    for (int k = 0; k < 200; ++k) {
        fixture::BeamState beam = open_beam();
        const float all_deg = 90 * unit(random) - 45;
        beam.optics.shaper_deg = all_deg;
        for (int side = 0; side < 4; ++side)
            beam.optics.blades.push_back(
                {unit(random) < 0.3f ? 0.0f : unit(random), unit(random) < 0.3f ? 0.0f : unit(random)});
        const shared::Light light = light_of(beam);
        for (int sample = 0; sample < 200; ++sample) {
            const vec2 at(2 * unit(random) - 1, 2 * unit(random) - 1);
            bool covered = false, near = false;
            for (int side = 0; side < 4; ++side) {
                const fixture::Blade& blade = beam.optics.blades[static_cast<std::size_t>(side)];
                if (blade.a < 1e-3f && blade.b < 1e-3f) continue;
                // In the blade's own frame it comes from above; right, bottom, left are quarter turns
                // clockwise.
                const float turn = glm::radians(90.0f * static_cast<float>(side) - all_deg);
                const vec2 own(std::cos(turn) * at.x - std::sin(turn) * at.y,
                               std::sin(turn) * at.x + std::cos(turn) * at.y);
                const float line = 1 - 2 * blade.a + (own.x + 1) * (blade.a - blade.b);
                covered = covered || own.y > line;
                near = near || std::abs(own.y - line) < 0.06f;
            }
            if (near) continue;
            const float fraction = shared::blades_transmittance(light, at, shared::even_focus(light, 0.02f));
            EXPECT_NEAR(fraction, covered ? 0.0f : 1.0f, 1e-4f);
        }
    }
}

TEST(Blades, ABladeThatTurnsTouchesTheRimUntilItMovesIn) {
    for (const float deg : {-30.0f, 0.0f, 30.0f}) {
        const shared::Blade out = blade_plane({0.002f, 0.002f, deg}, 0, 0);
        EXPECT_NEAR(out.offset, 1.0f, 0.005f);
        const shared::Blade half = blade_plane({0.5f, 0.5f, deg}, 0, 0);
        EXPECT_NEAR(half.offset, 1.0f - std::cos(glm::radians(deg)), 1e-5f);
        EXPECT_NEAR(half.normal.x, -std::sin(glm::radians(deg)), 1e-5f) << "counter-clockwise";
    }
    EXPECT_GT(blade_plane({0, 0, 30}, 2, 0).offset, 2.0f) << "out is out";
}

// A slit that is narrower than its blur lets through what a sharp one does.
TEST(Blades, ABlurredSlitKeepsItsLight) {
    fixture::BeamState beam = open_beam();
    beam.optics.blades = {{0.45f, 0.45f}, {}, {0.45f, 0.45f}, {}};
    const shared::Light light = light_of(beam);
    for (const float blur : {0.02f, 0.1f, 0.3f}) {
        double sum = 0;
        for (int k = 0; k < 4000; ++k)
            sum += static_cast<double>(
                       shared::blades_transmittance(light, vec2(0, (static_cast<float>(k) + 0.5f) / 2000 - 1),
                                                    shared::even_focus(light, blur))) /
                   2000;
        EXPECT_NEAR(sum, 0.2, 0.001) << blur;
    }
}

// Slope of an edge where it is half, on the way to the wall: the plane in focus has the steepest.
float width_of(const std::function<float(float)>& fraction) {
    float low = -1, high = 1;
    for (int k = 0; k < 40; ++k) {
        const float middle = 0.5f * (low + high);
        (fraction(middle) > 0.5f ? low : high) = middle;
    }
    return 0.02f / std::max(fraction(low - 0.01f) - fraction(low + 0.01f), 1e-6f);
}

TEST(Focus, PicksThePlaneThatIsSharp) {
    const auto with_focus = [&](float depth_of_sharp) {
        fixture::BeamState beam = open_beam();
        beam.optics.iris = 0.6f;
        beam.optics.blades = {{0.4f, 0.4f}, {}, {}, {}};
        shared::Light light = light_of(beam);
        light.focus_per_m = 1.0f / 8.0f + depth_of_sharp * light.tan_field / light.lens_radius_m;
        return light;
    };
    for (const float depth : {kIrisDepth, kBladeDepth[0]}) {
        const shared::Light light = with_focus(depth);
        EXPECT_EQ(light.shaped, 2u);
        const shared::Focus focus = shared::beam_focus(light, light.lens_m + 8.0f);
        EXPECT_NEAR(shared::blur_of(light, focus, depth), light.edge, 2e-3f);
        const float other = depth == kIrisDepth ? kBladeDepth[0] : kIrisDepth;
        EXPECT_GT(shared::blur_of(light, focus, other), light.edge + 0.015f);
    }
    const shared::Light light = with_focus(kBladeDepth[0]);
    const auto blade_at = [&](float from_lens_m) {
        return width_of([&](float y) {
            return shared::blades_transmittance(light, {0, y},
                                                shared::beam_focus(light, light.lens_m + from_lens_m));
        });
    };
    EXPECT_GT(blade_at(4), 1.5f * blade_at(8)) << "in the air before the wall";
    EXPECT_GT(blade_at(30), 1.5f * blade_at(8));
}

TEST(Focus, OnePlaneAloneNeedsNoShape) {
    fixture::BeamState beam = open_beam();
    EXPECT_EQ(light_of(beam).shaped, 0u);
    beam.optics.iris = 0.5f;
    EXPECT_EQ(light_of(beam).shaped, 0u) << "focus lies on the iris";
    beam.optics.gobo_wheels.push_back({.wheel = wheel_number("Static gobos"), .number = 1, .position = 1});
    EXPECT_EQ(light_of(beam).shaped, 1u);
    beam.optics.iris = 1.0f;
    EXPECT_EQ(light_of(beam).shaped, 0u) << "the rim is the gobo's";
    EXPECT_EQ(light_of(beam).wheel_count, 1u);
    beam.optics.gobo_wheels.push_back({.wheel = wheel_number("Rotating gobos"), .number = 2, .position = 1});
    EXPECT_EQ(light_of(beam).shaped, 1u);
    beam.optics.blades = {{}, {}, {}, {}};
    beam.optics.gobo_wheels.clear();
    EXPECT_EQ(light_of(beam).shaped, 0u) << "blades that are out cost nothing";
}

// Rays from all over the lens, through the point of the gate's sharp image that they come from, onto a wall:
// how the light of a slit of the gate lies there. Against beam_candela.
TEST(Focus, BlursAsALensDoes) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0, 1);
    fixture::BeamState beam = open_beam();
    beam.optics.focus_m = 10.0f;
    beam.optics.blades = {{0.35f, 0.35f}, {}, {0.35f, 0.35f}, {}};
    shared::Light light = light_of(beam);
    for (shared::Blade& blade : light.blade) blade.depth = 0;
    light.iris_depth = 0;
    const double R = static_cast<double>(light.lens_radius_m), tan = static_cast<double>(light.tan_field);
    const double lens = static_cast<double>(light.lens_m),
                 sharp = 1.0 / static_cast<double>(light.focus_per_m);
    double worst = 0;
    for (const double from_lens : {5.0, 8.0, 10.0, 16.0, 30.0, 60.0}) {
        const double z = lens + from_lens; // from the apex
        constexpr int kBins = 160;
        std::vector<double> traced(kBins), drawn(kBins);
        double traced_all = 0, drawn_all = 0;
        const double half = 1.5 * z * tan;
        for (int k = 0; k < 400000; ++k) {
            const double pr = R * std::sqrt(unit(random)), pa = 6.283185307 * unit(random);
            const double gy = 0.6 * unit(random) - 0.3;
            // The slit's image at the sharp distance; the ray goes on from the lens through it.
            const double image = gy * (lens + sharp) * tan;
            const double lens_y = pr * std::sin(pa);
            const double y = lens_y + (image - lens_y) * from_lens / sharp;
            const auto at = static_cast<long>((y / half + 1) * 0.5 * kBins);
            if (at >= 0 && at < kBins) traced[static_cast<std::size_t>(at)] += 1;
            traced_all += 1;
        }
        for (int k = 0; k < kBins * 20; ++k) {
            const double y = ((k + 0.5) / (kBins * 20) * 2 - 1) * half;
            const float gate = static_cast<float>(y / (z * tan));
            const double fraction = static_cast<double>(shared::blades_transmittance(
                light, {0, gate}, shared::beam_focus(light, static_cast<float>(z))));
            drawn[static_cast<std::size_t>(k / 20)] += fraction;
            drawn_all += fraction;
        }
        double a = 0, b = 0, most = 0;
        for (int k = 0; k < kBins; ++k) {
            a += traced[static_cast<std::size_t>(k)] / traced_all;
            b += drawn[static_cast<std::size_t>(k)] / drawn_all;
            most = std::max(most, std::abs(a - b));
        }
        std::printf("slit, sharp at 10 m, seen at %5.2f m: flux distribution off by %.2f %%\n", from_lens,
                    100 * most);
        worst = std::max(worst, most);
    }
    EXPECT_LT(worst, 0.02);
}

// Beside a slot that stands in the gate a blur throws that slot's light, not its neighbour's.
TEST(Focus, ABlurredSlotHasNoNeighbour) {
    const fixture::Type& type = profile_type();
    constexpr float kBlur = 1.5f;
    float apart = 0.0f;
    for (std::uint32_t layer = 1; layer < static_cast<std::uint32_t>(gobos().images.layers); ++layer)
        for (float v = -1.0f; v <= 1.0f; v += 0.1f) {
            const shared::Wheel wheel{layer, layer, 0.0f, 1.0f, 0.0f, 0.0f};
            const vec2 beside(1.3f, v), other_side(1.3f - shared::kSlotSpacing, v);
            const vec3 seen = shared::wheel_sample(wheel, beside, kBlur, gobos().images);
            const vec3 own = shared::gobo_sample(layer, beside, kBlur, gobos().images);
            const vec3 others = shared::gobo_sample(layer, other_side, kBlur, gobos().images);
            EXPECT_LT(glm::length(seen - own), 1e-5f);
            apart = std::max(apart, glm::length(own - others));
        }
    EXPECT_GT(apart, 0.1f) << "these pictures do not tell, of " << type.name;
}

// Between two slots both shine, each blurred beyond its own rim: nothing is cut where they meet.
TEST(Focus, TwoBlurredSlotsAddUp) {
    constexpr float kBlur = 0.5f;
    const shared::Wheel open{0, 0, 0.5f, 1.0f, 0.0f, 0.0f};
    const vec3 middle = shared::wheel_sample(open, {0.0f, 0.0f}, kBlur, gobos().images);
    const float one = shared::beam_aperture(0.5f * shared::kSlotSpacing, 1.0f, kBlur);
    EXPECT_GT(one, 0.2f);
    EXPECT_NEAR(middle.y, 2.0f * one, 1e-5f);
    // A bright slot beside a darker one.
    for (std::uint32_t layer = 1; layer < static_cast<std::uint32_t>(gobos().images.layers); ++layer) {
        const shared::Wheel wheel{0, layer, 0.5f, 1.0f, 0.0f, 0.0f};
        const vec3 left = shared::wheel_sample(wheel, {-1e-3f, 0.0f}, kBlur, gobos().images);
        const vec3 right = shared::wheel_sample(wheel, {1e-3f, 0.0f}, kBlur, gobos().images);
        EXPECT_LT(glm::length(left - right), 0.02f) << layer;
    }
}

TEST(Disc, TurnsThroughTheGateAndSwingsOutOfIt) {
    fixture::BeamState beam = open_beam();
    fixture::Insert disc{.number = 1, .wheel = wheel_number("Animation wheel"), .slot = 0, .in = 1};
    beam.optics.animations = {disc};
    const shared::Light in = light_of(beam);
    ASSERT_GT(in.disc.layer, 0u);
    EXPECT_EQ(in.shaped, 2u);
    beam.optics.animations[0].deg = 30;
    const shared::Light turned = light_of(beam);
    double differs = 0;
    for (int k = 0; k < 100; ++k) {
        const vec2 at(0.15f * static_cast<float>(k % 10) - 0.7f, 0.15f * static_cast<float>(k / 10) - 0.7f);
        const auto fraction = [&](const shared::Light& light) {
            return shared::disc_sample(light, at, shared::even_focus(light, 0.02f), gobos().images).y;
        };
        differs += static_cast<double>(std::abs(fraction(in) - fraction(turned)));
    }
    EXPECT_GT(differs, 10.0);
    beam.optics.animations[0].in = 0.02f;
    const shared::Light out = light_of(beam);
    EXPECT_NEAR(shared::disc_sample(out, {-1, 0}, shared::even_focus(out, 0.01f), gobos().images).y, 1.0f,
                0.6f);
    EXPECT_NEAR(shared::disc_sample(out, {0.5f, 0}, shared::even_focus(out, 0.01f), gobos().images).y, 1.0f,
                1e-4f);
    beam.optics.animations[0].in = 0;
    EXPECT_EQ(light_of(beam).shaped, 0u);
}

} // namespace
} // namespace ghost::scene
