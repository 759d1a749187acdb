// SPDX-License-Identifier: Apache-2.0
// What write_mvr writes has everything that was read: element by element, member by member.
#include "mvr/mvr_write.h"
#include "support/mvr_files.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

const fs::path kReal = fs::path(GHOST_SOURCE_DIR) / ".." / "shared" / "fixtures" / "mvr";

fs::path temporary(const std::string& name) {
    const char* folder = std::getenv("TEST_TMPDIR");
    return fs::path(folder ? folder : "/tmp") / name;
}

std::string text_of_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string description_of(LoadedPlot& loaded) {
    const auto bytes = loaded.archive.read(loaded.description);
    return bytes.ok() ? std::string(bytes->begin(), bytes->end()) : "";
}

// "" or what differs first. Texts are compared with entities resolved, and to the letter.
std::string difference(pugi::xml_node a, pugi::xml_node b) {
    const std::string place = a.path();
    if (a.type() != b.type() || std::string_view(a.name()) != b.name())
        return place + ": " + a.name() + " / " + b.name();
    if (std::string_view(a.value()) != b.value())
        return place + ": '" + a.value() + "' / '" + b.value() + "'";
    pugi::xml_attribute left = a.first_attribute();
    pugi::xml_attribute right = b.first_attribute();
    for (; left || right; left = left.next_attribute(), right = right.next_attribute())
        if (std::string_view(left.name()) != right.name() || std::string_view(left.value()) != right.value())
            return place + "@" + left.name() + ": '" + left.value() + "' / '" + right.value() + "'";
    pugi::xml_node x = a.first_child();
    pugi::xml_node y = b.first_child();
    for (; x || y; x = x.next_sibling(), y = y.next_sibling())
        if (std::string found = difference(x, y); !found.empty()) return found;
    return "";
}

std::string difference(const std::string& a, const std::string& b) {
    constexpr unsigned kAll = pugi::parse_full | pugi::parse_ws_pcdata | pugi::parse_fragment;
    pugi::xml_document left;
    pugi::xml_document right;
    if (!left.load_buffer(a.data(), a.size(), kAll) || !right.load_buffer(b.data(), b.size(), kAll))
        return "not well formed";
    return difference(left, right);
}

int compare_members(LoadedPlot& a, LoadedPlot& b) {
    int members = 0;
    EXPECT_EQ(a.archive.names().size(), b.archive.names().size());
    for (const std::string& name : a.archive.names()) {
        if (name == a.description) continue;
        const auto left = a.archive.read(name);
        const auto right = b.archive.read(name);
        EXPECT_TRUE(left.ok() && right.ok() && *left == *right) << name;
        ++members;
    }
    return members;
}

std::vector<PlotChange> some_changes() {
    std::vector<PlotChange> changes(5);
    changes[0] = {.uuid = uuid(14), .what = PlotChange::What::address, .dmx_break = 1, .address = {4, 100}};
    changes[1] = {.uuid = uuid(14), .what = PlotChange::What::mode, .text = "Wide & \"Fast\" <2>"};
    changes[2] = {.uuid = uuid(16), .what = PlotChange::What::position};
    changes[2].local[3] = glm::dvec4(1.5, -2.25, 0.1, 1.0);
    changes[3] = {.uuid = uuid(10), .what = PlotChange::What::name, .text = "Deck 'B' & \"C\""};
    changes[4] = {.uuid = uuid(16), .what = PlotChange::What::address, .address = {2, 1}};
    return changes;
}

