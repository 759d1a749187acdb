// SPDX-License-Identifier: Apache-2.0
// Links of bounced light that were stopped go on where they were, to the same bytes, whatever became of their
// parts.
#include "bounce/bounce_parts.h"

#include "bake/bounce.h"
#include "bounce/bounce_file.h"
#include "disk/crc32.h"
#include "disk/files.h"
#include "support/must.h"
#include "support/test_folder.h"
#include "support/test_stage.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::bake {
namespace {

namespace fs = std::filesystem;

const std::string kKey(32, 'a');

class BouncePartsTest : public testing::Test {
protected:
    BouncePartsTest() : stage_(edgy_stage()), tracer_(stage_) {
        options_.box = {{-10, -3, -1}, {10, 13, 9}};
        options_.seeds_m = {{0, 0, 5}};
        options_.most_surfels = 6000;
        options_.most_cells = 2000;
        options_.rays_of_surfel = options_.rays_of_cell = options_.rays_of_block = 32;
        expected_ = bytes_of(must(make_bounce(tracer_, options_)));
    }

    fs::path links() const { return folder_.path / ".ghost" / "bounce" / "normal.bin"; }

    std::vector<std::uint8_t> bytes_of(const scene::Bounce& bounce) const {
        const fs::path file = folder_.path / "bounce.bin";
        EXPECT_TRUE(scene::write_bounce(file, kKey, bounce).ok());
        return must(read_file(file, 1 << 30));
    }

    // Stopped when that much of the work is told; 2: never.
    bool make(double stop_at, const std::string& key = kKey) {
        scene::BounceParts parts(links(), folder_.path, key);
        BounceOptions options = options_;
        options.parts = &parts;
        if (stop_at < 1) options.threads = 1; // nodes in their order, so that parts are whole one by one
        std::atomic<bool> stops{false};
        options.stop = [&] { return stops.load(); };
        options.progress = [&](double fraction) {
            if (fraction >= stop_at) stops = true;
        };
        const auto made = make_bounce(tracer_, options);
        failure_ = parts.take_failure();
        if (made.ok()) {
            EXPECT_EQ(bytes_of(*made), expected_);
            parts.remove_all();
        }
        return made.ok();
    }

    std::map<std::string, fs::file_time_type> kept() const {
        std::map<std::string, fs::file_time_type> files;
        if (fs::exists(links().parent_path()))
            for (const auto& entry : fs::directory_iterator(links().parent_path()))
                files[entry.path().filename().string()] = fs::last_write_time(entry.path());
        return files;
    }

    const TestFolder folder_;
    const scene::Stage stage_;
    const Tracer tracer_;
    BounceOptions options_;
    std::vector<std::uint8_t> expected_;
    std::optional<Error> failure_;
};

TEST_F(BouncePartsTest, WhatWasMadeIsTakenUp) {
    std::map<std::string, fs::file_time_type> before;
    for (const double stop_at : {0.1, 0.3, 0.45, 0.7}) {
        ASSERT_FALSE(make(stop_at));
        EXPECT_FALSE(failure_);
        const auto now = kept();
        EXPECT_GT(now.size(), before.size());
        for (const auto& [name, written] : before)
            EXPECT_EQ(now.at(name), written) << name << " is not made again";
        before = now;
    }
    EXPECT_TRUE(before.contains("normal.size.part"));
    EXPECT_TRUE(before.contains("normal.near-0.part"));
    EXPECT_TRUE(before.contains("normal.far-0.part"));
    ASSERT_TRUE(make(2));
    EXPECT_TRUE(kept().empty());
}

TEST_F(BouncePartsTest, PartsOfAnotherStageAreNotTaken) {
    ASSERT_FALSE(make(0.7, std::string(32, 'b')));
    ASSERT_GT(kept().size(), 2u);
    EXPECT_TRUE(make(2));
    EXPECT_FALSE(failure_);
    EXPECT_TRUE(kept().empty());
}

TEST_F(BouncePartsTest, DamagedPartsAreSaidAndMadeAgain) {
    const fs::path part = links().parent_path() / "normal.near-0.part";
    const auto with = [&](const auto& change, bool right_sum) {
        ASSERT_FALSE(make(0.7));
        std::vector<std::uint8_t> bytes = must(read_file(part, 1 << 30));
        bytes.resize(bytes.size() - 4);
        change(bytes);
        const std::uint32_t check = crc32(bytes) + (right_sum ? 0 : 1);
        for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<std::uint8_t>(check >> (8 * k)));
        ASSERT_TRUE(write_file_atomic(part, Bytes(bytes)).ok());
        EXPECT_TRUE(make(2));
        ASSERT_TRUE(failure_);
        EXPECT_NE(failure_->text().find("normal.near-0.part: is damaged"), std::string::npos)
            << failure_->text();
    };
    constexpr std::size_t kHead = 25 + 32; // then a count and the first link
    with([](auto&) {}, false);
    with([](auto& bytes) { bytes.resize(bytes.size() - 5); }, true);
    with([](auto& bytes) { bytes.push_back(0); }, true);
    for (const std::size_t at : {kHead + 3, kHead + 4 + 3, kHead + 8 + 3, kHead + 12 + 3, kHead + 16 + 3})
        with([&](auto& bytes) { bytes[at] = 0xff; }, true); // count, receiver, emitter, weight, distance
}

