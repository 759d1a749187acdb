// SPDX-License-Identifier: Apache-2.0
#include "base/child.h"

#include <gtest/gtest.h>

namespace ghost {
namespace {

Result<ChildResult> says(std::size_t bytes) {
    return run_child(
        {"sh", "-c", "head -c " + std::to_string(bytes - 3) + " /dev/zero | tr '\\0' x; printf end; exit 3"},
        "", false);
}

TEST(Child, tells_what_it_said_and_how_it_ended) {
    const auto short_one = says(10);
    ASSERT_TRUE(short_one.ok()) << short_one.error().text();
    EXPECT_EQ(short_one->output, "xxxxxxxend");
    EXPECT_EQ(short_one->exit_code, 3);
    const auto killed = run_child({"sh", "-c", "kill -9 $$"}, "", false);
    ASSERT_TRUE(killed.ok()) << killed.error().text();
    EXPECT_EQ(killed->exit_code, 128 + 9);
    const auto missing = run_child({"/nowhere/program"}, "", false);
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().where, "/nowhere/program");
}

TEST(Child, of_what_it_said_the_last_is_kept) {
    for (const std::size_t bytes : {kMostChildOutput, kMostChildOutput + 1, 3 * kMostChildOutput}) {
        const auto result = says(bytes);
        ASSERT_TRUE(result.ok()) << result.error().text();
        EXPECT_EQ(result->output.size(), kMostChildOutput) << bytes;
        EXPECT_TRUE(result->output.ends_with("xend")) << bytes;
    }
    EXPECT_EQ(says(kMostChildOutput - 1)->output.size(), kMostChildOutput - 1);
}

} // namespace
} // namespace ghost
