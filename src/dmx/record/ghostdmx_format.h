#pragma once
// SPDX-License-Identifier: Apache-2.0
// The bytes of a .ghostdmx recording, as docs/reference/recording.md describes them: a header, pieces, and at
// the end an index with a trailer that finds it. Little-endian. One or more pieces make a block, which is one
// zstd stream, starts with the levels of every universe and needs nothing that stands before it. A piece
// holds whole frames and is written at once, so a recording can be cut between any two. Pure functions.

#include "base/byte_reader.h"
#include "base/result.h"
#include "dmx/record/recorded_frame.h"

#include <array>
#include <optional>
#include <vector>

namespace ghost::dmx::ghostdmx {

using std::chrono::microseconds;

inline constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'G', 'D', 'M', 'X', '\r', '\n', 0x1A};
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::uint32_t kMark = 0x784D4447; // "GDMx" before every piece
inline constexpr std::array<std::uint8_t, 8> kTrailerMark = {'G', 'D', 'M', 'X', 'e', 'n', 'd', '\n'};
inline constexpr std::size_t kHeaderBytes = 24;
inline constexpr std::size_t kPieceHeaderBytes = 28;
inline constexpr std::size_t kBlockHeadBytes = 16; // of the first piece's content, before the zstd stream
inline constexpr std::size_t kTrailerBytes = 16;

// Limits for what is read, and kept by what is written.
inline constexpr std::uint32_t kMaxPieceBytes = 24u << 20;
inline constexpr std::uint32_t kMaxIndexBytes = 64u << 20;
inline constexpr std::size_t kMaxBlockBytes = 16u << 20; // unpacked
inline constexpr std::size_t kMaxBlocks = 4u << 20;

struct Header {
    microseconds unix_time{0}; // when it began; 0: not known
};
std::vector<std::uint8_t> encode(const Header& header);
// Error.what says what is wrong; where stays empty.
Result<Header> decode_header(Bytes bytes);

enum class PieceKind : std::uint32_t { begins_block = 1, goes_on = 2, index = 3 };

struct PieceHeader {
    std::uint32_t crc =
        0; // of the rest of the header and the content; goes_on: after that of the piece before
    PieceKind kind = PieceKind::begins_block;
    std::uint32_t content_bytes = 0;
    std::uint32_t frames = 0; // in this block up to the end of this piece; of an index 0
    microseconds end{0};      // everything that happened up to then is in the file
};
// The whole piece. crc_before: of the piece before, 0 for the first of a block.
std::vector<std::uint8_t> encode(PieceHeader header, Bytes content, std::uint32_t crc_before);
// Nothing where these bytes begin no piece, by mark and limits. bytes: at least kPieceHeaderBytes.
std::optional<PieceHeader> decode_piece(Bytes bytes);
// bytes: a whole piece.
std::uint32_t piece_crc(Bytes bytes, std::uint32_t crc_before);

struct BlockPlace {
    std::uint64_t offset = 0;
    microseconds start{0};
    std::uint64_t first_frame = 0; // frames before this block
};
std::array<std::uint8_t, kBlockHeadBytes> encode_block_head(const BlockPlace& place);

struct Index {
    std::vector<BlockPlace> blocks; // by place and time
    std::uint64_t frames = 0;
    microseconds duration{0};
};
std::vector<std::uint8_t> encode(const Index& index);
std::optional<Index> decode_index(Bytes bytes);
std::array<std::uint8_t, kTrailerBytes> encode_trailer(std::uint64_t index_offset);

void put_u32(std::vector<std::uint8_t>& out, std::uint32_t value);
void put_u64(std::vector<std::uint8_t>& out, std::uint64_t value);
std::uint64_t read_u64(ByteReader& reader);
// Seven bits a byte, lowest first; the top bit says that more follow.
void put_varint(std::vector<std::uint8_t>& out, std::uint64_t value);
// Past the end or over 64 bits: 0, and the reader is no longer ok.
std::uint64_t read_varint(ByteReader& reader);

} // namespace ghost::dmx::ghostdmx
