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

TEST(LoopWatch, what_comes_before_the_loop_runs_is_not_of_it) {
    LoopWatch watch(nullptr);
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    wait_ms(200);
    EXPECT_GE(watch.busy().count(), 1u);
    EXPECT_LT(watch.busy().max_ms(), 600);
}

} // namespace
} // namespace ghost::ui
