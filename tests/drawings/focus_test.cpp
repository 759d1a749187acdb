// SPDX-License-Identifier: Apache-2.0
// Focus charts: where a beam goes, and the ellipse that its cone cuts out of the floor.
#include "drawings/focus.h"

#include "drawings/private/view.h"
#include "fixture/decode.h"
#include "show/show.h"
#include "support/must.h"
#include "support/tiny_gdtf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <memory>

namespace ghost::scene {
namespace {

// A lamp that hangs at (1, 2, 5) and is turned so far about X; field 20 degrees.
Show lamp_at(float turned_deg) {
    fixture::Description description;
    description.geometries =
        R"(<Geometry Name="Base"><Beam Name="Beam" FieldAngle="20" BeamAngle="20"/></Geometry>)";
    Show show;
    PatchedFixture& fixture = show.fixtures.emplace_back();
    fixture.name = "Lamp";
    fixture.type = std::make_shared<const fixture::Type>(fixture::loaded(description).type);
    fixture.position_m = {1, 2, 5};
    fixture.rotation_deg = {turned_deg, 0, 0};
    return show;
}

std::vector<fixture::State> states_of(const Show& show) {
    std::vector<fixture::State> states;
    for (const PatchedFixture& fixture : show.fixtures) {
        if (!fixture.type) {
            states.emplace_back();
            continue;
        }
        const fixture::Patch patch = fixture.patch();
        states.push_back(fixture::make_state(patch));
        fixture::step(states.back(), patch, fixture::decode(patch, {}), 0.0);
    }
    return states;
}

Extent2 extent(const std::vector<glm::dvec2>& points) {
    Extent2 extent;
    for (const glm::dvec2& point : points) extent.include(point);
    return extent;
}

TEST(Focus, straight_down_is_a_circle_below) {
    const Show show = lamp_at(0);
    const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.");
    ASSERT_EQ(chart.lamps.size(), 1u);
    const FocusLamp& lamp = chart.lamps[0];
    ASSERT_TRUE(lamp.hit);
    EXPECT_NEAR(lamp.hit->distance_m, 5, 1e-4);
    EXPECT_NEAR(lamp.aim_m().x, 1, 1e-4);
    EXPECT_NEAR(lamp.aim_m().y, 2, 1e-4);
    EXPECT_TRUE(lamp.is_pool_whole);
    const double radius = 5 * std::tan(glm::radians(10.0));
    EXPECT_NEAR(extent(lamp.pool_m).size().x, 2 * radius, 1e-3);
    EXPECT_NEAR(extent(lamp.pool_m).size().y, 2 * radius, 1e-3);
}

TEST(Focus, aslant_is_an_ellipse_of_known_length) {
    const Show show = lamp_at(45);
    const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.");
    const FocusLamp& lamp = chart.lamps[0];
    ASSERT_TRUE(lamp.hit);
    EXPECT_NEAR(lamp.hit->distance_m, 5 * std::sqrt(2.0), 1e-3);
    EXPECT_NEAR(std::abs(lamp.aim_m().y - 2), 5, 1e-3);
    const double length = 5 * (std::tan(glm::radians(55.0)) - std::tan(glm::radians(35.0)));
    EXPECT_NEAR(extent(lamp.pool_m).size().y, length, 0.01);
    const PaperTable table = table_of(chart);
    EXPECT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0].cells[8], "7.07");
}

TEST(Focus, that_hits_no_floor_has_no_pool) {
    const Show show = lamp_at(0);
    const FindHit wall = [](const glm::vec3&, const glm::vec3&) {
        return std::optional(FocusHit{3, {0, -1, 0}, "Curtain"});
    };
    const FocusChart chart = focus_of(show, states_of(show), wall, {}, "Now.");
    EXPECT_FALSE(chart.lamps[0].is_on_floor);
    EXPECT_TRUE(chart.lamps[0].pool_m.empty());
    EXPECT_EQ(table_of(chart).rows[0].cells[7], "Curtain");
    const Show up = lamp_at(180);
    const FocusChart nothing = focus_of(up, states_of(up), {}, {}, "Now.");
    EXPECT_FALSE(nothing.lamps[0].hit);
    EXPECT_EQ(table_of(nothing).rows[0].cells[7], "") << "what it hits is not known";
    const FindHit none = [](const glm::vec3&, const glm::vec3&) { return std::optional<FocusHit>(); };
    EXPECT_EQ(table_of(focus_of(up, states_of(up), none, {}, "Now.")).rows[0].cells[7], "hits nothing");
}

