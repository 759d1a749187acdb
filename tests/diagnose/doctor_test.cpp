// SPDX-License-Identifier: Apache-2.0
// The import doctor: each fault of a small plot is found, with its place, and none hides another.
#include "support/mvr_files.h"

#include "diagnose/doctor.h"
#include "diagnose/doctor_show.h"
#include "diagnose/private/doctor_patch.h"
#include "diagnose/private/doctor_substitute.h"
#include "disk/files.h"
#include "show_folder/load_show.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

std::string channel_xml(int offset, const std::string& attribute) {
    return "<DMXChannel Offset=\"" + std::to_string(offset) +
           "\" Geometry=\"Beam\"><LogicalChannel Attribute=\"" + attribute + "\"><ChannelFunction Name=\"" +
           attribute + "\" Attribute=\"" + attribute + "\"/></LogicalChannel></DMXChannel>\n";
}

// A fixture with a mode for each of these lengths: "M4", "M8" ..
std::string gdtf(const std::string& name, const std::vector<int>& lengths, bool has_beam = true,
                 const std::string& other = "Control") {
    std::string modes;
    for (const int length : lengths) {
        modes += "<DMXMode Name=\"M" + std::to_string(length) + "\" Geometry=\"Base\"><DMXChannels>\n";
        for (int k = 1; k <= length; ++k)
            modes += channel_xml(k, k == 1 && has_beam ? "Dimmer" : other + std::to_string(k));
        modes += "</DMXChannels></DMXMode>";
    }
    const std::string xml = "<?xml version=\"1.0\"?>\n<GDTF DataVersion=\"1.2\"><FixtureType Name=\"" + name +
                            "\" Manufacturer=\"Test\">\n<Geometries><Geometry Name=\"Base\">" +
                            (has_beam ? "<Beam Name=\"Beam\"/>" : "<Geometry Name=\"Beam\"/>") +
                            "</Geometry></Geometries>\n<DMXModes>" + modes +
                            "</DMXModes></FixtureType></GDTF>";
    const auto zip = fixture::make_zip({{"description.xml", xml}});
    return {zip.begin(), zip.end()};
}

// address: "" for none.
std::string lamp(int number, const std::string& spec, const std::string& mode, const std::string& address,
                 const std::string& more = "") {
    return "<Fixture uuid=\"" + uuid(number) + "\" name=\"Lamp " + std::to_string(number) + "\"><GDTFSpec>" +
           spec + "</GDTFSpec><GDTFMode>" + mode + "</GDTFMode>" +
           (address.empty() ? "" : "<Addresses><Address break=\"0\">" + address + "</Address></Addresses>") +
           more + "</Fixture>\n";
}

