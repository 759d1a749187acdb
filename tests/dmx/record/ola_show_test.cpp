// SPDX-License-Identifier: Apache-2.0
#include "disk/files.h"
#include "support/test_recording.h"

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const char kShow[] = "OLA Show\n"
                     "1 255,0,10\n"
                     "40\n"
                     "3 7\n"
                     "0\n"
                     "1 254,0,10\n"
                     "1000\n";

struct Shown {
    std::vector<RecordedFrame> frames;
    std::vector<Error> problems;
    std::chrono::microseconds duration{0};
};

Result<Shown> try_parse(std::string_view text) {
    Shown shown;
    TRY(OlaShowEnd end, read_ola_show(text, "x.show", [&](const RecordedFrame& frame) -> Result<void> {
            shown.frames.push_back(frame);
            return {};
        }));
    shown.problems = std::move(end.problems);
    shown.duration = end.duration;
    return shown;
}

Shown parse(std::string_view text) {
    auto result = try_parse(text);
    EXPECT_TRUE(result.ok()) << result.error().text();
    return result.ok() ? std::move(*result) : Shown{};
}

std::string write(const std::vector<RecordedFrame>& frames, std::chrono::microseconds duration) {
    std::string text;
    OlaShowWriter writer([&](Bytes bytes) -> Result<void> {
        text.append(bytes.begin(), bytes.end());
        return {};
    });
    for (const RecordedFrame& frame : frames) EXPECT_TRUE(writer.append(frame).ok());
    EXPECT_TRUE(writer.finish(duration).ok());
    return text;
}

TEST(OlaShow, reads_frames_and_pauses) {
    const Shown recording = parse(kShow);
    ASSERT_EQ(recording.frames.size(), 3u);
    EXPECT_TRUE(recording.problems.empty());
    EXPECT_EQ(recording.duration, 1040ms);
    EXPECT_EQ(recording.frames[0].time, 0ms);
    EXPECT_EQ(recording.frames[0].universe, 1);
    EXPECT_EQ(recording.frames[0].slot_count, 3);
    EXPECT_EQ((*recording.frames[0].levels)[0], 255);
    EXPECT_EQ((*recording.frames[0].levels)[2], 10);
    EXPECT_EQ(recording.frames[1].universe, 3);
    EXPECT_EQ(recording.frames[1].time, 40ms);
    EXPECT_EQ(recording.frames[2].time, 40ms);
}

TEST(OlaShow, dos_line_ends_empty_levels_and_blank_lines) {
    const Shown recording = parse("OLA Show\r\n\r\n1 1,,3,\r\n25\r\n");
    ASSERT_EQ(recording.frames.size(), 1u);
    EXPECT_TRUE(recording.problems.empty());
    EXPECT_EQ(recording.frames[0].slot_count, 4);
    EXPECT_EQ((*recording.frames[0].levels)[1], 0);
    EXPECT_EQ((*recording.frames[0].levels)[2], 3);
    EXPECT_EQ(recording.duration, 25ms);
}

TEST(OlaShow, every_truncation_keeps_whole_lines) {
    const std::string_view whole(kShow);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const auto result = try_parse(whole.substr(0, size));
        if (size < whole.find("40\n")) {
            EXPECT_FALSE(result.ok()) << size;
            continue;
        }
        ASSERT_TRUE(result.ok()) << size;
        const bool line_end = whole[size - 1] == '\n';
        EXPECT_EQ(result->problems.empty(), line_end) << size;
        const std::size_t frames = size < whole.find("0\n1 254") ? 1u : size < whole.find("1000\n") ? 2u : 3u;
        EXPECT_EQ(result->frames.size(), frames) << size;
    }
}

TEST(OlaShow, bad_lines_are_named_and_the_rest_is_kept) {
    const Shown recording = parse("OLA Show\n1 1\n10\n0 5\n64000 5\n1 256\n1 -1\n1 12x\nten\n-5\n1 9\n5\n");
    ASSERT_EQ(recording.frames.size(), 2u);
    EXPECT_EQ((*recording.frames[1].levels)[0], 9);
    EXPECT_EQ(recording.duration, 15ms);
    std::vector<std::string> places;
    for (const Error& problem : recording.problems) places.push_back(problem.where);
    EXPECT_EQ(places, (std::vector<std::string>{"x.show:4", "x.show:5", "x.show:6", "x.show:7", "x.show:8",
                                                "x.show:9", "x.show:10"}));
    EXPECT_EQ(recording.problems[2].what, "level '256' of slot 1, expected 0 to 255");
}

