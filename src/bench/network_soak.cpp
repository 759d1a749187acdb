// SPDX-License-Identifier: Apache-2.0
// An even load on one receiver for as long as wanted: a desk by sACN and one by Art-Net send 64 universes
// each at 44 Hz, all through; a backup desk of lower priority comes for half of every minute and goes, by
// turns with a goodbye and without. One row a minute. What proves it: every packet that was sent was
// received, none is missing by its number, came late or was dropped by the kernel, and memory stayed flat;
// the last row says so, and what does not hold is an error.
#include "base/interrupt.h"
#include "bench/bench.h"

#include "base/memory.h"
#include "base/progress.h"
#include "dmx/receive/receiver.h"
#include "dmx/send/sender.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::uint16_t kUniverses = 64;
constexpr auto kPeriod = std::chrono::nanoseconds(1'000'000'000 / 44);
constexpr double kMinute_s = 60.0;
constexpr double kWarmUp_s = 120.0; // at most half of the time: caches and heaps fill
// Pages come and go with the threads; a byte for each packet of an hour would be 25.
constexpr double kMostGrowth_mb = 2.0;

struct Load {
    std::atomic<bool> stop{false};
    std::atomic<std::uint64_t> sent{0};
};

double resident_mb() {
    return static_cast<double>(used_memory_bytes()) * 1e-6;
}

double elapsed_s(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

dmx::Universes look(int number) {
    auto levels = std::make_shared<dmx::Levels>();
    levels->fill(static_cast<std::uint8_t>(number));
    dmx::Universes all;
    for (std::uint16_t universe = 1; universe <= kUniverses; ++universe) all.at(universe).levels = levels;
    return all;
}

void send(dmx::Sender& desk, int number, Load& load) {
    const std::uint64_t before = desk.packets();
    (void)desk.send(look(number)); // what the system refuses was not sent, and is not counted
    load.sent += desk.packets() - before;
}

// A desk that is late goes on from there, as real ones do.
void run_desk(dmx::Sender& desk, Load& load) {
    auto next = Clock::now();
    for (int number = 0; !load.stop; ++number) {
        std::this_thread::sleep_until(next);
        next = std::max(next, Clock::now() - 1ms) + kPeriod;
        send(desk, number, load);
    }
    // A gap shows with the next packet only.
    std::this_thread::sleep_for(300ms);
    send(desk, 0, load);
}

void run_backup(dmx::Sender& desk, Load& load) {
    const auto start = Clock::now();
    auto next = start;
    bool was_here = false, says_goodbye = false;
    for (int number = 0; !load.stop; ++number) {
        std::this_thread::sleep_until(next);
        next = std::max(next, Clock::now() - 1ms) + kPeriod;
        const bool here = std::fmod(elapsed_s(start), kMinute_s) < kMinute_s / 2;
        if (here) send(desk, number, load);
        if (!here && was_here) {
            if (says_goodbye) load.sent += desk.terminate();
            says_goodbye = !says_goodbye;
        }
        was_here = here;
    }
}

Result<dmx::Sender> open_desk(dmx::Protocol protocol, std::uint8_t priority,
                              const dmx::ReceiverOptions& receiver) {
    dmx::SenderOptions to;
    to.protocol = protocol;
    to.priority = priority;
    to.destination = to.interface = receiver.interface;
    to.port = protocol == dmx::Protocol::sacn ? receiver.sacn_port : receiver.artnet_port;
    return dmx::Sender::open(to);
}

BenchRow row_of(const std::string& name, const dmx::Statistics& statistics, std::uint64_t sent,
                double running_s) {
    const double cpu_s = std::chrono::duration<double>(statistics.cpu).count();
    BenchRow row;
    row.table = "network";
    row.name = name;
    row.figures = {
        {"sent", static_cast<double>(sent)},
        {"received", static_cast<double>(statistics.packets_sacn + statistics.packets_artnet)},
        {"lost", static_cast<double>(statistics.merge.missed)},
        {"kernel_overflow", static_cast<double>(statistics.overflow)},
        {"out_of_sequence", static_cast<double>(statistics.merge.out_of_sequence)},
        {"sources_left",
         static_cast<double>(statistics.merge.sources_lost + statistics.merge.sources_terminated)},
        {"p50_ms", statistics.latency.percentile_ms(0.5)},
        {"p99_ms", statistics.latency.percentile_ms(0.99)},
        {"max_ms", statistics.latency.max_ms()},
        {"cpu_percent", 100.0 * cpu_s / std::max(running_s, 1e-3)},
        {"memory_mb", resident_mb()},
    };
    row.note = std::to_string(statistics.sources.size()) + " sources";
    return row;
}

} // namespace

Result<void> network_soak(double seconds, std::uint16_t port, const BenchSink& sink) {
    dmx::ReceiverOptions wanted;
    wanted.interface = "127.0.0.1";
    wanted.sacn_port = port;
    wanted.artnet_port = static_cast<std::uint16_t>(port + 1);
    wanted.answer_polls = false;
    for (std::uint16_t universe = 1; universe <= kUniverses; ++universe) wanted.universes.push_back(universe);
    TRY(const auto receiver, dmx::Receiver::start(wanted));
    TRY(dmx::Sender sacn, open_desk(dmx::Protocol::sacn, 100, wanted));
    TRY(dmx::Sender artnet, open_desk(dmx::Protocol::artnet, 100, wanted));
    TRY(dmx::Sender backup, open_desk(dmx::Protocol::sacn, 90, wanted));
    Load load;
    const InterruptScope scope;
    const auto start = Clock::now();
    std::vector<std::thread> desks;
    desks.emplace_back([&] { run_desk(sacn, load); });
    desks.emplace_back([&] { run_desk(artnet, load); });
    desks.emplace_back([&] { run_backup(backup, load); });

    dmx::Statistics statistics;
    const auto look_in = [&](auto until) {
        for (; Clock::now() < until; std::this_thread::sleep_for(20ms)) {
            (void)receiver->take(); // as whoever draws does
            if (auto newest = receiver->take_statistics()) statistics = std::move(*newest);
        }
    };
    Progress progress("soak", Progress::style_for_stderr(), 0.0);
    const double warm_s = std::min(kWarmUp_s, seconds / 2);
    double warm_mb = 0;
    for (int minute = 1; !interrupted() && elapsed_s(start) < seconds;) {
        look_in(Clock::now() + 500ms);
        const double now_s = elapsed_s(start);
        progress.update(now_s / seconds, now_s, std::to_string(statistics.merge.missed) + " lost");
        if (warm_mb == 0 && now_s >= warm_s) warm_mb = resident_mb();
        if (now_s < minute * kMinute_s) continue;
        progress.finish();
        sink(row_of("minute " + std::to_string(minute++), statistics, load.sent, now_s));
    }
    progress.finish();
    load.stop = true;
    for (std::thread& one : desks) one.join();
    look_in(Clock::now() + 700ms);
    const double ran_s = elapsed_s(start);
    const std::uint64_t received = statistics.packets_sacn + statistics.packets_artnet;
    const double growth_mb = warm_mb > 0 ? resident_mb() - warm_mb : 0;
    const bool all_came = received == load.sent && statistics.merge.missed == 0 &&
                          statistics.merge.out_of_sequence == 0 && statistics.overflow == 0;
    const bool flat = growth_mb <= kMostGrowth_mb;
    const bool whole = ran_s >= seconds;
    BenchRow row = row_of("soak of " + clock_text(ran_s), statistics, load.sent, ran_s);
    row.figures.emplace_back("memory_growth_mb", growth_mb);
    row.note = all_came && flat && whole ? "holds: none lost, memory flat" : "does not hold";
    sink(row);
    if (!all_came)
        return Error{std::to_string(load.sent) + " packets were sent, " + std::to_string(received) +
                         " received, " + std::to_string(statistics.merge.missed) +
                         " missed by their numbers, " + std::to_string(statistics.merge.out_of_sequence) +
                         " late, " + std::to_string(statistics.overflow) +
                         " dropped by the kernel; expected all",
                     "soak"};
    if (!flat)
        return Error{"memory grew by " + std::to_string(growth_mb) + " MB after the first " +
                         clock_text(warm_s) + ", expected " + std::to_string(kMostGrowth_mb) + " at most",
                     "soak"};
    if (!whole) return Error{"interrupted after " + clock_text(ran_s) + " of " + clock_text(seconds), "soak"};
    return {};
}

} // namespace ghost::app
