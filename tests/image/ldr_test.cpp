// SPDX-License-Identifier: Apache-2.0
#include "image/ldr.h"

#include "base/files.h"

#include <gtest/gtest.h>

namespace ghost::image {
namespace {

namespace fs = std::filesystem;

#include "red_jpeg.inc"

fs::path scratch(const std::string& name) {
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
    ASSERT_TRUE(write_png(scratch("four.png"), image).ok());
    const auto back = read_ldr(scratch("four.png"));
    ASSERT_TRUE(back.ok()) << back.error().text();
    EXPECT_EQ(back->width, 23);
    EXPECT_EQ(back->height, 11);
    EXPECT_EQ(back->samples, image.samples);
}

TEST(Ldr, ThreeChannelsBecomeOpaque) {
    const Image8 image = sample_image(3);
    ASSERT_TRUE(write_png(scratch("three.png"), image).ok());
    const auto back = read_ldr(scratch("three.png"));
    ASSERT_TRUE(back.ok());
    ASSERT_EQ(back->channels, 4);
    for (int y = 0; y < 11; ++y)
        for (int x = 0; x < 23; ++x) {
            for (int k = 0; k < 3; ++k) ASSERT_EQ(back->at(x, y)[k], image.at(x, y)[k]);
            ASSERT_EQ(back->at(x, y)[3], 255);
        }
}

TEST(Ldr, EveryTruncationOfAPngIsAnError) {
    ASSERT_TRUE(write_png(scratch("whole.png"), sample_image(4)).ok());
    const auto bytes = read_file(scratch("whole.png"), 1 << 20);
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
    EXPECT_FALSE(read_ldr(scratch("absent.png")).ok());
}

TEST(Ldr, TooLargeASideIsAnError) {
    // Header of a PNG of 16385 x 1.
    const std::uint8_t header[] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0,
                                   0,    64,  1,   0,   0,  0,  1,  8,  6, 0, 0, 0,  0,   0,   0,   0};
    EXPECT_FALSE(decode_ldr(header, "wide.png").ok());
}

} // namespace
} // namespace ghost::image
