#pragma once
// SPDX-License-Identifier: Apache-2.0
// "bake house 64", "export-still big.png 3840x2160", "export-film clip.mp4 10 20" and so on. Window thread.

#include "ui/actions/actions.h"
#include "ui/actions/exporter.h"

#include <QSize>

namespace ghost::ui {

void add_export_actions(Actions& actions, AppModel& app, Exporter& exporter);

// "1920x1080", 16 to 8192 each way.
Result<QSize> size_of(const QString& words);
// What a still or a film can be of: such a size, of what the window sees, or a camera of the show.
Result<void> check_picture_of(const AppModel& app, const QString& words);

} // namespace ghost::ui
