// SPDX-License-Identifier: Apache-2.0
// Plans and sections: lines of objects, which symbol stands for what, words that cover nothing, sheets.
#include "drawings/drawings.h"

#include "drawings/private/drawing.h"
#include "drawings/private/file_symbols.h"
#include "drawings/private/labels.h"
#include "drawings/private/outlines.h"
#include "drawings/private/rigging.h"
#include "drawings/private/sheet.h"
#include "show/show.h"
#include "stage/primitives.h"
#include "support/must.h"
#include "support/tiny_gdtf.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <memory>

namespace ghost::scene {
namespace {

// A cuboid of that size about a point.
void add_cuboid(Stage& stage, const std::string& name, const glm::vec3& middle, const glm::vec3& size) {
    if (stage.meshes.empty()) stage.meshes.push_back(primitive_mesh("Cube"));
    glm::vec3 low(1e9f), high(-1e9f);
    for (const glm::vec3& position : stage.meshes[0].positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const glm::mat4 world = glm::translate(glm::mat4(1.0f), middle) *
                            glm::scale(glm::mat4(1.0f), size / (high - low)) *
                            glm::translate(glm::mat4(1.0f), -0.5f * (low + high));
    Instance instance;
    instance.name = name;
    instance.world = world;
    stage.instances.push_back(instance);
}

std::shared_ptr<const fixture::Type> type_with(const std::string& channels, const std::string& beam = "",
                                               const std::string& geometries = "") {
    fixture::Description description;
    description.geometries = geometries.empty()
                                 ? R"(<Geometry Name="Base"><Beam Name="Beam" )" + beam + "/></Geometry>"
                                 : geometries;
    if (!channels.empty()) description.channels = channels;
    return std::make_shared<const fixture::Type>(fixture::loaded(description).type);
}

std::string channel(const std::string& attribute, const std::string& geometry = "Beam",
                    const std::string& physical = "") {
    static int offset = 0;
    return "<DMXChannel Offset=\"" + std::to_string(1 + offset++ % 400) + "\" Geometry=\"" + geometry +
           "\"><LogicalChannel Attribute=\"" + attribute + "\"><ChannelFunction Name=\"F\" Attribute=\"" +
           attribute + "\" " + physical + "/></LogicalChannel></DMXChannel>";
}

SymbolKind kind_of(std::shared_ptr<const fixture::Type> type) {
    PatchedFixture fixture;
    fixture.type = std::move(type);
    return symbol_of(fixture);
}

Show show_of(int fixtures) {
    Show show;
    show.name = "Demo";
    show.file = "demo/show.toml";
    static const auto type = type_with("");
    for (int i = 0; i < fixtures; ++i) {
        PatchedFixture& fixture = show.fixtures.emplace_back();
        fixture.name = "Spot " + std::to_string(i + 1);
        fixture.type = type;
        fixture.position_m = {-4.5f + static_cast<float>(i % 10), 3.0f + static_cast<float>(i / 10), 6.0f};
    }
    return show;
}

TEST(Outlines, of_a_box_are_four_lines_from_each_side) {
    Stage stage;
    add_cuboid(stage, "Truss", {0, 2, 6}, {10, 0.3f, 0.3f});
    const Outlines above = outlines_of(stage, from_above(), 0.001);
    ASSERT_EQ(above.objects.size(), 1u);
    EXPECT_EQ(above.objects[0].ends_m.size(), 8u);
    EXPECT_NEAR(above.objects[0].extent.size().x, 10, 0.002);
    EXPECT_NEAR(above.objects[0].extent.size().y, 0.3, 0.002);
    const Outlines side = outlines_of(stage, from_the_side(std::nullopt), 0.001);
    EXPECT_EQ(side.objects[0].ends_m.size(), 8u);
    EXPECT_NEAR(side.objects[0].extent.low.y, 5.85, 0.002);
}

TEST(Outlines, of_a_section_end_where_it_is_cut) {
    Stage stage;
    add_cuboid(stage, "left", {-3, 0, 1}, {1, 1, 1});
    add_cuboid(stage, "right", {3, 0, 1}, {1, 1, 1});
    const Outlines cut = outlines_of(stage, from_the_side(0.0), 0.001);
    ASSERT_EQ(cut.objects.size(), 1u);
    EXPECT_EQ(cut.objects[0].instance, 0u);
}

TEST(Outlines, with_too_many_lines_are_the_outermost_one) {
    Stage stage;
    Mesh& mesh = stage.meshes.emplace_back();
    for (std::uint32_t i = 0; i < 5000; ++i) { // loose triangles have three borders each
        const auto x = static_cast<float>(i % 100), y = static_cast<float>(i / 100);
        mesh.positions.insert(mesh.positions.end(), {{x, y, 0}, {x + 0.5f, y, 0}, {x, y + 0.5f, 0}});
        mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    stage.instances.push_back({"many", 0, glm::mat4(1.0f)});
    const Outlines lines = outlines_of(stage, from_above(), 0.001);
    EXPECT_EQ(lines.simplified, 1u);
    EXPECT_LT(lines.objects[0].ends_m.size(), 20u);
    EXPECT_NEAR(lines.objects[0].extent.size().x, 99.5, 1e-6);
}

TEST(Outlines, with_too_many_lines_together_are_simple_from_there_on) {
    Stage stage;
    Mesh& mesh = stage.meshes.emplace_back();
    for (std::uint32_t i = 0; i < 1900; ++i) { // 5,700 lines, and 21 such objects are 119,700
        const auto x = static_cast<float>(i % 50), y = static_cast<float>(i / 50);
        mesh.positions.insert(mesh.positions.end(), {{x, y, 0}, {x + 0.5f, y, 0}, {x, y + 0.5f, 0}});
        mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    for (int i = 0; i < 23; ++i) stage.instances.push_back({"many", 0, glm::mat4(1.0f)});
    const Outlines lines = outlines_of(stage, from_above(), 0.001);
    ASSERT_EQ(lines.objects.size(), 23u);
    EXPECT_EQ(lines.objects[20].ends_m.size(), 11'400u);
    EXPECT_EQ(lines.simplified, 2u);
    EXPECT_LT(lines.objects[21].ends_m.size(), 20u);
}

// Level, of that many squares, two triangles each; its lines are those of its rim.
Mesh level_mesh(std::uint32_t columns, std::uint32_t rows) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= rows; ++y)
        for (std::uint32_t x = 0; x <= columns; ++x)
            mesh.positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0f);
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const std::uint32_t at = y * (columns + 1) + x, above = at + columns + 1;
            mesh.indices.insert(mesh.indices.end(), {at, at + 1, above, at + 1, above + 1, above});
        }
    return mesh;
}

TEST(Outlines, of_a_mesh_with_too_many_triangles_are_the_outermost_one) {
    constexpr std::size_t kMost = 200'000;
    for (const bool is_one_more : {false, true}) {
        Stage stage;
        Mesh& mesh = stage.meshes.emplace_back(level_mesh(400, 250));
        ASSERT_EQ(mesh.indices.size(), 3 * kMost);
        if (is_one_more) mesh.indices.insert(mesh.indices.end(), {0, 1, 401});
        stage.instances.push_back({"deck", 0, glm::mat4(1.0f)});
        const Outlines lines = outlines_of(stage, from_above(), 0.001);
        EXPECT_EQ(lines.simplified, is_one_more ? 1u : 0u);
        ASSERT_EQ(lines.objects.size(), 1u);
        EXPECT_EQ(lines.objects[0].ends_m.size(), 2 * (is_one_more ? 4u : 2 * (400u + 250u)));
    }
}

TEST(Outlines, of_meshes_with_more_edges_than_are_kept_are_the_same) {
    Stage stage;
    for (int k = 0; k < 7; ++k) // 300,650 edges each: with the last one they are more than two million
        stage.meshes.push_back(level_mesh(400, 250));
    for (const int mesh : {0, 0, 1, 2, 3, 4, 5, 6, 0, 6})
        stage.instances.push_back({"deck", mesh, glm::mat4(1.0f)});
    const Outlines lines = outlines_of(stage, from_above(), 0.001);
    EXPECT_EQ(lines.simplified, 0u);
    ASSERT_EQ(lines.objects.size(), stage.instances.size());
    for (const Outline& one : lines.objects) EXPECT_EQ(one.ends_m, lines.objects[0].ends_m);
}

TEST(Outlines, with_too_many_objects_leave_the_last_out_and_count_them) {
    Stage stage;
    add_cuboid(stage, "box", {0, 0, 1}, {1, 1, 1});
    const Instance one = stage.instances.front();
    stage.instances.assign(20'003, one);
    const Outlines lines = outlines_of(stage, from_above(), 10.0); // each is a dot on paper
    EXPECT_EQ(lines.objects.size(), 20'000u);
    EXPECT_EQ(lines.left_out, 3u);
}

TEST(Hull, is_the_outermost_line) {
    EXPECT_EQ(hull_of({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}}).size(), 4u);
    EXPECT_TRUE(hull_of({}).empty());
}

TEST(Symbols, follow_from_what_a_type_does) {
    const std::string moving =
        R"(<Geometry Name="Base"><Axis Name="Yoke"><Axis Name="Head"><Beam Name="Beam" FieldAngle="30" BeamType="Wash"/></Axis></Axis></Geometry>)";
    const std::string axes = channel("Pan", "Yoke", R"(PhysicalFrom="-270" PhysicalTo="270")") +
                             channel("Tilt", "Head", R"(PhysicalFrom="-130" PhysicalTo="130")");
    EXPECT_EQ(kind_of(type_with(axes, "", moving)), SymbolKind::moving_wash);
    EXPECT_EQ(kind_of(type_with(axes + channel("Gobo1"), "", moving)), SymbolKind::moving_profile);
    EXPECT_EQ(
        kind_of(type_with(axes + channel("Zoom", "Beam", R"(PhysicalFrom="2" PhysicalTo="6")"), "", moving)),
        SymbolKind::moving_beam);
    EXPECT_EQ(kind_of(type_with("", R"(BeamType="Wash")")), SymbolKind::wash);
    EXPECT_EQ(kind_of(type_with("", R"(BeamType="Spot")")), SymbolKind::profile);
    EXPECT_EQ(kind_of(type_with(channel("Shutter1Strobe", "Beam", R"(PhysicalFrom="1" PhysicalTo="20")"),
                                R"(BeamType="Wash")")),
              SymbolKind::strobe);
    const std::string beamless = R"(<Geometry Name="Base"><Geometry Name="Beam"/></Geometry>)";
    EXPECT_EQ(kind_of(type_with(channel("Pan") + channel("Gobo1") + channel("Dimmer"), "", beamless)),
              SymbolKind::moving_profile);
    EXPECT_EQ(kind_of(type_with(channel("Dimmer"), "", beamless)), SymbolKind::not_known);
    EXPECT_EQ(kind_of(type_with(channel("Fog1"), "", beamless)), SymbolKind::other);
    EXPECT_EQ(kind_of(nullptr), SymbolKind::not_known);
    PatchedFixture projector;
    projector.projector.emplace();
    EXPECT_EQ(symbol_of(projector), SymbolKind::projector);
}

TEST(Labels, cover_neither_each_other_nor_symbols) {
    Labels labels({{0, 0}, {400, 300}});
    std::vector<Extent2> boxes;
    for (int i = 0; i < 12; ++i) {
        boxes.push_back({{100.0 + 11 * i, 100}, {110.0 + 11 * i, 110}});
        labels.keep_free(boxes.back());
    }
    for (std::size_t i = 0; i < 12; ++i) {
        const auto label = labels.place({30, 12}, boxes[i]);
        ASSERT_TRUE(label) << i;
        boxes.push_back(label->box);
    }
    for (std::size_t a = 0; a < boxes.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(boxes[a].touches(boxes[b])) << a << " " << b;
    EXPECT_FALSE(labels.place({500, 10}, boxes[0]));
}

// A box of 0.4 by 0.2 m, drawn 0.1 m to the right of where it is put in.
std::shared_ptr<const fixture::Type> type_with_symbol() {
    fixture::Description description;
    description.models = R"(<Model Name="Body" PrimitiveType="Cube" Length="0.4" Width="0.2" Height="0.2"/>)";
    description.geometries = R"(<Geometry Name="Base" Model="Body"><Beam Name="Beam"/></Geometry>)";
    fixture::Type type = fixture::loaded(description).type;
    type.models.at(0).symbols[0] = {
        {{{-0.1f, -0.1f}, {0.3f, -0.1f}, {0.3f, 0.1f}, {-0.1f, 0.1f}}, true, true}};
    return std::make_shared<const fixture::Type>(std::move(type));
}

Extent2 extent_of(const std::vector<FlatLine>& lines) {
    Extent2 all;
    for (const FlatLine& line : lines)
        for (const glm::dvec2& point : line.points) all.include(point);
    return all;
}

TEST(Symbols, of_the_fixtures_own_file_turn_as_it_hangs) {
    PatchedFixture fixture;
    fixture.type = type_with_symbol();
    FileSymbols symbols;
    const auto seen = [&](const glm::vec3& rotation_deg) {
        fixture.rotation_deg = rotation_deg;
        fixture.position_m = {7, 8, 9};
        return extent_of(symbols.seen(fixture, fixture_to_world(fixture, 0), from_above()));
    };
    EXPECT_NEAR(seen({0, 0, 0}).high.x, 0.3, 1e-6);
    EXPECT_NEAR(seen({0, 0, 90}).high.y, 0.3, 1e-6);
    EXPECT_NEAR(seen({0, 0, 90}).size().x, 0.2, 1e-6);
    EXPECT_NEAR(seen({180, 0, 0}).high.x, 0.3, 1e-6) << "on the floor it is mirrored";
    EXPECT_TRUE(seen({90, 0, 0}).is_empty()) << "its back is seen, and the file has none";
    fixture.type = type_with("");
    EXPECT_TRUE(seen({0, 0, 0}).is_empty());
}

TEST(Symbols, of_files_are_drawn_and_the_legend_says_so) {
    Show show = show_of(3);
    const Drawings plain = must(drawings_of(show, {}, {}));
    for (PatchedFixture& fixture : show.fixtures) fixture.type = type_with_symbol();
    const Drawings drawn = must(drawings_of(show, {}, {}));
    EXPECT_NE(plain.pdf, drawn.pdf);
    EXPECT_EQ(must(drawings_of(show, {}, {})).pdf, drawn.pdf);
}

TEST(Bars, are_named_after_where_lamps_hang) {
    Stage stage;
    add_cuboid(stage, "Truss A", {0, 3, 6.3f}, {10, 0.3f, 0.3f});
    add_cuboid(stage, "Truss without lamps", {0, 30, 6.3f}, {10, 0.3f, 0.3f});
    const Show show = show_of(3);
    const auto bars = rigging_of(show, stage).bars;
    ASSERT_EQ(bars.size(), 1u);
    EXPECT_EQ(bars[0].name, "Truss A");
    EXPECT_NEAR(bars[0].bar.length_m(), 10, 0.01);
}

// Pieces of an arc round (0, -6.5): 8 m long, its middle 1 m up-stage of its ends.
TEST(Bars, that_are_bent_stay_bent_where_nothing_lengthens_them) {
    Stage stage;
    Mesh& mesh = stage.meshes.emplace_back();
    for (int k = -20; k <= 20; ++k) {
        const float angle = std::asin(4.0f / 8.5f) * static_cast<float>(k) / 20;
        for (const float radius_m : {8.35f, 8.65f})
            for (const float z_m : {5.9f, 6.2f})
                mesh.positions.emplace_back(radius_m * std::sin(angle), radius_m * std::cos(angle) - 5, z_m);
    }
    stage.instances.push_back({"Arc", 0, glm::mat4(1.0f)});
    const auto bars = rigging_of(show_of(10), stage).bars;
    ASSERT_EQ(bars.size(), 1u);
    EXPECT_NEAR(bars[0].bar.bow_m, 1, 0.05f);
}

TEST(Drawings, have_equal_bytes_and_say_which_scale_fits) {
    Stage stage;
    add_cuboid(stage, "Truss A", {0, 3, 6.3f}, {10, 0.3f, 0.3f});
    const Show show = show_of(30);
    DrawingOptions options;
    const Drawings made = must(drawings_of(show, stage, options));
    EXPECT_TRUE(made.pdf.starts_with("%PDF-1."));
    EXPECT_EQ(must(drawings_of(show, stage, options)).pdf, made.pdf);
    EXPECT_EQ(made.sheets, 2u);
    EXPECT_EQ(made.plan_scale, 50);
    options.scale = 20; // a plan of 14 m by 9 m: 700 mm by 450 mm
    EXPECT_GT(must(drawings_of(show, stage, options)).sheets, 4u);
    options.scale = 1;
    const auto too_large = drawings_of(show, stage, options);
    ASSERT_FALSE(too_large.ok());
    EXPECT_NE(too_large.error().what.find("1:50 fits on one"), std::string::npos) << too_large.error().what;
    options.scale.reset();
    options.style.units = Units::imperial;
    EXPECT_EQ(must(drawings_of(show, stage, options)).plan_scale, 48);
}

TEST(Bars, of_many_pieces_are_one_and_those_with_lamps_come_first) {
    Stage stage;
    for (int i = 0; i < static_cast<int>(kMostBars); ++i) // far away
        add_cuboid(stage, "rail", {100.0f + 3 * static_cast<float>(i), 300, 1}, {1, 0.1f, 0.1f});
    for (int i = 0; i < 10; ++i)
        add_cuboid(stage, "Truss " + std::to_string(i), {-4.5f + static_cast<float>(i), 3, 6.3f},
                   {1, 0.3f, 0.3f});
    const Rigging rigging = rigging_of(show_of(10), stage);
    ASSERT_EQ(rigging.bars.size(), 1u);
    EXPECT_NEAR(rigging.bars[0].bar.length_m(), 10, 0.01);
    EXPECT_EQ(rigging.pieces_left_out, 10u);
    EXPECT_EQ(std::count(rigging.are_slender.begin(), rigging.are_slender.end(), true),
              static_cast<std::ptrdiff_t>(kMostBars + 10));
}

TEST(Drawings, have_a_wall_whole_and_say_what_no_scale_fits) {
    Show show = show_of(0);
    PatchedFixture& wall = show.fixtures.emplace_back();
    wall.name = "Wall";
    wall.position_m = {0, 4, 5};
    wall.wall.emplace();
    wall.wall->size_m = {30, 7};
    const auto seen = bodies_seen(show, {}, from_the_side(std::nullopt));
    Extent2 extent;
    for (const glm::dvec2& point : seen.at(0).at(0)) extent.include(point);
    EXPECT_NEAR(extent.low.y, 1.5, 1e-5);
    EXPECT_NEAR(extent.high.y, 8.5, 1e-5);
    EXPECT_NEAR(extent.size().x, kWallDepth_m, 1e-5);
    const Drawings made = must(drawings_of(show, {}, {}));
    EXPECT_EQ(made.plan_scale, 125) << "35.2 m on A3; without the ends of the wall 1:25";
    show.fixtures.push_back(wall);
    show.fixtures[1].position_m.x = 1e6f;
    const auto none = drawings_of(show, {}, {});
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().what.find("m apart: no scale up to 1:50000 fits on a sheet of A3"),
              std::string::npos)
        << none.error().what;
}

bool has_line(const std::vector<DrawnLabel>& labels, const std::string& line) {
    return std::any_of(labels.begin(), labels.end(), [&](const DrawnLabel& label) {
        return std::find(label.lines.begin(), label.lines.end(), line) != label.lines.end();
    });
}

// A plan that is laid out.
struct LaidOut {
    LaidOut(const Show& show, const Stage& stage, const View& view, bool is_plan)
        : rigging(rigging_of(show, stage)),
          drawing(pdf, show, stage, options, view, is_plan, rigging, symbols) {
        int scale = 0;
        must(drawing.lay_out(scale));
    }
    DrawingOptions options;
    PdfWriter pdf{PaperSize::a3, true, "Demo"};
    Rigging rigging;
    FileSymbols symbols;
    Drawing drawing;
};

TEST(Labels, of_a_long_name_keep_their_numbers) {
    Stage stage;
    const std::string name = "Truss of a name that is longer than anybody would write it on a plan";
    add_cuboid(stage, name, {0, 3, 6.3f}, {10, 0.3f, 0.3f});
    const Show show = show_of(3);
    const LaidOut plan(show, stage, from_above(), true);
    EXPECT_TRUE(has_line(plan.drawing.labels(), name));
    EXPECT_TRUE(has_line(plan.drawing.labels(), "underside 6.15 m, length 10 m"));
}

TEST(Labels, of_many_lamps_cut_no_number) {
    Show show = show_of(2);
    for (PatchedFixture& fixture : show.fixtures) {
        fixture.name = "Light Source Pendant 44deg #7" + fixture.name.substr(fixture.name.size() - 1);
        fixture.position_m = {0, 3, 6};
    }
    show.fixtures[1].name += " above the orchestra";
    const Stage stage;
    const LaidOut plan(show, stage, from_above(), true);
    EXPECT_TRUE(has_line(plan.drawing.labels(), "2: see the instrument schedule"));
}

TEST(Sheets, say_that_there_is_no_stage_where_lamps_have_bodies) {
    const Show show = show_of(1);
    Stage stage;
    add_cuboid(stage, "Body", {-4.5f, 3, 6}, {0.3f, 0.3f, 0.3f});
    const std::string sentence = "The show has no stage model: trusses and set are not drawn.";
    for (const int owner : {kNone, 0}) {
        stage.instances[0].fixture = owner;
        const LaidOut plan(show, stage, from_above(), true);
        const std::vector<std::string>& said = plan.drawing.remarks();
        EXPECT_EQ(std::count(said.begin(), said.end(), sentence), owner == kNone ? 0 : 1);
    }
}

TEST(Sheets, draw_nobody_whose_place_is_not_known) {
    Show show = show_of(2);
    show.fixtures[1].is_place_known = false;
    const Stage stage;
    const LaidOut plan(show, stage, from_above(), true);
    EXPECT_EQ(plan.drawing.rig().size(), 1u);
    const std::vector<std::string>& said = plan.drawing.remarks();
    EXPECT_EQ(
        std::count(said.begin(), said.end(), "Not drawn, for nobody says a place that can be used: Spot 2."),
        1);
}

TEST(Sheets, name_whose_turn_nobody_says) {
    Show show = show_of(2);
    show.fixtures[1].is_rotation_known = false;
    const Stage stage;
    const LaidOut plan(show, stage, from_above(), true);
    EXPECT_EQ(plan.drawing.rig().size(), 2u);
    const std::vector<std::string>& said = plan.drawing.remarks();
    EXPECT_EQ(std::count(said.begin(), said.end(),
                         "Drawn as if they hung upright, for nobody says how they are turned: Spot 2."),
              1);
}

TEST(Sheets, of_a_cut_section_count_what_is_left) {
    const Show show = show_of(10); // from -4.5 m to 4.5 m
    const Stage stage;
    const Rigging rigging = rigging_of(show, stage);
    FileSymbols symbols;
    const DrawingOptions options;
    PdfWriter pdf(PaperSize::a3, true, "Demo");
    const Drawing section(pdf, show, stage, options, from_the_side(0.0), false, rigging, symbols);
    const auto legend = legend_of(show, section.rig(), symbols);
    ASSERT_EQ(legend.size(), 1u);
    EXPECT_EQ(legend[0].count, 5u);
}

TEST(Sheets, give_a_long_type_two_lines) {
    PdfWriter pdf(PaperSize::a4, true, "Sheet");
    std::vector<LegendLine> legend(100);
    const std::size_t of_short = draw_column(pdf, room_on(pdf), {}, {}, legend, {});
    for (LegendLine& line : legend) line.type = "A maker of a long name and a type of a longer one, too";
    EXPECT_LT(draw_column(pdf, room_on(pdf), {}, {}, legend, {}), of_short);
}

// 2,000 lamps over all of the sheet, to its corners but for the usual margin, which at 1:500 is no wider than
// a line of words.
TEST(Sheets, that_are_full_have_scale_bar_and_words_beside_all_symbols) {
    Show show = show_of(2000);
    for (std::size_t i = 0; i < 2000; ++i)
        show.fixtures[i].position_m = {static_cast<float>(i % 50) * 3, static_cast<float>(i / 50) * 3, 6};
    const Stage stage;
    const LaidOut plan(show, stage, from_above(), true);
    ASSERT_EQ(plan.drawing.symbols().size(), 2000u);
    for (const SheetPart& sheet : plan.drawing.sheets()) {
        ASSERT_FALSE(sheet.scale_bar.is_empty());
        for (const DrawnSymbol& symbol : plan.drawing.symbols()) {
            const Extent2 box{symbol.box.low + sheet.offset, symbol.box.high + sheet.offset};
            EXPECT_TRUE(sheet.window.holds(box));
            EXPECT_FALSE(box.touches(sheet.scale_bar));
            for (const EdgeWords& words : sheet.words) EXPECT_FALSE(box.touches(words.box)) << words.text;
        }
        EXPECT_FALSE(sheet.window.touches(sheet.scale_bar));
        EXPECT_LT(sheet.scale_bar.high.y, plan.pdf.height_pt() - 10 * kPointsOfMm) << "within the frame";
    }
}

TEST(Sheets, say_which_size_symbols_have) {
    const Stage stage;
    for (const float far_m : {1.0f, 150.0f}) {
        Show show = show_of(2);
        show.fixtures[1].position_m.x = far_m;
        const LaidOut plan(show, stage, from_above(), true);
        const std::vector<std::string>& said = plan.drawing.remarks();
        const auto has = [&](const char* words) {
            return std::any_of(said.begin(), said.end(),
                               [&](const std::string& one) { return one.find(words) != std::string::npos; });
        };
        EXPECT_EQ(has("as large as its body, turned"), far_m == 1.0f);
        EXPECT_EQ(has("as large as its body but at least 3 points"), far_m > 1.0f);
    }
}

TEST(Sheets, keep_room_for_all_notes) {
    PdfWriter pdf(PaperSize::a4, true, "Sheet");
    const std::vector<LegendLine> legend(100);
    const std::size_t most = draw_column(pdf, room_on(pdf), {}, {}, legend, {});
    const std::vector<std::string> notes(9, std::string(120, 'n'));
    const std::size_t fewer = draw_column(pdf, room_on(pdf), {}, {}, legend, notes);
    EXPECT_GT(most, 10u);
    EXPECT_LT(fewer, most);
    EXPECT_EQ(draw_column(pdf, room_on(pdf), {}, {}, legend, std::vector<std::string>(20, notes[0])), 0u);
}

TEST(Outlines, behind_the_last_line_are_simple_ones) {
    Stage stage;
    Mesh& mesh = stage.meshes.emplace_back();
    for (std::uint32_t i = 0; i < 1900; ++i) {
        const auto x = static_cast<float>(i % 100), y = static_cast<float>(i / 100);
        mesh.positions.insert(mesh.positions.end(), {{x, y, 0}, {x + 0.5f, y, 0}, {x, y + 0.5f, 0}});
        mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    for (int i = 0; i < 25; ++i) stage.instances.push_back({"many", 0, glm::mat4(1.0f)});
    const Outlines lines = outlines_of(stage, from_above(), 0.001);
    ASSERT_EQ(lines.objects.size(), 25u);
    EXPECT_EQ(lines.simplified, 4u) << "21 of 5,700 lines are fewer than 120,000";
    EXPECT_EQ(lines.objects[20].ends_m.size(), 2u * 5700);
    EXPECT_LT(lines.objects[21].ends_m.size(), 20u);
}

TEST(Drawings, of_bad_input_are_made) {
    EXPECT_TRUE(drawings_of(Show{}, Stage{}, {}).ok());
    Show show = show_of(3);
    show.fixtures[0].type = nullptr;
    show.fixtures[0].name = std::string(100'000, 'x');
    show.fixtures[1].name = "\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d \xe7\x81\xaf\n\x01\xff";
    show.fixtures[1].position_m = {1e4f, -1e4f, 1e4f};
    show.fixtures[2].position_m.x = std::nanf("");
    Stage stage;
    add_cuboid(stage, "flat", {0, 0, 0}, {1, 1, 0});
    EXPECT_TRUE(drawings_of(show, stage, {}).ok());
}

TEST(Scale, is_one_that_people_use) {
    EXPECT_EQ(scale_text(50), "1:50");
    EXPECT_EQ(scale_text(48), "1:48 (1/4\" = 1'-0\")");
    EXPECT_EQ(scale_text(64), "1:64 (3/16\" = 1'-0\")");
    EXPECT_EQ(scale_text(128), "1:128 (3/32\" = 1'-0\")");
    EXPECT_DOUBLE_EQ(points_of_metre(100), 72 / 2.54);
    EXPECT_EQ(fitting_scale({10, 1}, {100 * kPointsOfMm, 100 * kPointsOfMm}, Units::metric), 100);
    EXPECT_FALSE(fitting_scale({1e9, 1}, {100, 100}, Units::metric));
}

} // namespace
} // namespace ghost::scene
