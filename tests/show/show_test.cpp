// SPDX-License-Identifier: Apache-2.0
#include "beam_groups/light_places.h"
#include "disk/files.h"
#include "light/bodies.h"
#include "show/show.h"
#include "show_file/show_toml.h"
#include "show_folder/load_show.h"
#include "support/tiny_glb.h"

#include <cmath>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

// Lines 1 to 8 of every file below: what a show needs.
const std::string kHead = "[show]\n"
                          "name = \"Test\"\n"
                          "stage = \"tiny.glb\"\n"
                          "[[camera]]\n"
                          "name = \"house\"\n"
                          "position_m = [0, -10, 2]\n"
                          "target_m = [0, 0, 2]\n"
                          "\n";
// A fixture of 9 lines; line 1 is the header.
std::string fixture(const std::string& name, int address, const std::string& type = "Spot") {
    return "[[fixture]]\n"
           "name = \"" +
           name +
           "\"\n"
           "gdtf = \"Vari-Lite@VL2500_" +
           type +
           ".gdtf\"\n"
           "mode = \"Standard " +
           (type == "Spot" ? "22" : "15") +
           " channels\"\n"
           "universe = 1\n"
           "address = " +
           std::to_string(address) +
           "\n"
           "position_m = [1, 2, 6]\n"
           "\n\n";
}

ParsedShow parse(const std::string& text, Report& report) {
    auto parsed = parse_show(text, "show/show.toml", report);
    EXPECT_TRUE(parsed.ok()) << parsed.error().text();
    return parsed.ok() ? std::move(*parsed) : ParsedShow{};
}

std::string all_text(const Report& report) {
    std::string text;
    for (const Message& message : report.messages) text += message.where + ": " + message.what + "\n";
    return text;
}

// The one message of the report.
void expect_message(const Report& report, Severity severity, int line, const std::string& part) {
    ASSERT_EQ(report.messages.size(), 1u) << all_text(report);
    EXPECT_EQ(report.messages[0].severity, severity) << all_text(report);
    const std::string where = report.messages[0].where;
    EXPECT_EQ(where.substr(where.rfind(':') + 1), std::to_string(line)) << all_text(report);
    EXPECT_NE(where.find("show.toml:"), std::string::npos) << where;
    EXPECT_NE(report.messages[0].what.find(part), std::string::npos) << all_text(report);
}

// A folder with kHead's stage and both fixture types.
fs::path show_folder(const std::string& name, const std::string& text) {
    const fs::path folder = scratch_folder(name);
    written(folder / "tiny.glb", TinyGlb{}.bytes());
    for (const char* type : {"Spot", "Wash"}) {
        const std::string file = std::string("Vari-Lite@VL2500_") + type + ".gdtf";
        fs::copy_file(fs::path("assets/fixtures") / file, folder / file);
    }
    written(folder / "show.toml", text);
    return folder;
}

Show load(const fs::path& path, Report& report) {
    auto show = load_show(path, true, report);
    EXPECT_TRUE(show.ok()) << show.error().text();
    // What is not used of the fixture files is no matter of the show.
    std::erase_if(report.messages, [](const Message& message) {
        return message.severity == Severity::note && message.where.find(".gdtf: ") != std::string::npos;
    });
    return show.ok() ? std::move(*show) : Show{};
}

