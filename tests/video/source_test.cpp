// SPDX-License-Identifier: Apache-2.0
#include "video/source.h"

#include "image/ldr.h"
#include "support/test_films.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

namespace ghost::video {
namespace {

using SourceTest = WithFilms;
constexpr double kPatience_s = 60; // never used up but by a fault

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

SourceSettings of(const std::filesystem::path& path, SourceKind kind = SourceKind::file) {
    SourceSettings settings;
    settings.name = "test";
    settings.kind = kind;
    settings.path = path;
    settings.side = 128;
    return settings;
}

int number_at(Source& source, double show_s) {
    const auto picture = source.wait_for(show_s, kPatience_s);
    return picture ? number_of(picture->pyramid) : -2;
}

// A clock of its own: at every moment exactly the picture whose time has come, 60 rounds of a film of ten
// seconds long.
TEST_F(SourceTest, TenMinutesWithoutDrift) {
    Source source(of(film("film.mp4", 250)));
    int wrong = 0, looked = 0;
    for (int k = 0; k < 600 * 25; k += 7, ++looked) {
        const double at_s =
            (k + (looked % 2 ? 0.001 : 0.999)) / 25.0; // just after it is due, just before the next one
        if (number_at(source, at_s) != k % 250) ++wrong;
    }
    EXPECT_EQ(wrong, 0) << "of " << looked;
    EXPECT_TRUE(source.take_messages().empty());
}

// Pictures at uneven times: each from its time stamp to the next one's, in every round.
TEST_F(SourceTest, UnevenTimesAreKept) {
    const std::vector<int> at_ms{0, 100, 150, 1000, 1020, 2500};
    make_uneven(folder / "uneven.mkv", at_ms, 3000);
    Source source(of(folder / "uneven.mkv"));
    for (const int round : {0, 1, 7})
        for (int ms = 5; ms < 2950; ms += 35) {
            const auto due = std::upper_bound(at_ms.begin(), at_ms.end(), ms) - at_ms.begin() - 1;
            EXPECT_EQ(number_at(source, 3.0 * round + ms / 1000.0), due) << round << " " << ms;
        }
}

// Its stated length is that of its pictures, whose last one stands long: it is whole. Cut, it is said to be.
TEST_F(SourceTest, ALastPictureMayStandLong) {
    make_uneven(folder / "long.mp4", {0, 100, 150}, 3000);
    for (const bool loops : {false, true}) {
        SourceSettings settings = of(folder / "long.mp4");
        settings.loop = loops;
        Source source(settings);
        EXPECT_EQ(number_at(source, 2.5), 2);
        EXPECT_EQ(number_at(source, 3.05), loops ? 0 : 2);
        EXPECT_EQ(source.take_messages(), std::vector<std::string>{});
    }
    std::vector<int> at_ms;
    for (int ms = 0; ms < 3000; ms += 40) at_ms.push_back(ms);
    make_uneven(folder / "cut.mkv", at_ms, 3000);
    std::filesystem::resize_file(folder / "cut.mkv", std::filesystem::file_size(folder / "cut.mkv") / 2);
    Source source(of(folder / "cut.mkv"));
    EXPECT_GT(number_at(source, 2.9), 10);
    const std::vector<std::string> messages = source.take_messages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("cut short"), std::string::npos) << messages[0];
}

TEST_F(SourceTest, JumpsAnywhere) {
    Source source(of(film("film.mp4", 250)));
    std::mt19937 random(4);
    for (int n = 0; n < 60; ++n) {
        const int k = static_cast<int>(random() % 2000);
        EXPECT_EQ(number_at(source, (k + 0.5) / 25), k % 250) << n;
    }
}

// Where the moment goes back a little while a film is being searched, the pictures in between were passed
// over: they are searched again, and what was shown meanwhile does not stay.
TEST_F(SourceTest, StandsWhereItIsPutWhateverCameBefore) {
    Source source(of(film("film.mp4", 100)));
    for (int n = 0; n < 30; ++n) {
        const double at_s = n % 2 ? 0.6 : (n % 4 ? 3.4 : 2.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(130)); // long enough for a glimpse on the way
        source.at(at_s + 0.04);                                      // time code runs on before it stands
        std::this_thread::sleep_for(std::chrono::milliseconds(n % 7));
        const double until_s = now_s() + 10;
        const auto is_right = [&] {
            const auto picture = source.at(at_s);
            return picture && std::abs(picture->from_s - at_s) < 0.045;
        };
        while (!is_right() && now_s() < until_s) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ASSERT_TRUE(is_right()) << n << ", " << at_s << " s";
    }
}

TEST_F(SourceTest, BeginsWhenItShallAndEndsAtItsLastPicture) {
    SourceSettings settings = of(film("film.mp4", 50));
    settings.loop = false;
    settings.start_s = 100;
    Source source(settings);
    EXPECT_EQ(number_at(source, 0), 0);
    EXPECT_EQ(number_at(source, 99.9), 0);
    EXPECT_EQ(number_at(source, 101.02), 25);
    EXPECT_EQ(number_at(source, 500), 49);
    EXPECT_EQ(number_at(source, 100.5), 12);
    EXPECT_EQ(number_at(source, 103), 49);
}

// Live: asking takes no time, whatever the worker does, and never shows a picture from the future for long.
TEST_F(SourceTest, AskingNeverWaits) {
    Source source(of(film("film.mp4", 250)));
    ASSERT_TRUE(source.wait_for(0, kPatience_s));
    double longest_s = 0;
    int shown = 0;
    for (int n = 0; n < 300; ++n) {
        const double begin_s = now_s();
        shown += source.at(n * 3.7) ? 1 : 0; // each a jump
        longest_s = std::max(longest_s, now_s() - begin_s);
    }
    EXPECT_EQ(shown, 300);
    EXPECT_LT(longest_s,
              0.25); // a search takes longer than a lock; a busy machine may take the processor away
}

// In real time the picture is the newest one, or at most one before.
TEST_F(SourceTest, InRealTimeItIsAtMostAPictureLate) {
    Source source(of(film("film.mp4", 250)));
    ASSERT_TRUE(source.wait_for(0, kPatience_s));
    const double begin_s = now_s();
    int late = 0, looked = 0;
    for (double at_s = 0; at_s < 4; at_s = now_s() - begin_s, ++looked) {
        const auto picture = source.at(at_s);
        const double due = std::floor(at_s * 25) / 25;
        if (picture->from_s < due - 1.5 / 25) ++late;
        std::this_thread::sleep_for(std::chrono::milliseconds(15));
    }
    EXPECT_LE(late, looked / 20) << "of " << looked;
}

TEST_F(SourceTest, WhatCannotBeShownIsSaidAndSeen) {
    Source source(of(folder / "missing.mp4"));
    const auto picture = source.wait_for(3, kPatience_s);
    ASSERT_TRUE(picture);
    EXPECT_TRUE(picture->stand_in);
    const std::vector<std::string> messages = source.take_messages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("'test'"), std::string::npos);
    EXPECT_NE(messages[0].find("missing.mp4"), std::string::npos);
    film("missing.mp4", 50); // now it is there
    const double until_s = now_s() + 30;
    while (source.at(0.5)->stand_in && now_s() < until_s)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(number_at(source, 0.5), 12);
}

