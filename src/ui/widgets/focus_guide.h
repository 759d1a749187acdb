#pragma once
// SPDX-License-Identifier: Apache-2.0
// FocusGuide: where the keyboard is: a ring round the control that has it; and the keys that fly work from
// every control that types nothing. Window thread.

#include <QFocusFrame>
#include <QObject>
#include <QPointer>
#include <QWidget>

namespace ghost::ui {

class FocusGuide : public QObject {
    Q_OBJECT
public:
    // view: gets the keys that fly.
    explicit FocusGuide(QWidget* view);
    ~FocusGuide() override; // with its ring

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void show_ring(QWidget* control);

    QWidget* view_;
    QPointer<QFocusFrame> ring_; // it lives beside the control, and goes with its panel
};

} // namespace ghost::ui
