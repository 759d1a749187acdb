// SPDX-License-Identifier: Apache-2.0
#include "image/exr.h"

#include "disk/files.h"

#include <algorithm>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#if !defined(_WIN32)
#include <csignal>
#include <sys/resource.h>
#endif

namespace ghost::image {
namespace {

namespace fs = std::filesystem;

fs::path exr_scratch(const std::string& name) {
    const fs::path folder = fs::path(testing::TempDir()) / "ghost_exr_test";
    fs::create_directories(folder);
    return folder / name;
}

ExrFile sample_file(std::vector<std::string> channels) {
    ExrFile file;
    file.pixels = ImageF(37, 19, static_cast<int>(channels.size()));
    std::uint32_t state = 1;
    for (float& value : file.pixels.samples) {
        state = state * 1664525u + 1013904223u;
        value = std::bit_cast<float>((state & 0x007fffffu) | 0x3f000000u) * 3.0f;
    }
    file.channels = std::move(channels);
    return file;
}

TEST(Exr, FloatRoundTripIsBitExact) {
    ExrFile file = sample_file({"R", "G", "B", "A", "V", "X"});
    file.pixels.samples[0] = -0.0f;
    file.pixels.samples[1] = 1e-42f;
    file.pixels.samples[2] = std::numeric_limits<float>::infinity();
    file.pixels.samples[3] = std::numeric_limits<float>::quiet_NaN();
    file.chromaticities = kRec2020;
    file.text["ghost:key"] = "abc";
    const fs::path path = exr_scratch("float.exr");
    ASSERT_TRUE(write_exr(path, file, ExrSample::full).ok());
    const auto back = read_exr(path);
    ASSERT_TRUE(back.ok()) << back.error().text();
    EXPECT_EQ(back->channels, file.channels);
    ASSERT_EQ(back->pixels.samples.size(), file.pixels.samples.size());
    for (std::size_t k = 0; k < file.pixels.samples.size(); ++k)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(back->pixels.samples[k]),
                  std::bit_cast<std::uint32_t>(file.pixels.samples[k]))
            << k;
    EXPECT_EQ(back->chromaticities, kRec2020);
    EXPECT_EQ(back->text.at("ghost:key"), "abc");
    EXPECT_EQ(back->find_channel("V"), 4);
    EXPECT_EQ(back->find_channel("Z"), -1);
}

TEST(Exr, HalfKeepsHalfValuesAndStaysFinite) {
    ExrFile file = sample_file({"R"});
    file.pixels = ImageF(5, 1, 1);
    file.pixels.samples = {1.0f, 0.333251953125f, -65504.0f, 1e9f, 5.9604644775390625e-08f};
    const fs::path path = exr_scratch("half.exr");
    ASSERT_TRUE(write_exr(path, file, ExrSample::half).ok());
    const auto back = read_exr(path);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->pixels.samples,
              (std::vector<float>{1.0f, 0.333251953125f, -65504.0f, 65504.0f, 5.9604644775390625e-08f}));
    EXPECT_FALSE(back->chromaticities.has_value());
}

TEST(Exr, ColourChannelsComeFirst) {
    const fs::path path = exr_scratch("order.exr");
    ASSERT_TRUE(write_exr(path, sample_file({"A", "B", "G", "Index", "R", "Z"}), ExrSample::full).ok());
    const auto back = read_exr(path);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->channels, (std::vector<std::string>{"R", "G", "B", "A", "Index", "Z"}));
}

TEST(Exr, BlenderLayerNamesAreTakenOff) {
    const fs::path path = exr_scratch("blender.exr");
    ASSERT_TRUE(
        write_exr(path,
                  sample_file({"ViewLayer.Combined.B", "ViewLayer.Combined.G", "ViewLayer.Combined.R",
                               "ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Position.Z"}),
                  ExrSample::full)
            .ok());
    const auto back = read_exr(path);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->channels, (std::vector<std::string>{"R", "G", "B", "X", "Y", "Z"}));
}

TEST(Exr, CombinedLayerWinsTheShortName) {
    const fs::path path = exr_scratch("layers.exr");
    ASSERT_TRUE(
        write_exr(path, sample_file({"RenderLayer.Combined.R", "RenderLayer.DiffDir.R"}), ExrSample::full)
            .ok());
    const auto back = read_exr(path);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->channels, (std::vector<std::string>{"R", "RenderLayer.DiffDir.R"}));
    ASSERT_TRUE(write_exr(path, sample_file({"Combined.R", "L.Combined.R", "R"}), ExrSample::full).ok());
    const auto plain = read_exr(path);
    ASSERT_TRUE(plain.ok());
    EXPECT_EQ(plain->channels, (std::vector<std::string>{"R", "Combined.R", "L.Combined.R"}));
}

