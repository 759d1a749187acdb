// SPDX-License-Identifier: Apache-2.0
#include "ui/language/language.h"

#include "ui/language/private/sentence_list.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <regex>
#include <set>
#include <string>

using namespace ghost::ui;

struct Language : testing::Test {
    ~Language() override { set_language("en"); }
};

namespace {

std::string in_german(const char* english) {
    set_language("de");
    return said(english).toStdString();
}

// Words that are English and German, or of neither: names, units, protocols, commands.
const std::set<std::string> kBoth = {
    "ArtPoll",   "Art", "Blind", "CID", "DHCP",     "DMX",  "Dimmer", "Firewall", "Gobo",  "Hz",
    "IGMP",      "IPv", "LED",   "LTP", "HTP",      "Net",  "OLA",    "Physical", "Port",  "QLC",
    "Shutter",   "Sub", "UDP",   "USB", "Universe", "VLAN", "am",     "an",       "blind", "deg",
    "discovery", "in",  "lm",    "lx",  "net",      "pid",  "poll",   "root",     "sACN",  "so"};

// Words of a sentence that its German still has: none of them may be English.
std::string english_left(const std::string& english) {
    static const std::regex names(
        R"('[^']*'|--[a-z-]+|\w+_\w+|[\w/.-]+\.(?:gdtf|pcap)|sysctl -w [\w.]+(?:=\d+)?|\b(?:ff18|0xDD)\b|[a-z]+[0-9]* (?=\(pid))"),
        word("[A-Za-z]{2,}");
    const auto words = [](const std::string& sentence) {
        const std::string plain = std::regex_replace(sentence, names, "");
        return std::set<std::string>(std::sregex_token_iterator(plain.begin(), plain.end(), word), {});
    };
    const std::set<std::string> before = words(english), after = words(in_german(english.c_str()));
    std::string left;
    for (const std::string& one : before)
        if (after.contains(one) && !kBoth.contains(one)) left += one + " ";
    return left;
}

} // namespace

TEST_F(Language, EnglishIsWhatTheSourcesSay) {
    EXPECT_EQ(translated("Action", "Undo"), "Undo");
    EXPECT_EQ(translated("Action", "a text that no catalogue has"), "a text that no catalogue has");
    EXPECT_EQ(said("no show is open"), "no show is open");
}

TEST_F(Language, EnglishHasPlurals) {
    EXPECT_EQ(translated("By hand", "%n fixture(s)", nullptr, 1), "1 fixture");
    EXPECT_EQ(translated("By hand", "%n fixture(s)", nullptr, 0), "0 fixtures");
    EXPECT_EQ(translated("Looks", "What if %n fixture(s) had", nullptr, 1), "What if this fixture had");
}

TEST_F(Language, GermanIsOfTheCatalogue) {
    set_language("de");
    EXPECT_EQ(translated("Action", "Undo"), "Rückgängig");
    EXPECT_EQ(translated("By hand", "%n fixture(s)", nullptr, 1), "1 Gerät");
    EXPECT_EQ(translated("By hand", "%n fixture(s)", nullptr, 12), "12 Geräte");
    EXPECT_EQ(translated("Action", "a text that no catalogue has"), "a text that no catalogue has");
}

TEST_F(Language, AnUnknownLanguageIsEnglish) {
    set_language("tlh");
    EXPECT_EQ(translated("Action", "Undo"), "Undo");
    EXPECT_EQ(translated("By hand", "%n fixture(s)", nullptr, 2), "2 fixtures");
    EXPECT_EQ(said("no show is open"), "no show is open");
}

TEST_F(Language, ThereAreThoseThatAreOffered) {
    for (const LanguageChoice& one : kLanguages) {
        set_language(one.code);
        EXPECT_EQ(translated("By hand", "%n fixture(s)", nullptr, 7).contains('('), false) << one.code;
    }
}

TEST_F(Language, TheMoreParticularPatternIsTaken) {
    EXPECT_EQ(in_german("'x' is none of lux, luminance and off"),
              "'x' ist keines von lux, luminance und off");
}

TEST_F(Language, ASentenceIsKnownByItsPattern) {
    EXPECT_EQ(in_german("no show is open"), "keine Show ist offen");
    EXPECT_EQ(in_german("no fixture is called 'Spot %2 and on'"), "kein Gerät heißt 'Spot %2 and on'");
    EXPECT_EQ(in_german("lit: 1351 of 10000 lm, beam 12.1 deg, hits 'riser_drums' at 4.4 m with 1775 lx"),
              "leuchtet: 1351 von 10000 lm, Strahl 12.1°, trifft 'riser_drums' in 4.4 m mit 1775 lx");
    EXPECT_EQ(in_german("'x' is no number of seconds from 0 to 3600"),
              "'x' ist nicht: Zahl von Sekunden von 0 bis 3600");
}

