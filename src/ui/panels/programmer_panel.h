#pragma once
// SPDX-License-Identifier: Apache-2.0
// ProgrammerPanel: the selected fixtures under the hand, beside DMX: intensity, colour, zoom, pan, tilt,
// gobo, palettes, and all other parameters of their heads. What is moved is set for all of them; what is not
// moved stays the desk's. Where they differ it says so. Window thread.

#include "ui/model/app_model.h"
#include "ui/model/head_parameters.h"
#include "ui/model/head_values.h"
#include "ui/panel_parts/fan_box.h"
#include "ui/panel_parts/palette_box.h"
#include "ui/widgets/colour_row.h"
#include "ui/widgets/parameter_row.h"
#include "ui/widgets/slot_picture.h"
#include "ui/widgets/value_row.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include <map>
#include <string>

namespace ghost::ui {

class ProgrammerPanel : public QWidget {
    Q_OBJECT
public:
    ProgrammerPanel(AppModel& app, PaletteList& palettes, Actions& actions, QWidget* parent);
    PaletteBox& palettes() { return *palettes_; }

private:
    struct Row {
        ValueRow* row;
        fixture::Role role;
        std::optional<float> fixture::Programmer::*value;
        float FixtureNow::*now;
        double per_unit; // of the row's number: 0.01 for percent
    };
    ValueRow* add_row(const QString& name, const ValueRange& range, int kind, fixture::Role role,
                      std::optional<float> fixture::Programmer::*value, float FixtureNow::*now,
                      double per_unit);
    bool is_by_hand(const Row& row, std::size_t fixture) const;
    // Each of the selected heads' own value of this word, from what it had when a hand began, by so much;
    // ends hold it back and give it free again.
    void move_each(const QString& name, const std::string& word, int kind, float by, bool begins);
    void refresh();
    void refresh_parameters();
    void set_reach(ValueRow& row, fixture::Role role, const fixture::AxisRange& otherwise);
    void take_kinds();
    void make_parameters();
    fixture::Programmer programmer_of(std::size_t fixture) const;

    AppModel& app_;
    std::map<std::size_t, HeadValue> before_; // of move_each
    QLabel* title_;
    QVBoxLayout* column_;
    std::vector<Row> rows_;
    ValueRow *zoom_, *pan_, *tilt_;
    ColourRow* colour_;
    SlotPictures pictures_;
    QLabel* gobo_label_;
    QComboBox* gobo_;
    PaletteBox* palettes_;
    FanBox* fan_;
    QPushButton *hold_, *release_, *release_all_;
    QWidget* parameter_box_ = nullptr;
    std::vector<HeadParameter> parameters_;
    std::vector<ParameterRow*> parameter_rows_;
    QTimer parameter_timer_; // what desks do with them is shown a few times a second
};

} // namespace ghost::ui