TEST_F(BouncePartsTest, ThePartsOfAShowAreNotReadOrWrittenThroughALink) {
    const fs::path elsewhere = folder_.path / "elsewhere";
    fs::create_directory(elsewhere);
    fs::create_directory_symlink(elsewhere, folder_.path / ".ghost");
    EXPECT_FALSE(make(0.7));
    ASSERT_TRUE(failure_);
    EXPECT_NE(failure_->what.find("would begin anew"), std::string::npos) << failure_->text();
    EXPECT_TRUE(fs::is_empty(elsewhere));
    fs::remove(folder_.path / ".ghost");
    ASSERT_FALSE(make(0.7));
    const fs::path part = links().parent_path() / "normal.near-0.part";
    fs::rename(part, elsewhere / "part");
    fs::create_symlink(elsewhere / "part", part);
    EXPECT_TRUE(make(2));
    EXPECT_TRUE(fs::exists(elsewhere / "part"));
}

TEST_F(BouncePartsTest, APartThatIsTooLargeIsSaid) {
    ASSERT_FALSE(make(0.7));
    fs::resize_file(links().parent_path() / "normal.near-0.part", (std::uintmax_t{256} << 20) + 1); // sparse
    EXPECT_TRUE(make(2));
    EXPECT_TRUE(failure_);
}

// Each by itself is small enough, as parts of two runs, or of a show that was made so.
TEST_F(BouncePartsTest, PartsAreReadUpToTheLimitOfAllOfThem) {
    const scene::FoundLink link{0, 0, 1, 1};
    std::vector<std::vector<scene::FoundLink>> rows(1);
    rows[0].assign((std::size_t{200} << 20) / sizeof link, link);
    for (const std::size_t first : {0u, 1u})
        scene::BounceParts(links(), folder_.path, kKey).keep(false, first, rows, {});
    ASSERT_EQ(kept().size(), 2u);
    rows[0] = {};
    scene::BounceLevel level;
    level.surfels.resize(1); // of which node 1 is none: what is read is not of use, but it is read
    scene::BounceParts parts(links(), folder_.path, kKey);
    (void)parts.take(level, false, 1, rows, {});
    const auto first = parts.take_failure();
    EXPECT_FALSE(first && first->text().find("all parts together") != std::string::npos);
    (void)parts.take(level, false, 0, rows, {});
    const auto second = parts.take_failure();
    ASSERT_TRUE(second.has_value());
    EXPECT_NE(second->text().find("and all parts together have at most 268435456"), std::string::npos)
        << second->text();
}

} // namespace
} // namespace ghost::bake
