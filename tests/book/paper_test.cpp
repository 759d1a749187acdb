// SPDX-License-Identifier: Apache-2.0
// The tables of a crew: sorted, with what is free and what is not known.
#include "book/paper.h"

#include "book/paper_pages.h"
#include "book/private/paper_widths.h"
#include "show/show.h"
#include "support/must.h"
#include "support/mvr_files.h"
#include "support/tiny_gdtf.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <string_view>

namespace ghost::scene {
namespace {

// Three channels and a wheel of two slots.
std::shared_ptr<const fixture::Type> three_channel_spot(const std::string& properties = "") {
    fixture::Description description;
    if (!properties.empty()) description.physical = "<Properties>" + properties + "</Properties>";
    description.wheels =
        R"(<Wheel Name="W"><Slot Name="Open"/><Slot Name="Red" Color="0.64,0.33,21"/></Wheel>)";
    description.channels = R"(
<DMXChannel Offset="1,2" Geometry="Beam"><LogicalChannel Attribute="Dimmer">
  <ChannelFunction Name="Dimmer" Attribute="Dimmer"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="3" Geometry="Beam"><LogicalChannel Attribute="Color1">
  <ChannelFunction Name="Colour" Attribute="Color1" Wheel="W"><ChannelSet Name="Red" DMXFrom="9/1" WheelSlotIndex="2"/>
  </ChannelFunction></LogicalChannel></DMXChannel>)";
    return std::make_shared<const fixture::Type>(must(fixture::load_xml(description.xml())).type);
}

PatchedFixture hung(const std::string& name, int universe, int address) {
    PatchedFixture fixture;
    fixture.name = name;
    fixture.universe = universe;
    fixture.address = address;
    static const auto type = three_channel_spot();
    fixture.type = type;
    return fixture;
}

const PaperTable& table(const Paper& paper, std::string_view file) {
    for (const PaperTable& one : paper.tables)
        if (one.file == file) return one;
    throw std::runtime_error("no table " + std::string(file));
}

std::vector<std::string> column(const PaperTable& table, const std::string& title) {
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < table.columns.size(); ++k)
        if (table.columns[k].title == title)
            for (const PaperRow& row : table.rows) cells.push_back(row.cells[k]);
    return cells;
}

using Cells = std::vector<std::string>;

TEST(Patch, has_what_is_free_between) {
    Show show;
    show.fixtures = {hung("b", 1, 7), hung("a", 1, 1), hung("c", 3, 510)};
    const PaperTable patch = table(paper_of(show), "patch");
    EXPECT_EQ(column(patch, "name"), (Cells{"a", "free", "b", "free", "free", "c"}));
    EXPECT_EQ(column(patch, "from"), (Cells{"1", "4", "7", "10", "1", "510"}));
    EXPECT_EQ(column(patch, "to"), (Cells{"3", "6", "9", "512", "509", "512"}));
    EXPECT_EQ(column(patch, "channels"), (Cells{"3", "3", "3", "503", "509", "3"}));
    EXPECT_TRUE(patch.rows[1].is_free);
    EXPECT_FALSE(patch.rows[0].is_free);
    const PaperTable universes = table(paper_of(show), "universes");
    EXPECT_EQ(column(universes, "universe"), (Cells{"1", "3"}));
    EXPECT_EQ(column(universes, "free"), (Cells{"506", "509"}));
    EXPECT_EQ(column(universes, "largest gap"), (Cells{"503", "509"}));
    EXPECT_EQ(column(universes, "counted"), (Cells{"whole", "whole"}));
}

TEST(Patch, says_what_is_shared_runs_on_or_is_not_known) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 3), hung("c", 1, 511), hung("d", 5, 1), hung("e", 1, 0)};
    show.fixtures[3].type = nullptr;
    show.fixtures[0].track = Track{{}, 2, 100};
    const PaperTable patch = table(paper_of(show), "patch");
    EXPECT_EQ(column(patch, "name"),
              (Cells{"a", "b", "free", "c", "c", "free", "a", "free", "d", "free at most"}));
    const Cells remarks = column(patch, "remarks");
    EXPECT_EQ(remarks[1], "shares channels with a");
    EXPECT_EQ(remarks[4], "goes on");
    EXPECT_EQ(remarks[6], "track");
    EXPECT_EQ(remarks[8], "how many channels is not known");
    EXPECT_EQ(column(patch, "to")[8], "");
    EXPECT_EQ(patch.unknown, (Cells{"Not patched: e."}));
    EXPECT_EQ(column(table(paper_of(show), "universes"), "counted"),
              (Cells{"whole", "whole", "free at most"}));
}

