// SPDX-License-Identifier: Apache-2.0
#include "live/session/opening.h"

#include "support/demo_copy.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>

namespace ghost::app {
namespace {

std::optional<Opening::Opened> taken_within_a_minute(Opening& opening) {
    for (int i = 0; i < 6000; ++i) {
        if (auto opened = opening.take()) return opened;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return {};
}

TEST(Opening, is_handed_over_once_and_not_before_it_is_ready) {
    Opening opening;
    EXPECT_FALSE(opening.is_running());
    EXPECT_FALSE(opening.take());
    std::promise<void> goes_on;
    opening.begin(Opening::Kind::edit, [&] {
        goes_on.get_future().wait();
        auto session = std::make_unique<Session>();
        session->master = 0.5f;
        return Opening::Opened(std::move(session));
    });
    EXPECT_TRUE(opening.is_running());
    EXPECT_FALSE(opening.take());
    goes_on.set_value();
    const auto opened = taken_within_a_minute(opening);
    ASSERT_TRUE(opened && opened->ok());
    EXPECT_EQ((**opened)->master, 0.5f);
    EXPECT_EQ(opening.kind(), Opening::Kind::edit);
    EXPECT_FALSE(opening.is_running());
    EXPECT_FALSE(opening.take());
}

TEST(Opening, an_error_is_handed_over_too_and_the_next_one_may_begin) {
    Opening opening;
    opening.begin(Opening::Kind::newer_plot, [] { return Opening::Opened(Error{"no such file", "x.mvr"}); });
    const auto opened = taken_within_a_minute(opening);
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->error().text(), "x.mvr: no such file");
    opening.begin(Opening::Kind::edit, [] { return Opening::Opened(std::make_unique<Session>()); });
    EXPECT_TRUE(taken_within_a_minute(opening)->ok());
}

TEST(Opening, a_session_that_is_not_wanted_any_more_ends_while_it_is_opened) {
    SessionOptions options;
    options.show = DemoCopy::show().string();
    options.live = options.quiet = options.maps_in_background = true;
    options.stop = [] { return true; };
    const auto opened = open_session(options);
    ASSERT_FALSE(opened.ok());
    EXPECT_NE(opened.error().what.find("interrupted"), std::string::npos) << opened.error().text();
}

TEST(Opening, what_is_dropped_is_never_handed_over) {
    Opening opening;
    opening.drop(); // nothing runs: the next one is taken
    for (const bool drops : {true, false}) {
        opening.begin(Opening::Kind::edit, [] { return Opening::Opened(std::make_unique<Session>()); });
        if (drops) opening.drop();
        for (int i = 0; i < 6000 && opening.is_running(); ++i) {
            EXPECT_FALSE(drops && opening.take());
            if (!drops) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        EXPECT_EQ(opening.is_running(), !drops);
    }
    EXPECT_TRUE(taken_within_a_minute(opening)->ok());
}

TEST(Opening, what_is_being_opened_is_waited_for) {
    std::atomic<bool> ended{false};
    {
        Opening opening;
        opening.begin(Opening::Kind::edit, [&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            ended = true;
            return Opening::Opened(std::make_unique<Session>());
        });
    }
    EXPECT_TRUE(ended);
}

} // namespace
} // namespace ghost::app
