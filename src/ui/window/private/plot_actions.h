#pragma once
// SPDX-License-Identifier: Apache-2.0
// What can be done about what a plot has: another fixture file for one that gives no light ([[substitute]] of
// the show, one step of the undo list), its fixtures selected, the page as text. A plot that was opened as it
// is becomes a show first. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/plot_report.h"
#include "ui/model/show_document.h"

#include <QObject>

#include <vector>

namespace ghost::ui {

struct Substitute {
    std::string wanted; // as the plot calls the file
    std::filesystem::path file;
    std::string mode; // empty: the one whose name is nearest
};

// Files of the fixtures that the show has, copied beside it if they lie elsewhere.
Result<void> substitute(AppModel& app, ShowDocument& document, const std::vector<Substitute>& all);

// "substitute FOR FILE [MODE]", "substitute-same", "plot-select", "plot-copy", "plot-text".
void add_plot_actions(Actions& actions, AppModel& app, ShowDocument& document, const PlotReport& report);

} // namespace ghost::ui
