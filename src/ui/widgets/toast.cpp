// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/toast.h"

#include "ui/language/language.h"

#include <QEvent>
#include <QHBoxLayout>

namespace ghost::ui {
namespace {

constexpr int kStays_ms = 2000;
constexpr int kAbove_px = 48; // the chips

} // namespace

Toast::Toast(QWidget* over) : QWidget(over), words_(new QLabel(this)), undo_(new QToolButton(this)) {
    setObjectName("toast");
    setAttribute(Qt::WA_StyledBackground);
    setStyleSheet("#toast { background: rgba(20, 20, 22, 225); border: 1px solid #55555a; border-radius: "
                  "5px; } #toast QLabel { color: #dedede; }");
    undo_->setText(translated("Notice", "Undo"));
    undo_->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 8, 6);
    layout->addWidget(words_);
    layout->addWidget(undo_);
    connect(undo_, &QToolButton::clicked, this, [this] {
        hide();
        if (on_undo_) on_undo_();
    });
    end_.setSingleShot(true);
    connect(&end_, &QTimer::timeout, this, &QWidget::hide);
    over->installEventFilter(this);
    hide();
}

void Toast::say(const QString& what, std::function<void()> undo) {
    words_->setText(what);
    undo_->setVisible(static_cast<bool>(undo));
    on_undo_ = std::move(undo);
    place();
    show();
    raise();
    end_.start(kStays_ms);
}

void Toast::place() {
    adjustSize();
    move((parentWidget()->width() - width()) / 2, parentWidget()->height() - height() - kAbove_px);
}

bool Toast::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QWidget::eventFilter(object, event);
}

} // namespace ghost::ui
