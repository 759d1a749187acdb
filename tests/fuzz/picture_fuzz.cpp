// SPDX-License-Identifier: Apache-2.0
// Gobo pictures on anything: PNG (as it is, and with right checksums) and JPEG, drawings (SVG), path data.
#include "disk/crc32.h"
#include "fixture_files/common/gobo_drawing.h"
#include "fixture_files/common/svg_path.h"
#include "image/ldr.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

using namespace ghost;

namespace {

// A PNG file whose chunks have the checksums that they should have; any other as it is.
std::vector<std::uint8_t> with_checksums(Bytes bytes) {
    std::vector<std::uint8_t> png(bytes.begin(), bytes.end());
    constexpr std::size_t kSignature = 8, kAround = 12; // length, name and checksum of a chunk
    if (png.size() < kSignature || png[1] != 'P' || png[2] != 'N') return png;
    for (std::size_t at = kSignature; png.size() - at >= kAround;) {
        const std::size_t length = ByteReader(bytes.subspan(at)).u32_be();
        if (length > png.size() - at - kAround) break;
        const std::uint32_t sum = crc32(Bytes(png).subspan(at + 4, length + 4));
        for (std::size_t k = 0; k < 4; ++k)
            png[at + 8 + length + k] = static_cast<std::uint8_t>(sum >> (24 - 8 * k));
        at += kAround + length;
    }
    return png;
}

void decode(Bytes bytes) {
    const auto picture = image::decode_ldr(bytes, "fuzz");
    if (picture && picture->samples.size() != 4 * static_cast<std::size_t>(picture->width) *
                                                  static_cast<std::size_t>(picture->height))
        std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes(data, size);
    decode(bytes);
    if (const std::vector<std::uint8_t> mended = with_checksums(bytes);
        !std::equal(mended.begin(), mended.end(), data, data + size))
        decode(mended);
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const fixture::SvgLine& line : fixture::read_svg_path(text, 1000).lines)
        for (const glm::vec2& point : line.points)
            if (!std::isfinite(point.x) || !std::isfinite(point.y)) std::abort();
    (void)fixture::draw_gobo(bytes, "fuzz.svg");
    return 0;
}
