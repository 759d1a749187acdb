// SPDX-License-Identifier: Apache-2.0
// The receiver under the load it is made for: 512 universes at 44 Hz from two desks, each refresh in one
// burst. Judged is what the receiver does, not the machine: every packet must be accounted for and cost
// little processor time, always; one that the kernel dropped is our fault unless the receiver's thread was
// kept waiting for a processor meanwhile.
#include "dmx/receive/receiver.h"
#include "dmx/send/sender.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>
#include <unistd.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool kInstrumented = true;
constexpr std::uint16_t kUniverses = 64; // a packet takes ten times as long
#else
constexpr bool kInstrumented = false;
constexpr std::uint16_t kUniverses = 512;
#endif
constexpr int kRefreshes = 88;
constexpr auto kDeskPeriod = 22727us;
constexpr double kSeconds = 2.0;
// A socket's buffer of 16 MiB holds 580 ms of two desks. So without a fault of ours a drop takes a time in
// which the receiver was ready to run and had no processor for most of that.
constexpr auto kStarving = 800ms;
constexpr double kStarved_ms = 500;

std::set<int> threads() {
    std::set<int> result;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task"))
        result.insert(std::stoi(entry.path().filename().string()));
    return result;
}

// What the kernel says of a thread. A kernel that does not count excuses nothing: zeros.
struct Scheduled {
    Clock::time_point time;
    double ran_ms = 0;
    double waited_ms = 0; // ready to run, without a processor
};

Scheduled scheduled(int thread) {
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
    std::uint64_t ran_ns = 0, waited_ns = 0;
    file >> ran_ns >> waited_ns;
    return {Clock::now(), static_cast<double>(ran_ns) * 1e-6, static_cast<double>(waited_ns) * 1e-6};
}

// The longest that the thread waited for a processor within any kStarving.
double most_waited_ms(const std::vector<Scheduled>& samples) {
    double most = 0;
    for (std::size_t first = 0, last = 0; last < samples.size(); ++last) {
        while (samples[last].time - samples[first].time > kStarving) ++first;
        most = std::max(most, samples[last].waited_ms - samples[first].waited_ms);
    }
    return most;
}

Universes all_universes() {
    Universes all;
    for (std::uint16_t universe = 1; universe <= kUniverses; ++universe)
        all.at(universe).levels = std::make_shared<Levels>();
    return all;
}

// The time of sending travels in the first slots of every universe, each desk's in its own eight.
void send_refresh(Sender& out, Universes& all, std::size_t first_slot) {
    const std::int64_t sent = Clock::now().time_since_epoch().count();
    auto levels = std::make_shared<Levels>();
    for (std::size_t byte = 0; byte < 8; ++byte)
        (*levels)[byte + first_slot] = static_cast<std::uint8_t>(sent >> (8 * byte));
    for (Universe& universe : all.list) universe.levels = levels;
    EXPECT_TRUE(out.send(all).ok());
}

// A desk that is late goes on from there: real ones do not make up for it with several refreshes at once.
void run_desk(Sender& out, std::size_t first_slot) {
    Universes all = all_universes();
    auto next = Clock::now();
    for (int i = 0; i < kRefreshes; ++i) {
        std::this_thread::sleep_until(next);
        next = std::max(next, Clock::now() - 1ms) + kDeskPeriod;
        send_refresh(out, all, first_slot);
    }
}

struct Watched {
    std::vector<double> latency_ms; // first byte sent by the sACN desk until its last universe can be read
    std::vector<Scheduled> thread;
};

Watched watch(Receiver& receiver, int thread, const std::atomic<int>& running) {
    Watched result;
    std::int64_t last = 0;
    for (result.thread.push_back(scheduled(thread)); running > 0; std::this_thread::sleep_for(200us)) {
        if (Clock::now() > result.thread.back().time + 10ms) result.thread.push_back(scheduled(thread));
        const auto levels = receiver.take();
        if (!levels) continue;
        std::int64_t sent = 0;
        for (int byte = 0; byte < 8; ++byte)
            sent |= static_cast<std::int64_t>(levels->level(kUniverses, byte + 1)) << (8 * byte);
        const std::int64_t now = Clock::now().time_since_epoch().count();
        if (sent != 0 && sent != last) result.latency_ms.push_back(static_cast<double>(now - sent) * 1e-6);
        last = sent;
    }
    result.thread.push_back(scheduled(thread));
    std::sort(result.latency_ms.begin(), result.latency_ms.end());
    return result;
}

// The last statistics, once no packet has come for half a second.
Statistics statistics_when_quiet(Receiver& receiver) {
    Statistics last;
    for (auto quiet = Clock::now(); Clock::now() < quiet + 500ms; std::this_thread::sleep_for(10ms)) {
        const auto newest = receiver.take_statistics();
        if (!newest) continue;
        if (newest->packets_sacn + newest->packets_artnet != last.packets_sacn + last.packets_artnet)
            quiet = Clock::now();
        last = *newest;
    }
    return last;
}

