// SPDX-License-Identifier: Apache-2.0
// Films of whole blocks, joined: the bytes of one that was written at once.
#include "video/files/film.h"
#include "video/files/movie.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <string>
#include <unistd.h>

namespace ghost::video {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 64, kHeight = 48, kFps = 30;

class FilmJoin : public ::testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("ghost_join_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    fs::path folder;
};

// Something moves, so that pictures are sent in another order than they are shown in.
std::vector<std::uint8_t> picture(long frame, int width, int height) {
    std::mt19937 random(static_cast<unsigned>(frame / 7));
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool is_bar = (x + frame) % 23 < 6;
            for (int c = 0; c < 4; ++c)
                rgba[static_cast<std::size_t>((y * width + x) * 4 + c)] =
                    static_cast<std::uint8_t>(is_bar ? 220 : 20 + 3 * y + random() % 40);
        }
    return rgba;
}

FilmPart film_of(const fs::path& path, long first, long last, int width = kWidth, int height = kHeight) {
    auto film = FilmWriter::create(path, width, height, kFps, {}, first);
    EXPECT_TRUE(film.ok());
    for (long frame = first; film.ok() && frame <= last; ++frame)
        EXPECT_TRUE((*film)->add(picture(frame, width, height).data()).ok());
    EXPECT_TRUE(film.ok() && (*film)->finish().ok());
    return {path, last - first + 1};
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(FilmJoin, PartsMakeTheBytesOfTheWhole) {
    for (const auto& [first, last] :
         {std::pair{0L, 239L}, {0L, 240L}, {100L, 599L}, {239L, 482L}, {480L, 960L}}) {
        film_of(folder / "whole.mp4", first, last);
        std::vector<FilmPart> parts;
        for (long from = first; from <= last;) {
            const long to = std::min((from / kFilmBlockFrames + 1) * kFilmBlockFrames - 1, last);
            parts.push_back(film_of(folder / ("part" + std::to_string(from) + ".mp4"), from, to));
            from = to + 1;
        }
        const auto joined = join_films(folder / "joined.mp4", parts, kFps);
        ASSERT_TRUE(joined.ok()) << joined.error().text();
        EXPECT_EQ(*joined, "");
        EXPECT_TRUE(bytes_of(folder / "joined.mp4") == bytes_of(folder / "whole.mp4"))
            << first << " to " << last << ": " << fs::file_size(folder / "joined.mp4") << " bytes, expected "
            << fs::file_size(folder / "whole.mp4");
    }
}

TEST_F(FilmJoin, EveryPictureIsShownAtItsTime) {
    film_of(folder / "whole.mp4", 239, 482); // a block of one picture, a whole one, and a begun one
    const auto movie = Movie::open(folder / "whole.mp4");
    ASSERT_TRUE(movie.ok()) << movie.error().text();
    for (long frame = 239; frame <= 482; ++frame) {
        const auto at_s = (*movie)->next();
        ASSERT_TRUE(at_s.ok() && *at_s);
        EXPECT_NEAR(**at_s, static_cast<double>(frame - 239) / kFps, 1e-3);
        const auto shown = (*movie)->picture(Movie::Which::newest, kWidth, kHeight);
        ASSERT_TRUE(shown.ok());
        const auto drawn = picture(frame, kWidth, kHeight);
        double difference = 0;
        for (std::size_t k = 0; k < drawn.size(); k += 4) // green
            difference += std::abs(int(shown->samples[k + 1]) - int(drawn[k + 1]));
        EXPECT_LT(difference / (kWidth * kHeight), 12) << frame;
    }
    const auto end = (*movie)->next();
    EXPECT_TRUE(end.ok() && !*end);
    EXPECT_EQ((*movie)->damaged(), 0);
}

TEST_F(FilmJoin, WhatIsNoPartIsNamed) {
    const std::vector<FilmPart> good{film_of(folder / "a.mp4", 200, 239),
                                     film_of(folder / "b.mp4", 240, 250)};
    film_of(folder / "larger.mp4", 240, 250, 2 * kWidth, kHeight);
    std::ofstream(folder / "text.mp4") << "no film";
    fs::copy_file(folder / "b.mp4", folder / "cut.mp4");
    fs::resize_file(folder / "cut.mp4", fs::file_size(folder / "cut.mp4") / 2);
    const fs::path out = folder / "out.mp4";
    std::ofstream(out) << "the film of yesterday";
    const auto refused = [&](const std::vector<FilmPart>& parts, const std::string& name,
                             const std::string& why) {
        const auto joined = join_films(out, parts, kFps);
        ASSERT_FALSE(joined.ok()) << name;
        EXPECT_NE(joined.error().text().find(name), std::string::npos) << joined.error().text();
        EXPECT_NE(joined.error().text().find(why), std::string::npos) << joined.error().text();
        EXPECT_EQ(bytes_of(out), "the film of yesterday");
    };
    refused({}, "out.mp4", "no part");
    refused({good[0], {folder / "nowhere.mp4", 11}}, "nowhere.mp4", "cannot be opened");
    refused({{folder / "text.mp4", 11}, good[1]}, "text.mp4", "cannot be opened");
    refused({good[0], {folder / "larger.mp4", 11}}, "larger.mp4", "another size");
    refused({good[0], {folder / "b.mp4", 12}}, "b.mp4", "has 11 pictures, expected 12");
    refused({good[0], {folder / "b.mp4", 10}}, "b.mp4", "has 11 pictures, expected 10");
    refused({good[0], {folder / "cut.mp4", 11}}, "cut.mp4", "");
}

} // namespace
} // namespace ghost::video
