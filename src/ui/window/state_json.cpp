// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/state_json.h"
#include "show/show.h"
#include "ui/actions/bounce_edit.h"
#include "ui/picture/mover_marks.h"

#include <QJsonArray>

#include <algorithm>

namespace ghost::ui {
namespace {

QJsonArray array_of(const glm::vec3& values) {
    return {static_cast<double>(values.x), static_cast<double>(values.y), static_cast<double>(values.z)};
}

template <class T>
void put(QJsonObject& object, const char* key, const std::optional<T>& value) {
    if (!value) return;
    if constexpr (std::is_same_v<T, glm::vec3>)
        object[key] = array_of(*value);
    else if constexpr (std::is_same_v<T, float>)
        object[key] = static_cast<double>(*value);
    else
        object[key] = *value;
}

QJsonObject camera_json(const scene::Camera& camera) {
    return {{"name", QString::fromStdString(camera.name)},
            {"position_m", array_of(camera.position_m)},
            {"target_m", array_of(camera.target_m)},
            {"fov_y_deg", static_cast<double>(camera.fov_y_deg)},
            {"ev100", static_cast<double>(camera.ev100)},
            {"auto_exposure", camera.auto_exposure},
            {"width", camera.width},
            {"height", camera.height}};
}

QJsonObject look_json(const Look& look, const scene::Show& show) {
    QJsonObject fixtures;
    for (const auto& [index, programmer] : look.fixtures) {
        if (index >= show.fixtures.size()) continue; // of an edit that is not open yet
        QJsonObject one;
        put(one, "intensity", programmer.intensity);
        put(one, "colour", programmer.colour);
        put(one, "zoom_deg", programmer.zoom_deg);
        put(one, "pan_deg", programmer.pan_deg);
        put(one, "tilt_deg", programmer.tilt_deg);
        put(one, "gobo", programmer.gobo);
        put(one, "gel", programmer.gel);
        put(one, "lamp", programmer.lamp);
        put(one, "lamp_k", programmer.lamp_k);
        if (!programmer.levels.empty()) one["levels"] = static_cast<int>(programmer.levels.size());
        QJsonObject channels;
        for (const auto& [name, share] : programmer.channels)
            channels[QString::fromStdString(name)] = static_cast<double>(share);
        if (!channels.isEmpty()) one["channels"] = channels;
        fixtures[QString::fromStdString(show.fixtures[index].name)] = one;
    }
    QJsonObject scene;
    put(scene, "smoke", look.scene.smoke);
    put(scene, "ambient_lux", look.scene.ambient_lux);
    put(scene, "ambient_colour", look.scene.ambient_colour);
    put(scene, "attenuation", look.scene.attenuation);
    put(scene, "shadows", look.scene.shadows);
    QJsonArray solo;
    for (const std::size_t index : look.solo)
        if (index < show.fixtures.size()) solo.append(QString::fromStdString(show.fixtures[index].name));
    return {{"fixtures", fixtures},
            {"scene", scene},
            {"solo", solo},
            {"objects", static_cast<int>(look.shown.size())},
            {"surfaces", static_cast<int>(look.surfaces.size())}};
}

// What it does not hold is not there.
QJsonObject remote_json(const RemoteNow& remote) {
    QJsonObject held;
    if (remote.master < 1) held["master"] = static_cast<double>(remote.master);
    if (remote.black_out) held["black_out"] = true;
    if (remote.haze != 1.0f) held["haze"] = static_cast<double>(remote.haze);
    put(held, "ev100", remote.ev100);
    if (remote.tone) held["tone"] = QString::fromStdString(image::name_of(*remote.tone));
    return held;
}

} // namespace

QJsonObject latency_json(const dmx::Latency& latency) {
    return {{"count", static_cast<qint64>(latency.count())},
            {"p50", latency.percentile_ms(0.5)},
            {"p99", latency.percentile_ms(0.99)},
            {"max", latency.max_ms()}};
}

QJsonObject state_json(const AppModel& app, const View& view) {
    if (!app.show()) return {{"show", QJsonValue()}};
    const scene::Show& show = *app.show();
    QJsonArray selection;
    for (const std::size_t index : app.selection())
        if (index < show.fixtures.size()) selection.append(QString::fromStdString(show.fixtures[index].name));
    const Picture& picture = app.picture();
    const QPoint corner = view.mapToGlobal(QPoint(0, 0));
    QJsonObject patch;
    for (const scene::PatchedFixture& fixture : show.fixtures)
        patch[QString::fromStdString(fixture.name)] =
            QJsonObject{{"universe", fixture.universe},
                        {"address", fixture.address},
                        {"mode", fixture.mode},
                        {"position_m", array_of(fixture.position_m)}};
    QJsonObject lamps;
    for (std::size_t i = 0; i < std::min(app.rig().fixtures.size(), show.fixtures.size()); ++i)
        if (const auto at = to_widget(picture_rect(view.size(), picture.camera, picture.framed),
                                      picture.camera, app.rig().fixtures[i].light_m))
            lamps[QString::fromStdString(show.fixtures[i].name)] = QJsonArray{at->x(), at->y()};
    QJsonObject movers;
    const QRectF seen = picture_rect(view.size(), picture.camera, picture.framed);
    const MoverScene scene{app.opened(), app.rig(), seen, picture.camera};
    for (std::size_t m = 0; m < std::min(app.rig().movers.size(), show.movers.size()); ++m) {
        const MoverNow& now = app.rig().movers[m];
        QJsonArray values, goals, handles; // handles: in the view
        for (std::size_t a = 0; a < std::min(now.values.size(), show.movers[m].axes.size()); ++a) {
            values.append(static_cast<double>(now.values[a]));
            goals.append(static_cast<double>(now.goals[a]));
            const auto at = to_widget(seen, picture.camera, handle_at_m(scene, {m, a}, now.values[a]));
            handles.append(at ? QJsonArray{at->x(), at->y()} : QJsonArray());
        }
        movers[QString::fromStdString(show.movers[m].name)] =
            QJsonObject{{"values", values}, {"goals", goals}, {"handles", handles}};
    }
    const QRectF frame = frame_rect(view.size(), app.request().frame); // in the view
    QJsonArray universes;
    for (const dmx::Universe& universe : app.rig().universes.list) universes.append(universe.number);
    const QJsonObject of_picture{{"camera", camera_json(picture.camera)},
                                 {"draw_ms", picture.draw_ms},
                                 {"coarse", picture.is_coarse},
                                 {"lights_drawn", picture.lights_drawn},
                                 {"device_mb", static_cast<double>(picture.device_bytes) * 1e-6},
                                 {"missing_maps", static_cast<int>(picture.missing_maps)},
                                 {"missing_shadows", static_cast<int>(picture.missing_shadows)},
                                 {"left_dark", static_cast<int>(picture.left_dark)},
                                 {"paint_ms", view.paint_ms()},
                                 {"pictures_per_s", view.figures().pictures_per_s()},
                                 {"baked", picture.is_baked},
                                 {"work_light", picture.has_work_light},
                                 {"supply", QString::fromStdString(picture.supply)},
                                 {"shower", QString::fromStdString(view.shower().words)},
                                 {"surface_format", QString::fromStdString(view.shower().format)},
                                 {"false_colour", static_cast<int>(picture.false_colour.measure)},
                                 {"latency_ms", view.figures().latency_ms()}};
    QJsonObject probe;
    if (const std::optional<Probed>& probed = app.probed(); probed && app.request().probe == probed->place)
        probe = {{"cd_m2", static_cast<double>(probed->cd_m2)},
                 {"lux", probed->hit ? QJsonValue(static_cast<double>(probed->lux)) : QJsonValue()},
                 {"bounced_lux",
                  probed->bounced_lux ? QJsonValue(static_cast<double>(*probed->bounced_lux)) : QJsonValue()},
                 {"at_m", array_of(probed->at_m)},
                 {"object", QString::fromStdString(probed->object)}};
    const BounceNow& bounce = app.bounce();
    const QJsonObject of_bounce{{"show", scene::name_of(show.bounce)},
                                {"picture", scene::name_of(bounce.detail)},
                                {"state", state_name(bounce.state)},
                                {"made_share", bounce.made_share},
                                {"left_s", bounce.left_s ? QJsonValue(*bounce.left_s) : QJsonValue()},
                                {"solve_ms", bounce.solve_ms},
                                {"draw_ms", bounce.draw_ms},
                                {"words", words_of(bounce)}};
    QJsonObject hovered;
    if (const std::optional<Explained>& one = app.hovered(); one && one->fixture < show.fixtures.size())
        hovered = {{"name", QString::fromStdString(show.fixtures[one->fixture].name)},
                   {"why", QString::fromStdString(one->explanation.verdict)}};
    QJsonObject explained; // of the one fixture that is selected
    if (const Explained& one = app.explained(); !one.words.empty() && one.fixture < show.fixtures.size())
        explained = {{"name", QString::fromStdString(show.fixtures[one.fixture].name)},
                     {"why", QString::fromStdString(one.explanation.verdict)}};
    QJsonArray identify;
    int found = 0;
    for (const RdmHead& head : app.rdm().heads) {
        found += head.is_found ? 1 : 0;
        if (head.identifies && head.fixture < show.fixtures.size())
            identify.append(QString::fromStdString(show.fixtures[head.fixture].name));
    }
    const QJsonObject rdm{{"access", kRdmAccess[static_cast<int>(app.rdm().access)]},
                          {"heads", static_cast<int>(app.rdm().heads.size())},
                          {"found", found},
                          {"messages", static_cast<qint64>(app.rdm().messages)},
                          {"identify", identify}};
    QJsonArray chips;
    for (const QString& words : view.chip_words()) chips.append(words);
    QJsonArray palettes;
    for (const scene::Palette& palette : show.palettes) palettes.append(QString::fromStdString(palette.name));
    QJsonArray diagnosis;
    for (const scene::Sentence& sentence : app.diagnosis())
        diagnosis.append(QJsonObject{{"trouble", scene::trouble_name(sentence.trouble)},
                                     {"problem", sentence.is_problem},
                                     {"text", QString::fromStdString(sentence.text)}});
    return {{"show", QString::fromStdString(show.file.string())},
            {"device", QString::fromStdString(app.opened().device)},
            {"camera", camera_json(app.camera())},
            {"fixtures", static_cast<int>(show.fixtures.size())},
            {"received_plot", QString::fromStdString(app.plot().file)},
            {"selection", selection},
            {"hovered", hovered},
            {"explained", explained},
            {"palettes", palettes},
            {"camera_pictures", static_cast<int>(app.camera_pictures().size())},
            {"by_hand", look_json(app.look(), show)},
            {"fades", app.fades()},
            {"black_out", app.request().black_out},
            {"tone", QString::fromStdString(image::name_of(app.request().tone))},
            {"master", static_cast<double>(app.request().master)},
            {"remote", remote_json(app.rig().remote)},
            {"playing", app.request().transport.playing},
            {"at_s", app.rig().at_s},
            {"recording_s", app.rig().recording_s},
            {"recorded_s", app.rig().recorded_s},
            {"timecode", QString::fromStdString(app.rig().timecode)},
            {"recorded", QString::fromStdString(app.recorded().file)},
            {"from_desk", app.rig().from_desk},
            {"chips", chips},
            {"universes", universes},
            {"view", QJsonArray{corner.x(), corner.y(), view.width(), view.height()}},
            {"frame", QJsonArray{frame.x(), frame.y(), frame.width(), frame.height()}},
            {"lamps", lamps},
            {"movers", movers},
            {"patch", patch},
            {"messages", static_cast<int>(app.messages().size())},
            {"picture", of_picture},
            {"probe", probe},
            {"bounce", of_bounce},
            {"rdm", rdm},
            {"undo", app.undo_stack().undoText()},
            {"saved", static_cast<qint64>(app.saved())},
            {"packet_to_window_ms", latency_json(app.latency())},
            {"window_ms", latency_json(app.window_cost())},
            {"draws_ms", latency_json(view.figures().draws())},
            {"network", diagnosis}};
}

} // namespace ghost::ui