class Doctor : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(::testing::TempDir()) /
                  (std::string("doctor_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::vector<Finding> check(const std::string& objects, Members members,
                               const FixtureOffers& offers = {}) {
        const auto bytes = mvr_bytes(small_xml(objects), std::move(members));
        std::ofstream(folder_ / "tiny.mvr", std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
        return check_file(folder_ / "tiny.mvr", offers);
    }
    static std::vector<Finding> check_file(const fs::path& file, const FixtureOffers& offers = {}) {
        Report report;
        const auto show = load_show(file, true, report);
        EXPECT_TRUE(show.ok());
        return show.ok() ? findings_of(*show, report, offers) : std::vector<Finding>{};
    }

    fs::path folder_;
};

std::vector<Finding> of_kind(const std::vector<Finding>& findings, const std::string& kind) {
    std::vector<Finding> result;
    std::copy_if(findings.begin(), findings.end(), std::back_inserter(result),
                 [&](const Finding& finding) { return finding.kind == kind; });
    return result;
}

// The only one of its kind.
Finding one(const std::vector<Finding>& findings, const std::string& kind) {
    const std::vector<Finding> found = of_kind(findings, kind);
    std::string all;
    for (const Finding& finding : findings)
        all += finding.kind + ": " + finding.where + ": " + finding.what + "\n";
    EXPECT_EQ(found.size(), 1u) << kind << " in\n" << all;
    return found.empty() ? Finding{} : found.front();
}

void expect_said(const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

TEST(doctor, takes_places_apart) {
    Place place = split_where("a b.mvr: GeneralSceneDescription.xml:120: Scene/Layers/Fixture 'x: 3: y'");
    EXPECT_EQ(place.file, "a b.mvr: GeneralSceneDescription.xml");
    EXPECT_EQ(place.line, 120);
    EXPECT_EQ(place.element, "Scene/Layers/Fixture 'x: 3: y'");
    place = split_where("VL.gdtf: description.xml:7");
    EXPECT_EQ(place.file, "VL.gdtf: description.xml");
    EXPECT_EQ(place.line, 7);
    EXPECT_EQ(place.element, "");
    place = split_where("VL.gdtf: description.xml: Wheels");
    EXPECT_EQ(place.file, "VL.gdtf: description.xml");
    EXPECT_EQ(place.line, 0);
    EXPECT_EQ(place.element, "Wheels");
    EXPECT_EQ(split_where("").file, "");
    EXPECT_EQ(split_where("a:99999999999999999999").line, 0);
}

TEST(doctor, knows_equal_faults) {
    EXPECT_EQ(fault_key("mesh 'a.glb' is not in the archive"),
              fault_key("mesh 'it's b' is not in the archive"));
    EXPECT_EQ(fault_key("the picture wheels/leaves.png is not there"),
              fault_key("the picture wheels/7.jpg is not there"));
    EXPECT_EQ(fault_key("needs 12 channels (3 fixtures)"), fault_key("needs 7 channels (1 fixture)"));
    EXPECT_EQ(fault_key("not shown: 'a', 'b', 'c' and 3 more"), fault_key("not shown: 'd', 'e' and 12 more"));
    EXPECT_NE(fault_key("no mode"), fault_key("no beam"));

    const std::vector<Finding> findings{
        {Severity::note, "reading", "a.gdtf: description.xml:3", "odd", "", 1},
        {Severity::error, "missing_media", "a.gdtf: description.xml:5", "the picture wheels/1.png is lost",
         "", 1},
        {Severity::error, "missing_media", "a.gdtf: description.xml:9", "the picture wheels/x.png is lost",
         "", 1}};
    const std::vector<FindingGroup> groups = grouped(findings);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(
        text_of(groups[0]),
        "error: a.gdtf: description.xml:5: the picture wheels/1.png is lost (and 1 more like it; line 9)");
    EXPECT_EQ(text_of(groups[1]), "note: a.gdtf: description.xml:3: odd");
}

TEST(doctor, takes_counts_out_of_sentences) {
    const Finding finding = finding_of({Severity::note, "x.mvr: y.xml:1",
                                        "the Position that Position names does not "
                                        "exist (87 times, first here)"});
    EXPECT_EQ(finding.kind, "missing_link");
    EXPECT_EQ(finding.times, 87);
    EXPECT_EQ(finding.what, "the Position that Position names does not exist");
}

TEST(doctor, names_of_fixtures) {
    EXPECT_GT(likeness("Robe Lighting@Robin Spiider.gdtf", "ogl_Robe@Robin_Spiider.gdtf"), kSameFixture);
    EXPECT_GT(likeness("Vari-Lite@VL2500 Spot.gdtf", "Varilite VL-2500 spot"), kSameFixture);
    EXPECT_LT(likeness("Vari-Lite@VL2500 Spot.gdtf", "Vari-Lite@VL3500 Spot.gdtf"), kSameFixture);
    EXPECT_LT(likeness("LED Lighting", "Robe Robin"), kLikeFixture);
    EXPECT_EQ(likeness("", "x"), 0);
    EXPECT_EQ(likeness("---", "..."), 0);
}

TEST_F(Doctor, says_nothing_of_a_sound_plot) {
    const auto findings = check(lamp(10, "Spot.gdtf", "M4", "1") + lamp(11, "Spot.gdtf", "M4", "5") +
                                    lamp(12, "Spot.gdtf", "M4", "9"),
                                {{"Spot.gdtf", gdtf("Spot", {4, 8})}});
    for (const Finding& finding : findings)
        EXPECT_EQ(finding.severity, Severity::note) << finding.where << ": " << finding.what;
}

TEST_F(Doctor, finds_every_fault_of_one_plot) {
    const std::string objects =
        lamp(10, "Spot.gdtf", "M4", "1") + lamp(11, "Spot.gdtf", "M4", "3") + // overlap, line 6
        lamp(12, "Spot.gdtf", "M4", "") +                                     // unpatched, line 7
        lamp(13, "Spot.gdtf", "M4", "1.511") +                                // past 512, line 8
        lamp(14, "Gone.gdtf", "M4", "2.1") +                                  // missing fixture, line 9
        lamp(15, "Box.gdtf", "M4", "3.1") +                                   // no beam, line 10
        lamp(16, "Spot.gdtf", "M4", "4.1", "<Gobo>leaves</Gobo><FixtureID>7</FixtureID>") + // line 11
        lamp(17, "Spot.gdtf", "M4", "4.1", "<FixtureID>7</FixtureID>") + // multipatch, number, line 12
        lamp(18, "Spot.gdtf", "M4", "4.11",
             "<Position>8BF13DD7-CBF4-415B-99E4-000000000000</Position>") + // line 13
        lamp(18, "Spot.gdtf", "M9", "4.21") +                               // UUID, mode, line 14
        "<SceneObject uuid=\"" +
        uuid(30) +
        "\" name=\"Deck\"><Geometries><Geometry3D fileName=\"deck.glb\"/>"
        "</Geometries></SceneObject>\n"; // mesh, line 15
    const auto findings =
        check(objects, {{"Spot.gdtf", gdtf("Spot", {4, 8})}, {"Box.gdtf", gdtf("Box", {4}, false)}});

    const Finding overlap = one(findings, "overlap");
    EXPECT_EQ(overlap.severity, Severity::warning);
    expect_said(overlap.where, {"tiny.mvr: GeneralSceneDescription.xml:6", "'Lamp 11'"});
    expect_said(overlap.what,
                {"'Lamp 10'", "channels 3 to 4 of universe 1", "GeneralSceneDescription.xml:5"});

    const Finding unpatched = one(findings, "unpatched");
    EXPECT_EQ(split_where(unpatched.where).line, 7);
    expect_said(unpatched.what, {"1 fixture has no address", "'Lamp 12'"});

    const Finding past = one(findings, "past_512");
    EXPECT_EQ(split_where(past.where).line, 8);
    expect_said(past.what, {"'Lamp 13'", "past channel 512", "next universe"});

    const Finding missing = one(findings, "missing_fixture_file");
    EXPECT_EQ(missing.severity, Severity::error);
    EXPECT_EQ(split_where(missing.where).line, 9);
    expect_said(missing.what, {"'Gone.gdtf' is not in the archive"});

    bool said = false;
    for (const Finding& finding : of_kind(findings, "no_beam"))
        said = said ||
               (split_where(finding.where).line == 10 && finding.what.find("'Lamp 15'") != std::string::npos);
    EXPECT_TRUE(said);

    const Finding number = one(findings, "duplicate_id");
    EXPECT_EQ(split_where(number.where).line, 12);
    expect_said(number.what, {"'7'", "'Lamp 16', 'Lamp 17'"});
    const Finding multipatch = one(findings, "multipatch");
    EXPECT_EQ(multipatch.severity, Severity::note);
    expect_said(multipatch.what, {"4.1", "'Lamp 16', 'Lamp 17'"});

    EXPECT_EQ(split_where(one(findings, "missing_link").where).line, 13);
    const Finding twice = one(findings, "duplicate_uuid");
    EXPECT_EQ(split_where(twice.where).line, 14);
    expect_said(twice.what, {uuid(18), "line 13"});
    const Finding mode = one(findings, "unknown_mode");
    EXPECT_EQ(split_where(mode.where).line, 14);
    expect_said(mode.what, {"'M9'", "it gets"});

    std::string media;
    for (const Finding& finding : of_kind(findings, "missing_media"))
        media += std::to_string(split_where(finding.where).line) + " " + finding.what + "\n";
    expect_said(media,
                {"11 gobo 'leaves' is not in the archive", "15 mesh 'deck.glb' is not in the archive"});
}

TEST_F(Doctor, overlaps_of_two_runs_are_one_line) {
    std::string objects;
    for (int k = 0; k < 8; ++k) objects += lamp(10 + k, "Spot.gdtf", "M4", std::to_string(1 + 4 * k));
    for (int k = 0; k < 8; ++k) objects += lamp(20 + k, "Wash.gdtf", "M4", std::to_string(3 + 4 * k));
    const auto findings =
        check(objects, {{"Spot.gdtf", gdtf("Spot", {4})}, {"Wash.gdtf", gdtf("Wash", {4})}});
    const Finding overlap = one(findings, "overlap");
    EXPECT_EQ(overlap.times, 15); // each wash with two spots, the last one with one
    expect_said(overlap.what, {"so do 14 more pairs"});
}

TEST_F(Doctor, a_declared_multipatch_is_no_fault) {
    const std::string second = "<Fixture uuid=\"" + uuid(11) + "\" name=\"B\" multipatch=\"" + uuid(10) +
                               "\"><GDTFSpec>Spot.gdtf</GDTFSpec><GDTFMode>M4</GDTFMode></Fixture>";
    const auto findings =
        check(lamp(10, "Spot.gdtf", "M4", "1") + second, {{"Spot.gdtf", gdtf("Spot", {4})}});
    for (const char* kind : {"multipatch", "overlap", "unpatched"})
        EXPECT_TRUE(of_kind(findings, kind).empty()) << kind;
}

TEST_F(Doctor, modes_that_the_patch_contradicts) {
    const auto row = [](const std::string& mode, int apart) {
        std::string objects;
        for (int k = 0; k < 5; ++k) objects += lamp(10 + k, "Spot.gdtf", mode, std::to_string(1 + apart * k));
        return objects;
    };
    const Members members{{"Spot.gdtf", gdtf("Spot", {4, 8})}};
    // Too long: each begins before the last one ends.
    Finding wrong = one(check(row("M8", 4), members), "wrong_mode_length");
    EXPECT_EQ(split_where(wrong.where).line, 5);
    expect_said(wrong.what, {"5 fixtures", "'M8' (8 channels)", "4 channels apart"});
    expect_said(wrong.advice, {"'M4'", "4 channels"});
    // Too short, and another mode has just that length.
    wrong = one(check(row("M4", 8), members), "wrong_mode_length");
    expect_said(wrong.advice, {"'M8'"});
    // No mode has it: too near is a fault all the same, room is not.
    wrong = one(check(row("M8", 5), members), "wrong_mode_length");
    expect_said(wrong.advice, {"no mode of this type has 5 channels"});
    EXPECT_TRUE(of_kind(check(row("M8", 10), members), "wrong_mode_length").empty());
    EXPECT_TRUE(of_kind(check(row("M8", 8), members), "wrong_mode_length").empty());
}

TEST_F(Doctor, suggests_a_substitute_with_the_mode_that_fits) {
    std::string objects;
    for (int k = 0; k < 4; ++k)
        objects += lamp(10 + k, "Test@Super Spot 300.gdtf", "Something", std::to_string(1 + 8 * k));
    const Members members{{"Other@Super_Spot_300.gdtf", gdtf("Super Spot 300", {4, 8})},
                          {"Test@Wash 5.gdtf", gdtf("Wash 5", {8})}};
    Finding missing = one(check(objects, members), "missing_fixture_file");
    EXPECT_EQ(split_where(missing.where).line, 5);
    expect_said(missing.advice, {"'Other@Super_Spot_300.gdtf' of the archive", "'M8' has the 8 channels",
                                 "[[substitute]] for = \"Test@Super Spot 300.gdtf\"", "mode = \"M8\""});

    // From elsewhere, by what stands in the file.
    FixtureOffers offers;
    offers.names = {"x7.gdtf", "Test Super Spot 300"};
    offers.files = {"/lib/x7.gdtf", "/lib/x7.gdtf"};
    int loaded = 0;
    offers.load = [&](std::size_t) {
        ++loaded;
        const std::string bytes = gdtf("Super Spot 300", {4, 8});
        auto type = fixture::load_gdtf(
            Bytes(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()), "x7.gdtf");
        return std::make_shared<const fixture::Type>(std::move(type->type));
    };
    missing = one(check(objects, {}, offers), "missing_fixture_file");
    EXPECT_EQ(loaded, 1);
    expect_said(missing.advice, {"'/lib/x7.gdtf' seems to be this fixture", "'M8' has the 8 channels"});
}

TEST_F(Doctor, suggests_a_lamp_that_shines) {
    const Members members{{"Test@Spot 300.gdtf", gdtf("Spot 300", {4}, false)},
                          {"Other@Spot 300.gdtf", gdtf("Spot 300", {4, 8}, false)},
                          {"Third@Spot 300.gdtf", gdtf("Spot 300", {8, 4})}};
    const std::string objects =
        lamp(10, "Test@Spot 300.gdtf", "M4", "1") + lamp(11, "Test@Spot 300.gdtf", "M4", "5");
    bool said = false;
    for (const Finding& finding : of_kind(check(objects, members), "no_beam"))
        if (finding.what.find("2 fixtures of 'Test@Spot 300.gdtf'") != std::string::npos) {
            said = true;
            expect_said(finding.advice, {"'Third@Spot 300.gdtf' of the archive", "'M4' has the 4 channels"});
        }
    EXPECT_TRUE(said);
}

// As Capture writes all of its heads.
TEST_F(Doctor, suggests_a_lamp_for_one_that_hands_alone_light) {
    const Members members{{"Test@Spot 300.gdtf", gdtf("Spot 300", {4}, false, "Dimmer")},
                          {"Other@Spot 300.gdtf", gdtf("Spot 300", {4, 8}, false, "Dimmer")},
                          {"Third@Spot 300.gdtf", gdtf("Spot 300", {8, 4})}};
    bool said = false;
    for (const Finding& finding :
         of_kind(check(lamp(10, "Test@Spot 300.gdtf", "M4", "1"), members), "no_beam"))
        if (finding.what.find("1 fixture of 'Test@Spot 300.gdtf'") != std::string::npos) {
            said = true;
            expect_said(finding.what, {"has stand-in optics, which hands alone light"});
            expect_said(finding.advice, {"'Third@Spot 300.gdtf' of the archive"});
        }
    EXPECT_TRUE(said);
}

TEST_F(Doctor, show_files_have_their_lines) {
    const std::string spot = gdtf("Spot", {4});
    std::ofstream(folder_ / "Spot.gdtf", std::ios::binary) << spot;
    std::ofstream(folder_ / "show.toml")
        << "[show]\nname = \"a\"\n[[camera]]\nposition_m = [0, -9, 2]\n"
           "target_m = [0, 0, 2]\n" // line 5
           "[[fixture]]\nname = \"A\"\ngdtf = \"Spot.gdtf\"\naddress = 1\n"
           "[[fixture]]\nname = \"B\"\ngdtf = \"Spot.gdtf\"\naddress = 2\n" // line 13
           "[[fixture]]\nname = \"C\"\ngdtf = \"Sport.gdtf\"\naddress = 20\n";
    const auto findings = check_file(folder_ / "show.toml");
    const Finding overlap = one(findings, "overlap");
    EXPECT_EQ(overlap.severity, Severity::error);
    EXPECT_EQ(split_where(overlap.where).line, 13);
    EXPECT_EQ(split_where(overlap.where).file, (folder_ / "show.toml").string());
    const Finding missing = one(findings, "missing_file");
    EXPECT_EQ(split_where(missing.where).line, 16);
    expect_said(missing.what, {"Sport.gdtf", "did you mean 'Spot.gdtf'"});
}

} // namespace
} // namespace ghost::scene