TEST_F(Language, EnglishHasTheSignOfDegreesAsEveryPanelHas) {
    EXPECT_EQ(said("lit: 1 of 2 lm, beam 12.1 deg, hits 'Truss 45 deg' at 4.4 m"),
              "lit: 1 of 2 lm, beam 12.1\u00b0, hits 'Truss 45 deg' at 4.4 m");
    EXPECT_EQ(said("it points 37 degrees downwards"), "it points 37 degrees downwards");
}

TEST_F(Language, SoAreTheSentencesThatItIsMadeOf) {
    const std::string said = in_german(
        "no levels arrive, though 3 other packets did (3 poll): is the desk's output on, is it in this "
        "network, "
        "and is no firewall on UDP 5568 in the way? We listen on net0 (10.93.0.2/24); 'Desk' (10.93.0.1) on "
        "universe 1: only priorities per address (start code 0xDD), no levels. To tell them apart: where "
        "'tcpdump -ni any udp port 5568' shows packets to an address of ours, to its broadcast or to the "
        "group of a universe of ours (239.255.0.1, ff18::.. for 1), a firewall or the reverse path filter of "
        "this machine drops them, or their sender has an address of ours; to another broadcast, the masks "
        "differ; to another group, it is another universe; where it shows none at all, they do not get here: "
        "a cable, another VLAN, a switch that holds multicast back (IGMP snooping without a querier), a desk "
        "that sends to other addresses alone (unicast), or one that is silent");
    for (const char* const part : {"nur Prioritäten je Adresse", "wo 'tcpdump -ni any udp port 5568' Pakete",
                                   "obwohl 3 andere Pakete ankommen (3 poll)",
                                   "'Desk' (10.93.0.1) auf Universum 1", "oder eines, das schweigt"})
        EXPECT_NE(said.find(part), std::string::npos) << part << " in: " << said;
    EXPECT_EQ(
        in_german(
            "universe 1 comes with 24 channels (512 in some packets), and 1 fixture ('Spot') is patched "
            "past these: not patched on the desk?"),
        "Universum 1 bringt 24 Kanäle (512 in manchen Paketen), und 1 Gerät ('Spot') ist dahinter "
        "gepatcht: am Pult nicht gepatcht?");
}

TEST_F(Language, SoIsWhoOverridesWhom) {
    EXPECT_EQ(
        in_german("'House' (sACN, 10.0.0.3, priority 150) overrides 'FOH' (sACN, 10.0.0.2, priority 100 for "
                  "this address), which would light it: on channel 1 (1.001) it sends 0 instead of 255"),
        "'House' (sACN, 10.0.0.3, Priorität 150) geht 'FOH' (sACN, 10.0.0.2, für diese Adresse Priorität "
        "100) "
        "vor, das es leuchten ließe: auf Kanal 1 (1.001) sendet es 0 statt 255");
}

// What is said of mistakes is put together from parts in rooms without Qt, whose patterns stand in lists of
// their own: of each sentence of the table every part is found.
TEST_F(Language, SoIsWhatIsSaidOfEveryMistake) {
    std::ifstream table(GHOST_SOURCE_DIR "/docs/reference/mistakes.md");
    const std::regex row(R"(\| .* \| `([a-z_:]+)` \| (?:yes)? \| (.*) \|)");
    int rows = 0;
    std::smatch parts;
    for (std::string line; std::getline(table, line);) {
        if (!std::regex_match(line, parts, row) || parts[1] == "error:") continue;
        ++rows;
        EXPECT_EQ(english_left(parts[2]), "") << in_german(parts[2].str().c_str());
    }
    EXPECT_GT(rows, 100);
}

// variants.txt has what else the same functions say: two and three names, one and several of each, other
// causes.
TEST_F(Language, SoIsWhatElseIsSaidOfTheNetworkAndOfLamps) {
    std::ifstream variants(GHOST_SOURCE_DIR "/tests/ui/language/variants.txt");
    int lines = 0;
    for (std::string line; std::getline(variants, line); ++lines)
        EXPECT_EQ(english_left(line), "") << in_german(line.c_str());
    EXPECT_GT(lines, 60);
}

TEST_F(Language, SoIsWhatIsSaidOfMalformedXml) {
    EXPECT_EQ(in_german("tour.mvr: GeneralSceneDescription.xml:3: the XML is not well formed: Start-end tags "
                        "mismatch, in or behind Scene/Layers/Layer 'Rig' of that file inside of the plot, "
                        "which is a zip"),
              "tour.mvr: GeneralSceneDescription.xml:3: das XML ist nicht wohlgeformt: End-Tag passt nicht "
              "zum Start-Tag, in oder hinter Scene/Layers/Layer 'Rig' dieser Datei im Plot, der ein Zip ist");
    EXPECT_EQ(in_german("tour.mvr: GeneralSceneDescription.xml:1: the XML is not well formed: No document "
                        "element found, in that file inside of the plot, which is a zip"),
              "tour.mvr: GeneralSceneDescription.xml:1: das XML ist nicht wohlgeformt: kein Wurzelelement "
              "gefunden, in dieser Datei im Plot, der ein Zip ist");
}

