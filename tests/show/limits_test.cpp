// SPDX-License-Identifier: Apache-2.0
// How much of a kind a show file and a file of looks may have (docs/reference/limits.md): one more is left
// out and said, and what is at the limit is kept.
#include "json_xml_toml/toml_reader.h"
#include "show/cues.h"
#include "show/looks.h"
#include "show_file/show_toml.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ctime>

namespace ghost::scene {
namespace {

std::string all_said(const Report& report) {
    std::string text;
    for (const Message& message : report.messages) text += message.what + "\n";
    return text.substr(0, 2000);
}

bool has_said(const Report& report, const std::string& words) {
    return std::any_of(report.messages.begin(), report.messages.end(),
                       [&](const Message& message) { return message.what.find(words) != std::string::npos; });
}

Report of_show(const std::string& text) {
    Report report;
    EXPECT_TRUE(parse_show("[show]\nstage = \"none.glb\"\n" + text, "show.toml", report).ok());
    return report;
}

Report of_looks(const std::string& text) {
    Report report;
    EXPECT_TRUE(parse_looks(text, "looks.toml", report).ok());
    return report;
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t k = 0; k < times; ++k) all += text;
    return all;
}

TEST(ShowLimits, TablesOfAKind) {
    struct Row {
        const char* entry;
        std::size_t most;
        const char* before = "";
        bool is_look = false;
    };
    constexpr std::array kRows{
        Row{"[[camera]]\n", 256},
        Row{"[[fixture]]\n", 10'000},
        Row{"[[change]]\n", 100'000},
        Row{"[[substitute]]\n", 1000},
        Row{"[[photometry]]\n", 1000},
        Row{"[[model]]\n", 1000},
        Row{"[[media]]\n", 63}, // and the test card
        Row{"[[wall]]\n", 1000},
        Row{"[[hazer]]\n", 8},
        Row{"[[object]]\n", 1000},
        Row{"[[tracker]]\n", 256},
        Row{"[[mover]]\n", 256},
        Row{"[[mover.axis]]\n", 32, "[[mover]]\nname = \"M\"\nkind = \"hoists\"\n"},
        Row{"[[mover.key]]\n", 10'000,
            "[[mover]]\nname = \"M\"\nkind = \"linear\"\n[[mover.axis]]\nrange_m = [0, 1]\n"},
        Row{"[[circuit]]\n", 10'000},
        Row{"[[cue]]\n", 10'000},
        Row{"[[palette]]\n", 1000},
        Row{"[[palette.fixture]]\n", 65'536, "[[palette]]\nname = \"P\"\nkind = \"gobo\"\n"},
        Row{"[[look]]\n", 1000, "", true},
        Row{"[[look.fixture]]\n", 65'536, "[[look]]\nname = \"L\"\n", true},
    };
    for (const Row& row : kRows) {
        const auto read = [&](std::size_t count) {
            const std::string text = row.before + repeated(row.entry, count);
            return row.is_look ? of_looks(text) : of_show(text);
        };
        const std::string words = "has more than " + std::to_string(row.most) + " entries";
        const Report kept = read(row.most), over = read(row.most + 1);
        EXPECT_FALSE(has_said(kept, words)) << row.entry;
        EXPECT_TRUE(has_said(over, words)) << row.entry << all_said(over);
    }
}

TEST(ShowLimits, ListsAndTexts) {
    const auto list = [](const std::string& what, std::size_t count) {
        return "[" + repeated(what + ", ", count) + "]\n";
    };
    const auto named = [](std::size_t count) {
        std::string all = "{ ";
        for (std::size_t k = 0; k < count; ++k) all += (k > 0 ? ", a" : "a") + std::to_string(k) + " = 0.5";
        return all + " }\n";
    };
    const std::string mover = "[[mover]]\nname = \"M\"\nkind = \"path\"\n",
                      look = "[[look]]\nname = \"L\"\n[[look.fixture]]\n",
                      palette = "[[palette]]\nname = \"P\"\nkind = \"beam\"\n";
    struct Row {
        std::string most, over, words;
        bool is_look = false;
    };
    const std::vector<Row> rows{
        {"hide_layers = " + list("\"a\"", 1000), "hide_layers = " + list("\"a\"", 1001),
         "at most 1000 texts"},
        {mover + "path_m = " + list("[0, 0, 1]", 1000), mover + "path_m = " + list("[0, 0, 1]", 1001),
         "1000"},
        {mover + "objects = " + list("\"a\"", 10'000), mover + "objects = " + list("\"a\"", 10'001),
         "at most 10000 texts"},
        {palette + "attributes = " + named(256), palette + "attributes = " + named(257),
         "has more than 256 entries"},
        {look + "channels = " + named(4096), look + "channels = " + named(4097), "has more than 4096 entries",
         true},
        {look + "levels = " + list("7", 65'536), look + "levels = " + list("7", 65'537), "65536", true},
        {"name = \"" + std::string(1000, 'a') + "\"\n", "name = \"" + std::string(1001, 'a') + "\"\n",
         "a text of at most 1000 bytes"},
        {mover + "[[mover.axis]]\nrange_m = [0, 1000]\n", mover + "[[mover.axis]]\nrange_m = [0, 1001]\n",
         "1000"},
        {"[[mover]]\nname = \"M\"\nkind = \"revolve\"\n[[mover.axis]]\nrange_deg = [0, 36000]\n",
         "[[mover]]\nname = \"M\"\nkind = \"revolve\"\n[[mover.axis]]\nrange_deg = [0, 36001]\n", "36000"},
        {"sound = \"a.wav\"\nsound_offset_s = 86400\n", "sound = \"a.wav\"\nsound_offset_s = 86401\n",
         "86400"},
        {"recording = \"a.show\"\nbegin_s = 86400\n", "recording = \"a.show\"\nbegin_s = 86401\n", "86400"},
    };
    for (const Row& row : rows) {
        const Report kept = row.is_look ? of_looks(row.most) : of_show(row.most);
        const Report over = row.is_look ? of_looks(row.over) : of_show(row.over);
        EXPECT_FALSE(has_said(kept, row.words)) << row.most.substr(0, 80) << "\n" << all_said(kept);
        EXPECT_TRUE(has_said(over, row.words)) << row.over.substr(0, 80) << "\n" << all_said(over);
    }
}

TEST(ShowLimits, UnknownKeysAreNotListedWithoutEnd) {
    std::string text;
    for (int k = 0; k < 30'000; ++k) text += "k" + std::to_string(k) + " = 1\n";
    const Report report = of_show(text + "[haze]\nalbedo = \"much\"\n");
    EXPECT_LT(report.messages.size(), kMostReported + 10);
    EXPECT_TRUE(has_said(report, "more messages are not listed, but the first of each kind"))
        << all_said(report);
    EXPECT_TRUE(report.lost_anything()) << "what is rare is among them";
}

// Names as long as they may be, alike but for their ends: they are told apart in less time than their file
// takes to be parsed.
TEST(ShowLimits, NamesOfCuesTakeNoTime) {
    constexpr int kCues = 10'000;
    const std::string letters(990, 'a');
    std::string text;
    for (int k = 0; k < kCues; ++k)
        text += "[[cue]]\nname = \"" + letters + std::to_string(kCues + k) + "\"\nat_s = 1\n";
    const std::clock_t begun = std::clock();
    const toml::table root = toml::parse(text);
    const std::clock_t parsed = std::clock();
    Report report;
    TableReader top(root, "the show", "show.toml", report);
    EXPECT_EQ(read_cues(top, "show.toml", report).size(), kCues);
    EXPECT_LT(std::clock() - parsed, parsed - begun);
}

} // namespace
} // namespace ghost::scene
