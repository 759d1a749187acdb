// SPDX-License-Identifier: Apache-2.0
#include "live/session/passes_sources.h"

#include "disk/files.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

class PassesSources : public testing::Test {
protected:
    PassesSources() {
        show_.folder = folder_.path;
        show_.file = folder_.path / "show.toml";
        EXPECT_TRUE(write_file_atomic(show_.file, std::string_view("[show]\n")).ok());
        EXPECT_TRUE(write_file_atomic(folder_.path / "a.gdtf", std::string_view("a lamp")).ok());
        EXPECT_TRUE(write_file_atomic(folder_.path / "b.gdtf", std::string_view("another")).ok());
        hang("a.gdtf");
    }
    void hang(const std::string& gdtf) { show_.fixtures.emplace_back().gdtf = gdtf; }

    const TestFolder folder_;
    scene::Show show_;
};

TEST_F(PassesSources, AnotherFileOrContentIsAnotherFingerprint) {
    const std::string before = passes_fingerprint(show_);
    EXPECT_EQ(passes_fingerprint(show_), before);
    ASSERT_TRUE(write_file_atomic(folder_.path / "a.gdtf", std::string_view("a lamb")).ok());
    const std::string after = passes_fingerprint(show_);
    EXPECT_NE(after, before);
    hang("b.gdtf");
    EXPECT_NE(passes_fingerprint(show_), after);
}

// Hundreds of spellings of one file, or links to it, of a gigabyte were hours.
TEST_F(PassesSources, AFileOfManyNamesIsReadOnce) {
    const std::string once = passes_fingerprint(show_);
    std::string name = "a.gdtf";
    for (int k = 0; k < 100; ++k) hang(name = "./" + name);
    fs::create_symlink("a.gdtf", folder_.path / "z.gdtf");
    hang("z.gdtf");
    EXPECT_EQ(passes_fingerprint(show_), once);
}

TEST_F(PassesSources, OfWhatIsTooLargeSizeAndTimeCount) {
    hang("b.gdtf");
    constexpr std::uintmax_t kOnlyA = 6; // bytes
    const std::string before = passes_fingerprint(show_, kOnlyA);
    EXPECT_NE(passes_fingerprint(show_), before);
    const fs::file_time_type time = fs::last_write_time(folder_.path / "b.gdtf");
    ASSERT_TRUE(write_file_atomic(folder_.path / "b.gdtf", std::string_view("amother")).ok());
    fs::last_write_time(folder_.path / "b.gdtf", time);
    EXPECT_EQ(passes_fingerprint(show_, kOnlyA), before) << "it is not read";
    fs::last_write_time(folder_.path / "b.gdtf", time + std::chrono::seconds(1));
    EXPECT_NE(passes_fingerprint(show_, kOnlyA), before);
}

} // namespace
} // namespace ghost::app
