// SPDX-License-Identifier: Apache-2.0
// The octahedral map, and the files of distance maps with all that can be wrong with them.
#include "image/exr.h"
#include "passes/distance_maps_file.h"
#include "passes/passes_file.h"
#include "shared/octahedral.h"
#include "show/show.h"

#include <filesystem>
#include <fstream>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <unistd.h>

namespace ghost::scene {
namespace {

using shared::direction_from_octahedral;
using shared::octahedral_from;

TEST(Octahedral, KnownDirections) {
    const auto at = [](const glm::vec2& place, const glm::vec3& direction) {
        EXPECT_LT(glm::length(direction_from_octahedral(place) - direction), 1e-6f);
    };
    at({0.5f, 0.5f}, {0, 0, -1}); // down in the middle
    for (const float x : {0.0f, 1.0f})
        for (const float y : {0.0f, 1.0f}) at({x, y}, {0, 0, 1}); // up in all corners
    at({1.0f, 0.5f}, {1, 0, 0});
    at({0.0f, 0.5f}, {-1, 0, 0});
    at({0.5f, 1.0f}, {0, 1, 0});
    EXPECT_EQ(octahedral_from(glm::vec3(0.0f)), glm::vec2(0.5f));
    EXPECT_EQ(octahedral_from({0, 0, -3}), glm::vec2(0.5f));
}

TEST(Octahedral, RoundTripsOfPlacesAndDirections) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::normal_distribution<float> normal;
    float worst = 0;
    for (int k = 0; k < 100000; ++k) {
        const glm::vec3 direction = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        const glm::vec2 place = octahedral_from(direction);
        ASSERT_TRUE(place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1);
        worst = std::max(worst, glm::length(direction_from_octahedral(place) - direction));
        const glm::vec2 there(unit(random), unit(random));
        worst = std::max(worst, glm::length(octahedral_from(direction_from_octahedral(there)) - there));
        EXPECT_NEAR(glm::length(direction_from_octahedral(there)), 1.0f, 1e-6f);
    }
    EXPECT_LT(worst, 2e-6f);
}

TEST(Octahedral, NeighboursStayNeighboursAcrossTheSeams) {
    // The two halves of an edge are the same directions, mirrored about its middle.
    for (int k = 0; k <= 64; ++k) {
        const float t = static_cast<float>(k) / 64;
        for (const float edge : {0.0f, 1.0f}) {
            EXPECT_LT(
                glm::length(direction_from_octahedral({edge, t}) - direction_from_octahedral({edge, 1 - t})),
                1e-6f);
            EXPECT_LT(
                glm::length(direction_from_octahedral({t, edge}) - direction_from_octahedral({1 - t, edge})),
                1e-6f);
        }
    }
    // Inside the square a small step is a small turn, over the fold at the horizon too.
    constexpr float kStep = 1.0f / 512;
    float largest = 0;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 511; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5f) * kStep;
            largest = std::max(largest, glm::length(direction_from_octahedral(at) -
                                                    direction_from_octahedral(at + glm::vec2(kStep, 0))));
        }
    EXPECT_LT(largest, 5 * kStep);
}

