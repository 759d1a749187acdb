// SPDX-License-Identifier: Apache-2.0
// From DMX bytes to candela through our two real fixture files: known answers worked out by hand from the
// data in the files (10000 lm, 5600 K, wheel colours as xyY) with numpy, outside of this code.
#include "light/rig.h"

#include "base/text.h"
#include "beam_groups/light_places.h"
#include "fixture_files/gdtf/gdtf.h"
#include "shared/beam.h"
#include "show/show.h"
#include "support/must.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;

// From the apex: peak of 10000 lm at 42.5 degrees field, 36.1 beam, and at 15 degrees field with the same
// ratio, on a wall 10 m before a lens of 7 cm, which takes 0.007 off the tangents.
constexpr float kWidePeak_cd = 34095.3f;
constexpr float kNarrowPeak_cd = 292120.3f;
constexpr float kWideTangent = 0.381879f;
const vec3 kLamp{1.046784f, 0.994273f, 0.858233f}; // CIE daylight of 5600 K, luminance 1

std::shared_ptr<const fixture::Type> read_type(const std::string& kind) {
    return std::make_shared<const fixture::Type>(
        must(fixture::load_gdtf(std::filesystem::path("assets/fixtures/Vari-Lite@VL2500_" + kind + ".gdtf")))
            .type);
}

std::shared_ptr<const fixture::Type> vl2500(const std::string& kind) {
    static const auto spot = read_type("Spot");
    static const auto wash = read_type("Wash");
    return kind == "Spot" ? spot : wash;
}

PatchedFixture hung(const std::string& kind, int address) {
    PatchedFixture fixture;
    fixture.name = kind + " " + std::to_string(address);
    fixture.type = vl2500(kind);
    fixture.address = address;
    fixture.position_m = {1, 2, 6};
    return fixture;
}

// Blurring takes a while, so every test has the same stack.
const GoboStack& spot_gobos() {
    static const GoboStack stack = [] {
        Show show;
        show.fixtures.push_back(hung("Spot", 1));
        Report report;
        GoboStack built = build_gobos(show, report);
        EXPECT_TRUE(report.messages.empty());
        EXPECT_EQ(built.images.layers, 17);
        return built;
    }();
    return stack;
}

// One fixture at address 1, its channels from 1 on.
struct Desk {
    Show show;
    const GoboStack& gobos = spot_gobos();
    Passes passes;
    dmx::Levels levels{};

    explicit Desk(const std::string& kind) {
        show.fixtures.push_back(hung(kind, 1));
        set(1, 255).set(2, 128).set(4, 128).set(12, 255).set(17, 255); // full, centred, wide, iris open
        if (kind == "Wash") set(10, 255).set(12, 0).set(17, 0);
    }
    Desk& set(int channel, int value) {
        levels[static_cast<std::size_t>(channel - 1)] = static_cast<std::uint8_t>(value);
        return *this;
    }
    dmx::Universes universes() const {
        dmx::Universes result;
        result.at(1).levels = std::make_shared<const dmx::Levels>(levels);
        return result;
    }
    shared::Light light() const {
        Rig rig(show);
        rig.step(universes(), 1.0 / 30);
        const std::vector<shared::Light> lights = rig.lights(gobos, passes);
        EXPECT_EQ(lights.size(), 1u);
        return lights.at(0);
    }
    // Candela towards a gate position, at the distance of the sharp picture.
    vec3 candela(vec2 gate) const {
        const shared::Light now = light();
        const float z = now.lens_m + 1.0f / now.focus_per_m;
        return shared::beam_candela(now, vec3(gate * z * now.tan_field, z), gobos.images);
    }
};

void expect_colour(const vec3& value, const vec3& expected, float relative) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(value[c], expected[c], std::abs(expected[c]) * relative) << "channel " << c;
}