TEST(mvr_write, unchanged_is_the_same_text_and_the_same_bytes_each_time) {
    LoadedPlot loaded = full_plot();
    Report report;
    const fs::path first = temporary("mvr_write_first.mvr");
    const fs::path second = temporary("mvr_write_second.mvr");
    const fs::path third = temporary("mvr_write_third.mvr");
    ASSERT_TRUE(write_mvr(loaded, {}, first, report).ok());
    ASSERT_TRUE(write_mvr(loaded, {}, second, report).ok());
    EXPECT_EQ(text_of_file(first), text_of_file(second));
    EXPECT_TRUE(report.messages.empty()) << messages_of(report);
    auto again = load_mvr(first);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(description_of(*again), full_xml());
    EXPECT_EQ(compare_members(loaded, *again), 10);
    // What was written is written the same when it is opened and written again.
    ASSERT_TRUE(write_mvr(*again, {}, third, report).ok());
    EXPECT_EQ(text_of_file(first), text_of_file(third));
    // Changes that say what the file says already change nothing.
    const std::vector<PlotChange> same = {
        {.uuid = uuid(14), .what = PlotChange::What::address, .dmx_break = 1, .address = {3, 17}},
        {.uuid = uuid(16), .what = PlotChange::What::address, .address = {0, 0}},
        {.uuid = uuid(17), .what = PlotChange::What::name, .text = "Wall"},
        {.uuid = uuid(16), .what = PlotChange::What::position},
        {.uuid = uuid(14), .what = PlotChange::What::mode, .text = "Standard"}};
    ASSERT_TRUE(write_mvr(loaded, same, second, report).ok());
    EXPECT_EQ(text_of_file(first), text_of_file(second));
}

TEST(mvr_write, changes_touch_only_their_elements) {
    LoadedPlot loaded = full_plot();
    Report report;
    const fs::path path = temporary("mvr_write_changed.mvr");
    const std::vector<PlotChange> changes = some_changes();
    ASSERT_TRUE(write_mvr(loaded, changes, path, report).ok());
    EXPECT_TRUE(report.messages.empty()) << messages_of(report);
    auto again = load_mvr(path);
    ASSERT_TRUE(again.ok()) << again.error().text();
    compare_members(loaded, *again);
    const Plot& plot = again->plot;
    EXPECT_EQ(object_of(plot, 14).device.addresses[1].written, "4.100"); // in the form that stood there
    EXPECT_EQ(object_of(plot, 14).device.addresses[0].written, "513");
    EXPECT_EQ(object_of(plot, 14).device.gdtf_mode, "Wide & \"Fast\" <2>");
    EXPECT_EQ(object_of(plot, 16).local, changes[2].local);
    EXPECT_EQ(object_of(plot, 16).device.addresses.at(0).written, "513");
    EXPECT_EQ(object_of(plot, 10).name, "Deck 'B' & \"C\"");
    // The text around them, letter by letter.
    std::string expected = full_xml();
    const auto replace = [&](const std::string& from, const std::string& to) {
        const std::size_t place = expected.find(from);
        ASSERT_NE(place, std::string::npos) << from;
        expected.replace(place, from.size(), to);
    };
    replace("3.17", "4.100");
    replace("<GDTFMode>Standard<", "<GDTFMode>Wide &amp; &quot;Fast&quot; &lt;2&gt;<");
    replace("Deck &quot;A&quot;", "Deck 'B' &amp; &quot;C&quot;");
    const std::string text = description_of(*again);
    EXPECT_NE(
        text.find(
            "\n            <Matrix>{1,0,0}{0,1,0}{0,0,1}{1500,-2250,100}</Matrix>\n            <Geometries"),
        std::string::npos); // indented as its neighbours are
    pugi::xml_document document;
    ASSERT_TRUE(document.load_buffer(text.data(), text.size(), pugi::parse_full));
    pugi::xml_node hoist = document.select_node("//Support").node();
    ASSERT_TRUE(hoist.remove_child("Matrix"));
    ASSERT_TRUE(hoist.remove_child("Addresses"));
    pugi::xml_document original;
    ASSERT_TRUE(original.load_buffer(expected.data(), expected.size(), pugi::parse_full));
    EXPECT_EQ(difference(document, original), "");
    // Merging is what a plot that was changed before needs: writing it once more adds nothing.
    const fs::path second = temporary("mvr_write_changed_2.mvr");
    ASSERT_TRUE(write_mvr(*again, changes, second, report).ok());
    EXPECT_EQ(text_of_file(path), text_of_file(second));
}

