// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/ghostdmx_reader.h"

#include "dmx/record/zstd_stream.h"

#include <algorithm>
#include <cstdio>

namespace ghost::dmx {

using namespace ghostdmx;

namespace {

constexpr std::size_t kMaxListedProblems = 100;
constexpr std::size_t kSearchBytes = 1u << 20;           // read at a time
constexpr std::uint64_t kMarkEffortBytes = 8u << 10;     // to look at one mark, however little it says
constexpr std::uint64_t kSearchEffortBytes = 1ull << 30; // of a file

std::string seconds_text(microseconds time) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", std::chrono::duration<double>(time).count());
    return text;
}

} // namespace

bool GhostdmxReader::recognises(Bytes first_bytes) {
    return first_bytes.size() >= kMagic.size() &&
           std::equal(kMagic.begin(), kMagic.end(), first_bytes.begin());
}

std::vector<std::uint8_t> GhostdmxReader::bytes_at(std::uint64_t offset, std::size_t count) {
    const std::uint64_t left = source_.size() - std::min(offset, source_.size());
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min<std::uint64_t>(count, left)));
    bytes.resize(source_.read(offset, bytes));
    return bytes;
}

Result<GhostdmxReader> GhostdmxReader::open(ByteSource source, const std::string& name) {
    GhostdmxReader reader(std::move(source), name);
    const std::vector<std::uint8_t> first = reader.bytes_at(0, kHeaderBytes);
    if (!recognises(first)) return Error{"is no Ghostlight recording", name};
    auto header = decode_header(first);
    if (!header.ok()) return Error{header.error().what, name};
    reader.header_ = *header;
    if (!reader.find_index()) reader.scan();
    if (reader.index_.blocks.empty()) return Error{"no frame is in it", name};
    return reader;
}

bool GhostdmxReader::check_blocks() const {
    std::uint64_t least = kHeaderBytes;
    for (const BlockPlace& block : index_.blocks) {
        if (block.offset < least) return false;
        least = block.offset + kPieceHeaderBytes;
    }
    return least <= end_of_blocks_;
}

bool GhostdmxReader::read_index(std::uint64_t offset) {
    const auto piece = decode_piece(bytes_at(offset, kPieceHeaderBytes));
    if (!piece || piece->kind != PieceKind::index) return false;
    const std::vector<std::uint8_t> bytes = bytes_at(offset, kPieceHeaderBytes + piece->content_bytes);
    if (bytes.size() < kPieceHeaderBytes + piece->content_bytes || piece_crc(bytes, 0) != piece->crc)
        return false;
    const auto index = decode_index(Bytes(bytes).subspan(kPieceHeaderBytes));
    if (!index) return false;
    const Index before = std::move(index_);
    index_ = *index;
    end_of_blocks_ = offset;
    if (check_blocks()) return true;
    index_ = before;
    return false;
}

bool GhostdmxReader::find_index() {
    if (source_.size() < kHeaderBytes + kPieceHeaderBytes + kTrailerBytes) return false;
    const std::vector<std::uint8_t> trailer = bytes_at(source_.size() - kTrailerBytes, kTrailerBytes);
    if (trailer.size() < kTrailerBytes ||
        !std::equal(kTrailerMark.begin(), kTrailerMark.end(), trailer.begin() + 8))
        return false;
    ByteReader reader{Bytes(trailer)};
    return read_index(read_u64(reader));
}

bool GhostdmxReader::begins_block_at(std::uint64_t offset) {
    const auto piece = decode_piece(bytes_at(offset, kPieceHeaderBytes));
    if (!piece || piece->kind != PieceKind::begins_block) return false;
    const std::vector<std::uint8_t> bytes = bytes_at(offset, kPieceHeaderBytes + piece->content_bytes);
    return bytes.size() == kPieceHeaderBytes + piece->content_bytes && piece_crc(bytes, 0) == piece->crc;
}

// Of a whole piece; size() where there is none. What was read is kept for the next search: damage may stand
// behind every block.
std::uint64_t GhostdmxReader::next_block_after(std::uint64_t offset) {
    std::vector<std::uint8_t> mark;
    put_u32(mark, kMark);
    while (offset + kPieceHeaderBytes <= source_.size() && search_effort_ <= kSearchEffortBytes) {
        if (offset < window_at_ || offset + mark.size() > window_at_ + window_.size()) {
            window_ = bytes_at(offset, kSearchBytes);
            window_at_ = offset;
            search_effort_ += window_.size();
            if (window_.size() < mark.size()) break;
        }
        const auto from = window_.begin() + static_cast<std::ptrdiff_t>(offset - window_at_);
        const auto found = std::search(from, window_.end(), mark.begin(), mark.end());
        offset = window_at_ + static_cast<std::uint64_t>(found - window_.begin());
        if (found == window_.end()) {
            offset -= mark.size() - 1;
            continue;
        }
        const auto piece = decode_piece(bytes_at(offset, kPieceHeaderBytes));
        search_effort_ += kMarkEffortBytes + (piece ? piece->content_bytes : 0);
        if (begins_block_at(offset)) return offset;
        ++offset;
    }
    return source_.size();
}

