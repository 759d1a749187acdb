// SPDX-License-Identifier: Apache-2.0
#include "base/memory.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace ghost {
namespace {

namespace fs = std::filesystem;

class MemoryTest : public testing::Test {
protected:
    void SetUp() override { fs::remove_all(root_); }
    void TearDown() override { fs::remove_all(root_); }
    void write(const std::string& path, const std::string& text) const {
        fs::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }
    fs::path root_ = fs::path(testing::TempDir()) / "ghost_memory";
};

TEST_F(MemoryTest, nothing_is_known_where_nothing_says) {
    EXPECT_EQ(free_memory_bytes(root_), 0u);
}

TEST_F(MemoryTest, the_machines_is_what_is_available) {
    write("proc/meminfo", "MemTotal:       8000 kB\nMemFree:         100 kB\nMemAvailable:   3000 kB\n");
    EXPECT_EQ(free_memory_bytes(root_), 3000u * 1024);
}

TEST_F(MemoryTest, a_container_may_have_less) {
    write("proc/meminfo", "MemAvailable:   3000 kB\n");
    write("proc/self/cgroup", "0::/box/inner\n");
    write("sys/fs/cgroup/box/inner/memory.max", "max\n");
    write("sys/fs/cgroup/box/inner/memory.current", "1000\n");
    EXPECT_EQ(free_memory_bytes(root_), 3000u * 1024);
    write("sys/fs/cgroup/box/memory.max", "50000\n");
    write("sys/fs/cgroup/box/memory.current", "20000\n");
    EXPECT_EQ(free_memory_bytes(root_), 30000u);
    write("sys/fs/cgroup/box/memory.stat", "anon 5000\ninactive_file 4000\nslab 7\n"); // given back at once
    EXPECT_EQ(free_memory_bytes(root_), 34000u);
    write("sys/fs/cgroup/box/memory.current", "60000\n"); // above
    EXPECT_EQ(free_memory_bytes(root_), 0u);
}

TEST_F(MemoryTest, what_this_program_has_is_its_resident_memory) {
    EXPECT_EQ(used_memory_bytes(root_), 0u);
    write("proc/self/status",
          "Name:\tghostlight 7\nUmask:\t0022\nVmHWM:\t  900 kB\nVmRSS:\t  700 kB\nThreads:\t3\n");
    EXPECT_EQ(used_memory_bytes(root_), 700u * 1024);
}

TEST_F(MemoryTest, this_machine_says_something) {
    EXPECT_GT(used_memory_bytes(), 1u << 20);
    EXPECT_GT(free_memory_bytes(), 1u << 20);
}

// As a window does that is resized: large blocks come and go, small ones stay between them.
TEST_F(MemoryTest, large_blocks_go_back_to_the_system) {
#if !defined(__GLIBC__) || defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "another C library, or a sanitizer's, keeps the blocks";
#endif
    return_large_blocks();
    const auto filled = [](std::size_t bytes) { return std::vector<char>(bytes, 'x'); };
    (void)filled(std::size_t{16} << 20); // glibc by itself learns to keep what is as large
    constexpr std::size_t kBlocks = 200, kBlock_bytes = std::size_t{1} << 20;
    std::vector<std::vector<char>> large, small;
    const std::uint64_t before = used_memory_bytes();
    for (std::size_t k = 0; k < kBlocks; ++k) {
        large.push_back(filled(kBlock_bytes));
        small.push_back(filled(1000));
    }
    EXPECT_GT(used_memory_bytes(), before + kBlocks * kBlock_bytes * 9 / 10);
    large.clear();
    EXPECT_LT(used_memory_bytes(), before + kBlocks * kBlock_bytes / 10);
}

} // namespace
} // namespace ghost
