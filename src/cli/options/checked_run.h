#pragma once
// SPDX-License-Identifier: Apache-2.0
// How a command ends: 2 where its options make no sense together, 1 where it failed, both with the reason on
// standard error, else 0.

#include "base/log.h"
#include "base/result.h"

namespace ghost::app {

// check and run: give Result<void>; nothing is run that check refuses.
template <class Check, class Run>
int checked_run(bool quiet, const Check& check, const Run& run) {
    if (quiet) set_log_level(LogLevel::warning);
    if (const Result<void> usage = check(); !usage.ok()) {
        log_error(usage.error().text());
        return 2;
    }
    if (const Result<void> done = run(); !done.ok()) {
        log_error(done.error().text());
        return 1;
    }
    return 0;
}

} // namespace ghost::app
