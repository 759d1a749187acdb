// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_file.h"
#include "disk/files.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ghost::scene {
namespace {

const std::string kKey(32, 'a');

std::filesystem::path file_of(const std::string& text) {
    const auto file = std::filesystem::path(testing::TempDir()) / "ghost_bounce_file_test.bin";
    EXPECT_TRUE(write_file_atomic(file, text).ok());
    return file;
}

TEST(BounceFile, another_version_is_said) {
    const auto file = file_of("ghostlight bounce 1\n" + kKey + std::string(100, 'x'));
    const auto read = read_bounce(file, kKey);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().text(), file.string() + ": is of another version of Ghostlight; the links of "
                                                   "bounced light are made again, once");
}

TEST(BounceFile, another_key_is_no_error_and_damage_is_one) {
    const std::string head = "ghostlight bounce 4\n";
    const auto other = read_bounce(file_of(head + std::string(32, 'b') + std::string(100, 'x')), kKey);
    ASSERT_TRUE(other.ok());
    EXPECT_FALSE(other->has_value());
    for (const std::string& text : {std::string(), head, head + kKey + std::string(100, 'x'),
                                    "something else that is long enough" + std::string(100, 'x')}) {
        const auto read = read_bounce(file_of(text), kKey);
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_NE(read.error().what.find("is damaged"), std::string::npos) << read.error().what;
    }
}

Bounce room_of(const glm::ivec3& subs) {
    Bounce room;
    room.grid.sub_m = 0.25f;
    room.grid.subs = subs;
    room.cell_of.assign(room.grid.count(), kNoNode);
    room.near.start = room.far.start = {0};
    return room;
}

bool comes_back(const Bounce& room) {
    const auto file = file_of("");
    EXPECT_TRUE(write_bounce(file, kKey, room).ok());
    const auto read = read_bounce(file, kKey);
    std::filesystem::remove(file);
    return read.ok() && read->has_value();
}

TEST(BounceFile, a_room_that_is_larger_than_any_that_is_made_is_damaged) {
    EXPECT_TRUE(comes_back(room_of({200, 200, 200})));
    EXPECT_FALSE(comes_back(room_of({208, 200, 200}))) << "kMostBounceSubs";
}

TEST(BounceFile, so_many_cells_of_a_level_and_no_more) {
    Bounce room = room_of({8, 8, 8});
    BounceCell cell;
    cell.volume_m3 = 1;
    room.coarse.cells.assign(kMostBounceCells, cell);
    room.far.start.assign(room.coarse.slots() + 1, 0);
    EXPECT_TRUE(comes_back(room));
    room.coarse.cells.push_back(cell);
    room.far.start.assign(room.coarse.slots() + 1, 0);
    EXPECT_FALSE(comes_back(room)) << "kMostBounceCells";
}

} // namespace
} // namespace ghost::scene
