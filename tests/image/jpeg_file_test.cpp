// SPDX-License-Identifier: Apache-2.0
#include "image/ldr.h"

#include "red_jpeg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ghost::image {
namespace {

#include "odd_jpegs.inc"

using Bytes8 = std::vector<std::uint8_t>;

const Bytes8 kRed(std::begin(kRedJpeg), std::end(kRedJpeg));

void expect_pixel(const Image8& image, int x, int y, const std::vector<int>& rgba) {
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(image.at(x, y)[k], rgba[k], 3) << x << ", " << y << ", channel " << k;
}

// Before the end marker.
Bytes8 with_inserted(Bytes8 file, const Bytes8& inserted) {
    file.insert(file.end() - 2, inserted.begin(), inserted.end());
    return file;
}

TEST(JpegFile, every_kind_becomes_opaque_colour) {
    const struct {
        Bytes bytes;
        int side;
        std::vector<int> rgba;
    } kinds[] = {{kGrayJpeg, 8, {90, 90, 90, 255}},
                 {kInkJpeg, 8, {200, 30, 60, 255}},
                 {kInkAsYcckJpeg, 8, {200, 30, 60, 255}},
                 {kProgressiveJpeg, 8, {200, 30, 60, 255}},
                 {kOddJpeg, 32, {200, 30, 60, 255}}};
    for (const auto& kind : kinds) {
        const auto image = decode_ldr(kind.bytes, "kind.jpg");
        ASSERT_TRUE(image.ok()) << image.error().text();
        EXPECT_EQ(image->width, kind.side);
        EXPECT_EQ(image->height, kind.side);
        expect_pixel(*image, 4, 4, kind.rgba);
    }
}

TEST(JpegFile, how_the_camera_was_held_turns_nothing) {
    const auto image = decode_ldr(kTurnedJpeg, "turned.jpg");
    ASSERT_TRUE(image.ok()) << image.error().text();
    EXPECT_EQ(image->width, 16);
    EXPECT_EQ(image->height, 8);
    expect_pixel(*image, 1, 4, {200, 30, 60, 255});
    expect_pixel(*image, 14, 4, {0, 0, 200, 255});
}

TEST(JpegFile, a_table_larger_than_its_place_is_refused) {
    Bytes8 tables{0xff, 0xc4, 0x10, 0x00, 0x00};
    tables.insert(tables.end(), 16, 0x32); // codes of 1 to 16 bits
    tables.insert(tables.end(), 0x1000 - 19, 0);
    Bytes8 file = kRed;
    file.insert(file.begin() + 2, tables.begin(), tables.end());
    const auto picture = decode_ldr(file, "bad.jpg");
    ASSERT_FALSE(picture.ok());
    EXPECT_EQ(picture.error().text(), "bad.jpg: not a readable JPEG picture: Bogus Huffman table definition");
}

TEST(JpegFile, more_scans_than_any_picture_needs_are_refused) {
    const Bytes8 whole(std::begin(kProgressiveJpeg), std::end(kProgressiveJpeg));
    const Bytes8 mark{0xff, 0xda};
    const auto last = std::find_end(whole.begin(), whole.end(), mark.begin(), mark.end());
    Bytes8 scans;
    for (int k = 0; k < 40; ++k) scans.insert(scans.end(), last, whole.end() - 2);
    const auto picture = decode_ldr(with_inserted(whole, scans), "slow.jpg");
    ASSERT_FALSE(picture.ok());
    EXPECT_NE(picture.error().text().find("scans"), std::string::npos) << picture.error().text();
}

TEST(JpegFile, what_is_damaged_is_shown_and_said) {
    const Bytes8 file = with_inserted(kRed, Bytes8(8, 1));
    std::string damage;
    const auto image = decode_ldr(file, "odd.jpg", {}, &damage);
    ASSERT_TRUE(image.ok()) << image.error().text();
    expect_pixel(*image, 4, 4, {200, 30, 60, 255});
    EXPECT_NE(damage.find("the picture is damaged: Corrupt JPEG data"), std::string::npos) << damage;
    const auto refused = decode_ldr(file, "odd.jpg");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().text(), "odd.jpg: " + damage);
    ASSERT_TRUE(decode_ldr(kRed, "red.jpg", {}, &damage).ok());
    EXPECT_EQ(damage, "");
}

// Found by fuzzing: fill bytes, then a table that is larger than its place.
TEST(JpegFile, fill_bytes_hide_nothing) {
    const Bytes8 found{0xff, 0xff, 0xff, 0xff, 0xd8, 0xff, 0xff, 0xff, 0xff, 0xc4, 0xc4, 0x00, 0x00,
                       0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x32, 0xff, 0xff, 0xff, 0xd8, 0xff, 0xff,
                       0xff, 0xff, 0xc4, 0xc4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    EXPECT_FALSE(decode_ldr(found, "found.jpg").ok());
}

TEST(JpegFile, no_changed_byte_crashes_or_is_printed) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const Bytes all[] = {kRedJpeg, kGrayJpeg, kInkJpeg, kInkAsYcckJpeg, kProgressiveJpeg, kOddJpeg};
    int shown = 0;
    for (const Bytes& whole : all)
        for (std::size_t at = 0; at < whole.size(); ++at)
            for (const int change : {0x01, 0x80, 0xff}) {
                Bytes8 file(whole.begin(), whole.end());
                file[at] = static_cast<std::uint8_t>(file[at] ^ change);
                std::string damage;
                shown += decode_ldr(file, "changed.jpg", {1024, 1u << 20}, &damage).ok();
            }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_GT(shown, 0);
}

} // namespace
} // namespace ghost::image
