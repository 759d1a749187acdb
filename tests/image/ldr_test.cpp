// SPDX-License-Identifier: Apache-2.0
#include "image/ldr.h"

#include "disk/crc32.h"
#include "disk/files.h"
#include "red_jpeg.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace ghost::image {
namespace {

namespace fs = std::filesystem;

fs::path ldr_scratch(const std::string& name) {
    const fs::path folder = fs::path(testing::TempDir()) / "ghost_ldr_test";
    fs::create_directories(folder);
    return folder / name;
}

Image8 sample_image(int channels) {
    Image8 image(23, 11, channels);
    for (std::size_t k = 0; k < image.samples.size(); ++k)
        image.samples[k] = static_cast<std::uint8_t>(k * 37);
    return image;
}

TEST(Ldr, PngRoundTrip) {
    const Image8 image = sample_image(4);
    ASSERT_TRUE(write_png(ldr_scratch("four.png"), image).ok());
    const auto back = read_ldr(ldr_scratch("four.png"));
    ASSERT_TRUE(back.ok()) << back.error().text();
    EXPECT_EQ(back->width, 23);
    EXPECT_EQ(back->height, 11);
    EXPECT_EQ(back->samples, image.samples);
}

TEST(Ldr, ThreeChannelsBecomeOpaque) {
    const Image8 image = sample_image(3);
    ASSERT_TRUE(write_png(ldr_scratch("three.png"), image).ok());
    const auto back = read_ldr(ldr_scratch("three.png"));
    ASSERT_TRUE(back.ok());
    ASSERT_EQ(back->channels, 4);
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 23; ++x) {
            for (int k = 0; k < 3; ++k) ASSERT_EQ(back->at(x, y)[k], image.at(x, y)[k]);
            ASSERT_EQ(back->at(x, y)[3], 255);
        }
}

TEST(Ldr, EveryTruncationOfAPngIsAnError) {
    ASSERT_TRUE(write_png(ldr_scratch("whole.png"), sample_image(4)).ok());
    const auto bytes = read_file(ldr_scratch("whole.png"), 1 << 20);
    ASSERT_TRUE(bytes.ok());
    // The last 16 bytes are a checksum and the end mark: the picture is whole without them.
    for (std::size_t length = 0; length + 16 < bytes->size(); ++length)
        ASSERT_FALSE(decode_ldr(Bytes(*bytes).first(length), "cut.png").ok())
            << length << " of " << bytes->size();
}

TEST(Ldr, JpegAndItsTruncations) {
    const auto image = decode_ldr(kRedJpeg, "red.jpg");
    ASSERT_TRUE(image.ok()) << image.error().text();
    EXPECT_EQ(image->width, 8);
    EXPECT_EQ(image->height, 8);
    EXPECT_NEAR(image->at(4, 4)[0], 200, 3);
    EXPECT_NEAR(image->at(4, 4)[1], 30, 3);
    EXPECT_NEAR(image->at(4, 4)[2], 60, 3);
    const Bytes whole(kRedJpeg);
    for (std::size_t length = 0; length < whole.size(); ++length)
        ASSERT_FALSE(decode_ldr(whole.first(length), "cut.jpg").ok()) << length << " of " << whole.size();
}

TEST(Ldr, ErrorsNameTheFile) {
    const std::uint8_t rubbish[] = {1, 2, 3, 4};
    const auto image = decode_ldr(rubbish, "poster.png");
    ASSERT_FALSE(image.ok());
    EXPECT_EQ(image.error().where, "poster.png");
    EXPECT_NE(image.error().what.find("PNG or JPEG"), std::string::npos);
    EXPECT_FALSE(read_ldr(ldr_scratch("absent.png")).ok());
}

// Bytes of a PNG's header that say its size.
std::vector<std::uint8_t> with_size(std::vector<std::uint8_t> png, std::uint32_t width,
                                    std::uint32_t height) {
    for (std::size_t k = 0; k < 4; ++k) {
        png[16 + k] = static_cast<std::uint8_t>(width >> (24 - 8 * k));
        png[20 + k] = static_cast<std::uint8_t>(height >> (24 - 8 * k));
    }
    const std::uint32_t sum = crc32(Bytes(png).subspan(12, 17));
    for (std::size_t k = 0; k < 4; ++k) png[29 + k] = static_cast<std::uint8_t>(sum >> (24 - 8 * k));
    return png;
}

std::vector<std::uint8_t> png_of(const Image8& image) {
    EXPECT_TRUE(write_png(ldr_scratch("sized.png"), image).ok());
    return *read_file(ldr_scratch("sized.png"), 1u << 24);
}

TEST(Ldr, TooLargeASideIsAnError) {
    const auto wide = with_size(png_of(sample_image(4)), 16385, 1);
    const auto refused = decode_ldr(wide, "wide.png");
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().what.find("16385 x 1 pixels, at most 16384 a side"), std::string::npos);
    EXPECT_EQ(decoded_bytes(wide), 0u);
}

TEST(Ldr, TooManyPixelsAreRefusedByTheHeader) {
    const auto png = png_of(sample_image(4));
    EXPECT_EQ(decoded_bytes(png), 23u * 11u * 4u);
    const auto largest = with_size(png, 16384, 8192); // 2^27
    EXPECT_EQ(decoded_bytes(largest), std::size_t{512} << 20);
    const auto larger = with_size(png, 16384, 8193);
    EXPECT_EQ(decoded_bytes(larger), 0u);
    const auto refused = decode_ldr(larger, "poster.png");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().text(),
              "poster.png: the picture has 16384 x 8193 pixels, at most 16384 a side and "
              "134217728 in all are allowed");
    std::vector<std::uint8_t> jpeg(std::begin(kRedJpeg), std::end(kRedJpeg));
    const std::uint8_t frame[] = {0xff, 0xc0};
    const auto start = std::search(jpeg.begin(), jpeg.end(), std::begin(frame), std::end(frame));
    ASSERT_NE(start, jpeg.end());
    for (const int k : {5, 7}) *(start + k) = 0x40; // 16384 x 16384, but for the low bytes
    EXPECT_FALSE(decode_ldr(jpeg, "poster.jpg").ok());
    EXPECT_EQ(decoded_bytes(jpeg), 0u);
}

TEST(Ldr, AUserMayHaveSmallerLimits) {
    const auto png = png_of(sample_image(4));
    EXPECT_TRUE(decode_ldr(png, "gobo.png", {23, 23 * 11}).ok());
    for (const LdrLimits& limits : {LdrLimits{22, 1000}, LdrLimits{23, 23 * 11 - 1}}) {
        const auto refused = decode_ldr(png, "gobo.png", limits);
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().what.find("23 x 11 pixels"), std::string::npos) << refused.error().what;
        EXPECT_EQ(decoded_bytes(png, limits), 0u);
    }
}

TEST(Ldr, APictureThatUnpacksToMoreThanItsSizeIsRefused) {
    const auto bomb = with_size(png_of(Image8(2048, 2048, 4)), 1, 1); // 16 MB
    const auto refused = decode_ldr(bomb, "bomb.png");
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().what.find("Too much image data"), std::string::npos);
}

} // namespace
} // namespace ghost::image
