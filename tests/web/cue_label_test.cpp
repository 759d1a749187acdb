// SPDX-License-Identifier: Apache-2.0
// Which cue browsers are told that a show is in.
#include "web/private/cue_label.h"

#include <gtest/gtest.h>

namespace ghost::web {
namespace {

scene::Show show_of(std::vector<scene::Cue> cues) {
    scene::Show show;
    show.cues = std::move(cues);
    return show;
}

TEST(CueLabel, follows_the_recording) {
    const scene::Show show = show_of({{.name = "Verse", .at_s = 20}, {.name = "Walk-in", .at_s = 5}});
    CueLabel label;
    EXPECT_EQ(label.name(show, 0, 0), "");
    EXPECT_EQ(label.name(show, 5, 0), "Walk-in");
    EXPECT_EQ(label.name(show, 19.9, 0), "Walk-in");
    EXPECT_EQ(label.name(show, 90, 0), "Verse");
    EXPECT_EQ(label.name(show, std::nullopt, 0), "") << "a desk plays";
}

TEST(CueLabel, names_no_cue_whose_look_nobody_recalled) {
    const scene::Show show =
        show_of({{.name = "Verse", .at_s = 20}, {.name = "Night", .at_s = 20, .look = "Blue"}});
    CueLabel label;
    EXPECT_EQ(label.name(show, 76, 0), "Verse");
    label.call("Night", 100);
    EXPECT_EQ(label.name(show, 76, 100), "Night") << "while the recording jumps";
    EXPECT_EQ(label.name(show, 21, 102), "Night");
}

TEST(CueLabel, is_the_one_that_was_called_until_the_recording_comes_by_another) {
    const scene::Show show = show_of(
        {{.name = "Verse", .at_s = 20}, {.name = "Solo", .at_s = 40}, {.name = "Close", .camera = "close"}});
    CueLabel label;
    label.call("Close", 0);
    EXPECT_EQ(label.name(show, 25, 2), "Close");
    EXPECT_EQ(label.name(show, 39, 16), "Close");
    EXPECT_EQ(label.name(show, 40, 17), "Solo");
    label.call("Verse", 20);
    EXPECT_EQ(label.name(show, 41, 20.5), "Verse") << "while the recording jumps";
    EXPECT_EQ(label.name(show, 21, 22), "Verse");
    EXPECT_EQ(label.name(show, 40, 41), "Solo");
    label.call("Close", 50);
    EXPECT_EQ(label.name(show, std::nullopt, 60), "Close");
    label.call("Gone", 70);
    EXPECT_EQ(label.name(show, 50, 80), "Solo") << "no cue of this show";
    label.call("Solo", 90);
    EXPECT_EQ(label.name(show, 41, 92), "Solo");
    EXPECT_EQ(label.name(show, 21, 99), "Verse") << "somebody sent the recording back";
    EXPECT_EQ(label.name(show, 45, 120), "Solo");
    label.call("Verse", 130);
    EXPECT_EQ(label.name(show, 22, 132), "Verse");
    EXPECT_EQ(label.name(show, 2, 140), "") << "it began anew";
}

} // namespace
} // namespace ghost::web
