// SPDX-License-Identifier: Apache-2.0
// A fixture file's 2D symbol from anybody: no more lines and points than it may have, and none that is no
// number.
#include "base/check.h"
#include "fixture_files/common/svg_symbol.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto symbol = ghost::fixture::read_svg_symbol({data, size}, "fuzz.svg");
    if (!symbol.ok()) return 0;
    CHECK(symbol->lines.size() <= ghost::fixture::kMostSymbolLines);
    std::size_t count = 0;
    for (const ghost::fixture::SvgSymbol::Line& line : symbol->lines) {
        count += line.points.size();
        for (const glm::vec2& point : line.points) CHECK(std::isfinite(point.x) && std::isfinite(point.y));
    }
    CHECK(count <= ghost::fixture::kMostSymbolPoints);
    return 0;
}
