#pragma once
// SPDX-License-Identifier: Apache-2.0
// ColourRow: one colour under the hand: its name, a button in that colour that unfolds a field to choose in
// below it, and a button that gives it back. Window thread.

#include <QColor>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class ColourField;

class ColourRow : public QWidget {
    Q_OBJECT
public:
    ColourRow(const QString& name, QWidget* parent);

    // by_hand: it is set by a person; else it is only shown. mixed: others have other colours. Does not call
    // back.
    void show_colour(const QColor& colour, bool by_hand, bool mixed = false);
    std::function<void(const QColor&)> on_change; // a person chose it
    std::function<void()> on_release;

private:
    void unfold(bool on);

    QLabel* label_;
    QPushButton* button_;
    QToolButton* release_;
    ColourField* field_ = nullptr; // made when it is first wanted
    QVBoxLayout* column_;
    QColor colour_;
    bool mixed_ = false;
};

} // namespace ghost::ui
