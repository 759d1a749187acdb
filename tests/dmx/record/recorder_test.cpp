// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/recorder.h"

#include "disk/files.h"
#include "dmx/record/changes.h"
#include "support/test_recording.h"

#if !defined(_WIN32)
#include <csignal>
#include <sys/resource.h>
#endif

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

Universes look(std::uint16_t number, std::uint64_t revision, std::initializer_list<int> levels,
               std::chrono::nanoseconds arrival, bool lost = false) {
    Universes result;
    Universe& universe = result.at(number);
    universe.levels = make_frame(0us, number, levels).levels;
    universe.slot_count = static_cast<std::uint16_t>(levels.size());
    universe.arrival = arrival;
    universe.lost = lost;
    universe.revision = result.revision = revision;
    return result;
}

TEST(Changes, one_frame_for_each_change_at_its_arrival) {
    Changes changes;
    std::vector<RecordedFrame> frames;
    changes.find(look(1, 1, {0, 9, 3}, 1000ms), 1001ms, frames);
    changes.find(look(1, 1, {0, 9, 3}, 1020ms), 1021ms, frames); // the same levels again
    changes.find(look(1, 2, {0, 8, 0}, 1040ms + 600us + 999ns), 1041ms, frames);
    changes.find(look(2, 3, {}, 1040ms + 900us), 1042ms, frames);
    auto expected =
        std::vector<RecordedFrame>{make_frame(1000ms, 1, {0, 9, 3}), make_frame(1040ms + 600us, 1, {0, 8, 0}),
                                   make_frame(1040ms + 900us, 2, {0})};
    EXPECT_TRUE(same_frames(frames, expected));
}

TEST(Changes, lost_and_back_are_changes_and_time_never_goes_back) {
    Changes changes;
    std::vector<RecordedFrame> frames;
    changes.find(look(1, 1, {5}, 10ms), 10ms, frames);
    changes.find(look(1, 1, {5}, 10ms, true), 2510ms, frames);
    changes.find(look(1, 1, {5}, 2600ms), 2600ms, frames);
    changes.find(look(3, 2, {7}, 2000ms), 2700ms, frames); // arrived before what is written
    EXPECT_TRUE(same_frames(frames, {make_frame(10ms, 1, {5}), make_frame(2510ms, 1, {5}, true),
                                     make_frame(2600ms, 1, {5}), make_frame(2600ms, 3, {7})}));
}

TEST(Recorder, the_ending_of_the_name_chooses_the_format) {
    const TestFolder folder;
    for (const char* name : {"a.show", "a.txt", "b.SHOW", "a.ghostdmx", "b.GhostDmx"}) {
        const fs::path path = folder.path / name;
        auto recorder = Recorder::create(path);
        ASSERT_TRUE(recorder.ok()) << recorder.error().text();
        ASSERT_TRUE(recorder->append(make_frame(0us, 1, {0, 9, 3})).ok());
        ASSERT_TRUE(recorder->append(make_frame(40ms, 1, {0, 8, 0})).ok());
        EXPECT_FALSE(fs::exists(path)); // only when it is whole
        ASSERT_TRUE(recorder->finish(100ms).ok());
        EXPECT_EQ(recorder->frames(), 2u);
        EXPECT_EQ(recorder->bytes(), fs::file_size(path));
        EXPECT_FALSE(fs::exists(path.string() + ".part"));
        const ReadBack back = read_back(path);
        EXPECT_TRUE(
            same_frames(back.frames, {make_frame(0us, 1, {0, 9, 3}), make_frame(40ms, 1, {0, 8, 0})}));
        EXPECT_EQ(back.end.duration, 100ms);
        const bool text = std::string_view(name).find("ost") == std::string_view::npos;
        EXPECT_EQ(*read_text_file(path, 1000) == "OLA Show\n1 0,9,3\n40\n1 0,8,0\n60\n", text);
    }
    for (const char* name : {"a", "a.wav", "ghostdmx"}) {
        const auto unknown = Recorder::create(folder.path / name);
        ASSERT_FALSE(unknown.ok());
        EXPECT_NE(unknown.error().text().find(".ghostdmx"), std::string::npos);
    }
}

TEST(Recorder, a_killed_one_leaves_a_readable_part_file_and_the_old_recording) {
    const TestFolder folder;
    for (const char* name : {"a.show", "a.ghostdmx"}) {
        const fs::path path = folder.path / name;
        ASSERT_TRUE(write_file_atomic(path, std::string_view("old")).ok());
        {
            auto recorder = Recorder::create(path);
            ASSERT_TRUE(recorder.ok());
            ASSERT_TRUE(recorder->append(make_frame(0us, 1, {5})).ok());
            ASSERT_TRUE(recorder->flush(3s).ok());
            const ReadBack part = read_back(path.string() + ".part"); // while it still runs
            ASSERT_TRUE(part.ok) << part.error;
            EXPECT_EQ(part.frames.size(), 1u);
        }
        EXPECT_EQ(*read_text_file(path, 10), "old");
        EXPECT_TRUE(fs::exists(path.string() + ".part"));
    }
}