TEST(ShowToml, Everything) {
    const std::string text = R"(
[show]
name = "Hall"
stage = "hall.glb"
recording = "hall.show"
begin_s = 12.5
sound = "song.flac"
sound_offset_s = -1.5
ambient_lux = 1.5
[haze]
extinction_per_m = 0.02
albedo = 0.9
forward_g = 0.7
back_g = -0.5
back_weight = 0.1
[[camera]]
name = "house"
position_m = [1, -15.5, 3]
target_m = [0, 3, 4]
fov_y_deg = 20.5
size = [1024, 300]
ev100 = 7.5
foreign_passes = "cycles/passes.toml"
[[camera]]
name = "close"
position_m = [0, 0, 0]
target_m = [0, 3, 4]
exposure = "auto"
[[fixture]]
name = "Runner"
gdtf = "runner.gdtf"
mode = "wide"
universe = 2
address = 500
rotation_deg = [180, 0, 90]
home_deg = [-90, 45]
track = { stops_m = [[0, 0, 5], [1, 0, 5], [2, 0, 5]], universe = 3, address = 7 }
)";
    Report report;
    const ParsedShow parsed = parse(text, report);
    const Show& show = parsed.show;
    EXPECT_TRUE(report.messages.empty()) << all_text(report);
    EXPECT_EQ(show.name, "Hall");
    EXPECT_EQ(show.folder, "show");
    EXPECT_EQ(show.stage_file, "show/hall.glb");
    EXPECT_EQ(show.recording, "show/hall.show");
    EXPECT_EQ(show.begin_s, 12.5);
    EXPECT_EQ(show.sound.file, "show/song.flac");
    EXPECT_EQ(show.sound.offset_s, -1.5);
    EXPECT_FLOAT_EQ(show.ambient_lux, 1.5f);
    EXPECT_FLOAT_EQ(show.haze.extinction_per_m, 0.02f);
    EXPECT_FLOAT_EQ(show.haze.albedo, 0.9f);
    EXPECT_FLOAT_EQ(show.haze.forward_g, 0.7f);
    EXPECT_FLOAT_EQ(show.haze.back_g, -0.5f);
    EXPECT_FLOAT_EQ(show.haze.back_weight, 0.1f);
    ASSERT_EQ(show.cameras.size(), 2u);
    EXPECT_EQ(show.cameras[0].position_m, glm::vec3(1, -15.5f, 3));
    EXPECT_FLOAT_EQ(show.cameras[0].fov_y_deg, 20.5f);
    EXPECT_EQ(show.cameras[0].width, 1024);
    EXPECT_EQ(show.cameras[0].height, 300);
    EXPECT_FLOAT_EQ(show.cameras[0].ev100, 7.5f);
    EXPECT_FALSE(show.cameras[0].auto_exposure);
    EXPECT_EQ(show.cameras[0].foreign_passes, "show/cycles/passes.toml");
    EXPECT_TRUE(show.cameras[1].auto_exposure);
    ASSERT_EQ(show.fixtures.size(), 1u);
    const PatchedFixture& runner = show.fixtures[0];
    EXPECT_EQ(runner.gdtf, "runner.gdtf");
    EXPECT_EQ(parsed.sources[0].mode, "wide");
    EXPECT_EQ(runner.universe, 2);
    EXPECT_EQ(runner.address, 500);
    EXPECT_EQ(runner.rotation_deg, glm::vec3(180, 0, 90));
    EXPECT_FLOAT_EQ(runner.home_pan_deg, -90);
    EXPECT_FLOAT_EQ(runner.home_tilt_deg, 45);
    ASSERT_TRUE(runner.track.has_value());
    EXPECT_EQ(runner.track->universe, 3);
    EXPECT_EQ(runner.track->address, 7);
    EXPECT_EQ(runner.stops_m().size(), 3u);
    EXPECT_EQ(runner.position_m, glm::vec3(0, 0, 5));
}

struct Wrong {
    const char* title;
    std::string text;
    int line;
    Severity severity;
    const char* part;
};

class ShowTomlWrong : public testing::TestWithParam<Wrong> {};

TEST_P(ShowTomlWrong, NamesTheLineAndKeepsTheRest) {
    Report report;
    const ParsedShow parsed = parse(GetParam().text, report);
    expect_message(report, GetParam().severity, GetParam().line, GetParam().part);
    ASSERT_FALSE(parsed.show.cameras.empty());
    EXPECT_EQ(parsed.show.cameras[0].name, "house");
    EXPECT_EQ(parsed.show.cameras[0].target_m, glm::vec3(0, 0, 2));
}

