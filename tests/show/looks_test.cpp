// SPDX-License-Identifier: Apache-2.0
// Looks in a file: what is written comes back, whatever is wrong is said with its line, the rest stays.
#include "show/looks.h"

#include "light/rig.h"

#include "fixture_files/gdtf/gdtf.h"
#include "show/names.h"
#include "show/show.h"

#include <cstring>
#include <gtest/gtest.h>
#include <random>

namespace ghost::scene {
namespace {

StoredLook verse() {
    StoredLook look;
    look.name = "Verse \"one\"";
    look.fade_s = 2.5f;
    look.scene.smoke = 1.5f;
    look.scene.ambient_lux = 3;
    look.scene.ambient_colour = glm::vec3(1, 0.25f, 0.1f);
    look.scene.attenuation = glm::vec3(0, 0, 1);
    look.scene.shadows = false;
    look.fixtures["Spot 1"] = {.intensity = 0.3f,
                               .colour = glm::vec3(1, 0.1f, 0.05f),
                               .zoom_deg = 12.5f,
                               .pan_deg = -170,
                               .tilt_deg = 33.25f,
                               .gobo = 4,
                               .gel = glm::vec3(0.2f, 0.4f, 0.9f),
                               .lamp = 1.75f,
                               .lamp_k = 3200.0f,
                               .levels = {0, 255, 17}};
    look.fixtures["Wash 2"] = {.intensity = 0.0f};
    look.movers["Truss \"front\""] = {-2.5f, -3};
    return look;
}

TEST(Looks, of_a_fixture_whose_name_names_no_file_are_those_of_the_one_it_was_given) {
    Show show;
    show.fixtures.resize(3);
    show.fixtures[0].name = "Bar 1-2 (2)";
    show.fixtures[0].written_name = "Bar 1/2";
    show.fixtures[1].name = "Bar 1-2";
    show.fixtures[2].name = "Truss A/B"; // of a plot, which keeps its names
    StoredLook look;
    look.fixtures["Bar 1/2"].intensity = 0.9f;
    look.fixtures["Bar 1-2"].intensity = 0.1f;
    look.fixtures["Truss A/B"].intensity = 0.5f;
    const auto programmer = programmer_of(look, show);
    ASSERT_EQ(programmer.size(), 3u);
    EXPECT_EQ(programmer.at(0).intensity, 0.9f);
    EXPECT_EQ(programmer.at(1).intensity, 0.1f);
    EXPECT_EQ(programmer.at(2).intensity, 0.5f);
    Report report;
    check_look(look, show, "looks.toml", report);
    EXPECT_TRUE(report.messages.empty());
    look.fixtures["Bar 1?2"].intensity = 1.0f;
    check_look(look, show, "looks.toml", report);
    EXPECT_EQ(report.messages.size(), 1u) << "nobody is called so";
    EXPECT_EQ(good_name("../x"), "-.-x");
    EXPECT_EQ(good_name(std::string(99, 'x') + "\xc3\xa4"), std::string(99, 'x')) << "whole letters";
    EXPECT_EQ(good_name(""), "");
}

TEST(Looks, what_is_written_comes_back) {
    const std::vector<StoredLook> looks{verse(), {.name = "Empty"}};
    Report report;
    const auto read = parse_looks(text_of(looks), "looks.toml", report);
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(*read, looks);
    EXPECT_TRUE(report.messages.empty()) << report.messages.front().what;
    EXPECT_EQ(text_of(*read), text_of(looks));
}

TEST(Looks, every_beginning_of_a_file_is_read_or_refused_with_its_line) {
    const std::string whole = text_of({verse()});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        Report report;
        const auto read = parse_looks(whole.substr(0, size), "looks.toml", report);
        EXPECT_TRUE(read.ok() || read.error().where.starts_with("looks.toml:")) << size;
    }
}

TEST(Looks, movers_that_the_show_does_not_have_so_are_named) {
    Show show;
    show.movers.resize(2);
    show.movers[0].name = "lift";
    show.movers[0].axes.resize(1);
    show.movers[1].name = "truss";
    show.movers[1].axes.resize(3);
    Report report;
    const auto looks = parse_looks("[[look]]\nname = \"A\"\n[[look.mover]]\nname = \"lift\"\nvalues = [2]\n"
                                   "[[look.mover]]\nname = \"truss\"\nvalues = [1, 2]\n"
                                   "[[look.mover]]\nname = \"wagon\"\nvalues = [1]\n"
                                   "[[look.mover]]\nname = \"lift\"\nvalues = [3]\n"
                                   "[[look.mover]]\nname = \"winch\"\nvalues = [nan]\n",
                                   "looks.toml", report);
    ASSERT_TRUE(looks.ok());
    EXPECT_EQ(report.messages.size(), 2u) << "twice one name, and what is no number";
    EXPECT_EQ(movers_of((*looks)[0], show), (std::map<std::size_t, std::vector<float>>{{0, {2.0f}}}));
    Report strangers;
    check_look((*looks)[0], show, "looks.toml", strangers);
    ASSERT_EQ(strangers.messages.size(), 1u);
    EXPECT_NE(strangers.messages[0].what.find("'truss'"), std::string::npos) << strangers.messages[0].what;
    EXPECT_NE(strangers.messages[0].what.find("'wagon'"), std::string::npos);
}

TEST(Looks, fixtures_that_the_show_does_not_have_are_named) {
    Show show;
    show.fixtures.emplace_back().name = "Spot 1";
    show.movers.emplace_back().name = verse().movers.begin()->first;
    show.movers[0].axes.resize(2);
    Report report;
    check_look(verse(), show, "looks.toml", report);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_EQ(report.messages[0].what,
              "look 'Verse \"one\"' has values for fixtures that the show does not have: 'Wash 2'");
    show.fixtures.emplace_back().name = "Wash 2";
    check_look(verse(), show, "looks.toml", report);
    EXPECT_EQ(report.messages.size(), 1u);
}

// A slot that no wheel has is said, with what there is.
TEST(Looks, gobos_that_a_wheel_does_not_have_are_said) {
    auto type = std::make_shared<fixture::Type>();
    type->geometries.emplace_back().beam = fixture::Beam{};
    fixture::Mode& mode = type->modes.emplace_back();
    mode.nodes.emplace_back().geometry = 0;
    mode.beams = {0};
    Show show;
    show.fixtures.emplace_back().name = "Spot 1";
    show.fixtures[0].type = type;
    StoredLook look;
    look.name = "A";
    look.fixtures["Spot 1"].gobo = 200;
    Report report;
    check_look(look, show, "looks.toml", report);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_EQ(report.messages[0].what, "look 'A': gobo 200 of 'Spot 1', which has no gobo wheel");
    look.fixtures["Spot 1"].gobo = 0;
    check_look(look, show, "looks.toml", report);
    EXPECT_EQ(report.messages.size(), 1u) << "no gobo is what it shows anyway";
}

TEST(Looks, bad_values_are_said_and_the_rest_stays) {
    Report report;
    const auto read =
        parse_looks("[[look]]\nname = \"A\"\nsmoke = -1\nattenuation = [0, 0, 0]\n"
                    "[[look.fixture]]\nname = \"Spot 1\"\nintensity = 0.5\ngobo = 999\nzooom_deg = 3\n"
                    "[[look.fixture]]\nname = \"Spot 1\"\nintensity = 0.7\n"
                    "[[look.fixture]]\nname = \"Spot 2\"\nlevels = [1, 256]\n"
                    "[[look]]\nfade_s = 2\n"
                    "[[look]]\nname = \"A\"\n",
                    "looks.toml", report);
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read->size(), 1u);
    EXPECT_EQ(read->front().fixtures.at("Spot 1").intensity, 0.5f);
    EXPECT_FALSE(read->front().scene.smoke);
    EXPECT_TRUE(report.lost_anything());
    const auto said = [&](const std::string& where, const std::string& what) {
        for (const Message& message : report.messages)
            if (message.where == where && message.what.find(what) != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(said("looks.toml:3", "smoke"));
    EXPECT_TRUE(said("looks.toml:4", "0, 0, 0"));
    EXPECT_TRUE(said("looks.toml:8", "gobo"));
    EXPECT_TRUE(said("looks.toml:9", "zooom_deg"));
    EXPECT_TRUE(said("looks.toml:10", "twice"));
    EXPECT_TRUE(said("looks.toml:15", "each from 0 to 255"));
    EXPECT_TRUE(said("looks.toml:18", "twice"));
}

TEST(Looks, fixtures_go_by_name) {
    Show show;
    for (const char* const name : {"Wash 2", "Other", "Spot 1"}) show.fixtures.emplace_back().name = name;
    const auto programmer = programmer_of(verse(), show);
    ASSERT_EQ(programmer.size(), 2u);
    EXPECT_EQ(programmer.at(2).gobo, 4);
    EXPECT_EQ(programmer.at(0).intensity, 0.0f);
}

// Wheels, prisms, blades, frost, iris, strobes, turning gobos: a look that was stored has the light that a
// desk made, whatever it sent.
TEST(Looks, levels_bring_every_attribute_back) {
    for (const char* const file : {"Ghostlight@Optics_Profile.gdtf", "Vari-Lite@VL2500_Spot.gdtf"}) {
        const auto loaded = fixture::load_gdtf(std::filesystem::path("assets/fixtures") / file);
        ASSERT_TRUE(loaded.ok());
        Show show;
        PatchedFixture& profile = show.fixtures.emplace_back();
        profile.name = "Profile";
        profile.type = std::make_shared<fixture::Type>(loaded->type);
        profile.universe = 3;
        profile.address = 490; // goes on in the next universe
        show.motion = fixture::Motion::as_commanded;
        Report of_gobos;
        const GoboStack gobos = build_gobos(show, of_gobos);
        const auto lights = [&](Rig& rig) { return rig.lights(gobos, DistanceMaps{}); };
        std::mt19937 random(5);
        int lit = 0;
        for (int round = 0; round < 100; ++round) {
            dmx::Universes desk;
            fixture::Levels levels;
            for (const std::uint16_t number : {std::uint16_t{3}, std::uint16_t{4}}) {
                auto values = std::make_shared<dmx::Levels>();
                for (std::uint8_t& value : *values) value = static_cast<std::uint8_t>(random() % 256);
                desk.at(number).levels = values;
                levels.set(number, *values);
            }
            StoredLook look{.name = "Seen"};
            look.fixtures["Profile"].levels = fixture::levels_of(profile.patch(), levels);
            Report report;
            const auto read = parse_looks(text_of({look}), "looks.toml", report);
            ASSERT_TRUE(read.ok());
            Rig by_desk(show), by_look(show);
            // 10 ms: what turns and strobes is somewhere on its way.
            for (int step = 0; step < 3; ++step) {
                by_desk.step(desk, 0.01);
                by_look.step({}, 0.01, programmer_of(read->front(), show));
                const auto wanted = lights(by_desk), found = lights(by_look);
                ASSERT_EQ(wanted.size(), found.size());
                for (std::size_t i = 0; i < wanted.size(); ++i) {
                    EXPECT_EQ(std::memcmp(&wanted[i], &found[i], sizeof wanted[i]), 0)
                        << file << ", round " << round << ", light " << i;
                    lit += wanted[i].intensity_cd.y > 0 ? 1 : 0;
                }
            }
        }
        EXPECT_GT(lit, 20) << "else the rounds say nothing";
    }
}

TEST(Looks, levels_of_another_mode_are_said_and_left_out) {
    const auto loaded =
        fixture::load_gdtf(std::filesystem::path("assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"));
    ASSERT_TRUE(loaded.ok());
    Show show;
    PatchedFixture& spot = show.fixtures.emplace_back();
    spot.name = "Spot 1";
    spot.type = std::make_shared<fixture::Type>(loaded->type);
    StoredLook look{.name = "A"};
    look.fixtures["Spot 1"] = {.intensity = 0.5f, .levels = {1, 2, 3}};
    EXPECT_EQ(programmer_of(look, show).at(0), fixture::Programmer{.intensity = 0.5f});
    Report report;
    check_look(look, show, "looks.toml", report);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_NE(report.messages[0].what.find("levels of another mode"), std::string::npos);
    look.fixtures["Spot 1"].levels.resize(fixture::level_count(spot.patch().mode_of()));
    check_look(look, show, "looks.toml", report);
    EXPECT_EQ(report.messages.size(), 1u);
    EXPECT_EQ(programmer_of(look, show).at(0), look.fixtures["Spot 1"]);
}

// A gel takes its share of the light, a lamp multiplies it, and both are in the light alone.
TEST(Looks, another_lamp_and_a_gel_change_the_light_by_their_factors) {
    const auto loaded =
        fixture::load_gdtf(std::filesystem::path("assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"));
    ASSERT_TRUE(loaded.ok());
    Show show;
    PatchedFixture& spot = show.fixtures.emplace_back();
    spot.name = "Spot";
    spot.type = std::make_shared<fixture::Type>(loaded->type);
    show.motion = fixture::Motion::as_commanded;
    Rig rig(show);
    const auto light_of = [&](const fixture::Programmer& programmer) {
        rig.step({}, 0, {{0, programmer}});
        return rig.lights({}, DistanceMaps{}).front().intensity_cd;
    };
    const glm::vec3 own = light_of({.intensity = 1.0f});
    ASSERT_GT(own.y, 0);
    const glm::vec3 doubled = light_of({.intensity = 1.0f, .lamp = 2.0f});
    const glm::vec3 gelled = light_of({.intensity = 1.0f, .gel = glm::vec3(0.5f, 0.25f, 0)});
    for (int c = 0; c < 3; ++c) {
        EXPECT_FLOAT_EQ(doubled[c], 2 * own[c]);
        EXPECT_FLOAT_EQ(gelled[c], own[c] * glm::vec3(0.5f, 0.25f, 0)[c]);
    }
    const glm::vec3 warm = light_of({.intensity = 1.0f, .lamp_k = 2800.0f});
    EXPECT_GT(warm.x / warm.z, 2 * own.x / own.z);
    ASSERT_TRUE(rig.asked(0));
    EXPECT_EQ(rig.asked(0)->intensity, 0.0f) << "no desk asks for light";
}

} // namespace
} // namespace ghost::scene
