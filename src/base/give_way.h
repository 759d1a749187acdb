#pragma once
// SPDX-License-Identifier: Apache-2.0
// For threads whose work may wait, and for those whose work may not.

namespace ghost {

inline constexpr int kGiveWay = 19, kGiveWayABit = 5; // of nice
// The calling thread gets what processor time others leave (19), or a third of what each of them gets (5):
// others wait for it now and then. Where the system does not do so, nothing happens.
void give_way(int nice = kGiveWay);

// The calling thread comes before all that is not real-time (SCHED_RR, the lowest priority; not what it
// starts): for one that sleeps nearly always and must be in time. Where the system refuses that (without root
// and without a limit `rtprio`), nothing happens.
void go_first();

} // namespace ghost
