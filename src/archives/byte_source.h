#pragma once
// SPDX-License-Identifier: Apache-2.0
// ByteSource: bytes of a file or of memory, read from any place, for files too long to hold; of a gzip file
// what it unpacks to. One thread.

#include "archives/gzip_file.h"
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

    // As it was when it was opened; of a gzip file what it says of itself.
    std::uint64_t size() const { return gzip_ ? gzip_->likely_size() : size_; }
    bool is_gzip() const { return gzip_ != nullptr; }
    // Of a gzip file: why it ended where it did.
    std::optional<std::string> problem() const { return gzip_ ? gzip_->problem() : std::nullopt; }
    // Up to target.size() bytes from offset; how many there were.
    std::size_t read(std::uint64_t offset, std::span<std::uint8_t> target);

private:
    ByteSource(std::ifstream file, std::uint64_t size) : file_(std::move(file)), size_(size) {}

    std::ifstream file_;
    std::unique_ptr<GzipFile> gzip_;
    std::vector<std::uint8_t> memory_;
    std::uint64_t size_ = 0;
};

} // namespace ghost::dmx
