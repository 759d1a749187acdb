// SPDX-License-Identifier: Apache-2.0
#include "ui/message_panel.h"

#include "scene/doctor.h"
#include "ui/theme.h"

#include <QHeaderView>
#include <QVBoxLayout>

namespace ghost::ui {

MessagePanel::MessagePanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {
    list_ = new QTreeWidget(this);
    list_->setHeaderLabels({"", "What", "Where", "What to do"});
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->setWordWrap(true);
    const int letter = list_->fontMetrics().averageCharWidth();
    for (const auto& [column, letters] : {std::pair{0, 10}, {1, 60}, {2, 30}})
        list_->setColumnWidth(column, letters * letter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(list_);
    connect(&studio_, &Studio::messages_came, this, &MessagePanel::refresh);
}

void MessagePanel::refresh() {
    std::vector<scene::Finding> findings;
    for (const scene::Message& message : studio_.messages()) findings.push_back(scene::finding_of(message));
    list_->clear();
    for (const scene::FindingGroup& group : scene::grouped(findings)) {
        const scene::Finding& first = group.first;
        auto* item = new QTreeWidgetItem(list_);
        item->setText(0, scene::name_of(first.severity));
        const QColor colour = first.severity == scene::Severity::error     ? bad()
                              : first.severity == scene::Severity::warning ? accent()
                                                                           : faint();
        item->setForeground(0, colour);
        QString what = QString::fromStdString(first.what);
        if (group.times > 1) what += QString(" (%1 times)").arg(group.times);
        item->setText(1, what);
        item->setText(2, QString::fromStdString(first.where));
        item->setText(3, QString::fromStdString(first.advice));
        for (int column = 1; column < 4; ++column) item->setToolTip(column, item->text(column));
    }
    if (list_->topLevelItemCount() > 0) return;
    auto* item = new QTreeWidgetItem(list_);
    item->setText(1, "Nothing is wrong with this show.");
    item->setForeground(1, good());
}

} // namespace ghost::ui
