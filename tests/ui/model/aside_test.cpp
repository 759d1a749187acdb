// SPDX-License-Identifier: Apache-2.0
// Work on another thread that an action waits for: the window goes on, who asked has the answer.
#include "support/test_window.h"
#include "ui/model/aside.h"
#include "ui/widgets/loop_watch.h"

#include <chrono>
#include <new>

namespace ghost::ui {
namespace {

constexpr auto kWork = std::chrono::milliseconds(900);

TEST(Aside, the_window_goes_on_meanwhile) {
    LoopWatch watch(nullptr);
    wait_ms(20);
    watch.reset();
    const Result<int> answer = aside([]() -> Result<int> {
        std::this_thread::sleep_for(kWork);
        return 7;
    });
    ASSERT_TRUE(answer.ok());
    EXPECT_EQ(*answer, 7);
    EXPECT_GE(watch.busy().count(), 5u);
    EXPECT_LT(watch.busy().max_ms(), 600) << "a loop that stood would have been late by all of it";
}

TEST(Aside, what_went_wrong_goes_to_who_asked) {
    const Result<void> refused = aside([]() -> Result<void> { return Error{"is no model", "club.glb"}; });
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().text(), "club.glb: is no model");
    EXPECT_THROW((void)aside([]() -> Result<void> { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(Aside, one_may_be_asked_for_while_another_works) {
    std::vector<int> done;
    QTimer::singleShot(20, [&] { done.push_back(*aside([]() -> Result<int> { return 2; })); });
    done.push_back(*aside([]() -> Result<int> {
        std::this_thread::sleep_for(kWork);
        return 1;
    }));
    EXPECT_EQ(done, (std::vector<int>{2, 1}));
}

} // namespace
} // namespace ghost::ui
