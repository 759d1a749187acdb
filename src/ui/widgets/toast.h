#pragma once
// SPDX-License-Identifier: Apache-2.0
// Toast: for two seconds, over the picture, that something was done which nothing else shows, with a way back
// where there is one. It takes no focus and no key, but for the name that it was asked to ask for. While the
// mouse is on it, it stays. Window thread.

#include <QLabel>
#include <QLineEdit>
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
    // undo, name (of what was made: "Name..."): none: no button. The newest one stays.
    void say(const QString& what, std::function<void()> undo = {}, std::function<void()> name = {});
    // Whether the way back is that of what was said; else its button is grey.
    void allow_undo(bool allowed) { undo_->setEnabled(allowed); }
    // A line to write in, value in it: Enter takes it, Esc or going elsewhere leaves all as it is. done:
    // empty, or why not, which is said there, and it asks on.
    void ask(const QString& what, const QString& value, std::function<QString(const QString&)> done);
    // What was said last, whether it still stands or not.
    QString words() const { return words_->text(); }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void show_anew(const QString& what);
    void place();
    void take();
    void leave();

    QLabel* words_;
    QLineEdit* field_;
    QToolButton *name_, *undo_;
    std::function<void()> on_undo_, on_name_;
    std::function<QString(const QString&)> on_words_;
    QTimer end_;
    int stays_ms_;
};

} // namespace ghost::ui
