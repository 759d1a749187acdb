// SPDX-License-Identifier: Apache-2.0
// A plot as a show: where things stand, what they are called, which channels they have, what the show file
// changes. Small plots made here.
#include "mvr_files.h"
#include "tiny_glb.h"

#include "fixture/decode.h"
#include "scene/default_cameras.h"
#include "scene/import_plot.h"
#include "scene/plot_show.h"
#include "scene/plot_types.h"
#include "scene/rig.h"
#include "scene/show.h"

#include <filesystem>
#include <fstream>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

// A head with pan and tilt and two breaks; the lamp is 0.2 m below the pivot.
std::string head_gdtf(const std::string& more_modes = "") {
    fixture::Description description;
    description.geometries = R"(<Geometry Name="Base"><Axis Name="Yoke">
        <Axis Name="Head" Position="{1,0,0,0}{0,1,0,0}{0,0,1,-0.3}{0,0,0,1}">
        <Beam Name="Lamp" Position="{1,0,0,0}{0,1,0,0}{0,0,1,-0.2}{0,0,0,1}"/></Axis></Axis></Geometry>)";
    const auto channel = [](const std::string& place, const std::string& geometry,
                            const std::string& attribute, const std::string& physical) {
        return "<DMXChannel " + place + " Geometry=\"" + geometry + "\"><LogicalChannel Attribute=\"" +
               attribute + "\"><ChannelFunction Name=\"" + attribute + "\" Attribute=\"" + attribute + "\" " +
               physical + "/></LogicalChannel></DMXChannel>\n";
    };
    description.channels =
        channel("DMXBreak=\"1\" Offset=\"1,2\"", "Yoke", "Pan", "PhysicalFrom=\"-270\" PhysicalTo=\"270\"") +
        channel("DMXBreak=\"1\" Offset=\"3,4\"", "Head", "Tilt", "PhysicalFrom=\"-135\" PhysicalTo=\"135\"") +
        channel("DMXBreak=\"2\" Offset=\"1\"", "Lamp", "Dimmer", "");
    std::string xml = description.xml();
    const std::string end = "</DMXModes>";
    xml.insert(xml.find(end), more_modes);
    return text_of(fixture::make_zip({{"description.xml", xml}}));
}

std::string matrix(const std::string& rows) {
    return "<Matrix>" + rows + "</Matrix>";
}

const std::string kIdentity = "{1,0,0}{0,1,0}{0,0,1}";

std::string fixture_xml(int number, const std::string& name, const std::string& rows, const std::string& rest,
                        const std::string& gdtf = "Head.gdtf", const std::string& mode = "Standard",
                        const std::string& attributes = "") {
    return "<Fixture uuid=\"" + uuid(number) + "\" name=\"" + name + "\"" + attributes + ">" + matrix(rows) +
           "<GDTFSpec>" + gdtf + "</GDTFSpec><GDTFMode>" + mode + "</GDTFMode><FixtureID>" +
           std::to_string(number) + "</FixtureID>" + rest + "</Fixture>\n";
}

std::string object_xml(int number, const std::string& name, const std::string& rows,
                       const std::string& geometries, const std::string& rest = "") {
    return "<SceneObject uuid=\"" + uuid(number) + "\" name=\"" + name + "\">" + matrix(rows) + rest +
           "<Geometries>" + geometries + "</Geometries></SceneObject>\n";
}

fs::path scratch(const std::string& name) {
    const fs::path folder = fs::path(::testing::TempDir()) / ("plot_show_" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

void write_mvr(const fs::path& path, const std::string& xml, Members members = {}) {
    members.push_back({"Head.gdtf", head_gdtf()});
    members.push_back({"Sail.glb", text_of(TinyGlb{}.bytes())});
    const std::vector<std::uint8_t> bytes = mvr_bytes(xml, std::move(members));
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

Show opened(const fs::path& path, Report& report) {
    auto show = load_show(path, true, report);
    EXPECT_TRUE(show.ok()) << show.error().text();
    return show.ok() ? std::move(*show) : Show{};
}

Show opened_xml(const std::string& name, const std::string& xml, Report& report, Members members = {}) {
    const fs::path path = scratch(name) / "plot.mvr";
    write_mvr(path, xml, std::move(members));
    return opened(path, report);
}

const PatchedFixture& named(const Show& show, const std::string& name) {
    for (const PatchedFixture& fixture : show.fixtures)
        if (fixture.name == name) return fixture;
    ADD_FAILURE() << "no fixture " << name;
    static const PatchedFixture none;
    return none;
}

void expect_near(const glm::vec3& value, const glm::vec3& expected, float tolerance = 1e-4f) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], tolerance) << "component " << k;
}

