// SPDX-License-Identifier: Apache-2.0
#include "link/news.h"

#include <gtest/gtest.h>

namespace ghost::ui {
namespace {

TEST(News, two_readers_get_the_newest_once_each) {
    News<int> news;
    news.put(1);
    EXPECT_EQ(news.take_second(), std::nullopt) << "nobody asked for it";
    EXPECT_EQ(news.take(), 1);
    news.also_for_second(true);
    EXPECT_EQ(news.take_second(), 1) << "who comes late gets the newest";
    EXPECT_EQ(news.take_second(), std::nullopt) << "once";
    news.also_for_second(true);
    EXPECT_EQ(news.take_second(), std::nullopt) << "he was there already";
    news.put(2);
    news.put(3);
    EXPECT_EQ(news.take(), 3);
    EXPECT_EQ(news.take(), std::nullopt);
    EXPECT_EQ(news.take_second(), 3) << "the first reader took nothing away";
    EXPECT_EQ(news.take_second(), std::nullopt);
    news.also_for_second(false);
    news.put(4);
    EXPECT_EQ(news.take_second(), std::nullopt);
}

TEST(News, what_comes_often_is_waited_for) {
    News<int, Late::waits> news;
    news.put(1);
    news.also_for_second(true);
    EXPECT_EQ(news.take_second(), std::nullopt);
    news.put(2);
    EXPECT_EQ(news.take_second(), 2);
}

TEST(News, what_goes_on_goes_on_for_each_reader) {
    const auto sum = [](int unread, int& next) { next += unread; };
    News<int> news;
    news.also_for_second(true);
    news.put(1, sum);
    EXPECT_EQ(news.take(), 1);
    news.put(10, sum);
    EXPECT_EQ(news.take(), 10);
    EXPECT_EQ(news.take_second(), 11);
}

} // namespace
} // namespace ghost::ui