TEST(Recorder, what_a_killed_one_left_is_kept_under_another_name) {
    const TestFolder folder;
    const fs::path path = folder.path / "night.ghostdmx";
    for (int crash = 0; crash < 2; ++crash) {
        auto recorder = Recorder::create(path);
        ASSERT_TRUE(recorder.ok());
        ASSERT_TRUE(recorder->append(make_frame(0us, 1, {static_cast<std::uint8_t>(5 + crash)})).ok());
        ASSERT_TRUE(recorder->flush(3s).ok());
    }
    {
        auto empty = Recorder::create(path); // sees nothing, and takes nothing with it
        ASSERT_TRUE(empty.ok());
        EXPECT_EQ(empty->kept(), folder.path / "night.unfinished-2.ghostdmx");
    }
    for (const int number : {1, 2}) {
        const ReadBack kept =
            read_back(folder.path / ("night.unfinished-" + std::to_string(number) + ".ghostdmx"));
        ASSERT_TRUE(kept.ok) << kept.error;
        ASSERT_EQ(kept.frames.size(), 1u);
    }
    EXPECT_FALSE(fs::exists(path.string() + ".part"));
}

TEST(Recorder, two_do_not_write_one_file) {
    const TestFolder folder;
    const fs::path path = folder.path / "night.ghostdmx";
    auto first = Recorder::create(path);
    ASSERT_TRUE(first.ok());
    ASSERT_TRUE(first->append(make_frame(0us, 1, {5})).ok());
    ASSERT_TRUE(first->flush(3s).ok());
    const auto second = Recorder::create(path);
    ASSERT_FALSE(second.ok());
    EXPECT_NE(second.error().text().find("another program is recording into it"), std::string::npos);
    ASSERT_TRUE(first->finish(4s).ok());
    EXPECT_TRUE(read_back(path).ok);
}

TEST(Recorder, one_that_saw_nothing_leaves_nothing) {
    const TestFolder folder;
    { ASSERT_TRUE(Recorder::create(folder.path / "a.show").ok()); }
    { ASSERT_TRUE(Recorder::create(folder.path / "a.ghostdmx").ok()); }
    auto discarded = Recorder::create(folder.path / "b.ghostdmx");
    ASSERT_TRUE(discarded.ok());
    ASSERT_TRUE(discarded->append(make_frame(0us, 1, {5})).ok());
    discarded->discard();
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(Recorder, errors_name_the_file) {
    const auto missing = Recorder::create("/nonexistent/folder/a.show");
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(missing.error().where.find("/nonexistent/folder/a.show"), std::string::npos);
    const TestFolder folder;
    EXPECT_FALSE(Recorder::create(folder.path).ok()); // a folder cannot be replaced
    EXPECT_FALSE(Recorder::create("").ok());
    const std::string long_name = std::string(300, 'a') + ".show";
    const auto too_long = Recorder::create(folder.path / long_name);
    ASSERT_FALSE(too_long.ok());
    EXPECT_NE(too_long.error().text().find(long_name), std::string::npos);
    EXPECT_FALSE(read_recording(folder.path / long_name).ok());
}

#if !defined(_WIN32) // which has no limit for the size of a file
TEST(Recorder, a_full_disk_is_an_error_and_what_was_written_stays) {
    const TestFolder folder;
    for (const char* name : {"a.show", "a.ghostdmx"}) {
        auto recorder = Recorder::create(folder.path / name);
        ASSERT_TRUE(recorder.ok());
        ASSERT_TRUE(recorder->append(make_frame(0us, 1, {1, 2, 3})).ok());
        ASSERT_TRUE(recorder->flush(0us).ok());
        rlimit before{};
        ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
        const rlimit small{recorder->bytes() + 3, before.rlim_max};
        signal(SIGXFSZ, SIG_IGN);
        ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto appended = recorder->append(make_frame(10ms, 1, {4, 5, 6}));
        const auto flushed = recorder->flush(10ms);
        ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
        const Result<void>& failed = appended.ok() ? flushed : appended;
        ASSERT_FALSE(failed.ok());
        EXPECT_NE(failed.error().where.find(std::string(name) + ".part"), std::string::npos);
        const ReadBack part = read_back((folder.path / name).string() + ".part");
        ASSERT_TRUE(part.ok) << part.error;
        EXPECT_EQ(part.frames.size(), 1u);
    }
}
#endif

} // namespace
} // namespace ghost::dmx
