// SPDX-License-Identifier: Apache-2.0
// Passes from disk: our own folder and passes.toml, whole and damaged.
#include "base/memory.h"
#include "image/exr.h"
#include "passes/passes.h"
#include "passes/passes_file.h"
#include "passes/passes_foreign.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <unistd.h>

namespace ghost::scene {
namespace {
namespace fs = std::filesystem;

class PassesFiles : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("ghost_passes_" + std::to_string(::getpid()));
        fs::create_directories(folder_ / "abc");
    }
    void TearDown() override { fs::remove_all(folder_); }

    // 3 x 2 pixels; pixel 1 shows two surfaces, pixel 4 three, pixel 5 none.
    void write_baked() {
        table_ = {3, 2, {0, 0, 1, 1, 1, 3, 3}, {}};
        for (int k = 0; k < 9; ++k) table_.fragments.emplace_back(k, 2 * k, 3 * k, k == 5 ? -1.0f : 0.5f);
        for (int k = 0; k < 9; ++k)
            values_.push_back(k == 5 ? glm::vec3(0)
                                     : glm::vec3(1, 2, 3) * (0.25f * static_cast<float>(k + 1)));
        manifest_.camera = "eye";
        manifest_.width = 3;
        manifest_.height = 2;
        manifest_.spp = 4;
        manifest_.folder = "abc";
        manifest_.layout_key = "layout";
        manifest_.extra_count = 3;
        manifest_.has_emission = true;
        manifest_.lights = {{"Spot 1", 0, {1, 2, 3}, "one", "light_1", true},
                            {"Spot 2", 1, {4, 5, 6}, "two", "light_2", false}};
        const auto write = [&](const std::string& name, float scale, const std::string& key) {
            EXPECT_TRUE(write_layer(folder_ / "abc", name, 3, 2, to_stored(table_, values_), scale,
                                    {{"ghost.key", key}})
                            .ok());
        };
        EXPECT_TRUE(write_fragments(folder_ / "abc", table_).ok());
        write("ambient", kPictureCandela, "layout");
        write("emission", 1, "layout");
        write("light_1", kPictureCandela, "one");
        write("light_2", kPictureCandela, "two");
        const std::vector<glm::vec3> bounced(6, glm::vec3(0.5f));
        EXPECT_TRUE(write_picture(folder_ / "abc/light_1_indirect.exr", 3, 2, bounced, kPictureCandela,
                                  {{"ghost.key", "one"}})
                        .ok());
        text("manifest.json", manifest_text(manifest_));
    }
    void text(const fs::path& name, const std::string& content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
    }
    void picture(const std::string& name, int width, int height, const std::vector<float>& rgba,
                 int channels = 4) {
        image::ExrFile file;
        file.pixels = image::ImageF(width, height, channels);
        file.pixels.samples = rgba;
        file.channels = {"R", "G", "B", "A"};
        file.channels.resize(static_cast<std::size_t>(channels));
        ASSERT_TRUE(image::write_exr(folder_ / name, file, image::ExrSample::full).ok());
    }
    static std::string all_messages(const Report& report) {
        std::string text;
        for (const Message& message : report.messages) text += message.where + ": " + message.what + "\n";
        return text;
    }

    fs::path folder_;
    FragmentTable table_;
    std::vector<glm::vec3> values_;
    PassManifest manifest_;
};

TEST_F(PassesFiles, RoundTrip) {
    write_baked();
    Report report;
    const auto passes = load_passes(folder_, true, report);
    ASSERT_TRUE(passes.ok()) << passes.error().text();
    EXPECT_TRUE(report.messages.empty()) << all_messages(report);
    EXPECT_EQ(passes->extra_first, table_.extra_first);
    EXPECT_EQ(passes->fragments, table_.fragments);
    ASSERT_EQ(passes->lights.size(), 2u);
    const LightPass& light = passes->lights[0];
    EXPECT_EQ(light.position_m, glm::vec3(1, 2, 3));
    ASSERT_EQ(light.radiance.size(), 36u);
    for (std::size_t k = 0; k < 9; ++k) {
        EXPECT_EQ(glm::unpackHalf1x16(light.radiance[4 * k + 1]), values_[k].y * kRadianceScale) << k;
        EXPECT_EQ(passes->emission[k].z, values_[k].z);
    }
    ASSERT_EQ(light.indirect.size(), 24u);
    EXPECT_EQ(glm::unpackHalf1x16(light.indirect[0]), 0.5f * kRadianceScale);
    EXPECT_TRUE(passes->lights[1].indirect.empty());
    EXPECT_EQ(passes->find("Spot 2", 1), 1);
    EXPECT_EQ(passes->find("Spot 2", 0), -1);
    const auto without = load_passes(folder_, false, report);
    ASSERT_TRUE(without.ok());
    EXPECT_TRUE(without->lights[0].radiance.empty());
}

