// SPDX-License-Identifier: Apache-2.0
#include "ui/notice_bar.h"

#include <QLabel>

namespace ghost::ui {

NoticeBar::NoticeBar(Actions& actions, ShowDocument& document, Studio& studio, QWidget* parent)
    : QToolBar("Notice", parent), actions_(actions), document_(document), studio_(studio) {
    connect(&studio_, &Studio::messages_came, this, &NoticeBar::look_at_messages);
    setObjectName("notice");
    setMovable(false);
    toggleViewAction()->setVisible(false);
    hide();
    connect(&document_, &ShowDocument::draft_found, this, [this](const QString& words) {
        ask(words, {{"Take them", "take-changes"}, {"Drop them", "drop-changes"}});
    });
    connect(&document_, &ShowDocument::found_changed_outside, this, [this](const QString& words) {
        ask(words, {{"Take what the file says", "reload"}, {"Save mine over it", "save over"}});
    });
    connect(&document_, &ShowDocument::found_gone, this, [this](const QString& words) {
        ask(words, {{"Save it there again", "save"}, {"Save a copy elsewhere...", "save-copy"}});
    });
    connect(&document_, &ShowDocument::found_held, this, [this](const QString& words) {
        ask(words, {{"Take it over", "take-over"}});
    });
    connect(&document_, &ShowDocument::save_failed, this, [this](const QString& words) {
        ask(words, {{"Try again", "save"}, {"Save a copy elsewhere...", "save-copy"}});
    });
    connect(&document_, &ShowDocument::keep_failed, this, [this](const QString& words) {
        ask(words, {{"Save a copy elsewhere...", "save-copy"}, {"Close and lose them", "quit anyway"}});
    });
    connect(&document_, &ShowDocument::changed, this, [this] {
        if (!document_.waits_for_answer()) hide();
    });
}

void NoticeBar::look_at_messages() {
    std::set<std::string> errors;
    QStringList anew;
    for (const scene::Message& message : studio_.messages()) {
        if (message.severity != scene::Severity::error) continue;
        if (errors.insert(message.what).second && !errors_.contains(message.what))
            anew << QString::fromStdString(message.where + ": " + message.what);
    }
    errors_ = std::move(errors);
    if (!studio_.opened().is_edit || anew.isEmpty()) return;
    const QString more = anew.size() == 1 ? QString() : QString(" (and %1 more)").arg(anew.size() - 1);
    ask("Since this edit: " + anew.front() + more, {{"Undo", "undo"}, {"All messages", "panel-messages on"}});
}

void NoticeBar::ask(const QString& words, const std::vector<std::pair<QString, QString>>& buttons_and_lines) {
    clear();
    auto* label = new QLabel(words, this);
    label->setContentsMargins(8, 0, 8, 0);
    addWidget(label);
    for (const auto& [text, line] : buttons_and_lines)
        connect(addAction(text), &QAction::triggered, this, [this, line = line] { actions_.choose(line); });
    show();
}

} // namespace ghost::ui
