// SPDX-License-Identifier: Apache-2.0
// The actions that are about the recording, the input, and how finely the picture is drawn.
#include "ui/actions/programmer_actions.h"

#include "dmx/record/recording.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/aside.h"

#include <QDateTime>

namespace ghost::ui {

namespace {

// Beside the show, and never over another one.
std::string new_recording(const AppModel& app) {
    const QString name =
        "recording-" + QDateTime::currentDateTime().toString("yyyyMMdd-hhmmss") + ".ghostdmx";
    return (app.show()->folder / name.toStdString()).string();
}

Result<void> record(AppModel& app, const QStringList& words) {
    if (!app.show()) return Error{"no show is open", ""};
    const bool runs = !app.request().record_to.empty();
    const bool is_switch = words.isEmpty() || words[0] == "on";
    if (runs && words.value(0) == "on") return {};
    const bool ends = words.isEmpty() ? runs : words[0] == "off";
    if (!ends && runs) return Error{"a recording runs; 'record off' ends it", app.request().record_to};
    const std::string file = ends ? "" : is_switch ? new_recording(app) : words[0].toStdString();
    app.change_request([&](ViewRequest& request) { request.record_to = file; });
    return {};
}

Result<void> play_file(AppModel& app, const std::string& file) {
    // What is no recording must not stop the one that plays.
    const std::uint64_t opens = app.request().opens;
    const auto check = [&file]() -> Result<void> {
        TRY_VOID(dmx::read_recording(file));
        return {};
    };
    if (!file.empty()) TRY_VOID(aside(check));
    if (app.request().opens != opens)
        return Error{"another show was opened meanwhile; its own recording plays", file};
    app.change_request([&](ViewRequest& request) {
        request.recording = file;
        request.input = Input::recording;
        request.transport.playing = true;
        request.transport.loop_from_s = request.transport.loop_to_s = 0;
        ++request.transport.seeks;
        request.transport.at_s = 0;
    });
    return {};
}

void add_recorder(Actions& actions, AppModel& app) {
    actions.add({"record", "Play", translated("Action", "Record what the desk sends"), "Ctrl+R",
                 "[on|off|FILE]", [&app](const QStringList& words) { return record(app, words); },
                 [&app] { return !app.request().record_to.empty(); }});
    actions.add({"play-recorded",
                 "Play",
                 translated("Action", "Play what was recorded last"),
                 "",
                 "",
                 [&app](const QStringList&) -> Result<void> {
                     const Recorded& recorded = app.recorded();
                     if (recorded.file.empty() || recorded.error)
                         return Error{"nothing was recorded in this window", ""};
                     return play_file(app, recorded.file);
                 },
                 {}});
    actions.add({"play-file",
                 "Play",
                 translated("Action", "Play a recording..."),
                 "",
                 "FILE|own",
                 [&app](const QStringList& words) -> Result<void> {
                     return play_file(app, words[0] == "own" ? "" : words[0].toStdString());
                 },
                 {},
                 {translated("Files", "Play a recording"),
                  translated("Files", "Recordings (*.ghostdmx *.show *.pcap *.pcapng);;All files (*)"), ""}});
    actions.add(
        {"play-own", "Play", translated("Action", "Play the show's own recording"), "", "",
         [&app](const QStringList&) { return play_file(app, ""); },
         [&app] { return app.request().recording.empty() && app.request().input == Input::recording; }});
}

} // namespace

void add_play_actions(Actions& actions, AppModel& app) {
    actions.add({"play", "Play", translated("Action", "Play or pause the recording"), "Space", "[on|off]",
                 [&app](const QStringList& words) -> Result<void> {
                     const bool plays = app.request().transport.playing;
                     const QString word = words.value(0, plays ? "off" : "on");
                     if (word != "on" && word != "off")
                         return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
                     app.change_request(
                         [&](ViewRequest& request) { request.transport.playing = word == "on"; });
                     return {};
                 },
                 [&app] { return app.request().transport.playing; }});
    actions.add({"freeze", "Play", translated("Action", "Freeze: time stands still"), "Z", "[on|off]",
                 [&app](const QStringList& words) -> Result<void> {
                     const QString word = words.value(0, app.request().frozen ? "off" : "on");
                     if (word != "on" && word != "off")
                         return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
                     app.change_request([&](ViewRequest& request) { request.frozen = word == "on"; });
                     return {};
                 },
                 [&app] { return app.request().frozen; }});
    const auto jump = [&app](double at_s) {
        app.change_request([&](ViewRequest& request) {
            ++request.transport.seeks;
            request.transport.at_s = at_s;
        });
    };
    actions.add({"jump",
                 "",
                 "jump",
                 "",
                 "SECONDS",
                 [jump](const QStringList& words) -> Result<void> {
                     TRY(const double at_s, number_of(words, 0, "number of seconds", 0, 86400));
                     jump(at_s);
                     return {};
                 },
                 {}});
    add_recorder(actions, app);
    actions.add({"loop",
                 "",
                 "loop",
                 "",
                 "FROM TO|off",
                 [&app](const QStringList& words) -> Result<void> {
                     double from_s = 0, to_s = 0;
                     if (words.value(0) != "off") {
                         TRY(from_s, number_of(words, 0, "first second", 0, 1e7));
                         TRY(to_s, number_of(words, 1, "last second", 0, 1e7));
                         if (to_s <= from_s) return Error{"it must end after it begins", ""};
                     }
                     app.change_request([&](ViewRequest& request) {
                         request.transport.loop_from_s = from_s;
                         request.transport.loop_to_s = to_s;
                     });
                     return {};
                 },
                 {}});
    actions.add({"to-start",
                 "Play",
                 translated("Action", "Back to the start"),
                 "Ctrl+Home",
                 "",
                 [jump](const QStringList&) -> Result<void> {
                     jump(0);
                     return {};
                 },
                 {}});
    for (const auto& [name, text, wanted] :
         {std::tuple{"automatic", translated("Action", "A desk as soon as one is heard"), Input::automatic},
          std::tuple{"desk", translated("Action", "What a desk sends"), Input::desk},
          std::tuple{"recording", translated("Action", "The recording of the show"), Input::recording}}) {
        actions.add({QString("input-") + name, "Play", text, "", "",
                     [&app, wanted = wanted](const QStringList&) -> Result<void> {
                         app.change_request([&](ViewRequest& request) { request.input = wanted; });
                         return {};
                     },
                     [&app, wanted = wanted] { return app.request().input == wanted; }});
    }
    actions.add({"fps",
                 "",
                 "fps",
                 "",
                 "PICTURES-PER-SECOND",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const double fps, number_of(words, 0, "number of pictures a second", 1, 240));
                     app.change_request(
                         [&](ViewRequest& request) { request.quality.fps = static_cast<int>(fps); });
                     return {};
                 },
                 {}});
    for (const int fps : {15, 25, 30, 44, 60}) {
        actions.add({QString("fps-%1").arg(fps), "Quality",
                     translated("Action", "%1 pictures a second").arg(fps), "", "",
                     [&app, fps](const QStringList&) -> Result<void> {
                         app.change_request([&](ViewRequest& request) { request.quality.fps = fps; });
                         return {};
                     },
                     [&app, fps] { return app.request().quality.fps == fps; }});
    }
    actions.add({"resolution",
                 "",
                 "resolution",
                 "",
                 "PERCENT",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const double percent,
                         number_of(words, 0, "share of the pixels in percent, 0 for automatic,", 0, 100));
                     app.change_request(
                         [&](ViewRequest& request) { request.quality.percent = static_cast<int>(percent); });
                     return {};
                 },
                 {}});
    for (const int percent : {0, 100, 50, 25, 10}) {
        actions.add({QString("resolution-%1").arg(percent), "Quality",
                     percent == 0 ? translated("Action", "As fine as the rate allows, full when at rest")
                                  : translated("Action", "%1 % of the pixels").arg(percent),
                     percent == 0 ? "Ctrl+0" : "", "",
                     [&app, percent](const QStringList&) -> Result<void> {
                         app.change_request([&](ViewRequest& request) { request.quality.percent = percent; });
                         return {};
                     },
                     [&app, percent] { return app.request().quality.percent == percent; }});
    }
}

} // namespace ghost::ui