TEST(mvr_write, what_pugixml_would_lose_stays) {
    const std::string xml =
        "\xef\xbb\xbf<?xml version='1.0' encoding='utf-8'?>\r\n<!DOCTYPE x [<!ENTITY a \"b\">]>\r\n"
        "<?tool says?>\r\n<GeneralSceneDescription verMajor=\"1\" verMinor=\"6\">\r\n<!-- a & b -->"
        "<Scene><Layers><Layer uuid=\"1\"><ChildList><Fixture uuid=\"f1\" name=\"a&#9;b &a; &#xE4;\">"
        "<FixtureID>&lt;x&gt;&#13; <![CDATA[<raw & \"\">]]> y</FixtureID><Odd  b='2'   a='5\" x'/>"
        "<GDTFMode><![CDATA[old]]></GDTFMode>"
        "</Fixture></ChildList></Layer></Layers></Scene>\r\n</GeneralSceneDescription>\r\n<!-- end -->\r\n";
    auto loaded = load_description(xml);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    EXPECT_TRUE(says(loaded->report, {"entities"}));
    Report report;
    const fs::path path = temporary("mvr_write_odd.mvr");
    const std::vector<PlotChange> changes = {{.uuid = "F1", .what = PlotChange::What::mode, .text = "new"}};
    ASSERT_TRUE(write_mvr(*loaded, changes, path, report).ok());
    auto again = load_mvr(path);
    ASSERT_TRUE(again.ok());
    std::string expected = xml;
    expected.replace(expected.find("<![CDATA[old]]>"), 15, "new");
    EXPECT_EQ(difference(description_of(*again), expected), "");
    std::string text = description_of(*again);
    for (const char* kept :
         {"\xef\xbb\xbf<?xml", "<!ENTITY a \"b\">", "\r\n<?tool says?>\r\n", "a&#9;b &a; &#xE4;",
          "&lt;x&gt;&#13; <![CDATA[<raw & \"\">]]> y", "a=\"5&quot; x\"", "<!-- end -->\r\n"})
        EXPECT_NE(text.find(kept), std::string::npos) << kept << "\n" << text;
}

TEST(mvr_write, changes_that_cannot_be_written_are_said) {
    LoadedPlot loaded = full_plot();
    Report report;
    const std::vector<PlotChange> changes = {{.uuid = "nobody", .what = PlotChange::What::name, .text = "x"},
                                             {.uuid = uuid(14), .what = PlotChange::What::hidden}};
    const fs::path path = temporary("mvr_write_said.mvr");
    ASSERT_TRUE(write_mvr(loaded, changes, path, report).ok());
    EXPECT_TRUE(says(report, {"no object nobody"}));
    EXPECT_TRUE(says(report, {"'Spot 1' is hidden"}));
    const auto no_folder = write_mvr(loaded, {}, temporary("no_such_folder") / "x.mvr", report);
    ASSERT_FALSE(no_folder.ok());
    EXPECT_NE(no_folder.error().text().find("cannot write"), std::string::npos) << no_folder.error().text();
}

TEST(mvr_write, members_that_lead_out_or_come_twice_are_left_out) {
    auto loaded = load_mvr(
        mvr_bytes(small_xml(""), {{"../evil", "1"}, {"a.3ds", "2"}, {"a.3ds", "3"}, {"sub/b.3ds", "4"}}),
        "odd.mvr");
    ASSERT_TRUE(loaded.ok());
    Report report;
    const fs::path path = temporary("mvr_write_left_out.mvr");
    ASSERT_TRUE(write_mvr(*loaded, {}, path, report).ok());
    EXPECT_TRUE(says(report, {"../evil", "leads out"}));
    EXPECT_TRUE(says(report, {"second 'a.3ds'"}));
    auto again = load_mvr(path);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->archive.names(),
              (std::vector<std::string>{"GeneralSceneDescription.xml", "a.3ds", "sub/b.3ds"}));
}

