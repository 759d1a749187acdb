// SPDX-License-Identifier: Apache-2.0
#include "show_folder/hold.h"

#include "disk/files.h"
#include "disk/temporary.h"
#include "support/must.h"

#include <gtest/gtest.h>
#include <optional>
#include <sys/wait.h>
#include <unistd.h>

namespace ghost {
namespace {

namespace fs = std::filesystem;

class Holds : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(show_);
        fs::create_directories(show_);
    }
    void TearDown() override { fs::remove_all(show_); }
    Hold take(Hold::Other other = Hold::Other::keeps) const { return must(Hold::take(file_, show_, other)); }

    fs::path show_ = fs::path(testing::TempDir()) / "ghost_hold", file_ = show_ / ".ghost" / "window.lock";
};

TEST_F(Holds, one_has_it_and_says_who_it_is) {
    std::optional<Hold> first = take();
    EXPECT_TRUE(first->is_ours());
    {
        const Hold second = take();
        EXPECT_FALSE(second.is_ours());
        EXPECT_NE(second.holder().find("process " + std::to_string(::getpid()) + " on "), std::string::npos)
            << second.holder();
        EXPECT_NE(second.holder().find(", since 20"), std::string::npos) << second.holder();
    }
    EXPECT_TRUE(first->is_ours()); // who did not get it takes nothing away
    first.reset();
    EXPECT_FALSE(fs::exists(file_));
    EXPECT_TRUE(take().is_ours());
}

TEST_F(Holds, who_gives_way_sees_it_and_takes_nothing_back) {
    std::optional<Hold> first = take();
    const Hold second = take(Hold::Other::gives_way);
    EXPECT_TRUE(second.is_ours());
    EXPECT_FALSE(first->is_ours());
    first.reset();
    EXPECT_TRUE(second.is_ours());
    EXPECT_FALSE(take().is_ours());
}

TEST_F(Holds, who_was_killed_holds_nothing) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto hold = Hold::take(file_, show_, Hold::Other::keeps);
        const char done = hold.ok() && hold->is_ours() ? 'y' : 'n';
        (void)!::write(ready[1], &done, 1);
        ::pause();
        ::_exit(0);
    }
    char done = 0;
    ASSERT_EQ(::read(ready[0], &done, 1), 1);
    EXPECT_EQ(done, 'y');
    EXPECT_FALSE(take().is_ours());
    EXPECT_NE(take().holder().find("process " + std::to_string(child)), std::string::npos);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(take().is_ours());
}

TEST_F(Holds, what_is_no_lock_of_ours_names_nobody) {
    fs::create_directories(file_.parent_path());
    ASSERT_TRUE(write_file_atomic(file_, host_name() + "\n1\n" + std::string(1100, 'x')).ok());
    const Hold hold = take();
    EXPECT_TRUE(hold.is_ours()) << "nobody locks it";
    ASSERT_TRUE(write_file_atomic(file_, host_name() + "\n1\n" + std::string(1100, 'x')).ok());
    EXPECT_FALSE(hold.is_ours());
    EXPECT_EQ(hold.holder().find(std::string(65, 'x')), std::string::npos);
    EXPECT_NE(hold.holder().find("process 0 on "), std::string::npos) << hold.holder();
}

TEST_F(Holds, nothing_is_written_through_a_link) {
    const fs::path letter = show_ / "letter.txt";
    ASSERT_TRUE(write_file_atomic(letter, std::string_view("dear")).ok());
    fs::create_directories(show_ / ".ghost");
    fs::create_symlink(letter, file_);
    EXPECT_FALSE(Hold::take(file_, show_, Hold::Other::gives_way).ok());
    EXPECT_EQ(*read_text_file(letter, 100), "dear");
}

} // namespace
} // namespace ghost
