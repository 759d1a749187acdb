// SPDX-License-Identifier: Apache-2.0
// What a show file does with a plot (changes, substitutes, hidden layers), cameras made for one, import and
// the next version.
#include "support/plot_files.h"

#include "plots/export_plot.h"
#include "plots/import_plot.h"
#include "show/default_cameras.h"
#include "show_folder/load_show.h"

namespace ghost::scene {
namespace {

Result<ImportedPlot> imported_into(const fs::path& plot, const fs::path& folder, Report& report) {
    TRY(const Show opened, load_show(plot, true, report));
    return import_plot(opened, folder, report);
}

TEST(PlotShow, FixtureFilesBesideThePlotAreTaken) {
    const fs::path folder = scratch("beside");
    write_mvr(folder / "plot.mvr",
              small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,0}", "", "Other", "Standard")));
    const std::string gdtf = head_gdtf();
    std::ofstream(folder / "Other.gdtf", std::ios::binary).write(gdtf.data(), std::ssize(gdtf));
    Report report;
    const Show show = opened(folder / "plot.mvr", report);
    EXPECT_NE(named(show, "Spot").type, nullptr);
    EXPECT_FALSE(report.lost_anything()) << messages_of(report);
}

TEST(PlotShow, SubstitutesStandInForFilesOfThePlot) {
    const fs::path folder = scratch("substitute");
    write_mvr(folder / "plot.mvr",
              small_xml(fixture_xml(20, "A", kIdentity + "{0,0,0}", "", "Gone@r1.gdtf", "Any") +
                        fixture_xml(21, "B", kIdentity + "{0,0,0}", "", "Head.gdtf", "Standard")));
    const std::string gdtf = head_gdtf();
    std::ofstream(folder / "Own.gdtf", std::ios::binary).write(gdtf.data(), std::ssize(gdtf));
    std::ofstream(folder / "show.toml") << R"([show]
plot = "plot.mvr"
[[substitute]]
for = "gone*"
gdtf = "Own.gdtf"
mode = "Standard"
[[substitute]]
for = "Nothing"
gdtf = "Own.gdtf"
)";
    Report report;
    const Show show = opened(folder, report);
    EXPECT_NE(named(show, "A").type, nullptr);
    EXPECT_EQ(named(show, "A").gdtf, "Own.gdtf");
    EXPECT_NE(named(show, "A").type, named(show, "B").type);
    EXPECT_FALSE(report.lost_anything()) << messages_of(report);
    EXPECT_TRUE(says(report, {"show.toml:8", "'Nothing'", "no fixture of the plot"})) << messages_of(report);
}

TEST(PlotShow, WhatIsHiddenIsLeftOutWithWhatHangsOnIt) {
    const fs::path folder = scratch("hidden");
    const std::string sail = "<Geometry3D fileName=\"Sail.glb\"/>";
    write_mvr(folder / "plot.mvr",
              small_xml(object_xml(40, "Seen", kIdentity + "{0,0,0}", sail) +
                            object_xml(41, "Audio", kIdentity + "{0,0,0}", sail,
                                       "<Classing>" + uuid(2) + "</Classing>") +
                            "<GroupObject uuid=\"" + uuid(42) + "\" name=\"G\"><ChildList>" +
                            object_xml(43, "In the group", kIdentity + "{0,0,0}", sail) +
                            fixture_xml(44, "Spot", kIdentity + "{0,0,0}", "") + "</ChildList></GroupObject>",
                        "<Class uuid=\"" + uuid(2) + "\" name=\"Sound\"/>"));
    std::ofstream(folder / "show.toml")
        << "[show]\nplot = \"plot.mvr\"\nhide_classes = [\"sound\", \"Soun\"]\n"
        << "[[change]]\nuuid = \"" << uuid(42) << "\"\nhidden = true\n";
    Report report;
    const Show show = opened(folder, report);
    ASSERT_EQ(show.stage.instances.size(), 1u);
    EXPECT_EQ(show.stage.instances[0].name, "Seen");
    EXPECT_TRUE(show.fixtures.empty());
    EXPECT_TRUE(says(report, {"show.toml:3", "no class 'Soun', did you mean 'Sound'"}))
        << messages_of(report);
}

// Looks and palettes call fixtures by their names.
TEST(PlotShow, OfFixturesOfOneNameTheOthersKeepTheirsWhereOneIsHidden) {
    const fs::path folder = scratch("one_name");
    write_mvr(folder / "plot.mvr", small_xml(fixture_xml(20, "Wash", kIdentity + "{0,0,0}", "") +
                                             fixture_xml(21, "Wash", kIdentity + "{1000,0,0}", "") +
                                             fixture_xml(22, "Wash", kIdentity + "{2000,0,0}", "")));
    std::ofstream(folder / "show.toml")
        << "[show]\nplot = \"plot.mvr\"\n[[change]]\nuuid = \"" << uuid(20) << "\"\nhidden = true\n";
    Report report;
    const Show show = opened(folder, report);
    ASSERT_EQ(show.fixtures.size(), 2u);
    EXPECT_EQ(show.fixtures[0].name, "Wash #2");
    EXPECT_EQ(show.fixtures[0].uuid, uuid(21));
    EXPECT_EQ(show.fixtures[1].name, "Wash #3");
}

TEST(PlotShow, TheShowFileChangesAndAdds) {
    const fs::path folder = scratch("changes");
    const std::string address = "<Addresses><Address break=\"0\">1</Address></Addresses>";
    write_mvr(folder / "plot.mvr", small_xml("<GroupObject uuid=\"" + uuid(10) + "\" name=\"Truss\">" +
                                             matrix("{0,1,0}{-1,0,0}{0,0,1}{1000,0,6000}") + "<ChildList>" +
                                             fixture_xml(20, "Spot", kIdentity + "{0,0,0}", address) +
                                             "</ChildList></GroupObject>"));
    const std::string gdtf = head_gdtf();
    std::ofstream(folder / "Own.gdtf", std::ios::binary).write(gdtf.data(), std::ssize(gdtf));
    std::ofstream(folder / "show.toml") << R"([show]
plot = "plot.mvr"
[[camera]]
name = "mine"
position_m = [0, -9, 2]
target_m = [0, 0, 2]
[[fixture]]
name = "Spot"
gdtf = "Own.gdtf"
address = 200
more_addresses = [[2, 7]]
invert_tilt = true
position_m = [3, 0, 6]
[[change]]
uuid = ")" << uuid(20) << R"("
universe = 4
address = 40
name = "Key"
position_m = [2, 3, 5]
rotation_deg = [180, 0, 0]
[[change]]
uuid = ")" << uuid(20) << R"("
break = 2
universe = 5
address = 50
circuit = "A3"
[[change]]
uuid = ")" << uuid(99) << R"("
name = "Nobody"
)";
    Report report;
    const Show show = opened(folder, report);
    ASSERT_EQ(show.cameras.size(), 1u);
    ASSERT_EQ(show.fixtures.size(), 2u);
    const PatchedFixture& own = named(show, "Spot");
    EXPECT_TRUE(own.uuid.empty());
    EXPECT_TRUE(own.invert_tilt);
    ASSERT_EQ(own.more_addresses.size(), 1u);
    EXPECT_EQ(own.more_addresses[0].channel, 7);
    const PatchedFixture& key = named(show, "Key");
    EXPECT_EQ(key.universe, 4);
    EXPECT_EQ(key.address, 40);
    ASSERT_EQ(key.more_addresses.size(), 1u);
    EXPECT_EQ(key.more_addresses[0].universe, 5);
    EXPECT_EQ(key.more_addresses[0].channel, 50);
    EXPECT_EQ(key.circuit, "A3");
    EXPECT_EQ(own.circuit, "");
    expect_near(key.position_m, {2, 3, 5});
    expect_near(-glm::vec3(fixture_to_world(key, 0)[2]), {0, 0, 1});
    EXPECT_TRUE(says(report, {"show.toml:28", "(Nobody)", "not in the plot"})) << messages_of(report);
    EXPECT_EQ(show.cache_folder(), folder / ".ghost");
}

