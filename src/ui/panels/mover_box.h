#pragma once
// SPDX-License-Identifier: Apache-2.0
// MoverBox: the axes of the show's movers under the hand, one row each, between their end stops. Hidden where
// the show has none. Window thread.

#include "ui/model/app_model.h"
#include "ui/widgets/value_row.h"

#include <QGroupBox>
#include <QVBoxLayout>

#include <cstddef>
#include <vector>

namespace ghost::ui {

class MoverBox : public QGroupBox {
    Q_OBJECT
public:
    MoverBox(AppModel& app, QWidget* parent);

private:
    struct Row {
        std::size_t mover = 0, axis = 0;
        ValueRow* row = nullptr;
    };
    void fill();
    void refresh();
    // By hand, else what drives them.
    std::vector<float> values_of(std::size_t mover) const;

    AppModel& app_;
    QVBoxLayout* layout_;
    std::vector<Row> rows_;
};

} // namespace ghost::ui
