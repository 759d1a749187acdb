#pragma once
// SPDX-License-Identifier: Apache-2.0
// ColourRow: one colour under the hand: its name, a button in that colour that opens a palette beside the
// work, and a button that gives it back. The palette stays open while other things are done. Window thread.

#include <QColor>
#include <QColorDialog>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QString>
#include <QToolButton>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class ColourRow : public QWidget {
    Q_OBJECT
public:
    ColourRow(const QString& name, QWidget* parent);
    ~ColourRow() override; // with its palette

    // by_hand: it is set by a person; else it is only shown. Does not call back.
    void show_colour(const QColor& colour, bool by_hand);
    std::function<void(const QColor&)> on_change; // a person chose it
    std::function<void()> on_release;

private:
    void open_palette();

    QString name_;
    QLabel* label_;
    QPushButton* button_;
    QToolButton* release_;
    QPointer<QColorDialog> palette_;
    QColor colour_;
};

} // namespace ghost::ui