TEST(Patch, has_the_channels_of_machines_and_of_what_chooses_media) {
    Show show;
    show.fixtures = {hung("beamer", 1, 0), hung("wall", 1, 0)};
    show.fixtures[0].projector = Projector{.universe = 1, .address = 301};
    show.fixtures[1].wall = LedWall{.universe = 1, .address = 302};
    Mover truss{.name = "Front truss"};
    truss.axes.push_back({.name = "left", .levels = {{1, 186}, {1, 187}}});
    truss.axes.push_back({.name = "right", .levels = {{1, 188}, {1, 189}}});
    truss.axes.push_back({.name = "of a lamp", .levels = {{2, 1}}, .fixture = "beamer", .attribute = "Z"});
    show.movers = {truss};
    const PaperTable patch = table(paper_of(show), "patch");
    EXPECT_EQ(column(patch, "name"),
              (Cells{"free", "Front truss", "Front truss", "free", "beamer", "wall", "free"}));
    EXPECT_EQ(column(patch, "to"), (Cells{"185", "187", "189", "300", "301", "302", "512"}));
    const Cells remarks = column(patch, "remarks");
    EXPECT_EQ(remarks[1], "axis left");
    EXPECT_EQ(remarks[4], "chooses the medium");
    EXPECT_EQ(remarks[5], "chooses the medium");
    const PaperTable universes = table(paper_of(show), "universes");
    EXPECT_EQ(column(universes, "free"), (Cells{"506"}));
    EXPECT_EQ(column(universes, "fixtures"), (Cells{"2"})) << "machines are none";
}

TEST(Patch, is_not_certain_behind_a_fixture_of_unknown_length) {
    Show show;
    show.fixtures = {hung("missing", 1, 1), hung("known", 1, 30)};
    show.fixtures[0].type = nullptr;
    EXPECT_EQ(column(table(paper_of(show), "patch"), "name"),
              (Cells{"missing", "free at most", "known", "free at most"}));
}

TEST(Patch, has_no_channels_of_a_mode_that_nobody_names) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 30)};
    show.fixtures[0].is_mode_known = false;
    const PaperTable patch = table(paper_of(show), "patch");
    EXPECT_EQ(column(patch, "name"), (Cells{"a", "free at most", "b", "free at most"}));
    EXPECT_EQ(column(patch, "mode"), (Cells{"", "", "Standard", ""}));
    EXPECT_EQ(column(patch, "remarks")[0], "how many channels is not known");
}

TEST(Instruments, leave_empty_what_was_replaced_while_loading) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 30)};
    show.fixtures[0].is_mode_known = false;
    show.fixtures[1].is_place_known = false;
    const PaperTable schedule = table(paper_of(show), "instruments");
    EXPECT_EQ(column(schedule, "mode"), (Cells{"", "Standard"}));
    EXPECT_EQ(column(schedule, "channels"), (Cells{"", "3"}));
    EXPECT_EQ(column(schedule, "x m"), (Cells{"0", ""}));
    EXPECT_EQ(column(schedule, "z m"), (Cells{"0", ""}));
    ASSERT_GE(schedule.unknown.size(), 2u);
    EXPECT_EQ(schedule.unknown[0], "Nobody says a place that can be used of b.");
    EXPECT_TRUE(schedule.unknown[1].starts_with("Nobody names a mode that the type has of a:"));
    EXPECT_TRUE(table(paper_of(show, {.language = Language::german}), "instruments")
                    .unknown[0]
                    .starts_with("Niemand nennt einen brauchbaren Ort von b"));
}

