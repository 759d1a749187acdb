// SPDX-License-Identifier: Apache-2.0
// Our reading of packets, of our own making and captured ones, against that of an independent decoder,
// Wireshark's tshark, field by field. tshark 4.0 shows neither the levels of ArtDmx as a field nor the inside
// of sync, discovery and time code; these have literal tests. It calls levels of less than a whole universe
// malformed after having read their header.
#include "dmx/merge/source_status.h"
#include "dmx/wire/packet.h"
#include "support/pcap_file.h"
#include "support/test_capture.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <sstream>

namespace ghost::dmx {
namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(GHOST_SOURCE_DIR) / "../shared/control/data";

enum Field {
    frame,
    port,
    cid,
    universe,
    priority,
    sequence,
    name,
    count,
    preview,
    terminated,
    levels,
    opcode,
    art_universe,
    art_sequence,
    art_physical,
    art_length,
    malformed
};
constexpr const char* kFields[] = {"frame.number",
                                   "udp.dstport",
                                   "acn.cid",
                                   "acn.dmx.universe",
                                   "acn.dmx.priority",
                                   "acn.dmx.seq_number",
                                   "acn.dmx.source_name",
                                   "acn.dmx.count",
                                   "acn.dmx.option_p",
                                   "acn.dmx.option_s",
                                   "acn.dmx.data",
                                   "artnet.header.opcode",
                                   "artnet.output.universe",
                                   "artnet.output.sequence",
                                   "artnet.output.physical",
                                   "artnet.output.length",
                                   "_ws.malformed"};
using Row = std::vector<std::string>;

// Rows by frame number.
std::map<int, Row> tshark(const fs::path& file) {
    std::string command = "tshark -r '" + file.string() +
                          "' --enable-protocol acn --enable-heuristic acn -o acn.dmx_enable:TRUE -T fields"
                          " -E separator=/t -E occurrence=a -E aggregator='~'";
    for (const char* field : kFields) command += std::string(" -e ") + field;
    std::map<int, Row> rows;
    std::FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
    if (!pipe) return rows;
    std::string text;
    char part[65536];
    for (std::size_t size; (size = std::fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, size);
    if (pclose(pipe) != 0) return {};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        Row row;
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, '\t');) row.push_back(field);
        row.resize(std::size(kFields));
        rows[std::atoi(row[frame].c_str())] = row;
    }
    return rows;
}

// "001-020: .. 0A FF ..." and so on, ".." for 0.
std::vector<int> levels_of(const std::string& text) {
    std::vector<int> result;
    std::istringstream rows(text);
    for (std::string row; std::getline(rows, row, '~');) {
        const std::size_t colon = row.find(": ");
        if (colon == std::string::npos) continue; // the heading
        std::istringstream values(row.substr(colon + 2));
        for (std::string value; values >> value;)
            if (value != "|")
                result.push_back(value == ".." ? 0
                                               : static_cast<int>(std::strtol(value.c_str(), nullptr, 16)));
    }
    return result;
}

std::string without(std::string text, char sign) {
    std::erase(text, sign);
    return text;
}

int truth(const std::string& text) {
    return text == "1" || text == "True" ? 1 : 0;
}

void compare_sacn(const Captured& captured, const Row& row) {
    const Parsed parsed = parse_sacn(captured.payload, captured.from);
    const Packet* packet = std::get_if<Packet>(&parsed);
    ASSERT_EQ(packet != nullptr, !row[universe].empty());
    if (!packet) { // of sync and discovery tshark reads at most who sends it
        const auto* sync = std::get_if<SyncPacket>(&parsed);
        const auto* list = std::get_if<DiscoveryPacket>(&parsed);
        ASSERT_TRUE(sync || list);
        if (!row[cid].empty()) {
            EXPECT_EQ(source_id(sync ? sync->source : list->source), without(row[cid], '-'));
        }
        return;
    }
    EXPECT_EQ(source_id(packet->source), without(row[cid], '-'));
    EXPECT_EQ(std::to_string(packet->universe), row[universe]);
    EXPECT_EQ(std::to_string(packet->priority), row[priority]);
    EXPECT_EQ(std::to_string(packet->sequence), row[sequence]);
    EXPECT_EQ(packet->source_name, row[name]);
    EXPECT_EQ(std::to_string(packet->slot_count + 1), row[count]);
    EXPECT_EQ(packet->source.preview ? 1 : 0, truth(row[preview]));
    EXPECT_EQ(packet->terminated ? 1 : 0, truth(row[terminated]));
    if (!row[malformed].empty()) return;
    const std::vector<int> theirs = levels_of(row[levels]);
    EXPECT_EQ(std::vector<int>(packet->slots.begin(), packet->slots.begin() + packet->slot_count), theirs);
}