TEST(Exr, EveryTruncationIsAnError) {
    const fs::path path = exr_scratch("whole.exr");
    ASSERT_TRUE(write_exr(path, sample_file({"R", "G", "B"}), ExrSample::half).ok());
    const auto bytes = read_file(path, 1 << 20);
    ASSERT_TRUE(bytes.ok());
    const fs::path cut = exr_scratch("cut.exr");
    for (std::size_t length = 0; length < bytes->size(); length += 7) {
        ASSERT_TRUE(write_file_atomic(cut, Bytes(*bytes).first(length)).ok());
        const auto back = read_exr(cut);
        ASSERT_FALSE(back.ok()) << "accepted " << length << " of " << bytes->size() << " bytes";
        EXPECT_EQ(back.error().where, cut.string());
    }
}

// The size stands in the first bytes; a picture of that size with hardly a byte behind it is refused before
// any memory is taken.
TEST(Exr, AFewBytesDoNotAskForGigabytes) {
    ExrFile small;
    small.pixels = ImageF(16, 16, 4);
    small.channels = {"R", "G", "B", "A"};
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "huge.exr";
    ASSERT_TRUE(write_exr(path, small, ExrSample::full).ok());
    auto bytes = *read_file(path, 1u << 20);
    const std::vector<std::uint8_t> window{0, 0, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 15, 0, 0, 0};
    int found = 0;
    for (auto at = bytes.begin();
         (at = std::search(at, bytes.end(), window.begin(), window.end())) != bytes.end(); ++at, ++found)
        at[9] = at[13] = 0x1F;             // 7,952 a side
    ASSERT_EQ(found, 2);                   // data and display
    bytes.resize(bytes.size() + 8 * 7952); // the table of its rows, which is read first
    ASSERT_TRUE(write_file_atomic(path, bytes).ok());
    const auto read = read_exr(path);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().text().find("964 MiB of pixels, but the file has "), std::string::npos)
        << read.error().text();
}

TEST(Exr, ASideAndAllSamplesHaveAnEnd) {
    ExrFile small;
    small.pixels = ImageF(16, 16, 4);
    small.channels = {"R", "G", "B", "A"};
    const std::filesystem::path path = exr_scratch("side.exr");
    ASSERT_TRUE(write_exr(path, small, ExrSample::full).ok());
    const auto whole = *read_file(path, 1u << 20);
    const std::vector<std::uint8_t> window{0, 0, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 15, 0, 0, 0};
    const auto error_of = [&](int width, int height) {
        auto bytes = whole;
        for (auto at = bytes.begin();
             (at = std::search(at, bytes.end(), window.begin(), window.end())) != bytes.end();) {
            at[8] = static_cast<std::uint8_t>(width - 1);
            at[9] = static_cast<std::uint8_t>((width - 1) >> 8);
            at[12] = static_cast<std::uint8_t>(height - 1);
            at[13] = static_cast<std::uint8_t>((height - 1) >> 8);
        }
        bytes.resize(bytes.size() + 8 * static_cast<std::size_t>(height)); // the table of its rows
        EXPECT_TRUE(write_file_atomic(path, bytes).ok());
        const auto read = read_exr(path);
        return read.ok() ? std::string() : read.error().text();
    };
    EXPECT_NE(error_of(16385, 2).find("16385 x 2 pixels, expected 1 to 16384 a side"), std::string::npos)
        << error_of(16385, 2);
    EXPECT_NE(error_of(2, 16385).find("2 x 16385 pixels, expected 1 to 16384 a side"), std::string::npos)
        << error_of(2, 16385);
    EXPECT_NE(error_of(16384, 16384).find("more than the limit of 512 Mi samples"), std::string::npos)
        << error_of(16384, 16384);
}

TEST(Exr, ASmallPieceDoesNotAskForAHugePicture) {
    ExrFile small;
    small.pixels = ImageF(16, 16, 4);
    small.channels = {"R", "G", "B", "A"};
    const std::filesystem::path path = exr_scratch("huge_display.exr");
    ASSERT_TRUE(write_exr(path, small, ExrSample::full).ok());
    auto bytes = *read_file(path, 1u << 20);
    const std::string name = "displayWindow";
    const auto named = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
    ASSERT_NE(named, bytes.end());
    const std::vector<std::uint8_t> window{0, 0, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 15, 0, 0, 0};
    const auto at = std::search(named, bytes.end(), window.begin(), window.end());
    ASSERT_NE(at, bytes.end());
    at[9] = at[13] = 0x1F; // 7,952 a side, a gigabyte
    ASSERT_TRUE(write_file_atomic(path, bytes).ok());
    const auto read = read_exr(path);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().text().find("63234304 pixels, but holds 256 of them"), std::string::npos)
        << read.error().text();
}

