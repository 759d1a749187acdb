// SPDX-License-Identifier: Apache-2.0
// The actions that are about the recording, the input, and how finely the picture is drawn.
#include "ui/actions/hand.h"

#include "dmx/record/recording.h"

#include <QDateTime>

namespace ghost::ui {

namespace {

// Beside the show, and never over another one.
std::string new_recording(const Studio& studio) {
    const QString name =
        "recording-" + QDateTime::currentDateTime().toString("yyyyMMdd-hhmmss") + ".ghostdmx";
    return (studio.show()->folder / name.toStdString()).string();
}

Result<void> record(Studio& studio, const QStringList& words) {
    if (!studio.show()) return Error{"no show is open", ""};
    const bool runs = !studio.wishes().record_to.empty();
    const bool ends = words.isEmpty() ? runs : words[0] == "off";
    if (!ends && runs) return Error{"a recording runs; 'record off' ends it", studio.wishes().record_to};
    const std::string file = ends ? "" : words.isEmpty() ? new_recording(studio) : words[0].toStdString();
    studio.wish([&](Wishes& wishes) { wishes.record_to = file; });
    return {};
}

Result<void> play_file(Studio& studio, const std::string& file) {
    // What is no recording must not stop the one that plays.
    if (!file.empty()) TRY_VOID(dmx::read_recording(file));
    studio.wish([&](Wishes& wishes) {
        wishes.recording = file;
        wishes.input = Input::recording;
        wishes.transport.playing = true;
        wishes.transport.loop_from_s = wishes.transport.loop_to_s = 0;
        ++wishes.transport.seeks;
        wishes.transport.at_s = 0;
    });
    return {};
}

void add_recorder(Actions& actions, Studio& studio) {
    actions.add({"record", "Play", "Record what the desk sends", "Ctrl+R", "[FILE|off]",
                 [&studio](const QStringList& words) { return record(studio, words); },
                 [&studio] { return !studio.wishes().record_to.empty(); }});
    actions.add({"play-recorded",
                 "Play",
                 "Play what was recorded last",
                 "",
                 "",
                 [&studio](const QStringList&) -> Result<void> {
                     const Recorded& recorded = studio.recorded();
                     if (recorded.file.empty() || recorded.error)
                         return Error{"nothing was recorded in this window", ""};
                     return play_file(studio, recorded.file);
                 },
                 {}});
    actions.add({"play-file",
                 "Play",
                 "Play a recording...",
                 "",
                 "FILE|own",
                 [&studio](const QStringList& words) -> Result<void> {
                     return play_file(studio, words[0] == "own" ? "" : words[0].toStdString());
                 },
                 {},
                 {"Play a recording", "Recordings (*.ghostdmx *.show *.pcap *.pcapng);;All files (*)", ""}});
    actions.add({"play-own", "Play", "Play the show's own recording", "", "",
                 [&studio](const QStringList&) { return play_file(studio, ""); },
                 [&studio] {
                     return studio.wishes().recording.empty() && studio.wishes().input == Input::recording;
                 }});
}

} // namespace

void add_play_actions(Actions& actions, Studio& studio) {
    actions.add({"play", "Play", "Play or pause the recording", "Space", "[on|off]",
                 [&studio](const QStringList& words) -> Result<void> {
                     const bool plays = studio.wishes().transport.playing;
                     const QString word = words.value(0, plays ? "off" : "on");
                     if (word != "on" && word != "off")
                         return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
                     studio.wish([&](Wishes& wishes) { wishes.transport.playing = word == "on"; });
                     return {};
                 },
                 [&studio] { return studio.wishes().transport.playing; }});
    actions.add({"freeze", "Play", "Freeze: time stands still", "Z", "[on|off]",
                 [&studio](const QStringList& words) -> Result<void> {
                     const QString word = words.value(0, studio.wishes().frozen ? "off" : "on");
                     if (word != "on" && word != "off")
                         return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
                     studio.wish([&](Wishes& wishes) { wishes.frozen = word == "on"; });
                     return {};
                 },
                 [&studio] { return studio.wishes().frozen; }});
    const auto jump = [&studio](double at_s) {
        studio.wish([&](Wishes& wishes) {
            ++wishes.transport.seeks;
            wishes.transport.at_s = at_s;
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
    add_recorder(actions, studio);
    actions.add({"loop",
                 "",
                 "loop",
                 "",
                 "FROM TO|off",
                 [&studio](const QStringList& words) -> Result<void> {
                     double from_s = 0, to_s = 0;
                     if (words.value(0) != "off") {
                         TRY(from_s, number_of(words, 0, "first second", 0, 1e7));
                         TRY(to_s, number_of(words, 1, "last second", 0, 1e7));
                         if (to_s <= from_s) return Error{"it must end after it begins", ""};
                     }
                     studio.wish([&](Wishes& wishes) {
                         wishes.transport.loop_from_s = from_s;
                         wishes.transport.loop_to_s = to_s;
                     });
                     return {};
                 },
                 {}});
    actions.add({"to-start",
                 "Play",
                 "Back to the start",
                 "Ctrl+Home",
                 "",
                 [jump](const QStringList&) -> Result<void> {
                     jump(0);
                     return {};
                 },
                 {}});
    for (const auto& [name, text, wanted] :
         {std::tuple{"automatic", "A desk as soon as one is heard", Input::automatic},
          std::tuple{"desk", "What a desk sends", Input::desk},
          std::tuple{"recording", "The recording of the show", Input::recording}}) {
        actions.add({QString("input-") + name, "Play", text, "", "",
                     [&studio, wanted = wanted](const QStringList&) -> Result<void> {
                         studio.wish([&](Wishes& wishes) { wishes.input = wanted; });
                         return {};
                     },
                     [&studio, wanted = wanted] { return studio.wishes().input == wanted; }});
    }
    actions.add({"fps",
                 "",
                 "fps",
                 "",
                 "PICTURES-PER-SECOND",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY(const double fps, number_of(words, 0, "number of pictures a second", 1, 240));
                     studio.wish([&](Wishes& wishes) { wishes.quality.fps = static_cast<int>(fps); });
                     return {};
                 },
                 {}});
    for (const int fps : {15, 25, 30, 44, 60}) {
        actions.add({QString("fps-%1").arg(fps), "Quality", QString("%1 pictures a second").arg(fps), "", "",
                     [&studio, fps](const QStringList&) -> Result<void> {
                         studio.wish([&](Wishes& wishes) { wishes.quality.fps = fps; });
                         return {};
                     },
                     [&studio, fps] { return studio.wishes().quality.fps == fps; }});
    }
    actions.add({"resolution",
                 "",
                 "resolution",
                 "",
                 "PERCENT",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY(const double percent,
                         number_of(words, 0, "share of the pixels in percent, 0 for automatic,", 0, 100));
                     studio.wish([&](Wishes& wishes) { wishes.quality.percent = static_cast<int>(percent); });
                     return {};
                 },
                 {}});
    for (const int percent : {0, 100, 50, 25, 10}) {
        actions.add({QString("resolution-%1").arg(percent), "Quality",
                     percent == 0 ? QString("As fine as the rate allows, full when at rest")
                                  : QString("%1 % of the pixels").arg(percent),
                     percent == 0 ? "Ctrl+0" : "", "",
                     [&studio, percent](const QStringList&) -> Result<void> {
                         studio.wish([&](Wishes& wishes) { wishes.quality.percent = percent; });
                         return {};
                     },
                     [&studio, percent] { return studio.wishes().quality.percent == percent; }});
    }
}

} // namespace ghost::ui