TEST(rig, OpenWhite) {
    expect_colour(Desk("Spot").candela({0, 0}), kWidePeak_cd * kLamp, 0.002f);
    expect_colour(Desk("Spot").set(12, 0).candela({0, 0}), kNarrowPeak_cd * kLamp, 0.002f);
}

TEST(rig, DimmerScalesLinearly) {
    expect_colour(Desk("Spot").set(1, 51).candela({0, 0}), 0.2f * kWidePeak_cd * kLamp, 0.002f);
    EXPECT_EQ(Desk("Spot").set(1, 0).candela({0, 0}), vec3(0.0f));
    EXPECT_EQ(Desk("Spot").set(11, 4).candela({0, 0}), vec3(0.0f)) << "shutter closed";
}

TEST(rig, FlagsFilterByBeersLaw) {
    const vec3 open = kWidePeak_cd * kLamp;
    expect_colour(Desk("Spot").set(6, 255).candela({0, 0}), open * vec3(0.03f, 0.72f, 0.90f), 0.002f);
    expect_colour(Desk("Spot").set(7, 255).candela({0, 0}), open * vec3(0.95f, 0.80f, 0.02f),
                  0.002f); // yellow
    expect_colour(Desk("Spot").set(8, 255).candela({0, 0}), open * vec3(0.80f, 0.03f, 0.75f), 0.002f);
    // A fifth of cyan: 0.03^0.2, 0.72^0.2, 0.90^0.2.
    expect_colour(Desk("Spot").set(6, 51).candela({0, 0}), open * vec3(0.49593f, 0.93641f, 0.97915f), 0.002f);
    // Cyan and yellow make green.
    expect_colour(Desk("Spot").set(6, 255).set(7, 255).candela({0, 0}), open * vec3(0.0285f, 0.576f, 0.018f),
                  0.002f);
}

TEST(rig, ColourWheelAndSplitColours) {
    const vec3 open = kWidePeak_cd * kLamp;
    const vec3 blue = open * vec3(0.017432f, 0.008570f, 0.499309f);
    const vec3 yellow = open * vec3(0.959420f, 0.773934f, 0.054539f);
    expect_colour(Desk("Spot").set(9, 18).candela({0, 0}), open * vec3(0.408206f, 0.018550f, 0.003158f),
                  0.005f);
    Desk split("Spot");
    split.set(9, 45); // half blue, half yellow
    const shared::Light light = split.light();
    EXPECT_NEAR(light.split, 0.0f, 1e-6f);
    const float off_axis = shared::beam_profile(0.25f, light.profile_power, light.profile_scale);
    expect_colour(split.candela({-0.5f, 0}), blue * off_axis, 0.005f);
    expect_colour(split.candela({0.5f, 0}), yellow * off_axis, 0.005f);
    expect_colour(split.candela({0, 0.5f}), (blue + yellow) * 0.5f * off_axis,
                  0.005f); // the soft border between
}

TEST(rig, ColourWheelGoesRound) {
    Desk desk("Spot");
    desk.set(9, 207); // between UV, the last slot, and open
    const shared::Light light = desk.light();
    EXPECT_NEAR(light.split, 0.0f, 1e-6f);
    const vec3 right = light.intensity_cd * light.colour_b;
    expect_colour(right, kWidePeak_cd * kLamp, 0.005f);
}

TEST(rig, ZoomAndIris) {
    EXPECT_NEAR(Desk("Spot").light().tan_field, kWideTangent, 1e-5f);         // tan 21.25 - 0.007
    EXPECT_NEAR(Desk("Spot").set(12, 0).light().tan_field, 0.124652f, 1e-5f); // tan 7.5 - 0.007
    EXPECT_NEAR(Desk("Spot").set(17, 0).light().iris_radius, 0.1f, 1e-6f);
    const vec3 inside = Desk("Spot").candela({0.05f, 0});
    EXPECT_EQ(Desk("Spot").set(17, 0).candela({0.05f, 0}), inside);
    EXPECT_EQ(Desk("Spot").set(17, 0).candela({0.15f, 0}), vec3(0.0f));
    EXPECT_GT(Desk("Spot").candela({0.15f, 0}).y, 0.9f * kWidePeak_cd);
}