TEST(PlotShow, APlotIsAShow) {
    const fs::path folder = scratch("a_show");
    write_mvr(folder / "Tour.MVR", small_xml(fixture_xml(20, "Spot", kIdentity + "{1000,2000,6000}",
                                                         "<Addresses><Address break=\"0\">513</Address>"
                                                         "<Address break=\"1\">1030</Address></Addresses>")));
    Report report;
    const Show show = opened(folder / "Tour.MVR", report);
    EXPECT_FALSE(report.lost_anything()) << messages_of(report);
    EXPECT_EQ(show.name, "Tour");
    EXPECT_EQ(show.cache_folder(), folder / ".ghost" / "Tour.MVR");
    ASSERT_EQ(show.fixtures.size(), 1u);
    const PatchedFixture& spot = show.fixtures[0];
    EXPECT_EQ(spot.name, "Spot");
    EXPECT_EQ(spot.fixture_id, "20");
    EXPECT_EQ(spot.uuid, uuid(20));
    EXPECT_EQ(spot.universe, 2);
    EXPECT_EQ(spot.address, 1);
    ASSERT_EQ(spot.more_addresses.size(), 1u);
    EXPECT_EQ(spot.more_addresses[0].universe, 3);
    EXPECT_EQ(spot.more_addresses[0].channel, 6);
    expect_near(spot.position_m, {1, 2, 6});
    expect_near(spot.rotation_deg, {0, 0, 0});
    // Identity hangs: the light goes down, from below the pivot.
    expect_near(light_position_m(spot, 0), {1, 2, 5.7f});
    ASSERT_EQ(show.cameras.size(), 3u);
    EXPECT_EQ(show.cameras[0].name, "house");
    EXPECT_LT(show.cameras[0].position_m.y, -1.0f) << "the audience is down-stage";
    EXPECT_EQ(show.find_camera("").ok(), true);
}

TEST(PlotShow, EveryBreakIsReadFromItsOwnAddress) {
    Report report;
    const Show show = opened_xml("breaks",
                                 small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,5000}",
                                                       "<Addresses><Address break=\"0\">1</Address>"
                                                       "<Address break=\"1\">700</Address></Addresses>")),
                                 report);
    Rig rig(show);
    dmx::Universes universes;
    dmx::Levels second{};
    second[700 - 512 - 1] = 255;
    universes.at(2).levels = std::make_shared<const dmx::Levels>(second);
    rig.step(universes, 0.0);
    ASSERT_EQ(rig.states().size(), 1u);
    ASSERT_EQ(rig.states()[0].beams.size(), 1u);
    EXPECT_FLOAT_EQ(rig.states()[0].beams[0].optics.dimmer, 1.0f);
}

TEST(PlotShow, PanAndTiltAreInvertedBeforeTheyMove) {
    const std::string address = "<Addresses><Address>1</Address></Addresses>";
    Report report;
    const Show show = opened_xml("invert",
                                 small_xml(fixture_xml(20, "Plain", kIdentity + "{0,0,5000}", address) +
                                           fixture_xml(21, "Turned", kIdentity + "{2000,0,5000}",
                                                       "<DMXInvertPan>true</DMXInvertPan>" + address) +
                                           fixture_xml(22, "Tilted", kIdentity + "{4000,0,5000}",
                                                       "<DMXInvertTilt>true</DMXInvertTilt>" + address)),
                                 report);
    Rig rig(show);
    dmx::Universes universes;
    dmx::Levels levels{};
    levels[0] = 0xc0; // pan 135
    levels[2] = 0x40; // tilt -67.5
    universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
    rig.step(universes, 0.0);
    const auto angles = [&](std::size_t fixture) {
        double pan = 0;
        double tilt = 0;
        for (const fixture::AxisState& axis : rig.states()[fixture].axes)
            (axis.pan ? pan : tilt) = axis.motor.position;
        return glm::dvec2(pan, tilt);
    };
    EXPECT_NEAR(angles(0).x, 135.0, 0.01);
    EXPECT_NEAR(angles(0).y, -67.5, 0.01);
    EXPECT_NEAR(angles(1).x, -135.0, 0.01);
    EXPECT_NEAR(angles(1).y, -67.5, 0.01);
    EXPECT_NEAR(angles(2).x, 135.0, 0.01);
    EXPECT_NEAR(angles(2).y, 67.5, 0.01);
    // What is not received stays where the file has its default.
    Rig silent(show);
    silent.step({}, 0.0);
    EXPECT_EQ(silent.states()[0].axes[0].motor.position, silent.states()[1].axes[0].motor.position);
}