TEST_F(PassesFiles, PictureOnDiskIsTheWholePicture) {
    write_baked();
    const auto file = image::read_exr(folder_ / "abc/light_1.exr");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->pixels.at(1, 0)[0], (values_[1].x + values_[6].x) * kPictureCandela);
    ASSERT_TRUE(file->chromaticities.has_value());
    EXPECT_EQ(*file->chromaticities, image::kRec2020);
}

TEST_F(PassesFiles, LostPicturesAreNamedAndTheRestKept) {
    write_baked();
    fs::remove(folder_ / "abc/light_2.exr");
    fs::remove(folder_ / "abc/emission.exr");
    picture("abc/light_1.exr", 2, 2, std::vector<float>(16, 1.0f));
    Report report;
    const auto passes = load_passes(folder_, true, report);
    ASSERT_TRUE(passes.ok());
    EXPECT_TRUE(report.lost_anything());
    const std::string messages = all_messages(report);
    EXPECT_NE(messages.find("2 x 2 pixels, expected 3 x 2"), std::string::npos) << messages;
    EXPECT_NE(messages.find("light_2.exr"), std::string::npos) << messages;
    EXPECT_NE(messages.find("'Spot 2' is dark"), std::string::npos) << messages;
    EXPECT_TRUE(passes->lights[0].radiance.empty() && passes->lights[1].radiance.empty());
    EXPECT_TRUE(passes->emission.empty());
    EXPECT_EQ(passes->ambient.size(), 9u);
}

TEST_F(PassesFiles, PictureOfAnotherBakeIsRefused) {
    write_baked();
    ASSERT_TRUE(
        write_layer(folder_ / "abc", "light_2", 3, 2, to_stored(table_, values_), 1, {{"ghost.key", "old"}})
            .ok());
    Report report;
    const auto passes = load_passes(folder_, true, report);
    ASSERT_TRUE(passes.ok());
    EXPECT_TRUE(passes->lights[1].radiance.empty());
    EXPECT_NE(all_messages(report).find("another bake"), std::string::npos);
}

TEST_F(PassesFiles, NotANumberIsBlackAndCounted) {
    write_baked();
    std::vector<float> samples(24, 2.0f);
    samples[4] = std::numeric_limits<float>::quiet_NaN();
    samples[9] = std::numeric_limits<float>::infinity();
    picture("nan.exr", 3, 2, samples);
    Report report;
    const auto values = read_picture(folder_ / "nan.exr", 3, 2, 1, "", report);
    ASSERT_TRUE(values.ok());
    EXPECT_EQ((*values)[1], glm::vec3(0));
    EXPECT_EQ((*values)[2], glm::vec3(0));
    EXPECT_EQ((*values)[3], glm::vec3(2));
    EXPECT_NE(all_messages(report).find("2 pixels"), std::string::npos);
}