TEST(Patch, is_free_at_most_where_an_address_cannot_be_read) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("odd", 1, 0), hung("none", 1, 0)};
    show.fixtures[1].is_address_known = false;
    const Paper paper = paper_of(show);
    const PaperTable patch = table(paper, "patch");
    EXPECT_EQ(column(patch, "name"), (Cells{"a", "free at most"}));
    EXPECT_EQ(patch.unknown,
              (Cells{"Not patched: none.",
                     "The address of odd cannot be read: less may be free, in any universe."}));
    EXPECT_EQ(table(paper, "universes").unknown.back(), patch.unknown.back());
    for (const char* const file : {"instruments", "hookup"}) {
        const PaperTable one = table(paper, file);
        const Cells names = column(one, "name"), addresses = column(one, "address");
        for (std::size_t k = 0; k < names.size(); ++k)
            EXPECT_EQ(addresses[k], names[k] == "a" ? "1.1" : names[k] == "odd" ? "" : "not patched");
        EXPECT_EQ(one.unknown[0], "The address of odd cannot be read.");
    }
    EXPECT_EQ(table(paper_of(show, {.language = Language::german}), "patch").unknown.back(),
              "Die Adresse von odd ist nicht lesbar: es kann weniger frei sein, in jedem Universum.");
}

TEST(Instruments, leave_out_breaks_that_their_mode_does_not_have) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 0), hung("c", 1, 4)};
    show.fixtures[0].more_addresses = {{1, 0}, {1, 0}};
    show.fixtures[2].more_addresses = {{1, 0}, {2, 5}};
    EXPECT_EQ(column(table(paper_of(show), "instruments"), "address"),
              (Cells{"1.1", "not patched", "1.4 + 2.5"}));
}

TEST(Instruments, without_unit_numbers_are_sorted_by_desk_number_then_name) {
    Show show;
    show.fixtures = {hung("z", 1, 1), hung("y", 1, 4), hung("x 10", 1, 7), hung("x 2", 1, 10)};
    show.fixtures[0].fixture_id = "1108";
    show.fixtures[1].fixture_id = "206";
    EXPECT_EQ(column(table(paper_of(show), "instruments"), "name"), (Cells{"y", "z", "x 2", "x 10"}));
}

TEST(Instruments, of_numbers_that_differ_by_zeros_are_not_mixed) {
    Show show;
    show.fixtures = {hung("c", 1, 1), hung("a", 1, 4), hung("d", 1, 7), hung("b", 1, 10)};
    const char* const numbers[] = {"1", "01", "01", "1"};
    for (std::size_t i = 0; i < 4; ++i) show.fixtures[i].fixture_id = numbers[i];
    EXPECT_EQ(column(table(paper_of(show), "instruments"), "name"), (Cells{"a", "d", "b", "c"}));
}

TEST(Instruments, have_no_filter_where_the_plot_has_white) {
    Show show;
    auto loaded = load_description(small_xml(""));
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    show.plot = std::make_shared<LoadedPlot>(std::move(*loaded));
    for (int i = 0; i < 2; ++i) {
        PlotObject& object = show.plot->plot.objects.emplace_back();
        object.uuid = uuid(i);
        object.device.color =
            i == 0 ? fixture::ColorCie{0.3127f, 0.3290f, 100} : fixture::ColorCie{0.64f, 0.33f, 21};
        show.fixtures.push_back(hung("Spot " + std::to_string(i), 1, 1 + 3 * i));
        show.fixtures.back().uuid = uuid(i);
    }
    const Cells filters = column(table(paper_of(show), "instruments"), "filter");
    ASSERT_EQ(filters.size(), 2u);
    EXPECT_EQ(filters[0], "");
    EXPECT_TRUE(filters[1].starts_with("#ff0")) << filters[1];
}

