// SPDX-License-Identifier: Apache-2.0
// Folders of this machine in what viewers read: taken out where a path begins, whole names only.
#include "show/show.h"
#include "web/private/own_folders.h"

#include <gtest/gtest.h>

namespace ghost::web {
namespace {

std::string read_by_viewers(const std::string& text) {
    scene::Show show;
    show.folder = "/srv/tour/show";
    show.file = "/srv/tour/show/show.toml";
    OwnFolders folders;
    folders.take(&show, std::vector<Message>{{Severity::warning, "/tmp/lib/a.gdtf", "is damaged"}});
    return folders.taken_out(text);
}

TEST(OwnFolders, are_taken_out_where_a_path_begins) {
    EXPECT_EQ(read_by_viewers("/srv/tour/show/show.toml:12: no such lamp"), "show.toml:12: no such lamp");
    EXPECT_EQ(read_by_viewers("opening '/srv/tour/show/fixtures/a.gdtf', /tmp/lib/b.gdtf"),
              "opening 'fixtures/a.gdtf', b.gdtf");
    EXPECT_EQ(read_by_viewers("../../../../tmp/lib/cut2.gdtf: is damaged"),
              "../../../../tmp/lib/cut2.gdtf: is damaged");
    EXPECT_EQ(read_by_viewers("media/tmp/lib/cut2.gdtf"), "media/tmp/lib/cut2.gdtf");
}

TEST(OwnFolders, go_by_their_last_name_where_nothing_follows) {
    EXPECT_EQ(read_by_viewers("/srv/tour/show is not a folder"), "show is not a folder");
    EXPECT_EQ(read_by_viewers("not written: '/srv/tour/show'"), "not written: 'show'");
    EXPECT_EQ(read_by_viewers("there is no /srv/tour/show."), "there is no show.");
    EXPECT_EQ(read_by_viewers("/srv/tour/show"), "show");
    EXPECT_EQ(read_by_viewers("/srv/tour/shows/a.mvr"), "/srv/tour/shows/a.mvr");
    EXPECT_EQ(read_by_viewers("/srv/tour/show.mvr"), "/srv/tour/show.mvr");
}

TEST(OwnFolders, ones_home_has_no_name) {
    const char* const home = std::getenv("HOME");
    const std::string before = home ? home : "";
    setenv("HOME", "/home/joe", 1);
    EXPECT_EQ(read_by_viewers("/home/joe is full; /home/joe/old/a.mvr"), "~ is full; old/a.mvr");
    if (home)
        setenv("HOME", before.c_str(), 1);
    else
        unsetenv("HOME");
}

} // namespace
} // namespace ghost::web
