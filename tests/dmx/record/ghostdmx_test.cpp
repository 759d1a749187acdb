// SPDX-License-Identifier: Apache-2.0
// The .ghostdmx format: lossless for any frames, and what cuts, flipped bits and hostile bytes do to it.
#include "disk/crc32.h"
#include "support/must.h"
#include "support/test_recording.h"

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

TEST(Ghostdmx, any_frames_come_back_as_they_were) {
    const TestFolder folder;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const auto frames = random_frames(seed, 1 + seed * 60, 1 + seed % 7);
        const auto duration = frames.back().time + 17us;
        const auto bytes = pack(frames, duration, seed % 4 * 5);
        const ReadBack back = read_back(write_bytes(folder.path / "a.ghostdmx", bytes));
        ASSERT_TRUE(back.ok) << back.error;
        EXPECT_TRUE(back.end.problems.empty()) << back.end.problems.at(0).text();
        ASSERT_TRUE(same_frames(back.frames, frames)) << "seed " << seed;
        EXPECT_EQ(back.end.duration, duration);
        EXPECT_EQ(back.end.unix_time, 1'800'000'000s);
    }
}

TEST(Ghostdmx, the_bytes_are_those_of_the_description) {
    const auto bytes = pack({make_frame(0us, 1, {255, 0, 7})}, 1s);
    // docs/reference/recording.md: header, one piece, index, trailer.
    const std::vector<std::uint8_t> start = {0x89, 'G', 'D', 'M', 'X', '\r', '\n', 0x1A, 1, 0, 0, 0};
    ASSERT_GT(bytes.size(), 24u + 28 + 16 + 28 + 16);
    EXPECT_TRUE(std::equal(start.begin(), start.end(), bytes.begin()));
    const std::vector<std::uint8_t> mark = {'G', 'D', 'M', 'x'},
                                    end = {'G', 'D', 'M', 'X', 'e', 'n', 'd', '\n'};
    EXPECT_TRUE(std::equal(mark.begin(), mark.end(), bytes.begin() + 24));
    EXPECT_TRUE(std::equal(end.begin(), end.end(), bytes.end() - 8));
    std::vector<std::uint8_t> unpacked;
    ByteReader piece(Bytes(bytes).subspan(24));
    piece.skip(12);
    const std::uint32_t content = piece.u32_le();
    ASSERT_TRUE(Unpacker().unpack(Bytes(bytes).subspan(24 + 28 + 16, content - 16), 1000, unpacked));
    // No universe in the key; a frame after 0 us, universe 1 with a new slot count of 3, two runs... in one,
    // as a gap of one slot is cheaper inside.
    EXPECT_EQ(unpacked, (std::vector<std::uint8_t>{0, 0, 1 << 2 | 2, 3, 1, 0, 3, 255, 0, 7}));
}

// What plays of a file, whatever was done to it.
struct Damaged {
    std::vector<RecordedFrame> frames;
    std::size_t problems = 0;
    bool ok = false;
};

Damaged play(const std::vector<std::uint8_t>& bytes, const std::filesystem::path& file) {
    const ReadBack back = read_back(write_bytes(file, bytes));
    return {back.frames, back.end.problems.size(), back.ok};
}

bool begins_with(const std::vector<RecordedFrame>& whole, const std::vector<RecordedFrame>& part) {
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin(), same_frame);
}

TEST(Ghostdmx, every_truncation_plays_up_to_there_and_says_so) {
    const TestFolder folder;
    const auto frames = random_frames(3, 60, 3, 12);
    const auto bytes = pack(frames, frames.back().time + 1s, 7);
    std::size_t played_before = 0, lengths = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const Damaged cut = play({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)},
                                 folder.path / "cut.ghostdmx");
        if (!cut.ok) {
            EXPECT_EQ(played_before, 0u) << size;
            continue;
        }
        EXPECT_GT(cut.problems, 0u) << size;
        EXPECT_TRUE(begins_with(frames, cut.frames)) << size;
        EXPECT_GE(cut.frames.size(), played_before) << size;
        if (cut.frames.size() > played_before) ++lengths;
        played_before = cut.frames.size();
    }
    EXPECT_EQ(played_before, frames.size()); // only index and trailer were missing
    EXPECT_GE(lengths, 9u);                  // flushes of 7 frames, blocks, and the rest
}

