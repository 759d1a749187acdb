// SPDX-License-Identifier: Apache-2.0
#include "support/must.h"
#include "support/test_recording.h"

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

const char kTwoUniverses[] = "OLA Show\n"
                             "1 255,0,10\n"
                             "40\n"
                             "3 7\n"
                             "0\n"
                             "1 254,0,10\n"
                             "1000\n";

Recording recording_of(std::string_view text) {
    return must(parse_recording(text, "x.show"));
}

TEST(Player, levels_by_time) {
    Player player(recording_of(kTwoUniverses));
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
    Player player(recording_of("OLA Show\n1 1\n10\n1 1\n10\n1 2\n10\n2 5\n0\n"));
    const Universes end = player.at(0.03), start = player.at(0.0), again = player.at(0.03);
    EXPECT_EQ(end.revision, again.revision);
    EXPECT_EQ(*end.find(1)->levels, *again.find(1)->levels);
    EXPECT_EQ(start.revision, player.at(0.01).revision); // the same levels sent again
    EXPECT_NE(player.at(0.01).revision, player.at(0.02).revision);
    EXPECT_EQ(player.at(0.02).find(1)->revision, end.find(1)->revision);
    EXPECT_NE(player.at(0.02).revision, end.revision);
    EXPECT_EQ(player.at(0.01).find(1)->arrival, std::chrono::nanoseconds(10ms));
}

// Every moment by walking, against the same moments by jumping, in both directions and at random.
TEST(Player, a_seek_gives_what_playing_up_to_there_gives) {
    const TestFolder folder;
    const auto frames = random_frames(11, 9000, 12);
    const auto file = write_bytes(folder.path / "a.ghostdmx", pack(frames, frames.back().time + 1s));
    Player walker(std::move(*read_recording(file)));
    ASSERT_GE(walker.recording().blocks(), 5u);
    std::vector<std::pair<double, Universes>> looks;
    // Those of the frames themselves, without any format between.
    Universes expected;
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        Universe& universe = expected.at(frames[i].universe);
        ++number;
        if (universe.revision == 0 || *universe.levels != *frames[i].levels)
            universe.revision = expected.revision = number;
        universe.levels = frames[i].levels;
        universe.lost = frames[i].lost;
        universe.arrival = frames[i].time;
        if (i + 1 < frames.size() && frames[i + 1].time == frames[i].time) continue;
        const double t_s = std::chrono::duration<double>(frames[i].time).count();
        ASSERT_TRUE(same_look(walker.at(t_s), expected)) << t_s;
        if (i % 7 == 0) looks.emplace_back(t_s, expected);
    }
    Player jumper(std::move(*read_recording(file)));
    for (auto look = looks.rbegin(); look != looks.rend(); ++look)
        ASSERT_TRUE(same_look(jumper.at(look->first), look->second)) << look->first;
    std::mt19937 random(5);
    for (int i = 0; i < 500; ++i) {
        const auto& [t_s, look] = looks[random() % looks.size()];
        ASSERT_TRUE(same_look(jumper.at(t_s), look)) << t_s;
    }
    EXPECT_TRUE(jumper.take_damage().empty());
}

TEST(Player, levels_that_were_handed_out_do_not_change) {
    Player player(recording_of("OLA Show\n1 1\n10\n1 2\n10\n1 3\n10\n"));
    const Universes first = player.at(0.0), second = player.at(0.01);
    EXPECT_EQ(player.at(0.02).level(1, 1), 3);
    EXPECT_EQ(first.level(1, 1), 1);
    EXPECT_EQ(second.level(1, 1), 2);
}

TEST(Player, lost_sources_are_lost_again) {
    const TestFolder folder;
    const auto file = write_bytes(
        folder.path / "a.ghostdmx",
        pack({make_frame(0us, 1, {9}), make_frame(2s, 1, {9}, true), make_frame(4s, 1, {9})}, 5s));
    Player player(std::move(*read_recording(file)));
    EXPECT_FALSE(player.at(1.9).find(1)->lost);
    EXPECT_TRUE(player.at(2.0).find(1)->lost);
    EXPECT_EQ(player.at(3.0).level(1, 1), 9);
    EXPECT_FALSE(player.at(4.0).find(1)->lost);
    EXPECT_EQ(player.at(4.0).revision, player.at(0.0).revision); // the levels never changed
}

TEST(Part, begins_with_the_levels_that_stand) {
    const TestFolder folder;
    const auto file =
        write_bytes(folder.path / "a.ghostdmx",
                    pack({make_frame(0us, 1, {1}), make_frame(0us, 2, {2}), make_frame(4s, 1, {3}),
                          make_frame(6s, 2, {4}), make_frame(8s, 1, {5}), make_frame(8s + 1us, 1, {6})},
                         10s));
    for (const double speed : {1.0, 2.0}) {
        PartOptions options;
        options.from = 5s;
        options.until = 8s;
        options.speed = speed;
        std::vector<RecordedFrame> frames;
        Part part(options, [&](const RecordedFrame& frame) -> Result<void> {
            frames.push_back(frame);
            return {};
        });
        for (const RecordedFrame& frame : read_back(file).frames) ASSERT_TRUE(part.take(frame).ok());
        EXPECT_TRUE(part.over());
        const auto scale = [&](std::chrono::microseconds time) {
            return std::chrono::microseconds(
                static_cast<std::int64_t>(static_cast<double>(time.count()) / speed));
        };
        EXPECT_EQ(*part.finish(10s), scale(3s));
        EXPECT_TRUE(same_frames(frames, {make_frame(0us, 1, {3}), make_frame(0us, 2, {2}),
                                         make_frame(scale(1s), 2, {4}), make_frame(scale(3s), 1, {5})}));
    }
}

TEST(Part, of_everything_is_everything) {
    const auto frames = random_frames(12, 300, 4);
    std::vector<RecordedFrame> taken;
    Part part({}, [&](const RecordedFrame& frame) -> Result<void> {
        taken.push_back(frame);
        return {};
    });
    for (const RecordedFrame& frame : frames) ASSERT_TRUE(part.take(frame).ok());
    EXPECT_TRUE(same_frames(taken, frames));
    EXPECT_EQ(*part.finish(frames.back().time + 3s), frames.back().time + 3s);
}

// The part of a long recording is read from the block where it begins, and is the same as from its start.
TEST(Part, of_a_long_recording_needs_few_blocks) {
    const TestFolder folder;
    const auto frames = random_frames(13, 9000, 12);
    const auto file = write_bytes(folder.path / "a.ghostdmx", pack(frames, frames.back().time));
    PartOptions options;
    options.from = frames[6000].time;
    options.until = frames[6100].time;
    const auto part_of = [&](const std::vector<RecordedFrame>& source) {
        std::vector<RecordedFrame> taken;
        Part part(options, [&](const RecordedFrame& frame) -> Result<void> {
            taken.push_back(frame);
            return {};
        });
        for (const RecordedFrame& frame : source) EXPECT_TRUE(part.take(frame).ok());
        EXPECT_TRUE(part.finish(frames.back().time).ok());
        return taken;
    };
    const ReadBack few = read_back(file, {}, options);
    EXPECT_LT(few.frames.size(), frames.size() / 2);
    EXPECT_TRUE(same_frames(part_of(few.frames), part_of(frames)));
}

} // namespace
} // namespace ghost::dmx
