// SPDX-License-Identifier: Apache-2.0
// 77 GDTF files of other makers (see the folder's manifest for their licences: they are not ours to ship):
// every mode of every file is driven, and the hard cases of docs/reference/gdtf.md do what stands there. What
// the files should hold is compared in oracle_test.cpp.
#include "fixture/decode.h"
#include "support/tiny_gdtf.h"

#include <algorithm>
#include <set>

namespace ghost::fixture {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(GHOST_SOURCE_DIR) / "../shared/fixtures/gdtf";

#define SKIP_WITHOUT_FILES()                                                                                 \
    if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << "no ../shared/fixtures beside the checkout"

LoadedType load_named(const std::string& name) {
    Result<LoadedType> loaded = load_gdtf(kFolder / name);
    EXPECT_TRUE(loaded) << name << (loaded ? "" : loaded.error().text());
    return loaded ? std::move(loaded).value() : LoadedType{};
}

int count_of(const LoadedType& loaded, const std::string& words) {
    return static_cast<int>(
        std::count_if(loaded.messages.begin(), loaded.messages.end(),
                      [&](const Message& message) { return message.what.find(words) != std::string::npos; }));
}

Patch patch_of(const Type& type, int mode = 0) {
    return {.name = "test", .type = &type, .mode = mode, .addresses = {{1, 1}, {2, 1}}};
}

const Beam& beam_of(const Type& type, const Mode& mode, std::size_t number) {
    const Node& node = mode.nodes.at(static_cast<std::size_t>(mode.beams.at(number)));
    return type.geometries.at(static_cast<std::size_t>(node.geometry)).beam.value();
}

TEST(real_files, every_mode_of_every_file_runs) {
    SKIP_WITHOUT_FILES();
    int files = 0;
    int modes = 0;
    int meshes = 0;
    std::vector<std::string> refused;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        const std::string name = entry.path().filename().string();
        ++files;
        const Result<LoadedType> loaded = load_gdtf(entry.path());
        if (!loaded) {
            EXPECT_FALSE(loaded.error().what.empty());
            refused.push_back(name);
            continue;
        }
        for (const Geometry& geometry : loaded->type.geometries)
            if (geometry.beam) {
                EXPECT_GE(geometry.beam->field_angle_deg, geometry.beam->beam_angle_deg) << name;
                EXPECT_GE(geometry.beam->color_temperature_k, 500.0f) << name;
            }
        EXPECT_EQ(count_of(*loaded, "the mesh is left out"), 0) << name;
        for (const Model& model : loaded->type.models) meshes += !model.mesh.empty();
        for (std::size_t m = 0; m < loaded->type.modes.size(); ++m) {
            ++modes;
            const Mode& mode = loaded->type.modes[m];
            std::set<std::string> names;
            for (const Node& node : mode.nodes) names.insert(node.name);
            EXPECT_EQ(names.size(), mode.nodes.size()) << name << ": node names are unique";
            const Patch patch = patch_of(loaded->type, static_cast<int>(m));
            State state = make_state(patch);
            std::vector<std::uint8_t> dmx(512);
            for (const int value : {0, 77, 255}) {
                std::fill(dmx.begin(), dmx.end(), static_cast<std::uint8_t>(value));
                Levels levels;
                levels.set(1, dmx);
                levels.set(2, dmx);
                step(state, patch, decode(patch, levels), 0.02);
                for (const BeamState& beam : state.beams)
                    EXPECT_TRUE(beam.optics.dimmer >= 0.0f && beam.optics.dimmer <= 1.0f &&
                                beam.optics.zoom_deg > 0.0f);
            }
        }
    }
    std::sort(refused.begin(), refused.end());
    EXPECT_EQ(refused,
              (std::vector<std::string>{"libmvr_CrashWhileOpen.gdtf", "libmvr_XMLBroken.gdtf",
                                        "opengdtf_Test@Channel_Layout_Test@v1_first_try.empty.gdtf"}));
    EXPECT_EQ(files, 77);
    EXPECT_EQ(modes, 231);
    EXPECT_GT(meshes, 100) << "the check of meshes refuses none of them";
}

