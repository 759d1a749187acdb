// SPDX-License-Identifier: Apache-2.0
#include "mvr/mvr_merge.h"
#include "support/mvr_files.h"

namespace ghost::scene {
namespace {

std::string matrix(double x, double y, double z) {
    return "<Matrix>{1,0,0}{0,1,0}{0,0,1}{" + std::to_string(x) + "," + std::to_string(y) + "," +
           std::to_string(z) + "}</Matrix>";
}

std::string spot(const std::string& uuid, const std::string& name, const std::string& place,
                 const std::string& address, const std::string& mode = "Standard") {
    return "<Fixture uuid='" + uuid + "' name='" + name + "'>" + place +
           "<GDTFSpec>Spot.gdtf</GDTFSpec><GDTFMode>" + mode + "</GDTFMode><Addresses><Address break='0'>" +
           address + "</Address></Addresses></Fixture>";
}

Plot plot_of(const std::string& objects) {
    auto loaded = load_description(small_xml(objects), {{"Spot.gdtf", ""}});
    if (!loaded.ok()) throw std::runtime_error(loaded.error().text());
    return std::move(loaded->plot);
}

std::string truss(const std::string& place, const std::string& children) {
    return "<Truss uuid='T' name='LX1'>" + place + "<Geometries/><ChildList>" + children +
           "</ChildList></Truss>";
}

std::vector<std::string> names(const std::vector<MergeEntry>& entries) {
    std::vector<std::string> result;
    for (const MergeEntry& entry : entries)
        result.push_back(entry.name + (entry.what.empty() ? "" : ": " + entry.what));
    return result;
}

using Strings = std::vector<std::string>;

TEST(mvr_merge, what_the_designer_changed) {
    const Plot before = plot_of(truss(matrix(0, 0, 6000), spot("A", "one", matrix(0, 0, 0), "1") +
                                                              spot("B", "two", matrix(1000, 0, 0), "50") +
                                                              spot("C", "three", matrix(2000, 0, 0), "100")) +
                                spot("D", "floor", matrix(0, 0, 0), "200"));
    // The truss goes up half a metre; "two" goes, "four" comes, "three" has another address, mode and name.
    const Plot after =
        plot_of(truss(matrix(0, 0, 6500), spot("a", "one", matrix(0, 0, 0), "1") +
                                              spot("C", "drei", matrix(2000, 0, 0), "2.1", "Wide") +
                                              spot("E", "four", matrix(3000, 0, 0), "150")) +
                spot("D", "floor", matrix(0, 0, 0), "200"));
    const MergedPlot merged = merge_plots(before, after, {});
    EXPECT_EQ(names(merged.report.added), Strings{"four"});
    EXPECT_EQ(names(merged.report.removed), Strings{"two"});
    EXPECT_EQ(names(merged.report.moved),
              (Strings{"LX1: moved 0.500 m", "one: moved 0.500 m", "drei: moved 0.500 m"}));
    EXPECT_EQ(names(merged.report.repatched), Strings{"drei: address 1.100 is now 2.1"});
    EXPECT_EQ(names(merged.report.changed),
              Strings{"drei: name 'three' is now 'drei', mode 'Standard' is now 'Wide'"});
    EXPECT_EQ(merged.report.unchanged, 1u);
    EXPECT_FALSE(merged.report.unrelated);
    EXPECT_EQ(merged.plot.objects.size(), after.objects.size());
    const std::string text = text_of(merged.report);
    EXPECT_NE(text.find("1 added, 1 removed, 3 moved, 1 re-patched, 1 changed, 1 as before"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("added: fixture 'four'"), std::string::npos) << text;
    EXPECT_NE(text.find("E)\n"), std::string::npos) << "its UUID, for names come again: " << text;
}

TEST(mvr_merge, the_users_changes_outlive_the_new_plot) {
    const Plot before = plot_of(truss(matrix(0, 0, 6000), spot("A", "one", matrix(0, 0, 0), "1") +
                                                              spot("B", "two", matrix(1000, 0, 0), "50") +
                                                              spot("C", "three", matrix(2000, 0, 0), "100")));
    const Plot after = plot_of(truss(matrix(0, 0, 7000), spot("A", "one", matrix(0, 0, 0), "7") +
                                                             spot("C", "three", matrix(2000, 0, 0), "100")));
    PlotChange moved{.uuid = "C", .what = PlotChange::What::position};
    moved.local[3] = glm::dvec4(2.5, 0, -0.2, 1);
    const std::vector<PlotChange> changes = {
        {.uuid = "A", .what = PlotChange::What::address, .address = {3, 3}},
        {.uuid = "A", .what = PlotChange::What::address, .address = {3, 10}}, // the last word
        {.uuid = "A", .what = PlotChange::What::address, .dmx_break = 1, .address = {4, 1}},
        {.uuid = "B", .what = PlotChange::What::name, .text = "gone"},
        {.uuid = "C", .what = PlotChange::What::mode, .text = "Extended"},
        {.uuid = "C", .what = PlotChange::What::hidden, .hidden = true},
        {.uuid = "C", .what = PlotChange::What::name, .text = "mine"},
        moved};
    const MergedPlot merged = merge_plots(before, after, changes);
    ASSERT_EQ(merged.report.gone.size(), 1u);
    EXPECT_EQ(merged.report.gone[0].text, "gone");
    ASSERT_EQ(merged.report.kept.size(), 6u);
    const auto object = [&](const char* uuid) {
        return merged.plot.objects[static_cast<std::size_t>(find_object(merged.plot, uuid))];
    };
    const auto patch = patch_addresses(merged.plot, object("A"));
    ASSERT_EQ(patch.size(), 2u);
    EXPECT_EQ(absolute_address(patch[0]), 2 * 512 + 10);
    EXPECT_EQ(absolute_address(patch[1]), 3 * 512 + 1);
    EXPECT_EQ(object("C").device.gdtf_mode, "Extended");
    EXPECT_EQ(object("C").name, "mine");
    EXPECT_TRUE(object("C").hidden);
    EXPECT_FALSE(object("A").hidden);
    // It keeps its place on the truss, which went up.
    EXPECT_NEAR(object("C").world[3].x, 2.5, 1e-12);
    EXPECT_NEAR(object("C").world[3].z, 6.8, 1e-12);
    // Both changed the address of A: the user's stays, and it is said.
    EXPECT_TRUE(merged.report.kept[0].both);
    EXPECT_EQ(merged.report.kept[0].plot_says, "1.7");
    for (std::size_t i = 1; i < merged.report.kept.size(); ++i) EXPECT_FALSE(merged.report.kept[i].both) << i;
    const std::string text = text_of(merged.report);
    EXPECT_NE(text.find("your address of 'one' (A) is kept; the new plot says 1.7"), std::string::npos)
        << text;
    EXPECT_NE(text.find("your name of B is dropped"), std::string::npos) << text;
    // The plots that went in are as they were.
    EXPECT_EQ(after.objects[static_cast<std::size_t>(find_object(after, "C"))].name, "three");
}

TEST(mvr_merge, turned_reparented_and_repatched_by_break) {
    const Plot before =
        plot_of(spot("A", "one", "", "1") + "<GroupObject uuid='G' name='Front'><ChildList/></GroupObject>");
    const Plot after =
        plot_of("<GroupObject uuid='G' name='Front'><ChildList><Fixture uuid='A' "
                "name='one'><Matrix>{0,1,0}{-1,0,0}{0,0,1}{0,0,0}</Matrix>"
                "<GDTFSpec>Spot.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode><Addresses><Address>0</Address>"
                "<Address break='2'>9.512</Address></Addresses></Fixture></ChildList></GroupObject>");
    const MergedPlot merged = merge_plots(before, after, {});
    EXPECT_EQ(names(merged.report.moved), Strings{"one: turned"});
    EXPECT_EQ(names(merged.report.repatched),
              Strings{"one: break 0 address 1.1 is now none, break 2 address none is now 9.512"});
    ASSERT_EQ(merged.report.changed.size(), 1u);
    EXPECT_NE(merged.report.changed[0].what.find("hangs on group 'Front' instead of nothing"),
              std::string::npos);
}

TEST(mvr_merge, without_uuids_and_unrelated) {
    // Three boxes without a UUID: the third one is new.
    const std::string box = "<SceneObject name='box'/>";
    const MergedPlot merged = merge_plots(plot_of(box + box), plot_of(box + box + box), {});
    EXPECT_EQ(merged.report.added.size(), 1u);
    EXPECT_EQ(merged.report.removed.size(), 0u);
    EXPECT_EQ(merged.report.unchanged, 2u);
    const MergedPlot other =
        merge_plots(plot_of(spot("A", "one", "", "1")), plot_of(spot("B", "one", "", "1")), {});
    EXPECT_TRUE(other.report.unrelated);
    EXPECT_NE(text_of(other.report).find("another show?"), std::string::npos);
    EXPECT_FALSE(merge_plots(Plot{}, plot_of(box), {}).report.unrelated);
}

} // namespace
} // namespace ghost::scene
