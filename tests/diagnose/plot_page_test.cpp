// SPDX-License-Identifier: Apache-2.0
// The page of a plot: what was found, missing and guessed in groups, fixture files without light with what
// could stand in, for a show that is made here.
#include "diagnose/plot_page.h"
#include "show/show.h"
#include "support/mvr_files.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

std::shared_ptr<const fixture::Type> type_of(const std::string& name, std::vector<int> lengths) {
    auto type = std::make_shared<fixture::Type>();
    type->name = name;
    for (const int length : lengths) {
        type->modes.emplace_back();
        type->modes.back().name = "M" + std::to_string(length);
        type->modes.back().footprint = {length};
        type->modes.back().beams = {0};
        type->modes.back().nodes.emplace_back().geometry = 0;
    }
    type->geometries.emplace_back();
    type->geometries.back().beam.emplace();
    return type;
}

// A plot of three spots whose file is missing and one wash, which is there.
struct Plot {
    Plot() {
        show.file = show.plot_file = "tour.mvr";
        show.plot = std::make_shared<LoadedPlot>(must(load_description(small_xml(""))));
        show.plot->plot.gdtf_files = {{"Test@Super Spot 300.gdtf", "", 3},
                                      {"Test@Wash.gdtf", "wash.gdtf", 1}};
        for (int i = 0; i < 4; ++i) {
            PlotObject object;
            object.kind = ObjectKind::fixture;
            object.uuid = "u" + std::to_string(i);
            object.device.gdtf = i < 3 ? 0 : 1;
            object.device.gdtf_spec = show.plot->plot.gdtf_files[i < 3 ? 0 : 1].spec;
            show.plot->plot.objects.push_back(object);
            PatchedFixture fixture;
            fixture.name = "Head " + std::to_string(i + 1);
            fixture.uuid = object.uuid;
            fixture.gdtf = object.device.gdtf_spec;
            fixture.address = i < 3 ? 1 + 8 * i : 0;
            if (i == 3) fixture.type = type_of("Wash", {10});
            show.fixtures.push_back(fixture);
        }
        offers.files = {"lib/Test@Super_Spot_300_rev2.gdtf", "lib/Vari-Lite@VL2500_Spot.gdtf",
                        "lib/Ghostlight@LED_Par.gdtf"};
        for (const auto& file : offers.files) offers.names.push_back(file.filename().string());
        offers.load = [](std::size_t k) {
            return k == 0 ? type_of("Spot", {8, 20}) : type_of("Other", {22});
        };
    }
    Show show;
    FixtureOffers offers;
};

TEST(PlotPage, a_missing_file_has_its_heads_the_likest_other_one_and_lamps_of_its_kind) {
    const Plot plot;
    const PlotPage page = plot_page(plot.show, {}, plot.offers);
    ASSERT_EQ(page.lightless.size(), 1u);
    const LightlessType& spot = page.lightless.front();
    EXPECT_EQ(spot.wanted, "Test@Super Spot 300.gdtf");
    EXPECT_EQ(spot.why, "is not in the plot");
    EXPECT_EQ(spot.fixtures, (std::vector<std::size_t>{0, 1, 2}));
    ASSERT_EQ(spot.stand_ins.size(), 3u);
    EXPECT_EQ(spot.stand_ins[0].label, "Test@Super_Spot_300_rev2.gdtf (8 ch)");
    EXPECT_EQ(spot.stand_ins[0].mode, "M8") << "that of the patch";
    EXPECT_TRUE(spot.stand_ins[0].seems_same);
    EXPECT_EQ(spot.stand_ins[1].label, "VL2500 Spot (22 ch)") << "it is called a spot, too";
    EXPECT_EQ(spot.stand_ins[2].label, "LED par (22 ch)");
    EXPECT_TRUE(page.matters());
    EXPECT_EQ(page.found.front().words, "4 fixtures of 2 types, patched in 1 universe");
}

TEST(PlotPage, a_wash_that_makes_beams_too_is_a_wash) {
    Plot plot;
    plot.show.plot->plot.gdtf_files[0].spec = "Test@MMX WashBeam.gdtf";
    for (int i = 0; i < 3; ++i) {
        plot.show.plot->plot.objects[static_cast<std::size_t>(i)].device.gdtf_spec = "Test@MMX WashBeam.gdtf";
        plot.show.fixtures[static_cast<std::size_t>(i)].gdtf = "Test@MMX WashBeam.gdtf";
    }
    plot.offers.files = {"lib/Vari-Lite@VL2500_Spot.gdtf", "lib/Vari-Lite@VL2500_Wash.gdtf"};
    plot.offers.names.clear(); // no likeness of names
    plot.offers.load = [](std::size_t) { return type_of("Other", {22}); };
    const PlotPage page = plot_page(plot.show, {}, plot.offers);
    ASSERT_EQ(page.lightless.size(), 1u);
    ASSERT_EQ(page.lightless.front().stand_ins.size(), 2u);
    EXPECT_EQ(page.lightless.front().stand_ins[0].label, "VL2500 Wash (22 ch)");
}