TEST(PlotShow, LoadingStops) {
    const fs::path folder = scratch("stops");
    write_mvr(folder / "plot.mvr", small_xml(fixture_xml(20, "A", kIdentity + "{0,0,0}", "")));
    Report report;
    int asked = 0;
    double last = 0;
    ShowLoading loading;
    loading.progress = [&](double share, const std::string&) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1.0);
        last = share;
    };
    loading.stop = [&] { return ++asked > 0 && false; };
    EXPECT_TRUE(load_show(folder / "plot.mvr", true, report, loading).ok());
    EXPECT_GT(asked, 2);
    for (int after = 0; after < asked; ++after) {
        int calls = 0;
        loading.progress = {};
        loading.stop = [&] { return calls++ >= after; };
        EXPECT_FALSE(load_show(folder / "plot.mvr", true, report, loading).ok()) << after;
    }
}

TEST(PlotShow, NoPlotIsAnError) {
    const fs::path folder = scratch("broken");
    std::ofstream(folder / "plot.mvr") << "no zip";
    Report report;
    EXPECT_FALSE(load_show(folder / "plot.mvr", true, report).ok());
    EXPECT_FALSE(load_show(folder / "absent.mvr", true, report).ok());
    // In a show file it is a loss, and the rest goes on.
    std::ofstream(folder / "show.toml") << "[show]\nplot = \"plot.mvr\"\n";
    const Show show = opened(folder, report);
    EXPECT_EQ(show.cameras.size(), 3u);
    EXPECT_TRUE(report.lost_anything());
    for (const Camera& camera : show.cameras)
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(camera.position_m[k]));
}

