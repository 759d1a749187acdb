#pragma once
// SPDX-License-Identifier: Apache-2.0
// For threads whose work may wait, and for those whose work may not.

namespace ghost {

// The calling thread gets what processor time others leave (nice 19). Where the system does not do so,
// nothing happens.
void give_way();

// The calling thread comes before all that is not real-time (SCHED_RR, the lowest priority; not what it
// starts): for one that sleeps nearly always and must be in time. Where the system refuses that (without root
// and without a limit `rtprio`), nothing happens.
void go_first();

} // namespace ghost
