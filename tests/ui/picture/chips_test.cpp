// SPDX-License-Identifier: Apache-2.0
// The chips over the picture: where its levels come from, and whether they still do.
#include "support/test_window.h"
#include "ui/picture/private/chips.h"
#include "ui/widgets/theme.h"

namespace ghost::ui {
namespace {

struct Heard : Bench {
    Heard() { open(); }
    // Universes 1, 2 ... each silent for so many seconds; below 0: it is sent.
    Chip of(const std::vector<int>& silent_s) {
        RigNow rig = four_lit();
        rig.from_desk = true;
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        for (const int seconds : silent_s) {
            dmx::Universe& universe =
                rig.universes.at(static_cast<std::uint16_t>(rig.universes.list.size() + 1));
            universe.lost = seconds >= 0;
            universe.arrival = now - std::chrono::seconds(std::max(seconds, 0));
        }
        link.rig.put(std::move(rig));
        link.on_news();
        settle();
        return chips_of(app).front();
    }
};

TEST(Chips, a_desk_that_sends_no_more_is_told_from_one_that_does) {
    Heard heard;
    EXPECT_EQ(heard.of({}).text, "NO DESK YET");
    EXPECT_EQ(heard.of({-1, -1}).text, "LIVE DESK");
    EXPECT_EQ(heard.of({-1, -1}).ground, good());
    const Chip silent = heard.of({40, 12});
    EXPECT_EQ(silent.text, "DESK SILENT 12 s") << "since the newest packet";
    EXPECT_EQ(silent.ground, bad());
    const Chip in_part = heard.of({-1, 12, 13});
    EXPECT_EQ(in_part.text, "LIVE DESK, 2 universes silent");
    EXPECT_NE(in_part.ground, good());
}

TEST(Chips, what_a_remote_control_holds_is_told_from_what_the_window_does) {
    Heard heard;
    const auto words = [&](const RemoteNow& remote) {
        RigNow rig = four_lit();
        rig.remote = remote;
        heard.link.rig.put(std::move(rig));
        heard.link.on_news();
        settle();
        QStringList all;
        for (const Chip& chip : chips_of(heard.app)) all << chip.text;
        return all;
    };
    EXPECT_FALSE(words({}).join("|").contains("remote"));
    const QStringList held =
        words({.master = 0.25f, .black_out = true, .haze = 2, .ev100 = 12.0f, .tone = image::Tone::linear});
    EXPECT_EQ(held.front(), "BLACK-OUT (remote)");
    for (const char* const one :
         {"MASTER 25 % (remote)", "EV 0.0 (remote)", "HAZE x 2 (remote)", "TONE linear (remote)"})
        EXPECT_TRUE(held.contains(one)) << one << " in " << held.join("|").toStdString();
    EXPECT_FALSE(held.contains("BLACK-OUT"));
}

// Twenty seconds of the show before would pass for a window that has not understood.
TEST(Chips, another_show_that_is_opened_is_said_first) {
    Heard heard;
    heard.app.open("/home/me/shows/tour/show.toml");
    heard.link.activity.put("opening /home/me/shows/tour/show.toml");
    heard.link.on_news();
    settle();
    const Chip opening = chips_of(heard.app).front();
    EXPECT_EQ(opening.text, "opening /home/me/shows/tour/show.toml");
    EXPECT_TRUE(opening.is_loud);
    heard.link.activity.put("");
    heard.link.on_news();
    settle();
    EXPECT_EQ(chips_of(heard.app).front().text, "NO DESK YET");
}

TEST(Chips, shadows_that_are_missing_are_those_of_lights_that_shine) {
    Bench bench;
    bench.link.opened.put(four_lamps());
    const auto chips = [&](std::size_t maps, std::size_t shadows, std::size_t left_dark) {
        Picture picture;
        picture.missing_maps = maps;
        picture.missing_shadows = shadows;
        picture.left_dark = left_dark;
        bench.link.picture.put(std::move(picture));
        bench.link.on_news();
        settle();
        QStringList words;
        for (const Chip& chip : chips_of(bench.app)) words << chip.text;
        return words.join("|").toStdString();
    };
    EXPECT_EQ(chips(65, 0, 0).find("shadows"), std::string::npos);
    EXPECT_NE(chips(65, 3, 0).find("3 lights throw no shadows yet"), std::string::npos);
    EXPECT_NE(chips(65, 0, 24).find("24 heads that nobody asks left dark"), std::string::npos);
}

TEST(Chips, an_edit_that_is_read_is_said_behind_what_stands_there) {
    Heard heard;
    heard.link.activity.put("taking the changes of tour/show.toml");
    heard.link.on_news();
    settle();
    const std::vector<Chip> chips = chips_of(heard.app);
    EXPECT_EQ(chips.front().text, "NO DESK YET");
    EXPECT_EQ(chips.back().text, "taking the changes of tour/show.toml");
    EXPECT_FALSE(chips.back().is_loud);
}

} // namespace
} // namespace ghost::ui