// A file in the place of a camera: it runs as fast as its time stamps say, ends as if it were pulled out, and
// comes back.
TEST_F(SourceTest, ACameraGoesAndComes) {
    Source source(of(folder / "camera.mp4", SourceKind::camera));
    const auto wait_until = [&](bool stand_in) {
        const double until_s = now_s() + 30;
        for (;;) {
            const auto picture = source.at(0);
            if (picture && picture->stand_in == stand_in) return true;
            if (now_s() > until_s) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    };
    EXPECT_TRUE(wait_until(true)); // there is none yet
    film("camera.mp4", 25);
    EXPECT_TRUE(wait_until(false)); // plugged in
    const double begin_s = now_s();
    EXPECT_GE(number_of(source.at(0)->pyramid), 0);
    EXPECT_TRUE(wait_until(true));     // pulled out
    EXPECT_GT(now_s() - begin_s, 0.7); // a second of pictures takes a second
    EXPECT_TRUE(wait_until(false));    // and in again
    EXPECT_GE(source.take_messages().size(), 3u);
}

TEST_F(SourceTest, StillsAndCards) {
    image::Image8 red(32, 18, 4);
    for (std::size_t k = 0; k < red.samples.size(); ++k) red.samples[k] = k % 4 == 0 || k % 4 == 3 ? 255 : 0;
    ASSERT_TRUE(image::write_png(folder / "red.png", red).ok());
    Source still(of(folder / "red.png"));
    const auto picture = still.wait_for(5, kPatience_s);
    ASSERT_TRUE(picture);
    EXPECT_FALSE(picture->stand_in);
    EXPECT_EQ(picture->pyramid.mean, glm::vec3(1, 0, 0));
    EXPECT_EQ(still.wait_for(99, kPatience_s)->number, picture->number);
    SourceSettings card = of({}, SourceKind::card);
    card.card = "white";
    Source white(card);
    EXPECT_EQ(white.wait_for(0, kPatience_s)->pyramid.mean, glm::vec3(1.0f));
}

// Neither a worker that is ahead of its film nor one that sleeps before it tries again, which is a second, is
// waited for.
TEST_F(SourceTest, EndsAtOnce) {
    const std::filesystem::path path = film("film.mp4", 100);
    double ending_s = 0;
    for (int n = 0; n < 20; ++n) {
        auto source = std::make_unique<Source>(of(n % 2 == 0 ? path : folder / "missing.mp4"));
        const auto picture = source->wait_for(n * 0.2, kPatience_s);
        ASSERT_TRUE(picture);
        EXPECT_EQ(picture->stand_in, n % 2 == 1);
        const double begun_s = now_s();
        source.reset();
        ending_s += now_s() - begun_s;
    }
    EXPECT_LT(ending_s, 4.0) << "all twenty";
}

} // namespace
} // namespace ghost::video