TEST(Ghostdmx, what_a_cut_lost_is_said) {
    const TestFolder folder;
    const auto bytes = pack({make_frame(0us, 1, {1}), make_frame(2s, 1, {2}), make_frame(5s, 1, {3})}, 9s, 1);
    const auto file = write_bytes(folder.path / "x.ghostdmx", Bytes(bytes).first(bytes.size() - 50));
    const auto recording = read_recording(file);
    ASSERT_TRUE(recording.ok());
    ASSERT_EQ(recording->problems.size(), 1u);
    EXPECT_NE(recording->problems[0].what.find(
                  "plays up to 9.000 s; 3 bytes behind that are no whole piece and left out"),
              std::string::npos)
        << recording->problems[0].what;
}

TEST(Ghostdmx, a_flipped_bit_is_noticed_and_costs_a_part) {
    const TestFolder folder;
    const auto frames = random_frames(4, 40, 2, 12);
    const auto bytes = pack(frames, frames.back().time + 1s, 6);
    std::size_t complete = 0, flips = 0;
    for (std::size_t byte = 0; byte < bytes.size(); ++byte) {
        for (const int bit : {0, 3, 7}) {
            auto flipped = bytes;
            flipped[byte] = static_cast<std::uint8_t>(flipped[byte] ^ (1 << bit));
            const Damaged played = play(flipped, folder.path / "flip.ghostdmx");
            ++flips;
            const bool header = byte < ghostdmx::kHeaderBytes;
            if (played.ok && played.problems == 0) {
                ++complete;
                EXPECT_TRUE(header) << byte; // costs the date at most
                EXPECT_TRUE(same_frames(played.frames, frames)) << byte;
            }
            // One block: nothing after the damage, and nothing that was not there.
            EXPECT_TRUE(!played.ok || begins_with(frames, played.frames)) << byte << " bit " << bit;
        }
    }
    EXPECT_LT(complete, 24u * 3);
    EXPECT_GT(flips, 1500u);
}

TEST(Ghostdmx, damage_in_one_block_spares_the_others) {
    const TestFolder folder;
    const auto frames = random_frames(5, 9000, 12); // several blocks
    const auto bytes = pack(frames, frames.back().time + 1s, 200);
    auto whole = read_recording(write_bytes(folder.path / "a.ghostdmx", bytes));
    ASSERT_TRUE(whole.ok());
    ASSERT_GE(whole->blocks(), 5u);
    const ghostdmx::BlockPlace second = whole->block_place(1), third = whole->block_place(2);
    auto broken = bytes;
    broken[static_cast<std::size_t>(second.offset + (third.offset - second.offset) / 2)] ^= 0x10;
    // With its index, and with neither index nor trailer.
    for (const std::size_t cut : {std::size_t{0}, std::size_t{40}}) {
        auto recording =
            read_recording(write_bytes(folder.path / "b.ghostdmx", Bytes(broken).first(broken.size() - cut)));
        ASSERT_TRUE(recording.ok());
        EXPECT_EQ(recording->problems.size(), cut ? 1u : 0u);
        Player good(std::move(*read_recording(folder.path / "a.ghostdmx"))), bad(std::move(*recording));
        const auto seconds = [](std::chrono::microseconds t) {
            return std::chrono::duration<double>(t).count();
        };
        const double lost_from_s = seconds(second.start), lost_to_s = seconds(third.start);
        EXPECT_TRUE(same_look(bad.at(lost_from_s - 0.001), good.at(lost_from_s - 0.001)));
        EXPECT_TRUE(bad.take_damage().empty());
        EXPECT_TRUE(same_look(bad.at(lost_to_s), good.at(lost_to_s)));
        EXPECT_TRUE(same_look(bad.at(good.duration_s()), good.at(good.duration_s())));
        EXPECT_TRUE(bad.take_damage().empty());
        const Universes still = bad.at(lost_to_s - 0.001);
        const auto damage = bad.take_damage();
        ASSERT_EQ(damage.size(), 1u);
        EXPECT_NE(damage[0].what.find("the levels stand still"), std::string::npos) << damage[0].what;
        EXPECT_NE(damage[0].what.find(" frames are lost"), std::string::npos);
        EXPECT_FALSE(same_look(still, good.at(lost_to_s - 0.001)));
        EXPECT_TRUE(same_look(bad.at(lost_to_s - 0.001), still)); // in any order
        EXPECT_TRUE(bad.take_damage().empty());                   // said once
    }
}

