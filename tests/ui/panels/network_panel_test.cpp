// SPDX-License-Identifier: Apache-2.0
// The network panel where it is narrow: sources above the universe, so that both can be read.
#include "support/test_window.h"

#include "ui/panels/network_panel.h"
#include "ui/widgets/panel_area.h"
#include "ui/widgets/theme.h"

namespace ghost::ui {
namespace {

TEST(NetworkPanel, a_narrow_one_has_its_halves_one_above_the_other) {
    Bench bench;
    QWidget window;
    Actions actions(window);
    NetworkPanel panel(bench.app, actions, nullptr);
    panel.resize(1200, 400);
    panel.show();
    settle();
    const auto* sources = panel.findChild<QTableWidget*>();
    const auto* grid = panel.findChild<UniverseGrid*>();
    EXPECT_LT(sources->mapTo(&panel, QPoint(0, 0)).x(), grid->mapTo(&panel, QPoint(0, 0)).x());
    panel.resize(560, 400);
    settle();
    EXPECT_GT(grid->mapTo(&panel, QPoint(0, 0)).y(), sources->mapTo(&panel, QPoint(0, 0)).y() + 40);
    EXPECT_GT(sources->width(), 500);
    EXPECT_GT(grid->width(), 500);
    panel.resize(1200, 400);
    settle();
    EXPECT_LT(sources->width(), 700);
}

// In the panel below the picture of a small laptop.
TEST(NetworkPanel, however_much_is_wrong_the_levels_are_in_sight) {
    Bench bench;
    bench.open();
    QWidget window;
    Actions actions(window);
    auto* panel = new NetworkPanel(bench.app, actions, nullptr);
    PanelArea area(panel, nullptr);
    area.resize(1000, 260); // 1366x768, less the list beside it
    area.show();
    settle();
    const auto* grid = panel->findChild<UniverseGrid*>();
    const auto is_in_sight = [&] {
        const QWidget* const seen = grid->parentWidget(); // as much as there is room for
        return area.viewport()->rect().contains(
                   QRect(seen->mapTo(area.viewport(), QPoint(0, 0)), seen->size())) &&
               seen->height() >= 5 * grid->fontMetrics().height();
    };
    EXPECT_TRUE(is_in_sight());
    dmx::Statistics statistics; // nothing arrives, and much is to be said about why
    statistics.time = std::chrono::seconds(60);
    for (int k = 0; k < 12; ++k) {
        dmx::NetInterface one;
        one.name = "eth" + std::to_string(k);
        one.address = 0x0A000001 + (static_cast<std::uint32_t>(k) << 8);
        one.netmask = 0xFFFFFF00;
        one.running = true;
        statistics.interfaces.push_back(one);
    }
    bench.link.network.put(std::move(statistics));
    bench.link.on_news();
    settle();
    ASSERT_FALSE(bench.app.diagnosis().empty());
    const auto* sentences = panel->findChild<QScrollArea*>();
    ASSERT_TRUE(sentences && sentences->isVisible());
    const auto* label = sentences->findChild<QLabel*>();
    EXPECT_GT(label->height(), sentences->height()) << "it is scrolled";
    EXPECT_GE(sentences->height(), 2 * label->fontMetrics().height());
    EXPECT_TRUE(is_in_sight());
    // What is wrong in the colour for it, what to look at in that of all text.
    const auto& found = bench.app.diagnosis();
    EXPECT_EQ(label->text().count(bad().name()),
              std::count_if(found.begin(), found.end(), [](const auto& one) { return one.is_problem; }))
        << label->text().toStdString();
    EXPECT_GT(label->text().count("<p"), 2);
    EXPECT_TRUE(label->text().contains(">We listen on")) << label->text().toStdString();
}

TEST(NetworkPanel, every_level_can_be_read_and_those_of_the_selection_are_scrolled_to) {
    Bench bench;
    bench.open();
    QWidget window;
    Actions actions(window);
    NetworkPanel panel(bench.app, actions, nullptr);
    const auto* const grid = panel.findChild<UniverseGrid*>();
    for (const QSize& size : {QSize(1000, 260), {300, 600}, {1800, 500}}) {
        panel.resize(size);
        panel.show();
        settle();
        const QFontMetrics letters = grid->fontMetrics();
        EXPECT_GE(letters.height(), 11);
        for (const int slot : {0, 255, 511}) {
            EXPECT_GE(grid->cell(slot).width(), letters.horizontalAdvance("255") + 2) << size.width();
            EXPECT_GE(grid->cell(slot).height(), letters.height()) << size.width();
            EXPECT_TRUE(QRectF(grid->rect()).contains(grid->cell(slot))) << size.width();
        }
    }
}

} // namespace
} // namespace ghost::ui