TEST(Instruments, name_what_the_plot_says) {
    Show show;
    auto loaded = load_description(small_xml(""));
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    show.plot = std::make_shared<LoadedPlot>(std::move(*loaded));
    Plot& plot = show.plot->plot;
    plot.positions = {{"p1", "Truss 10", 0}, {"p2", "Truss 2", 0}};
    for (int i = 0; i < 3; ++i) {
        PlotObject& object = plot.objects.emplace_back();
        object.uuid = uuid(i);
        object.device.position = i == 2 ? 1 : 0;
        object.device.unit_number = 10 - i;
        show.fixtures.push_back(hung("Spot " + std::to_string(i), 1, 1 + 3 * i));
        show.fixtures.back().uuid = "{" + uuid(i) + "}";
        show.fixtures.back().fixture_id = std::to_string(101 + i);
    }
    show.fixtures.push_back(hung("lonely", 1, 100));
    const PaperTable instruments = table(paper_of(show), "instruments");
    EXPECT_EQ(column(instruments, "name"), (Cells{"Spot 2", "Spot 1", "Spot 0", "lonely"}));
    EXPECT_EQ(column(instruments, "hangs on"), (Cells{"Truss 2", "Truss 10", "Truss 10", ""}));
    EXPECT_EQ(column(instruments, "channels"), (Cells{"3", "3", "3", "3"}));
    EXPECT_EQ(instruments.unknown, (Cells{"What they hang on: 1 fixture does not say it."}));
    EXPECT_EQ(column(table(paper_of(show), "hookup"), "number"), (Cells{"101", "102", "103", ""}));
}

TEST(Instruments, of_a_file_that_is_not_read_are_as_the_plot_writes_them) {
    Show show;
    show.plot = std::make_shared<LoadedPlot>(must(load_description(small_xml(""))));
    PlotObject& object = show.plot->plot.objects.emplace_back();
    object.uuid = uuid(1);
    object.device.gdtf_spec = "Robe Lighting@Robin Esprite.gdtf";
    object.device.gdtf_mode = "Mode 1 - Standard 16 bit";
    show.fixtures = {hung("Esprite", 1, 1), hung("of a show file", 1, 100)};
    for (PatchedFixture& fixture : show.fixtures) fixture.type = nullptr;
    show.fixtures[0].uuid = uuid(1);
    show.fixtures[1].gdtf = "../fixtures/Maker@Wash.GDTF";
    const Paper paper = paper_of(show);
    for (const char* const name : {"instruments", "hookup", "patch", "types"}) {
        const PaperTable& one = table(paper, name);
        Cells types = column(one, "type"), modes = column(one, "mode");
        std::erase(types, "");
        std::erase(modes, "");
        std::sort(types.begin(), types.end());
        EXPECT_EQ(types, (Cells{"Maker@Wash", "Robe Lighting@Robin Esprite"})) << name;
        EXPECT_EQ(modes, (Cells{"Mode 1 - Standard 16 bit"})) << name;
    }
    EXPECT_TRUE(table(paper, "instruments")
                    .unknown.back()
                    .starts_with("The file of the type could not be read of 2: type and mode are as"));
}

TEST(Instruments, that_hang_nowhere_are_sorted_by_layer) {
    Show show;
    auto loaded = load_description(small_xml(""));
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    show.plot = std::make_shared<LoadedPlot>(std::move(*loaded));
    Plot& plot = show.plot->plot;
    plot.layers.resize(2);
    plot.layers[0].name = "Truss";
    plot.layers[1].name = "Floor";
    for (int i = 0; i < 4; ++i) {
        PlotObject& object = plot.objects.emplace_back();
        object.uuid = uuid(i);
        object.layer = i % 2;
        object.device.unit_number = 4 - i;
        show.fixtures.push_back(hung("Spot " + std::to_string(i), 1, 1 + 3 * i));
        show.fixtures.back().uuid = uuid(i);
    }
    const PaperTable instruments = table(paper_of(show), "instruments");
    EXPECT_EQ(column(instruments, "name"), (Cells{"Spot 3", "Spot 1", "Spot 2", "Spot 0"}));
    EXPECT_EQ(column(instruments, "layer"), (Cells{"Floor", "Floor", "Truss", "Truss"}));
}