const Wrong kWrong[] = {
    {"unknown_key", kHead + "[haze]\nalbedoo = 1\n", 10, Severity::warning,
     "unknown key 'albedoo', did you mean 'albedo'?"},
    {"unknown_fixture_key", kHead + fixture("a", 1) + "postion_m = [0, 0, 0]\n", 18, Severity::warning,
     "unknown key 'postion_m', did you mean 'position_m'?"},
    {"unknown_section", kHead + "[hase]\nalbedo = 1\n", 9, Severity::warning,
     "unknown key 'hase', did you mean 'haze'?"},
    {"unlike_anything", kHead + "[haze]\nqqqqqqqqqqqqq = 1\n", 10, Severity::warning, "expected one of"},
    {"wrong_type", kHead + "[haze]\nalbedo = \"much\"\n", 10, Severity::error,
     "[haze] albedo is 'much', expected a number from 0 to 1"},
    {"out_of_range", kHead + "[haze]\n\nalbedo = 1.5\n", 11, Severity::error,
     "expected a number from 0 to 1"},
    {"not_a_number", kHead + "[haze]\nextinction_per_m = nan\n", 10, Severity::error,
     "expected a number from 0 to 10"},
    {"offset_of_no_sound", "[show]\nsound_offset_s = 1\n" + kHead.substr(kHead.find('\n') + 1), 2,
     Severity::warning, "there is no sound"},
    {"beginning_of_no_recording", "[show]\nbegin_s = 1\n" + kHead.substr(kHead.find('\n') + 1), 2,
     Severity::warning, "there is no recording"},
    {"infinite", kHead + "[haze]\nextinction_per_m = inf\n", 10, Severity::error,
     "expected a number from 0 to 10"},
    {"two_concentrations", kHead + "[haze]\nextinction_per_m = 0.1\nconcentration_mg_per_m3 = 5\n", 11,
     Severity::warning, "is not used"},
    {"vector_of_two", kHead + "[[camera]]\nname = \"b\"\nposition_m = [1, 2]\ntarget_m = [0, 0, 0]\n", 11,
     Severity::error, "expected three numbers [x, y, z]"},
    {"vector_with_nan", kHead + "[[camera]]\nname = \"b\"\nposition_m = [1, nan, 2]\ntarget_m = [0, 0, 0]\n",
     11, Severity::error, "expected three numbers"},
    {"camera_without_target", kHead + "[[camera]]\nname = \"b\"\nposition_m = [1, 2, 3]\n", 9,
     Severity::error, "target_m is missing"},
    {"camera_looks_at_itself",
     kHead + "[[camera]]\nname = \"b\"\nposition_m = [1, 2, 3]\ntarget_m = [1, 2, 3]\n", 12, Severity::error,
     "expected another point"},
    {"exposure",
     kHead +
         "[[camera]]\nname = \"b\"\nposition_m = [1, 2, 3]\ntarget_m = [0, 0, 0]\nexposure = \"bright\"\n",
     13, Severity::error, "expected \"auto\""},
    {"picture_too_large",
     kHead + "[[camera]]\nname = \"b\"\nposition_m = [1, 2, 3]\ntarget_m = [0, 0, 0]\nsize = [1024, 20000]\n",
     13, Severity::error, "size is [ 1024, 20000 ], expected 2 whole numbers in brackets"},
    {"camera_name_twice",
     kHead + "[[camera]]\nposition_m = [1, 2, 3]\ntarget_m = [0, 0, 0]\nname = \"house\"\n", 12,
     Severity::error, "'house' is taken by line 5"},
    {"name_that_leaves_the_folder",
     kHead + "[[camera]]\nposition_m = [1, 2, 3]\ntarget_m = [0, 0, 0]\nname = \"../x\"\n", 12,
     Severity::warning, "cannot name a file"},
    {"one_camera_table", kHead + "[fixture]\nname = \"x\"\n", 9, Severity::error, "write [[fixture]]"},
    {"fixture_name_twice", kHead + fixture("a", 1) + fixture("a", 100), 19, Severity::error,
     "'a' is taken by line 10"},
    {"address_beyond_512", kHead + fixture("a", 513), 14, Severity::error,
     "expected a whole number from 0 to 512"},
    {"address_as_text",
     kHead + "[[fixture]]\nname = \"a\"\ngdtf = \"x.gdtf\"\naddress = \"1.17\"\nposition_m = [0, 0, 5]\n", 12,
     Severity::error, "expected a whole number from 0 to 512"},
    {"fixture_without_address",
     kHead + "[[fixture]]\nname = \"a\"\ngdtf = \"x.gdtf\"\nposition_m = [0, 0, 5]\n", 9, Severity::warning,
     "not patched"},
    {"fixture_without_gdtf", kHead + "[[fixture]]\nname = \"a\"\naddress = 1\nposition_m = [0, 0, 5]\n", 9,
     Severity::error, "gdtf is missing"},
    {"fixture_without_position", kHead + "[[fixture]]\nname = \"a\"\naddress = 1\ngdtf = \"x.gdtf\"\n", 9,
     Severity::error, "position_m is missing"},
    {"track_with_one_stop",
     kHead + fixture("a", 1) + "track = { stops_m = [[0, 0, 5]], universe = 1, address = 99 }\n", 18,
     Severity::error, "a list of 2 to 64 points"},
};

