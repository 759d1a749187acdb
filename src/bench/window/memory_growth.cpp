// SPDX-License-Identifier: Apache-2.0
#include "bench/window/private/memory_growth.h"

#include "bench/bench.h"

#include <cmath>
#include <vector>

namespace ghost::app {
namespace {

constexpr double kAlike_mb = 4; // one picture of the window more or less

} // namespace

std::optional<double> memory_growth_mb(std::span<const MemoryRow> rows, std::size_t warm) {
    if (warm >= rows.size()) return std::nullopt;
    const std::span<const MemoryRow> after = rows.subspan(warm);
    const std::size_t half = after.size() / 2;
    std::vector<double> grown_mb;
    for (const MemoryRow& late : after.subspan(half)) {
        std::vector<double> before_mb;
        for (const MemoryRow& early : after.first(half))
            if (std::abs(early.device_mb - late.device_mb) <= kAlike_mb)
                before_mb.push_back(early.process_mb);
        if (!before_mb.empty()) grown_mb.push_back(late.process_mb - median(before_mb));
    }
    if (grown_mb.empty()) return std::nullopt;
    return median(grown_mb);
}

} // namespace ghost::app
