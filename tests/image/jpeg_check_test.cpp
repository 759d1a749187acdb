// SPDX-License-Identifier: Apache-2.0
#include "image/ldr.h"
#include "image/private/jpeg_check.h"

#include <gtest/gtest.h>

#include <vector>

namespace ghost::image {
namespace {

#include "red_jpeg.inc"

using Bytes8 = std::vector<std::uint8_t>;

// A DHT segment whose 16 counts are all this.
Bytes8 tables_of(std::uint8_t count) {
    Bytes8 segment{0xff, 0xc4, 0x10, 0x00, 0x00};
    segment.insert(segment.end(), 16, count);
    segment.insert(segment.end(), 0x1000 - 19, 0);
    return segment;
}

TEST(JpegCheck, a_whole_picture_has_no_fault) {
    EXPECT_EQ(fault_of_jpeg(kRedJpeg), "");
}

TEST(JpegCheck, a_table_larger_than_its_place_is_refused_wherever_it_stands) {
    const Bytes8 whole(std::begin(kRedJpeg), std::end(kRedJpeg));
    const std::size_t places[] = {2, whole.size() - 2}; // behind the start, before the end
    for (const std::size_t place : places) {
        Bytes8 file = whole;
        const Bytes8 bad = tables_of(0x32);
        file.insert(file.begin() + static_cast<std::ptrdiff_t>(place), bad.begin(), bad.end());
        EXPECT_EQ(fault_of_jpeg(file), "a Huffman table of more than 256 codes") << place;
        const auto picture = decode_ldr(file, "bad.jpg");
        ASSERT_FALSE(picture.ok());
        EXPECT_NE(picture.error().text().find("Huffman"), std::string::npos);
    }
}

TEST(JpegCheck, more_scans_than_any_picture_needs_are_refused) {
    const Bytes8 scan{0xff, 0xda, 0x00, 0x02};
    Bytes8 file(std::begin(kRedJpeg), std::end(kRedJpeg)); // has one
    for (int k = 0; k < 199; ++k) file.insert(file.end() - 2, scan.begin(), scan.end());
    EXPECT_EQ(fault_of_jpeg(file), "");
    file.insert(file.end() - 2, scan.begin(), scan.end());
    EXPECT_EQ(fault_of_jpeg(file), "more than 200 scans");
}

// Found by fuzzing: fill bytes, then a table that wrote past its place.
TEST(JpegCheck, fill_bytes_hide_nothing) {
    const Bytes8 found{0xff, 0xff, 0xff, 0xff, 0xd8, 0xff, 0xff, 0xff, 0xff, 0xc4, 0xc4, 0x00, 0x00,
                       0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x32, 0xff, 0xff, 0xff, 0xd8, 0xff, 0xff,
                       0xff, 0xff, 0xc4, 0xc4, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};
    EXPECT_NE(fault_of_jpeg(found), "");
    EXPECT_FALSE(decode_ldr(found, "found.jpg").ok());
}

} // namespace
} // namespace ghost::image
