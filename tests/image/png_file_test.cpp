// SPDX-License-Identifier: Apache-2.0
// PNGs put together here byte by byte, with stored (not packed) pixels.
#include "disk/crc32.h"
#include "image/ldr.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ghost::image {
namespace {

using Bytes8 = std::vector<std::uint8_t>;

void put_u32(Bytes8& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

Bytes8 chunk(const std::string& kind, const Bytes8& content) {
    Bytes8 out;
    put_u32(out, static_cast<std::uint32_t>(content.size()));
    out.insert(out.end(), kind.begin(), kind.end());
    out.insert(out.end(), content.begin(), content.end());
    put_u32(out, crc32(Bytes(out).subspan(4)));
    return out;
}

// A zlib stream of one stored block.
Bytes8 stored(const Bytes8& content) {
    const auto size = static_cast<std::uint16_t>(content.size());
    const auto low = [](unsigned value) { return static_cast<std::uint8_t>(value & 0xff); };
    Bytes8 out{0x78, 1, 1, low(size), low(size >> 8u), low(~size), low(~size >> 8u)};
    out.insert(out.end(), content.begin(), content.end());
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t byte : content) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    put_u32(out, b << 16 | a);
    return out;
}

struct Header {
    std::uint32_t width, height;
    std::uint8_t bits, colours, interlaced = 0; // colours: 0 gray, 2 RGB, 3 palette, 4 gray and alpha, 6 RGBA
};

// lines: each begins with its filter, 0. between: chunks before the pixels.
Bytes8 png(const Header& header, const Bytes8& lines, const std::vector<Bytes8>& between = {}) {
    Bytes8 first;
    put_u32(first, header.width);
    put_u32(first, header.height);
    first.insert(first.end(), {header.bits, header.colours, 0, 0, header.interlaced});
    Bytes8 out{0x89, 'P', 'N', 'G', 13, 10, 26, 10};
    std::vector<Bytes8> chunks{chunk("IHDR", first)};
    chunks.insert(chunks.end(), between.begin(), between.end());
    chunks.push_back(chunk("IDAT", stored(lines)));
    chunks.push_back(chunk("IEND", {}));
    for (const Bytes8& one : chunks) out.insert(out.end(), one.begin(), one.end());
    return out;
}

const Bytes8 kGray = png({2, 2, 8, 0}, {0, 10, 20, 0, 30, 40});
const Bytes8 kGrayPixels{10, 10, 10, 255, 20, 20, 20, 255, 30, 30, 30, 255, 40, 40, 40, 255};

void expect_pixels(const std::string& what, const Bytes8& file, const Bytes8& rgba) {
    const auto image = decode_ldr(file, what);
    ASSERT_TRUE(image.ok()) << image.error().text();
    EXPECT_EQ(image->samples, rgba) << what;
}

TEST(PngFile, every_kind_becomes_rgba) {
    const Bytes8 palette = chunk("PLTE", {1, 2, 3, 4, 5, 6});
    expect_pixels("gray of 8 bits", kGray, kGrayPixels);
    expect_pixels("gray of 1 bit", png({2, 1, 1, 0}, {0, 0x40}), {0, 0, 0, 255, 255, 255, 255, 255});
    expect_pixels("gray of 2 bits, one see-through", png({2, 1, 2, 0}, {0, 0x60}, {chunk("tRNS", {0, 1})}),
                  {85, 85, 85, 0, 170, 170, 170, 255});
    expect_pixels("gray of 16 bits", png({1, 1, 16, 0}, {0, 0x12, 0xff}), {0x12, 0x12, 0x12, 255});
    expect_pixels("gray and alpha", png({1, 1, 8, 4}, {0, 70, 80}), {70, 70, 70, 80});
    expect_pixels("gray and alpha of 16 bits", png({1, 1, 16, 4}, {0, 70, 1, 80, 2}), {70, 70, 70, 80});
    expect_pixels("RGB", png({1, 1, 8, 2}, {0, 7, 8, 9}), {7, 8, 9, 255});
    expect_pixels("RGB, one see-through",
                  png({1, 1, 8, 2}, {0, 7, 8, 9}, {chunk("tRNS", {0, 7, 0, 8, 0, 9})}), {7, 8, 9, 0});
    expect_pixels("RGBA of 16 bits", png({1, 1, 16, 6}, {0, 7, 0, 8, 0, 9, 0, 10, 255}), {7, 8, 9, 10});
    expect_pixels("palette", png({2, 1, 8, 3}, {0, 1, 0}, {palette}), {4, 5, 6, 255, 1, 2, 3, 255});
    expect_pixels("palette of 4 bits with alpha",
                  png({2, 1, 4, 3}, {0, 0x10}, {palette, chunk("tRNS", {99})}), {4, 5, 6, 255, 1, 2, 3, 99});
}

TEST(PngFile, interlaced_lines_find_their_place) {
    // Adam7 of 2 x 3 pixels: passes 1, 6 and 5 have 1, 2 and 1 of them, pass 7 its line of 2.
    expect_pixels("interlaced", png({2, 3, 8, 0, 1}, {0, 1, 0, 5, 0, 2, 0, 6, 0, 3, 4}),
                  {1, 1, 1, 255, 2, 2, 2, 255, 3, 3, 3, 255, 4, 4, 4, 255, 5, 5, 5, 255, 6, 6, 6, 255});
}

TEST(PngFile, gamma_profiles_and_texts_are_not_looked_at) {
    const Bytes8 gamma = chunk("gAMA", {0, 1, 0x86, 0xa0}); // linear
    const Bytes8 rubbish{'x', 0, 0, 1, 2, 3, 4, 5};
    expect_pixels("others",
                  png({2, 2, 8, 0}, {0, 10, 20, 0, 30, 40},
                      {gamma, chunk("iCCP", rubbish), chunk("zTXt", rubbish), chunk("ghOS", {1})}),
                  kGrayPixels);
}

// Decodes it both ways: with a place for what is damaged, and without.
void expect_damage(const Bytes8& file, const Bytes8& rgba, const std::string& words) {
    std::string damage;
    const auto image = decode_ldr(file, "odd.png", {}, &damage);
    ASSERT_TRUE(image.ok()) << image.error().text();
    EXPECT_EQ(image->samples, rgba);
    EXPECT_EQ(damage, "the picture is damaged: " + words);
    const auto refused = decode_ldr(file, "odd.png");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().text(), "odd.png: the picture is damaged: " + words);
}