INSTANTIATE_TEST_SUITE_P(All, ShowTomlWrong, testing::ValuesIn(kWrong),
                         [](const auto& wrong) { return std::string(wrong.param.title); });

TEST(ShowToml, NamesThatNameNoFileLeaveTheOthersAlone) {
    Report report;
    const auto parsed = parse_show(kHead + fixture("Bar 1/2", 1) + fixture("Bar 1-2", 30) +
                                       fixture("Bar 1:2", 60) + fixture("Bar 3", 90),
                                   "s.toml", report);
    ASSERT_TRUE(parsed.ok());
    const auto& fixtures = parsed->show.fixtures;
    ASSERT_EQ(fixtures.size(), 4u);
    EXPECT_EQ(fixtures[0].name, "Bar 1-2 (2)");
    EXPECT_EQ(fixtures[0].written_name, "Bar 1/2");
    EXPECT_EQ(fixtures[1].name, "Bar 1-2");
    EXPECT_EQ(fixtures[1].written_name, "");
    EXPECT_EQ(fixtures[2].name, "Bar 1-2 (3)");
    EXPECT_EQ(fixtures[2].written_name, "Bar 1:2");
    EXPECT_EQ(fixtures[3].written_name, "");
}

TEST(ShowToml, WhatCannotBeShownIsAnError) {
    Report report;
    const auto broken = parse_show("[show]\nname = \"x\nstage = 1\n", "s.toml", report);
    ASSERT_FALSE(broken.ok());
    EXPECT_EQ(broken.error().where, "s.toml:2");
    EXPECT_NE(broken.error().what.find("not TOML"), std::string::npos);
}

TEST(ShowToml, MotionIsTheMachinesUnlessTheShowSaysOtherwise) {
    const auto with = [](const std::string& line, Report& report) {
        std::string text = kHead;
        text.insert(text.find("[show]\n") + 7, line);
        return parse(text, report).show.motion;
    };
    Report report;
    EXPECT_EQ(with("", report), fixture::Motion::as_the_machine);
    EXPECT_EQ(with("motion = \"machine\"\n", report), fixture::Motion::as_the_machine);
    EXPECT_EQ(with("motion = \"commanded\"\n", report), fixture::Motion::as_commanded);
    EXPECT_TRUE(report.messages.empty()) << all_text(report);
    EXPECT_EQ(with("motion = \"slow\"\n", report), fixture::Motion::as_the_machine);
    expect_message(report, Severity::error, 2, "expected \"machine\"");
}

TEST(ShowToml, ConcentrationBecomesExtinction) {
    Report report;
    const ParsedShow parsed = parse(kHead + "[haze]\nconcentration_mg_per_m3 = 10\n", report);
    EXPECT_TRUE(report.messages.empty()) << all_text(report);
    EXPECT_FLOAT_EQ(parsed.show.haze.extinction_per_m, 0.045f);
}

TEST(ShowToml, SecondFixtureOfANameKeepsItsPlace) {
    Report report;
    const ParsedShow parsed = parse(kHead + fixture("a", 1) + fixture("a", 100), report);
    ASSERT_EQ(parsed.show.fixtures.size(), 2u);
    EXPECT_EQ(parsed.show.fixtures[1].name, "a (2)");
    EXPECT_EQ(parsed.show.fixtures[1].address, 100);
}

TEST(Show, LoadsFromItsFolderOrItsFile) {
    const fs::path folder =
        show_folder("good", kHead + fixture("a", 1) + fixture("b", 23) + fixture("c", 45, "Wash"));
    for (const fs::path& path : {folder, folder / "show.toml"}) {
        Report report;
        const Show show = load(path, report);
        EXPECT_FALSE(report.lost_anything()) << all_text(report);
        ASSERT_EQ(show.fixtures.size(), 3u);
        ASSERT_TRUE(show.fixtures[0].type);
        EXPECT_EQ(show.fixtures[0].type, show.fixtures[1].type) << "one file is loaded once";
        EXPECT_NE(show.fixtures[0].type, show.fixtures[2].type);
        EXPECT_EQ(show.stage.drawn_triangles(), 1u);
    }
    Report report;
    const auto without = load_show(folder, false, report);
    ASSERT_TRUE(without.ok());
    EXPECT_TRUE(without->stage.instances.empty());
    EXPECT_FALSE(load_show(folder / "absent", true, report).ok());
}

