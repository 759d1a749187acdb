// SPDX-License-Identifier: Apache-2.0
// What a receiver of sACN must do, stimulus by stimulus, numbered as in the black-box test that OLA drives
// nodes with (s1 to s27; the facts, not its text), once with the bare rules and once with the receiver's:
// there a newcomer beside others may be kept waiting for 1.5 s, so each stimulus lasts 3 s at 40 Hz.
#include "dmx/wire/build.h"
#include "support/desk.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <set>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;
using Slots = std::vector<std::uint8_t>;

constexpr auto kPeriod = 25ms;
constexpr auto kLong = 3s;

// One source as bytes on the wire.
struct WireSource {
    std::uint8_t id;
    std::uint8_t sequence = 0;

    std::vector<std::uint8_t> data(std::uint8_t priority, const Slots& slots, std::uint8_t options = 0) {
        return build_sacn(1, slots, ++sequence, {priority, {id}, "Test"}, {options});
    }
};

Slots all(int level) {
    return Slots(512, static_cast<std::uint8_t>(level));
}

class Conformance : public testing::TestWithParam<bool> {
protected:
    Conformance() : merge_(options()) {}

    static MergeOptions options() {
        MergeOptions result;
        if (GetParam()) result.priority_wait = kPriorityWait;
        return result;
    }
    void send(const std::vector<std::uint8_t>& bytes) {
        const Parsed parsed = parse_sacn(bytes);
        if (const Packet* packet = std::get_if<Packet>(&parsed)) merge_.feed(*packet, now_);
    }
    // Repeats a stimulus for kLong and looks at the first slots after each refresh.
    void phase(const std::function<void()>& stimulus, std::size_t slots = 4) {
        seen_.clear();
        lost_after_.reset();
        const nanoseconds start = now_;
        for (; now_ < start + kLong; now_ += kPeriod) {
            stimulus();
            merge_.tick(now_);
            const Universe* universe = merge_.universes().find(1);
            if (!universe) continue;
            Ints look;
            for (std::size_t i = 0; i < slots; ++i) look.push_back((*universe->levels)[i]);
            if (universe->lost && !lost_after_) lost_after_ = now_ - start;
            if (!universe->lost) lost_after_.reset();
            if (seen_.empty() || seen_.back() != look) seen_.push_back(look);
            last_512_ = universe->levels->at(511);
        }
    }
    // What was shown, in order, was at most this, and the last of it at the end.
    void expect(const char* which, const std::vector<Ints>& allowed) {
        ASSERT_FALSE(seen_.empty()) << which;
        EXPECT_EQ(seen_.back(), allowed.back()) << which;
        for (const Ints& look : seen_)
            EXPECT_NE(std::find(allowed.begin(), allowed.end(), look), allowed.end())
                << which << ": " << look[0];
        EXPECT_FALSE(lost_after_.has_value()) << which;
    }
    // Lost between these times after the phase began; the last look is held meanwhile.
    void expect_lost(const char* which, nanoseconds from, nanoseconds to, const Ints& held) {
        ASSERT_TRUE(lost_after_.has_value()) << which;
        EXPECT_GE(*lost_after_, from) << which;
        EXPECT_LE(*lost_after_, to) << which;
        EXPECT_EQ(seen_, std::vector<Ints>{held}) << which;
    }

    Merge merge_;
    nanoseconds now_ = 100s;
    std::vector<Ints> seen_;
    std::optional<nanoseconds> lost_after_;
    int last_512_ = 0;
    WireSource a_{1}, b_{2};
};

const std::function<void()> kNothing = [] {};
Ints four(int level) {
    return Ints(4, level);
}

