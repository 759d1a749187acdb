// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/ghostdmx_format.h"

#include "disk/crc32.h"

#include <algorithm>

namespace ghost::dmx::ghostdmx {

namespace {

constexpr std::size_t kCrcEnd = 8; // of a piece: mark and checksum stand before what is summed
constexpr std::uint64_t kMaxTime = static_cast<std::uint64_t>(kLongestRecording.count());

std::uint64_t number(microseconds time) {
    return static_cast<std::uint64_t>(time.count());
}

microseconds time_of(std::uint64_t number) {
    return microseconds(static_cast<std::int64_t>(number));
}

template <std::size_t size>
std::array<std::uint8_t, size> to_array(const std::vector<std::uint8_t>& bytes) {
    std::array<std::uint8_t, size> result{};
    std::copy_n(bytes.begin(), size, result.begin());
    return result;
}

} // namespace

void put_u32(std::vector<std::uint8_t>& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void put_u64(std::vector<std::uint8_t>& out, std::uint64_t value) {
    put_u32(out, static_cast<std::uint32_t>(value));
    put_u32(out, static_cast<std::uint32_t>(value >> 32));
}

std::uint64_t read_u64(ByteReader& reader) {
    const std::uint64_t low = reader.u32_le();
    return low | static_cast<std::uint64_t>(reader.u32_le()) << 32;
}

void put_varint(std::vector<std::uint8_t>& out, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) out.push_back(static_cast<std::uint8_t>(value | 0x80));
    out.push_back(static_cast<std::uint8_t>(value));
}

std::uint64_t read_varint(ByteReader& reader) {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const std::uint8_t byte = reader.u8();
        if (shift == 63 && byte > 1) break;
        value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
        if (byte < 0x80) return value;
    }
    reader.skip(reader.left() + 1);
    return 0;
}

std::vector<std::uint8_t> encode(const Header& header) {
    std::vector<std::uint8_t> out(kMagic.begin(), kMagic.end());
    put_u32(out, kVersion);
    put_u64(out, number(header.unix_time));
    put_u32(out, crc32(out));
    return out;
}

Result<Header> decode_header(Bytes bytes) {
    if (bytes.size() < kHeaderBytes)
        return Error{"ends inside of its header: nothing of the recording is left", ""};
    ByteReader reader(bytes.first(kHeaderBytes));
    reader.skip(kMagic.size());
    const std::uint32_t version = reader.u32_le();
    Header header;
    header.unix_time = time_of(read_u64(reader));
    const bool whole = reader.u32_le() == crc32(bytes.first(kHeaderBytes - 4));
    if (whole && version != kVersion)
        return Error{"is of version " + std::to_string(version) + ", this Ghostlight reads version " +
                         std::to_string(kVersion),
                     ""};
    // A damaged header costs the date at most.
    if (!whole || header.unix_time < microseconds(0)) header.unix_time = microseconds(0);
    return header;
}

std::vector<std::uint8_t> encode(PieceHeader header, Bytes content, std::uint32_t crc_before) {
    std::vector<std::uint8_t> out;
    out.reserve(kPieceHeaderBytes + content.size());
    put_u32(out, kMark);
    put_u32(out, 0);
    put_u32(out, static_cast<std::uint32_t>(header.kind));
    put_u32(out, static_cast<std::uint32_t>(content.size()));
    put_u32(out, header.frames);
    put_u64(out, number(header.end));
    out.insert(out.end(), content.begin(), content.end());
    const std::uint32_t crc = piece_crc(out, crc_before);
    for (std::size_t i = 0; i < 4; ++i) out[4 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    return out;
}

std::optional<PieceHeader> decode_piece(Bytes bytes) {
    ByteReader reader(bytes);
    if (reader.u32_le() != kMark) return std::nullopt;
    PieceHeader header;
    header.crc = reader.u32_le();
    const std::uint32_t kind = reader.u32_le();
    header.content_bytes = reader.u32_le();
    header.frames = reader.u32_le();
    const std::uint64_t end = read_u64(reader);
    if (!reader.ok() || kind < 1 || kind > 3 || end > kMaxTime) return std::nullopt;
    header.kind = static_cast<PieceKind>(kind);
    header.end = time_of(end);
    const bool fits = header.kind == PieceKind::index ? header.content_bytes <= kMaxIndexBytes
                                                      : header.content_bytes <= kMaxPieceBytes &&
                                                            (header.kind == PieceKind::goes_on ||
                                                             header.content_bytes >= kBlockHeadBytes);
    return fits ? std::optional(header) : std::nullopt;
}

std::uint32_t piece_crc(Bytes bytes, std::uint32_t crc_before) {
    return crc32(bytes.subspan(kCrcEnd), crc_before);
}

std::array<std::uint8_t, kBlockHeadBytes> encode_block_head(const BlockPlace& place) {
    std::vector<std::uint8_t> out;
    put_u64(out, number(place.start));
    put_u64(out, place.first_frame);
    return to_array<kBlockHeadBytes>(out);
}

std::vector<std::uint8_t> encode(const Index& index) {
    std::vector<std::uint8_t> out;
    put_varint(out, number(index.duration));
    put_varint(out, index.frames);
    put_varint(out, index.blocks.size());
    BlockPlace before;
    for (const BlockPlace& block : index.blocks) {
        put_varint(out, block.offset - before.offset);
        put_varint(out, number(block.start - before.start));
        put_varint(out, block.first_frame - before.first_frame);
        before = block;
    }
    return out;
}

std::optional<Index> decode_index(Bytes bytes) {
    ByteReader reader(bytes);
    Index index;
    const std::uint64_t duration = read_varint(reader);
    index.frames = read_varint(reader);
    const std::uint64_t count = read_varint(reader);
    if (!reader.ok() || duration > kMaxTime || count > kMaxBlocks || count > bytes.size())
        return std::nullopt;
    index.duration = time_of(duration);
    index.blocks.reserve(static_cast<std::size_t>(count));
    BlockPlace block;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t offset = read_varint(reader), start = read_varint(reader),
                            frames = read_varint(reader);
        if (!reader.ok() || offset == 0 || offset > (1ull << 62) - block.offset ||
            start > duration - number(block.start) || frames > index.frames - block.first_frame)
            return std::nullopt;
        block = {block.offset + offset, block.start + time_of(start), block.first_frame + frames};
        index.blocks.push_back(block);
    }
    return index;
}

std::array<std::uint8_t, kTrailerBytes> encode_trailer(std::uint64_t index_offset) {
    std::vector<std::uint8_t> out;
    put_u64(out, index_offset);
    out.insert(out.end(), kTrailerMark.begin(), kTrailerMark.end());
    return to_array<kTrailerBytes>(out);
}

} // namespace ghost::dmx::ghostdmx