TEST(hard_cases, byte_order_mark_old_version_and_a_beam_without_angles) {
    SKIP_WITHOUT_FILES();
    const LoadedType file = load_named("libmvr_BugInDmxWithHex.gdtf");
    EXPECT_EQ(file.type.data_version, "0.88");
    EXPECT_EQ(count_of(file, "DataVersion is '0.88'"), 1);
    EXPECT_EQ(beam_of(file.type, file.type.modes.at(0), 0).beam_angle_deg, 25.0f);
    EXPECT_EQ(beam_of(file.type, file.type.modes[0], 0).field_angle_deg, 25.0f);
}

TEST(hard_cases, macros_under_the_fixture_type) {
    SKIP_WITHOUT_FILES();
    const LoadedType file = load_named("libmvr_WrongDmxValue.gdtf");
    EXPECT_EQ(file.type.modes.size(), 6u);
    EXPECT_EQ(count_of(file, "FTMacros stands under"), 0) << "the misplaced list is empty: nothing to say";
}

TEST(hard_cases, a_function_that_begins_above_zero) {
    SKIP_WITHOUT_FILES();
    const LoadedType file =
        load_named("libmvr_Robe_lighting_s.r.o.@BMFL_Spot@cannot_assign_0_to_frost_function.gdtf");
    const Mode& mode = file.type.modes.at(0);
    const auto frost = std::find_if(mode.channels.begin(), mode.channels.end(), [](const Channel& channel) {
        return !channel.functions.empty() && channel.functions[0].attribute == "Frost1";
    });
    ASSERT_NE(frost, mode.channels.end());
    const auto physical_at = [&](std::uint8_t value) {
        std::vector<std::uint8_t> dmx(512);
        dmx[static_cast<std::size_t>(frost->offsets.at(0))] = value;
        Levels levels;
        levels.set(1, dmx);
        const auto readings = read_channels(patch_of(file.type), levels);
        return readings.at(static_cast<std::size_t>(frost - mode.channels.begin())).physical;
    };
    EXPECT_EQ(physical_at(0), 0.0f);
    EXPECT_EQ(physical_at(1), 0.0f);
    EXPECT_GT(physical_at(100), 0.1f);
    EXPECT_EQ(count_of(file, "slots without a Wheel, taking 'Color2'"), 2);
}

TEST(hard_cases, colours_and_highlights_that_are_no_numbers_and_pictures_with_a_folder) {
    SKIP_WITHOUT_FILES();
    const LoadedType file = load_named("libmvr_allWorking.gdtf");
    EXPECT_EQ(count_of(file, "Color is '-nan(ind),-nan(ind)"), 1);
    EXPECT_EQ(count_of(file, "Highlight is '-"), 2);
    int pictures = 0;
    for (const Wheel& wheel : file.type.wheels)
        for (const Slot& slot : wheel.slots) {
            EXPECT_TRUE(slot.color.x > 0.0f && slot.color.Y >= 0.0f);
            pictures += slot.media >= 0;
        }
    EXPECT_EQ(pictures, 15) << "MediaFileName has a folder that the archive has not";
}

TEST(hard_cases, geometries_of_one_name) {
    SKIP_WITHOUT_FILES();
    const LoadedType file = load_named("opengdtf_Robe_Robin_Tetra2.gdtf");
    EXPECT_EQ(count_of(file, "a second geometry named"), 18);
    for (const Mode& mode : file.type.modes)
        for (const Channel& channel : mode.channels) EXPECT_GE(channel.node, 0);
}

TEST(hard_cases, modes_that_name_no_geometry) {
    SKIP_WITHOUT_FILES();
    const LoadedType file = load_named("ogl_Fiilex@Q8_Color.gdtf");
    EXPECT_EQ(count_of(file, "the mode names no geometry, taking 'Body'"), 16);
    for (const Mode& mode : file.type.modes) EXPECT_FALSE(mode.beams.empty());
}

TEST(hard_cases, slots_beyond_the_wheel) {
    SKIP_WITHOUT_FILES();
    const LoadedType file = load_named("ogl_Robe@Robin_DL7S_Profile.gdtf");
    EXPECT_GE(count_of(file, "' has 2 slots"), 1);
    for (const Mode& mode : file.type.modes)
        for (const Channel& channel : mode.channels)
            for (const ChannelFunction& function : channel.functions)
                for (const ChannelSet& set : function.sets)
                    if (set.slot >= 0) {
                        ASSERT_GE(function.wheel, 0);
                        EXPECT_LT(static_cast<std::size_t>(set.slot),
                                  file.type.wheels[static_cast<std::size_t>(function.wheel)].slots.size());
                    }
}