TEST(Ghostdmx, a_block_that_is_gone_is_skipped_without_an_index) {
    const TestFolder folder;
    const auto frames = random_frames(6, 9000, 12);
    const auto bytes = pack(frames, frames.back().time + 1s);
    auto whole = read_recording(write_bytes(folder.path / "a.ghostdmx", bytes));
    ASSERT_TRUE(whole.ok());
    const ghostdmx::BlockPlace second = whole->block_place(1), third = whole->block_place(2);
    auto broken = bytes;
    std::fill(broken.begin() + static_cast<std::ptrdiff_t>(second.offset),
              broken.begin() + static_cast<std::ptrdiff_t>(third.offset) - 5, std::uint8_t{'G'});
    broken.resize(broken.size() - 1);
    const auto recording = read_recording(write_bytes(folder.path / "b.ghostdmx", broken));
    ASSERT_TRUE(recording.ok());
    EXPECT_EQ(recording->problems.size(), 2u);
    Player good(std::move(*whole)), bad(std::move(*read_recording(folder.path / "b.ghostdmx")));
    const double after_s = std::chrono::duration<double>(third.start).count();
    EXPECT_TRUE(same_look(bad.at(after_s), good.at(after_s)));
    EXPECT_TRUE(same_look(bad.at(0.0), good.at(0.0)));
}

// Whole blocks of which each is out of order: the search for the next good one goes on where it stood.
TEST(Ghostdmx, a_file_of_one_block_over_and_over_is_searched_once) {
    const TestFolder folder;
    const auto one = pack({make_frame(0us, 1, {255, 0, 7})}, 1s);
    ByteReader piece(Bytes(one).subspan(ghostdmx::kHeaderBytes));
    piece.skip(12);
    const std::size_t block_bytes = ghostdmx::kPieceHeaderBytes + piece.u32_le();
    std::vector<std::uint8_t> bytes(one.begin(), one.begin() + ghostdmx::kHeaderBytes);
    const auto block = Bytes(one).subspan(ghostdmx::kHeaderBytes, block_bytes);
    while (bytes.size() < (8u << 20)) bytes.insert(bytes.end(), block.begin(), block.end());
    const auto begun = std::chrono::steady_clock::now();
    const auto recording = read_recording(write_bytes(folder.path / "again.ghostdmx", bytes));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    ASSERT_TRUE(recording.ok()) << recording.error().text();
    EXPECT_FALSE(recording->problems.empty());
    EXPECT_LT(took.count(), 5.0);
}

// Each mark that begins nothing costs as much as 8 KiB that are read.
TEST(Ghostdmx, the_search_for_the_next_good_block_has_an_end) {
    const TestFolder folder;
    const auto frames = random_frames(6, 9000, 12);
    const auto whole = pack(frames, frames.back().time + 1s);
    auto recording = read_recording(write_bytes(folder.path / "whole.ghostdmx", whole));
    ASSERT_TRUE(recording.ok());
    const auto second = static_cast<std::ptrdiff_t>(recording->block_place(1).offset);
    const auto blocks_behind = [&](std::size_t marks) {
        std::vector<std::uint8_t> bytes(whole.begin(), whole.begin() + second);
        for (std::size_t k = 0; k < marks; ++k)
            bytes.insert(bytes.end(), whole.begin() + ghostdmx::kHeaderBytes,
                         whole.begin() + ghostdmx::kHeaderBytes + 4);
        bytes.insert(bytes.end(), whole.begin() + second, whole.end() - 1); // without its index
        return must(read_recording(write_bytes(folder.path / "marks.ghostdmx", bytes))).blocks();
    };
    EXPECT_EQ(blocks_behind(1000), recording->blocks());
    EXPECT_EQ(blocks_behind((1u << 30) / (8u << 10) + 1000), 1u);
}

TEST(Ghostdmx, what_is_none_is_refused_with_a_reason) {
    const TestFolder folder;
    const auto error_of = [&](const std::vector<std::uint8_t>& bytes) {
        const auto result = read_recording(write_bytes(folder.path / "x.ghostdmx", bytes));
        return result.ok() ? std::string() : result.error().what;
    };
    const auto bytes = pack({make_frame(0us, 1, {1})}, 1s);
    EXPECT_NE(error_of({}).find("expected one of Ghostlight"), std::string::npos);
    EXPECT_NE(error_of({bytes.begin(), bytes.begin() + 12}).find("header"), std::string::npos);
    EXPECT_NE(error_of({bytes.begin(), bytes.begin() + 24}).find("no frame"), std::string::npos);
    EXPECT_NE(error_of(pack({}, 1s)).find("no frame"), std::string::npos);
    ghostdmx::Header header;
    auto newer = ghostdmx::encode(header);
    newer[8] = 2;
    newer.resize(20);
    ghostdmx::put_u32(newer, crc32(newer));
    EXPECT_NE(error_of(newer).find("version 2"), std::string::npos) << error_of(newer);
}

