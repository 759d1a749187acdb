// SPDX-License-Identifier: Apache-2.0
#include "base/helper_process.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace ghost {
namespace {

// As a program that links the library and whose main() knows no command of it: each of its helpers would
// start another one, until the memory is gone.
TEST(HelperProcess, AHelperStartsNoHelper) {
    ::setenv("GHOSTLIGHT_IS_HELPER", "1", 1);
    const auto helper = HelperProcess::start("--unknown");
    ::unsetenv("GHOSTLIGHT_IS_HELPER");
    ASSERT_FALSE(helper.ok());
    EXPECT_NE(helper.error().what.find("does not know '--unknown'"), std::string::npos);
}

TEST(HelperProcess, KnowsThatItIsOne) {
    auto helper = HelperProcess::start("--gtest_filter=HelperProcess.IsTold");
    ASSERT_TRUE(helper.ok()) << helper.error().text();
    std::uint8_t byte = 0;
    EXPECT_FALSE(helper->stream().receive({&byte, 1})); // until it has ended
    EXPECT_EQ(helper->end(), "exit code 0");
}

// What the one above starts.
TEST(HelperProcess, IsTold) {
    if (!std::getenv("GHOSTLIGHT_IS_HELPER")) return;
    EXPECT_FALSE(HelperProcess::start("--unknown").ok());
}

} // namespace
} // namespace ghost
