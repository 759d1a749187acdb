#pragma once
// SPDX-License-Identifier: Apache-2.0
// The actions that make a show, or go on with one elsewhere: "new FOLDER", "import-plot FILE.mvr", "save-as
// FILE", and what a program says of itself. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

namespace ghost::ui {

// Of the show folder that a plot becomes: beside it, called as it.
QString folder_for_plot(const QString& plot);
// The plot becomes a show folder in the background, which then is opened, or read again where it is; error:
// what is no plot.
Result<void> import_plot(AppModel& app, ShowDocument& document, const QString& plot);

// docs: folder of the guide; empty: it is not there.
void add_show_actions(Actions& actions, AppModel& app, ShowDocument& document, const std::string& docs,
                      QWidget& window);

} // namespace ghost::ui
