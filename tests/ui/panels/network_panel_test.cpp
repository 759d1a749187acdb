// SPDX-License-Identifier: Apache-2.0
// The network panel where it is narrow: sources above the universe, so that both can be read.
#include "support/test_window.h"

#include "ui/panels/network_panel.h"

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

} // namespace
} // namespace ghost::ui