TEST_F(PassesFiles, EveryCutManifestAndEveryCutFragmentFileIsAnError) {
    write_baked();
    const std::string whole = manifest_text(manifest_);
    for (std::size_t size = 0; size + 2 < whole.size(); ++size)
        EXPECT_FALSE(parse_manifest(whole.substr(0, size), "m").ok()) << size;
    ASSERT_TRUE(parse_manifest(whole, "m").ok());
    std::ifstream file(folder_ / "abc/fragments.exr", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    for (std::size_t size = 0; size < bytes.size(); size += 7) {
        text("abc/fragments.exr", bytes.substr(0, size));
        EXPECT_FALSE(read_fragments(folder_ / "abc", manifest_).ok()) << size;
    }
}

TEST_F(PassesFiles, APixelHasNoMoreThanThreeExtraFragments) {
    write_baked();
    for (const std::uint32_t extras : {3u, 4u}) {
        FragmentTable table = table_;
        table.fragments.resize(6 + extras, table.fragments.front());
        table.extra_first = {0, 0, extras, extras, extras, extras, extras};
        ASSERT_TRUE(write_fragments(folder_ / "abc", table).ok());
        PassManifest manifest = manifest_;
        manifest.extra_count = extras;
        const auto read = read_fragments(folder_ / "abc", manifest);
        ASSERT_EQ(read.ok(), extras == 3);
        if (read.ok()) continue;
        EXPECT_NE(read.error().what.find("pixel 1 has more than 3 extra fragments"), std::string::npos)
            << read.error().what;
    }
}

TEST_F(PassesFiles, AManifestNestedWithoutEndIsRefused) {
    const auto manifest = parse_manifest("{\"lights\": " + std::string(4'000'000, '['), "manifest.json");
    ASSERT_FALSE(manifest.ok());
    EXPECT_NE(manifest.error().text().find("manifest.json: is nested deeper than 32"), std::string::npos)
        << manifest.error().text();
}

TEST_F(PassesFiles, AManifestOfTooMuchIsRefused) {
    write_baked();
    const auto refused = [&](const Result<PassManifest>& manifest, const std::string& words) {
        EXPECT_FALSE(manifest.ok()) << words;
        if (!manifest.ok()) {
            EXPECT_NE(manifest.error().text().find(words), std::string::npos) << manifest.error().text();
        }
    };
    const ManifestLight light = manifest_.lights.front();
    manifest_.lights.assign(kMaxLightPasses + 1, light);
    refused(parse_manifest(manifest_text(manifest_), "m"), "a list of at most 2047 entries");
    text("manifest.json", "{");
    std::filesystem::resize_file(folder_ / "manifest.json", (16u << 20) + 1);
    refused(read_manifest(folder_), "more than the limit of 16777216");
}

// Each light is a copy of its picture, even where all of them name one small file. Nothing is read for it:
// what lacks here would be said otherwise.
TEST_F(PassesFiles, LightsThatMemoryDoesNotHoldAreNotRead) {
    constexpr int kWidth = 4096, kHeight = 2048;
    constexpr std::uint64_t kBytes = std::uint64_t{8} * kWidth * kHeight * kMaxLightPasses;
    EXPECT_TRUE(check_light_memory(std::uint64_t{kWidth} * kHeight, kMaxLightPasses, "p", kBytes).ok());
    EXPECT_TRUE(check_light_memory(std::uint64_t{kWidth} * kHeight, kMaxLightPasses, "p", 0).ok());
    const auto refused =
        check_light_memory(std::uint64_t{kWidth} * kHeight, kMaxLightPasses, "p", kBytes - 1);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(
        refused.error().text().find("p: the pictures of its 2047 lights need 131008 MB of memory, and 131007 "
                                    "are free"),
        std::string::npos)
        << refused.error().text();

    if (free_memory_bytes() == 0 || free_memory_bytes() > kBytes)
        GTEST_SKIP() << "this machine has the memory, or does not say";
    write_baked();
    manifest_.width = kWidth;
    manifest_.height = kHeight;
    manifest_.lights.assign(kMaxLightPasses, manifest_.lights.front());
    text("manifest.json", manifest_text(manifest_));
    Report report;
    const auto passes = load_passes(folder_, true, report);
    ASSERT_FALSE(passes.ok());
    EXPECT_NE(passes.error().text().find("lights need "), std::string::npos) << passes.error().text();
}

TEST_F(PassesFiles, ManifestNamesStayInTheirFolder) {
    for (const char* name : {"../x", "/etc/passwd", "", ".hidden", "a\\b"}) {
        manifest_.width = manifest_.height = 2;
        manifest_.spp = 1;
        manifest_.folder = name;
        EXPECT_FALSE(parse_manifest(manifest_text(manifest_), "m").ok()) << name;
        manifest_.folder = "good";
        EXPECT_TRUE(parse_manifest(manifest_text(manifest_), "m").ok());
        manifest_.lights = {{"a", 0, {}, "k", name, false}};
        EXPECT_FALSE(parse_manifest(manifest_text(manifest_), "m").ok()) << name;
        manifest_.lights.clear();
    }
    manifest_.width = 1 << 20;
    EXPECT_FALSE(parse_manifest(manifest_text(manifest_), "m").ok());
    EXPECT_EQ(file_name_of("Front of house 1"), "Front of house 1");
    EXPECT_EQ(file_name_of("Front/../of: house").substr(0, 19), "Front____of_ house-");
    EXPECT_NE(file_name_of("cam.1"), file_name_of("cam_1"));
    EXPECT_NE(file_name_of("cam.1"), file_name_of("cam:1"));
}

constexpr char kToml[] = R"(position = "P.exr"
axes = "y-up"
primaries = "rec2020"
[camera]
matrix_world = [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]
fov_y_deg = 30.0
[[light]]
name = "Spot 1"
file = "l0.exr"
position_m = [1, 2, 3]
intensity_cd = 4.0
[[light]]
name = "Spot 2"
stop = 1
file = "l1.exr"
position_m = [0, 0, 0]
intensity_cd = 1.0
)";

