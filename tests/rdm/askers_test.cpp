// SPDX-License-Identifier: Apache-2.0
#include "rdm/askers.h"

#include <gtest/gtest.h>

namespace ghost::rdm {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr std::uint32_t kOne = 0x0A000001, kTwo = 0x0A000002;
constexpr nanoseconds kStart = 100s;

TEST(RdmAskers, only_who_asked_for_a_port_hears_of_it_and_once) {
    Askers askers;
    askers.asked(kOne, 3, kStart);
    askers.asked(kTwo, 4, kStart);
    EXPECT_FALSE(askers.next(kStart)) << "nothing changed";
    askers.changed(3);
    askers.changed(3);
    askers.changed(9);
    EXPECT_EQ(askers.next(kStart), (Askers::Due{kOne, 3}));
    EXPECT_FALSE(askers.next(kStart));
}

TEST(RdmAskers, a_table_that_changes_all_the_time_is_sent_once_in_its_rest_and_the_last_state_too) {
    Askers askers;
    askers.asked(kOne, 3, kStart);
    int sent = 0;
    for (nanoseconds now = kStart; now < kStart + 10s; now += 10ms) {
        askers.changed(3);
        while (askers.next(now)) ++sent;
    }
    EXPECT_EQ(sent, 10);
    EXPECT_TRUE(askers.next(kStart + 11s)) << "what came last";
    EXPECT_FALSE(askers.next(kStart + 13s));
}

TEST(RdmAskers, who_asks_meanwhile_has_it) {
    Askers askers;
    askers.asked(kOne, 3, kStart);
    askers.changed(3);
    askers.asked(kOne, 3, kStart);
    EXPECT_FALSE(askers.next(kStart));
}

TEST(RdmAskers, who_sends_no_rdm_for_long_is_forgotten) {
    Askers askers;
    askers.asked(kOne, 3, kStart);
    askers.asked(kTwo, 3, kStart);
    askers.heard(kTwo, kStart + 30min);
    askers.heard(0x0A000003, kStart + 30min);
    askers.changed(3);
    EXPECT_EQ(askers.next(kStart + kAskerStays), (Askers::Due{kTwo, 3}));
    EXPECT_FALSE(askers.next(kStart + kAskerStays));
}

TEST(RdmAskers, so_many_controllers_and_ports_and_no_more) {
    Askers askers;
    for (std::uint32_t i = 0; i <= kMaxAskers; ++i) askers.asked(kOne + i, 3, kStart + i * 1ms);
    askers.changed(3);
    for (std::uint32_t i = 1; i <= kMaxAskers; ++i)
        EXPECT_EQ(askers.next(kStart + 1s), (Askers::Due{kOne + i, 3}))
            << "the one that was silent longest went";
    EXPECT_FALSE(askers.next(kStart + 1s));
    for (std::size_t port = 0; port <= kMaxAskedPorts + 3; ++port)
        askers.asked(kOne, static_cast<std::uint16_t>(port), kStart + 2s);
    askers.changed(0);
    askers.changed(static_cast<std::uint16_t>(kMaxAskedPorts));
    EXPECT_EQ(askers.next(kStart + 2s), (Askers::Due{kOne, 0}));
    EXPECT_FALSE(askers.next(kStart + 2s));
}

} // namespace
} // namespace ghost::rdm
