// SPDX-License-Identifier: Apache-2.0
#include "web/flow.h"

#include <gtest/gtest.h>

namespace ghost::web {
namespace {

// Pictures that are painted so long after they were sent, one after the other. Returns the time after.
double painted_after(Flow& flow, double begin_s, double takes_s, int count) {
    for (int i = 0; i < count; ++i) {
        flow.sent(flow.newest() + 1, begin_s);
        begin_s += takes_s;
        flow.painted(flow.newest(), begin_s);
    }
    return begin_s;
}

TEST(Flow, two_are_on_the_way_and_no_more) {
    Flow flow;
    painted_after(flow, -1, 0.1, 1);
    EXPECT_TRUE(flow.may_send(0));
    flow.sent(1, 0);
    EXPECT_TRUE(flow.may_send(0));
    EXPECT_FALSE(flow.is_full(0.01));
    flow.sent(2, 0.01);
    EXPECT_TRUE(flow.is_full(0.01));
    EXPECT_FALSE(flow.may_send(1000)) << "time alone changes nothing: hidden tabs paint nothing";
    flow.painted(7, 0.02);
    EXPECT_FALSE(flow.may_send(0.02)) << "one that was never sent";
    flow.painted(2, 0.03);
    EXPECT_TRUE(flow.may_send(0.03));
    EXPECT_FALSE(flow.is_full(0.03)) << "the first one was done with the second";
    flow.sent(3, 0.03);
    flow.painted(2, 0.04);
    EXPECT_EQ(flow.newest(), 3u);
}

TEST(Flow, a_second_one_follows_only_while_the_first_is_not_slower_than_the_one_before) {
    Flow flow;
    flow.sent(1, 0);
    EXPECT_FALSE(flow.may_send(0)) << "nothing is known of him yet";
    flow.painted(1, 0.1);
    flow.sent(2, 1);
    EXPECT_TRUE(flow.may_send(1.09));
    EXPECT_FALSE(flow.may_send(1.11)) << "his line has become slow, perhaps";
    flow.painted(2, 1.3);
    flow.sent(3, 2);
    EXPECT_FALSE(flow.may_send(2.01)) << "he was late";
    flow.painted(3, 2.05);
    EXPECT_TRUE(flow.may_send(2.05));
}

TEST(Flow, who_is_late_gets_one_at_a_time_and_smaller_ones) {
    Flow flow;
    double now_s = painted_after(flow, 0, 0.16, 2);
    now_s = painted_after(flow, now_s, 0.02, 1);
    now_s = painted_after(flow, now_s, 0.16, 2);
    EXPECT_EQ(flow.width(), 1280) << "never three in a row";
    now_s = painted_after(flow, now_s, 0.16, 1);
    EXPECT_EQ(flow.width(), 854);
    flow.sent(100, now_s);
    EXPECT_FALSE(flow.may_send(now_s));
    flow.painted(100, now_s + 0.1);
    now_s = painted_after(flow, now_s + 0.1, 0.2, 20);
    EXPECT_EQ(flow.width(), 480) << "the smallest that there is";
}

TEST(Flow, who_is_fast_for_long_gets_more_again) {
    Flow flow;
    double now_s = painted_after(flow, 0, 0.2, 6);
    ASSERT_EQ(flow.width(), 480);
    now_s = painted_after(flow, now_s, 0.05, 95); // 4.75 s
    EXPECT_EQ(flow.width(), 480);
    now_s = painted_after(flow, now_s, 0.05, 10);
    EXPECT_EQ(flow.width(), 854);
    now_s = painted_after(flow, now_s, 0.1, 1); // neither fast nor late
    now_s = painted_after(flow, now_s, 0.05, 95);
    EXPECT_EQ(flow.width(), 854);
    painted_after(flow, now_s, 0.05, 20);
    EXPECT_EQ(flow.width(), 1280);
}

TEST(Flow, a_small_page_gets_small_pictures_and_a_calm_one_two_a_second) {
    Flow flow;
    flow.want(400, true);
    EXPECT_EQ(flow.width(), 400);
    EXPECT_TRUE(flow.may_send(0));
    flow.sent(1, 0);
    flow.painted(1, 0.02);
    EXPECT_FALSE(flow.may_send(0.49));
    EXPECT_TRUE(flow.may_send(0.5));
    flow.want(4000, false);
    EXPECT_TRUE(flow.may_send(0.03));
    EXPECT_EQ(flow.width(), 1280);
}

TEST(Ration, in_the_long_run_no_more_than_the_rate) {
    Ration ration(1000);
    double spent = 0;
    for (int i = 0; i < 1000; ++i)
        if (ration.has_some(0.01 * i)) {
            ration.spend(70);
            spent += 70;
        }
    EXPECT_NEAR(spent, 10'000, 300);
    EXPECT_TRUE(ration.has_some(100));
    ration.spend(5000);
    EXPECT_FALSE(ration.has_some(104)) << "what was too much is a pause";
    EXPECT_TRUE(ration.has_some(105.1));
}

} // namespace
} // namespace ghost::web