// Each of the two limits by itself lets it pass: 61 MiB of pixels, a sixteenth of the picture that they lie
// in.
TEST(Exr, AFewBytesDoNotAskForAHugePictureAroundALargeOne) {
    ExrFile small;
    small.pixels = ImageF(16, 16, 4);
    small.channels = {"R", "G", "B", "A"};
    const std::filesystem::path path = exr_scratch("large_in_huge.exr");
    ASSERT_TRUE(write_exr(path, small, ExrSample::full).ok());
    auto bytes = *read_file(path, 1u << 20);
    const std::vector<std::uint8_t> window{0, 0, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 15, 0, 0, 0};
    const auto enlarge = [&](const std::string& name, std::uint8_t low, std::uint8_t high) {
        const auto named = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
        const auto at = std::search(named, bytes.end(), window.begin(), window.end());
        ASSERT_NE(at, bytes.end());
        at[8] = at[12] = low;
        at[9] = at[13] = high;
    };
    enlarge("displayWindow", 15, 0x1F);    // 7,952 a side
    enlarge("dataWindow", 0xCF, 0x07);     // 2,000 a side
    bytes.resize(bytes.size() + 8 * 2000); // the table of its rows
    ASSERT_TRUE(write_file_atomic(path, bytes).ok());
    const auto read = read_exr(path);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().text().find("964 MiB of pixels, but the file has "), std::string::npos)
        << read.error().text();
}

// 63 million pixels in a file that is long enough for them, where a reader wants 16 x 16: no memory for them.
TEST(Exr, AnotherShapeThanExpectedIsRefusedByTheHeader) {
    ExrFile small;
    small.pixels = ImageF(16, 16, 2);
    small.channels = {"A", "B"};
    const std::filesystem::path path = exr_scratch("shape.exr");
    ASSERT_TRUE(write_exr(path, small, ExrSample::full).ok());
    EXPECT_TRUE(read_exr(path, {16, 16, 2}).ok());
    EXPECT_TRUE(read_exr(path, {16, 16, 0}).ok());
    const auto channels = read_exr(path, {16, 16, 1});
    ASSERT_FALSE(channels.ok());
    EXPECT_NE(channels.error().text().find("shape.exr: has 2 channels, expected 1"), std::string::npos)
        << channels.error().text();
    const auto whole = *read_file(path, 1u << 20);
    const std::vector<std::uint8_t> window{0, 0, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 15, 0, 0, 0};
    const auto error_of = [&](std::initializer_list<std::string> enlarged) {
        auto bytes = whole;
        for (const std::string& name : enlarged) {
            const auto named = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
            const auto at = std::search(named, bytes.end(), window.begin(), window.end());
            at[9] = at[13] = 0x1F; // 7,952 a side
        }
        bytes.resize(bytes.size() + 8 * 7952); // the table of its rows
        EXPECT_TRUE(write_file_atomic(path, bytes).ok());
        std::filesystem::resize_file(path, 1u << 20); // long enough: a hole
        const auto read = read_exr(path, {16, 16, 0});
        return read.ok() ? std::string("read") : read.error().text();
    };
    const std::string picture = error_of({"dataWindow", "displayWindow"}), around = error_of({"dataWindow"});
    EXPECT_NE(picture.find("is 7952 x 7952 pixels, expected 16 x 16"), std::string::npos) << picture;
    EXPECT_NE(around.find("holds 63234304 pixels, but its picture has 256 of them"), std::string::npos)
        << around;
}

TEST(Exr, AnAttributeIsNoLongerThanItsFile) {
    ExrFile small;
    small.pixels = ImageF(16, 16, 1);
    small.channels = {"Z"};
    small.text = {{"words", "abcd"}};
    const std::filesystem::path path = exr_scratch("long_attribute.exr");
    ASSERT_TRUE(write_exr(path, small, ExrSample::full).ok());
    auto bytes = *read_file(path, 1u << 20);
    const std::string_view head("words\0string\0\4\0\0\0abcd", 21);
    const auto at = std::search(bytes.begin(), bytes.end(), head.begin(), head.end());
    ASSERT_NE(at, bytes.end());
    at[16] = 0x70; // 1.75 GiB
    ASSERT_TRUE(write_file_atomic(path, bytes).ok());
    const auto read = read_exr(path);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().text().find("says that it is 1879048196 bytes long"), std::string::npos)
        << read.error().text();
}

TEST(Exr, MissingFileAndFolder) {
    EXPECT_NE(read_exr(exr_scratch("absent.exr")).error().what.find("no such file"), std::string::npos);
    EXPECT_NE(read_exr(exr_scratch("x").parent_path()).error().what.find("not a plain file"),
              std::string::npos);
}

// A limit on the size of files fails writes as a full disk does.
#if !defined(_WIN32) // which has no limit for the size of a file
TEST(Exr, FullDiskIsAnErrorAndLeavesTheOldFile) {
    const fs::path path = exr_scratch("full/picture.exr");
    fs::remove_all(path.parent_path());
    fs::create_directories(path.parent_path());
    ASSERT_TRUE(write_file_atomic(path, "old").ok());
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit small{1000, limit.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = write_exr(path, sample_file({"R", "G", "B"}), ExrSample::full);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().where, path.string());
    EXPECT_EQ(*read_text_file(path, 100), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(path.parent_path()), fs::directory_iterator()), 1);
}
#endif

} // namespace
} // namespace ghost::image