TEST(DefaultCameras, SeeTheRigAndStayBeforeWalls) {
    Show show;
    for (int k = 0; k < 11; ++k) {
        show.fixtures.emplace_back();
        show.fixtures.back().position_m = {static_cast<float>(2 * k - 10), 5, 8};
    }
    const std::vector<Camera> open = default_cameras(show);
    EXPECT_LT(open[0].position_m.y, -8.0f) << "far enough for 20 m of truss";
    EXPECT_NEAR(open[0].target_m.x, 0.0f, 0.01);
    // A wall across the house.
    Mesh wall;
    wall.positions = {{-50, -10, -50}, {50, -10, -50}, {0, -10, 90}};
    wall.normals.assign(3, {0, 1, 0});
    wall.indices = {0, 1, 2};
    show.stage.meshes.push_back(wall);
    show.stage.materials.emplace_back();
    show.stage.instances.push_back({"wall", 0, glm::mat4(1.0f), kNone});
    const std::vector<Camera> walled = default_cameras(show);
    EXPECT_GT(walled[0].position_m.y, -10.0f);
    EXPECT_LT(walled[0].position_m.y, -5.0f);
    // So near, with a wider lens.
    const glm::vec3 ahead = glm::normalize(walled[0].target_m - walled[0].position_m);
    const float half = std::tan(glm::radians(walled[0].fov_y_deg / 2));
    for (const PatchedFixture& fixture : show.fixtures) {
        const glm::vec3 way = fixture.position_m - walled[0].position_m;
        EXPECT_LT(std::abs(way.x) / glm::dot(way, ahead), half * 16 / 9) << fixture.position_m.x;
    }
}

TEST(DefaultCameras, LookOverWhoStandsInTheWay) {
    Show show;
    for (int k = 0; k < 11; ++k) {
        show.fixtures.emplace_back();
        show.fixtures.back().position_m = {static_cast<float>(2 * k - 10), 5, 8};
    }
    const float free_y = default_cameras(show)[0].position_m.y;
    Mesh person;
    person.positions = {{-0.4f, -3, 0}, {0.4f, -3, 0}, {0.4f, -3, 2.6f}, {-0.4f, -3, 2.6f}};
    person.normals.assign(4, {0, 1, 0});
    person.indices = {0, 1, 2, 0, 2, 3};
    show.stage.meshes.push_back(person);
    show.stage.materials.emplace_back();
    show.stage.instances.push_back({"person", 0, glm::mat4(1.0f), kNone});
    EXPECT_FLOAT_EQ(default_cameras(show)[0].position_m.y, free_y);
}