TEST_P(Conformance, one_source_s1_to_s11) {
    phase([&] { send(a_.data(100, all(20))); });
    expect("s1", {four(20)});
    EXPECT_EQ(last_512_, 20);
    phase(kNothing);
    expect_lost("s2", 2400ms, 2600ms, four(20));
    phase([&] { send(a_.data(100, all(10))); });
    expect("s3", {four(10)});
    send(a_.data(100, {}, 0x40));
    phase(kNothing);
    expect_lost("s4", 0ms, 0ms, four(10));
    phase([&] { send(a_.data(100, all(30))); });
    expect("s5", {four(30)});
    for (int i = 0; i < 3; ++i) send(a_.data(100, all(10), 0x40));
    phase(kNothing);
    expect_lost("s6: never a value of 10", 0ms, 0ms, four(30));
    phase([&] { send(a_.data(201, all(201))); });
    expect_lost("s7: priority above 200", 0ms, 0ms, four(30));
    phase([&] { send(a_.data(100, all(100))); });
    expect("s8", {four(100)});
    phase([&] { send(a_.data(99, all(99))); });
    expect("s9: a source lowers its priority", {four(99)});
    phase(kNothing);
    expect_lost("s10", 2400ms, 2600ms, four(99));
    send(a_.data(100, all(10), 0x40));
    phase(kNothing);
    expect_lost("s11: too late to matter", 0ms, 0ms, four(99));
}

TEST_P(Conformance, sequence_s12_s13) {
    int turn = 0;
    phase([&] {
        if (++turn % 4 != 0 || turn < 40) return send(a_.data(100, all(255)));
        WireSource late = a_;
        late.sequence = static_cast<std::uint8_t>(late.sequence - turn % 19 - 1);
        send(late.data(100, all(0)));
    });
    expect("s12: late packets", {four(255)});
    send(a_.data(100, {}, 0x40));
    phase(kNothing);
    expect_lost("s13", 0ms, 0ms, four(255));
}

TEST_P(Conformance, two_sources_s14_to_s21) {
    const auto both = [&](int pa, const Slots& a, int pb, const Slots& b) {
        phase([&, pa, pb] {
            send(a_.data(static_cast<std::uint8_t>(pa), a));
            send(b_.data(static_cast<std::uint8_t>(pb), b));
        });
    };
    phase([&] { send(a_.data(20, all(20))); });
    expect("s14", {four(20)});
    both(20, all(20), 10, all(10));
    expect("s15: the lower priority never shows", {four(20)});
    both(20, all(20), 30, all(30));
    expect("s16: the higher one does", {four(20), four(30)});
    both(20, all(20), 10, {100, 100, 100, 100});
    expect("s17: and leaves", {four(100), four(20)});
    both(20, {1, 1, 100, 100}, 20, {100, 100, 1, 1});
    expect("s18: highest takes precedence", {four(20), {1, 1, 100, 100}, four(100)});
    both(20, {1, 1, 100, 0}, 20, {100, 0, 1, 1});
    expect("s19", {{100, 1, 100, 1}});
    phase([&] { send(b_.data(20, {100, 0, 1, 1})); });
    expect("s20: one leaves", {{100, 1, 100, 1}, {100, 0, 1, 1}});
    phase(kNothing);
    expect_lost("s21: the other, too", 2400ms, 2600ms, {100, 0, 1, 1});
}

TEST_P(Conformance, newcomers_s22_to_s27) {
    phase([&] { send(a_.data(20, all(20))); });
    expect("s22", {four(20)});
    phase([&] {
        send(a_.data(20, all(20)));
        send(b_.data(30, all(30)));
    });
    expect("s23: one of higher priority", {four(20), four(30)});
    send(a_.data(20, {}, 0x40));
    send(b_.data(30, {}, 0x40));
    phase(kNothing);
    expect_lost("s24: both say goodbye", 0ms, 0ms, four(30));
    phase([&] { send(a_.data(20, {20, 20, 20, 20})); });
    expect("s25", {four(20)});
    phase([&] {
        send(a_.data(20, {20, 20, 20, 20}));
        send(b_.data(20, {100, 100, 100, 100}));
    });
    expect("s26: one of equal priority", {four(20), four(100)});
    send(b_.data(20, {}, 0x40));
    phase([&] { send(a_.data(20, {20, 20, 20, 20})); });
    expect("s27: it leaves", {four(100), four(20)});
}

INSTANTIATE_TEST_SUITE_P(BareAndReceiver, Conformance, testing::Bool());

} // namespace
} // namespace ghost::dmx