TEST(rig, WashHalfAtTheBeamAngle) {
    const Desk wash("Wash");
    const vec3 peak = wash.candela({0, 0});
    EXPECT_NEAR(wash.light().tan_field, 0.516131f, 1e-5f); // tan 27.75 - 0.01
    const float beam_radius = 0.299072f / 0.526131f;       // tan 16.65
    expect_colour(wash.candela({beam_radius, 0}), peak * 0.5f, 0.005f);
    expect_colour(wash.candela({0, -1.0f}), peak * 0.1f, 0.02f);
    EXPECT_EQ(wash.light().wheel_count, 0u);
    EXPECT_EQ(wash.light().haze_samples, 4u);
}

TEST(rig, GobosOfBothWheels) {
    Desk desk("Spot");
    EXPECT_EQ(desk.light().wheel_count, 0u);
    EXPECT_EQ(desk.light().haze_samples, 4u);
    desk.set(13, 72).set(14, 41).set(15, 64); // night sky; gothic window turned by 90 degrees
    const shared::Light light = desk.light();
    ASSERT_EQ(light.wheel_count, 2u);
    EXPECT_EQ(light.haze_samples, 10u);
    const fixture::Type& type = *desk.show.fixtures[0].type;
    EXPECT_EQ(light.wheel[0].layer_a, desk.gobos.layer(&type, type.wheels[1].slots[4].media));
    EXPECT_EQ(light.wheel[1].layer_a, desk.gobos.layer(&type, type.wheels[2].slots[2].media));
    EXPECT_GT(light.wheel[0].layer_a, 0u);
    EXPECT_NE(light.wheel[0].layer_a, light.wheel[1].layer_a);
    EXPECT_EQ(light.wheel[0].shift, 0.0f);
    EXPECT_NEAR(light.wheel[1].cosine, 0.0f, 1e-3f);
    EXPECT_NEAR(light.wheel[1].sine, 1.0f, 1e-3f);
    // Both filter: the candela is the product of what each alone lets through. They stand in two planes.
    EXPECT_EQ(light.shaped, 1u);
    shared::Light first = light, second = light, open = light;
    first.wheel_count = second.wheel_count = 1;
    second.wheel[0] = light.wheel[1];
    open.wheel_count = 0;
    for (const vec3 q : {vec3(0.1f, 0.2f, 8), vec3(-0.4f, 0.3f, 8), vec3(0.2f, -0.6f, 8), vec3(0, 0, 8)}) {
        const auto candela = [&](const shared::Light& one) {
            return shared::beam_candela(one, q, desk.gobos.images);
        };
        expect_colour(candela(light), candela(first) * candela(second) / candela(open), 1e-4f);
    }
}

TEST(rig, HalfGoboShowsBothSlots) {
    Desk desk("Spot");
    desk.set(13, 63); // medium circles and night sky
    const shared::Light light = desk.light();
    const fixture::Type& type = *desk.show.fixtures[0].type;
    ASSERT_EQ(light.wheel_count, 1u);
    EXPECT_EQ(light.wheel[0].layer_a, desk.gobos.layer(&type, type.wheels[1].slots[3].media));
    EXPECT_EQ(light.wheel[0].layer_b, desk.gobos.layer(&type, type.wheels[1].slots[4].media));
    EXPECT_NEAR(light.wheel[0].shift, 0.5f, 1e-5f);
    // Between the rims of the two slots the wheel itself stops the light.
    EXPECT_LT(desk.candela({0, 0}).y, 0.01f * kWidePeak_cd);
}