TEST(DefaultCameras, StepAsideFromWhatStandsBeforeThem) {
    Show show;
    for (int k = 0; k < 11; ++k) {
        show.fixtures.emplace_back();
        show.fixtures.back().position_m = {static_cast<float>(2 * k - 10), k % 2 ? 9.0f : 1.0f, 8};
    }
    const Camera before = default_cameras(show)[1];
    // A set piece 2 m before it, 2 m wide.
    const glm::vec3 ahead = glm::normalize(before.target_m - before.position_m);
    const glm::vec3 middle = before.position_m + 2.0f * ahead;
    Mesh piece;
    piece.positions = {middle + glm::vec3(-1, 0, -2), middle + glm::vec3(1, 0, -2),
                       middle + glm::vec3(1, 0, 2), middle + glm::vec3(-1, 0, 2)};
    piece.normals.assign(4, {0, -1, 0});
    piece.indices = {0, 1, 2, 0, 2, 3};
    show.stage.meshes.push_back(piece);
    show.stage.materials.emplace_back();
    show.stage.instances.push_back({"piece", 0, glm::mat4(1.0f), kNone});
    const Camera after = default_cameras(show)[1];
    EXPECT_GT(glm::distance(after.position_m, before.position_m), 2.0f);
    EXPECT_NEAR(after.position_m.y, before.position_m.y, 1e-3f);
    const glm::vec3 way = glm::normalize(after.target_m - after.position_m);
    const float at = (middle.y - after.position_m.y) / way.y;
    EXPECT_GT(std::abs((after.position_m + at * way).x - middle.x), 1.0f)
        << "the middle of the picture is free";
}

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(ImportPlot, MakesAShowAndKeepsWhatTheUserChanged) {
    const fs::path folder = scratch("import");
    const std::string address = "<Addresses><Address>1</Address></Addresses>";
    write_mvr(folder / "tour.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,5000}", address) +
                                             fixture_xml(21, "Wash", kIdentity + "{1000,0,5000}", "")));
    const fs::path out = folder / "new" / "tour";
    Report report;
    const auto first = imported_into(folder / "tour.mvr", out, report);
    ASSERT_TRUE(first.ok()) << first.error().text();
    EXPECT_FALSE(first->merge.has_value());
    EXPECT_EQ(first->fixtures, 2u);
    Report of_show;
    const Show made = opened(out, of_show);
    EXPECT_FALSE(of_show.lost_anything()) << messages_of(of_show);
    EXPECT_EQ(made.fixtures.size(), 2u);
    ASSERT_EQ(made.cameras.size(), 3u);
    const Show direct = opened(folder / "tour.mvr", of_show);
    for (std::size_t k = 0; k < 3; ++k)
        expect_near(made.cameras[k].position_m, direct.cameras[k].position_m, 0.006f);
    EXPECT_NEAR(made.haze.extinction_per_m, direct.haze.extinction_per_m, 1e-4f);

    std::ofstream(out / "show.toml", std::ios::app)
        << "[[change]]\nuuid = \"" << uuid(20) << "\"\naddress = 99\n[[change]]\nuuid = \"" << uuid(21)
        << "\"\nname = \"Mine\"\n";
    const std::string mine = read_text(out / "show.toml");
    // The designer's next version: Spot moved, Wash gone, Blinder new.
    write_mvr(folder / "tour_2.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{500,0,5000}", address) +
                                               fixture_xml(22, "Blinder", kIdentity + "{0,0,4000}", "")));
    const auto second = imported_into(folder / "tour_2.mvr", out, report);
    ASSERT_TRUE(second.ok()) << second.error().text();
    ASSERT_TRUE(second->merge.has_value());
    const MergeReport& merge = *second->merge;
    ASSERT_EQ(merge.added.size(), 1u);
    EXPECT_EQ(merge.added[0].name, "Blinder");
    ASSERT_EQ(merge.removed.size(), 1u);
    EXPECT_EQ(merge.removed[0].name, "Wash");
    ASSERT_EQ(merge.moved.size(), 1u);
    ASSERT_EQ(merge.kept.size(), 1u);
    EXPECT_EQ(merge.kept[0].change.address.channel, 99);
    ASSERT_EQ(merge.gone.size(), 1u);
    EXPECT_EQ(read_text(out / "show.toml"), mine);
    EXPECT_EQ(read_text(out / "tour.mvr"), read_text(folder / "tour_2.mvr"));
    const Show merged = opened(out, of_show);
    EXPECT_EQ(named(merged, "Spot").address, 99);
    expect_near(named(merged, "Spot").position_m, {0.5f, 0, 5});
    EXPECT_EQ(merged.fixtures.size(), 2u);
    // The version that gave way is kept.
    EXPECT_EQ(read_text(out / "tour (before 1).mvr"), read_text(folder / "tour.mvr"));
    EXPECT_TRUE(says(report, {"kept as 'tour (before 1).mvr'"})) << messages_of(report);
    ASSERT_TRUE(imported_into(folder / "tour.mvr", out, report).ok());
    EXPECT_EQ(read_text(out / "tour (before 2).mvr"), read_text(folder / "tour_2.mvr"));
    EXPECT_EQ(std::distance(fs::directory_iterator(out), fs::directory_iterator()), 4);
}