TEST(Show, TwoFixturesOnOneAddress) {
    const fs::path folder = show_folder("overlap", kHead + fixture("a", 1) + fixture("b", 22));
    Report report;
    (void)load(folder, report);
    expect_message(report, Severity::error, 23, "'b' shares universe 1 channels 22 to 22 with 'a' (line 14)");
}

TEST(Show, TheSamePatchTwiceIsOnlyAWarning) {
    Report report;
    (void)load(show_folder("multipatch", kHead + fixture("a", 1) + fixture("b", 1)), report);
    expect_message(report, Severity::warning, 23, "they will do the same");
}

TEST(Show, TrackOnAFixturesAddress) {
    Report report;
    (void)load(
        show_folder("track",
                    kHead + fixture("a", 1) +
                        "[[fixture]]\nname = \"b\"\ngdtf = \"Vari-Lite@VL2500_Spot.gdtf\"\naddress = 101\n"
                        "track = { stops_m = [[0, 0, 5], [1, 0, 5]], universe = 1, address = 22 }\n"),
        report);
    expect_message(report, Severity::error, 22, "shares universe 1 channels 22 to 22");
}

TEST(Show, FixturePastTheEndOfItsUniverse) {
    Report report;
    (void)load(show_folder("past", kHead + fixture("a", 500)), report);
    expect_message(report, Severity::warning, 14, "runs past channel 512");
}

TEST(Show, ModeThatDoesNotExist) {
    std::string text = kHead + fixture("a", 1);
    text.replace(text.find("22 channels"), 11, "22 chanels");
    Report report;
    const Show show = load(show_folder("mode", text), report);
    expect_message(report, Severity::error, 12, "did you mean 'Standard 22 channels'?");
    EXPECT_TRUE(show.fixtures[0].type) << "the first mode stands in";
}

TEST(Show, MissingFilesAreNamedAndTheRestStays) {
    std::string text = kHead + fixture("a", 1) + fixture("b", 23);
    text.replace(text.find("tiny.glb"), 8, "tony.glb");
    text.replace(text.find("VL2500_Spot"), 11, "VL2600_Spot");
    text.insert(text.find("[[camera]]"), "recording = \"gone.show\"\nsound = \"gone.wav\"\n");
    Report report;
    const Show show = load(show_folder("missing", text), report);
    ASSERT_EQ(report.messages.size(), 4u) << all_text(report);
    const auto has = [&](const std::string& line, const std::string& part) {
        for (const Message& message : report.messages)
            if (message.where.ends_with("show.toml:" + line) &&
                message.what.find(part) != std::string::npos && message.severity == Severity::error)
                return true;
        return false;
    };
    EXPECT_TRUE(has("13", "VL2600_Spot.gdtf, did you mean 'Vari-Lite@VL2500_Spot.gdtf'?"))
        << all_text(report);
    EXPECT_TRUE(has("3", "tony.glb, did you mean 'tiny.glb'?")) << all_text(report);
    EXPECT_TRUE(has("4", "gone.show")) << all_text(report);
    EXPECT_TRUE(has("5", "gone.wav")) << all_text(report);
    EXPECT_FALSE(show.fixtures[0].type);
    EXPECT_TRUE(show.fixtures[1].type);
}

TEST(Show, FindsCamerasByName) {
    Report report;
    const ParsedShow parsed =
        parse(kHead + "[[camera]]\nname = \"high\"\nposition_m = [1, 2, 3]\ntarget_m = [0, 0, 0]\n", report);
    EXPECT_EQ(*parsed.show.find_camera("high"), 1u);
    EXPECT_EQ(*parsed.show.find_camera(""), 0u);
    const auto wrong = parsed.show.find_camera("hgih");
    ASSERT_FALSE(wrong.ok());
    EXPECT_NE(parsed.show.find_camera("hous").error().what.find("did you mean 'house'?"), std::string::npos);
    EXPECT_NE(wrong.error().what.find("'house', 'high'"), std::string::npos);
}

void expect_near(const glm::vec3& value, const glm::vec3& expected) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], 1e-4f) << "component " << k;
}