class Folder {
public:
    Folder()
        : path(std::filesystem::temp_directory_path() / ("ghost_distances_" + std::to_string(::getpid()))) {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() {
        std::error_code code;
        std::filesystem::remove_all(path, code);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::filesystem::path path;
};

constexpr int kSize = 64;
const std::string kStageKey = "0123456789abcdef0123456789abcdef";
const std::string kOtherKey = "ffffffffffffffffffffffffffffffff";

class DistanceFiles : public ::testing::Test {
protected:
    DistanceFiles() {
        auto type = std::make_shared<fixture::Type>();
        type->modes.emplace_back();
        show.folder = folder.path;
        for (const char* name : {"A/1", "A_1", "dark"}) {
            PatchedFixture fixture;
            fixture.name = name;
            if (fixture.name != "dark") fixture.type = type;
            fixture.position_m = {0.1f, 0.2f, 3};
            show.fixtures.push_back(fixture);
        }
        show.fixtures[0].track = Track{{{0, 0, 1}, {0, 0, 2}}, 1, 1};
        places = distance_places(show, kSize);
        std::filesystem::create_directories(distance_folder(show, kSize));
        stage.key = kStageKey;
        stage.instances = {{"00000000000000aa", {0, 0, 0.1f}, {1, 2, 3}}};
    }
    StoredDistanceMap stored(std::size_t k) const {
        StoredDistanceMap map;
        map.distance.assign(kSize * kSize, kNoSurface);
        map.distance[5] = to_half(2.0f);
        map.distance[6] = to_half(7.5f);
        map.place = place_key(places[k], kSize);
        map.stage = map.key = kStageKey;
        map.sees = {"00000000000000aa", "00000000000000bb"};
        return map;
    }
    void write(std::size_t k, const StoredDistanceMap& map, int size = kSize) {
        const auto written = write_distance_map(places[k].file, size, map);
        ASSERT_TRUE(written.ok()) << written.error().text();
    }
    std::size_t loaded() {
        report = {};
        const auto maps = load_distance_maps(show, kSize, report);
        EXPECT_TRUE(maps.ok());
        return maps.ok() ? maps->maps.size() : 99;
    }

    Folder folder;
    Show show;
    DistanceStage stage;
    std::vector<DistancePlace> places;
    Report report;
};

TEST_F(DistanceFiles, NamesAreUniqueAndDarkFixturesHaveNone) {
    ASSERT_EQ(places.size(), 3u);
    EXPECT_EQ(places[0].file.filename(), file_name_of("A/1") + "_0.exr");
    EXPECT_EQ(places[1].file.filename(), file_name_of("A/1") + "_1.exr");
    EXPECT_EQ(places[2].file.filename(), "A_1_0.exr");
    EXPECT_EQ(places[1].position_m, glm::vec3(0, 0, 2));
}

TEST_F(DistanceFiles, NoSurfaceIsTheHalfOfItsDistance) {
    EXPECT_EQ(glm::unpackHalf1x16(kNoSurface), kNoSurface_m);
    EXPECT_EQ(to_half(kNoSurface_m), kNoSurface);
}

TEST(Halves, AreThoseOfGlmForAllExponents) {
    for (std::uint32_t bits = 0; bits <= 0x7bff; ++bits) {
        const float at = glm::unpackHalf1x16(static_cast<std::uint16_t>(bits));
        const float next = glm::unpackHalf1x16(static_cast<std::uint16_t>(std::min(bits + 1, 0x7bffu)));
        for (const float value :
             {at, std::nextafter(at, 0.0f), std::midpoint(at, next), 0.7f * at + 0.3f * next,
              std::nextafter(std::midpoint(at, next), 0.0f), -at, -std::midpoint(at, next)})
            ASSERT_EQ(to_half(value), glm::packHalf1x16(value)) << value;
    }
    EXPECT_EQ(to_half(1e9f), to_half(65504.0f));
    EXPECT_EQ(to_half(-1e9f), to_half(-65504.0f));
    EXPECT_EQ(to_half(std::nanf("")), 0);
}

TEST_F(DistanceFiles, WhatIsWrittenIsRead) {
    ASSERT_TRUE(write_distance_stage(show, kSize, stage).ok());
    for (std::size_t k = 0; k < 3; ++k) write(k, stored(k));
    const auto maps = load_distance_maps(show, kSize, report);
    ASSERT_TRUE(maps.ok());
    EXPECT_TRUE(report.messages.empty());
    ASSERT_EQ(maps->maps.size(), 3u);
    EXPECT_EQ(maps->find("A/1", 1), 1);
    EXPECT_EQ(maps->find("A_1", 0), 2);
    EXPECT_EQ(maps->find("A_1", 1), -1);
    EXPECT_EQ(maps->maps[1].distance, stored(1).distance);
    EXPECT_EQ(maps->maps[1].nearest_m, 2.0f);
    EXPECT_EQ(maps->maps[1].farthest_m, 7.5f);
    const auto map = read_distance_map(places[1].file, kSize);
    ASSERT_TRUE(map.ok() && map->has_value());
    EXPECT_EQ((*map)->sees, stored(1).sees);
    const auto read = read_distance_stage(distance_folder(show, kSize));
    ASSERT_TRUE(read.ok() && read->has_value());
    EXPECT_TRUE(**read == stage);
}

// What a show brings there may be anything, of any size: a hole of a terabyte is a few bytes in an archive.
TEST_F(DistanceFiles, OnlyMapsOfTheShowAreCopied) {
    namespace fs = std::filesystem;
    ASSERT_TRUE(write_distance_stage(show, kSize, stage).ok());
    for (std::size_t k = 0; k < 3; ++k) write(k, stored(k));
    fs::resize_file(places[1].file, std::uintmax_t{64} << 20);
    std::ofstream(distance_folder(show, kSize) / "x") << "no map";
    std::ofstream(distance_folder(show, kSize) / "nobody_0.exr") << "no map";
    Show moved = show;
    moved.cache_name = "tracked";
    copy_distance_maps(show, moved, kSize, [] { return true; });
    const fs::path there = distance_folder(moved, kSize);
    EXPECT_TRUE(!fs::exists(there) || fs::is_empty(there)) << "stopped";
    copy_distance_maps(show, moved, kSize, [] { return false; });
    std::set<std::string> copied;
    for (const auto& entry : fs::directory_iterator(there)) copied.insert(entry.path().filename().string());
    EXPECT_EQ(copied, (std::set<std::string>{"stage.json", places[0].file.filename().string(),
                                             places[2].file.filename().string()}));
    const auto map = read_distance_map(there / places[0].file.filename(), kSize);
    ASSERT_TRUE(map.ok() && map->has_value());
    EXPECT_EQ((*map)->distance, stored(0).distance);
}

TEST_F(DistanceFiles, OnlyWhatFitsPlaceAndStageIsLoaded) {
    write(0, stored(0));
    EXPECT_EQ(loaded(), 0u); // no stage says that it is right
    ASSERT_TRUE(write_distance_stage(show, kSize, stage).ok());
    EXPECT_EQ(loaded(), 1u);
    StoredDistanceMap other = stored(1);
    other.stage = other.key = kOtherKey;
    write(1, other);
    EXPECT_EQ(loaded(), 1u);
    stage.also_right = {kOtherKey};
    ASSERT_TRUE(write_distance_stage(show, kSize, stage).ok());
    EXPECT_EQ(loaded(), 2u);
    show.fixtures[0].track->stops_m[1].x = 1e-7f;
    EXPECT_EQ(loaded(), 1u);
    EXPECT_TRUE(report.messages.empty());
    EXPECT_FALSE(load_distance_maps(show, 63, report).ok());
    EXPECT_FALSE(load_distance_maps(show, 4097, report).ok());
}

TEST_F(DistanceFiles, DamagedFilesAreNamedAndLeftOut) {
    ASSERT_TRUE(write_distance_stage(show, kSize, stage).ok());
    write(0, stored(0));
    write(1, stored(1));
    const auto named = [&](const char* what) {
        EXPECT_EQ(loaded(), 1u) << what;
        ASSERT_EQ(report.messages.size(), 1u) << what;
        EXPECT_EQ(report.messages[0].where, places[1].file.string());
        EXPECT_NE(report.messages[0].what.find(what), std::string::npos) << report.messages[0].what;
    };
    const auto whole = std::filesystem::file_size(places[1].file);
    for (std::uintmax_t bytes = whole - 1;; bytes = bytes * 2 / 3) {
        std::filesystem::resize_file(places[1].file, bytes);
        named("not a readable OpenEXR image");
        if (bytes == 0) break;
    }
    StoredDistanceMap map = stored(1);
    map.distance.assign(65 * 65, 0);
    write(1, map, 65);
    named("65 x 65 pixels");
    for (const float value : {-1.0f, 60032.0f, std::numeric_limits<float>::quiet_NaN()}) {
        map = stored(1);
        map.distance[9] = glm::packHalf1x16(value);
        write(1, map);
        named("distance that is not between");
    }
    map = stored(1);
    map.stage = "here";
    write(1, map);
    named("which stage");
    map = stored(1);
    map.sees[1] = "0123";
    write(1, map);
    named("list of what it shows");
    std::filesystem::remove(places[1].file);
    std::filesystem::create_directory(places[1].file);
    named("not a plain file");
}

TEST_F(DistanceFiles, DamagedStageFileIsNamed) {
    write(0, stored(0));
    const std::string text = distance_stage_text(stage);
    ASSERT_TRUE(parse_distance_stage(text, "x").ok());
    for (std::size_t length = 0; length + 2 < text.size(); ++length)
        EXPECT_FALSE(parse_distance_stage(text.substr(0, length), "x").ok()) << length;
    for (const auto& [from, to] : {std::pair{"\"version\": 2", "\"version\": 1"},
                                   {"0123456789abcdef0123", "0123456789abcdeX0123"},
                                   {"00000000000000aa", "00000000000000a"},
                                   {"[\"00000000000000aa\",0.0", "[\"00000000000000aa\",\"0\""},
                                   {"\"also_right\": []", "\"also_right\": [7]"},
                                   {"\"also_right\": []", "\"also_right\": {}"}}) {
        std::string changed = text;
        const auto at = changed.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        changed.replace(at, std::string(from).size(), to);
        EXPECT_FALSE(parse_distance_stage(changed, "x").ok()) << changed;
    }
    std::string earlier = text;
    earlier.replace(earlier.find("\"version\": 2"), 12, "\"version\": 1");
    EXPECT_EQ(parse_distance_stage(earlier, "x").error().text(),
              "x: is of another version of Ghostlight; all maps are made again, once");
    std::ofstream(distance_folder(show, kSize) / "stage.json") << "{";
    EXPECT_EQ(loaded(), 0u);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_NE(report.messages[0].where.find("stage.json"), std::string::npos);
}

} // namespace
} // namespace ghost::scene
