// SPDX-License-Identifier: Apache-2.0
// Our two fixtures, channel by channel, against the chart in docs/reference/fixtures.md.
#include "fixture/decode.h"
#include "support/tiny_gdtf.h"

#include <cmath>

namespace ghost::fixture {
namespace {

struct Rig {
    LoadedType loaded;
    Patch patch;
    std::vector<std::uint8_t> dmx = std::vector<std::uint8_t>(512, 0);

    explicit Rig(const std::string& kind, int channel = 1)
        : loaded(
              std::move(load_gdtf(std::filesystem::path("assets/fixtures/Vari-Lite@VL2500_" + kind + ".gdtf"))
                            .value())) {
        patch = {.name = kind, .type = &loaded.type, .mode = 0, .addresses = {{1, channel}}};
    }
    // value of a fixture channel, 1-based
    Rig& set(int channel, int value) {
        dmx[static_cast<std::size_t>(patch.addresses[0].channel + channel - 2)] =
            static_cast<std::uint8_t>(value);
        return *this;
    }
    Targets targets() const {
        Levels levels;
        levels.set(1, dmx);
        return decode(patch, levels);
    }
    Optics optics() const { return targets().beams.at(0); }
    State state() const {
        State result = make_state(patch);
        step(result, patch, targets(), 0.0);
        return result;
    }
};

TEST(vl2500, both_files_load_without_a_message) {
    for (const std::string kind : {"Spot", "Wash"}) {
        const auto loaded =
            load_gdtf(std::filesystem::path("assets/fixtures/Vari-Lite@VL2500_" + kind + ".gdtf"));
        ASSERT_TRUE(loaded) << loaded.error().text();
        for (const Message& message : loaded->messages)
            ADD_FAILURE() << message.where << ": " << message.what;
        EXPECT_EQ(loaded->type.manufacturer, "Vari-Lite");
        EXPECT_EQ(loaded->type.name, "VL2500 " + kind);
        ASSERT_EQ(loaded->type.modes.size(), 1u);
        EXPECT_EQ(loaded->type.modes[0].footprint, std::vector<int>{kind == "Spot" ? 22 : 15});
        EXPECT_EQ(loaded->type.modes[0].beams.size(), 1u);
        ASSERT_EQ(loaded->type.models.size(), 3u);
        for (const Model& model : loaded->type.models) {
            ASSERT_GT(model.mesh.size(), 1000u);
            EXPECT_EQ(std::string(model.mesh.begin(), model.mesh.begin() + 4), "glTF");
            EXPECT_EQ(model.mesh_extension, "glb");
        }
        EXPECT_EQ(loaded->type.models[0].size_m, glm::vec3(0.494f, 0.382f, 0.105f));
    }
}

TEST(vl2500, spot_has_its_wheels_and_pictures) {
    const Rig rig("Spot");
    const Type& type = rig.loaded.type;
    ASSERT_EQ(type.wheels.size(), 3u);
    EXPECT_EQ(type.wheels[0].slots.size(), 12u);
    EXPECT_EQ(type.wheels[1].slots.size(), 12u);
    EXPECT_EQ(type.wheels[2].slots.size(), 6u);
    EXPECT_EQ(type.media.size(), 16u);
    for (const Wheel& wheel : {type.wheels[1], type.wheels[2]})
        for (std::size_t i = 0; i < wheel.slots.size(); ++i) EXPECT_EQ(wheel.slots[i].media >= 0, i > 0);
    for (const Media& media : type.media) {
        EXPECT_EQ(media.width, 512);
        EXPECT_EQ(media.height, 512);
        ASSERT_EQ(media.rgba.size(), 512u * 512u * 4u);
        EXPECT_EQ(media.rgba[3], 0) << media.file << ": the corner is outside of the disc";
        EXPECT_EQ(media.rgba[(256 * 512 + 256) * 4 + 3], 255) << media.file << ": the centre is inside";
    }
    EXPECT_FLOAT_EQ(type.wheels[0].slots[1].color.x, 0.68f);
    EXPECT_FLOAT_EQ(type.wheels[0].slots[0].color.Y, 100.0f);
}

TEST(vl2500, without_data_the_spot_is_dark_and_looks_down) {
    const Rig rig("Spot");
    const State state = make_state(rig.patch);
    EXPECT_EQ(state.beams.at(0).optics.dimmer, 0.0f);
    EXPECT_EQ(state.beams[0].optics.shutter, 1.0f);
    EXPECT_EQ(state.beams[0].optics.iris, 1.0f);
    EXPECT_NEAR(state.pan_deg, 0.0f, 0.01f);
    EXPECT_NEAR(state.tilt_deg, 0.0f, 0.01f);
    const glm::vec4 forward = state.beams[0].to_fixture * glm::vec4(0, 0, -1, 0);
    EXPECT_NEAR(forward.z, -1.0f, 1e-6f);
    EXPECT_NEAR(state.beams[0].to_fixture[3].z, -0.65f, 1e-6f); // 0.105 + 0.29 + 0.255
    EXPECT_EQ(state.parts.size(), 3u);
}

TEST(vl2500, dimmer) {
    Rig rig("Spot");
    EXPECT_EQ(rig.set(1, 0).optics().dimmer, 0.0f);
    EXPECT_FLOAT_EQ(rig.set(1, 51).optics().dimmer, 0.2f);
    EXPECT_EQ(rig.set(1, 255).optics().dimmer, 1.0f);
}

TEST(vl2500, pan_and_tilt_are_16_bits) {
    Rig rig("Spot");
    EXPECT_FLOAT_EQ(rig.set(2, 0).set(3, 0).state().pan_deg, -270.0f);
    EXPECT_FLOAT_EQ(rig.set(2, 255).set(3, 255).state().pan_deg, 270.0f);
    // 0x1234 = 4660: -270 + 540 * 4660 / 65535
    EXPECT_NEAR(rig.set(2, 0x12).set(3, 0x34).state().pan_deg, -231.602197f, 1e-4f);
    EXPECT_NEAR(rig.set(2, 0x12).set(3, 0x35).state().pan_deg, -231.593957f, 1e-4f);
    EXPECT_FLOAT_EQ(rig.set(4, 255).set(5, 255).state().tilt_deg, 135.0f);
    EXPECT_NEAR(rig.set(4, 0).set(5, 1).state().tilt_deg, -134.995880f, 1e-4f);
}

TEST(vl2500, the_head_turns_right_handed_about_z_then_x) {
    Rig rig("Spot");
    // Tilt +90 looks upstage (+Y); pan +90 turns that to -X.
    const int tilt = static_cast<int>(std::lround((90.0 + 135.0) / 270.0 * 65535.0));
    const int pan = static_cast<int>(std::lround((90.0 + 270.0) / 540.0 * 65535.0));
    rig.set(2, 128).set(3, 0).set(4, tilt >> 8).set(5, tilt & 255);
    glm::vec4 forward = rig.state().beams[0].to_fixture * glm::vec4(0, 0, -1, 0);
    EXPECT_NEAR(forward.y, 1.0f, 1e-3f);
    rig.set(2, pan >> 8).set(3, pan & 255);
    const State state = rig.state();
    forward = state.beams[0].to_fixture * glm::vec4(0, 0, -1, 0);
    EXPECT_NEAR(forward.x, -1.0f, 1e-3f);
    // The lens stands 0.255 m in front of the tilt axis, which is 0.395 m below the clamp.
    EXPECT_NEAR(state.beams[0].to_fixture[3].x, -0.255f, 1e-3f);
    EXPECT_NEAR(state.beams[0].to_fixture[3].z, -0.395f, 1e-3f);
    EXPECT_NEAR(state.parts[0].to_fixture[0].x, 1.0f, 1e-6f) << "the base stays";
}

TEST(vl2500, cyan_yellow_magenta_in_this_order) {
    Rig rig("Spot");
    const Optics optics = rig.set(6, 255).set(7, 51).set(8, 102).optics();
    EXPECT_EQ(optics.cyan, 1.0f);
    EXPECT_FLOAT_EQ(optics.yellow, 0.2f);
    EXPECT_FLOAT_EQ(optics.magenta, 0.4f);
}

TEST(vl2500, color_wheel_centres_and_halves) {
    Rig rig("Spot");
    for (int slot = 0; slot < 12; ++slot) {
        const WheelState wheel = rig.set(9, 18 * slot).optics().color_wheels.at(0);
        EXPECT_FLOAT_EQ(wheel.position, static_cast<float>(slot));
        EXPECT_FALSE(wheel.spinning);
    }
    EXPECT_FLOAT_EQ(rig.set(9, 45).optics().color_wheels[0].position, 2.5f); // half blue, half yellow
    EXPECT_FLOAT_EQ(rig.set(9, 207).optics().color_wheels[0].position, 11.5f);
    EXPECT_FLOAT_EQ(rig.set(9, 216).optics().color_wheels[0].position, 0.0f);
}

TEST(vl2500, color_wheel_spins) {
    Rig rig("Spot");
    struct Row {
        int dmx;
        float deg_s;
    };
    for (const Row row :
         {Row{217, -360.0f}, {233, -3.0f}, {234, 0.0f}, {236, 0.0f}, {237, 3.0f}, {255, 360.0f}}) {
        const WheelState wheel = rig.set(9, row.dmx).optics().color_wheels.at(0);
        EXPECT_TRUE(wheel.spinning) << row.dmx;
        EXPECT_FLOAT_EQ(wheel.spin_deg_s, row.deg_s) << row.dmx;
    }
}

TEST(vl2500, edge_zoom_iris) {
    Rig rig("Spot");
    EXPECT_EQ(rig.set(10, 0).state().beams[0].optics.focus_m, 2.0f);
    EXPECT_NEAR(rig.set(10, 255).state().beams[0].optics.focus_m, 50.0f, 1e-4f);
    EXPECT_FLOAT_EQ(rig.set(12, 0).optics().zoom_deg, 15.0f);
    EXPECT_FLOAT_EQ(rig.set(12, 51).optics().zoom_deg, 20.5f);
    EXPECT_FLOAT_EQ(rig.set(12, 255).optics().zoom_deg, 42.5f);
    EXPECT_FLOAT_EQ(rig.set(17, 0).optics().iris, 0.1f);
    EXPECT_FLOAT_EQ(rig.set(17, 255).optics().iris, 1.0f);
}

TEST(vl2500, strobe_ranges) {
    struct Row {
        int dmx;
        float shutter;
        Strobe strobe;
        float hz;
    };
    for (const std::string kind : {"Spot", "Wash"}) {
        Rig rig(kind);
        for (const Row& row :
             {Row{0, 1, Strobe::none, 0}, Row{2, 1, Strobe::none, 0}, Row{3, 0, Strobe::none, 0},
              Row{5, 0, Strobe::none, 0}, Row{6, 1, Strobe::random, 2}, Row{8, 1, Strobe::random, 5},
              Row{12, 1, Strobe::random, 10}, Row{13, 1, Strobe::regular, 1},
              Row{255, 1, Strobe::regular, 20}}) {
            const Optics optics = rig.set(11, row.dmx).optics();
            EXPECT_EQ(optics.shutter_position, row.shutter) << row.dmx;
            EXPECT_EQ(optics.strobe, row.strobe) << row.dmx;
            EXPECT_FLOAT_EQ(optics.strobe_hz, row.hz) << row.dmx;
        }
    }
}

TEST(vl2500, fixed_gobo_wheel_half_gobo_and_spin) {
    Rig rig("Spot");
    ASSERT_EQ(rig.optics().gobo_wheels.size(), 2u);
    EXPECT_EQ(rig.optics().gobo_wheels[0].wheel, 1);
    EXPECT_EQ(rig.optics().gobo_wheels[1].wheel, 2);
    EXPECT_FLOAT_EQ(rig.set(13, 72).optics().gobo_wheels[0].position, 4.0f); // night sky
    EXPECT_FLOAT_EQ(rig.set(13, 63).optics().gobo_wheels[0].position, 3.5f);
    EXPECT_TRUE(rig.set(13, 255).optics().gobo_wheels[0].spinning);
    EXPECT_FALSE(rig.optics().gobo_wheels[1].spinning);
}

TEST(vl2500, rotating_gobo_wheel_indexes_or_rotates) {
    Rig rig("Spot");
    constexpr int kIndex[] = {0, 18, 41, 63, 86, 108};
    constexpr int kRotate[] = {128, 146, 169, 191, 214, 236};
    rig.set(15, 64).set(16, 0);
    for (int slot = 0; slot < 6; ++slot) {
        WheelState wheel = rig.set(14, kIndex[slot]).optics().gobo_wheels.at(1);
        EXPECT_FLOAT_EQ(wheel.position, static_cast<float>(slot));
        EXPECT_FALSE(wheel.rotating);
        EXPECT_NEAR(wheel.gobo_deg, 90.00137f, 1e-3f); // 16384 / 65535 * 360
        wheel = rig.set(14, kRotate[slot]).optics().gobo_wheels.at(1);
        EXPECT_FLOAT_EQ(wheel.position, static_cast<float>(slot));
        EXPECT_TRUE(wheel.rotating);
    }
    struct Row {
        int raw;
        float deg_s;
    };
    for (const Row row :
         {Row{0, -360.0f}, {32535, -1.0f}, {32536, 0.0f}, {33031, 0.0f}, {33032, 1.0f}, {65535, 360.0f}}) {
        rig.set(14, 146).set(15, row.raw >> 8).set(16, row.raw & 255);
        EXPECT_NEAR(rig.optics().gobo_wheels[1].gobo_deg_s, row.deg_s, 1e-3f) << row.raw;
        EXPECT_TRUE(rig.optics().gobo_wheels[1].rotating);
    }
}

TEST(vl2500, timing_channels) {
    Rig rig("Spot");
    struct Row {
        int dmx;
        float seconds;
    };
    for (const Row row : {Row{0, 0.0f},
                          {1, 0.2f},
                          {53, 10.6f},
                          {54, 11.0f},
                          {179, 60.0f},
                          {180, 65.0f},
                          {254, 310.0f},
                          {255, 0.0f}}) {
        const Times times = rig.set(18, row.dmx).set(19, 0).set(20, row.dmx).set(21, 1).targets().times;
        EXPECT_NEAR(times.position_s, row.seconds, 1e-4f) << row.dmx;
        EXPECT_NEAR(times.beam_s, row.seconds, 1e-4f) << row.dmx;
        EXPECT_EQ(times.color_s, 0.0f);
        EXPECT_FLOAT_EQ(times.gobo_s, 0.2f);
    }
}

TEST(vl2500, wash_chart) {
    Rig rig("Wash");
    rig.set(1, 255).set(6, 255).set(7, 51).set(8, 102).set(9, 27).set(10, 255).set(12, 1).set(13, 53).set(14,
                                                                                                          54);
    const Optics optics = rig.optics();
    EXPECT_EQ(optics.dimmer, 1.0f);
    EXPECT_EQ(optics.cyan, 1.0f);
    EXPECT_FLOAT_EQ(optics.yellow, 0.2f);
    EXPECT_FLOAT_EQ(optics.magenta, 0.4f);
    EXPECT_FLOAT_EQ(optics.color_wheels.at(0).position, 1.5f);
    EXPECT_FLOAT_EQ(optics.zoom_deg, 55.5f);
    EXPECT_TRUE(optics.gobo_wheels.empty());
    EXPECT_FLOAT_EQ(rig.targets().times.position_s, 0.2f);
    EXPECT_FLOAT_EQ(rig.targets().times.color_s, 10.6f);
    EXPECT_FLOAT_EQ(rig.targets().times.beam_s, 11.0f);
    EXPECT_FLOAT_EQ(rig.set(10, 0).optics().zoom_deg, 14.0f);
}

TEST(vl2500, a_fixture_at_the_end_of_a_universe_goes_on_in_the_next) {
    Rig rig("Spot", 512); // channel 1 in universe 1, the rest in universe 2
    rig.dmx[511] = 255;
    std::vector<std::uint8_t> second(512, 0);
    second[0] = second[1] = 255; // pan
    Levels levels;
    levels.set(2, second);
    levels.set(1, rig.dmx);
    const Targets targets = decode(rig.patch, levels);
    EXPECT_EQ(targets.beams.at(0).dimmer, 1.0f);
    EXPECT_EQ(targets.axes.at(0).deg, 270.0f);
}

TEST(vl2500, readings_explain_a_channel) {
    Rig rig("Spot");
    rig.set(9, 45);
    Levels levels;
    levels.set(1, rig.dmx);
    const std::vector<ChannelReading> readings = read_channels(rig.patch, levels);
    const Mode& mode = rig.patch.mode_of();
    ASSERT_EQ(readings.size(), 19u);
    EXPECT_EQ(mode.channels[6].name, "Beam_Color1");
    EXPECT_EQ(readings[6].raw, 45u);
    EXPECT_TRUE(readings[6].received);
    const ChannelFunction& function =
        mode.channels[6].functions.at(static_cast<std::size_t>(readings[6].function));
    EXPECT_EQ(function.name, "Index");
    EXPECT_EQ(function.sets.at(static_cast<std::size_t>(readings[6].set)).name, "Blue / Yellow");
    EXPECT_FALSE(read_channels(rig.patch, Levels{})[6].received);
}

} // namespace
} // namespace ghost::fixture