// Decks at z = 1 below the lamp, so far apart, along x or y; a floor at z = 0.
FindHit decks(float gap_m, bool is_along_x) {
    return [=](const glm::vec3& from_m, const glm::vec3& way) -> std::optional<FocusHit> {
        const glm::vec3 up(0, 0, 1);
        const float to_deck_m = (1 - from_m.z) / way.z;
        const glm::vec3 at_m = from_m + to_deck_m * way - glm::vec3(1, 2, 0);
        if (std::abs(is_along_x ? at_m.y : at_m.x) > 0.5f * gap_m) return FocusHit{to_deck_m, up, "Deck"};
        return FocusHit{-from_m.z / way.z, up, "Floor"};
    };
}

TEST(Focus, falls_through_no_seam_of_two_decks) {
    const Show show = lamp_at(0);
    for (const bool is_along_x : {false, true}) {
        const auto lamp_over = [&](float gap_m) {
            return focus_of(show, states_of(show), decks(gap_m, is_along_x), {}, "Now.").lamps[0];
        };
        EXPECT_EQ(lamp_over(0.004f).hit->what, "Deck") << is_along_x;
        EXPECT_NEAR(lamp_over(0.004f).hit->distance_m, 4, 1e-4);
        EXPECT_EQ(lamp_over(0.5f).hit->what, "Floor") << "which is no seam";
    }
    const FindHit hole = [](const glm::vec3& from_m, const glm::vec3&) {
        const bool is_beside = glm::distance(glm::vec2(from_m), glm::vec2(1, 2)) > 0.005f;
        return is_beside ? std::nullopt : std::optional(FocusHit{5, {0, 0, 1}, "Floor"});
    };
    EXPECT_EQ(focus_of(show, states_of(show), hole, {}, "Now.").lamps[0].hit->what, "Floor");
}

TEST(Focus, whose_edge_leaves_the_floor_says_so) {
    const Show show = lamp_at(85);
    const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.");
    ASSERT_TRUE(chart.lamps[0].is_on_floor);
    EXPECT_FALSE(chart.lamps[0].is_pool_whole);
    // From one end of the gap round to the other: nearer to the lamp first, then farther again.
    const std::vector<glm::dvec2>& pool = chart.lamps[0].pool_m;
    const auto nearest = std::min_element(pool.begin(), pool.end(), [](const auto& a, const auto& b) {
        return glm::distance(a, {1, 2}) < glm::distance(b, {1, 2});
    });
    for (auto at = pool.begin(); at + 1 != pool.end(); ++at)
        EXPECT_EQ(glm::distance(at[1], {1, 2}) < glm::distance(at[0], {1, 2}), at < nearest)
            << at - pool.begin();
    EXPECT_GT(nearest - pool.begin(), 10);
    EXPECT_GT(pool.end() - nearest, 10);
    Report report;
    EXPECT_TRUE(must(pdf_of(chart, PaperSize::a4, report)).starts_with("%PDF-"));
}

TEST(Focus, charts_have_equal_bytes_and_name_who_has_no_beam) {
    Show show = lamp_at(30);
    show.fixtures.push_back(show.fixtures[0]);
    show.fixtures[1].name = "Dark";
    show.fixtures[1].type = nullptr;
    const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.");
    EXPECT_EQ(chart.lamps.size(), 1u);
    EXPECT_NE(chart.unknown.back().find("Dark"), std::string::npos);
    Report report;
    EXPECT_EQ(must(pdf_of(chart, PaperSize::letter, report)), must(pdf_of(chart, PaperSize::letter, report)));
    EXPECT_TRUE(must(pdf_of(FocusChart{}, PaperSize::a4, report)).starts_with("%PDF-"));
    EXPECT_TRUE(report.messages.empty());
}

TEST(Focus, leaves_out_whose_place_or_mode_nobody_knows) {
    Show show = lamp_at(30);
    show.fixtures.resize(3, show.fixtures[0]);
    show.fixtures[0].is_place_known = show.fixtures[1].is_mode_known = false;
    show.fixtures[0].name = "Nowhere";
    show.fixtures[1].name = "Modeless";
    const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.");
    EXPECT_EQ(chart.lamps.size(), 1u);
    EXPECT_NE(chart.unknown.back().find("Modeless, Nowhere"), std::string::npos) << chart.unknown.back();
}

