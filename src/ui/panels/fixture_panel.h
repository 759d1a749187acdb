#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixturePanel: all fixtures with their patch and what they do now, a line to search in, and the selection,
// the same as in the picture. Cells of the patch are edited where they stand; what is typed goes to all that
// are selected. Window thread.

#include "ui/actions/patch_edit.h"
#include "ui/model/fixture_groups.h"
#include "ui/model/fixture_list.h"
#include "ui/widgets/fixture_table.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QWidget>

namespace ghost::ui {

class FixturePanel : public QWidget {
    Q_OBJECT
public:
    FixturePanel(AppModel& app, ShowDocument& document, QWidget* parent);
    void find() { search_->setFocus(); }
    FixtureTable* table() { return table_; }
    // By index; nothing: the list is out of sight, or has all.
    std::optional<std::set<std::size_t>> listed() const;

    // What an edit that cannot be done says.
    std::function<void(const Error&)> complain;

private:
    Result<void> edit(FixtureList::Column column, const QString& words);
    void show_selection();
    void take_selection();
    void list_groups();
    void show_group();
    void count();

    AppModel& app_;
    ShowDocument& document_;
    QLabel* title_;
    QLineEdit* search_;
    QComboBox* group_;
    QToolButton* dark_;
    std::vector<FixtureGroup> groups_;
    FixtureTable* table_;
    FixtureList* list_;
    FixtureFilter* sorted_;
    QElapsedTimer since_reset_; // of the rows, until lamps are as the show has them
    bool follows_ = false;      // the table is being changed by the model
};

} // namespace ghost::ui
