// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <gtest/gtest.h>

namespace ghost {
namespace {

TEST(Files, temporaries_of_those_who_live_are_in_use) {
    EXPECT_TRUE(is_temporary_in_use(temporary_beside("/show/.ghost/light_1.extra.exr")));
    EXPECT_TRUE(is_temporary_in_use(temporary_beside("/show/manifest")));
    EXPECT_FALSE(is_temporary_in_use("/show/.light_1.part999999999_0.exr")); // no process has such a number
    EXPECT_FALSE(is_temporary_in_use("/show/light_1.part1_0.exr"));
    EXPECT_FALSE(is_temporary_in_use("/show/light_1.exr"));
}

} // namespace
} // namespace ghost