TEST(Focus, has_no_aim_of_whom_nobody_says_how_it_is_turned) {
    Show show = lamp_at(30);
    show.fixtures[0].is_rotation_known = false;
    const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.");
    ASSERT_EQ(chart.lamps.size(), 1u);
    EXPECT_FALSE(chart.lamps[0].hit);
    EXPECT_TRUE(chart.lamps[0].pool_m.empty());
    EXPECT_EQ(chart.unknown.back(),
              "Nobody says how they are turned: where the beam goes is not known of Lamp.");
    const PaperTable table = table_of(chart);
    EXPECT_EQ(table.rows[0].cells[4].find("1 m right"), 0u) << "its place is known";
    for (const std::size_t k : {6u, 7u, 8u}) EXPECT_EQ(table.rows[0].cells[k], "");
}

TEST(Focus, is_where_movers_carry_a_lamp) {
    const Show show = lamp_at(0);
    const std::array moved{glm::translate(glm::mat4(1.0f), {2, 0, -3})};
    const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.", moved);
    const FocusLamp& lamp = chart.lamps.at(0);
    EXPECT_NEAR(lamp.place_m.x, 3, 1e-5);
    EXPECT_NEAR(lamp.place_m.z, 2, 1e-5);
    ASSERT_TRUE(lamp.hit);
    EXPECT_NEAR(lamp.hit->distance_m, 2, 1e-5);
    EXPECT_NEAR(lamp.aim_m().x, 3, 1e-5);
}

// A truss from so far above the lamp's floor down to so far, and the floor.
FindHit truss_and_floor(float high_m, float low_m, bool is_bar) {
    return [=](const glm::vec3& from_m, const glm::vec3&) {
        for (const float at_m : {high_m, low_m})
            if (from_m.z > at_m) return std::optional(FocusHit{from_m.z - at_m, {0, 0, 1}, "Truss", is_bar});
        return std::optional(FocusHit{from_m.z, {0, 0, 1}, "Floor"});
    };
}

bool says(const FocusChart& chart, const std::string& part) {
    return std::any_of(chart.unknown.begin(), chart.unknown.end(),
                       [&](const std::string& sentence) { return sentence.find(part) != std::string::npos; });
}

TEST(Focus, looks_past_the_truss_at_the_lens_and_says_so) {
    const Show show = lamp_at(0); // 5 m high
    const FocusChart chart = focus_of(show, states_of(show), truss_and_floor(4.9f, 4.6f, true), {}, "Now.");
    ASSERT_TRUE(chart.lamps.at(0).hit);
    EXPECT_EQ(chart.lamps[0].hit->what, "Floor");
    EXPECT_NEAR(chart.lamps[0].hit->distance_m, 5, 1e-4);
    EXPECT_TRUE(says(chart, "Looked through is a truss or pipe within 0.5 m of the lens of Lamp."));
    // What is farther away is in its way, and what is no truss is what it hits.
    const FocusChart far = focus_of(show, states_of(show), truss_and_floor(4.4f, 4.1f, true), {}, "Now.");
    EXPECT_EQ(far.lamps.at(0).hit->what, "Truss");
    EXPECT_TRUE(far.unknown.empty());
    const FocusChart near = focus_of(show, states_of(show), truss_and_floor(4.9f, 4.6f, false), {}, "Now.");
    EXPECT_NEAR(near.lamps.at(0).hit->distance_m, 0.1, 1e-4);
    EXPECT_TRUE(says(near, "within 0.5 m of the lens may be a mistake of the model: Lamp."));
}

std::string channel_of(const std::string& attribute, const std::string& geometry,
                       const std::string& physical = "") {
    return R"(<DMXChannel Offset="1" Geometry=")" + geometry + R"("><LogicalChannel Attribute=")" +
           attribute + R"("><ChannelFunction Name="F" Attribute=")" + attribute + "\" " + physical +
           "/></LogicalChannel></DMXChannel>";
}

