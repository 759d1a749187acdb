// SPDX-License-Identifier: Apache-2.0
#include "ui/panel_parts/rdm_box.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/fixture_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr int kMostHeads = 1000; // more would take longer than a frame
constexpr int kMostNamed = 3;
constexpr int kTable_px = 140;

QString state_of(const RdmHead& head) {
    return head.identifies     ? translated("RDM", "identifies itself")
           : head.messages > 0 ? translated("RDM", "is spoken to")
           : head.is_found     ? translated("RDM", "is found")
                               : translated("RDM", "waits");
}

} // namespace

QString words_of(const RdmNow& rdm, const scene::Show& show) {
    if (rdm.access == RdmAccess::off) return {};
    const auto found = std::count_if(rdm.heads.begin(), rdm.heads.end(),
                                     [](const RdmHead& head) { return head.is_found || head.messages > 0; });
    const auto messages = static_cast<long long>(rdm.messages);
    QString text =
        translated("RDM", "%1 of %2 fixtures were found by a desk, %n message(s)", nullptr, messages)
            .arg(found)
            .arg(rdm.heads.size());
    if (rdm.faults > 0) text += translated("RDM", ", %1 not understood").arg(rdm.faults);
    if (rdm.refused > 0) text += translated("RDM", ", %1 refused").arg(rdm.refused);
    int identify = 0;
    QStringList names;
    for (const RdmHead& head : rdm.heads) {
        if (!head.identifies || head.fixture >= show.fixtures.size()) continue;
        if (++identify <= kMostNamed) names.append(QString::fromStdString(show.fixtures[head.fixture].name));
    }
    if (identify > kMostNamed) names.append(translated("RDM", "%1 more").arg(identify - kMostNamed));
    if (identify > 0)
        text += translated("RDM", "; %1 identify themselves", nullptr, identify).arg(names.join(", "));
    return text;
}

RdmBox::RdmBox(AppModel& app, Actions& actions, QWidget* parent) : QWidget(parent), app_(app) {
    access_ = new QComboBox(this);
    access_->setAccessibleName("RDM");
    access_->addItems({translated("RDM", "off"), translated("RDM", "desks find and read"),
                       translated("RDM", "desks also set address, mode and name")});
    access_->setToolTip(translated("RDM", "Whether desks find the fixtures by RDM over Art-Net. What a desk "
                                          "sets is an edit of the show, which can be undone."));
    connect(access_, &QComboBox::activated, this,
            [&actions](int index) { actions.choose(QString("rdm ") + kRdmAccess[index]); });
    auto* label = new QLabel("RDM", this);
    label->setBuddy(access_);
    auto* line = new QHBoxLayout;
    line->addWidget(label);
    line->addWidget(access_, 1);
    words_ = new QLabel(this);
    words_->setWordWrap(true);
    heads_ = new QTableWidget(0, 5, this);
    heads_->setTabKeyNavigation(false); // Tab leaves it
    heads_->setAccessibleName(translated("RDM", "Fixtures as RDM devices"));
    heads_->setHorizontalHeaderLabels({translated("RDM", "Fixture"), "UID", translated("RDM", "Address"),
                                       translated("RDM", "Mode"), translated("RDM", "Is")});
    heads_->verticalHeader()->hide();
    heads_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    heads_->setSelectionBehavior(QAbstractItemView::SelectRows);
    heads_->setShowGrid(false);
    heads_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    heads_->horizontalHeader()->setStretchLastSection(true);
    heads_->setMaximumHeight(kTable_px);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(line);
    layout->addWidget(words_);
    layout->addWidget(heads_);
    connect(&app_, &AppModel::request_changed, this, &RdmBox::show_switch);
    connect(&app_, &AppModel::rdm_came, this, &RdmBox::refresh);
    connect(&app_, &AppModel::opened_show, this, &RdmBox::refresh);
    refresh();
}

void RdmBox::showEvent(QShowEvent*) {
    refresh();
}

void RdmBox::show_switch() {
    access_->setCurrentIndex(static_cast<int>(app_.request().rdm));
}

void RdmBox::refresh() {
    show_switch();
    const bool is_on = app_.rdm().access != RdmAccess::off && app_.show();
    heads_->setVisible(is_on);
    words_->setVisible(is_on);
    if (!is_on || !isVisible()) return;
    words_->setText(words_of(app_.rdm(), *app_.show()));
    fill_table();
}

void RdmBox::fill_table() {
    const std::vector<RdmHead>& heads = app_.rdm().heads;
    const std::vector<scene::PatchedFixture>& fixtures = app_.show()->fixtures;
    heads_->setRowCount(std::min(static_cast<int>(heads.size()), kMostHeads));
    for (int row = 0; row < heads_->rowCount(); ++row) {
        const RdmHead& head = heads[static_cast<std::size_t>(row)];
        if (head.fixture >= fixtures.size()) continue; // of an edit that is not open yet
        const scene::PatchedFixture& fixture = fixtures[head.fixture];
        const auto mode = static_cast<std::size_t>(std::max(fixture.mode, 0));
        const QStringList cells{
            QString::fromStdString(fixture.name),
            QString::fromStdString(head.uid),
            fixture.address > 0 ? address_words(fixture.universe, fixture.address)
                                : translated("Fixtures", "none"),
            fixture.type && mode < fixture.type->modes.size()
                ? QString::fromStdString(fixture.type->modes[mode].name)
                : QString(),
            state_of(head),
        };
        for (int column = 0; column < cells.size(); ++column) {
            QTableWidgetItem* item = heads_->item(row, column);
            if (!item) heads_->setItem(row, column, item = new QTableWidgetItem);
            if (item->text() != cells[column]) item->setText(cells[column]);
        }
    }
}

} // namespace ghost::ui
