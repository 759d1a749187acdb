// SPDX-License-Identifier: Apache-2.0
// A film that decodes slower than it is asked for holds no picture up: neither on an LED wall nor from a
// projector. The picture before it stays, and the right one comes.
#include "live/session/session.h"
#include "video/files/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

namespace ghost::app {
namespace {

constexpr int kFilmWidth = 1920, kFilmHeight = 1080;
constexpr int kPictures = 3;
constexpr int kAsked = 3;
constexpr double kApart_s = 0.97; // no two of the moments have the same picture of the same round

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + kAsked / 2, values.end());
    return values[kAsked / 2];
}

// Noise: nothing is slower.
class LateMedia : public ::testing::TestWithParam<const char*> {
protected:
    static void SetUpTestSuite() {
        folder() = std::filesystem::temp_directory_path() / ("ghost_late_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder());
        auto film = video::FilmWriter::create(folder() / "noise.mp4", kFilmWidth, kFilmHeight, 25);
        ASSERT_TRUE(film.ok());
        std::minstd_rand random(1);
        std::vector<std::uint8_t> rgba(std::size_t{kFilmWidth} * kFilmHeight * 4);
        for (int k = 0; k < kPictures; ++k) {
            for (std::uint8_t& value : rgba) value = static_cast<std::uint8_t>(random() >> 16);
            ASSERT_TRUE((*film)->add(rgba.data()).ok());
        }
        ASSERT_TRUE((*film)->finish().ok());
    }
    static void TearDownTestSuite() {
        std::error_code ignored;
        std::filesystem::remove_all(folder(), ignored);
    }
    static std::filesystem::path& folder() {
        static std::filesystem::path path;
        return path;
    }
    std::unique_ptr<Session> open() const {
        SessionOptions options;
        options.show = (folder() / "show.toml").string();
        options.text = std::make_shared<const std::string>(
            "[show]\nname = \"Late\"\nstage = \"" +
            std::filesystem::absolute("assets/optics/stage.glb").string() +
            "\"\n[[media]]\nname = \"noise\"\nfile = \"noise.mp4\"\n"
            "[[camera]]\nposition_m = [0, -6, 3]\ntarget_m = [0, 8, 3]\nsize = [96, 54]\n"
            "[[fixture]]\nname = \"Shows it\"\nposition_m = [0, 5, 3]\n" +
            GetParam() + "\n");
        options.live = true;
        options.shadows = false;
        options.quiet = true;
        auto session = open_session(options);
        EXPECT_TRUE(session.ok()) << session.error().text();
        return session.ok() ? std::move(*session) : nullptr;
    }
    // Seconds that each of the moments takes.
    static std::vector<double> asked(Session& session, bool waits, double from_s) {
        std::vector<double> took_s;
        session.media_waits = waits;
        for (int n = 0; n < kAsked; ++n) {
            const double begin_s = now_s();
            session.show_media(from_s + n * kApart_s);
            took_s.push_back(now_s() - begin_s);
        }
        return took_s;
    }
};

TEST_P(LateMedia, HoldsNoPictureUp) {
    const auto session = open();
    ASSERT_TRUE(session);
    const double decoding_s = median(asked(*session, true, 1));
    ASSERT_GT(decoding_s, 0.01) << "this film is not slow: it tests nothing";
    EXPECT_LT(median(asked(*session, false, 20)), 0.25 * decoding_s);
    // Drawing goes on meanwhile, and what is late comes.
    session->rig->step({}, 1);
    session->media_waits = false;
    session->draw(40);
    session->media_waits = true;
    session->draw(41);
    const std::vector<std::uint8_t> pixels = session->relighter->picture().samples;
    EXPECT_GT(std::count_if(pixels.begin(), pixels.end(), [](std::uint8_t v) { return v > 40 && v < 255; }),
              100);
}

INSTANTIATE_TEST_SUITE_P(
    Of, LateMedia,
    ::testing::Values("wall = { media = \"noise\", size_m = [4, 2.25], nits = 500 }",
                      "projector = { media = \"noise\", throw_ratio = 1, lumens = 20000 }"));

} // namespace
} // namespace ghost::app