// The isotropic source of the same lumens: 10000 / (4 pi) = 795.77 cd.
TEST(rig, BouncedLightHasTheLumensOfTheBeam) {
    for (const char* kind : {"Spot", "Wash"})
        expect_colour(Desk(kind).light().bounce_cd, 795.775f * kLamp, 0.002f);
    expect_colour(Desk("Spot").set(12, 0).light().bounce_cd, 795.775f * kLamp, 0.002f); // any zoom
    expect_colour(Desk("Spot").set(1, 51).light().bounce_cd, 159.155f * kLamp, 0.002f);
    // A tenth of the radius: 1 % of an even disc; the middle is a little brighter than the mean.
    const float narrow = Desk("Spot").set(17, 0).light().bounce_cd.y / (795.775f * kLamp.y);
    EXPECT_GT(narrow, 0.009f);
    EXPECT_LT(narrow, 0.02f);
    const float through_gobo = Desk("Spot").set(13, 72).light().bounce_cd.y / (795.775f * kLamp.y);
    EXPECT_GT(through_gobo, 0.02f);
    EXPECT_LT(through_gobo, 0.9f);
}

TEST(rig, HeadPointsWhereTheDeskSays) {
    Desk desk("Spot");
    desk.set(2, 128).set(3, 0).set(4, 128).set(5, 0); // centred: straight down
    shared::Light light = desk.light();
    EXPECT_NEAR(light.axis_w.z, -1.0f, 1e-4f);
    // The pivot is 0.395 m below the clamp, the lens 0.255 m before it.
    const auto expect_lens = [&](const vec3& expected_m) {
        const vec3 lens_m = light.position_m + light.lens_m * light.axis_w;
        const vec3 map_m = light.position_m - light.off_map_m;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(lens_m[axis], expected_m[axis], 1e-4f);
            EXPECT_NEAR(map_m[axis], vec3(1, 2, 5.605f)[axis], 1e-5f)
                << "a moving light turns, its map stays";
        }
    };
    expect_lens({1, 2, 5.35f});
    // The beam is as wide as its lens there, and has its angle on a wall 10 m before it.
    EXPECT_NEAR(light.lens_m * light.tan_field, 0.07f, 1e-4f);
    EXPECT_NEAR((light.lens_m + 10.0f) * light.tan_field, 10.0f * std::tan(glm::radians(42.5f / 2)), 1e-3f);
    const int tilt = static_cast<int>(std::lround((90.0 + 135.0) / 270.0 * 65535.0));
    desk.set(4, tilt >> 8).set(5, tilt & 255); // upstage
    light = desk.light();
    EXPECT_NEAR(light.axis_w.y, 1.0f, 1e-4f);
    expect_lens({1, 2.255f, 5.605f});
    // A right-handed frame: right x up = back towards the lamp.
    EXPECT_NEAR(glm::dot(glm::cross(light.axis_u, light.axis_v), light.axis_w), -1.0f, 1e-5f);
    desk.show.fixtures[0].rotation_deg = {180, 0, 0}; // stands on the floor: down becomes up
    desk.set(4, 128).set(5, 0);
    EXPECT_NEAR(desk.light().axis_w.z, 1.0f, 1e-4f);
}

TEST(rig, GoboTurnsWithTime) {
    Desk desk("Spot");
    const int raw = 33032 + (65535 - 33032) / 2; // about 180 degrees a second
    desk.set(14, 146).set(15, raw >> 8).set(16, raw & 255);
    Rig rig(desk.show);
    rig.step(desk.universes(), 0.0);
    const auto turn_deg = [&] { return rig.states()[0].beams[0].optics.gobo_wheels[1].gobo_deg; };
    const float start = turn_deg();
    for (int frame = 0; frame < 30; ++frame) rig.step(desk.universes(), 1.0 / 30);
    const float speed = rig.states()[0].beams[0].optics.gobo_wheels[1].gobo_deg_s;
    EXPECT_NEAR(speed, 180.5f, 1.0f);
    EXPECT_NEAR(std::fmod(turn_deg() - start + 720.0f, 360.0f), speed, 0.1f);
}

