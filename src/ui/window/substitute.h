#pragma once
// SPDX-License-Identifier: Apache-2.0
// Substitutes for fixture files of a plot that say nothing of their light: which files they are, which could
// stand in, and a window to choose in; what is chosen is a [[substitute]] of the show, one step of the undo
// list. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

#include <QDialog>
#include <QTableWidget>

namespace ghost::ui {

// file: of the fixtures that the show has, copied beside it if it lies elsewhere.
Result<void> substitute(AppModel& app, ShowDocument& document, const std::string& wanted,
                        const std::filesystem::path& file);

class SubstituteDialog : public QDialog {
    Q_OBJECT
public:
    // library: folder with more fixture files; empty: there is none.
    SubstituteDialog(Actions& actions, AppModel& app, const std::string& library, QWidget* parent);

private:
    void fill();

    Actions& actions_;
    AppModel& app_;
    std::filesystem::path library_;
    QTableWidget* table_;
};

// "substitute": the window; "substitute FOR FILE": done at once.
void add_substitute_action(Actions& actions, AppModel& app, ShowDocument& document,
                           const std::string& library, QWidget& window);

} // namespace ghost::ui
