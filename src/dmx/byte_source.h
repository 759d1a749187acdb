#pragma once
// SPDX-License-Identifier: Apache-2.0
// ByteSource: bytes of a file or of memory, read from any place, for files too long to hold. One thread.

#include "base/byte_reader.h"
#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace ghost::dmx {

class ByteSource {
public:
    // Error: missing, not a plain file, unreadable.
    static Result<ByteSource> open(const std::filesystem::path& path);
    explicit ByteSource(std::vector<std::uint8_t> memory)
        : memory_(std::move(memory)), size_(memory_.size()) {}

    // As it was when it was opened.
    std::uint64_t size() const { return size_; }
    // Up to target.size() bytes from offset; how many there were.
    std::size_t read(std::uint64_t offset, std::span<std::uint8_t> target);

private:
    ByteSource(std::ifstream file, std::uint64_t size) : file_(std::move(file)), size_(size) {}

    std::ifstream file_;
    std::vector<std::uint8_t> memory_;
    std::uint64_t size_ = 0;
};

} // namespace ghost::dmx