// Any rigid matrix comes back as the rotation of show.toml.
TEST(PlotShow, PlacementsAreTheMatrix) {
    for (const glm::vec3 turn : {glm::vec3(0, 0, 0), glm::vec3(180, 0, 0), glm::vec3(30, -50, 170),
                                 glm::vec3(-100, 20, -80), glm::vec3(0, 90, 0), glm::vec3(25, -90, 40)}) {
        PatchedFixture fixture;
        fixture.position_m = {1, -2, 3};
        fixture.rotation_deg = turn;
        const glm::mat4 world = fixture_to_world(fixture, 0);
        const Placement placement = placement_of(glm::dmat4(world));
        EXPECT_FALSE(placement.mirrored);
        EXPECT_FALSE(placement.scaled);
        fixture.rotation_deg = placement.rotation_deg;
        fixture.position_m = placement.position_m;
        const glm::mat4 again = fixture_to_world(fixture, 0);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) EXPECT_NEAR(again[column][row], world[column][row], 1e-5f);
    }
    glm::dmat4 mirror(1.0);
    mirror[0][0] = -1.0;
    EXPECT_TRUE(placement_of(mirror).mirrored);
    EXPECT_FALSE(placement_of(mirror).scaled);
    expect_near(placement_of(mirror).rotation_deg, {0, 0, 0});
    EXPECT_TRUE(placement_of(glm::dmat4(2.0)).scaled);
    EXPECT_TRUE(placement_of(glm::dmat4(0.0)).scaled);
    EXPECT_TRUE(std::isfinite(placement_of(glm::dmat4(0.0)).rotation_deg.x));
}

TEST(PlotShow, MirroredFixturesAreSaidOnce) {
    Report report;
    const std::string mirrored = "{-1,0,0}{0,1,0}{0,0,1}{0,0,5000}";
    const Show show = opened_xml(
        "mirrored_fixtures",
        small_xml(fixture_xml(20, "A", mirrored, "") + fixture_xml(21, "B", mirrored, "")), report);
    EXPECT_TRUE(says(report, {"2 fixtures are mirrored", "'A', 'B'"})) << messages_of(report);
    EXPECT_EQ(show.fixtures.size(), 2u);
}

TEST(PlotShow, NamesAreUnique) {
    Report report;
    const Show show = opened_xml("names",
                                 small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,0}", "") +
                                           fixture_xml(21, "Spot", kIdentity + "{0,0,0}", "") +
                                           fixture_xml(22, "Spot #2", kIdentity + "{0,0,0}", "") +
                                           fixture_xml(23, "Spot", kIdentity + "{0,0,0}", "") +
                                           fixture_xml(24, "", kIdentity + "{0,0,0}", "")),
                                 report);
    std::vector<std::string> names;
    for (const PatchedFixture& fixture : show.fixtures) names.push_back(fixture.name);
    EXPECT_EQ(names, (std::vector<std::string>{"Spot", "Spot #2", "Spot #2 #2", "Spot #3", "Tiny"}));
}