void GhostdmxReader::scan() {
    index_ = {};
    std::uint64_t offset = kHeaderBytes;
    bool in_block = false;
    while (offset + kPieceHeaderBytes <= source_.size() && index_.blocks.size() < kMaxBlocks) {
        const std::vector<std::uint8_t> bytes = bytes_at(offset, kPieceHeaderBytes + kBlockHeadBytes);
        const auto piece = decode_piece(bytes);
        bool good = piece && offset + kPieceHeaderBytes + piece->content_bytes <= source_.size();
        if (good && piece->kind == PieceKind::index) {
            if (!read_index(offset)) break;
            problems_.push_back(
                {"its last bytes are damaged or cut off; nothing of the recording is lost", name_});
            return;
        }
        if (good && piece->kind == PieceKind::begins_block) {
            ByteReader head(Bytes(bytes).subspan(kPieceHeaderBytes));
            const std::uint64_t start = read_u64(head), first_frame = read_u64(head);
            good = start <= static_cast<std::uint64_t>(piece->end.count()) && first_frame >= index_.frames &&
                   first_frame < 1ull << 62 &&
                   microseconds(static_cast<std::int64_t>(start)) >= index_.duration;
            if (good)
                index_.blocks.push_back(
                    {offset, microseconds(static_cast<std::int64_t>(start)), first_frame});
        } else if (good) {
            good = in_block && piece->end >= index_.duration;
        }
        in_block = good;
        if (good) {
            index_.frames = index_.blocks.back().first_frame + piece->frames;
            index_.duration = piece->end;
            offset += kPieceHeaderBytes + piece->content_bytes;
            continue;
        }
        const std::uint64_t next = next_block_after(offset + 1);
        if (next == source_.size()) break;
        if (problems_.size() < kMaxListedProblems)
            problems_.push_back({"is damaged: " + std::to_string(next - offset) + " bytes, " +
                                     seconds_text(index_.duration) + " s and later, are left out",
                                 name_ + ", byte " + std::to_string(offset)});
        offset = next;
    }
    end_of_blocks_ = std::min(offset, source_.size());
    problems_.push_back({"was not finished (a crash, a cut, or it is still being written): it plays up to " +
                             seconds_text(index_.duration) + " s; " +
                             std::to_string(source_.size() - end_of_blocks_) +
                             " bytes behind that are no whole piece and left out",
                         name_});
}

GhostdmxReader::Block GhostdmxReader::block(std::size_t number) {
    const BlockPlace& place = index_.blocks.at(number);
    const bool last = number + 1 == index_.blocks.size();
    const std::uint64_t limit = last ? end_of_blocks_ : index_.blocks[number + 1].offset;
    const std::uint64_t frames_after = last ? index_.frames : index_.blocks[number + 1].first_frame;
    const microseconds block_end = last ? index_.duration : index_.blocks[number + 1].start;

    std::vector<std::uint8_t> unpacked;
    Unpacker unpacker;
    std::uint64_t offset = place.offset, frames = 0;
    std::uint32_t crc = 0;
    microseconds good_until = place.start;
    for (bool first = true; offset < limit; first = false) {
        const auto piece = decode_piece(bytes_at(offset, kPieceHeaderBytes));
        if (!piece || piece->kind != (first ? PieceKind::begins_block : PieceKind::goes_on)) break;
        const std::size_t size = kPieceHeaderBytes + piece->content_bytes;
        const std::vector<std::uint8_t> bytes = bytes_at(offset, size);
        if (bytes.size() < size || piece_crc(bytes, crc) != piece->crc) break;
        const Bytes content = Bytes(bytes).subspan(kPieceHeaderBytes + (first ? kBlockHeadBytes : 0));
        if (!unpacker.unpack(content, kMaxBlockBytes, unpacked)) break;
        crc = piece->crc;
        frames = piece->frames;
        good_until = piece->end;
        offset += size;
    }
    Block result;
    if (!unpacked.empty()) result.cursor = BlockCursor(std::move(unpacked), place);
    const std::uint64_t expected = frames_after - place.first_frame;
    if (frames < expected)
        result.damage =
            Error{"is damaged: from " + seconds_text(good_until) + " to " + seconds_text(block_end) +
                      " s the levels stand still, " + std::to_string(expected - frames) + " frames are lost",
                  name_ + ", byte " + std::to_string(offset)};
    return result;
}

} // namespace ghost::dmx
