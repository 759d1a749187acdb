#pragma once
// SPDX-License-Identifier: Apache-2.0
// StageTree: the objects of the stage with their materials, a box before each that hides and shows it, and a
// line to search them. Objects of a plot stand in its layers, and objects that are named alike but for a
// number at the end in one group: the box of a layer or group is that of all in it, and so is the box of any
// of several that are selected. What is chosen is marked in the picture. Window thread.

#include "ui/model/app_model.h"

#include <QLineEdit>
#include <QTreeWidget>
#include <QWidget>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ghost::ui {

class StageTree : public QWidget {
    Q_OBJECT
public:
    StageTree(AppModel& app, QWidget* parent);

    // The one that is chosen, of a group its first: index into Opened::objects.
    std::optional<std::size_t> object() const;
    // After the model opened a show or its text was edited.
    void fill();
    // After the look changed.
    void refresh();
    void choose(std::size_t object);
    void follow_mark();

Q_SIGNALS:
    void chose();

private:
    void add(QTreeWidgetItem* parent, std::size_t object);
    void add_groups(QTreeWidgetItem* parent, const std::vector<std::size_t>& objects);
    QTreeWidgetItem* add_group(QTreeWidgetItem* parent, const std::string& name, std::size_t count);
    void search(const QString& text);
    void take_box(QTreeWidgetItem* item);
    bool is_shown(std::size_t object) const;

    AppModel& app_;
    QLineEdit* search_;
    QTreeWidget* tree_;
    std::set<QString> open_;                       // groups, before they were made anew
    std::vector<std::array<std::string, 3>> rows_; // of each object: layer, name, material
    bool follows_ = false;
};

// "truss_front_12", "Truss 12", "Cube.012" -> "truss_front", "Truss", "Cube"; a name that is a number stays.
std::string without_number(const std::string& name);

} // namespace ghost::ui
