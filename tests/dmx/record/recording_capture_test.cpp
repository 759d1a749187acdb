// SPDX-License-Identifier: Apache-2.0
// Captures as recordings: every container and link type, what is left out is counted, and the levels are
// those that a live receiver has.
#include "archives/gzip_file.h"
#include "disk/files.h"
#include "dmx/receive/receiver.h"
#include "dmx/send/sender.h"
#include "net/socket.h"
#include "support/test_capture.h"

#include "dmx/merge/merge.h"
#include "dmx/record/private/captured_udp.h"

#include <thread>
#include <zlib.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr std::chrono::nanoseconds kStart = 1'700'000'000s + 250ms;

ByteList sacn(std::uint16_t universe, std::uint8_t sequence, std::initializer_list<std::uint8_t> levels,
              std::uint8_t priority = 100, std::uint8_t id = 1) {
    const ByteList slots(levels);
    return build_sacn(universe, slots, sequence, {priority, {id}, "desk"});
}

// A look each 20 ms: slot 1 counts, slot 2 stands still.
std::vector<ByteList> counting(int count) {
    std::vector<ByteList> result;
    for (int i = 0; i < count; ++i)
        result.push_back(sacn(3, static_cast<std::uint8_t>(i), {static_cast<std::uint8_t>(i + 1), 77}));
    return result;
}

std::vector<TestPacket> each_20_ms(const std::vector<ByteList>& frames) {
    std::vector<TestPacket> result;
    for (std::size_t i = 0; i < frames.size(); ++i)
        result.push_back({kStart + static_cast<int>(i) * 20ms, frames[i]});
    return result;
}

std::vector<RecordedFrame> counted(int count) {
    std::vector<RecordedFrame> result;
    for (int i = 0; i < count; ++i) result.push_back(make_frame(i * 20ms, 3, {i + 1, 77}));
    return result;
}

class CaptureFiles : public testing::Test {
protected:
    TestFolder folder;

    ReadBack read(const ByteList& bytes, const CaptureOptions& options = {}) {
        return read_back(write_bytes(folder.path / "a.pcap", bytes), {options, {}});
    }
    void expect_counted(const ByteList& bytes, int count, const std::string& what) {
        const ReadBack back = read(bytes);
        ASSERT_TRUE(back.ok) << what << ": " << back.error;
        EXPECT_TRUE(back.end.problems.empty()) << what << ": " << back.end.problems.at(0).text();
        EXPECT_TRUE(same_frames(back.frames, counted(count))) << what;
        EXPECT_EQ(back.end.duration, (count - 1) * 20ms) << what;
        EXPECT_EQ(back.end.unix_time, std::chrono::floor<std::chrono::microseconds>(kStart)) << what;
    }
};

TEST_F(CaptureFiles, pcap_of_both_byte_orders_and_resolutions) {
    std::vector<ByteList> frames;
    for (const ByteList& payload : counting(20))
        frames.push_back(ethernet_of(ipv4_of(udp_of(payload, 5568))));
    for (const bool big : {false, true})
        for (const bool nano : {false, true})
            expect_counted(pcap_of(each_20_ms(frames), 1, big, nano), 20,
                           std::to_string(big) + std::to_string(nano));
}

TEST_F(CaptureFiles, pcapng_with_interfaces_of_different_clocks) {
    std::vector<ByteList> frames;
    for (const ByteList& payload : counting(20))
        frames.push_back(ethernet_of(ipv4_of(udp_of(payload, 5568))));
    for (const bool big : {false, true}) {
        const ReadBack back = read(pcapng_of(each_20_ms(frames), 1, big));
        ASSERT_TRUE(back.ok) << back.error;
        ASSERT_EQ(back.frames.size(), 20u);
        for (int i = 0; i < 20; ++i) { // 2^-20 s is nearly a microsecond
            EXPECT_LE(std::chrono::abs(back.frames[static_cast<std::size_t>(i)].time - i * 20ms), 1us) << i;
            EXPECT_EQ((*back.frames[static_cast<std::size_t>(i)].levels)[0], i + 1);
        }
    }
}

