// SPDX-License-Identifier: Apache-2.0
// Weight and power by position, and the proposal of phases: sums of what is known, and who is left out.
#include "book/paper.h"

#include "show/show.h"
#include "support/mvr_files.h"
#include "support/tiny_gdtf.h"

#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace ghost::scene {
namespace {

std::shared_ptr<const fixture::Type> type_of_power(int watts) {
    fixture::Description description;
    description.physical = "<Properties><Weight Value=\"10\"/><PowerConsumption Value=\"" +
                           std::to_string(watts) + "\"/></Properties>";
    return std::make_shared<const fixture::Type>(fixture::loaded(description).type);
}

// Six fixtures of 1,000 W on two positions, and one that says nothing.
Show rig() {
    Show show;
    show.plot = std::make_shared<LoadedPlot>(must(load_description(small_xml(""))));
    Plot& plot = show.plot->plot;
    plot.positions = {{"p1", "Truss 1", 0}, {"p2", "Truss 2", 0}};
    const auto type = type_of_power(1000);
    for (int i = 0; i < 7; ++i) {
        PlotObject& object = plot.objects.emplace_back();
        object.uuid = uuid(i);
        object.name = "Spot " + std::to_string(i + 1);
        object.device.position = i < 4 ? 0 : 1;
        object.device.unit_number = i + 1;
        PatchedFixture& fixture = show.fixtures.emplace_back();
        fixture.name = object.name;
        fixture.uuid = uuid(i);
        if (i < 6) fixture.type = type;
    }
    return show;
}

const PaperTable& table_named(const Paper& paper, std::string_view file) {
    for (const PaperTable& one : paper.tables)
        if (one.file == file) return one;
    throw std::runtime_error("no table " + std::string(file));
}

using Row = std::vector<std::string>;

TEST(HangingPositions, add_up_what_is_known_and_count_what_is_not) {
    const Paper paper = paper_of(rig());
    const PaperTable& positions = table_named(paper, "positions");
    ASSERT_EQ(positions.rows.size(), 2u);
    EXPECT_EQ(positions.rows[0].cells, (Row{"Truss 1", "4", "40", "", "4000", ""}));
    EXPECT_EQ(positions.rows[1].cells, (Row{"Truss 2", "3", "20", "1", "2000", "1"}));
    const Paper pounds = paper_of(rig(), {Language::german, Units::imperial});
    EXPECT_EQ(table_named(pounds, "positions").rows[0].cells[2], "88,2");
    EXPECT_EQ(table_named(pounds, "positions").columns[0].title, "hängt an");
}

TEST(Phases, are_a_proposal_of_circuits_that_hold) {
    const Paper paper = paper_of(rig(), {}, 2000);
    const PaperTable& phases = table_named(paper, "phases_proposal");
    EXPECT_TRUE(phases.unknown.at(0).starts_with("A PROPOSAL"));
    ASSERT_EQ(phases.rows.size(), 3u); // two on a circuit, none over two positions
    EXPECT_EQ(phases.rows[0].cells, (Row{"L1", "1", "Truss 1", "Spot 1-2", "2", "2000"}));
    EXPECT_EQ(phases.rows[2].cells, (Row{"L3", "1", "Truss 2", "Spot 5-6", "2", "2000"}));
    EXPECT_NE(phases.unknown.at(1).find("in the order of the instrument schedule"), std::string::npos);
    EXPECT_EQ(phases.unknown.at(2), "Phase L1: 2000 W.");
    EXPECT_EQ(phases.unknown.back(), "Not in it, for nobody says their power: Spot 7.");
    const Paper small = paper_of(rig(), {}, 500);
    EXPECT_EQ(table_named(small, "phases_proposal").unknown.back(), "Above 500 W by itself: Spot 1-6.");
}

TEST(Phases, without_watts_are_of_usual_circuits) {
    const Paper metric = paper_of(rig());
    const PaperTable& phases = table_named(metric, "phases_proposal");
    EXPECT_TRUE(phases.unknown.at(1).starts_with("Circuits of at most 3680 W"));
    EXPECT_TRUE(phases.unknown.at(2).starts_with("16 A at 230 V")) << phases.unknown.at(2);
    const Paper feet = paper_of(rig(), {Language::english, Units::imperial});
    const PaperTable& imperial = table_named(feet, "phases_proposal");
    EXPECT_TRUE(imperial.unknown.at(1).starts_with("Circuits of at most 2400 W"));
    EXPECT_TRUE(imperial.unknown.at(2).starts_with("20 A at 120 V")) << imperial.unknown.at(2);
    for (const PaperRow& row : imperial.rows) EXPECT_LE(std::stod(row.cells.back()), 2400);
    const Paper asked = paper_of(rig(), {Language::english, Units::imperial}, 3680);
    EXPECT_TRUE(
        table_named(asked, "phases_proposal").unknown.at(1).starts_with("Circuits of at most 3680 W"));
    EXPECT_TRUE(table_named(asked, "phases_proposal").unknown.at(2).starts_with("Phase L1"));
}

TEST(Phases, are_not_there_where_nobody_says_a_power) {
    Show show = rig();
    for (PatchedFixture& fixture : show.fixtures) fixture.type = nullptr;
    for (const PaperTable& one : paper_of(show).tables) EXPECT_NE(one.file, "phases_proposal");
}

// With a plug of 230 V and a power factor.
std::shared_ptr<const fixture::Type> type_with_plug(int watts) {
    fixture::Description description;
    description.physical = "<Connectors><Connector Name=\"In\" Type=\"NAC3FCA\"/></Connectors><Properties>"
                           "<PowerConsumption Connector=\"In\" PowerFactor=\"0.5\" VoltageLow=\"100\" "
                           "VoltageHigh=\"240\" Value=\"" +
                           std::to_string(watts) + "\"/></Properties>";
    return std::make_shared<const fixture::Type>(fixture::loaded(description).type);
}

TEST(Circuits, add_up_what_the_show_plugs_into_them) {
    Show show = rig();
    show.fixtures[3].type = type_with_plug(230);
    show.circuits = {{"A", "L1", 16, 230}, {"B", "L2", 10, 230}, {"spare", "L3", 16, 230}};
    for (const int i : {0, 1, 3}) show.fixtures[static_cast<std::size_t>(i)].circuit = "A";
    show.fixtures[2].circuit = show.fixtures[4].circuit = show.fixtures[5].circuit = "B";
    show.fixtures[6].circuit = "dimmer 12"; // of which nothing is said, nor of its power
    const Paper paper = paper_of(show);
    const PaperTable& circuits = table_named(paper, "circuits");
    ASSERT_EQ(circuits.rows.size(), 4u);
    EXPECT_EQ(circuits.rows[0].cells,
              (Row{"A", "L1", "3", "Spot 1-2, Spot 4", "2230", "", "230", "10.7", "16"}))
        << "230 W at a factor of 0.5 take 2 A";
    EXPECT_EQ(circuits.rows[1].cells,
              (Row{"B", "L2", "3", "Spot 3, Spot 5-6", "3000", "", "230", "13", "10"}));
    EXPECT_EQ(circuits.rows[2].cells, (Row{"spare", "L3", "0", "", "", "", "230", "", "16"}));
    EXPECT_EQ(circuits.rows[3].cells, (Row{"dimmer 12", "", "1", "Spot 7", "", "1", "", "", ""}));
    EXPECT_EQ(circuits.unknown.at(0), "ABOVE ITS BREAKER: circuit B (13 A of 10 A).");
    EXPECT_NE(circuits.unknown.back().find("the file of 5 says no power factor"), std::string::npos);
    const PaperTable& phases = table_named(paper, "phases");
    EXPECT_EQ(phases.rows.at(0).cells, (Row{"L1", "1", "3", "2230", "", "10.7"}));
    EXPECT_EQ(phases.rows.at(3).cells, (Row{"nobody says", "1", "1", "", "1", ""}));
    for (const PaperTable& one : paper.tables) EXPECT_NE(one.file, "phases_proposal");
    EXPECT_EQ(table_named(paper, "plugs").rows.at(1).cells, (Row{"NAC3FCA", "In", "100-240", "1", "230"}));
    show.fixtures[6].circuit.clear();
    show.circuits[0].voltage_v = 0;
    const Paper less = paper_of(show);
    EXPECT_EQ(table_named(less, "circuits").unknown.back(), "On no circuit: Spot 7.");
    EXPECT_EQ(table_named(less, "circuits").unknown.at(1),
              "Amperes are not known of circuits without a voltage: A.");
    EXPECT_EQ(table_named(less, "phases").rows.at(0).cells.back(), "") << "not half a sum";
}

TEST(Plugs, have_no_name_that_only_a_mode_says_which_nobody_names) {
    Show show = rig();
    auto type = std::make_shared<fixture::Type>(*type_with_plug(230));
    fixture::Type& two = *type;
    const auto of_first = static_cast<std::size_t>(two.modes.front().nodes.front().geometry);
    two.geometries[of_first].power_input = two.properties.power_inputs.front();
    two.geometries.push_back(two.geometries[of_first]);
    two.geometries.back().power_input->plug = "In 8 bit";
    two.modes.push_back(two.modes.front());
    two.modes.back().nodes.front().geometry = static_cast<int>(two.geometries.size()) - 1;
    two.properties.power_inputs.clear();
    show.fixtures.resize(1);
    show.fixtures[0].type = type;
    EXPECT_EQ(table_named(paper_of(show), "plugs").rows.at(0).cells,
              (Row{"NAC3FCA", "In", "100-240", "1", "230"}));
    show.fixtures[0].is_mode_known = false;
    EXPECT_EQ(table_named(paper_of(show), "plugs").rows.at(0).cells, (Row{"NAC3FCA", "100-240", "1", "230"}));
}

TEST(Circuits, name_all_that_is_on_them) {
    Show show;
    for (int i = 0; i < 30; ++i) {
        PatchedFixture& fixture = show.fixtures.emplace_back();
        fixture.name = "Spot " + std::to_string(100 - 3 * i); // none counts on
        if (i < 15) fixture.circuit = "A";
    }
    const Paper paper = paper_of(show);
    const PaperTable& circuits = table_named(paper, "circuits");
    EXPECT_TRUE(circuits.rows.at(0).cells.at(2).ends_with("Spot 58")) << circuits.rows[0].cells[2];
    EXPECT_TRUE(circuits.unknown.back().ends_with("Spot 13.")) << circuits.unknown.back();
}

TEST(Cables, are_those_of_the_plot) {
    Show show = rig();
    PlotConnection cable;
    cable.own = "Power";
    cable.other = "Out 1";
    cable.to_object = 1;
    show.plot->plot.objects[0].device.connections = {cable};
    const Paper paper = paper_of(show);
    const PaperTable& cables = table_named(paper, "cables");
    EXPECT_EQ(cables.rows.at(0).cells, (Row{"Spot 1", "Power", "Spot 2", "Out 1"}));
}

} // namespace
} // namespace ghost::scene
