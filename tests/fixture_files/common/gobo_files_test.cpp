// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/gobo_files.h"

#include "disk/files.h"
#include "image/ldr.h"

#include <gtest/gtest.h>

namespace ghost::fixture {
namespace {

std::filesystem::path scratch() {
    const auto folder = std::filesystem::path(testing::TempDir()) / "ghost_gobo_files_test";
    std::filesystem::create_directories(folder);
    return folder;
}

TEST(GoboFiles, a_damaged_picture_is_taken_and_that_is_said) {
    const auto folder = scratch();
    ASSERT_TRUE(image::write_png(folder / "whole.png", image::Image8(8, 8, 3)).ok());
    auto bytes = read_file(folder / "whole.png", 1u << 20);
    ASSERT_TRUE(bytes.ok());
    (*bytes)[bytes->size() - 13] ^= 1; // of the checksum of its pixels
    ASSERT_TRUE(write_file_atomic(folder / "odd.png", Bytes(*bytes)).ok());

    Type type;
    GoboFiles gobos({folder});
    const auto whole = gobos.find(type, "whole.png");
    EXPECT_EQ(whole.media, 0);
    EXPECT_EQ(whole.problem, "");
    const auto odd = gobos.find(type, "odd.png");
    EXPECT_EQ(odd.media, 1);
    EXPECT_EQ(odd.problem, "the picture is damaged: IDAT: CRC error");
}

} // namespace
} // namespace ghost::fixture
