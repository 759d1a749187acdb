// SPDX-License-Identifier: Apache-2.0
// The numbers of a fan are those that the heads have, whoever set them last.
#include "support/test_window.h"
#include "ui/actions/programmer_actions.h"
#include "ui/panel_parts/fan_box.h"

#include <QToolButton>
#include <QWidget>

namespace ghost::ui {
namespace {

TEST(FanBox, its_numbers_follow_undo_and_other_hands) {
    Bench bench;
    bench.open();
    QWidget widget;
    Actions actions(widget);
    add_fan_actions(actions, bench.app);
    FanBox box(bench.app, actions, nullptr);
    box.show();
    box.findChild<QToolButton*>()->setChecked(true);
    const auto combos = box.findChildren<QComboBox*>();
    combos[0]->setCurrentIndex(combos[0]->findData("intensity"));
    Q_EMIT combos[0]->activated(combos[0]->currentIndex());
    bench.app.select_in_order({0, 1, 2});
    settle();
    const auto numbers = box.findChildren<QDoubleSpinBox*>();
    ASSERT_EQ(numbers.size(), 2);
    QDoubleSpinBox &first = *numbers[0], &last = *numbers[1];
    last.setValue(80);
    ASSERT_EQ(bench.app.look().fixtures.at(2).intensity, 0.8f);
    EXPECT_EQ(bench.app.look().fixtures.at(1).intensity, 0.4f);
    wait_ms(1600); // a step of its own
    first.setValue(40);
    ASSERT_EQ(bench.app.look().fixtures.at(0).intensity, 0.4f);
    bench.app.undo_stack().undo();
    EXPECT_EQ(first.value(), 0) << "as the first one is again";
    EXPECT_EQ(last.value(), 80);
    last.setValue(60);
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 0.0f) << "what was undone stays so";
    change_selected(bench.app, "intensity", ProgrammerStep::step,
                    [](fixture::Programmer& programmer) { programmer.intensity = 0.25f; });
    EXPECT_EQ(first.value(), 25);
    EXPECT_EQ(last.value(), 25);
}

} // namespace
} // namespace ghost::ui