TEST_F(CaptureFiles, two_sections_after_each_other) {
    std::vector<ByteList> frames;
    for (const ByteList& payload : counting(20))
        frames.push_back(ethernet_of(ipv4_of(udp_of(payload, 5568))));
    const auto packets = each_20_ms(frames);
    ByteList both = pcapng_of({packets[0]}, 1, false);
    add_bytes(both, pcapng_of({packets[1]}, 1, true));
    expect_counted(both, 2, "sections");
}

TEST_F(CaptureFiles, every_link_type) {
    struct Link {
        const char* name;
        std::uint32_t type;
        std::function<ByteList(const ByteList& ip, bool v6)> wrap;
    };
    const auto before = [](std::size_t count, ByteList head) {
        return [count, head](const ByteList& ip, bool v6) {
            ByteList out(count, 0);
            std::copy(head.begin(), head.end(), out.begin());
            if (count == 16) add_number(out, 0, 0, true);
            const std::uint16_t type = v6 ? 0x86DD : 0x0800;
            if (count == 16)
                out[14] = static_cast<std::uint8_t>(type >> 8), out[15] = static_cast<std::uint8_t>(type);
            if (count == 20)
                out[0] = static_cast<std::uint8_t>(type >> 8), out[1] = static_cast<std::uint8_t>(type);
            add_bytes(out, ip);
            return out;
        };
    };
    const Link links[] = {
        {"Ethernet", 1, [](const ByteList& ip, bool) { return ethernet_of(ip); }},
        {"VLAN", 1, [](const ByteList& ip, bool) { return ethernet_of(ip, 1); }},
        {"VLAN in VLAN", 1, [](const ByteList& ip, bool) { return ethernet_of(ip, 2); }},
        {"Linux cooked", 113, before(16, {0, 0})},
        {"Linux cooked 2", 276, before(20, {})},
        {"loopback", 0, before(4, {2})},
        {"raw IP", 101, before(0, {})},
        {"raw IP of BSD", 12, before(0, {})},
        {"IPv4 or 6 only", 228, before(0, {})},
    };
    for (const Link& link : links)
        for (const bool v6 : {false, true}) {
            std::vector<ByteList> frames;
            for (const ByteList& payload : counting(3)) {
                const ByteList udp = udp_of(payload, 5568);
                frames.push_back(link.wrap(v6 ? ipv6_of(udp) : ipv4_of(udp), v6));
                if (link.type == 1) frames.back().resize(frames.back().size() + 9); // Ethernet's padding
            }
            expect_counted(pcap_of(each_20_ms(frames), link.type), 3,
                           link.name + std::string(v6 ? " v6" : " v4"));
        }
}

TEST_F(CaptureFiles, what_is_left_out_is_counted) {
    std::vector<TestPacket> packets;
    for (const ByteList& payload : counting(3)) {
        const ByteList udp = udp_of(payload, 5568);
        const auto time = kStart + static_cast<int>(packets.size()) * 20ms;
        packets.push_back({time, ethernet_of(ipv4_of(udp))});
        packets.push_back({time, ethernet_of(ipv4_of(udp, 0x2000))}); // more fragments follow
        packets.push_back({time, ethernet_of(ipv4_of(udp, 0x0010))}); // one that follows
        packets.push_back({time, ethernet_of(ipv4_of(udp)), 100});    // cut by the capture
        packets.push_back({time, ethernet_of(ipv4_of(udp, 0, 6))});   // TCP, not ours
        packets.push_back({time, ethernet_of(ipv4_of(udp_of(payload, 9)))});
    }
    packets.push_back({kStart, ethernet_of(ipv4_of(udp_of(ByteList(200, 1), 5568)))}); // late, and no sACN
    const ReadBack back = read(pcap_of(packets));
    ASSERT_TRUE(back.ok) << back.error;
    EXPECT_EQ(back.frames.size(), 3u);
    std::vector<std::string> said;
    for (const Error& problem : back.end.problems) said.push_back(problem.what);
    EXPECT_EQ(said,
              (std::vector<std::string>{
                  "6 fragments of IP packets are left out",
                  "3 packets were cut by the capture and are left out (capture with a snap length of 0)",
                  "1 packets on our ports were not understood: not_ours",
                  "1 packets are stamped earlier than the one before and count as of that moment"}));
}

