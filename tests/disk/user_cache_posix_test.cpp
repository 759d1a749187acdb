// SPDX-License-Identifier: Apache-2.0
#include "disk/user_cache.h"

#include "disk/files.h"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <unistd.h>

namespace ghost {
namespace {

namespace fs = std::filesystem;

class UserCache : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(root_);
        fs::create_directories(show_);
        fs::create_directories(cache_);
        fs::permissions(cache_, fs::perms::all);
        fs::permissions(show_, fs::perms(0555));
    }
    void TearDown() override {
        fs::permissions(show_, fs::perms::all);
        fs::remove_all(root_);
    }
    // To root nothing is read-only, so a child of another user asks.
    void as_a_user(const std::function<bool()>& holds) const {
        EXPECT_EXIT(
            {
                ::setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
                if (::geteuid() == 0 && ::setuid(65534) != 0) std::_Exit(2);
                std::_Exit(holds() ? 0 : 1);
            },
            testing::ExitedWithCode(0), "");
    }

    fs::path root_ = fs::path("/tmp") / ("ghost_user_cache_" + std::to_string(::getpid())),
             show_ = root_ / "show", cache_ = root_ / "cache";
};

TEST_F(UserCache, stands_for_the_folder_of_a_show_that_cannot_be_written) {
    as_a_user([&] {
        const fs::path found = user_cache_for(show_);
        return found.parent_path() == cache_ / "ghostlight" && found.filename().string().size() == 16 &&
               found == user_cache_for(show_ / ".." / "show") &&
               make_folders(found / "passes", cache_).ok() && fs::is_directory(found / "passes") &&
               !fs::exists(show_ / ".ghost");
    });
}

TEST_F(UserCache, is_not_needed_where_the_folder_can_be_written_or_has_been) {
    fs::permissions(show_, fs::perms::all);
    as_a_user([&] { return user_cache_for(show_).empty(); });
    fs::create_directory(show_ / ".ghost");
    fs::permissions(show_, fs::perms(0555));
    as_a_user([&] { return user_cache_for(show_).empty(); });
    as_a_user([&] { return user_cache_for(root_ / "none").empty(); });
}

TEST_F(UserCache, of_its_own_is_made_and_relative_ones_mean_nothing) {
    as_a_user([&] {
        ::unsetenv("XDG_CACHE_HOME");
        ::setenv("HOME", cache_.c_str(), 1);
        return user_cache_for(show_).parent_path() == cache_ / ".cache" / "ghostlight" &&
               fs::is_directory(cache_ / ".cache");
    });
    as_a_user([&] {
        ::setenv("XDG_CACHE_HOME", "cache", 1);
        ::setenv("HOME", "/nowhere/of/mine", 1);
        return user_cache_for(show_).empty();
    });
}

TEST_F(UserCache, is_reached_through_no_link) {
    fs::create_directory(root_ / "other");
    fs::permissions(root_ / "other", fs::perms::all);
    fs::create_directory_symlink(root_ / "other", cache_ / "ghostlight");
    as_a_user([&] {
        const fs::path found = user_cache_for(show_);
        return !found.empty() && !make_folders(found, cache_).ok() && fs::is_empty(root_ / "other");
    });
}

} // namespace
} // namespace ghost
