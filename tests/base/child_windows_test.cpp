// SPDX-License-Identifier: Apache-2.0
#include "base/child.h"

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace ghost {
namespace {

TEST(Child, tells_what_it_said_and_how_it_ended) {
    const auto short_one = run_child({"cmd", "/c", "echo one& echo two 1>&2& exit 3"}, "", false);
    ASSERT_TRUE(short_one.ok()) << short_one.error().text();
    EXPECT_EQ(short_one->output, "one\r\ntwo \r\n");
    EXPECT_EQ(short_one->exit_code, 3);
    for (const char* const name : {"no_such_program", "C:/nowhere/program"}) {
        const auto missing = run_child({name}, "", false);
        ASSERT_FALSE(missing.ok());
        EXPECT_EQ(missing.error().where, name);
    }
}

TEST(Child, starts_in_the_folder_that_is_asked_for) {
    const TestFolder folder;
    const auto result = run_child({"cmd", "/c", "cd"}, folder.path, false);
    ASSERT_TRUE(result.ok()) << result.error().text();
    EXPECT_NE(result->output.find(folder.path.filename().string()), std::string::npos) << result->output;
}

TEST(Child, of_what_it_said_the_last_is_kept) {
    const TestFolder folder;
    for (const std::size_t bytes :
         {kMostChildOutput - 1, kMostChildOutput, kMostChildOutput + 1, 3 * kMostChildOutput}) {
        std::ofstream(folder.path / "said", std::ios::binary) << std::string(bytes - 3, 'x') << "end";
        const auto result = run_child({"cmd", "/c", "type said"}, folder.path, false);
        ASSERT_TRUE(result.ok()) << result.error().text();
        EXPECT_EQ(result->output.size(), std::min(bytes, kMostChildOutput)) << bytes;
        EXPECT_TRUE(result->output.ends_with("xend")) << bytes;
    }
}

TEST(Child, a_batch_file_is_none) {
    const TestFolder folder;
    std::ofstream(folder.path / "tool.bat") << "echo %1\r\n";
    const auto result = run_child({(folder.path / "tool.bat").string(), "a"}, "", false);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().what, "cannot be started: it is a batch file, expected a program");
}

TEST(Child, several_are_waited_for) {
    const auto slow = start_child({"cmd", "/c", "ping -n 3 127.0.0.1 >nul"});
    const auto quick = start_child({"cmd", "/c", "exit 0"});
    ASSERT_TRUE(slow.ok() && quick.ok());
    std::vector<int> ended{wait_for_child(), wait_for_child()};
    std::sort(ended.begin(), ended.end());
    std::vector<int> expected{*slow, *quick};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(ended, expected);
    EXPECT_EQ(wait_for_child(), -1);
}

} // namespace
} // namespace ghost