TEST_F(CaptureFiles, other_ports_when_told_so) {
    std::vector<ByteList> frames;
    for (const ByteList& payload : counting(3)) frames.push_back(ethernet_of(ipv4_of(udp_of(payload, 7000))));
    const ByteList bytes = pcap_of(each_20_ms(frames));
    const ReadBack none = read(bytes);
    EXPECT_FALSE(none.ok);
    EXPECT_NE(none.error.find("no levels in 3 packets"), std::string::npos) << none.error;
    EXPECT_NE(none.error.find("3 went to other ports"), std::string::npos) << none.error;
    CaptureOptions options;
    options.sacn_port = 7000;
    EXPECT_EQ(read(bytes, options).frames.size(), 3u);
}

TEST_F(CaptureFiles, art_net_with_its_offset) {
    const ByteList slots = {9, 8};
    const ByteList frame = ethernet_of(ipv4_of(udp_of(build_artdmx(4, slots, 1), 6454)));
    CaptureOptions options;
    options.artnet_offset = 0;
    EXPECT_EQ(read(pcap_of({{kStart, frame}}), options).frames.at(0).universe, 4);
    EXPECT_EQ(read(pcap_of({{kStart, frame}})).frames.at(0).universe, 5);
}

TEST_F(CaptureFiles, a_silent_source_is_lost_at_the_captures_own_time) {
    std::vector<TestPacket> packets;
    packets.push_back({kStart, ethernet_of(ipv4_of(udp_of(sacn(1, 0, {10}, 100, 1), 5568)))});
    packets.push_back({kStart + 1s, ethernet_of(ipv4_of(udp_of(sacn(1, 0, {20}, 150, 2), 5568)))});
    for (int i = 1; i <= 3; ++i)
        packets.push_back(
            {kStart + i * 1500ms,
             ethernet_of(ipv4_of(udp_of(sacn(1, static_cast<std::uint8_t>(i), {10}, 100, 1), 5568)))});
    packets.push_back({kStart + 30h, ethernet_of(ipv4_of(udp_of({}, 9)))}); // the capture ran on
    const ReadBack back = read(pcap_of(packets));
    ASSERT_TRUE(back.ok) << back.error;
    // 150 wins until more than 2.5 s after its only packet, or until the other one is heard again; the last
    // one is lost as long after 4.5 s.
    ASSERT_EQ(back.frames.size(), 4u);
    const auto third = back.frames[2].time, last = back.frames[3].time;
    EXPECT_TRUE(same_frames(back.frames, {make_frame(0ms, 1, {10}), make_frame(1s, 1, {20}),
                                          make_frame(third, 1, {10}), make_frame(last, 1, {10}, true)}));
    EXPECT_TRUE(third > 3500ms && third <= 4600ms) << third.count();
    EXPECT_TRUE(last > 7s && last <= 7600ms) << last.count();
    EXPECT_EQ(back.end.duration, 30h);
}

TEST_F(CaptureFiles, that_stands_still_for_a_day_after_each_packet) {
    constexpr std::size_t kDays = 300;
    std::vector<TestPacket> packets;
    for (std::size_t i = 0; i < kDays; ++i)
        packets.push_back({kStart + i * 24h,
                           ethernet_of(ipv4_of(udp_of(sacn(1, static_cast<std::uint8_t>(i),
                                                           {static_cast<std::uint8_t>(i % 250 + 1)}, 100, 1),
                                                      5568)))});
    const ReadBack back = read(pcap_of(packets));
    ASSERT_TRUE(back.ok) << back.error;
    ASSERT_EQ(back.frames.size(), 2 * kDays - 1); // each look, and that it was lost
    for (std::size_t i = 0; i < back.frames.size(); ++i) {
        const auto since = back.frames[i].time - (i / 2) * 24h;
        EXPECT_EQ(back.frames[i].lost, i % 2 == 1) << i;
        EXPECT_TRUE(i % 2 == 0 ? since == 0s : since > 2500ms && since <= 2600ms)
            << i << ": " << since.count();
    }
}

