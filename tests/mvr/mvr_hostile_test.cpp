// SPDX-License-Identifier: Apache-2.0
// What bad MVR files get: a message that says where, bounded memory, and the rest is kept.
#include "support/mvr_files.h"

#include "base/message_cap.h"

#include <zip.h>

#include <chrono>
#include <cmath>

namespace ghost::scene {
namespace {

std::string error_of(const Result<LoadedPlot>& loaded) {
    return loaded.ok() ? "" : loaded.error().text();
}

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

// A zip whose description is packed, made by libzip.
std::vector<std::uint8_t> packed(const std::string& name, const std::string& text, zip_int32_t method) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(target);
    zip_t* zip = zip_open_from_source(target, ZIP_TRUNCATE, &error);
    const auto index = static_cast<zip_uint64_t>(
        zip_file_add(zip, name.c_str(), zip_source_buffer(zip, text.data(), text.size(), 0), 0));
    zip_set_file_compression(zip, index, method, 0);
    EXPECT_EQ(zip_close(zip), 0);
    zip_source_open(target);
    zip_source_seek(target, 0, SEEK_END);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(zip_source_tell(target)));
    zip_source_seek(target, 0, SEEK_SET);
    zip_source_read(target, bytes.data(), bytes.size());
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

TEST(mvr_hostile, no_zip_no_description_no_xml) {
    EXPECT_SAYS(error_of(load_mvr(std::vector<std::uint8_t>(), "a.mvr")), "a.mvr: expected ");
    EXPECT_SAYS(error_of(load_mvr({'P', 'K', 3, 4, 0}, "a.mvr")), "a.mvr: the archive is cut short");
    EXPECT_SAYS(error_of(load_mvr({'G', 'I', 'F', 4, 0}, "a.mvr")), "a.mvr: expected a zip archive");
    EXPECT_SAYS(error_of(load_mvr(fixture::make_zip({{"x.xml", "<a/>"}}), "a.mvr")),
                "expected GeneralSceneDescription.xml");
    EXPECT_SAYS(error_of(load_description("<GeneralSceneDescription>\n<Scene>\n</Scen>")),
                "tiny.mvr: GeneralSceneDescription.xml:3: the XML is not well formed");
    EXPECT_SAYS(
        error_of(load_description("<GeneralSceneDescription>\n<Scene><Layers><Layer name=\"Rig\">"
                                  "<Fixture name=\"Spot 3\"></Scene>")),
        "in or behind GeneralSceneDescription/Scene/Layers/Layer 'Rig'/Fixture 'Spot 3' of that file inside "
        "of the plot");
    EXPECT_SAYS(error_of(load_description("")),
                "not well formed: No document element found, in that file inside of the plot");
    EXPECT_SAYS(error_of(load_description("<GDTF/>")), "expected the element GeneralSceneDescription");
    const auto empty = load_description("<GeneralSceneDescription/>");
    ASSERT_TRUE(empty.ok());
    EXPECT_TRUE(says(empty->report, {"verMajor"}));
    EXPECT_TRUE(says(empty->report, {"no Scene"}));
}

TEST(mvr_hostile, every_truncation_is_an_error_or_a_plot) {
    const auto whole = mvr_bytes(full_xml(), full_members());
    int errors = 0;
    for (std::size_t size = 0; size < whole.size(); size += 13)
        errors +=
            !load_mvr({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}, "cut.mvr").ok();
    EXPECT_EQ(errors, static_cast<int>((whole.size() + 12) / 13)); // the directory of a zip is its end
    // Damage inside of the description is found by its checksum.
    auto damaged = whole;
    damaged[200] ^= 1;
    EXPECT_SAYS(error_of(load_mvr(damaged, "a.mvr")), "damaged");
    const std::string xml = full_xml();
    for (std::size_t size = 0; size < xml.size(); size += 7) {
        const auto loaded = load_description(xml.substr(0, size));
        if (!loaded.ok()) {
            EXPECT_SAYS(error_of(loaded), "GeneralSceneDescription.xml");
        }
    }
}

TEST(mvr_hostile, methods_bombs_and_large_descriptions) {
    EXPECT_SAYS(error_of(load_mvr(fixture::make_zip({{"GeneralSceneDescription.xml", "xxxx"}}, 12), "a.mvr")),
                "zip method 12 is not supported");
    // 1.5 GB of blanks in 1.5 MB would be more than a member may have; here 80 MB in 80 kB.
    const auto bomb = packed("GeneralSceneDescription.xml", std::string(80u << 20, ' '), ZIP_CM_DEFLATE);
    EXPECT_LT(bomb.size(), 200'000u);
    EXPECT_SAYS(error_of(load_mvr(bomb, "bomb.mvr")), "at most 67108864 are allowed");
    std::string tags = "<GeneralSceneDescription>";
    for (int i = 0; i < 2'100'000; ++i) tags += "<a/>";
    EXPECT_SAYS(error_of(load_description(tags + "</GeneralSceneDescription>")), "more than 2000000 tags");
    // A bomb beside the description does no harm until it is read, and then it is refused.
    auto beside = load_description(small_xml(""), {{"bomb.3ds", "x"}});
    ASSERT_TRUE(beside.ok());
    EXPECT_FALSE(beside->archive.read("nothing.3ds").ok());
}

TEST(mvr_hostile, what_is_unpacked_over_a_session_has_an_end) {
    EXPECT_EQ(MvrLoading{}.limits.total_bytes, kMaxMvrTotalBytes);
    const std::string xml = small_xml(""), mesh(600, 'x');
    MvrLoading loading;
    loading.limits.total_bytes = xml.size() + 2 * mesh.size();
    auto loaded = load_mvr(mvr_bytes(xml, {{"a.3ds", mesh}, {"b.3ds", mesh}}), "a.mvr", loading);
    ASSERT_TRUE(loaded.ok()) << error_of(loaded);
    EXPECT_TRUE(loaded->archive.read("a.3ds").ok());
    EXPECT_TRUE(loaded->archive.read("b.3ds").ok()) << "as much as the limit is";
    const auto again = loaded->archive.read("a.3ds");
    ASSERT_FALSE(again.ok());
    EXPECT_SAYS(again.error().text(), "a.mvr");
    EXPECT_SAYS(again.error().text(),
                "more than the " + std::to_string(loading.limits.total_bytes) + " bytes");
}

TEST(mvr_hostile, entities_are_not_expanded) {
    std::string xml = "<?xml version=\"1.0\"?><!DOCTYPE lolz [<!ENTITY lol \"lol\">";
    for (int i = 1; i < 10; ++i) {
        xml += "<!ENTITY lol" + std::to_string(i) + " \"";
        for (int k = 0; k < 10; ++k) xml += "&lol" + (i > 1 ? std::to_string(i - 1) : "") + ";";
        xml += "\">";
    }
    xml += "]><GeneralSceneDescription verMajor=\"1\" verMinor=\"6\"><Scene><Layers><Layer "
           "name=\"&lol9;\"/></Layers>"
           "</Scene></GeneralSceneDescription>";
    const auto loaded = load_description(xml);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(loaded->plot.layers.at(0).name, "&lol9;");
    EXPECT_TRUE(says(loaded->report, {"entities"}));
}

TEST(mvr_hostile, names_in_the_archive) {
    auto loaded = load_description(small_xml("<SceneObject uuid='a'><Geometries><Geometry3D "
                                             "fileName='../../etc/passwd'/><Geometry3D fileName='/abs.3ds'/>"
                                             "<Geometry3D fileName='twice.3ds'/><Geometry3D "
                                             "fileName='GEO.3DS'/><Geometry3D fileName='x/deep.3ds'/>"
                                             "</Geometries></SceneObject>"),
                                   {{"../../etc/passwd", "root"},
                                    {"/abs.3ds", ""},
                                    {"C:\\win.3ds", ""},
                                    {"twice.3ds", "1"},
                                    {"twice.3ds", "2"},
                                    {"geo.3ds", "g"},
                                    {"Geo.3ds", "G"},
                                    {"deep.3ds", "d"}});
    ASSERT_TRUE(loaded.ok());
    const Plot& plot = loaded->plot;
    EXPECT_TRUE(says(loaded->report, {"names that lead out of the archive", "../../etc/passwd", "2 more"}));
    EXPECT_TRUE(says(loaded->report, {"two files of one name", "twice.3ds"}));
    EXPECT_TRUE(says(loaded->report, {"differ only by case", "Geo.3ds"}));
    ASSERT_EQ(plot.meshes.size(), 5u);
    EXPECT_EQ(plot.meshes[0].member, "");
    EXPECT_EQ(plot.meshes[1].member, "");
    EXPECT_EQ(plot.meshes[2].member, "twice.3ds");
    EXPECT_EQ(plot.meshes[3].member, "geo.3ds");
    EXPECT_TRUE(says(loaded->report, {"mesh 'GEO.3DS'", "taken is 'geo.3ds'"}));
    EXPECT_EQ(plot.meshes[4].member, "deep.3ds");
    EXPECT_TRUE(says(loaded->report, {"'../../etc/passwd' is not in the archive"}));
}

TEST(mvr_hostile, numbers_that_are_none) {
    const auto loaded = load_description(small_xml(
        "<Fixture uuid='a' name='bad'><Matrix>{nan,0,0}{0,1,0}{0,0,1}{0,0,0}</Matrix><GDTFSpec>x</GDTFSpec>"
        "<Addresses><Address break='-1'>1</Address><Address break='0'>99999999999</Address><Address "
        "break='1'>two</Address>"
        "<Address break='1'>3</Address><Address break='2'>4</Address></Addresses><UnitNumber>1e3</UnitNumber>"
        "<Color>-nan(ind),-nan(ind),N</Color><CastShadow>maybe</CastShadow></Fixture>"
        "<SceneObject uuid='b'><Matrix>{1,0,0}{0,1,0}{0,0,0}{1e11,0,0}</Matrix><Geometries/><ChildList>"
        "<SceneObject uuid='c'><Matrix>{1000000,0,0}{0,1000000,0}{0,0,1000000}{0,0,0}</Matrix><ChildList>"
        "<SceneObject uuid='d'><Matrix>{1000000,0,0}{0,1000000,0}{0,0,1000000}{0,0,0}</Matrix></SceneObject>"
        "</ChildList></SceneObject></ChildList></SceneObject>"));
    ASSERT_TRUE(loaded.ok());
    const Plot& plot = loaded->plot;
    ASSERT_EQ(plot.objects.size(), 4u);
    for (const PlotObject& object : plot.objects)
        for (int i = 0; i < 16; ++i) EXPECT_LE(std::abs(object.world[i / 4][i % 4]), 1e8);
    EXPECT_TRUE(
        says(loaded->report, {":5: Scene/Layers/Layer 'L'/Fixture 'bad'/Matrix", "expected {u}{v}{w}{o}"}));
    EXPECT_TRUE(says(loaded->report, {"determinant is 0"}));
    EXPECT_TRUE(says(loaded->report, {"further away than any stage"}));
    EXPECT_TRUE(says(loaded->report, {"expected a break"}));
    EXPECT_TRUE(says(loaded->report, {"expected an address like 513 or 2.1", "99999999999"}));
    EXPECT_TRUE(says(loaded->report, {"'two'"}));
    EXPECT_TRUE(says(loaded->report, {"second address for the same break"}));
    EXPECT_TRUE(says(loaded->report, {"whole number", "1e3"}));
    EXPECT_TRUE(says(loaded->report, {"expected a colour"}));
    EXPECT_TRUE(says(loaded->report, {"true or false", "maybe"}));
    const PlotDevice& device = plot.objects[0].device;
    ASSERT_EQ(device.addresses.size(), 3u);
    EXPECT_EQ(device.addresses[2].address.channel, 4);
}

TEST(mvr_hostile, symbols_in_circles_and_by_the_billion) {
    const auto circle = load_description(
        small_xml("<SceneObject uuid='a'><Geometries><Symbol symdef='s1'/></Geometries></SceneObject>",
                  "<Symdef uuid='s1' name='one'><ChildList><Symbol symdef='s2'/><Geometry3D "
                  "fileName='m.3ds'/></ChildList></Symdef>"
                  "<Symdef uuid='s2' name='two'><ChildList><Symbol symdef='s1'/><Symbol "
                  "symdef='s2'/></ChildList></Symdef>"),
        {{"m.3ds", ""}});
    ASSERT_TRUE(circle.ok());
    EXPECT_TRUE(says(circle->report, {"Symdef 'two'", "contains itself"}));
    EXPECT_EQ(mesh_instances(circle->plot).size(), 1u);

    // Ten symbols in each of nine, with and without a mesh at the end: 10^9 to walk through.
    for (const bool with_mesh : {true, false}) {
        std::string symbols = "<Symdef uuid='s0'>" +
                              std::string(with_mesh ? "<Geometry3D fileName='m.3ds'/>" : "") + "</Symdef>";
        for (int i = 1; i < 10; ++i) {
            symbols += "<Symdef uuid='s" + std::to_string(i) + "'><ChildList>";
            for (int k = 0; k < 10; ++k) symbols += "<Symbol symdef='s" + std::to_string(i - 1) + "'/>";
            symbols += "</ChildList></Symdef>";
        }
        const auto start = std::chrono::steady_clock::now();
        const auto billion =
            load_description(small_xml("<SceneObject uuid='a'><Geometries><Symbol symdef='s2'/><Symbol "
                                       "symdef='s9'/></Geometries></SceneObject>",
                                       symbols),
                             {{"m.3ds", ""}});
        ASSERT_TRUE(billion.ok());
        EXPECT_TRUE(says(billion->report, {"more than 1000000 geometries"}));
        EXPECT_EQ(mesh_instances(billion->plot).size(), with_mesh ? 100u : 0u);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    }
    // A chain far deeper than any plot.
    std::string chain;
    for (int i = 0; i < 2000; ++i)
        chain += "<Symdef uuid='s" + std::to_string(i) + "'><Symbol symdef='s" + std::to_string(i + 1) +
                 "'/></Symdef>";
    const auto deep = load_description(small_xml(
        "<SceneObject uuid='a'><Geometries><Symbol symdef='s0'/></Geometries></SceneObject>", chain));
    ASSERT_TRUE(deep.ok());
    EXPECT_TRUE(says(deep->report, {"symbols in symbols more than 64 deep"}));
    EXPECT_EQ(mesh_instances(deep->plot).size(), 0u);
}

TEST(mvr_hostile, depth_counts_and_messages_have_limits) {
    std::string deep;
    for (int i = 0; i < 50'000; ++i) deep += "<GroupObject uuid='g" + std::to_string(i) + "'><ChildList>";
    for (int i = 0; i < 50'000; ++i) deep += "</ChildList></GroupObject>";
    const auto nested = load_description(small_xml(deep));
    ASSERT_TRUE(nested.ok());
    EXPECT_EQ(nested->plot.objects.size(), static_cast<std::size_t>(kMaxMvrDepth));
    EXPECT_TRUE(says(nested->report, {"objects in objects more than 64 deep"}));

    std::string many;
    for (std::size_t i = 0; i < kMaxMvrObjects + 5; ++i)
        many += "<SceneObject uuid='" + std::to_string(i) + "'/>";
    const auto full = load_description(small_xml(many));
    ASSERT_TRUE(full.ok());
    EXPECT_EQ(full->plot.objects.size(), kMaxMvrObjects);
    EXPECT_TRUE(says(full->report, {"more than 100000 objects", "5 times"}));

    std::string wrong;
    for (int i = 0; i < 2000; ++i)
        wrong += "<Fixture uuid='" + std::to_string(i) + "'><GDTFSpec>f" + std::to_string(i) +
                 "</GDTFSpec></Fixture>";
    const auto faults = load_description(small_xml(wrong));
    ASSERT_TRUE(faults.ok());
    EXPECT_EQ(faults->report.messages.size(), kMaxMessages + 1);
    EXPECT_TRUE(says(faults->report, {"1500 more messages are not listed", "1500 losses"}));
    // A limit that is met after them is said all the same.
    std::string both = wrong;
    for (std::size_t i = 0; i < kMaxMvrObjects; ++i)
        both += "<SceneObject uuid='s" + std::to_string(i) + "'/>";
    const auto late = load_description(small_xml(both));
    ASSERT_TRUE(late.ok());
    EXPECT_TRUE(says(late->report, {"more than 100000 objects", "2000 times"})) << messages_of(late->report);
}

// Each missing name is compared with each that is there: letters enough for minutes, of which the first few
// names get theirs.
TEST(mvr_hostile, missing_names_of_a_whole_plot_share_one_budget) {
    constexpr int kNames = 2000;
    const auto name = [](int number, char letter) {
        return "Lamp " + std::to_string(10'000 + number) + " " + std::string(50, letter) + ".gdtf";
    };
    std::string fixtures;
    Members members;
    for (int k = 0; k < kNames; ++k) {
        fixtures +=
            "<Fixture uuid='" + std::to_string(k) + "'><GDTFSpec>" + name(k, 'a') + "</GDTFSpec></Fixture>";
        members.push_back({name(k + kNames, 'a'), "x"});
    }
    const auto loaded = load_description(small_xml(fixtures), std::move(members));
    ASSERT_TRUE(loaded.ok());
    std::size_t missing = 0, suggested = 0;
    for (const Message& message : loaded->report.messages) {
        if (message.what.find("is not in the archive") == std::string::npos) continue;
        ++missing;
        suggested += message.what.find("did you mean") == std::string::npos ? 0 : 1;
    }
    EXPECT_GE(missing, 400u);
    EXPECT_GT(suggested, 0u);
    EXPECT_LT(suggested, 50u) << messages_of(loaded->report).substr(0, 2000);
}

TEST(mvr_hostile, uuids_links_and_texts) {
    const auto loaded = load_description(
        small_xml(
            "<SceneObject uuid='a' name='first'/><SceneObject uuid='A' name='second'/><SceneObject "
            "name='none'/>"
            "<Fixture uuid='f' multipatch='f'><GDTFSpec>x</GDTFSpec><Focus>a</Focus><Position>p</Position>"
            "<Classing>00000000-0000-0000-0000-000000000000</Classing><Gobo>gone.png</Gobo>"
            "<Connections><Connection own='1' other='2' toObject='q'/></Connections></Fixture>"
            "<SceneObject uuid='long' name='" +
            std::string(5000, 'n') +
            "'/>"
            "<VideoScreen uuid='v'><Sources>movie.mov<Source type='Radio'>x</Source></Sources></VideoScreen>"
            "<Projector uuid='w'><Projections><Projection>gone.mov<ScaleHandeling>UpScale</ScaleHandeling>"
            "</Projection></Projections></Projector>"),
        {{"movie.mov", ""}});
    ASSERT_TRUE(loaded.ok());
    const Plot& plot = loaded->plot;
    EXPECT_TRUE(says(loaded->report, {"another object has the uuid"}));
    EXPECT_EQ(plot.objects[static_cast<std::size_t>(find_object(plot, "A"))].name, "first");
    EXPECT_EQ(find_object(plot, ""), -1);
    EXPECT_TRUE(says(loaded->report, {"without a uuid"}));
    EXPECT_TRUE(says(loaded->report, {"Focus names an object that is no FocusPoint"}));
    EXPECT_TRUE(says(loaded->report, {"the Position that Position names does not exist"}));
    EXPECT_FALSE(says(loaded->report, {"Classing"}));
    EXPECT_TRUE(says(loaded->report, {"object that Connection names does not exist"}));
    EXPECT_TRUE(says(loaded->report, {"gobo 'gone.png' is not in the archive"}));
    const PlotObject& fixture = plot.objects[static_cast<std::size_t>(find_object(plot, "f"))];
    EXPECT_EQ(fixture.device.multipatch, -1);
    EXPECT_EQ(fixture.device.focus, -1);
    EXPECT_EQ(plot.objects[static_cast<std::size_t>(find_object(plot, "long"))].name.size(), kMaxMvrText);
    const PlotObject& screen = plot.objects[static_cast<std::size_t>(find_object(plot, "v"))];
    ASSERT_EQ(screen.sources.size(), 2u);
    EXPECT_EQ(screen.sources[0].member, "movie.mov");
    EXPECT_TRUE(says(loaded->report, {"source of type 'Radio'"}));
    const PlotObject& projector = plot.objects[static_cast<std::size_t>(find_object(plot, "w"))];
    EXPECT_EQ(projector.projections.at(0).scale, PictureScale::keep_ratio);
    EXPECT_EQ(projector.projections.at(0).sources.at(0).member, "");
    EXPECT_TRUE(says(loaded->report, {"found 'UpScale'; taken as ScaleKeepRatio"}));
}

// Hours, where every missing name is held against every file of the archive.
TEST(mvr_hostile, many_missing_files_beside_many_others) {
    constexpr int kCount = 8000;
    const std::string long_name(48, 'n');
    Members members;
    std::string fixtures;
    for (int k = 0; k < kCount; ++k) {
        members.emplace_back(long_name + std::to_string(k) + "a.gdtf", "");
        fixtures += "<Fixture uuid=\"" + std::to_string(k) + "\"><GDTFSpec>" + std::string(48, 'm') +
                    std::to_string(k) + "b.gdtf</GDTFSpec></Fixture>";
    }
    auto bytes = mvr_bytes(small_xml(fixtures), std::move(members));
    const auto begun = std::chrono::steady_clock::now();
    const auto loaded = load_mvr(std::move(bytes), "tiny.mvr");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    EXPECT_EQ(loaded->plot.gdtf_files.size(), static_cast<std::size_t>(kCount));
    EXPECT_LT(took.count(), 10.0);
}

#undef EXPECT_SAYS

} // namespace
} // namespace ghost::scene