// Neither line breaks nor bytes that are no UTF-8 can stand in a show file.
TEST(ImportPlot, GivesThePlotANameThatTheShowCanHold) {
    const fs::path folder = scratch("import_names");
    const fs::path plot = folder / "a\nb\xff.mvr";
    write_mvr(plot, small_xml(fixture_xml(20, "Spot\n", kIdentity + "{0,0,5000}", "")));
    Report report;
    const auto first = imported_into(plot, folder / "tour", report);
    ASSERT_TRUE(first.ok()) << first.error().text();
    EXPECT_EQ(first->plot_file, folder / "tour" / "a\\u000ab\xef\xbf\xbd.mvr");
    Report of_show;
    const Show made = opened(folder / "tour", of_show);
    EXPECT_FALSE(of_show.lost_anything()) << messages_of(of_show);
    EXPECT_EQ(made.name, "a\\u000ab\xef\xbf\xbd");
    EXPECT_EQ(made.fixtures.size(), 1u);
    const auto second = imported_into(plot, folder / "tour", report);
    ASSERT_TRUE(second.ok()) << second.error().text();
    EXPECT_TRUE(second->merge.has_value());
}

// A show from elsewhere says which file its plot is.
TEST(ImportPlot, ReplacesNoFileOutsideOfTheShow) {
    const fs::path folder = scratch("import_outside");
    write_mvr(folder / "new.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,0}", "")));
    fs::create_directories(folder / "show");
    std::ofstream(folder / "letter.mvr") << "dear";
    fs::create_symlink(folder / "letter.mvr", folder / "show" / "link.mvr");
    Report report;
    for (const char* const plot : {"../letter.mvr", "link.mvr"}) {
        std::ofstream(folder / "show" / "show.toml") << "[show]\nplot = \"" << plot << "\"\n";
        const auto imported = imported_into(folder / "new.mvr", folder / "show", report);
        ASSERT_FALSE(imported.ok()) << plot;
        EXPECT_NE(imported.error().text().find("outside of the show's folder"), std::string::npos)
            << imported.error().text();
        EXPECT_EQ(read_text(folder / "letter.mvr"), "dear");
        EXPECT_TRUE(fs::is_symlink(folder / "show" / "link.mvr"));
    }
}

