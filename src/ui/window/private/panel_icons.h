#pragma once
// SPDX-License-Identifier: Apache-2.0
// Small drawings of the panels, sharp at every scale: what a rail of buttons shows in place of words. In the
// colour of text, warm where the panel is open. Window thread.

#include <QIcon>

namespace ghost::ui {

// Of a panel by its name ("fixtures"); a square where none is drawn for it.
QIcon panel_icon(const QString& name);

} // namespace ghost::ui