TEST(Ghostdmx, limits_are_kept_while_writing) {
    GhostdmxWriter writer([](Bytes) -> Result<void> { return {}; });
    for (std::uint16_t universe = 1; universe <= kMaxRecordedUniverses; ++universe)
        ASSERT_TRUE(writer.append(make_frame(0us, universe, {1})).ok());
    const auto more = writer.append(make_frame(0us, 60000, {1}));
    ASSERT_FALSE(more.ok());
    EXPECT_EQ(more.error().what, "more than 4096 universes");
    EXPECT_TRUE(writer.append(make_frame(kLongestRecording, 1, {2})).ok());
    EXPECT_FALSE(writer.append(make_frame(kLongestRecording + 1us, 1, {3})).ok());
}

TEST(Ghostdmx, an_error_of_the_disk_goes_up) {
    GhostdmxWriter writer([](Bytes) -> Result<void> { return Error{"disk full", "x"}; });
    EXPECT_FALSE(writer.append(make_frame(0us, 1, {1})).ok());
}

TEST(Ghostdmx, quiet_hours_are_in_the_file_before_it_ends) {
    std::vector<std::uint8_t> bytes;
    GhostdmxWriter writer([&](Bytes more) -> Result<void> {
        bytes.insert(bytes.end(), more.begin(), more.end());
        return {};
    });
    ASSERT_TRUE(writer.append(make_frame(0us, 1, {1})).ok());
    for (auto now = 0us; now < 3600s; now += 100000us) ASSERT_TRUE(writer.flush(now).ok());
    const TestFolder folder;
    const auto recording = read_recording(write_bytes(folder.path / "a.ghostdmx", bytes)); // killed here
    ASSERT_TRUE(recording.ok());
    EXPECT_GE(recording->duration(), 3589s);
    EXPECT_LT(bytes.size(), 20000u);
}

TEST(Unpacker, stops_at_its_limit_and_at_garbage) {
    const std::vector<std::uint8_t> zeros(1 << 20, 0);
    std::vector<std::uint8_t> packed, out;
    Packer().pack(zeros, Packer::Then::end, packed);
    EXPECT_LT(packed.size(), 1000u);
    EXPECT_FALSE(Unpacker().unpack(packed, 1 << 19, out));
    EXPECT_TRUE(out.empty());
    EXPECT_TRUE(Unpacker().unpack(packed, 2 << 20, out));
    EXPECT_EQ(out, zeros);
    EXPECT_FALSE(Unpacker().unpack(zeros, 1 << 20, out));
}

TEST(Ghostdmx, a_piece_is_as_long_as_its_limit_and_no_longer) {
    using namespace ghostdmx;
    const auto head_of = [](PieceKind kind, std::uint32_t content_bytes) {
        PieceHeader header;
        header.kind = kind;
        auto bytes = encode(header, {}, 0);
        for (std::size_t i = 0; i < 4; ++i) // behind mark, checksum and kind
            bytes[12 + i] = static_cast<std::uint8_t>(content_bytes >> (8 * i));
        return decode_piece(bytes);
    };
    for (const PieceKind kind : {PieceKind::begins_block, PieceKind::goes_on}) {
        const auto longest = head_of(kind, kMaxPieceBytes);
        ASSERT_TRUE(longest);
        EXPECT_EQ(longest->content_bytes, kMaxPieceBytes);
        EXPECT_FALSE(head_of(kind, kMaxPieceBytes + 1));
    }
    EXPECT_TRUE(head_of(PieceKind::index, kMaxIndexBytes));
    EXPECT_FALSE(head_of(PieceKind::index, kMaxIndexBytes + 1));
}

TEST(Ghostdmx, an_index_has_four_million_blocks_and_no_more) {
    ghostdmx::Index index;
    index.duration = 1s;
    for (std::size_t i = 0; i < ghostdmx::kMaxBlocks; ++i) index.blocks.push_back({i + 1, 0us, 0});
    auto bytes = ghostdmx::encode(index);
    EXPECT_LE(bytes.size(), ghostdmx::kMaxIndexBytes) << "what is written can be read";
    const auto back = ghostdmx::decode_index(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->blocks.size(), ghostdmx::kMaxBlocks);
    EXPECT_EQ(back->blocks.back().offset, ghostdmx::kMaxBlocks);
    index.blocks.push_back({ghostdmx::kMaxBlocks + 1, 0us, 0});
    EXPECT_FALSE(ghostdmx::decode_index(ghostdmx::encode(index)));
}

} // namespace
} // namespace ghost::dmx