TEST(Placement, CameraAxes) {
    Camera camera;
    camera.position_m = {0, -10, 2};
    camera.target_m = {0, 0, 2};
    glm::mat4 matrix = camera_to_world(camera);
    expect_near(matrix[0], {1, 0, 0});  // right is house right
    expect_near(matrix[1], {0, 0, 1});  // up
    expect_near(matrix[2], {0, -1, 0}); // backward, to the house
    expect_near(matrix[3], {0, -10, 2});
    camera.target_m = {0, -10, 0}; // straight down
    matrix = camera_to_world(camera);
    expect_near(matrix[0], {1, 0, 0});
    expect_near(matrix[1], {0, 1, 0});
    expect_near(matrix[2], {0, 0, 1});
}

TEST(Placement, RotationIsAboutXThenYThenZ) {
    PatchedFixture fixture;
    fixture.position_m = {1, 2, 3};
    fixture.rotation_deg = {90, 0, 90};
    const glm::mat4 matrix = fixture_to_world(fixture, 0);
    // Down (-Z): about X by 90 -> +Y; about Z by 90 -> -X.
    expect_near(matrix * glm::vec4(0, 0, -1, 0), {-1, 0, 0});
    expect_near(matrix[3], {1, 2, 3});
    expect_near(light_position_m(fixture, 0), {1, 2, 3}); // no type: where it hangs
}

TEST(Placement, LightSitsInTheTiltAxis) {
    Report report;
    Show show = load(show_folder("pivot", kHead + fixture("a", 1)), report);
    PatchedFixture& spot = show.fixtures[0];
    // description.xml of our VL2500: yoke 0.105 m under the base, head 0.29 m under the yoke.
    expect_near(light_position_m(spot, 0), {1, 2, 6 - 0.395f});
    spot.rotation_deg = {180, 0, 0}; // on the floor
    expect_near(light_position_m(spot, 0), {1, 2, 6.395f});
    spot.track = Track{{{0, 0, 5}, {3, 0, 5}}, 1, 1};
    spot.rotation_deg = {0, 0, 0};
    expect_near(light_position_m(spot, 1), {3, 0, 5 - 0.395f});
}

struct Extent {
    glm::vec3 low{1e9f};
    glm::vec3 high{-1e9f};
};

Extent extent_of(const Stage& stage, int fixture) {
    Extent extent;
    for (const Instance& instance : stage.instances) {
        if (instance.fixture != fixture) continue;
        for (const glm::vec3& position : stage.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            const glm::vec3 world(instance.world * glm::vec4(position, 1));
            extent.low = glm::min(extent.low, world);
            extent.high = glm::max(extent.high, world);
        }
    }
    return extent;
}

TEST(Bodies, HangWhereTheFixtureHangsAndTurnWithTheHead) {
    Report report;
    Show show = load(show_folder("bodies", kHead + fixture("a", 1) + fixture("b", 23)), report);
    Stage stage = stage_with_bodies(show, report);
    EXPECT_FALSE(report.lost_anything()) << all_text(report);
    EXPECT_EQ(stage.instances[0].fixture, kNone) << "the stage itself stays";
    const std::size_t meshes = stage.meshes.size();
    show.fixtures.push_back(show.fixtures[0]);
    EXPECT_EQ(stage_with_bodies(show, report).meshes.size(), meshes) << "meshes of one type are stored once";
    show.fixtures.pop_back();

    const Extent down = extent_of(stage, 0);
    EXPECT_NEAR(down.high.z, 6.0f, 0.02f); // the base hangs from its origin
    EXPECT_GT(down.low.z, 5.0f);
    EXPECT_LT(down.low.z, 5.6f);
    EXPECT_NEAR(0.5f * (down.low.x + down.high.x), 1.0f, 0.05f);
    // Tilted by 90 degrees the head reaches out sideways (+y) instead of down.
    show.fixtures[0].home_tilt_deg = 90;
    stage = stage_with_bodies(show, report);
    const Extent level = extent_of(stage, 0);
    EXPECT_GT(level.low.z, down.low.z + 0.05f);
    EXPECT_GT(level.high.y, down.high.y + 0.05f);
    const Extent other = extent_of(stage, 1);
    expect_near(other.low, down.low);
}