TEST(mvr_write, a_damaged_member_is_said_and_written) {
    auto bytes = mvr_bytes(small_xml(""), {{"a.3ds", std::string(5000, 'm')}, {"b.3ds", "fine"}});
    const std::string wanted = "fine"; // stored or packed, its bytes stand in the file once
    const auto found = std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end());
    ASSERT_NE(found, bytes.end());
    *found = 'F';
    auto loaded = load_mvr(std::move(bytes), "hurt.mvr");
    ASSERT_TRUE(loaded.ok());
    Report report;
    const auto written = write_mvr(*loaded, {}, temporary("mvr_write_hurt.mvr"), report);
    ASSERT_TRUE(written.ok()) << written.error().text();
    ASSERT_EQ(report.messages.size(), 1u) << messages_of(report);
    EXPECT_EQ(report.messages[0].severity, Severity::error);
    EXPECT_TRUE(says(report, {"hurt.mvr: b.3ds", "is damaged", "written as it is"})) << messages_of(report);
    auto again = load_mvr(temporary("mvr_write_hurt.mvr"));
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->archive.names().size(), 3u);
    const auto whole = again->archive.read("a.3ds");
    ASSERT_TRUE(whole.ok());
    EXPECT_EQ(whole->size(), 5000u);
}

TEST(mvr_write, real_files) {
    if (!fs::exists(kReal)) GTEST_SKIP() << "no ../shared/fixtures beside the checkout";
    int files = 0;
    int members = 0;
    for (const auto& entry : fs::directory_iterator(kReal)) {
        if (entry.path().extension() != ".mvr") continue;
        SCOPED_TRACE(entry.path().filename().string());
        auto loaded = load_mvr(entry.path());
        ASSERT_TRUE(loaded.ok());
        Report report;
        const fs::path path = temporary("mvr_write_real.mvr");
        const fs::path second = temporary("mvr_write_real_2.mvr");
        ASSERT_TRUE(write_mvr(*loaded, {}, path, report).ok());
        ASSERT_TRUE(write_mvr(*loaded, {}, second, report).ok());
        EXPECT_EQ(text_of_file(path) == text_of_file(second), true);
        EXPECT_TRUE(report.messages.empty()) << messages_of(report);
        auto again = load_mvr(path);
        ASSERT_TRUE(again.ok());
        EXPECT_TRUE(description_of(*again) == description_of(*loaded));
        members += compare_members(*loaded, *again);

        // One object renamed: its attribute is all that differs.
        const PlotObject* named = nullptr;
        for (const PlotObject& object : loaded->plot.objects)
            if (!object.name.empty()) named = &object;
        ASSERT_NE(named, nullptr);
        const std::vector<PlotChange> changes = {
            {.uuid = named->uuid, .what = PlotChange::What::name, .text = "~~~"}};
        ASSERT_TRUE(write_mvr(*loaded, changes, path, report).ok());
        again = load_mvr(path);
        ASSERT_TRUE(again.ok());
        pugi::xml_document document;
        const std::string text = description_of(*again);
        constexpr unsigned kAll = pugi::parse_full | pugi::parse_ws_pcdata | pugi::parse_fragment;
        ASSERT_TRUE(document.load_buffer(text.data(), text.size(), kAll));
        const auto renamed = document.select_nodes("//*[@name='~~~']");
        ASSERT_EQ(renamed.size(), 1u);
        renamed[0].node().attribute("name").set_value(named->name.c_str());
        pugi::xml_document original;
        const std::string before = description_of(*loaded);
        ASSERT_TRUE(original.load_buffer(before.data(), before.size(), kAll));
        EXPECT_EQ(difference(document, original), "");
        ++files;
    }
    EXPECT_EQ(files, 10);
    EXPECT_EQ(members, 1084);
}

} // namespace
} // namespace ghost::scene