TEST(ExportPlot, WritesWhatTheShowChangesAndNothingElse) {
    const fs::path folder = scratch("export");
    const std::string address = "<Addresses><Address break=\"0\">1</Address></Addresses><Note>kept</Note>";
    write_mvr(folder / "tour.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,5000}", address) +
                                             fixture_xml(21, "Wash", kIdentity + "{1000,0,5000}", address)));
    Report report;
    ASSERT_TRUE(imported_into(folder / "tour.mvr", folder / "show", report).ok());
    const auto plain = export_plot(folder / "show", folder / "same.mvr", {}, report);
    ASSERT_TRUE(plain.ok()) << plain.error().text();
    EXPECT_EQ(plain->changes, 0u);
    std::ofstream(folder / "show" / "show.toml", std::ios::app)
        << "[[change]]\nuuid = \"" << uuid(20) << "\"\nuniverse = 3\naddress = 99\nmode = \"Wide\"\n"
        << "position_m = [2, 3, 4]\n[[change]]\nuuid = \"" << uuid(21)
        << "\"\nhidden = true\n[[change]]\nuuid = \"" << uuid(77)
        << "\"\naddress = 5\n[[fixture]]\nname = \"Own\"\n";
    Report said;
    const auto exported = export_plot(folder / "show" / "show.toml", folder / "out.mvr", {}, said);
    ASSERT_TRUE(exported.ok()) << exported.error().text();
    EXPECT_EQ(exported->changes, 3u);
    EXPECT_TRUE(says(said, {"no object " + uuid(77)})) << messages_of(said);
    EXPECT_TRUE(says(said, {"'Wash' is hidden"})) << messages_of(said);
    EXPECT_TRUE(says(said, {"1 [[fixture]]", "not written"})) << messages_of(said);
    auto again = load_mvr(folder / "out.mvr");
    ASSERT_TRUE(again.ok());
    const int spot = find_object(again->plot, uuid(20)), wash = find_object(again->plot, uuid(21));
    ASSERT_TRUE(spot >= 0 && wash >= 0);
    const PlotObject& changed = again->plot.objects[static_cast<std::size_t>(spot)];
    ASSERT_EQ(changed.device.addresses.size(), 1u);
    EXPECT_EQ(changed.device.addresses[0].address.universe, 3);
    EXPECT_EQ(changed.device.addresses[0].address.channel, 99);
    EXPECT_EQ(changed.device.gdtf_mode, "Wide");
    expect_near(glm::vec3(changed.world[3]), {2, 3, 4});
    EXPECT_EQ(again->plot.objects[static_cast<std::size_t>(wash)].device.addresses[0].address.channel, 1);
    const auto text = again->archive.read(again->description);
    ASSERT_TRUE(text.ok());
    EXPECT_NE(std::string(text->begin(), text->end()).find("<Note>kept</Note>"), std::string::npos);
    // Without changes it is the plot's own description, to the letter.
    auto same = load_mvr(folder / "same.mvr"), first = load_mvr(folder / "tour.mvr");
    ASSERT_TRUE(same.ok() && first.ok());
    EXPECT_EQ(*same->archive.read(same->description), *first->archive.read(first->description));
    std::ofstream(folder / "none.toml")
        << "[show]\nname = \"none\"\n[[camera]]\nposition_m = [0, -9, 2]\ntarget_m = [0, 0, 2]\n";
    const auto none = export_plot(folder / "none.toml", folder / "x.mvr", {}, said);
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().text().find("a show without a plot"), std::string::npos) << none.error().text();
}

TEST(ImportPlot, KeepsNoMoreThanNinetyNineOlderVersions) {
    const fs::path folder = scratch("import_kept"), show = folder / "show";
    write_mvr(folder / "a.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,0}", "")));
    Report report;
    ASSERT_TRUE(imported_into(folder / "a.mvr", show, report).ok());
    for (int number = 1; number <= 98; ++number)
        std::ofstream(show / ("a (before " + std::to_string(number) + ").mvr")) << number;
    write_mvr(folder / "a.mvr", small_xml(fixture_xml(21, "Wash", kIdentity + "{0,0,0}", "")));
    ASSERT_TRUE(imported_into(folder / "a.mvr", show, report).ok());
    EXPECT_TRUE(fs::exists(show / "a (before 99).mvr"));
    const std::string before = read_text(show / "a.mvr");
    write_mvr(folder / "a.mvr", small_xml(fixture_xml(22, "Beam", kIdentity + "{0,0,0}", "")));
    const auto refused = imported_into(folder / "a.mvr", show, report);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().text().find("99 older versions are kept beside it"), std::string::npos)
        << refused.error().text();
    EXPECT_EQ(read_text(show / "a.mvr"), before);
    EXPECT_EQ(read_text(show / "a (before 7).mvr"), "7");
    EXPECT_FALSE(fs::exists(show / "a (before 100).mvr"));
}

