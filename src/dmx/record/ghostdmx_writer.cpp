// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/ghostdmx_writer.h"

#include "base/check.h"

#include <algorithm>

namespace ghost::dmx {

using namespace ghostdmx;

namespace {

// A block ends when its frames are this many times as long as its key, so that keys are a fifth of what is
// packed at most, but not before it is worth packing, and after some time, so that damage costs no more.
constexpr std::size_t kFramesPerKey = 4;
constexpr std::size_t kLeastFrameBytes = 256u << 10;
constexpr microseconds kLongestBlock = std::chrono::minutes(10);
constexpr microseconds kAliveEvery = std::chrono::seconds(10); // that nothing happened is news, too

} // namespace

Result<void> GhostdmxWriter::put(Bytes bytes) {
    TRY_VOID(sink_(bytes));
    offset_ += bytes.size();
    return {};
}

Result<void> GhostdmxWriter::put_header() {
    return offset_ == 0 ? put(encode(header_)) : Result<void>();
}

bool GhostdmxWriter::block_is_full(microseconds now) const {
    const std::size_t frames = block_bytes_ - key_bytes_;
    return frames >= std::max(kLeastFrameBytes, kFramesPerKey * key_bytes_) ||
           now - index_.blocks.back().start >= kLongestBlock;
}

void GhostdmxWriter::begin_block(microseconds start) {
    index_.blocks.push_back({offset_, start, index_.frames});
    open_ = true;
    begun_ = false;
    block_frames_ = 0;
    encode_key(states_, start, index_.frames, waiting_);
    key_bytes_ = block_bytes_ = waiting_.size();
}

Result<void> GhostdmxWriter::append(const RecordedFrame& frame) {
    CHECK(frame.time >= time_);
    CHECK(frame.levels != nullptr && frame.universe >= 1 && frame.universe <= kMaxUniverse);
    if (frame.time > kLongestRecording) return Error{"longer than 366 days", ""};
    if (states_.size() == kMaxRecordedUniverses && !states_.contains(frame.universe))
        return Error{"more than " + std::to_string(kMaxRecordedUniverses) + " universes", ""};
    TRY_VOID(put_header());
    if (open_ && block_is_full(frame.time)) TRY_VOID(put_piece(Packer::Then::end, time_));
    if (!open_ && index_.blocks.size() == kMaxBlocks)
        return Error{"more than " + std::to_string(kMaxBlocks) + " blocks", ""};
    if (!open_) {
        begin_block(frame.time);
        time_ = frame.time;
    }
    const std::size_t before = waiting_.size();
    encode_frame(frame, time_, index_.frames, states_, waiting_);
    block_bytes_ += waiting_.size() - before;
    time_ = frame.time;
    ++index_.frames;
    ++block_frames_;
    return {};
}

Result<void> GhostdmxWriter::put_piece(Packer::Then then, microseconds end) {
    std::vector<std::uint8_t> content;
    if (!begun_) {
        const auto head = encode_block_head(index_.blocks.back());
        content.assign(head.begin(), head.end());
    }
    packer_.pack(waiting_, then, content);
    waiting_.clear();
    PieceHeader header;
    header.kind = begun_ ? PieceKind::goes_on : PieceKind::begins_block;
    header.frames = block_frames_;
    header.end = end_ = std::max(end_, end);
    const std::vector<std::uint8_t> piece = encode(header, content, begun_ ? crc_ : 0);
    ByteReader reader{Bytes(piece)};
    reader.skip(4);
    crc_ = reader.u32_le();
    begun_ = true;
    open_ = then == Packer::Then::flush;
    return put(piece);
}

Result<void> GhostdmxWriter::flush(microseconds now) {
    TRY_VOID(put_header());
    if (!open_ || (waiting_.empty() && now - end_ < kAliveEvery)) return {};
    return put_piece(Packer::Then::flush, std::clamp(now, time_, kLongestRecording));
}

Result<void> GhostdmxWriter::finish(microseconds duration) {
    TRY_VOID(put_header());
    index_.duration = std::clamp(duration, std::max(time_, end_), kLongestRecording);
    if (open_) TRY_VOID(put_piece(Packer::Then::end, index_.duration));
    PieceHeader header;
    header.kind = PieceKind::index;
    header.end = index_.duration;
    const std::uint64_t place = offset_;
    TRY_VOID(put(encode(header, encode(index_), 0)));
    return put(encode_trailer(place));
}

} // namespace ghost::dmx
