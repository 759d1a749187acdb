#pragma once
// SPDX-License-Identifier: Apache-2.0
// GzipFile: what a gzip file (RFC 1952) unpacks to, read from any place; forwards it is unpacked on,
// backwards from its beginning again. Memory: some hundred kilobytes. One thread.

#include "base/byte_reader.h"
#include "base/result.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

struct z_stream_s;

namespace ghost::dmx {

inline constexpr std::uint64_t kMaxUnpackedBytes = 64ull << 30; // further on nothing is read

class GzipFile {
public:
    static bool recognises(Bytes first_bytes);
    GzipFile(std::ifstream file, std::uint64_t packed_bytes, std::uint64_t most_bytes = kMaxUnpackedBytes);
    ~GzipFile();

    // Up to target.size() bytes from offset; fewer at the end, and where problem() says why.
    std::size_t read(std::uint64_t offset, std::span<std::uint8_t> target);
    // What it says of its own length, modulo 4 GiB, or what was read so far, if that is more.
    std::uint64_t likely_size() const { return std::max(told_size_, offset_); }
    const std::optional<std::string>& problem() const { return problem_; }

private:
    void restart();
    bool unpack_more();

    std::ifstream file_;
    std::uint64_t most_bytes_; // unpacked
    std::uint64_t told_size_ = 0;
    std::unique_ptr<z_stream_s> stream_;
    std::vector<std::uint8_t> packed_, window_; // window_: the last bytes unpacked
    std::uint64_t offset_ = 0;                  // of the end of window_, unpacked
    bool ended_ = false;
    std::optional<std::string> problem_;
};

} // namespace ghost::dmx