TEST(ExportPlot, MoversAreKeptBesideItAndFindTheirLoadByUuid) {
    const fs::path folder = scratch("export_movers");
    write_mvr(folder / "tour.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,5000}", "") +
                                             fixture_xml(21, "Wash", kIdentity + "{1000,0,5000}", "")));
    Report report;
    ASSERT_TRUE(imported_into(folder / "tour.mvr", folder / "show", report).ok());
    const std::string mover = "[[mover]]\nname = \"Truss\"\nkind = \"linear\"\nfixtures = [\"Spot\", "
                              "\"Wa*\"] # both\n\n[[mover.axis]]\nrange_m = [0, -4]\n";
    std::ofstream(folder / "show" / "show.toml", std::ios::app) << "\n" << mover;
    Report said;
    ASSERT_TRUE(export_plot(folder / "show", folder / "out.mvr", {}, said).ok());
    EXPECT_TRUE(says(said, {"1 [[mover]]", "out.movers.toml"})) << messages_of(said);
    const std::string kept = must(read_text_file(folder / "out.movers.toml", 1 << 20));
    EXPECT_NE(kept.find(mover), std::string::npos) << kept;
    EXPECT_NE(kept.find("name = \"Wash\"\nuuid = \"" + uuid(21) + "\""), std::string::npos) << kept;
    const auto again = load_mvr(folder / "out.mvr");
    ASSERT_TRUE(again.ok());
    EXPECT_GE(find_object(again->plot, uuid(20)), 0) << "what is moved keeps its UUID";

    // Another program gives the spot another name.
    write_mvr(folder / "renamed.mvr", small_xml(fixture_xml(20, "Key light", kIdentity + "{0,0,5000}", "")));
    fs::copy_file(folder / "out.movers.toml", folder / "renamed.movers.toml");
    Report taken;
    ASSERT_TRUE(imported_into(folder / "renamed.mvr", folder / "second", taken).ok());
    EXPECT_TRUE(says(taken, {"1 [[mover]] taken into the show"})) << messages_of(taken);
    EXPECT_TRUE(says(taken, {"no more of what its movers carry", "Wash"})) << messages_of(taken);
    const std::string second = must(read_text_file(folder / "second" / "show.toml", 1 << 20));
    EXPECT_NE(second.find("fixtures = [\"Key light\", \"Wa*\"] # both"), std::string::npos) << second;
    const Show show = opened(folder / "second", taken);
    ASSERT_EQ(show.movers.size(), 1u);
    EXPECT_EQ(show.fixtures[0].mover, 0);

    std::string many = kept;
    for (int k = 0; k <= 20'000; ++k) many += "[[carried]]\n";
    std::ofstream(folder / "renamed.movers.toml") << many;
    Report full;
    ASSERT_TRUE(imported_into(folder / "renamed.mvr", folder / "full", full).ok());
    EXPECT_TRUE(says(full, {"has more than 20000 entries"})) << messages_of(full).substr(0, 2000);
    fs::resize_file(folder / "renamed.movers.toml", (16 << 20) + 1);
    EXPECT_FALSE(imported_into(folder / "renamed.mvr", folder / "third", taken).ok());

    std::ofstream(folder / "renamed.movers.toml") << "[[mover]\n";
    EXPECT_FALSE(imported_into(folder / "renamed.mvr", folder / "third", taken).ok());
    EXPECT_FALSE(fs::exists(folder / "third" / "show.toml"));
}

TEST(ImportPlot, RefusesWhatItWouldDestroy) {
    const fs::path folder = scratch("import_refuses");
    write_mvr(folder / "a.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,0}", "")));
    Report report;
    // Another plot of that name, which no show knows.
    fs::create_directories(folder / "taken");
    write_mvr(folder / "taken" / "a.mvr", small_xml(""));
    const std::string before = read_text(folder / "taken" / "a.mvr");
    EXPECT_FALSE(imported_into(folder / "a.mvr", folder / "taken", report).ok());
    EXPECT_EQ(read_text(folder / "taken" / "a.mvr"), before);
    EXPECT_FALSE(fs::exists(folder / "taken" / "show.toml"));
    // A show without a plot.
    fs::create_directories(folder / "other");
    std::ofstream(folder / "other" / "show.toml")
        << "[show]\nstage = \"s.glb\"\n[[camera]]\nname = \"c\"\nposition_m = [0,-9,2]\ntarget_m = [0,0,2]\n";
    EXPECT_FALSE(imported_into(folder / "a.mvr", folder / "other", report).ok());
    EXPECT_FALSE(fs::exists(folder / "other" / "a.mvr"));
    // Where it lies, it needs no copy; and it is not imported into itself.
    ASSERT_TRUE(imported_into(folder / "a.mvr", folder, report).ok());
    EXPECT_TRUE(fs::exists(folder / "show.toml"));
    EXPECT_FALSE(imported_into(folder / "a.mvr", folder, report).ok());
    EXPECT_FALSE(imported_into(folder / "absent.mvr", folder / "x", report).ok());
    EXPECT_FALSE(imported_into(folder, folder / "x", report).ok()) << "a show is no plot";
    EXPECT_FALSE(fs::exists(folder / "x" / "show.toml"));
    EXPECT_FALSE(imported_into(folder / "a.mvr", folder / "a.mvr", report).ok());
}

} // namespace
} // namespace ghost::scene