TEST(Types, add_up_what_is_known_and_nothing_else) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 4)};
    const PaperTable unsaid = table(paper_of(show), "types");
    EXPECT_EQ(unsaid.unknown.at(0), "Weight: no fixture file says it.");
    EXPECT_TRUE(column(unsaid, "kg all").at(0).empty());
    const auto heavy = three_channel_spot(R"(<Weight Value="12.5"/><PowerConsumption Value="800"/>)");
    for (PatchedFixture& fixture : show.fixtures) fixture.type = heavy;
    show.fixtures.push_back(hung("c", 1, 7));
    show.fixtures[2].type = nullptr;
    const PaperTable types = table(paper_of(show), "types");
    EXPECT_EQ(column(types, "fixtures"), (Cells{"1", "2"}));
    if (heavy->properties.weight_kg > 0) {
        EXPECT_EQ(column(types, "kg all").at(1), "25");
        EXPECT_EQ(types.unknown.at(0), "Weight of the fixtures: 25 kg, without those that do not say it: 1.");
    }
    EXPECT_GT(heavy->properties.weight_kg, 0);
}

TEST(Types, of_two_files_with_equal_names_are_two) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 4), hung("c", 1, 7)};
    show.fixtures[0].type = three_channel_spot(R"(<Weight Value="22.5"/>)");
    show.fixtures[1].type = three_channel_spot(R"(<Weight Value="40"/>)");
    show.fixtures[2].type = three_channel_spot(R"(<Weight Value="40"/>)"); // a copy
    const PaperTable types = table(paper_of(show), "types");
    EXPECT_EQ(column(types, "kg all"), (Cells{"22.5", "80"}));
    EXPECT_EQ(types.unknown.at(0), "Rows of one name are of fixture files that say different things.");
    EXPECT_EQ(types.unknown.at(1), "Weight of the fixtures: 102.5 kg.");
}

TEST(Wheels, of_two_files_with_equal_names_are_all_there) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 4), hung("c", 1, 7)};
    const auto other = std::make_shared<fixture::Type>(*show.fixtures[0].type);
    other->wheels.at(0).slots.at(1).name = "Rose";
    show.fixtures[1].type = other;
    show.fixtures[2].type = std::make_shared<fixture::Type>(*show.fixtures[0].type); // a copy
    const PaperTable wheels = table(paper_of(show), "gobos_colours");
    EXPECT_EQ(column(wheels, "name"), (Cells{"Open", "Red", "Open", "Rose"}));
    EXPECT_EQ(column(wheels, "fixtures"), (Cells{"2", "2", "1", "1"}));
    EXPECT_EQ(wheels.unknown.size(), 1u);
}

TEST(Columns, of_numbers_and_codes_keep_their_width) {
    const std::vector<PaperColumn> columns{{"name"}, {"x", true}, {"address", false, true}, {"type"}};
    EXPECT_EQ(shared_widths(columns, {100, 30, 40, 50}, 220, 20), (std::vector<double>{100, 30, 40, 50}));
    EXPECT_EQ(shared_widths(columns, {100, 30, 40, 50}, 180, 20), (std::vector<double>{60, 30, 40, 50}));
    EXPECT_EQ(shared_widths(columns, {100, 30, 40, 50}, 150, 20), (std::vector<double>{40, 30, 40, 40}));
    EXPECT_EQ(shared_widths(columns, {100, 30, 40, 50}, 55, 20), (std::vector<double>{10, 15, 20, 10}))
        << "no text left to cut";
}

TEST(Columns, are_as_wide_as_their_longest_cell_wherever_it_stands) {
    PaperTable one{"x", "X", {{"address"}}, {}, {}};
    for (int i = 0; i < 2000; ++i) one.rows.push_back({{i == 777 ? "60000.480" : "1.1"}});
    const auto cells = longest_cells(one, 0, 400);
    EXPECT_EQ(cells.size(), 400u);
    EXPECT_TRUE(std::any_of(cells.begin(), cells.end(),
                            [](const std::string* cell) { return *cell == "60000.480"; }));
}