TEST(PlotShow, MissingFixtureFilesAndModes) {
    Report report;
    const Show show =
        opened_xml("missing",
                   small_xml(fixture_xml(20, "Gone 1", kIdentity + "{0,0,0}", "", "Gone.gdtf") +
                             fixture_xml(21, "Gone 2", kIdentity + "{0,0,0}", "", "Gone.gdtf") +
                             fixture_xml(22, "Odd 1", kIdentity + "{0,0,0}", "", "Head.gdtf", "standart") +
                             fixture_xml(23, "Odd 2", kIdentity + "{0,0,0}", "", "Head.gdtf", "standart") +
                             fixture_xml(24, "Plain", kIdentity + "{0,0,0}", "", "Head.gdtf", "")),
                   report);
    ASSERT_EQ(show.fixtures.size(), 5u);
    EXPECT_EQ(named(show, "Gone 1").type, nullptr);
    EXPECT_TRUE(says(report, {"'Gone.gdtf' is not in the archive", "2 fixtures need it"}))
        << messages_of(report);
    EXPECT_NE(named(show, "Odd 1").type, nullptr);
    EXPECT_TRUE(says(report, {"no mode 'standart'", "it gets 'Standard'", "(2 fixtures)"}))
        << messages_of(report);
    int said = 0;
    for (const Message& message : report.messages)
        said += message.what.find("no mode '") != std::string::npos;
    EXPECT_EQ(said, 1);
    Rig rig(show);
    rig.step({}, 0.0);
    EXPECT_TRUE(rig.states()[0].beams.empty());
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

TEST(PlotShow, NearestMode) {
    fixture::Type type;
    for (const char* name : {"Standard 16 bit", "Reduced 8 bit", "standard"}) {
        type.modes.emplace_back();
        type.modes.back().name = name;
    }
    const auto nearest = [&](const std::string& name) { return nearest_mode(type, name); };
    EXPECT_EQ(nearest("Reduced 8 bit"), 1);
    EXPECT_EQ(nearest("STANDARD"), 2);
    EXPECT_EQ(nearest("Standard - 16 bit"), 0);
    EXPECT_EQ(nearest_mode(fixture::Type{}, "x"), -1);
}

TEST(PlotShow, FixturesHangOnPartsOfFixtures) {
    Report report;
    const std::string child =
        "<ChildList>" +
        fixture_xml(21, "Scroller", kIdentity + "{0,0,-50}", "<ChildPosition>Base.Yoke.Head</ChildPosition>",
                    "Head.gdtf", "Standard", " multipatch=\"" + uuid(20) + "\"") +
        "</ChildList>";
    const Show show =
        opened_xml("child",
                   small_xml(fixture_xml(20, "Spot", "{0,1,0}{-1,0,0}{0,0,1}{1000,0,6000}",
                                         "<Addresses><Address>2.17</Address></Addresses>" + child)),
                   report);
    const PatchedFixture& scroller = named(show, "Scroller");
    expect_near(scroller.position_m, {1, 0, 6 - 0.3f - 0.05f});
    expect_near(scroller.rotation_deg, {0, 0, 90});
    EXPECT_EQ(scroller.universe, 2) << "multipatch: the channels of the one it names";
    EXPECT_EQ(scroller.address, 17);
}

TEST(PlotShow, LanternsThatNothingTurnsAimAtTheirFocus) {
    fixture::Description plain;
    const std::string gdtf = text_of(fixture::make_zip({{"description.xml", plain.xml()}}));
    Report report;
    const Show show = opened_xml(
        "focus",
        small_xml(
            fixture_xml(20, "Par", kIdentity + "{0,0,5000}", "<Focus>" + uuid(30) + "</Focus>", "Par.gdtf") +
            fixture_xml(21, "Spot", kIdentity + "{0,0,5000}", "<Focus>" + uuid(30) + "</Focus>") +
            "<FocusPoint uuid=\"" + uuid(30) + "\" name=\"F\">" + matrix(kIdentity + "{5000,0,0}") +
            "<Geometries><Geometry3D fileName=\"Sail.glb\"/></Geometries></FocusPoint>"),
        report, {{"Par.gdtf", gdtf}});
    const glm::mat4 to_world = fixture_to_world(named(show, "Par"), 0);
    expect_near(-glm::vec3(to_world[2]), glm::normalize(glm::vec3(1, 0, -1)));
    expect_near(named(show, "Spot").rotation_deg, {0, 0, 0});
    EXPECT_TRUE(show.stage.instances.empty()) << "a focus point is a mark, not a thing";
}

TEST(PlotShow, StageOfSymbolsInMirrorsAndMillimetres) {
    const std::string symbols =
        "<Symdef uuid=\"" + uuid(3) + "\" name=\"Bay\"><ChildList><Symbol uuid=\"" + uuid(31) +
        "\" symdef=\"" + uuid(4) + "\">" + matrix(kIdentity + "{0,0,500}") +
        "</Symbol><Geometry3D fileName=\"Sail.glb\"/></ChildList></Symdef><Symdef uuid=\"" + uuid(4) +
        "\" name=\"Sail\"><ChildList><Geometry3D fileName=\"Sail.glb\">" +
        matrix("{2,0,0}{0,2,0}{0,0,2}{0,100,0}") + "</Geometry3D></ChildList></Symdef>";
    Report report;
    const Show show = opened_xml(
        "stage",
        small_xml(object_xml(40, "Deck", "{-1,0,0}{0,1,0}{0,0,1}{2000,-3000,0}",
                             "<Symbol uuid=\"" + uuid(32) + "\" symdef=\"" + uuid(3) + "\"/>") +
                      object_xml(41, "Lost", kIdentity + "{0,0,0}", "<Geometry3D fileName=\"No.glb\"/>"),
                  symbols),
        report);
    EXPECT_TRUE(says(report, {"mesh 'No.glb' is not in the archive"})) << messages_of(report);
    const Stage& stage = show.stage;
    ASSERT_EQ(stage.meshes.size(), 1u) << "one file, however often it is used";
    ASSERT_EQ(stage.instances.size(), 2u);
    bool found = false;
    for (const Instance& instance : stage.instances) {
        EXPECT_EQ(instance.name, "Deck");
        EXPECT_LT(glm::determinant(glm::mat3(instance.world)), 0.0f) << "mirrored";
        // The corner (0, 1, 0) of the file, Y up, is (0, 0, 1) here.
        const glm::vec3 corner(instance.world * glm::vec4(stage.meshes[0].positions[2], 1.0f));
        if (glm::distance(corner, glm::vec3(2, -2.9f, 0.5f + 2)) < 1e-4f) found = true;
    }
    EXPECT_TRUE(found);
    // Read again, as a renderer with baked passes does: the same.
    Report again;
    const auto stage_again = read_stage(show, again);
    ASSERT_TRUE(stage_again.ok());
    EXPECT_EQ(stage_again->instances.size(), 2u);
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
    expect_near(key.position_m, {2, 3, 5});
    expect_near(-glm::vec3(fixture_to_world(key, 0)[2]), {0, 0, 1});
    EXPECT_TRUE(says(report, {"show.toml:27", "(Nobody)", "not in the plot"})) << messages_of(report);
    EXPECT_EQ(show.cache_folder(), folder / ".ghost");
}

TEST(PlotShow, ChannelsThatAreSharedAreSaidWithTheirPlaces) {
    Report report;
    const std::string address = "<Addresses><Address>1</Address></Addresses>";
    const std::string other = "<Addresses><Address>3</Address></Addresses>";
    opened_xml("overlap",
               small_xml(fixture_xml(20, "A", kIdentity + "{0,0,0}", address) +
                         fixture_xml(21, "B", kIdentity + "{0,0,0}", other)),
               report);
    EXPECT_TRUE(
        says(report, {"plot.mvr: GeneralSceneDescription.xml:", "'B' shares universe 1 channels 3 to 4"}))
        << messages_of(report);
}

TEST(PlotShow, PlotsFarFromTheirOriginComeNear) {
    Report report;
    const Show show =
        opened_xml("survey",
                   small_xml(fixture_xml(20, "A", kIdentity + "{400000250,5600000500,6000}", "") +
                             object_xml(40, "Deck", kIdentity + "{400001000,5600000000,0}",
                                        "<Geometry3D fileName=\"Sail.glb\"/>")),
                   report);
    expect_near(named(show, "A").position_m, {0.25f, 0.5f, 6});
    ASSERT_EQ(show.stage.instances.size(), 1u);
    expect_near(glm::vec3(show.stage.instances[0].world[3]), {1, 0, 0});
    EXPECT_TRUE(says(report, {"400, 5600, 0 km"})) << messages_of(report);
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
    const auto first = import_plot(folder / "tour.mvr", out, report);
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
    const auto second = import_plot(folder / "tour_2.mvr", out, report);
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
    for (const auto& entry : fs::directory_iterator(out))
        EXPECT_TRUE(entry.path().filename() == "show.toml" || entry.path().filename() == "tour.mvr")
            << entry.path();
}

TEST(ImportPlot, RefusesWhatItWouldDestroy) {
    const fs::path folder = scratch("import_refuses");
    write_mvr(folder / "a.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,0}", "")));
    Report report;
    // Another plot of that name, which no show knows.
    fs::create_directories(folder / "taken");
    write_mvr(folder / "taken" / "a.mvr", small_xml(""));
    const std::string before = read_text(folder / "taken" / "a.mvr");
    EXPECT_FALSE(import_plot(folder / "a.mvr", folder / "taken", report).ok());
    EXPECT_EQ(read_text(folder / "taken" / "a.mvr"), before);
    EXPECT_FALSE(fs::exists(folder / "taken" / "show.toml"));
    // A show without a plot.
    fs::create_directories(folder / "other");
    std::ofstream(folder / "other" / "show.toml")
        << "[show]\nstage = \"s.glb\"\n[[camera]]\nname = \"c\"\nposition_m = [0,-9,2]\ntarget_m = [0,0,2]\n";
    EXPECT_FALSE(import_plot(folder / "a.mvr", folder / "other", report).ok());
    EXPECT_FALSE(fs::exists(folder / "other" / "a.mvr"));
    // Where it lies, it needs no copy; and it is not imported into itself.
    ASSERT_TRUE(import_plot(folder / "a.mvr", folder, report).ok());
    EXPECT_TRUE(fs::exists(folder / "show.toml"));
    EXPECT_FALSE(import_plot(folder / "a.mvr", folder, report).ok());
    EXPECT_FALSE(import_plot(folder / "absent.mvr", folder / "x", report).ok());
    EXPECT_FALSE(import_plot(folder / "a.mvr", folder / "a.mvr", report).ok());
}

} // namespace
} // namespace ghost::scene