TEST(rig, TheShowSaysWhetherMachinesTakeTheirTime) {
    Desk desk("Spot");
    for (const bool is_machine : {true, false}) {
        desk.show.motion = is_machine ? fixture::Motion::as_the_machine : fixture::Motion::as_commanded;
        desk.set(2, 0).set(3, 0);
        Rig rig(desk.show);
        rig.step(desk.universes(), 1.0 / 30);
        desk.set(2, 255).set(3, 255);
        rig.step(desk.universes(), 1.0);
        const float pan_deg = rig.states()[0].pan_deg;
        if (is_machine) {
            EXPECT_GT(pan_deg, -200.0f);
            EXPECT_LT(pan_deg, 0.0f);
        } else {
            EXPECT_EQ(pan_deg, 270.0f);
        }
    }
}

TEST(rig, SameLevelsSameBits) {
    Desk desk("Spot");
    desk.set(13, 72).set(14, 146).set(15, 200).set(11, 100).set(18, 20); // gobos, rotation, strobe, slow pan
    Rig a(desk.show), b(desk.show);
    for (int frame = 0; frame < 100; ++frame) {
        desk.set(2, frame).set(9, frame * 2);
        a.step(desk.universes(), 1.0 / 30);
        b.step(desk.universes(), 1.0 / 30);
        const std::vector<shared::Light> from_a = a.lights(desk.gobos, desk.passes);
        const std::vector<shared::Light> from_b = b.lights(desk.gobos, desk.passes);
        ASSERT_EQ(std::memcmp(from_a.data(), from_b.data(), from_a.size() * sizeof(shared::Light)), 0)
            << frame;
    }
}

TEST(rig, LightsFindTheirPasses) {
    Desk desk("Spot");
    EXPECT_EQ(desk.light().pass, 0u) << "no passes: number passes.lights.size() is the dark one";
    LightPass other, mine;
    other.fixture = "Someone else";
    mine.fixture = desk.show.fixtures[0].name;
    mine.position_m = {3, 4, 5};
    desk.passes.lights = {other, mine};
    EXPECT_EQ(desk.light().pass, 1u);
    EXPECT_LT(glm::distance(desk.light().position_m - desk.light().off_map_m, vec3(3, 4, 5)), 1e-5f)
        << "a pass says where its light stood";
    desk.passes.lights.pop_back();
    EXPECT_EQ(desk.light().pass, 1u) << "the dark one again";
}

TEST(rig, FixturesWithoutATypeHaveNoLight) {
    Desk desk("Spot");
    desk.show.fixtures.insert(desk.show.fixtures.begin(), PatchedFixture{});
    EXPECT_NEAR(desk.light().position_m.x - desk.light().off_map_m.x, 1.0f, 1e-5f); // still the one light
}

TEST(rig, NoDataIsDarkAndOtherUniversesDoNotMatter) {
    const Desk desk("Spot");
    Rig rig(desk.show);
    dmx::Universes universes;
    rig.step(universes, 0.0);
    EXPECT_EQ(rig.lights(desk.gobos, desk.passes).at(0).intensity_cd, vec3(0.0f));
    universes.at(2).levels = std::make_shared<const dmx::Levels>(desk.levels);
    rig.step(universes, 0.0);
    EXPECT_EQ(rig.lights(desk.gobos, desk.passes).at(0).intensity_cd, vec3(0.0f));
}