TEST_F(PassesFiles, ForeignPassesAreTurnedAndScaled) {
    text("passes.toml", kToml);
    picture("P.exr", 2, 1, {1, 2, 3, 1, 9, 9, 9, 0});
    picture("l0.exr", 2, 1, {8, 4, 2, 7, 7, 7}, 3);
    Report report;
    const auto passes = load_foreign_passes(folder_ / "passes.toml", report);
    ASSERT_TRUE(passes.ok()) << passes.error().text();
    EXPECT_EQ(passes->fragments[0], glm::vec4(1, -3, 2, 1));
    EXPECT_LT(passes->fragments[1].w, 0);
    EXPECT_EQ(passes->camera_to_world[3], glm::vec4(1, -3, 2, 1));
    EXPECT_EQ(passes->camera_to_world[1], glm::vec4(0, 0, 1, 0)); // y up is z up
    EXPECT_EQ(passes->fov_y_deg, 30.0f);
    ASSERT_EQ(passes->lights.size(), 2u);
    EXPECT_EQ(passes->lights[0].position_m, glm::vec3(1, -3, 2));
    ASSERT_EQ(passes->lights[0].radiance.size(), 8u);
    EXPECT_EQ(glm::unpackHalf1x16(passes->lights[0].radiance[0]), 2 * kRadianceScale);
    EXPECT_EQ(passes->lights[0].radiance[4], 0); // nothing there
    EXPECT_TRUE(passes->lights[1].radiance.empty());
    EXPECT_NE(all_messages(report).find("passes.toml:12"), std::string::npos) << all_messages(report);
    EXPECT_NE(all_messages(report).find("'Spot 2' is dark"), std::string::npos);
}

TEST_F(PassesFiles, ForeignLightsThatMemoryDoesNotHoldAreNotRead) {
    constexpr int kWidth = 4096, kHeight = 2048;
    constexpr std::uint64_t kBytes = std::uint64_t{8} * kWidth * kHeight * kMaxLightPasses;
    if (free_memory_bytes() == 0 || free_memory_bytes() > kBytes)
        GTEST_SKIP() << "this machine has the memory, or does not say";
    std::string toml = std::string(kToml).substr(0, std::string(kToml).find("[[light]]"));
    for (std::size_t k = 0; k < kMaxLightPasses; ++k)
        toml += "[[light]]\nname = \"a\"\nfile = \"l.exr\"\nposition_m = [0, 0, 0]\n";
    text("passes.toml", toml);
    picture("P.exr", kWidth, kHeight, std::vector<float>(std::size_t{3} * kWidth * kHeight, 1.0f), 3);
    Report report;
    const auto foreign = load_foreign_passes(folder_ / "passes.toml", report);
    ASSERT_FALSE(foreign.ok());
    EXPECT_NE(foreign.error().text().find("passes.toml: the pictures of its 2047 lights need 131008 MB"),
              std::string::npos)
        << foreign.error().text();
}

TEST(ForeignPasses, FaultsHaveLines) {
    const auto messages = [](const std::string& text) {
        Report report;
        const auto parsed = parse_foreign_passes(text, "p.toml", report);
        std::string all = parsed.ok() ? "" : "error " + parsed.error().text() + "\n";
        for (const Message& message : report.messages) all += message.where + ": " + message.what + "\n";
        return all;
    };
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = kToml;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_EQ(messages(kToml), "");
    EXPECT_NE(messages(with("fov_y_deg", "fov_ydeg")).find("did you mean"), std::string::npos);
    EXPECT_NE(messages(with("y-up", "x-up")).find("p.toml:2"), std::string::npos);
    EXPECT_NE(messages(with("rec2020", "aces")).find("p.toml:3"), std::string::npos);
    EXPECT_NE(messages(with("intensity_cd = 4.0", "intensity_cd = 0")).find("p.toml:11"), std::string::npos);
    EXPECT_NE(messages(with("[1, 2, 3]", "[1, 2]")).find("p.toml:10"), std::string::npos);
    EXPECT_NE(messages(with("[0, 0, 1, 3]", "[0, 0, 5, 3]")).find("error p.toml:5"), std::string::npos);
    EXPECT_NE(messages(with("position = \"P.exr\"", "")).find("error"), std::string::npos);
    EXPECT_NE(messages(with("[camera]", "[camera")).find("error p.toml:4"), std::string::npos);
    for (std::size_t size = 0; size < std::string(kToml).size(); ++size)
        messages(std::string(kToml).substr(0, size));
}

} // namespace
} // namespace ghost::scene
