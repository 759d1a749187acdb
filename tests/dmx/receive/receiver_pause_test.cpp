// SPDX-License-Identifier: Apache-2.0
// The receiver after a pause in which it did not run, on the loopback interface: a callback that does not
// return stands for a program that is stopped, between two turns or in the middle of reading.
#include "dmx/receive/receiver.h"
#include "dmx/send/sender.h"
#include "net/socket.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <thread>
#include <unistd.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int kBefore = 1, kAfter = 255; // levels; what lies between was sent in the pause

enum class Where { publishing, reading };

class Paused {
public:
    explicit Paused(Where where) {
        ReceiverOptions options;
        options.interface = "127.0.0.1";
        options.sacn_port = static_cast<std::uint16_t>(20000 + (getpid() % 10000) * 2);
        options.artnet_port = static_cast<std::uint16_t>(options.sacn_port + 1);
        options.answer_polls = false;
        options.sampling = 0s;
        options.universes = {1, 2};
        options.on_levels = [this, where](const Universes&, std::chrono::nanoseconds) {
            ++calls_;
            if (where == Where::publishing) stand_still();
        };
        options.on_timecode = [this, where](const TimeCode&, std::chrono::nanoseconds) {
            if (where == Where::reading) stand_still();
        };
        auto started = Receiver::start(options);
        EXPECT_TRUE(started.ok()) << started.error().text();
        if (started.ok()) receiver_ = std::move(*started);
        SenderOptions wanted;
        wanted.destination = wanted.interface = "127.0.0.1";
        wanted.port = options.sacn_port;
        auto desk = Sender::open(wanted);
        EXPECT_TRUE(desk.ok()) << desk.error().text();
        if (desk.ok()) desk_ = std::make_unique<Sender>(std::move(*desk));
        artnet_port_ = options.artnet_port;
    }
    ~Paused() { go_on(); }

    void send(std::uint16_t universe, int level) {
        Universes look;
        auto levels = std::make_shared<Levels>();
        levels->fill(static_cast<std::uint8_t>(level));
        look.at(universe).levels = levels;
        ASSERT_TRUE(desk_->send(look).ok());
    }
    // ArtTimeCode 00:00:00:00.
    void send_timecode() {
        auto out = UdpSocket::open(IpAddress(0x7F000001u).ipv4(), 0, 1 << 16);
        ASSERT_TRUE(out.ok());
        const std::vector<std::uint8_t> packet{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0, 0x97,
                                               0,   14,  0,   0,   0,   0,   0,   0, 1};
        ASSERT_TRUE((*out)->send(packet, IpAddress(0x7F000001u), artnet_port_).ok());
    }
    // The look from before is out; from now on the receiver stands still.
    void stop() {
        send(1, kBefore);
        const auto end = Clock::now() + 2s;
        while (!(newest_ = receiver_->take()) && Clock::now() < end) std::this_thread::sleep_for(1ms);
        ASSERT_TRUE(newest_ && newest_->level(1, 1) == kBefore);
        if (!stands_) send_timecode();
        while (!stands_ && Clock::now() < end) std::this_thread::sleep_for(1ms);
        ASSERT_TRUE(stands_);
    }
    void go_on() {
        may_go_on_ = true;
        went_on_ = Clock::now();
    }
    // All levels of universe 1 that a reader can see until it sees this one, or for three seconds; and how
    // long that took.
    std::set<int> shown_until(int level, std::chrono::duration<double>& took) {
        std::set<int> shown;
        for (const auto end = Clock::now() + 60s; Clock::now() < end; std::this_thread::sleep_for(200us)) {
            if (const auto universes = receiver_->take()) shown.insert(universes->level(1, 1));
            if (shown.contains(level)) break;
        }
        took = Clock::now() - went_on_;
        return shown;
    }
    std::uint64_t overflow() {
        std::this_thread::sleep_for(300ms);
        const auto statistics = receiver_->take_statistics();
        return statistics ? statistics->overflow : 0;
    }
    int calls() const { return calls_; }

private:
    // Once: before the pause ends it must have lasted long enough to count as one.
    void stand_still() {
        if (stands_.exchange(true)) return;
        const auto least = Clock::now() + 400ms;
        while (!may_go_on_ || Clock::now() < least) std::this_thread::sleep_for(1ms);
    }

    std::unique_ptr<Receiver> receiver_;
    std::unique_ptr<Sender> desk_;
    std::uint16_t artnet_port_ = 0;
    std::optional<Universes> newest_;
    std::atomic<bool> stands_{false}, may_go_on_{false};
    std::atomic<int> calls_{0};
    Clock::time_point went_on_;
};

class Pause : public testing::TestWithParam<Where> {};

TEST_P(Pause, of_which_nothing_was_lost_ends_with_the_newest_look_at_once) {
    Paused test(GetParam());
    test.stop();
    std::this_thread::sleep_for(350ms);
    for (int level = 2; level <= 40; ++level) test.send(1, level);
    test.go_on();
    std::chrono::duration<double> took{};
    const std::set<int> shown = test.shown_until(40, took);
    EXPECT_EQ(shown.count(40), 1u);
    for (const int level : shown) EXPECT_TRUE(level == kBefore || level == 40) << level;
    EXPECT_LT(took.count(), 0.9) << "no further packet came, and none was waited for";
    EXPECT_GE(test.calls(), 39) << "a recording gets what waited, too";
}

TEST_P(Pause, that_filled_the_buffer_ends_with_what_comes_afterwards) {
#if defined(_WIN32)
    GTEST_SKIP() << "Windows does not tell how many packets it dropped";
#endif
    Paused test(GetParam());
    test.stop();
    for (int i = 0; i < 40000; ++i) test.send(1, 2 + i % 200);
    std::this_thread::sleep_for(350ms);
    test.go_on();
    std::this_thread::sleep_for(100ms); // the next refresh of a slow desk
    test.send(1, kAfter);
    std::chrono::duration<double> took{};
    const std::set<int> shown = test.shown_until(kAfter, took);
    EXPECT_EQ(shown.count(kAfter), 1u);
    for (const int level : shown) EXPECT_TRUE(level == kBefore || level == kAfter) << level;
    EXPECT_GT(test.overflow(), 0u);
}

TEST_P(Pause, that_filled_the_buffer_shows_what_it_knows_of_a_desk_that_is_gone) {
#if defined(_WIN32)
    GTEST_SKIP() << "Windows does not tell how many packets it dropped";
#endif
    Paused test(GetParam());
    test.stop();
    for (int i = 0; i < 40000; ++i) test.send(1, 77);
    std::this_thread::sleep_for(350ms);
    test.go_on();
    std::chrono::duration<double> took{};
    EXPECT_EQ(test.shown_until(77, took).count(77), 1u);
    EXPECT_GT(took.count(), 0.5);
    EXPECT_GT(test.overflow(), 0u) << "counted though no packet came after it";
}

INSTANTIATE_TEST_SUITE_P(Receiver, Pause, testing::Values(Where::publishing, Where::reading),
                         [](const auto& where) {
                             return where.param == Where::publishing ? "stopped_between_turns"
                                                                     : "stopped_while_reading";
                         });

} // namespace
} // namespace ghost::dmx
