#pragma once
// SPDX-License-Identifier: Apache-2.0
// Writes a .ghostdmx recording, forwards only (docs/reference/recording.md). What was flushed can be read,
// whatever happens after. Memory: one block. One thread.

#include "dmx/record/ghostdmx_block.h"
#include "dmx/record/zstd_stream.h"

namespace ghost::dmx {

class GhostdmxWriter final : public FrameWriter {
public:
    explicit GhostdmxWriter(ByteSink sink) : sink_(std::move(sink)) {}

    void began(std::chrono::microseconds unix_time) override { header_.unix_time = unix_time; }
    // Error: time past kLongestRecording, or more than kMaxRecordedUniverses. Time must not go back.
    Result<void> append(const RecordedFrame& frame) override;
    Result<void> flush(std::chrono::microseconds now) override;
    Result<void> finish(std::chrono::microseconds duration) override;

private:
    Result<void> put(Bytes bytes);
    Result<void> put_header();
    bool block_is_full(std::chrono::microseconds now) const;
    void begin_block(std::chrono::microseconds start);
    Result<void> put_piece(Packer::Then then, std::chrono::microseconds end);

    ByteSink sink_;
    std::uint64_t offset_ = 0; // bytes written
    ghostdmx::Header header_;
    ghostdmx::Index index_;
    ghostdmx::States states_;
    std::chrono::microseconds time_{0}; // of the last frame
    std::chrono::microseconds end_{0};  // of the last piece

    // The block that is being written, index_.blocks.back().
    Packer packer_;
    bool open_ = false;
    bool begun_ = false;          // its first piece is written
    std::size_t key_bytes_ = 0;   // unpacked
    std::size_t block_bytes_ = 0; // unpacked, with what waits
    std::uint32_t block_frames_ = 0;
    std::uint32_t crc_ = 0;             // of its last piece
    std::vector<std::uint8_t> waiting_; // not packed yet
};

} // namespace ghost::dmx