TEST(Bodies, ModelWithoutAMeshHasItsSize) {
    fixture::Type type;
    type.name = "box";
    type.models.push_back({.name = "Body", .size_m = {0.4f, 0.2f, 0.6f}, .primitive = "Base1_1"});
    fixture::Geometry geometry;
    geometry.name = "Base";
    geometry.model = 0;
    type.geometries.push_back(geometry);
    fixture::Mode mode;
    mode.name = "only";
    mode.nodes.push_back({.name = "Base", .geometry = 0, .parent = -1, .model = 0});
    mode.parts = {0};
    mode.footprint = {0};
    type.modes.push_back(mode);
    Show show;
    show.fixtures.emplace_back();
    show.fixtures[0].name = "x";
    show.fixtures[0].position_m = {1, 2, 3};
    show.fixtures[0].type = std::make_shared<const fixture::Type>(type);
    Report report;
    const Stage stage = stage_with_bodies(show, report);
    EXPECT_TRUE(report.messages.empty()) << all_text(report);
    const Extent extent = extent_of(stage, 0);
    expect_near(extent.low, {0.8f, 1.9f, 2.4f});
    expect_near(extent.high, {1.2f, 2.1f, 3.0f});
    EXPECT_LE(stage.drawn_triangles(), 100u) << "a stand-in is cheap";
    for (const Mesh& mesh : stage.meshes)
        for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
            const glm::vec3& a = mesh.positions[mesh.indices[k]];
            const glm::vec3 face =
                glm::cross(mesh.positions[mesh.indices[k + 1]] - a, mesh.positions[mesh.indices[k + 2]] - a);
            EXPECT_GT(glm::dot(face, mesh.normals[mesh.indices[k]]), 0.0f) << "wound outwards";
        }
}

TEST(Show, TheDemoShowIsWhole) {
    Report report;
    const auto show = load_show("assets/demo", true, report);
    ASSERT_TRUE(show.ok()) << show.error().text();
    EXPECT_FALSE(report.lost_anything()) << all_text(report);
    EXPECT_EQ(show->cameras.size(), 3u);
    ASSERT_EQ(show->fixtures.size(), 10u);
    const Stage stage = stage_with_bodies(*show, report);
    EXPECT_FALSE(report.lost_anything()) << all_text(report);
    for (int k = 0; k < 10; ++k) EXPECT_LT(extent_of(stage, k).low.z, 6.5f) << k;
}

// What a person did, not what the parser saw.
TEST(ShowToml, a_slip_of_the_pen_is_said_in_words_with_its_line) {
    const auto said = [](const std::string& text) {
        Report report;
        const auto parsed = parse_show(text, "show/show.toml", report);
        return parsed.ok() ? std::string() : parsed.error().text();
    };
    EXPECT_TRUE(said("[show]\nname = \"a\nstage = 1\n")
                    .starts_with("show/show.toml:2: is not TOML: a quotation mark is missing"));
    EXPECT_TRUE(said("[show]\n[[camera]\nname = \"a\"\n")
                    .starts_with("show/show.toml:2: is not TOML: a bracket ] is missing"));
    EXPECT_TRUE(said("[show]\nname = a\n")
                    .starts_with("show/show.toml:2: is not TOML: the value is neither a number nor true nor "
                                 "false; text needs"));
    EXPECT_NE(said("[show]\nsize = [1, 2\n").find("is missing"), std::string::npos)
        << said("[show]\nsize = [1, 2\n");
    EXPECT_NE(said("[show]\nname = \"a\"\nname = \"b\"\n").find("twice"), std::string::npos)
        << said("[show]\nname = \"a\"\nname = \"b\"\n");
}

// The other faults are said, and it opens: the cameras are made from where the fixtures hang.
TEST(ShowToml, a_show_without_a_camera_opens_and_says_all_of_its_faults) {
    const fs::path folder = fs::path(testing::TempDir()) / "no_camera";
    fs::create_directories(folder);
    ASSERT_TRUE(
        write_file_atomic(folder / "show.toml", "[show]\nname = \"a\"\nstagf = 2\n" + fixture("Spot 1", 1))
            .ok());
    Report report;
    const auto show = load_show(folder, true, report);
    ASSERT_TRUE(show.ok()) << show.error().text();
    ASSERT_FALSE(show->cameras.empty());
    EXPECT_EQ(show->cameras.front().name, "house");
    const std::string all = all_text(report);
    EXPECT_NE(all.find("has no [[camera]]: three are made"), std::string::npos) << all;
    EXPECT_NE(all.find("unknown key 'stagf'"), std::string::npos) << all;
    EXPECT_NE(all.find("Spot.gdtf"), std::string::npos) << all;
}

} // namespace
} // namespace ghost::scene
