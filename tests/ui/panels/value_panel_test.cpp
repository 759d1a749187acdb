// SPDX-License-Identifier: Apache-2.0
// The table of channels: what stands in its cells, and of which head.
#include "support/test_desk.h"
#include "ui/panels/value_panel.h"

namespace ghost::ui {
namespace {

// As it is beside the picture of a window of 1366 or 2560 pixels.
TEST(ValuePanel, a_narrow_one_shows_what_a_channel_means_before_its_address) {
    Bench bench;
    ValuePanel panel(bench.app, nullptr);
    const auto* const table = panel.findChild<QTableView*>();
    const int letter_px = panel.fontMetrics().averageCharWidth();
    for (const bool is_narrow : {true, false, true}) {
        panel.resize((is_narrow ? 42 : 60) * letter_px, 400);
        panel.show();
        settle();
        EXPECT_EQ(table->isColumnHidden(ChannelModel::address), is_narrow);
        EXPECT_GE(table->viewport()->width() - table->columnViewportPosition(ChannelModel::meaning),
                  12 * letter_px);
    }
}

// The engine's words about a head of the show that it draws: its name is its only channel.
void explain(Desk& desk, const scene::Show& drawn, std::size_t fixture) {
    Explained news;
    news.fixture = fixture;
    news.explanation.fixture = drawn.fixtures[fixture].name;
    news.explanation.verdict = "about " + news.explanation.fixture;
    news.explanation.channels.emplace_back().attribute = news.explanation.fixture;
    news.words = news.explanation.verdict;
    desk.link.explained.put(std::move(news));
    desk.link.on_news();
    settle();
}

TEST(ValuePanel, says_nothing_of_a_neighbour_while_an_edit_is_read) {
    Desk desk;
    ValuePanel panel(desk.app, nullptr);
    desk.open();
    const std::shared_ptr<const scene::Show> drawn = desk.app.show();
    const auto* const table = panel.findChild<QTableView*>()->model();
    const auto about = [&] { return table->index(0, ChannelModel::attribute).data().toString(); };
    const auto title = [&] { return panel.findChildren<QLabel*>().at(0)->text(); };
    desk.app.select({1});
    explain(desk, *drawn, 1);
    ASSERT_EQ(title(), "Lamp 2");
    ASSERT_EQ(about(), "Lamp 2");
    desk.app.select({2});
    EXPECT_EQ(title(), "Lamp 3");
    EXPECT_EQ(table->rowCount(), 0) << "nothing is known of it yet";
    explain(desk, *drawn, 2);
    EXPECT_EQ(about(), "Lamp 3");

    desk.app.select({0});
    ASSERT_TRUE(desk.edit.remove().ok());
    desk.app.select({0});
    ASSERT_EQ(desk.app.show()->fixtures.size(), 2u);
    EXPECT_EQ(title(), "Lamp 2");
    EXPECT_EQ(table->rowCount(), 0);
    explain(desk, *drawn, 0);
    EXPECT_EQ(table->rowCount(), 0) << "that was said of the lamp that is gone";
    explain(desk, *drawn, 1); // the engine knows whom the request means
    EXPECT_EQ(about(), "Lamp 2");
    desk.app.undo_stack().undo();
    desk.app.select({1});
    EXPECT_EQ(title(), "Lamp 2");
    EXPECT_EQ(about(), "Lamp 2") << "its number is another one, it is the same";
    desk.app.select({0});
    EXPECT_EQ(table->rowCount(), 0);
    desk.app.undo_stack().redo();
    desk.follow();
    desk.app.select({1});
    explain(desk, *drawn, 1); // late, of the show before
    EXPECT_EQ(title(), "Lamp 3");
    EXPECT_EQ(table->rowCount(), 0);
}

TEST(ValuePanel, says_what_holds_a_head_back_that_its_desk_knows_nothing_of) {
    Desk desk;
    ValuePanel panel(desk.app, nullptr);
    desk.open();
    desk.app.select({1});
    explain(desk, *desk.app.show(), 1);
    const auto verdict = [&] { return panel.findChildren<QLabel*>().at(1)->text(); };
    EXPECT_EQ(verdict(), "about Lamp 2");
    desk.app.change_request([](ViewRequest& request) { request.black_out = true; });
    EXPECT_EQ(verdict(), "BLACK-OUT: nothing shines until it ends (B)");
    desk.app.change_request([](ViewRequest& request) {
        request.black_out = false;
        request.master = 0;
    });
    EXPECT_EQ(verdict(), "The master is at 0 %: nothing shines");
    desk.app.change_request([](ViewRequest& request) { request.master = 0.5f; });
    EXPECT_EQ(verdict(), "about Lamp 2");
    Look look;
    look.solo = {0};
    desk.app.set_look(look, "Solo");
    EXPECT_EQ(verdict(), "Others are solo: this one is dark until they are not");
    look.solo = {0, 1};
    desk.app.set_look(look, "Solo");
    EXPECT_EQ(verdict(), "about Lamp 2");
}

TEST(ChannelModel, levels_of_a_look_stand_in_the_column_of_hands_where_nothing_else_does) {
    scene::Explanation explanation;
    for (const char* const name : {"Dimmer", "Pan"}) {
        scene::ChannelFacts& channel = explanation.channels.emplace_back();
        channel.name = name;
        channel.places.resize(1);
    }
    explanation.channels[0].role = fixture::Role::dimmer;
    std::vector<fixture::ChannelReading> levels(2);
    levels[0].raw = 51;
    levels[1].raw = 255;
    fixture::Programmer programmer;
    programmer.levels = {51, 255};
    ChannelModel model(nullptr);
    const auto by_hand = [&](int row) { return model.index(row, ChannelModel::by_hand).data().toString(); };
    model.show(explanation, programmer, levels);
    EXPECT_EQ(by_hand(0), "20 %");
    EXPECT_EQ(by_hand(1), "100 %");
    programmer.intensity = 0.5f;
    model.show(explanation, programmer, levels);
    EXPECT_EQ(by_hand(0), "50 %");
    model.show(explanation, {}, {});
    EXPECT_EQ(by_hand(1), "");
}

} // namespace
} // namespace ghost::ui
