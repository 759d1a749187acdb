// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/message_panel.h"

#include "diagnose/doctor.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/wrapped_text.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHeaderView>
#include <QRegularExpression>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <set>
#include <string>

namespace ghost::ui {
namespace {

constexpr float kAround_m = 2; // of a fixture that is looked at

} // namespace

MessagePanel::MessagePanel(AppModel& app, QWidget* parent) : QWidget(parent), app_(app) {
    list_ = new QTreeWidget(this);
    list_->setHeaderLabels({"", translated("Messages", "What"), translated("Messages", "Where"),
                            translated("Messages", "What to do")});
    list_->setAccessibleName(translated("Messages", "Messages"));
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->setWordWrap(true);
    list_->setTextElideMode(Qt::ElideMiddle); // paths have their file last
    list_->setItemDelegate(new WrappedText(list_));
    const int letter = list_->fontMetrics().averageCharWidth();
    for (const auto& [column, letters] : {std::pair{0, 10}, {2, 20}})
        list_->setColumnWidth(column, letters * letter);
    for (const int column : {1, 3}) list_->header()->setSectionResizeMode(column, QHeaderView::Stretch);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(list_);
    for (const auto signal : {&AppModel::messages_came, &AppModel::not_opened, &AppModel::opened_show})
        connect(&app_, signal, this, &MessagePanel::refresh);
    connect(list_, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) { go_to(*item); });
    list_->setToolTip(
        translated("Messages", "Double click or Enter: the fixtures that it is about, else the file."));
}

// What it names in quotes is selected and looked at; where that is no fixture, the file is opened.
void MessagePanel::go_to(const QTreeWidgetItem& item) {
    static const QRegularExpression kQuoted("'([^']+)'");
    std::set<std::string> names;
    for (auto found = kQuoted.globalMatch(item.text(1) + " " + item.text(2)); found.hasNext();)
        names.insert(found.next().captured(1).toStdString());
    std::set<std::size_t> fixtures;
    for (std::size_t i = 0; app_.show() && i < app_.show()->fixtures.size(); ++i)
        if (names.contains(app_.show()->fixtures[i].name)) fixtures.insert(i);
    if (!fixtures.empty()) {
        app_.select(fixtures);
        if (const std::size_t first = *fixtures.begin(); first < app_.rig().fixtures.size())
            app_.look_at(app_.rig().fixtures[first].light_m, kAround_m);
        return;
    }
    static const QRegularExpression kLine(":\\d+$"); // "show.toml:12"
    const QFileInfo file(item.text(2).remove(kLine));
    if (file.exists()) QDesktopServices::openUrl(QUrl::fromLocalFile(file.absoluteFilePath()));
}

void MessagePanel::refresh() {
    std::vector<scene::Finding> findings;
    // Of a show that could not be opened, however long ago: the newest thing first.
    static const QRegularExpression kInFile(":\\d+$"); // a line of it is wrong
    if (const auto& error = app_.open_error())
        findings.push_back({.severity = Severity::error,
                            .kind = "not_opened",
                            .where = error->where,
                            .what = "Not opened: " + error->what,
                            .advice = QString::fromStdString(error->where).contains(kInFile)
                                          ? "mend the file and open it again"
                                          : ""});
    for (const Message& message : app_.messages()) findings.push_back(scene::finding_of(message));
    list_->clear();
    for (const scene::FindingGroup& group : scene::grouped(findings)) {
        const scene::Finding& first = group.first;
        auto* item = new QTreeWidgetItem(list_);
        item->setText(0, said(scene::name_of(first.severity)));
        const QColor colour = first.severity == Severity::error     ? bad()
                              : first.severity == Severity::warning ? accent()
                                                                    : faint();
        item->setForeground(0, colour);
        const QString what = said(first.what);
        item->setText(1, group.times > 1 ? translated("Messages", "%1 (%2 times)").arg(what).arg(group.times)
                                         : what);
        item->setText(2, QString::fromStdString(first.where));
        item->setText(3, said(first.advice));
        for (int column = 1; column < 4; ++column) item->setToolTip(column, item->text(column));
    }
    if (list_->topLevelItemCount() > 0) return;
    auto* item = new QTreeWidgetItem(list_);
    item->setText(1, translated("Messages", "Nothing is wrong with this show."));
    item->setForeground(1, good());
}

} // namespace ghost::ui