TEST_F(CaptureFiles, every_truncation_plays_up_to_there_and_says_so) {
    std::vector<ByteList> frames;
    for (const ByteList& payload : counting(4)) frames.push_back(ethernet_of(ipv4_of(udp_of(payload, 5568))));
    for (const bool next_generation : {false, true}) {
        const ByteList whole = next_generation ? pcapng_of(each_20_ms(frames)) : pcap_of(each_20_ms(frames));
        const std::size_t least = read(whole).frames.size();
        ASSERT_EQ(least, 4u);
        std::size_t before = 0, quiet = 0;
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const ReadBack cut = read({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
            if (!cut.ok) continue;
            EXPECT_GE(cut.frames.size(), before);
            before = cut.frames.size();
            quiet += cut.end.problems.empty() ? 1 : 0;
        }
        EXPECT_EQ(before, 3u);
        EXPECT_EQ(quiet, 3u); // between packets nothing shows that more was to come
    }
}

TEST_F(CaptureFiles, hostile_lengths_end_the_reading) {
    ByteList pcap = pcap_of({{kStart, ByteList(60, 0)}});
    for (std::size_t i = 0; i < 4; ++i) pcap[24 + 8 + i] = 0xFF;
    EXPECT_NE(read(pcap).error.find("4294967295 bytes"), std::string::npos) << read(pcap).error;
    for (std::size_t i = 0; i < 4; ++i) pcap[24 + 8 + i] = i == 2 ? 0xFF : 0; // 16 MiB at most
    EXPECT_NE(read(pcap).error.find("ends inside of a packet"), std::string::npos) << read(pcap).error;
    ByteList next = pcapng_of({{kStart, ByteList(60, 0)}});
    for (std::size_t i = 0; i < 4; ++i) next[4 + i] = 0xFC;
    EXPECT_FALSE(read(next).ok);
}

const fs::path kControlData = fs::path(GHOST_SOURCE_DIR) / "../shared/control/data";

struct SentPacket {
    std::chrono::nanoseconds time;
    bool sacn;
    ByteList payload;
};

// All sACN and Art-Net of a capture, in order.
std::vector<SentPacket> packets_of(const fs::path& path) {
    std::vector<SentPacket> result;
    auto source = ByteSource::open(path);
    CaptureFile file(*source, path.string());
    while (const auto frame = file.next()) {
        const auto found = find_udp(*frame);
        const CapturedUdp* udp = std::get_if<CapturedUdp>(&found);
        if (!udp || (udp->to_port != 5568 && udp->to_port != 6454)) continue;
        result.push_back({frame->time, udp->to_port == 5568, {udp->payload.begin(), udp->payload.end()}});
    }
    return result;
}

// The captures' packets sent to a receiver of this machine give the levels that the capture plays at that
// moment. Not past a moment at which silence counts, as the packets are sent faster than they were captured.
TEST(RealCaptures, play_what_a_live_receiver_has) {
    if (!fs::exists(kControlData)) GTEST_SKIP() << kControlData << " is not there";
    struct Case {
        const char* name;
        double until_s;
        bool nobody_silent = true; // for as long as counts
    };
    for (const Case& one : {Case{"captures/qlcplus_4.12.6_movers_artnet0_sacn2_unicast.pcap", 4.0},
                            Case{"captures/qlcplus_4.12.6_artnet0_bcast_sacn2_mcast.pcap", 8.0},
                            Case{"captures/two_sources_sacn2_qlc100_ola150_killed.pcap", 7.0},
                            Case{"captures/ola_0.10.9_sacn1_5_artnet1_chase_terminate.pcap", 100.0, false}}) {
        auto recording = read_recording(kControlData / one.name);
        ASSERT_TRUE(recording.ok()) << recording.error().text();
        EXPECT_TRUE(recording->problems.empty()) << recording->problems.at(0).text();
        const auto began = recording->unix_time();
        Player player(std::move(*recording));

        ReceiverOptions options;
        options.interface = "127.0.0.1";
        options.sacn_port = 15568;
        options.artnet_port = 16454;
        options.answer_polls = false;
        options.sampling = options.priority_wait = 0ns; // as a capture is read
        const auto receiver = Receiver::start(options);
        ASSERT_TRUE(receiver.ok()) << receiver.error().text();
        auto socket = UdpSocket::open(0, 0, 1 << 20);
        ASSERT_TRUE(socket.ok());
        const auto packets = packets_of(kControlData / one.name);
        std::size_t sent = 0;
        std::uint64_t arrived = 0;
        Universes live;
        const auto receive_all = [&] {
            for (int patience = 0; patience < 4000 && arrived < sent; ++patience) {
                if (auto statistics = (*receiver)->take_statistics())
                    arrived = statistics->packets_sacn + statistics->packets_artnet;
                std::this_thread::sleep_for(5ms);
            }
            if (auto newest = (*receiver)->take()) live = std::move(*newest);
        };
        double last_s = 0.0;
        for (const SentPacket& packet : packets) {
            const double t_s = std::chrono::duration<double>(packet.time - began).count();
            if (t_s > one.until_s) break;
            last_s = std::max(last_s, t_s);
            ASSERT_TRUE((*socket)->send(packet.payload, 0x7F000001, packet.sacn ? 15568 : 16454).ok());
            if (++sent % 100 == 0) receive_all(); // so that no buffer overflows
        }
        receive_all();
        ASSERT_EQ(arrived, sent) << one.name;
        ASSERT_GT(sent, 200u) << one.name;
        const Universes played = player.at(last_s);
        ASSERT_EQ(played.list.size(), live.list.size()) << one.name;
        for (std::size_t i = 0; i < played.list.size(); ++i) {
            EXPECT_EQ(played.list[i].number, live.list[i].number) << one.name;
            EXPECT_EQ(*played.list[i].levels, *live.list[i].levels)
                << one.name << " " << played.list[i].number;
            EXPECT_TRUE(!one.nobody_silent || played.list[i].lost == live.list[i].lost)
                << one.name << " " << played.list[i].number;
        }
    }
}

class GzipCaptures : public CaptureFiles {
protected:
    static std::vector<ByteList> on_the_wire(int count) {
        std::vector<ByteList> frames;
        for (const ByteList& payload : counting(count))
            frames.push_back(ethernet_of(ipv4_of(udp_of(payload, 5568))));
        return frames;
    }
    // gzip of the system's zlib; level 0 to 9.
    static ByteList packed(const ByteList& bytes, int level = 6) {
        z_stream stream{};
        EXPECT_EQ(deflateInit2(&stream, level, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
        ByteList out(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64);
        stream.next_in = const_cast<Bytef*>(bytes.data());
        stream.avail_in = static_cast<uInt>(bytes.size());
        stream.next_out = out.data();
        stream.avail_out = static_cast<uInt>(out.size());
        EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
        out.resize(stream.total_out);
        deflateEnd(&stream);
        return out;
    }
};

TEST_F(GzipCaptures, are_read_as_what_they_hold) {
    const ByteList plain = pcap_of(each_20_ms(on_the_wire(200)));
    for (const int level : {0, 1, 9}) expect_counted(packed(plain, level), 200, "pcap.gz");
    const ReadBack next = read(packed(pcapng_of(each_20_ms(on_the_wire(200)))));
    ASSERT_TRUE(next.ok) << next.error;
    EXPECT_EQ(next.frames.size(), 200u);
    // Two gzip files one behind the other are one (RFC 1952), as pigz and cat make them.
    ByteList two = packed(ByteList(plain.begin(), plain.begin() + 1000));
    add_bytes(two, packed(ByteList(plain.begin() + 1000, plain.end())));
    expect_counted(two, 200, "two members");
}

TEST_F(GzipCaptures, that_end_early_or_are_damaged_say_so) {
    const ByteList whole = packed(pcap_of(each_20_ms(on_the_wire(2000))));
    const ReadBack cut =
        read(ByteList(whole.begin(), whole.end() - static_cast<std::ptrdiff_t>(whole.size() / 2)));
    ASSERT_TRUE(cut.ok) << cut.error;
    EXPECT_GT(cut.frames.size(), 100u);
    EXPECT_LT(cut.frames.size(), 2000u);
    std::string all;
    for (const Error& problem : cut.end.problems) all += problem.text() + "\n";
    EXPECT_NE(all.find("gzip file ends early"), std::string::npos) << all;
    ByteList damaged = whole;
    for (std::size_t i = damaged.size() / 2; i < damaged.size() / 2 + 40; ++i) damaged[i] ^= 0x5A;
    (void)read(damaged);
    for (std::size_t size = 0; size < 64; ++size)
        (void)read(ByteList(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
    const ReadBack other = read(packed(ByteList(100, 'x')));
    EXPECT_FALSE(other.ok);
    EXPECT_NE(other.error.find("gunzip"), std::string::npos) << other.error;
}

TEST_F(GzipCaptures, are_read_up_to_their_limit) {
    constexpr std::uint64_t kMost = 1'000'000;
    const auto unpacked = [&](std::size_t bytes) {
        const auto file = write_bytes(folder.path / "a.gz", packed(ByteList(bytes, 'x')));
        GzipFile gzip(std::ifstream(file, std::ios::binary), fs::file_size(file), kMost);
        ByteList read(bytes);
        read.resize(gzip.read(0, read));
        return std::pair(read.size(), gzip.problem().value_or(""));
    };
    EXPECT_EQ(unpacked(kMost), std::pair(std::size_t{kMost}, std::string()));
    for (const std::size_t bytes : {std::size_t{kMost + 1}, std::size_t{3 * kMost}})
        EXPECT_EQ(unpacked(bytes),
                  std::pair(std::size_t{kMost}, std::string("the gzip file unpacks to more than the 1000000 "
                                                            "bytes that are read")));
}

// At every packet, against the merge fed by hand.
TEST(RealCaptures, play_every_change) {
    if (!fs::exists(kControlData)) GTEST_SKIP() << kControlData << " is not there";
    std::size_t looks = 0;
    for (const char* name : {"captures/two_sources_sacn2_qlc100_ola150_killed.pcap",
                             "captures/ola_0.10.9_sacn1_5_artnet1_chase_terminate.pcap"}) {
        auto recording = read_recording(kControlData / name);
        ASSERT_TRUE(recording.ok()) << recording.error().text();
        const auto began = recording->unix_time();
        Player player(std::move(*recording));
        Merge merge;
        const auto packets = packets_of(kControlData / name);
        for (std::size_t i = 0; i < packets.size(); ++i) {
            const SentPacket& packet = packets[i];
            const Parsed parsed =
                packet.sacn ? parse_sacn(packet.payload, 1) : parse_artnet(packet.payload, 1);
            if (const Packet* levels = std::get_if<Packet>(&parsed)) merge.feed(*levels, packet.time);
            const double t_s = std::chrono::duration<double>(packet.time - began).count();
            if (t_s < 0 || (i + 1 < packets.size() && packets[i + 1].time - packet.time < 2us)) continue;
            if (t_s > 9) break; // there the killed one is given up, at a time of the receiver's own
            const Universes& expected = merge.universes();
            const Universes played = player.at(t_s);
            ASSERT_EQ(played.list.size(), expected.list.size());
            for (std::size_t k = 0; k < played.list.size(); ++k)
                ASSERT_EQ(*played.list[k].levels, *expected.list[k].levels) << name << " at " << t_s;
            ++looks;
        }
    }
    EXPECT_GT(looks, 500u);
}

} // namespace
} // namespace ghost::dmx
