// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/mover_box.h"

#include "show/show.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"

namespace ghost::ui {

MoverBox::MoverBox(AppModel& app, QWidget* parent)
    : QGroupBox(translated("Movers", "Movers"), parent), app_(app), layout_(new QVBoxLayout(this)) {
    connect(&app_, &AppModel::opened_show, this, &MoverBox::fill);
    for (const auto signal : {&AppModel::look_changed, &AppModel::rig_came})
        connect(&app_, signal, this, &MoverBox::refresh);
    hide();
}

std::vector<float> MoverBox::values_of(std::size_t mover) const {
    const auto by_hand = app_.look().movers.find(mover);
    if (by_hand != app_.look().movers.end()) return by_hand->second;
    if (mover < app_.rig().movers.size()) return app_.rig().movers[mover];
    return {};
}

void MoverBox::fill() {
    for (const Row& row : rows_) delete row.row;
    rows_.clear();
    const std::vector<scene::Mover>& movers = app_.show()->movers;
    setVisible(!movers.empty());
    for (std::size_t m = 0; m < movers.size(); ++m)
        for (std::size_t a = 0; a < movers[m].axes.size(); ++a) {
            const scene::MoverAxis& axis = movers[m].axes[a];
            const QString unit = axis.is_angle ? translated("Value", " deg") : " m";
            const QString name = QString::fromStdString(
                movers[m].axes.size() == 1 ? movers[m].name : movers[m].name + ", " + axis.name);
            auto* row = new ValueRow(
                name, {static_cast<double>(axis.low), static_cast<double>(axis.high), 2, unit}, this);
            row->setToolTip(
                translated("Movers", "Of its way from %1 to %2%3; as the machine, within its speed")
                    .arg(static_cast<double>(axis.low))
                    .arg(static_cast<double>(axis.high))
                    .arg(unit));
            row->on_change = [this, m, a](double value) {
                std::vector<float> values = values_of(m);
                values.resize(app_.show()->movers[m].axes.size());
                values[a] = static_cast<float>(value);
                drive_mover(app_, m, std::move(values));
            };
            row->on_release = [this, m] { drive_mover(app_, m, {}); };
            layout_->addWidget(row);
            rows_.push_back({m, a, row});
        }
    refresh();
}

void MoverBox::refresh() {
    for (const Row& row : rows_) {
        const std::vector<float> values = values_of(row.mover);
        if (row.axis < values.size())
            row.row->show_value(static_cast<double>(values[row.axis]),
                                app_.look().movers.contains(row.mover));
    }
}

} // namespace ghost::ui
