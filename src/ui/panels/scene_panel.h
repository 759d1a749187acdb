#pragma once
// SPDX-License-Identifier: Apache-2.0
// ScenePanel: the air, the even light and the stage under the hand: smoke, even light and its colour,
// attenuation, shadows, samples; the objects of the stage; specular and roughness of their materials.
// Window thread.

#include "ui/model/app_model.h"
#include "ui/panel_parts/stage_tree.h"
#include "ui/widgets/colour_row.h"
#include "ui/widgets/value_row.h"

#include <QCheckBox>
#include <QPushButton>
#include <QWidget>

namespace ghost::ui {

class ScenePanel : public QWidget {
    Q_OBJECT
public:
    ScenePanel(AppModel& app, QWidget* parent);

Q_SIGNALS:
    void asks_for_air();                   // what the show says of it: AirPanel
    void asks_to_hang(std::size_t object); // the selected fixtures under it
    void asks_for(const QString& line);    // of a script

private:
    void add_air(QLayout* layout);
    void add_stage(QLayout* layout);
    void fill();
    void refresh();
    void change_attenuation(int factor, double value);
    std::optional<std::size_t> material() const; // of the object that is chosen

    AppModel& app_;
    ValueRow *smoke_, *ambient_, *samples_;
    ValueRow* attenuation_[3];
    ColourRow* colour_;
    QCheckBox* shadows_;
    StageTree* stage_;
    QPushButton* hang_;
    QPushButton* fly_;
    ValueRow *specular_, *shininess_;
};

} // namespace ghost::ui