TEST(rig, WhoIsLeftDarkIsTold) {
    Desk desk("Spot");
    desk.show.fixtures.push_back(hung("Spot", 1));
    desk.show.fixtures.push_back(hung("Spot", 101)); // dark by its file
    desk.show.fixtures.push_back(PatchedFixture{});  // of no type
    Rig rig(desk.show);
    rig.leave_unasked_dark(true);
    rig.step(desk.universes(), 1.0 / 30, {{1, {.intensity = 1.0f}}});
    (void)rig.lit(desk.gobos, desk.passes);
    EXPECT_TRUE(rig.is_left_dark(0));
    EXPECT_FALSE(rig.is_left_dark(1)) << "a hand asks";
    EXPECT_FALSE(rig.is_left_dark(2));
    EXPECT_EQ(rig.left_dark(), 1u);
    fixture::Programmer zoomed, coloured;
    zoomed.zoom_deg = 20;
    coloured.colour = vec3(1, 1, 0);
    for (const fixture::Programmer& hand : {zoomed, coloured}) {
        rig.step(desk.universes(), 1.0 / 30, {{1, hand}});
        const FrameLights lit = rig.lit(desk.gobos, desk.passes);
        EXPECT_EQ(lit.faces.at(1).light.intensity_cd, vec3(0));
        EXPECT_TRUE(rig.is_left_dark(1))
            << "a hand asks, and not for light: " << (hand.colour ? "colour" : "zoom");
    }
    EXPECT_TRUE(rig.is_dark_without_hands(1));
    EXPECT_FALSE(rig.is_dark_without_hands(3));
    rig.leave_unasked_dark(false);
    EXPECT_FALSE(rig.is_dark_without_hands(1));
    (void)rig.lit(desk.gobos, DistanceMaps{});
    EXPECT_FALSE(rig.is_left_dark(0));
    EXPECT_EQ(rig.left_dark(), 0u);
}

TEST(rig, TrackFadesBetweenTwoPasses) {
    Desk desk("Wash");
    PatchedFixture& fixture = desk.show.fixtures[0];
    fixture.track = Track{{{0, 0, 6}, {2, 0, 6}, {6, 0, 6}}, 1, 100};
    const float pivot_z = light_position_m(fixture, 0).z;
    for (int stop = 0; stop < 3; ++stop) {
        LightPass pass;
        pass.fixture = fixture.name;
        pass.stop = stop;
        pass.position_m = light_position_m(fixture, static_cast<std::size_t>(stop));
        desk.passes.lights.push_back(pass);
    }
    struct Row {
        int coarse;
        int fine;
        float x_m;
        std::uint32_t passes[2];
        float fraction; // of the second
    };
    // 0x6000 / 65535 * 2 stops = 0.75; 0xffff is the last one.
    for (const Row& row : {Row{0, 0, 0.0f, {0, 1}, 0.0f}, Row{0x60, 0, 1.50002f, {0, 1}, 0.75001f},
                           Row{0xff, 0xff, 6.0f, {2, 2}, 0.0f}}) {
        desk.set(100, row.coarse).set(101, row.fine);
        Rig rig(desk.show);
        rig.step(desk.universes(), 0.0);
        const std::vector<shared::Light> lights = rig.lights(desk.gobos, desk.passes);
        ASSERT_EQ(lights.size(), 3u);
        for (const shared::Light& light : lights) {
            const vec3 pivot_m = light.position_m - light.off_map_m;
            EXPECT_NEAR(pivot_m.x, row.x_m, 1e-4f);
            EXPECT_NEAR(pivot_m.z, pivot_z, 1e-5f);
        }
        EXPECT_EQ(lights[0].pass, row.passes[0]);
        EXPECT_EQ(lights[1].pass, row.passes[1]);
        EXPECT_EQ(lights[2].pass, 3u); // the air alone: no pass
        EXPECT_EQ(lights[0].haze_samples + lights[1].haze_samples, 0u);
        EXPECT_GT(lights[2].haze_samples, 0u);
        const float whole = lights[2].intensity_cd.y;
        EXPECT_NEAR(lights[1].intensity_cd.y, row.fraction * whole, 1e-3f * whole);
        EXPECT_NEAR(lights[0].intensity_cd.y + lights[1].intensity_cd.y, whole, 1e-4f * whole);
    }
}

} // namespace
} // namespace ghost::scene
