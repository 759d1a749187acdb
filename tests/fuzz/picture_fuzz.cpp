// SPDX-License-Identifier: Apache-2.0
// Gobo pictures on anything: PNG and JPEG, drawings (SVG), path data. Seeds: the gobos of QLC+
// (qlcplus-data).
#include "fixture_files/common/gobo_drawing.h"
#include "fixture_files/common/svg_path.h"
#include "image/ldr.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

using namespace ghost;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes(data, size);
    if (const auto picture = image::decode_ldr(bytes, "fuzz"))
        if (picture->samples.size() !=
            4 * static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height))
            std::abort();
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const fixture::SvgLine& line : fixture::read_svg_path(text, 1000).lines)
        for (const glm::vec2& point : line.points)
            if (!std::isfinite(point.x) || !std::isfinite(point.y)) std::abort();
    (void)fixture::draw_gobo(bytes, "fuzz.svg");
    return 0;
}