TEST_F(Language, SoIsWhyABakedPictureIsNotShown) {
    EXPECT_EQ(
        in_german(
            "live: house, because its passes have 1024x300 pixels, and the window shows it with 1055x309"),
        "live: house, denn das Vorberechnete hat 1024x300 Pixel, und das Fenster zeigt es mit 1055x309");
    // All else that may stand there.
    for (const char* const why :
         {"its passes need 3 MB on the device, which has not got them", "it is not baked",
          "its passes are of an earlier version of Ghostlight: bake it again, once",
          "its passes are not whole: bake it again", "its passes are being read",
          "files of the show changed since its bake: bake it again",
          "a.exr: belongs to another bake than manifest.json says; run `ghostlight bake` again",
          "a.json: has version 9, this program reads up to 4; run `ghostlight bake` again",
          "a.exr: is 4 x 3 pixels, expected 8 x 6", "a.exr: has no channel G, expected R, G, B",
          "a.exr: has no channel G, expected R G B = x y z in metres and A",
          "a.exr: fragment 7 is not a finite number",
          "a.exr: fragment 7 belongs to no pixel or is out of order",
          "a.toml: has no 'position', expected the name of the position picture",
          "a.toml: has no [camera] with matrix_world and fov_y_deg"}) {
        const std::string said = in_german((std::string("live: house, because ") + why).c_str());
        EXPECT_EQ(said.rfind("live: house, denn ", 0), 0u) << said;
        for (const char* const english : {"passes", "baked", "again", "has ", "which", "expected", "belongs"})
            EXPECT_EQ(said.find(english), std::string::npos) << said;
    }
}

TEST_F(Language, ANameIsNoPartOfASentence) {
    EXPECT_EQ(
        in_german("'Sound and Light on channel 5. Now; on universe 3' (10.0.0.1), 'A and B' (10.0.0.2) and "
                  "'C, (D) and E' (10.0.0.3) are too many sources on universes 1, 3-4 and ignored: 16 are "
                  "merged, those of the highest priority and of these the longest known"),
        "'Sound and Light on channel 5. Now; on universe 3' (10.0.0.1), 'A and B' (10.0.0.2) und "
        "'C, (D) and E' (10.0.0.3) sind zu viele Quellen auf Universen 1, 3-4 und bleiben unbeachtet: 16 "
        "werden gemischt, die höchster Priorität und davon die am längsten bekannten");
}

// Alone, or in a sentence that is not known, they would be found in what is none of ours.
TEST_F(Language, PartsAreKnownInsideOfASentenceOnly) {
    for (const char* const one :
         {"channel 5 and channel 6", "show.toml:3: universe 1 and channel 5 do not fit", "hang: universe 7",
          "dimmer 3 leaves 1 of 5 lm"})
        EXPECT_EQ(in_german(one), one);
    EXPECT_EQ(in_german("dark because channel 5 and channel 6"), "dunkel, weil: Kanal 5 und Kanal 6");
}

TEST_F(Language, WhatHasManyEndsIsReadInTime) {
    for (const char* const end : {": ", "; ", ". ", " and ", ", channel "}) {
        std::string long_one = "dark because ";
        while (long_one.size() < 3000) long_one += "a" + std::string(end);
        const auto begun = std::chrono::steady_clock::now();
        EXPECT_TRUE(in_german(long_one.c_str()).starts_with("dunkel, weil: a")) << end;
        EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20)) << end;
    }
}

TEST_F(Language, WhatIsQuotedStays) {
    EXPECT_EQ(in_german("another cue is called 'nothing'"), "ein anderer Cue heißt 'nothing'");
}

TEST_F(Language, APlaceBeforeASentenceStays) {
    EXPECT_EQ(in_german("hang: no fixture is selected"), "hang: kein Gerät ist ausgewählt");
    EXPECT_EQ(in_german("/shows/tour/show.toml:12: has no DMX mode"),
              "/shows/tour/show.toml:12: hat keinen DMX-Modus");
}

TEST_F(Language, AnotherSentenceStays) {
    EXPECT_EQ(in_german("show.toml:12: unknown key 'postion', did you mean 'position'?"),
              "show.toml:12: unknown key 'postion', did you mean 'position'?");
    EXPECT_EQ(in_german(""), "");
    const std::string huge(100000, ':');
    EXPECT_EQ(in_german(huge.c_str()), huge);
}

TEST_F(Language, EveryPatternSaysSomethingInGerman) {
    set_language("de");
    for (const char* const one : sentence_list()) EXPECT_FALSE(said(one).isEmpty()) << one;
    for (const char* const one : part_list())
        EXPECT_FALSE(said("dark because " + std::string(one)).isEmpty()) << one;
    EXPECT_GT(sentence_list().size(), 400u);
    EXPECT_GT(part_list().size(), 100u);
}
