// SPDX-License-Identifier: Apache-2.0
#include "disk/files.h"

#include "disk/temporary.h"

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

// As another machine of a farm names it: 999999999 lives nowhere, but that cannot be seen from here.
constexpr const char* kOfAnotherMachine = "/show/.light_1.part999999999_4294967303.exr";

TEST(Files, temporaries_of_other_machines_are_in_use_whatever_lives_here) {
    EXPECT_EQ(writer_of(kOfAnotherMachine), Writer::elsewhere);
    EXPECT_TRUE(is_temporary_in_use(kOfAnotherMachine));
    EXPECT_EQ(writer_of(temporary_beside("/show/light_1.exr")), Writer::here);
    EXPECT_EQ(writer_of("/show/.light_1.part999999999_0.exr"), Writer::gone);
    EXPECT_EQ(writer_of("/show/light_1.exr"), Writer::none);
    EXPECT_NE(temporary_beside("/show/light_1.exr"), temporary_beside("/show/light_1.exr"));
}

} // namespace
} // namespace ghost