TEST(PlotPage, names_are_cut_between_letters_and_none_is_no_name) {
    Plot plot;
    plot.show.fixtures[3].type = type_of(std::string(99, 'x') + "\xc3\xa4", {10});
    plot.show.fixtures[0].name = "";
    PlotPage page = plot_page(plot.show,
                              {{.severity = Severity::warning,
                                .kind = "missing_link",
                                .where = "tour.mvr",
                                .what = "'' leads nowhere"}},
                              plot.offers);
    EXPECT_TRUE(std::any_of(page.found.begin(), page.found.end(),
                            [](const PageLine& line) { return line.words == "1 " + std::string(99, 'x'); }));
    ASSERT_EQ(page.groups.size(), 1u);
    EXPECT_TRUE(page.groups[0].fixtures.empty());
}

TEST(PlotPage, findings_are_grouped_by_kind_and_name_their_fixtures) {
    const Plot plot;
    const std::vector<Finding> findings{{Severity::warning, "unpatched",
                                         "tour.mvr: x.xml:3: Fixture 'Head 4'", "1 fixture has no address",
                                         "patch it"},
                                        {Severity::note, "guessed_value", "tour.mvr", "it gets 'a'", ""},
                                        {Severity::error, "missing_media", "tour.mvr", "no mesh 'b'", "", 2},
                                        {Severity::error, "missing_media", "tour.mvr", "no mesh 'c'", ""}};
    const PlotPage page = plot_page(plot.show, findings, plot.offers);
    ASSERT_EQ(page.groups.size(), 3u);
    EXPECT_EQ(page.groups[0].title, "Pictures and models that are missing");
    EXPECT_EQ(page.groups[0].times, 3);
    EXPECT_EQ(page.groups[0].lines.size(), 2u);
    EXPECT_EQ(page.groups[1].kind, "unpatched");
    EXPECT_EQ(page.groups[1].fixtures, (std::vector<std::size_t>{3}));
    EXPECT_EQ(page.count(Severity::error), 3);
    const std::string text = text_of(page);
    EXPECT_NE(text.find("3 heads: 'Test@Super Spot 300.gdtf' is not in the plot"), std::string::npos) << text;
    EXPECT_NE(text.find("Fixtures without an address: 1\n    Fixture 'Head 4': 1 fixture has no address\n"
                        "      do: patch it"),
              std::string::npos)
        << text;
}

TEST(PlotPage, what_is_only_odd_does_not_matter) {
    Plot plot;
    plot.show.fixtures.erase(plot.show.fixtures.begin(), plot.show.fixtures.begin() + 3);
    const std::vector<Finding> odd{{Severity::note, "not_used", "tour.mvr", "x", ""},
                                   {Severity::warning, "guessed_value", "tour.mvr", "y", ""}};
    const PlotPage page = plot_page(plot.show, odd, plot.offers);
    EXPECT_TRUE(page.lightless.empty());
    EXPECT_FALSE(page.matters());
    EXPECT_TRUE(
        plot_page(plot.show, {{Severity::error, "missing_file", "a", "b", ""}}, plot.offers).matters());
}

TEST(PlotPage, a_group_has_two_hundred_lines_and_counts_the_others) {
    const Plot plot;
    for (const std::size_t count : {kMostPageLines, kMostPageLines + 1}) {
        std::vector<Finding> findings;
        for (std::size_t k = 0; k < count; ++k)
            findings.push_back(
                {Severity::error, "missing_media", "tour.mvr", "no mesh " + std::to_string(k), ""});
        const PlotPage page = plot_page(plot.show, findings, plot.offers);
        ASSERT_EQ(page.groups.size(), 1u);
        EXPECT_EQ(page.groups[0].lines.size(), kMostPageLines);
        EXPECT_EQ(page.groups[0].lines.back().words, "no mesh 199");
        EXPECT_EQ(page.groups[0].times, static_cast<int>(count));
    }
}

TEST(PlotPage, fifty_files_without_light_have_a_stand_in_and_all_are_listed) {
    Plot plot;
    plot.show.plot->plot.gdtf_files.clear();
    plot.show.plot->plot.objects.clear();
    plot.show.fixtures.clear();
    for (int k = 0; k < 51; ++k) {
        PlotObject object;
        object.kind = ObjectKind::fixture;
        object.uuid = "u" + std::to_string(k);
        object.device.gdtf = k;
        plot.show.plot->plot.objects.push_back(object);
        plot.show.plot->plot.gdtf_files.push_back({"Lost " + std::to_string(k) + ".gdtf", "", 1});
        PatchedFixture& fixture = plot.show.fixtures.emplace_back();
        fixture.uuid = object.uuid;
    }
    const PlotPage page = plot_page(plot.show, {}, plot.offers);
    ASSERT_EQ(page.lightless.size(), 51u);
    EXPECT_FALSE(page.lightless[49].stand_ins.empty());
    EXPECT_TRUE(page.lightless[50].stand_ins.empty());
}

} // namespace
} // namespace ghost::scene
