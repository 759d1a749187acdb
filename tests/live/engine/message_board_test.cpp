// SPDX-License-Identifier: Apache-2.0
#include "live/engine/message_board.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

struct Board {
    std::vector<std::string> shown() {
        std::vector<std::string> texts;
        if (const auto news = link.messages.take())
            for (const Message& message : *news) texts.push_back(message.what);
        return texts;
    }
    Board() {
        link.on_news = [this] { ++told; };
    }
    using Texts = std::vector<std::string>;

    ui::Link link;
    int told = 0;
    MessageBoard board{link};
};

TEST(MessageBoard, the_network_stands_before_news_and_the_show) {
    Board one;
    one.board.add(Severity::note, "x", "news");
    EXPECT_TRUE(one.board.set_network({{Severity::error, "network", "port"}}));
    Report report;
    report.add(Severity::warning, "show.toml", "show");
    one.board.show(report);
    EXPECT_EQ(one.shown(), (Board::Texts{"port", "news", "show"}));
    EXPECT_TRUE(one.board.set_network({}));
    EXPECT_EQ(one.shown(), (Board::Texts{"news", "show"}));
    EXPECT_FALSE(one.board.has_network());
}

TEST(MessageBoard, what_is_the_same_is_not_told_again) {
    Board one;
    Report report;
    report.add(Severity::warning, "show.toml", "show");
    one.board.show(report);
    (void)one.board.set_network({{Severity::error, "network", "port"}});
    const int before = one.told;
    one.board.show(report);
    EXPECT_FALSE(one.board.set_network({{Severity::error, "network", "port"}}));
    EXPECT_EQ(one.told, before);
    one.board.show_anew(report); // another show may have as many
    EXPECT_EQ(one.told, before + 1);
}

TEST(MessageBoard, the_oldest_news_make_room) {
    Board one;
    for (int i = 0; i < 301; ++i) one.board.add(Severity::note, "x", std::to_string(i));
    const auto shown = one.shown();
    ASSERT_EQ(shown.size(), 300u);
    EXPECT_EQ(shown.front(), "1");
    EXPECT_EQ(shown.back(), "300");
}

} // namespace
} // namespace ghost::app