TEST(Wheels, have_their_slots) {
    Show show;
    show.fixtures = {hung("a", 1, 1), hung("b", 1, 4)};
    const PaperTable wheels = table(paper_of(show), "gobos_colours");
    EXPECT_EQ(column(wheels, "name"), (Cells{"Open", "Red"}));
    EXPECT_EQ(column(wheels, "kind"), (Cells{"colour", "colour"}));
    EXPECT_EQ(column(wheels, "fixtures"), (Cells{"2", "2"}));
    EXPECT_EQ(column(wheels, "colour").at(0), "open");
    EXPECT_TRUE(column(wheels, "colour").at(1).starts_with("#ff0")) << column(wheels, "colour").at(1);
}

TEST(Wheels, of_gobos_have_a_colour_only_where_their_slot_has_one) {
    Show show;
    show.fixtures = {hung("a", 1, 1)};
    const auto gobos = std::make_shared<fixture::Type>(*show.fixtures[0].type);
    for (fixture::Channel& channel : gobos->modes.at(0).channels)
        for (fixture::ChannelFunction& function : channel.functions)
            if (function.wheel >= 0) function.meaning.role = fixture::Role::gobo_wheel;
    fixture::Slot leaves{.name = "Leaves", .media_file = "leaves"};
    gobos->wheels.at(0).slots.push_back(leaves);
    show.fixtures[0].type = gobos;
    const PaperTable wheels = table(paper_of(show), "gobos_colours");
    EXPECT_EQ(column(wheels, "kind").at(2), "gobo");
    EXPECT_EQ(column(wheels, "picture").at(2), "leaves");
    EXPECT_EQ(column(wheels, "colour").at(0), "open");
    EXPECT_TRUE(column(wheels, "colour").at(1).starts_with("#ff0")) << "a coloured gobo";
    EXPECT_EQ(column(wheels, "colour").at(2), "");
}

TEST(Tables, have_codes_that_no_line_of_a_page_breaks) {
    Show show;
    show.fixtures = {hung("a", 61, 106)};
    const std::string page = html_of(paper_of(show), PaperSize::a4);
    EXPECT_NE(page.find("<td class=\"w\"><bdi>61.106</bdi></td>"), std::string::npos);
    EXPECT_NE(page.find("@page{size:A4 landscape"), std::string::npos);
    for (int i = 2; i < 30; ++i) show.fixtures[0].more_addresses.push_back({61, i});
    const std::string many = html_of(paper_of(show), PaperSize::a4);
    EXPECT_NE(many.find("<td><bdi>61.106 + 61.2 + "), std::string::npos) << "too long for one line";
}

TEST(Tables, of_a_show_without_fixtures_are_made) {
    const Paper paper = paper_of(Show{});
    EXPECT_EQ(paper.tables.size(), 7u);
    for (const PaperTable& one : paper.tables) {
        EXPECT_TRUE(csv_of(one).ends_with("\r\n")) << one.file;
        EXPECT_EQ(one.unknown.at(0), "The show has no fixtures.") << one.file;
    }
    EXPECT_NE(html_of(paper, PaperSize::letter).find("nothing"), std::string::npos);
}

TEST(Csv, quotes_and_lets_no_name_be_a_formula) {
    const PaperTable one{
        "x", "X", {{"name"}, {"z, m", true}}, {{{"=1+1", "-2.5"}}, {{"a \"b\"\n", ""}}, {{"@x,y", "1"}}}, {}};
    EXPECT_EQ(csv_of(one),
              "\xef\xbb\xbfname,\"z, m\"\r\n'=1+1,-2.5\r\n\"a \"\"b\"\"\\u000a\",\r\n\"'@x,y\",1\r\n");
}

TEST(Page, of_tables_escapes_and_marks_what_is_free) {
    const Paper paper{"<b>", {{"x", "X", {{"name"}}, {{{"<i>"}, true}}, {"nobody knows"}}}, {}};
    const std::string page = html_of(paper, PaperSize::a4);
    EXPECT_EQ(page.find("<i>"), std::string::npos);
    EXPECT_EQ(page.find("<b>"), std::string::npos);
    EXPECT_NE(page.find("<tr class=\"free\"><td><bdi>&lt;i&gt;</bdi></td></tr>"), std::string::npos);
    EXPECT_NE(page.find("nobody knows"), std::string::npos);
    EXPECT_NE(page.find("size:A4"), std::string::npos);
}

} // namespace
} // namespace ghost::scene