void compare_artnet(const Captured& captured, const Row& row) {
    const Parsed parsed = parse_artnet(captured.payload, captured.from);
    const long code = std::strtol(row[opcode].c_str(), nullptr, 16);
    const Packet* packet = std::get_if<Packet>(&parsed);
    ASSERT_EQ(packet != nullptr, code == 0x5000) << row[opcode];
    if (packet) {
        EXPECT_EQ(std::to_string(packet->universe - 1), row[art_universe]);
        EXPECT_EQ(std::to_string(packet->sequence), row[art_sequence]);
        EXPECT_EQ(std::to_string(packet->source.id[4]), row[art_physical]);
        EXPECT_EQ(std::to_string(packet->slot_count), row[art_length]);
        return;
    }
    const std::map<long, Notice> notices = {{0x2000, Notice::poll},
                                            {0x2100, Notice::poll_reply},
                                            {0x5200, Notice::sync},
                                            {0x9700, Notice::timecode},
                                            {0x9900, Notice::trigger}};
    const auto expected = notices.find(code);
    EXPECT_EQ(notice_of(parsed), expected == notices.end() ? Notice::other : expected->second) << row[opcode];
}

class Tshark : public testing::Test {
protected:
    void SetUp() override {
        if (std::system("tshark --version >/dev/null 2>&1") != 0)
            GTEST_SKIP() << "tshark is not installed (Debian package tshark)";
    }

    void compare(const fs::path& file) {
        const std::map<int, Row> rows = tshark(file);
        ASSERT_FALSE(rows.empty()) << file;
        for (const Captured& captured : read_pcap(file)) {
            SCOPED_TRACE(file.filename().string() + ", frame " + std::to_string(captured.frame));
            const auto row = rows.find(captured.frame);
            ASSERT_NE(row, rows.end());
            EXPECT_EQ(std::to_string(captured.port), row->second[port]);
            if (captured.port == 5568) {
                compare_sacn(captured, row->second);
                ++sacn;
            } else if (captured.port == 6454) {
                compare_artnet(captured, row->second);
                ++artnet;
            }
            if (HasFailure()) return;
        }
    }

    int sacn = 0, artnet = 0;
};

TEST_F(Tshark, reads_what_we_send_as_we_do) {
    std::mt19937 random(7);
    std::vector<TestPacket> packets;
    const auto add = [&](const auto& payload, std::uint16_t to) {
        packets.push_back({std::chrono::milliseconds(packets.size()),
                           ethernet_of(ipv4_of(udp_of({payload.begin(), payload.end()}, to)))});
    };
    for (int k = 0; k < 200; ++k) {
        std::array<std::uint8_t, 16> cid{};
        for (std::uint8_t& byte : cid) byte = static_cast<std::uint8_t>(random());
        // Less than a whole universe tshark calls malformed.
        ByteList slots(k % 3 == 0 ? 1 + random() % 512 : 512);
        for (std::uint8_t& slot : slots) slot = static_cast<std::uint8_t>(random());
        const auto number = static_cast<std::uint16_t>(1 + random() % 32'000);
        const auto sequence = static_cast<std::uint8_t>(random());
        const auto options = static_cast<std::uint8_t>(random() % 4 << 6); // preview, stream terminated
        const SacnSource source{static_cast<std::uint8_t>(random() % 201), cid, "desk " + std::to_string(k)};
        add(build_sacn(number, Bytes(slots), sequence, source, {options}), 5568);
        add(build_artdmx(number, Bytes(slots), sequence), 6454);
        if (k % 10 != 0) continue;
        add(build_sacn_sync(number, sequence, cid), 5568);
        add(build_sacn_discovery(std::vector<std::uint16_t>{1, 2, number}, 0, 0, cid, "desk"), 5568);
        PollReply reply;
        reply.ports = {{.address = number}};
        reply.short_name = "Ghostlight";
        add(build_poll_reply(reply), 6454);
    }
    const TestFolder folder;
    const fs::path file = folder.path / "own.pcap";
    ASSERT_TRUE(write_file_atomic(file, Bytes(pcap_of(packets))).ok());
    ASSERT_NO_FATAL_FAILURE(compare(file));
    EXPECT_EQ(sacn, 240);
    EXPECT_EQ(artnet, 220);
}

TEST_F(Tshark, reads_every_captured_packet_as_we_do) {
    if (!fs::exists(kData)) GTEST_SKIP() << "no ../shared beside the checkout";
    for (const char* folder : {"captures", "pcap_from_hex"})
        for (const fs::directory_entry& entry : fs::directory_iterator(kData / folder)) {
            ASSERT_NO_FATAL_FAILURE(compare(entry.path()));
            if (HasFailure()) return;
        }
    std::printf("%d sACN and %d Art-Net packets compared\n", sacn, artnet);
    EXPECT_GT(sacn, 1500);
    EXPECT_GT(artnet, 1500);
}

} // namespace
} // namespace ghost::dmx
