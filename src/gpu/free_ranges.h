#pragma once
// SPDX-License-Identifier: Apache-2.0
// FreeRanges: what of a block of memory is free, and who comes next. First fit, by place; what is given back
// merges with its free neighbours. Bytes. Pure.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace ghost::gpu {

class FreeRanges {
public:
    explicit FreeRanges(std::uint64_t bytes);

    // Where a range begins that is free from now on no more. align: a power of two. Nothing where none fits.
    std::optional<std::uint64_t> take(std::uint64_t bytes, std::uint64_t align);
    // A range that was taken, whole.
    void give_back(std::uint64_t begin, std::uint64_t bytes);
    bool is_whole() const { return free_bytes_ == bytes_; } // nothing is taken
    std::uint64_t free_bytes() const { return free_bytes_; }
    std::size_t count() const { return ranges_.size(); } // of free ranges

private:
    std::map<std::uint64_t, std::uint64_t> ranges_; // begin -> end
    std::uint64_t bytes_;
    std::uint64_t free_bytes_;
};

} // namespace ghost::gpu
