// SPDX-License-Identifier: Apache-2.0
// The load ladder of the receiver: desks send all their universes by sACN in one burst each refresh, as real
// ones do, to a receiver in the same process. Lost is what the sequence numbers miss; the time is from the
// kernel's receipt of a packet to the publication of its levels; the processor time is that of the receiver's
// thread alone.
#include "base/interrupt.h"
#include "bench/bench.h"

#include "dmx/receive/receiver.h"
#include "dmx/send/sender.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

struct Rung {
    std::uint16_t universes;
    int rate_hz;
    int desks;
};
constexpr Rung kLadder[] = {{256, 44, 1}, {512, 44, 1}, {512, 60, 1}, {512, 44, 2}, {1024, 44, 1}};
constexpr Rung kTwoDesks{512, 44, 2};
constexpr double kSent_s = 5.0;

// A desk that is late goes on from there: real ones do not make up for it with several refreshes at once.
std::uint64_t run_desk(dmx::Sender& desk, const Rung& rung, double sent_s) {
    dmx::Universes all;
    for (std::uint16_t universe = 1; universe <= rung.universes; ++universe) all.at(universe);
    const auto period = std::chrono::nanoseconds(1'000'000'000 / rung.rate_hz);
    const int refreshes = static_cast<int>(sent_s * rung.rate_hz);
    auto next = Clock::now();
    for (int i = 0; i < refreshes && !interrupted(); ++i) {
        std::this_thread::sleep_until(next);
        next = std::max(next, Clock::now() - 1ms) + period;
        auto levels = std::make_shared<dmx::Levels>();
        levels->fill(static_cast<std::uint8_t>(i));
        for (dmx::Universe& universe : all.list) universe.levels = levels;
        if (!desk.send(all).ok()) break;
    }
    // A gap shows with the next packet only.
    std::this_thread::sleep_for(300ms);
    for (const dmx::Universe& universe : all.list) {
        dmx::Universes one;
        one.at(universe.number).levels = universe.levels;
        if (!desk.send(one).ok()) break;
        if (universe.number % 16 == 0) std::this_thread::sleep_for(1ms);
    }
    return desk.packets();
}

Result<BenchRow> measure(const Rung& rung, double sent_s, std::uint16_t port) {
    dmx::ReceiverOptions wanted;
    wanted.interface = "127.0.0.1";
    wanted.artnet = false;
    wanted.sacn_port = port;
    wanted.sampling = wanted.priority_wait = 0s;
    for (std::uint16_t universe = 1; universe <= rung.universes; ++universe)
        wanted.universes.push_back(universe);
    TRY(const auto receiver, dmx::Receiver::start(wanted));
    std::vector<dmx::Sender> desks;
    for (int i = 0; i < rung.desks; ++i) {
        dmx::SenderOptions to;
        to.destination = to.interface = "127.0.0.1";
        to.port = port;
        TRY(auto desk, dmx::Sender::open(to));
        desks.push_back(std::move(desk));
    }
    std::vector<std::uint64_t> sent(desks.size());
    const auto start = Clock::now();
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < desks.size(); ++i)
        threads.emplace_back([&, i] { sent[i] = run_desk(desks[i], rung, sent_s); });
    for (std::thread& one : threads) one.join();
    const double took_s = std::chrono::duration<double>(Clock::now() - start).count();
    dmx::Statistics statistics;
    for (const auto end = Clock::now() + 700ms; Clock::now() < end; std::this_thread::sleep_for(10ms))
        if (auto newest = receiver->take_statistics()) statistics = std::move(*newest);

    std::uint64_t all = 0;
    for (const std::uint64_t count : sent) all += count;
    char name[64];
    std::snprintf(name, sizeof name, "%s%d at %d Hz", rung.desks > 1 ? "2 desks, " : "", int{rung.universes},
                  rung.rate_hz);
    const double cpu_s = std::chrono::duration<double>(statistics.cpu).count();
    BenchRow row;
    row.table = "network";
    row.name = name;
    row.figures = {{"sent", static_cast<double>(all)},
                   {"per_s", static_cast<double>(all) / took_s},
                   {"received", static_cast<double>(statistics.packets_sacn)},
                   {"lost", static_cast<double>(statistics.merge.missed)},
                   {"kernel_overflow", static_cast<double>(statistics.overflow)},
                   {"p50_ms", statistics.latency.percentile_ms(0.5)},
                   {"p99_ms", statistics.latency.percentile_ms(0.99)},
                   {"max_ms", statistics.latency.max_ms()},
                   {"cpu_percent", 100.0 * cpu_s / took_s},
                   {"cpu_us_per_packet", 1e6 * cpu_s / static_cast<double>(std::max<std::uint64_t>(1, all))}};
    row.note = std::to_string(statistics.sources.size()) + " sources";
    for (const std::string& warning : receiver->warnings()) row.note += "; " + warning;
    return row;
}

} // namespace

Result<void> bench_network(const BenchOptions& options, const BenchSink& sink) {
    const auto port = static_cast<std::uint16_t>(30000 + Clock::now().time_since_epoch().count() / 1'000'000 %
                                                             20000); // nobody else's, most likely
    if (options.soak_seconds > 0) return network_soak(options.soak_seconds, port, sink);
    if (options.desk_seconds > 0) {
        TRY(const BenchRow row, measure(kTwoDesks, options.desk_seconds, port));
        sink(row);
        return {};
    }
    for (const Rung& rung : kLadder) {
        if (interrupted()) break;
        TRY(const BenchRow row, measure(rung, kSent_s, port));
        sink(row);
    }
    return {};
}

} // namespace ghost::app
