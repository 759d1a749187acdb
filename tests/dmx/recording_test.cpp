// SPDX-License-Identifier: Apache-2.0
#include "dmx/recording.h"

#include "base/files.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>

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

Recording parse(std::string_view text) {
    auto result = parse_recording(text, "x.show");
    EXPECT_TRUE(result.ok()) << result.error().text();
    return result.ok() ? std::move(*result) : Recording{};
}

Universes look(std::uint16_t number, std::uint64_t revision, std::initializer_list<int> levels) {
    Universes result;
    auto data = std::make_shared<Levels>();
    std::size_t i = 0;
    for (const int level : levels) (*data)[i++] = static_cast<std::uint8_t>(level);
    Universe& universe = result.at(number);
    universe.levels = data;
    universe.revision = result.revision = revision;
    return result;
}

struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "ghost_recording_XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
};

TEST(Recording, reads_frames_and_pauses) {
    const Recording recording = parse(kShow);
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

TEST(Recording, dos_line_ends_empty_levels_and_blank_lines) {
    const Recording recording = parse("OLA Show\r\n\r\n1 1,,3,\r\n25\r\n");
    ASSERT_EQ(recording.frames.size(), 1u);
    EXPECT_TRUE(recording.problems.empty());
    EXPECT_EQ(recording.frames[0].slot_count, 4);
    EXPECT_EQ((*recording.frames[0].levels)[1], 0);
    EXPECT_EQ((*recording.frames[0].levels)[2], 3);
    EXPECT_EQ(recording.duration, 25ms);
}

TEST(Recording, every_truncation_keeps_whole_lines) {
    const std::string_view whole(kShow);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const auto result = parse_recording(whole.substr(0, size), "x.show");
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

TEST(Recording, bad_lines_are_named_and_the_rest_is_kept) {
    const Recording recording =
        parse("OLA Show\n1 1\n10\n0 5\n64000 5\n1 256\n1 -1\n1 12x\nten\n-5\n1 9\n5\n");
    ASSERT_EQ(recording.frames.size(), 2u);
    EXPECT_EQ((*recording.frames[1].levels)[0], 9);
    EXPECT_EQ(recording.duration, 15ms);
    std::vector<std::string> places;
    for (const Error& problem : recording.problems) places.push_back(problem.where);
    EXPECT_EQ(places, (std::vector<std::string>{"x.show:4", "x.show:5", "x.show:6", "x.show:7", "x.show:8",
                                                "x.show:9", "x.show:10"}));
    EXPECT_EQ(recording.problems[2].what, "level '256' of slot 1, expected 0 to 255");
}

TEST(Recording, more_than_512_levels_are_clipped_and_said) {
    std::string text = "OLA Show\n1 1";
    for (int i = 0; i < 512; ++i) text += ",2";
    const Recording recording = parse(text + "\n");
    ASSERT_EQ(recording.problems.size(), 1u);
    EXPECT_EQ(recording.problems[0].what, "513 levels, expected at most 512; the first 512 are used");
    EXPECT_EQ(recording.frames.at(0).slot_count, 512);
}

TEST(Recording, a_flood_of_problems_is_summed_up) {
    std::string text = "OLA Show\n1 1\n";
    for (int i = 0; i < 500; ++i) text += "x\n";
    const Recording recording = parse(text);
    ASSERT_EQ(recording.problems.size(), 101u);
    EXPECT_EQ(recording.problems.back().what, "400 more lines left out");
}

TEST(Recording, what_is_no_recording) {
    EXPECT_EQ(parse_recording("", "x").error().where, "x:1");
    EXPECT_FALSE(parse_recording("OLA Shows\n1 1\n", "x").ok());
    EXPECT_FALSE(parse_recording("OLA Show\n", "x").ok());
    EXPECT_FALSE(parse_recording("OLA Show\n5\n", "x").ok());
    EXPECT_FALSE(read_recording("/nonexistent/x.show").ok());
}

TEST(Recording, pauses_past_a_day_are_left_out) {
    EXPECT_EQ(parse("OLA Show\n1 1\n86400001\n").duration, 0ms);
    EXPECT_EQ(parse("OLA Show\n1 1\n86400000\n").duration, 24h);
    EXPECT_EQ(parse("OLA Show\n1 1\n99999999999999999999999\n").duration, 0ms);
}

TEST(Player, levels_by_time) {
    const Player player(parse(kShow));
    EXPECT_DOUBLE_EQ(player.duration_s(), 1.04);
    EXPECT_EQ(player.at(-1.0).level(1, 1), 255);
    EXPECT_EQ(player.at(0.0).level(1, 1), 255);
    EXPECT_EQ(player.at(0.0).find(3), nullptr); // not yet
    EXPECT_EQ(player.at(0.039).level(1, 1), 255);
    EXPECT_EQ(player.at(0.04).level(1, 1), 254);
    EXPECT_EQ(player.at(0.04).level(3, 1), 7);
    EXPECT_EQ(player.at(4.0 * 0.01).level(3, 1), 7);
    EXPECT_EQ(player.at(1e9).level(1, 1), 254);
}

TEST(Player, is_the_same_in_any_order_and_marks_changes) {
    const Player player(parse("OLA Show\n1 1\n10\n1 1\n10\n1 2\n10\n2 5\n0\n"));
    const Universes end = player.at(0.03), start = player.at(0.0), again = player.at(0.03);
    EXPECT_EQ(end.revision, again.revision);
    EXPECT_EQ(end.find(1)->levels, again.find(1)->levels);
    EXPECT_EQ(start.revision, player.at(0.01).revision); // the same levels sent again
    EXPECT_NE(player.at(0.01).revision, player.at(0.02).revision);
    EXPECT_EQ(player.at(0.02).find(1)->revision, end.find(1)->revision);
    EXPECT_NE(player.at(0.02).revision, end.revision);
    EXPECT_EQ(player.at(0.01).find(1)->arrival, std::chrono::nanoseconds(10ms));
}

TEST(Recorder, writes_what_the_reader_reads) {
    const Folder folder;
    const fs::path path = folder.path / "a.show";
    auto recorder = Recorder::create(path);
    ASSERT_TRUE(recorder.ok()) << recorder.error().text();
    ASSERT_TRUE(recorder->feed(look(1, 1, {0, 9, 3}), 1000ms).ok());
    ASSERT_TRUE(recorder->feed(look(1, 1, {0, 9, 3}), 1020ms).ok()); // unchanged: not written
    ASSERT_TRUE(recorder->feed(look(1, 2, {0, 8, 0}), 1040ms + 600us).ok());
    ASSERT_TRUE(recorder->feed(look(2, 3, {}), 1040ms + 900us).ok());
    EXPECT_FALSE(fs::exists(path)); // only when it is whole
    ASSERT_TRUE(recorder->finish(1100ms).ok());
    EXPECT_EQ(recorder->frames(), 3u);
    const auto text = read_text_file(path, 1000);
    ASSERT_TRUE(text.ok());
    EXPECT_EQ(*text, "OLA Show\n1 0,9,3\n40\n1 0,8,0\n0\n2 0\n60\n");
    EXPECT_EQ(recorder->bytes(), text->size());
    EXPECT_FALSE(fs::exists(path.string() + ".part"));
    const auto back = read_recording(path);
    ASSERT_TRUE(back.ok());
    EXPECT_TRUE(back->problems.empty());
    EXPECT_EQ(back->duration, 100ms);
}

TEST(Recorder, a_killed_one_leaves_a_readable_part_file_and_the_old_recording) {
    const Folder folder;
    const fs::path path = folder.path / "a.show";
    ASSERT_TRUE(write_file_atomic(path, std::string_view("old")).ok());
    {
        auto recorder = Recorder::create(path);
        ASSERT_TRUE(recorder.ok());
        ASSERT_TRUE(recorder->feed(look(1, 1, {5}), 0ms).ok());
        const auto part = read_recording(path.string() + ".part"); // while it still runs
        ASSERT_TRUE(part.ok()) << part.error().text();
        EXPECT_EQ(part->frames.size(), 1u);
    }
    EXPECT_EQ(*read_text_file(path, 10), "old");
    EXPECT_TRUE(fs::exists(path.string() + ".part"));
}

TEST(Recorder, one_that_saw_nothing_leaves_nothing) {
    const Folder folder;
    { ASSERT_TRUE(Recorder::create(folder.path / "a.show").ok()); }
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(Recorder, errors_name_the_file) {
    const auto missing = Recorder::create("/nonexistent/folder/a.show");
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(missing.error().where.find("/nonexistent/folder/a.show"), std::string::npos);
    const Folder folder;
    EXPECT_FALSE(Recorder::create(folder.path).ok()); // a folder cannot be replaced
    EXPECT_FALSE(Recorder::create("").ok());
    const std::string long_name(300, 'a');
    const auto too_long = Recorder::create(folder.path / long_name);
    ASSERT_FALSE(too_long.ok());
    EXPECT_NE(too_long.error().text().find(long_name), std::string::npos);
    EXPECT_FALSE(read_recording(folder.path / long_name).ok());
}

TEST(Recorder, a_full_disk_is_an_error_and_what_was_written_stays) {
    const Folder folder;
    auto recorder = Recorder::create(folder.path / "a.show");
    ASSERT_TRUE(recorder.ok());
    ASSERT_TRUE(recorder->feed(look(1, 1, {1, 2, 3}), 0ms).ok());
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{20, before.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = recorder->feed(look(1, 2, {4, 5, 6}), 10ms);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().where.find("a.show.part"), std::string::npos);
    const auto part = read_recording(folder.path / "a.show.part");
    ASSERT_TRUE(part.ok());
    EXPECT_EQ(part->frames.size(), 1u);
}

// Show files that OLA's own recorder made, where they lie beside the checkout.
TEST(Recording, reads_files_of_ola) {
    const fs::path folder = fs::path(GHOST_SOURCE_DIR) / "../shared/control/data/ola-recorder";
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
    struct Expected {
        const char* name;
        std::size_t frames;
        std::chrono::milliseconds duration;
    };
    for (const Expected& expected :
         {Expected{"single_uni.txt", 24, 19062ms}, Expected{"multiple_unis.txt", 18, 10410ms},
          Expected{"partial_frames.txt", 3, 1016ms}, Expected{"dos_line_endings.txt", 3, 1016ms},
          Expected{"trailing_timeout.txt", 2, 1469ms}}) {
        const auto recording = read_recording(folder / expected.name);
        ASSERT_TRUE(recording.ok()) << recording.error().text();
        EXPECT_TRUE(recording->problems.empty()) << expected.name << ": " << recording->problems.at(0).text();
        EXPECT_EQ(recording->frames.size(), expected.frames) << expected.name;
        EXPECT_EQ(recording->duration, expected.duration) << expected.name;
    }
}

} // namespace
} // namespace ghost::dmx