TEST(hard_cases, children_out_of_order_and_twice) {
    SKIP_WITHOUT_FILES();
    EXPECT_EQ(load_named("ogl_Cameo@F2_FC.gdtf").type.modes.size(), 8u);
    const LoadedType laser = load_named("ogl_Lightline@LaserLink.gdtf");
    EXPECT_EQ(laser.type.wheels.size(), 3u);
    EXPECT_EQ(laser.type.modes.at(0).footprint, std::vector<int>{32});
}

TEST(hard_cases, overlapping_bytes_and_modes_without_channels) {
    SKIP_WITHOUT_FILES();
    EXPECT_EQ(count_of(load_named("bauke_ROXX@CLUSTER_B4-FC.gdtf"), "both use byte"), 2);
    const LoadedType custom = load_named("bauke_Custom@Roxx_Cluster_B4_FC.gdtf");
    EXPECT_EQ(count_of(custom, "takes no DMX: all its channels are virtual"), 1);
    const LoadedType par = load_named("mhugi_ADJ@Mega_TriPar_Profile_Plus@28122021.gdtf");
    ASSERT_EQ(par.type.modes.size(), 5u);
    EXPECT_TRUE(par.type.modes[3].channels.empty() && par.type.modes[4].channels.empty());
    EXPECT_EQ(count_of(par, "takes no DMX: it has no channels"), 2);
    EXPECT_EQ(decode(patch_of(par.type, 3), {}).beams.size(), par.type.modes[3].beams.size());
}

TEST(hard_cases, angles_and_colour_temperatures_that_cannot_be) {
    SKIP_WITHOUT_FILES();
    const LoadedType bulb = load_named("bdmx_BrdoBulbLED_v3.gdtf");
    EXPECT_EQ(beam_of(bulb.type, bulb.type.modes.at(0), 0).beam_angle_deg, 360.0f);
    EXPECT_EQ(decode(patch_of(bulb.type), {}).beams.at(0).zoom_deg, kMaxZoom_deg);
    const LoadedType carre = load_named("ogl_Minuit_Une@IVL_Carre.gdtf");
    EXPECT_EQ(count_of(carre, "ColorTemperature below 500 K, taking 6000 K"), 3);
}

TEST(hard_cases, a_patched_lamp_without_a_beam_shines) {
    SKIP_WITHOUT_FILES();
    for (const char* name :
         {"ogl_Lightline@LaserLink.gdtf", "ogl_Varilite@VL-2500_Spot.gdtf", "ogl_Varilite@VL-2500_Wash.gdtf",
          "ogl_Robert_Juliat@Victor_1159B_DMX.gdtf", "ogl_Colortran@Cyc_Strip_6_Cell.gdtf"}) {
        const LoadedType file = load_named(name);
        const Mode& mode = file.type.modes.at(0);
        ASSERT_EQ(mode.beams.size(), 1u) << name;
        EXPECT_TRUE(beam_of(file.type, mode, 0).is_assumed);
        EXPECT_EQ(count_of(file, "taking one of 10000 lm and 25 degrees"), 1) << name;
    }
    const LoadedType shell = load_named("ogl_Varilite@VL-2500_Spot.gdtf");
    std::vector<std::uint8_t> dmx(512, 51);
    Levels levels;
    levels.set(1, dmx);
    EXPECT_NEAR(decode(patch_of(shell.type), levels).beams.at(0).dimmer, 0.2f, 1e-6f);
    // A fan and a media server give none.
    for (const char* name :
         {"mhugi_StairVille@Stairville_Fan-200_DMX@Init_-_Rev1.gdtf", "mhugi_ADSI_DATATON@WO_ADSI@V0.1.gdtf"})
        EXPECT_TRUE(load_named(name).type.modes.at(0).beams.empty()) << name;
}

TEST(hard_cases, lasers_of_no_power) {
    SKIP_WITHOUT_FILES();
    const LoadedType file = load_named("bdmx_Laser_v4.gdtf");
    EXPECT_EQ(file.type.modes.at(0).beams.size(), 21u);
    EXPECT_EQ(count_of(file, "OutputStrength is 0 W, taking 1 W"), 21);
    EXPECT_EQ(beam_of(file.type, file.type.modes[0], 0).luminous_flux_lm, 200.0f);
}

#undef SKIP_WITHOUT_FILES

} // namespace
} // namespace ghost::fixture