TEST(OlaShow, more_than_512_levels_are_clipped_and_said) {
    std::string text = "OLA Show\n1 1";
    for (int i = 0; i < 512; ++i) text += ",2";
    const Shown recording = parse(text + "\n");
    ASSERT_EQ(recording.problems.size(), 1u);
    EXPECT_EQ(recording.problems[0].what, "513 levels, expected at most 512; the first 512 are used");
    EXPECT_EQ(recording.frames.at(0).slot_count, 512);
}

TEST(OlaShow, a_flood_of_problems_is_summed_up) {
    std::string text = "OLA Show\n1 1\n";
    for (int i = 0; i < 500; ++i) text += "x\n";
    const Shown recording = parse(text);
    ASSERT_EQ(recording.problems.size(), 101u);
    EXPECT_EQ(recording.problems.back().what, "400 more lines left out");
}

TEST(OlaShow, what_is_no_recording) {
    EXPECT_EQ(try_parse("").error().where, "x.show:1");
    EXPECT_FALSE(try_parse("OLA Shows\n1 1\n").ok());
    EXPECT_FALSE(try_parse("OLA Show\n").ok());
    EXPECT_FALSE(try_parse("OLA Show\n5\n").ok());
}

TEST(OlaShow, pauses_past_a_day_are_left_out) {
    EXPECT_EQ(parse("OLA Show\n1 1\n86400001\n").duration, 0ms);
    EXPECT_EQ(parse("OLA Show\n1 1\n86400000\n").duration, 24h);
    EXPECT_EQ(parse("OLA Show\n1 1\n99999999999999999999999\n").duration, 0ms);
}

TEST(OlaShow, what_was_read_is_written_the_same) {
    for (const char* text : {kShow, "OLA Show\n7 1\n0\n", "OLA Show\n250\n7 1,2,3\n1\n9 0,0\n86400000\n"}) {
        const Shown recording = parse(text);
        EXPECT_EQ(write(recording.frames, recording.duration), text);
    }
}

TEST(OlaShow, microseconds_add_up_to_milliseconds_and_long_pauses_are_split) {
    EXPECT_EQ(write({make_frame(600us, 1, {1}), make_frame(1200us, 1, {2}), make_frame(2100us, 1, {3})}, 50h),
              "OLA Show\n1 1\n1\n1 2\n1\n1 3\n86400000\n86400000\n7199998\n");
}

// Into ours and out again.
TEST(OlaShow, through_ghostdmx_and_back_is_identical) {
    const TestFolder folder;
    const auto frames = random_frames(8, 500, 3);
    std::vector<RecordedFrame> in_ms = frames;
    for (RecordedFrame& frame : in_ms) {
        frame.time = std::chrono::floor<std::chrono::milliseconds>(frame.time);
        frame.lost = false;
    }
    const std::string text = write(in_ms, in_ms.back().time + 5ms);
    const Shown first = parse(text);
    const ReadBack back =
        read_back(write_bytes(folder.path / "a.ghostdmx", pack(first.frames, first.duration)));
    EXPECT_EQ(write(back.frames, back.end.duration), text);
}

// Show files that OLA's own recorder made, where they lie beside the checkout.
TEST(OlaShow, files_of_ola_survive_ghostdmx) {
    const fs::path folder = fs::path(GHOST_SOURCE_DIR) / "../shared/control/data/ola-recorder";
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
    const TestFolder mine;
    struct Expected {
        const char* name;
        std::size_t frames;
        std::chrono::milliseconds duration;
        bool same_bytes; // not those with DOS line ends or empty levels
    };
    for (const Expected& expected :
         {Expected{"single_uni.txt", 24, 19062ms, true}, Expected{"multiple_unis.txt", 18, 10410ms, true},
          Expected{"partial_frames.txt", 3, 1016ms, false},
          Expected{"dos_line_endings.txt", 3, 1016ms, false},
          Expected{"trailing_timeout.txt", 2, 1469ms, true}}) {
        const std::string text = *read_text_file(folder / expected.name, 1 << 20);
        const Shown shown = parse(text);
        EXPECT_TRUE(shown.problems.empty()) << expected.name << ": " << shown.problems.at(0).text();
        EXPECT_EQ(shown.frames.size(), expected.frames) << expected.name;
        EXPECT_EQ(shown.duration, expected.duration) << expected.name;
        const ReadBack back =
            read_back(write_bytes(mine.path / "a.ghostdmx", pack(shown.frames, shown.duration)));
        const std::string again = write(back.frames, back.end.duration);
        EXPECT_TRUE(same_frames(parse(again).frames, shown.frames)) << expected.name;
        // OLA leaves the last pause out where it is 0.
        EXPECT_EQ(again == text || again == text + "0\n", expected.same_bytes) << expected.name;
    }
}

} // namespace
} // namespace ghost::dmx
