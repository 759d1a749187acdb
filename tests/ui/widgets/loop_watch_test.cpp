// SPDX-License-Identifier: Apache-2.0
// What keeps the event loop is counted, waiting is not.
#include "support/test_window.h"
#include "ui/widgets/loop_watch.h"

#include <thread>

namespace ghost::ui {
namespace {

TEST(LoopWatch, counts_what_blocks_and_not_what_waits) {
    LoopWatch watch(nullptr);
    wait_ms(20);
    watch.reset();
    QTimer::singleShot(10, [] { std::this_thread::sleep_for(std::chrono::milliseconds(80)); });
    wait_ms(1000);
    EXPECT_GE(watch.busy().max_ms(), 80 - LoopWatch::kBeat_ms);
    EXPECT_LT(watch.busy().max_ms(), 900) << "the wait of a second is none";
    EXPECT_GE(watch.busy().count(), 2u);
}

} // namespace
} // namespace ghost::ui