// Ports that differ between test processes running at the same time.
ReceiverOptions on_loopback(std::uint16_t universes) {
    ReceiverOptions options;
    options.interface = "127.0.0.1";
    options.answer_polls = false;
    options.sampling = 0s;
    options.sacn_port = static_cast<std::uint16_t>(20000 + (getpid() % 10000) * 2);
    options.artnet_port = static_cast<std::uint16_t>(options.sacn_port + 1);
    for (std::uint16_t universe = 1; universe <= universes; ++universe) options.universes.push_back(universe);
    return options;
}

// One run of two seconds. True: judged; false: packets were dropped while the receiver had no processor.
bool judge_load() {
    const ReceiverOptions options = on_loopback(kUniverses);
    const std::set<int> before = threads();
    auto started = Receiver::start(options);
    if (!started.ok()) {
        ADD_FAILURE() << started.error().text();
        return true;
    }
    Receiver& receiver = **started;
    std::vector<int> ours;
    for (const int one : threads())
        if (!before.contains(one)) ours.push_back(one);
    EXPECT_EQ(ours.size(), 2u); // the watch of the ports, then the receiver's own

    std::vector<Sender> desks;
    for (const Protocol protocol : {Protocol::sacn, Protocol::artnet}) {
        SenderOptions wanted;
        wanted.protocol = protocol;
        wanted.destination = wanted.interface = "127.0.0.1";
        wanted.port = protocol == Protocol::sacn ? options.sacn_port : options.artnet_port;
        desks.push_back(must(Sender::open(wanted)));
    }
    std::atomic<int> running{2};
    const auto start = Clock::now();
    std::vector<std::thread> work;
    for (std::size_t i = 0; i < 2; ++i)
        work.emplace_back([&, i] {
            run_desk(desks[i], 8 * i);
            --running;
        });
    const Watched watched = watch(receiver, ours.back(), running);
    for (std::thread& one : work) one.join();
    const double took_s = std::chrono::duration<double>(Clock::now() - start).count();

    // Gaps in the sequence show with the next packet only.
    (void)statistics_when_quiet(receiver);
    for (std::size_t i = 0; i < 2; ++i)
        for (const Universe& universe : all_universes().list) {
            Universes one;
            one.at(universe.number).levels = universe.levels;
            EXPECT_TRUE(desks[i].send(one).ok());
            std::this_thread::sleep_for(50us);
        }
    const Statistics statistics = statistics_when_quiet(receiver);
    const double ran_ms = scheduled(ours.back()).ran_ms;

    const std::uint64_t sent = 2u * kUniverses * (kRefreshes + 1u);
    EXPECT_EQ(statistics.packets_sacn + statistics.packets_artnet + statistics.overflow, sent);
    // At most: what is dropped before a source's first packet leaves no gap.
    EXPECT_LE(statistics.merge.missed, statistics.overflow);
    EXPECT_EQ(statistics.merge.out_of_sequence, 0u);
    EXPECT_EQ(statistics.unlisted, 0u);
    const double packet_us = ran_ms * 1e3 / static_cast<double>(sent - statistics.overflow);
    EXPECT_LT(packet_us * 2 * kUniverses * kRefreshes, 0.75 * kSeconds * 1e6); // of one processor, at 44 Hz
    const double waited_ms = most_waited_ms(watched.thread);
    const std::vector<double>& latency_ms = watched.latency_ms;
    EXPECT_FALSE(latency_ms.empty());
    if (latency_ms.empty()) return true;
    std::printf(
        "%d universes from two desks at %.1f Hz%s: dropped %llu of %llu packets; receiver %.1f us of "
        "processor a packet, kept waiting for one for %.0f ms of 800 at most; first byte sent to last "
        "universe readable: median %.2f ms, p99 %.2f, max %.2f\n",
        int{kUniverses}, kRefreshes / took_s,
        kInstrumented ? " (instrumented build: 64 universes instead of 512)" : "",
        static_cast<unsigned long long>(statistics.overflow), static_cast<unsigned long long>(sent),
        packet_us, waited_ms, latency_ms[latency_ms.size() / 2], latency_ms[latency_ms.size() * 99 / 100],
        latency_ms.back());
    if (statistics.overflow > 0 && waited_ms > kStarved_ms) return false;
    EXPECT_EQ(statistics.overflow, 0u);
    return true;
}

TEST(Receiver, load_of_512_universes_from_two_desks) {
    {
        const auto probe = Receiver::start(on_loopback(512));
        ASSERT_TRUE(probe.ok()) << probe.error().text();
        if (!(*probe)->warnings().empty()) GTEST_SKIP() << (*probe)->warnings()[0];
    }
    for (int run = 0; run < 3; ++run)
        if (judge_load() || HasFailure()) return;
    GTEST_SKIP()
        << "in three runs packets were dropped while the receiver waited for a processor for more than "
        << kStarved_ms << " ms of 800: this machine is too busy to judge drops; all else held";
}

} // namespace
} // namespace ghost::dmx
