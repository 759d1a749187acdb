// SPDX-License-Identifier: Apache-2.0
#include "gpu/free_ranges.h"

#include "base/check.h"

#include <iterator>

namespace ghost::gpu {

FreeRanges::FreeRanges(std::uint64_t bytes) : ranges_{{0, bytes}}, bytes_(bytes), free_bytes_(bytes) {
    CHECK(bytes > 0);
}

std::optional<std::uint64_t> FreeRanges::take(std::uint64_t bytes, std::uint64_t align) {
    CHECK(bytes > 0 && align > 0 && (align & (align - 1)) == 0);
    for (auto range = ranges_.begin(); range != ranges_.end(); ++range) {
        const std::uint64_t begin = range->first, end = range->second;
        const std::uint64_t at = (begin + align - 1) & ~(align - 1);
        if (at > end || end - at < bytes) continue;
        ranges_.erase(range);
        if (at > begin) ranges_.emplace(begin, at);
        if (end > at + bytes) ranges_.emplace(at + bytes, end);
        free_bytes_ -= bytes;
        return at;
    }
    return std::nullopt;
}

void FreeRanges::give_back(std::uint64_t begin, std::uint64_t bytes) {
    std::uint64_t first = begin, end = begin + bytes;
    CHECK(bytes > 0 && end <= bytes_);
    auto next = ranges_.lower_bound(begin);
    CHECK(next == ranges_.end() || next->first >= end); // else it was free already
    if (next != ranges_.begin()) {
        const auto before = std::prev(next);
        CHECK(before->second <= begin);
        if (before->second == begin) {
            first = before->first;
            ranges_.erase(before);
        }
    }
    if (next != ranges_.end() && next->first == end) {
        end = next->second;
        ranges_.erase(next);
    }
    ranges_.emplace(first, end);
    free_bytes_ += bytes;
}

} // namespace ghost::gpu
