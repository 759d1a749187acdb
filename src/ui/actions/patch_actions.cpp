// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/patch_actions.h"

#include "dmx/wire/universes.h"
#include "show/camera_moves.h"
#include "show/show.h"
#include "ui/actions/hang_edit.h"
#include "ui/language/language.h"

namespace ghost::ui {
namespace {

constexpr const char* kModels =
    QT_TRANSLATE_NOOP("Files", "Models (*.glb *.gltf *.obj *.3ds);;All files (*)");
constexpr float kLowestHead_m = 3; // of a new one where nothing carries it

Result<glm::vec3> vector_of(const QStringList& words, const char* what, double most) {
    glm::vec3 numbers{0};
    for (int i = 0; i < 3; ++i) {
        TRY(const double number, number_of(words, i, what, -most, most));
        numbers[i] = static_cast<float>(number);
    }
    return numbers;
}

using PatchRun = std::function<Result<void>(PatchEdit& edit, const QStringList& words)>;

} // namespace

Result<fixture::Address> address_of(const QString& words) {
    if (words == "none") return fixture::Address{1, 0};
    const QStringList parts = words.split('.');
    bool has_universe = true, has_channel = false;
    const int universe = parts.size() == 2 ? parts[0].toInt(&has_universe) : 1;
    const int channel = parts.last().toInt(&has_channel);
    if (parts.size() > 2 || !has_universe || !has_channel || universe < 1 || universe > dmx::kMaxUniverse ||
        channel < 1 || channel > 512)
        return Error{"'" + words.toStdString() +
                         "' is no address like 2.101 (universe 1 to 63999, channel 1 to 512), nor 'none'",
                     ""};
    return fixture::Address{universe, channel};
}

void add_patch_actions(Actions& actions, AppModel& app, ShowDocument& document) {
    const auto add = [&](const QString& name, const QString& text, const QString& key,
                         const QString& arguments, const PatchRun& run, const FileQuestion& asks = {}) {
        actions.add({name,
                     text.isEmpty() ? "" : "Edit",
                     text.isEmpty() ? name : text,
                     key,
                     arguments,
                     [&app, &document, run](const QStringList& words) -> Result<void> {
                         PatchEdit edit(app, document);
                         return run(edit, words);
                     },
                     {},
                     asks});
    };
    add("address", "", "", "UNIVERSE.CHANNEL|none",
        [](PatchEdit& edit, const QStringList& words) -> Result<void> {
            TRY(const fixture::Address address, address_of(words.value(0)));
            return edit.set_address(address);
        });
    add("rename", "", "", "NAME",
        [](PatchEdit& edit, const QStringList& words) { return edit.rename(words.value(0)); });
    add("mode", "", "", "NAME",
        [](PatchEdit& edit, const QStringList& words) { return edit.set_mode(words.value(0)); });
    add("place", "", "", "X Y Z", [](PatchEdit& edit, const QStringList& words) -> Result<void> {
        TRY(const glm::vec3 place_m, vector_of(words, "metres", scene::kMaxCoordinate_m));
        return edit.set_position(place_m);
    });
    add("move", "", "", "X Y Z", [](PatchEdit& edit, const QStringList& words) -> Result<void> {
        TRY(const glm::vec3 by_m, vector_of(words, "metres", scene::kMaxCoordinate_m));
        return edit.move_by(by_m);
    });
    add("rotate", "", "", "X Y Z", [](PatchEdit& edit, const QStringList& words) -> Result<void> {
        TRY(const glm::vec3 turn_deg, vector_of(words, "degrees", 360));
        return edit.set_rotation(turn_deg);
    });
    add("align", "", "", "x|y|z", [](PatchEdit& edit, const QStringList& words) -> Result<void> {
        const int axis = static_cast<int>(QString("xyz").indexOf(words.value(0)));
        if (words.value(0).size() != 1 || axis < 0) return Error{"align: expected x, y or z", ""};
        return edit.align(axis);
    });
    for (const int axis : {0, 1, 2})
        add(QString("align-") + "xyz"[axis], translated("Action", "Align %1 with the first").arg("XYZ"[axis]),
            "", "", [axis](PatchEdit& edit, const QStringList&) { return edit.align(axis); });
    add("distribute", translated("Action", "Spread evenly"), "", "",
        [](PatchEdit& edit, const QStringList&) { return edit.distribute(); });
    add("duplicate", translated("Action", "Duplicate"), "Ctrl+D", "[X Y Z]",
        [](PatchEdit& edit, const QStringList& words) -> Result<void> {
            if (words.isEmpty()) return edit.duplicate({1, 0, 0});
            TRY(const glm::vec3 by_m, vector_of(words, "metres", scene::kMaxCoordinate_m));
            return edit.duplicate(by_m);
        });
    add("remove", translated("Action", "Remove"), "Delete", "",
        [](PatchEdit& edit, const QStringList&) { return edit.remove(); });
    add("unpatch", translated("Action", "Unpatch"), "", "", [](PatchEdit& edit, const QStringList&) {
        return edit.set_address({1, 0});
    });
    add("add-fixture", translated("Action", "Add a fixture..."), "", "FILE [X Y]",
        [&app](PatchEdit& edit, const QStringList& words) -> Result<void> {
            const scene::Camera& camera = app.camera();
            glm::vec3 floor_m =
                scene::floor_along(camera, glm::normalize(camera.target_m - camera.position_m));
            for (int axis = 0; words.size() > 1 && axis < 2; ++axis) {
                TRY(const double metres,
                    number_of(words, axis + 1, "metres", -scene::kMaxCoordinate_m, scene::kMaxCoordinate_m));
                floor_m[axis] = static_cast<float>(metres);
            }
            return edit.add(words[0].toStdString(), [&](const scene::PatchedFixture& made) {
                return place_above(app.opened().objects, app.show()->fixtures, made, floor_m, kLowestHead_m);
            });
        },
        {translated("Files", "Add a fixture"),
         translated("Files", "Fixtures (*.gdtf *.qxf *.json);;All files (*)"), ""});
    actions.add({"keep-camera",
                 "Camera",
                 translated("Action", "Keep this camera"),
                 "Ctrl+K",
                 "[NAME]",
                 [&app, &document](const QStringList& words) {
                     return PatchEdit(app, document).keep_camera(words.value(0));
                 },
                 {}});
    // Without its new name a person is asked for it.
    actions.add({"camera-rename",
                 "Camera",
                 translated("Action", "Name this camera"),
                 "Ctrl+Alt+K",
                 "NAME|NUMBER NEW-NAME",
                 [&actions, &app, &document](const QStringList& words) -> Result<void> {
                     PatchEdit edit(app, document);
                     if (words.size() > 1) return edit.rename_camera(words[0], words[1]);
                     if (!actions.is_by_hand() || !actions.ask_word)
                         return Error{"it needs a camera and its new name", ""};
                     TRY_VOID(document.check_editable());
                     TRY(const std::size_t index, edit.camera_of(words.value(0)));
                     const QString name = QString::fromStdString(app.show()->cameras[index].name);
                     actions.ask_word(translated("Notice", "Name of camera '%1'").arg(name), name,
                                      [&actions, name](const QString& typed) {
                                          return actions.run("camera-rename " + quoted(name) + " " +
                                                             quoted(typed.trimmed()));
                                      });
                     return {};
                 },
                 {}});
    actions.add({"camera-remove",
                 "Camera",
                 translated("Action", "Remove this camera"),
                 "Ctrl+Alt+Shift+K",
                 "[NAME|NUMBER]",
                 [&app, &document](const QStringList& words) {
                     return PatchEdit(app, document).remove_camera(words.value(0));
                 },
                 {}});
    add("set-stage", translated("Action", "Choose the stage..."), "", "MODEL",
        [](PatchEdit& edit, const QStringList& words) { return edit.set_stage(words[0].toStdString()); },
        {translated("Files", "A model becomes the stage of the show"), translated("Files", kModels), ""});
    add("add-model", translated("Action", "Add a model..."), "", "MODEL [X Y Z]",
        [&app](PatchEdit& edit, const QStringList& words) -> Result<void> {
            glm::vec3 place_m = app.camera().target_m;
            place_m.z = 0; // on the floor
            if (words.size() > 1) {
                TRY(place_m, vector_of(words.mid(1), "metres", scene::kMaxCoordinate_m));
            }
            return edit.add_model(words[0].toStdString(), place_m);
        },
        {translated("Files", "A model that stands on the stage"), translated("Files", kModels), ""});
    add("set-plot", "", "", "FILE.mvr", [](PatchEdit& edit, const QStringList& words) {
        return edit.set_plot(words.value(0).toStdString());
    });
}

void add_document_actions(Actions& actions, ShowDocument& document) {
    actions.add({"save",
                 "Show",
                 translated("Action", "Save the show"),
                 "Ctrl+S",
                 "[over]",
                 [&document](const QStringList& words) { return document.save(words.value(0) == "over"); },
                 {}});
    actions.add({"save-copy",
                 "Show",
                 translated("Action", "Save a copy of the show file..."),
                 "",
                 "FILE",
                 [&document](const QStringList& words) { return document.save_copy(words[0].toStdString()); },
                 {},
                 {translated("Files", "Save a copy of the show file"),
                  translated("Files", "Show files (*.toml)"), "show-copy.toml"}});
    actions.add({"reload",
                 "Show",
                 translated("Action", "Take what the show file says now"),
                 "",
                 "",
                 [&document](const QStringList&) { return document.reload(); },
                 {}});
    actions.add({"take-changes",
                 "Edit",
                 translated("Action", "Take changes that were not saved"),
                 "",
                 "",
                 [&document](const QStringList&) { return document.take_draft(); },
                 {}});
    actions.add({"drop-changes",
                 "Edit",
                 translated("Action", "Drop changes that were not saved"),
                 "",
                 "",
                 [&document](const QStringList&) { return document.drop_draft(); },
                 {}});
    actions.add({"take-over",
                 "Edit",
                 translated("Action", "Take the show over from another window"),
                 "",
                 "",
                 [&document](const QStringList&) { return document.take_over(); },
                 {}});
}

} // namespace ghost::ui
