// SPDX-License-Identifier: Apache-2.0
// A plot as a show: where things stand, what they are called, which channels they have. Small plots made
// here.
#include "support/plot_files.h"

#include "beam_groups/light_places.h"
#include "fixture/decode.h"
#include "light/rig.h"
#include "plots/plot_changes.h"
#include "plots/plot_show.h"
#include "plots/plot_stage.h"
#include "plots/plot_types.h"
#include "show_folder/load_show.h"

#include <ctime>

namespace ghost::scene {
namespace {

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

// A projector of the plot shows what its source names: a file beside the plot; a stream is a test card.
TEST(PlotShow, ProjectorsProject) {
    const auto projector = [](int number, const std::string& source) {
        return "<Projector uuid=\"" + uuid(number) + "\" name=\"Beamer\">" +
               matrix(kIdentity + "{0,0,5000}") +
               "<GDTFSpec>Beamer.gdtf</GDTFSpec><GDTFMode>Standard</GDTFMode><Projections><Projection>" +
               source +
               "<ScaleHandeling>ScaleIgnoreRatio</ScaleHandeling></Projection></Projections></Projector>\n";
    };
    fixture::Description description;
    description.geometries = R"(<Geometry Name="Base"><Beam Name="Lamp" BeamType="Rectangle" ThrowRatio="1.8"
        RectangleRatio="1.6" LuminousFlux="15000"/></Geometry>)";
    const std::string gdtf = text_of(fixture::make_zip({{"description.xml", description.xml()}}));
    const fs::path folder = scratch("projectors");
    std::ofstream(folder / "sea.mp4") << "not looked into here";
    write_mvr(
        folder / "Show.mvr",
        small_xml(projector(30, R"(<Source linkedGeometry="Lamp" type="File">C:\films\sea.mp4</Source>)") +
                  projector(31, R"(<Source linkedGeometry="Lamp" type="NDI">STUDIO (cam 1)</Source>)")),
        {{"Beamer.gdtf", gdtf}});
    Report report;
    const Show show = opened(folder / "Show.mvr", report);
    ASSERT_EQ(show.fixtures.size(), 2u) << messages_of(report);
    ASSERT_TRUE(show.fixtures[0].projector && show.fixtures[1].projector) << messages_of(report);
    EXPECT_FLOAT_EQ(show.fixtures[0].projector->throw_ratio, 1.8f);
    EXPECT_FLOAT_EQ(show.fixtures[0].projector->aspect, 1.6f);
    EXPECT_EQ(show.fixtures[0].projector->fit, Fit::stretch);
    ASSERT_EQ(show.media.size(), 2u);
    EXPECT_EQ(show.media[0].file, folder / "sea.mp4");
    EXPECT_EQ(show.media[1].kind, MediaKind::card);
    EXPECT_NE(messages_of(report).find("STUDIO (cam 1)"), std::string::npos) << messages_of(report);
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

TEST(PlotShow, KnowsWhichModesAndPlacesNobodySays) {
    const std::string nowhere = "{nan,0,0}{0,1,0}{0,0,1}{0,0,0}";
    const std::string two_modes = R"(<DMXMode Name="Wide" Geometry="Base"/>)";
    const std::string xml =
        small_xml(fixture_xml(20, "Good", kIdentity + "{0,0,5000}", "") +
                  fixture_xml(21, "Odd mode", kIdentity + "{0,0,5000}", "", "Two.gdtf", "standart") +
                  fixture_xml(22, "No mode", kIdentity + "{0,0,5000}", "", "Two.gdtf", "") +
                  fixture_xml(23, "One mode", kIdentity + "{0,0,5000}", "", "Tiny.gdtf", "") +
                  fixture_xml(24, "Nowhere", nowhere, "") + fixture_xml(25, "Put right", nowhere, "") +
                  fixture_xml(26, "Turned only", nowhere, "") +
                  object_xml(30, "Far truss", kIdentity + "{0,0,1e12}", "",
                             "<ChildList>" + fixture_xml(27, "Below it", kIdentity + "{0,0,5000}", "") +
                                 "</ChildList>"));
    const fs::path folder = scratch("unsaid");
    write_mvr(
        folder / "plot.mvr", xml,
        {{"Two.gdtf", head_gdtf(two_modes)},
         {"Tiny.gdtf", text_of(fixture::make_zip({{"description.xml", fixture::Description{}.xml()}}))}});
    std::ofstream(folder / "show.toml")
        << "[show]\nplot = \"plot.mvr\"\n"
        << "[[change]]\nuuid = \"" << uuid(25) << "\"\nposition_m = [1, 2, 3]\n"
        << "[[change]]\nuuid = \"" << uuid(26) << "\"\nrotation_deg = [0, 90, 0]\n";
    Report report;
    const Show show = opened(folder, report);
    for (const auto& [name, mode, place] : {std::tuple{"Good", true, true},
                                            {"Odd mode", false, true},
                                            {"No mode", false, true},
                                            {"One mode", true, true},
                                            {"Nowhere", true, false},
                                            {"Put right", true, true},
                                            {"Turned only", true, false},
                                            {"Below it", true, false}}) {
        EXPECT_EQ(named(show, name).is_mode_known, mode) << name << "\n" << messages_of(report);
        EXPECT_EQ(named(show, name).is_place_known, place) << name << "\n" << messages_of(report);
    }
}

TEST(PlotShow, KnowsWhichTurnsAndAddressesNobodySays) {
    const std::string flat = "{0,0,0}{0,0,0}{0,0,0}{7000,2000,6000}",
                      nowhere = "{nan,0,0}{0,1,0}{0,0,1}{0,0,0}";
    const auto address = [](const std::string& text) {
        return "<Addresses><Address break=\"0\">" + text + "</Address></Addresses>";
    };
    const fs::path folder = scratch("unread");
    write_mvr(folder / "plot.mvr",
              small_xml(fixture_xml(20, "Good", kIdentity + "{0,0,5000}", address("5")) +
                        fixture_xml(21, "Unpatched", kIdentity + "{0,0,5000}", address("0")) +
                        fixture_xml(22, "Odd address", kIdentity + "{0,0,5000}", address("abc")) +
                        fixture_xml(23, "Patched again", kIdentity + "{0,0,5000}", address("abc")) +
                        fixture_xml(24, "Odd break", kIdentity + "{0,0,5000}",
                                    "<Addresses><Address break=\"x\">9</Address></Addresses>") +
                        fixture_xml(25, "Flat", flat, "") + fixture_xml(26, "Turned", flat, "") +
                        fixture_xml(27, "Nowhere", nowhere, "") + fixture_xml(28, "Placed", nowhere, "")));
    std::ofstream(folder / "show.toml")
        << "[show]\nplot = \"plot.mvr\"\n"
        << "[[change]]\nuuid = \"" << uuid(23) << "\"\nuniverse = 1\naddress = 9\n"
        << "[[change]]\nuuid = \"" << uuid(26) << "\"\nrotation_deg = [0, 90, 0]\n"
        << "[[change]]\nuuid = \"" << uuid(28) << "\"\nposition_m = [1, 2, 3]\n"
        << "[[fixture]]\nname = \"Own\"\ngdtf = \"a.gdtf\"\naddress = 700\nposition_m = [0, 0, 5]\n"
        << "rotation_deg = [0, 0]\n"
        << "[[fixture]]\nname = \"Odd universe\"\ngdtf = \"a.gdtf\"\nuniverse = 0\naddress = 7\n"
        << "position_m = [0, 0, 5]\n";
    Report report;
    const Show show = opened(folder, report);
    for (const auto& [name, is_turn, is_address] : {std::tuple{"Good", true, true},
                                                    {"Unpatched", true, true},
                                                    {"Odd address", true, false},
                                                    {"Patched again", true, true},
                                                    {"Odd break", true, false},
                                                    {"Flat", false, true},
                                                    {"Turned", true, true},
                                                    {"Nowhere", false, true},
                                                    {"Placed", false, true},
                                                    {"Own", false, false},
                                                    {"Odd universe", true, false}}) {
        EXPECT_EQ(named(show, name).is_rotation_known, is_turn) << name << "\n" << messages_of(report);
        EXPECT_EQ(named(show, name).is_address_known, is_address) << name << "\n" << messages_of(report);
    }
    EXPECT_TRUE(named(show, "Flat").is_place_known);
    EXPECT_NEAR(named(show, "Flat").position_m.x, 7, 1e-5);
    EXPECT_NEAR(named(show, "Turned").rotation_deg.y, 90, 1e-3);
    EXPECT_EQ(named(show, "Odd universe").address, 0) << "of no other's light";
}

// Each fixture and each change is looked for among all objects.
TEST(PlotShow, ManyObjectsAreFoundSoon) {
    constexpr int kMany = 20'000;
    const std::clock_t begun = std::clock(); // of the processor, for others may have it
    std::string fixtures;
    for (int k = 0; k < kMany; ++k) fixtures += fixture_xml(100 + k, "Spot", kIdentity + "{0,0,0}", "");
    const fs::path folder = scratch("many_objects");
    write_mvr(folder / "plot.mvr", small_xml(fixtures));
    Report report;
    const Show show = opened(folder / "plot.mvr", report);
    EXPECT_EQ(show.fixtures.size(), 10'000u);
    Plot plot = show.plot->plot;
    std::vector<ChangeEntry> changes(kMany);
    for (int k = 0; k < kMany; ++k) {
        changes[static_cast<std::size_t>(k)].uuid = uuid(100 + k);
        changes[static_cast<std::size_t>(k)].position_m = glm::vec3(static_cast<float>(k), 0, 1);
    }
    apply_changes(plot, changes, glm::dvec3(0), report);
    expect_near(glm::vec3(plot.objects.back().world[3]), {kMany - 1, 0, 1});
    const auto took_s = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    EXPECT_LT(took_s, 15.0); // minutes, each against all
}

TEST(PlotShow, ModesOfManyNamesAreNotAllComparedWithAllModes) {
    constexpr int kFixtures = 400;
    std::string fixtures;
    for (int k = 0; k < kFixtures; ++k)
        fixtures += fixture_xml(20 + k, "Odd", kIdentity + "{0,0,0}", "", "Head.gdtf",
                                "standart " + std::to_string(k % 200)); // each twice
    Report report;
    const Show show = opened_xml("many_modes", small_xml(fixtures), report);
    ASSERT_EQ(show.fixtures.size(), static_cast<std::size_t>(kFixtures));
    int said = 0;
    for (const Message& message : report.messages)
        said += message.what.find("no mode '") != std::string::npos;
    EXPECT_EQ(said, 100);
    EXPECT_TRUE(says(report, {"no mode 'standart 99'", "it gets 'Standard' (2 fixtures)"}));
    EXPECT_TRUE(says(report, {"200 more fixtures name other modes", "they get the first"}))
        << messages_of(report);
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
    type.modes[0].name = "Mode 1 - Standard 16 bit";
    type.modes[1].name = "Mode 2 - Reduced 8 bit"; // fewer letters
    type.modes[2].name = "Mode 16";
    EXPECT_EQ(nearest("1"), 0);
    EXPECT_EQ(nearest("2"), 1);
    EXPECT_EQ(nearest("Standard, 16 bit"), 0);
    EXPECT_EQ(nearest("16"), 2);
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
    const auto unhung = [](const Report& of) {
        return std::any_of(of.messages.begin(), of.messages.end(), [](const Message& message) {
            return message.what.find("ChildPosition") != std::string::npos;
        });
    };
    EXPECT_FALSE(unhung(report));
    std::string nowhere = child;
    nowhere.replace(nowhere.find("Base.Yoke.Head"), 14, "Base.Nothing");
    Report missing;
    opened_xml("nowhere",
               small_xml(fixture_xml(20, "Spot", kIdentity + "{1000,0,6000}",
                                     "<Addresses><Address>2.17</Address></Addresses>" + nowhere)),
               missing);
    EXPECT_TRUE(unhung(missing));
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

// A mesh of some MB may unpack to a gigabyte, and a plot has as many as it likes.
TEST(PlotShow, MeshesOfAPlotHaveAnEndTogether) {
    Report report;
    const std::string sails[] = {"<Geometry3D fileName=\"Sail.glb\"/>",
                                 "<Geometry3D fileName=\"Sail2.glb\"/>",
                                 "<Geometry3D fileName=\"Sail3.glb\"/>"};
    std::string objects;
    for (int k = 0; k < 3; ++k)
        objects += object_xml(40 + k, "Sail " + std::to_string(k), kIdentity + "{0,0,0}", sails[k]);
    const std::string glb = text_of(TinyGlb{}.bytes());
    const Show show =
        opened_xml("meshes", small_xml(objects, ""), report, {{"Sail2.glb", glb}, {"Sail3.glb", glb}});
    ASSERT_EQ(show.stage.instances.size(), 3u) << messages_of(report);
    const Mesh& mesh = show.stage.meshes[0];
    const std::uint64_t bytes = (mesh.positions.size() + mesh.normals.size()) * sizeof(glm::vec3) +
                                mesh.tangents.size() * sizeof(glm::vec4) +
                                mesh.uvs.size() * sizeof(glm::vec2) +
                                mesh.indices.size() * sizeof(std::uint32_t);
    const std::vector<bool> shown(show.plot->plot.objects.size(), true);
    for (const std::uint64_t most : {3 * bytes, 3 * bytes - 1, bytes, bytes - 1}) {
        Stage stage;
        Report said;
        ASSERT_TRUE(add_plot_stage(*show.plot, shown, {}, stage, said, {}, most).ok());
        EXPECT_EQ(stage.instances.size(), most / bytes) << most;
        EXPECT_EQ(stage.meshes.size(), most / bytes) << most;
        EXPECT_EQ(
            says(said, {std::to_string(3 - most / bytes) + " mesh file", "left out: the others need all"}),
            most < 3 * bytes)
            << messages_of(said);
    }
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

// One of them would take all cameras along.
TEST(PlotShow, WhatIsFarFromMostOfAPlotIsLeftOutByName) {
    Report report;
    const std::string sail = "<Geometry3D fileName=\"Sail.glb\"/>";
    const Show show = opened_xml("far",
                                 small_xml(fixture_xml(20, "A", kIdentity + "{0,0,6000}", "") +
                                           fixture_xml(21, "B", kIdentity + "{2000,0,6000}", "") +
                                           fixture_xml(22, "Lost", kIdentity + "{40000000,0,6000}", "") +
                                           object_xml(40, "Deck", kIdentity + "{0,0,0}", sail) +
                                           object_xml(41, "Moon", kIdentity + "{0,0,40000000}", sail)),
                                 report);
    ASSERT_EQ(show.fixtures.size(), 2u);
    EXPECT_EQ(show.fixtures[1].name, "B");
    ASSERT_EQ(show.stage.instances.size(), 1u);
    for (const Camera& camera : show.cameras) EXPECT_LT(glm::length(camera.position_m), 100) << camera.name;
    EXPECT_TRUE(says(report, {"1 fixture is left out, more than 10 km from most of the plot", "Lost"}))
        << messages_of(report);
    EXPECT_TRUE(says(report, {"objects more than 10 km from most of the plot are left out", "Moon"}))
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

} // namespace
} // namespace ghost::scene
