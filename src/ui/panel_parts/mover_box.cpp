// SPDX-License-Identifier: Apache-2.0
#include "ui/panel_parts/mover_box.h"

#include "show/show.h"
#include "ui/actions/actions.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/fixture_list.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <utility>

namespace ghost::ui {
namespace {

// "1.005"; "": no channel drives its first axis.
QString address_of(const scene::Mover& mover) {
    if (mover.axes.empty() || mover.axes.front().levels.empty()) return QString();
    const fixture::Address& first = mover.axes.front().levels.front();
    return address_words(first.universe, first.channel);
}

bool has_same_rows(const scene::Mover& a, const scene::Mover& b) {
    const auto is_same = [](const scene::MoverAxis& x, const scene::MoverAxis& y) {
        return x.name == y.name && x.is_angle == y.is_angle && x.low == y.low && x.high == y.high;
    };
    return a.name == b.name &&
           std::equal(a.axes.begin(), a.axes.end(), b.axes.begin(), b.axes.end(), is_same);
}

} // namespace

MoverBox::MoverBox(AppModel& app, QWidget* parent)
    : QGroupBox(translated("Movers", "Movers"), parent), app_(app), layout_(new QVBoxLayout(this)),
      as_machine_(new QCheckBox(translated("Movers", "As machines go"), this)) {
    as_machine_->setToolTip(translated(
        "Movers", "Within speed and acceleration of each; else at once where they are asked to be"));
    connect(as_machine_, &QCheckBox::clicked, this,
            [this](bool on) { Q_EMIT asks_for(on ? "motion machine" : "motion commanded"); });
    layout_->addWidget(as_machine_);
    connect(&app_, &AppModel::opened_show, this, &MoverBox::fill);
    for (const auto signal : {&AppModel::look_changed, &AppModel::rig_came, &AppModel::request_changed})
        connect(&app_, signal, this, &MoverBox::refresh);
    hide();
}

void MoverBox::fill() {
    const std::vector<scene::Mover> before = std::exchange(shown_, app_.show()->movers);
    // Who drags a slider or types an address goes on.
    if (app_.opened().is_edit &&
        std::equal(before.begin(), before.end(), shown_.begin(), shown_.end(), has_same_rows)) {
        for (std::size_t m = 0; m < shown_.size(); ++m) {
            auto* const address = heads_[m]->findChild<QLineEdit*>();
            if (address->text() == address_of(before[m])) address->setText(address_of(shown_[m]));
        }
        refresh();
        return;
    }
    for (const Row& row : rows_) delete row.row;
    rows_.clear();
    // One of them may have asked for what is shown now.
    for (QWidget* head : heads_) {
        head->hide();
        head->deleteLater();
    }
    heads_.clear();
    setVisible(!shown_.empty());
    for (std::size_t m = 0; m < shown_.size(); ++m) {
        add_head(m);
        for (std::size_t a = 0; a < shown_[m].axes.size(); ++a) add_row(m, a);
    }
    refresh();
}

void MoverBox::add_head(std::size_t mover) {
    const scene::Mover& of = app_.show()->movers[mover];
    const QString name = QString::fromStdString(of.name);
    auto* head = new QWidget(this);
    auto* line = new QHBoxLayout(head);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(new QLabel(name, head), 1);
    auto* address = new QLineEdit(address_of(of), head);
    address->setPlaceholderText(translated("Movers", "no address"));
    address->setAccessibleName(translated("Movers", "Address of %1").arg(name));
    address->setToolTip(translated(
        "Movers", "Universe.address of its first axis, 16 bits each; the others follow. Return sets it."));
    connect(address, &QLineEdit::editingFinished, this, [this, address, name, mover] {
        if (mover >= app_.show()->movers.size() || address->text() == address_of(app_.show()->movers[mover]))
            return;
        const QString asked = "mover-address " + quoted(name) + " " + quoted(address->text());
        address->setText(address_of(app_.show()->movers[mover])); // until the show has it
        Q_EMIT asks_for(asked);
    });
    line->addWidget(address);
    layout_->addWidget(head);
    heads_.push_back(head);
}

void MoverBox::add_row(std::size_t mover, std::size_t axis) {
    const scene::MoverAxis& of = app_.show()->movers[mover].axes[axis];
    const QString unit = of.is_angle ? "\u00b0" : " m";
    auto* row = new ValueRow(QString::fromStdString(of.name),
                             {static_cast<double>(of.low), static_cast<double>(of.high), 2, unit}, this);
    row->setToolTip(translated("Movers", "Of its way from %1 to %2%3; as the machine, within its speed")
                        .arg(static_cast<double>(of.low))
                        .arg(static_cast<double>(of.high))
                        .arg(unit));
    row->on_change = [this, mover, axis](double value) {
        std::vector<float> values = mover_goals(app_, mover);
        values[axis] = static_cast<float>(value);
        drive_mover(app_, mover, std::move(values));
    };
    row->on_release = [this, mover] { drive_mover(app_, mover, {}); };
    layout_->addWidget(row);
    rows_.push_back({mover, axis, row});
}

void MoverBox::refresh() {
    if (!app_.show()) return;
    const QSignalBlocker quiet(as_machine_);
    as_machine_->setChecked(app_.request().motion.value_or(app_.show()->motion) ==
                            fixture::Motion::as_the_machine);
    for (const Row& row : rows_) {
        const bool by_hand = app_.look().movers.contains(row.mover);
        std::vector<float> values;
        if (by_hand)
            values = mover_goals(app_, row.mover);
        else if (row.mover < app_.rig().movers.size())
            values = app_.rig().movers[row.mover].values;
        if (row.axis < values.size()) row.row->show_value(static_cast<double>(values[row.axis]), by_hand);
    }
}

} // namespace ghost::ui
