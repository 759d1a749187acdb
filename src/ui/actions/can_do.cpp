// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/can_do.h"

#include <algorithm>
#include <set>

namespace ghost::ui {
namespace {

const std::set<QString> kNeedNothing{
    "new",       "open",           "import-plot",   "open-demo",   "quit",  "screenshot",
    "shortcuts", "documentation",  "about",         "full-screen", "chips", "figures",
    "frame",     "names",          "addresses",     "aims",        "marks", "movers",
    "find",      "second-display", "second-window", "panels-dock"};
const std::set<QString> kNeedSelection{"select-none", "hold",  "select-similar", "duplicate", "remove",
                                       "unpatch",     "hang",  "distribute",     "align-x",   "align-y",
                                       "align-z",     "focus", "aim-through"};
const std::set<QString> kNeedEditable{"add-fixture", "duplicate", "remove",      "unpatch", "hang",
                                      "distribute",  "align-x",   "align-y",     "align-z", "set-stage",
                                      "add-model",   "add-hazer", "keep-camera", "save",    "fly-on-hoists"};

const std::set<QString> kEdits{"address",
                               "rename",
                               "mode",
                               "place",
                               "move",
                               "rotate",
                               "align",
                               "mover-address",
                               "move-object",
                               "nudge-left",
                               "nudge-right",
                               "nudge-up-stage",
                               "nudge-down-stage",
                               "set-plot",
                               "substitute",
                               "substitute-same",
                               "haze",
                               "clouds",
                               "cloud-size",
                               "wind",
                               "hazer",
                               "remove-hazer",
                               "bounce",
                               "camera-rename",
                               "camera-remove",
                               "save-as",
                               "cue-add",
                               "cue-set",
                               "cue-move",
                               "cue-remove",
                               "palette-store",
                               "palette-rename",
                               "palette-remove",
                               "look-store",
                               "look-capture",
                               "look-rename",
                               "look-fade",
                               "look-remove"};

} // namespace

bool is_edit(const std::string& name) {
    const QString action = QString::fromStdString(name);
    return kEdits.contains(action) || kNeedEditable.contains(action);
}

bool can_do(const QString& name, const AppModel& app, const ShowDocument& document) {
    if (name.startsWith("panel-") || name.startsWith("language-") || kNeedNothing.contains(name)) return true;
    if (name == "take-plot") return app.plot().number > 0;
    if (name == "cancel-jobs") return app.jobs().is_busy();
    if (!app.show()) return false;
    if (name == "undo") return app.undo_stack().canUndo();
    if (name == "redo") return app.undo_stack().canRedo();
    if (name == "take-changes" || name == "drop-changes") return document.has_draft();
    if (name == "take-over") return document.is_read_only();
    if (name == "save-picture") return app.picture().image != nullptr;
    if (name == "release")
        return std::any_of(app.selection().begin(), app.selection().end(),
                           [&](std::size_t one) { return app.look().fixtures.contains(one); });
    if (name == "release-all") return !app.look().is_empty();
    if (name == "camera-rename" || name == "camera-remove")
        return app.stored_camera() && document.can_edit() &&
               (name == "camera-rename" || app.show()->cameras.size() > 1);
    if (name == "solo") return !app.selection().empty() || !app.look().solo.empty();
    if (name == "play-recorded") return !app.recorded().file.empty() && !app.recorded().error;
    if (kNeedSelection.contains(name) && app.selection().empty()) return false;
    return !kNeedEditable.contains(name) || document.can_edit();
}

} // namespace ghost::ui
