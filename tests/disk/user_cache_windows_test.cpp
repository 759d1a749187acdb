// SPDX-License-Identifier: Apache-2.0
#include "disk/user_cache.h"

#include "support/test_folder.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace ghost {
namespace {

TEST(UserCache, is_in_the_folder_of_this_machines_programs_or_where_it_is_asked_for) {
    const std::filesystem::path state = user_state();
    EXPECT_TRUE(state.is_absolute()) << state;
    EXPECT_EQ(state.filename(), "ghostlight");
    EXPECT_EQ(state.parent_path().filename(), "Local") << state;
    const TestFolder folder;
    ::_wputenv_s(L"XDG_STATE_HOME", folder.path.c_str());
    EXPECT_EQ(user_state(), folder.path / "ghostlight");
    ::_wputenv_s(L"XDG_STATE_HOME", L"state");
    EXPECT_EQ(user_state(), state) << "relative ones mean nothing";
    ::_wputenv_s(L"XDG_STATE_HOME", L"");
}

TEST(UserCache, is_not_needed_where_the_folder_can_be_written) {
    const TestFolder folder;
    EXPECT_TRUE(user_cache_for(folder.path).empty());
    EXPECT_TRUE(user_cache_for(folder.path / "none").empty());
}

} // namespace
} // namespace ghost