TEST(PngFile, what_is_damaged_is_shown_and_said) {
    Bytes8 checksum = kGray;
    checksum[checksum.size() - 13] ^= 1; // of the pixels
    expect_damage(checksum, kGrayPixels, "IDAT: CRC error");
    Bytes8 cut = kGray;
    cut.resize(cut.size() - 12); // without its end
    expect_damage(cut, kGrayPixels, "the file ends early");
    expect_damage(png({1, 1, 8, 0}, Bytes8(60000, 0)), {0, 0, 0, 255}, "IDAT: Too much image data");
}

TEST(PngFile, what_cannot_be_shown_is_refused) {
    const auto refused = [](const Bytes8& file) {
        const auto image = decode_ldr(file, "bad.png");
        return image.ok() ? "" : image.error().text();
    };
    const std::string begin = "bad.png: not a readable PNG picture: ";
    EXPECT_EQ(refused(png({2, 1, 8, 3}, {0, 1, 0})), begin + "IDAT: Missing PLTE before IDAT");
    EXPECT_EQ(refused(png({2, 9, 8, 0}, {0, 1, 0})), begin + "Not enough image data");
    EXPECT_EQ(refused(png({2, 1, 7, 0}, {0, 1, 0})), begin + "Invalid IHDR data");
    EXPECT_EQ(refused(png({0, 1, 8, 0}, {0})), begin + "Invalid IHDR data");
    EXPECT_EQ(refused(png({2, 1, 8, 0}, {9, 1, 0})), begin + "bad adaptive filter value");
}

TEST(PngFile, an_index_without_a_colour_is_black) {
    expect_pixels("palette", png({2, 1, 8, 3}, {0, 1, 200}, {chunk("PLTE", {1, 2, 3, 4, 5, 6})}),
                  {4, 5, 6, 255, 0, 0, 0, 255});
}

TEST(PngFile, no_changed_byte_crashes_or_is_printed) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const Bytes8 all[] = {
        kGray, png({2, 3, 8, 0, 1}, {0, 1, 0, 5, 0, 2, 0, 6, 0, 3, 4}),
        png({2, 1, 4, 3}, {0, 0x10}, {chunk("PLTE", {1, 2, 3, 4, 5, 6}), chunk("tRNS", {99})})};
    int shown = 0;
    for (const Bytes8& whole : all)
        for (std::size_t at = 0; at < whole.size(); ++at)
            for (int change = 1; change < 256; ++change) {
                Bytes8 file = whole;
                file[at] ^= static_cast<std::uint8_t>(change);
                std::string damage;
                shown += decode_ldr(file, "changed.png", {1024, 1u << 20}, &damage).ok();
            }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_GT(shown, 0);
}

} // namespace
} // namespace ghost::image
