// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/toast.h"

#include "ui/language/language.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>

#include <utility>

namespace ghost::ui {
namespace {

constexpr int kStays_ms = 2000, kStaysWithName_ms = 6000; // who wants to give a name reads first
constexpr int kAbove_px = 48;                             // the chips
constexpr int kLetters = 24;

} // namespace

Toast::Toast(QWidget* over)
    : QWidget(over), words_(new QLabel(this)), field_(new QLineEdit(this)), name_(new QToolButton(this)),
      undo_(new QToolButton(this)), stays_ms_(kStays_ms) {
    setObjectName("toast");
    setAttribute(Qt::WA_StyledBackground);
    setStyleSheet("#toast { background: rgba(20, 20, 22, 225); border: 1px solid #55555a; border-radius: "
                  "5px; } #toast QLabel { color: #dedede; }");
    name_->setText(translated("Notice", "Name..."));
    name_->setObjectName("name");
    undo_->setText(translated("Notice", "Undo"));
    undo_->setObjectName("undo");
    for (QToolButton* const button : {name_, undo_}) button->setFocusPolicy(Qt::NoFocus);
    field_->setMinimumWidth(kLetters * fontMetrics().averageCharWidth());
    field_->setAccessibleName(translated("Notice", "Name"));
    field_->installEventFilter(this);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 8, 6);
    for (QWidget* const one : std::initializer_list<QWidget*>{words_, field_, name_, undo_})
        layout->addWidget(one);
    connect(undo_, &QToolButton::clicked, this, [this] {
        hide();
        if (on_undo_) on_undo_();
    });
    connect(name_, &QToolButton::clicked, this, [this] {
        if (on_name_) on_name_();
    });
    connect(field_, &QLineEdit::returnPressed, this, &Toast::take);
    end_.setSingleShot(true);
    connect(&end_, &QTimer::timeout, this, &QWidget::hide);
    over->installEventFilter(this);
    hide();
}

void Toast::say(const QString& what, std::function<void()> undo, std::function<void()> name) {
    const bool had_focus = field_->hasFocus();
    on_words_ = nullptr;
    field_->hide();
    undo_->setVisible(static_cast<bool>(undo));
    undo_->setEnabled(true);
    name_->setVisible(static_cast<bool>(name));
    stays_ms_ = name ? kStaysWithName_ms : kStays_ms;
    on_undo_ = std::move(undo);
    on_name_ = std::move(name);
    show_anew(what);
    if (had_focus) parentWidget()->setFocus();
    if (!underMouse()) end_.start(stays_ms_);
}

void Toast::ask(const QString& what, const QString& value, std::function<QString(const QString&)> done) {
    end_.stop();
    undo_->hide();
    name_->hide();
    field_->setText(value);
    field_->show();
    show_anew(what);
    field_->selectAll();
    field_->setFocus();
    on_words_ = std::move(done);
}

void Toast::take() {
    if (!on_words_) return;
    const auto done = on_words_;
    if (const QString why_not = done(field_->text()); !why_not.isEmpty())
        show_anew(why_not);
    else if (on_words_) // nothing else was said meanwhile
        leave();
}

void Toast::leave() {
    on_words_ = nullptr;
    const bool had_focus = field_->hasFocus();
    hide();
    if (had_focus) parentWidget()->setFocus();
}

void Toast::show_anew(const QString& what) {
    words_->setText(what);
    place();
    show();
    raise();
}

void Toast::place() {
    adjustSize();
    move((parentWidget()->width() - width()) / 2, parentWidget()->height() - height() - kAbove_px);
}

void Toast::enterEvent(QEnterEvent* event) {
    QWidget::enterEvent(event);
    end_.stop();
}

void Toast::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    if (isVisible() && !on_words_) end_.start(stays_ms_);
}

bool Toast::eventFilter(QObject* object, QEvent* event) {
    if (object != field_) {
        if (event->type() == QEvent::Resize && isVisible()) place();
        return QWidget::eventFilter(object, event);
    }
    if (event->type() == QEvent::FocusOut && on_words_ &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason)
        leave();
    const bool is_key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!is_key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return QWidget::eventFilter(object, event);
    event->accept(); // it means this alone
    if (event->type() == QEvent::KeyPress) leave();
    return true;
}

} // namespace ghost::ui
