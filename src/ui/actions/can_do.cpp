// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/can_do.h"

#include <algorithm>
#include <map>

namespace ghost::ui {
namespace {

const std::set<QString> kNeedNothing{"new",
                                     "open",
                                     "import-plot",
                                     "open-demo",
                                     "quit",
                                     "screenshot",
                                     "shortcuts",
                                     "documentation",
                                     "about",
                                     "full-screen",
                                     "chips",
                                     "figures",
                                     "frame",
                                     "names",
                                     "addresses",
                                     "aims",
                                     "marks",
                                     "movers",
                                     "find",
                                     "second-display",
                                     "second-window",
                                     "panels-dock",
                                     "in-browsers",
                                     "browsers",
                                     "browsers-control",
                                     "browsers-new-token",
                                     "browsers-away",
                                     "open-outside",
                                     "state",
                                     "reset-figures"};
const std::set<QString> kNeedSelection{"hold",    "select-similar", "duplicate",  "remove",
                                       "unpatch", "hang",           "distribute", "align-x",
                                       "align-y", "align-z",        "focus",      "aim-through"};
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

// Of these nothing but that a show is open.
const std::set<QString> kNeedShow{"aim",
                                  "align-values",
                                  "ambient",
                                  "attenuation",
                                  "auto-exposure",
                                  "bake",
                                  "baked",
                                  "black-out",
                                  "brighter",
                                  "camera",
                                  "camera-strip",
                                  "cancel-bounce",
                                  "choose-object",
                                  "colour",
                                  "cue",
                                  "cue-back",
                                  "cue-book",
                                  "cue-follow",
                                  "cue-go",
                                  "darker",
                                  "dolly",
                                  "export-book",
                                  "export-film",
                                  "export-paper",
                                  "export-sheet",
                                  "export-still",
                                  "exposure",
                                  "false-colour",
                                  "false-luminance",
                                  "false-lux",
                                  "fan",
                                  "fly",
                                  "fps",
                                  "freeze",
                                  "gel",
                                  "gobo",
                                  "hide-through",
                                  "input-automatic",
                                  "input-desk",
                                  "input-recording",
                                  "intensity",
                                  "jump",
                                  "lamp",
                                  "look",
                                  "look-before",
                                  "look-next",
                                  "look-recall",
                                  "loop",
                                  "master",
                                  "motion",
                                  "mover",
                                  "mover-back",
                                  "mover-on",
                                  "object",
                                  "orbit",
                                  "palette",
                                  "pan",
                                  "paperwork",
                                  "parameter",
                                  "play",
                                  "play-file",
                                  "play-own",
                                  "plot-copy",
                                  "plot-select",
                                  "plot-text",
                                  "probe",
                                  "rdm",
                                  "record",
                                  "reload",
                                  "resolution",
                                  "samples",
                                  "save-copy",
                                  "see-all",
                                  "select",
                                  "select-all",
                                  "shadows",
                                  "slide",
                                  "smoke",
                                  "surface",
                                  "tilt",
                                  "to-start",
                                  "tone",
                                  "turn",
                                  "wipe",
                                  "work-light",
                                  "zoom"};

using Condition = bool (*)(const AppModel&, const ShowDocument&);
const std::map<QString, Condition> kOfTheirOwn{
    {"take-plot", [](const AppModel& app, const ShowDocument&) { return app.plot().number > 0; }},
    {"cancel-jobs", [](const AppModel& app, const ShowDocument&) { return app.jobs().is_busy(); }},
};
bool has_something_chosen(const AppModel& app, const ShowDocument&) {
    return !app.selection().empty() || app.marked().has_value();
}
// With a show.
const std::map<QString, Condition> kOfTheirOwnInAShow{
    {"undo", [](const AppModel& app, const ShowDocument&) { return app.undo_stack().canUndo(); }},
    {"redo", [](const AppModel& app, const ShowDocument&) { return app.undo_stack().canRedo(); }},
    {"take-changes", [](const AppModel&, const ShowDocument& document) { return document.has_draft(); }},
    {"drop-changes", [](const AppModel&, const ShowDocument& document) { return document.has_draft(); }},
    {"take-over", [](const AppModel&, const ShowDocument& document) { return document.is_read_only(); }},
    {"save-picture", [](const AppModel& app, const ShowDocument&) { return app.picture().image != nullptr; }},
    {"select-none", has_something_chosen},
    {"nudge-left", has_something_chosen},
    {"nudge-right", has_something_chosen},
    {"nudge-up-stage", has_something_chosen},
    {"nudge-down-stage", has_something_chosen},
    {"release",
     [](const AppModel& app, const ShowDocument&) {
         return std::any_of(app.selection().begin(), app.selection().end(),
                            [&](std::size_t one) { return app.look().fixtures.contains(one); });
     }},
    {"release-all", [](const AppModel& app, const ShowDocument&) { return !app.look().is_empty(); }},
    {"camera-rename",
     [](const AppModel& app, const ShowDocument& document) {
         return app.stored_camera() && document.can_edit();
     }},
    {"camera-remove",
     [](const AppModel& app, const ShowDocument& document) {
         return app.stored_camera() && document.can_edit() && app.show()->cameras.size() > 1;
     }},
    {"solo", [](const AppModel& app,
                const ShowDocument&) { return !app.selection().empty() || !app.look().solo.empty(); }},
    {"play-recorded",
     [](const AppModel& app, const ShowDocument&) {
         return !app.recorded().file.empty() && !app.recorded().error;
     }},
};

bool needs_nothing(const QString& name) {
    return name.startsWith("panel-") || name.startsWith("language-") || kNeedNothing.contains(name);
}

} // namespace

bool is_edit(const std::string& name) {
    const QString action = QString::fromStdString(name);
    return kEdits.contains(action) || kNeedEditable.contains(action);
}

bool can_do(const QString& name, const AppModel& app, const ShowDocument& document) {
    if (needs_nothing(name)) return true;
    if (const auto own = kOfTheirOwn.find(name); own != kOfTheirOwn.end()) return own->second(app, document);
    if (!app.show()) return false;
    if (const auto own = kOfTheirOwnInAShow.find(name); own != kOfTheirOwnInAShow.end())
        return own->second(app, document);
    if (kNeedSelection.contains(name) && app.selection().empty()) return false;
    return !kNeedEditable.contains(name) || document.can_edit();
}

std::set<QString> listed_actions() {
    std::set<QString> all;
    for (const std::set<QString>* const list :
         {&kNeedNothing, &kNeedShow, &kNeedSelection, &kNeedEditable, &kEdits})
        all.insert(list->begin(), list->end());
    for (const auto* const list : {&kOfTheirOwn, &kOfTheirOwnInAShow})
        for (const auto& [name, condition] : *list) all.insert(name);
    return all;
}

} // namespace ghost::ui
