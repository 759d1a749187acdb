// SPDX-License-Identifier: Apache-2.0
// The table of channels: what stands in its cells.
#include "support/test_window.h"
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

} // namespace
} // namespace ghost::ui
