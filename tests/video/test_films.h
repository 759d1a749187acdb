#pragma once
// SPDX-License-Identifier: Apache-2.0
// Films whose every picture says its number, as ten black or white bars.

#include "image/pyramid.h"
#include "video/film.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <vector>

namespace ghost::video {

inline constexpr int kBits = 10;
inline constexpr int kBarWidth = 16;
inline constexpr int kTestHeight = 64;

inline std::vector<std::uint8_t> numbered(int number) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kTestHeight; ++y)
        for (int x = 0; x < kBits * kBarWidth; ++x) {
            const auto value = static_cast<std::uint8_t>((number >> (x / kBarWidth)) % 2 ? 255 : 0);
            rgba.insert(rgba.end(), {value, value, value, 255});
        }
    return rgba;
}

// -1: no such bars.
inline int number_of(const image::Pyramid& pyramid) {
    const int side = pyramid.side;
    int number = 0;
    for (int bit = 0; bit < kBits; ++bit) {
        const int x = (2 * bit + 1) * side / (2 * kBits);
        const std::uint8_t value =
            (*pyramid.levels)[0][4 * (static_cast<std::size_t>(side / 2) * static_cast<std::size_t>(side) +
                                      static_cast<std::size_t>(x))];
        if (value > 60 && value < 190) return -1;
        number |= value >= 190 ? 1 << bit : 0;
    }
    return number;
}

class WithFilms : public ::testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("ghost_films_" + std::to_string(::getpid()) + "_" +
                  ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder);
    }
    void TearDown() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }
    std::filesystem::path film(const std::string& name, int frames, int fps = 25, int first = 0) const {
        const std::filesystem::path path = folder / name;
        auto writer = FilmWriter::create(path, kBits * kBarWidth, kTestHeight, fps);
        EXPECT_TRUE(writer.ok());
        for (int k = 0; k < frames; ++k) EXPECT_TRUE((*writer)->add(numbered(first + k).data()).ok());
        EXPECT_TRUE((*writer)->finish().ok());
        return path;
    }
    std::filesystem::path folder;
};

} // namespace ghost::video
