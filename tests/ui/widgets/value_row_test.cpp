// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/value_row.h"

#include <QCoreApplication>
#include <QKeyEvent>

#include <gtest/gtest.h>

namespace ghost::ui {
namespace {

void type(QWidget& field, const QString& digits) {
    for (const QChar digit : digits) {
        QKeyEvent event(QEvent::KeyPress, digit.unicode(), Qt::NoModifier, QString(digit));
        QCoreApplication::sendEvent(&field, &event);
    }
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QCoreApplication::sendEvent(&field, &enter);
}

// A desk has it at 100 %, and a hand wants it to stay there.
TEST(ValueRow, the_number_that_is_there_already_is_taken_when_it_is_typed) {
    ValueRow row("Intensity", {.low = 0, .high = 100, .decimals = 0, .unit = " %"}, nullptr);
    std::vector<double> asked;
    row.on_change = [&](double value) { asked.push_back(value); };
    row.show_value(100, false);
    auto* const field = row.findChild<MixedSpinBox*>();
    field->selectAll();
    type(*field, "100");
    EXPECT_EQ(asked, std::vector<double>{100});
    field->selectAll();
    type(*field, "50");
    EXPECT_EQ(asked, (std::vector<double>{100, 50}));
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QCoreApplication::sendEvent(field, &enter);
    EXPECT_EQ(asked.size(), 2u) << "nothing was typed";
}

} // namespace
} // namespace ghost::ui
