#pragma once
// SPDX-License-Identifier: Apache-2.0
// Toast: for two seconds, over the picture, that something was done which nothing else shows, with a way back
// where there is one. It takes no focus and no key. Window thread.

#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class Toast : public QWidget {
    Q_OBJECT
public:
    // over: whose lower middle it stands in.
    explicit Toast(QWidget* over);
    // undo: none: no button. The newest one stays.
    void say(const QString& what, std::function<void()> undo = {});
    // What was said last, whether it still stands or not.
    QString words() const { return words_->text(); }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void place();

    QLabel* words_;
    QToolButton* undo_;
    std::function<void()> on_undo_;
    QTimer end_;
};

} // namespace ghost::ui