TEST(Focus, prints_no_angle_and_no_pool_that_nobody_says) {
    const std::string beam = R"(<Geometry Name="Base"><Beam Name="Beam" FieldAngle="20"/></Geometry>)";
    const std::string beamless = R"(<Geometry Name="Base"/>)";
    const struct {
        std::string geometries, channels;
        bool is_said;
    } cases[] = {{beamless, channel_of("Dimmer", "Base"), false},
                 {beam, channel_of("Zoom", "Beam"), false},
                 {beam, channel_of("Zoom", "Beam", R"(PhysicalFrom="10" PhysicalTo="50")"), true},
                 {beam, channel_of("Dimmer", "Beam"), true}};
    for (const auto& one : cases) {
        fixture::Description description;
        description.geometries = one.geometries;
        description.channels = one.channels;
        Show show = lamp_at(0);
        show.fixtures[0].type = std::make_shared<const fixture::Type>(fixture::loaded(description).type);
        const FocusChart chart = focus_of(show, states_of(show), {}, {}, "Now.");
        ASSERT_EQ(chart.lamps.size(), 1u) << one.channels;
        EXPECT_EQ(chart.lamps[0].is_angle_known, one.is_said) << one.channels;
        EXPECT_EQ(chart.lamps[0].pool_m.empty(), !one.is_said) << one.channels;
        EXPECT_EQ(table_of(chart).rows[0].cells[9].empty(), !one.is_said) << one.channels;
        EXPECT_EQ(says(chart, "Nobody says the angle of Lamp"), !one.is_said) << one.channels;
        Report report;
        EXPECT_TRUE(must(pdf_of(chart, PaperSize::a4, report)).starts_with("%PDF-"));
    }
}

TEST(Focus, of_a_show_without_fixtures_says_so) {
    const FocusChart chart = focus_of({}, {}, {}, {}, "Now.");
    EXPECT_EQ(chart.unknown.at(0), "The show has no fixtures.");
}

TEST(Focus, tells_a_show_without_a_stage_from_one_whose_stage_is_not_readable) {
    Show show = lamp_at(0);
    EXPECT_TRUE(says(focus_of(show, states_of(show), {}, {}, "Now."), "The show has no stage model"));
    show.stage_file = "stage.glb";
    EXPECT_TRUE(says(focus_of(show, states_of(show), {}, {}, "Now."), "The stage model could not be read"));
}

TEST(Focus, prints_no_aim_where_pan_or_tilt_has_no_range) {
    const std::string tilt =
        R"(<Geometry Name="Base"><Axis Name="Head"><Beam Name="Beam"/></Axis></Geometry>)";
    for (const bool is_said : {false, true}) {
        fixture::Description description;
        description.geometries = tilt;
        description.channels =
            channel_of("Tilt", "Head", is_said ? R"(PhysicalFrom="-10" PhysicalTo="10")" : "");
        Show show = lamp_at(0);
        show.fixtures[0].type = std::make_shared<const fixture::Type>(fixture::loaded(description).type);
        const FindHit floor = [](const glm::vec3&, const glm::vec3&) {
            return std::optional(FocusHit{5, {0, 0, 1}, "Floor"});
        };
        const FocusChart chart = focus_of(show, states_of(show), floor, {}, "Now.");
        const std::vector<std::string> cells = table_of(chart).rows.at(0).cells;
        EXPECT_EQ(chart.lamps[0].is_aim_known(), is_said);
        EXPECT_EQ(chart.lamps[0].hit.has_value(), is_said);
        EXPECT_EQ(chart.lamps[0].pool_m.empty(), !is_said);
        for (const std::size_t column : {6u, 7u, 8u, 11u})
            EXPECT_EQ(cells[column].empty(), !is_said) << column;
        EXPECT_EQ(says(chart, "where the beam goes is not known of Lamp."), !is_said);
        Report report;
        EXPECT_TRUE(must(pdf_of(chart, PaperSize::a4, report)).starts_with("%PDF-"));
    }
}

TEST(Focus, pool_is_what_the_iris_leaves) {
    const Show show = lamp_at(0);
    std::vector<fixture::State> states = states_of(show);
    states[0].beams[0].optics.iris = 0.5f;
    const FocusChart chart = focus_of(show, states, {}, {}, "Now.");
    EXPECT_NEAR(extent(chart.lamps.at(0).pool_m).size().x, 5 * std::tan(glm::radians(10.0)), 1e-3);
    EXPECT_TRUE(says(chart, "The iris narrows angle and pool of Lamp."));
}

TEST(Focus, says_left_and_right_as_the_house_sees_it) {
    const PrintStyle english, german{Language::german, Units::metric};
    EXPECT_EQ(across_text(english, -1.75), "1.75 m left");
    EXPECT_EQ(along_text(english, 3), "3 m up-stage");
    EXPECT_EQ(along_text(german, -0.5), "0,5 m zum Saal");
    EXPECT_EQ(across_text(english, 0), "0 m");
}

} // namespace
} // namespace ghost::scene
