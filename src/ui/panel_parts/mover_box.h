#pragma once
// SPDX-License-Identifier: Apache-2.0
// MoverBox: the show's movers under the hand: the channel of each, and its axes, one row each, between their
// end stops; and whether they go as machines do. Hidden where the show has none. Window thread.

#include "show/movers.h"
#include "ui/model/app_model.h"
#include "ui/widgets/value_row.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QLineEdit>
#include <QVBoxLayout>

#include <cstddef>
#include <vector>

namespace ghost::ui {

class MoverBox : public QGroupBox {
    Q_OBJECT
public:
    MoverBox(AppModel& app, QWidget* parent);

Q_SIGNALS:
    void asks_for(const QString& line); // of a script

private:
    struct Row {
        std::size_t mover = 0, axis = 0;
        ValueRow* row = nullptr;
    };
    void fill();
    void refresh();
    void add_head(std::size_t mover);
    void add_row(std::size_t mover, std::size_t axis);

    AppModel& app_;
    QVBoxLayout* layout_;
    QCheckBox* as_machine_;
    std::vector<QWidget*> heads_; // of each mover: its name and address
    std::vector<Row> rows_;
    std::vector<scene::Mover> shown_;
};

} // namespace ghost::ui
