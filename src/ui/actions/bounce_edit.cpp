// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/bounce_edit.h"

#include "show_file/air_edit.h"
#include "ui/language/language.h"

#include <cmath>
#include <iterator>

namespace ghost::ui {
namespace {

QString left_text(double seconds) {
    const auto whole = static_cast<int>(std::ceil(seconds));
    return whole < 60
               ? QString("%1 s").arg(whole)
               : translated("Bounced light", "%1:%2 min").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
}

QString in_ms(double ms) {
    return QString::number(ms, 'f', 1) + " ms";
}

} // namespace

Result<void> set_bounce(AppModel& app, ShowDocument& document, scene::BounceDetail detail) {
    TRY_VOID(document.check_editable());
    TRY(const std::string text, scene::edit_bounce(document.text(), detail));
    stop_bounce(app, false);
    return document.edit(translated("Undo", "Bounced light"), {text, app.look(), app.selection()});
}

void stop_bounce(AppModel& app, bool stops) {
    if (app.request().stops_bounce != stops)
        app.change_request([&](ViewRequest& request) { request.stops_bounce = stops; });
}

QString words_of(const BounceNow& bounce) {
    QString words;
    switch (bounce.state) {
    case BounceNow::State::off:
        words = translated("Bounced light", "no light bounces");
        break;
    case BounceNow::State::makes_links:
        words = translated("Bounced light", "links are being made, %1 %")
                    .arg(std::lround(100 * bounce.made_share));
        if (bounce.left_s) words += translated("Jobs", ", %1 left").arg(left_text(*bounce.left_s));
        break;
    case BounceNow::State::stopped:
        words = translated("Bounced light", "its links were cancelled: no light bounces");
        break;
    case BounceNow::State::failed:
        words = translated("Bounced light", "it cannot be made, Messages say why: no light bounces");
        break;
    case BounceNow::State::bounces:
        words = bounce.solve_ms > 0
                    ? translated("Bounced light", "solved in %1 beside the picture, drawn in %2 of it")
                          .arg(in_ms(bounce.solve_ms), in_ms(bounce.draw_ms))
                    : translated("Bounced light", "is being solved");
        break;
    }
    if (bounce.is_of_command_line)
        words = translated("Bounced light", "%1, by --bounce of the command line: %2")
                    .arg(said(scene::name_of(bounce.detail)), words);
    return words;
}

const char* state_name(BounceNow::State state) {
    static constexpr const char* kNames[] = {"off", "makes_links", "cancelled", "failed", "bounces"};
    static_assert(std::size(kNames) == static_cast<std::size_t>(BounceNow::State::bounces) + 1);
    return kNames[static_cast<std::size_t>(state)];
}

void add_bounce_actions(Actions& actions, AppModel& app, ShowDocument& document) {
    actions.add({"bounce",
                 "",
                 "bounce",
                 "",
                 "off|room|normal|fine",
                 [&app, &document](const QStringList& words) -> Result<void> {
                     const std::string name = words.value(0).toStdString();
                     const auto detail = scene::find_bounce_detail(name);
                     if (!detail) return Error{"bounced light " + scene::no_such_bounce_detail(name), ""};
                     return set_bounce(app, document, *detail);
                 },
                 {}});
    actions.add({"cancel-bounce",
                 "",
                 "cancel-bounce",
                 "",
                 "[on|off]",
                 [&app](const QStringList& words) -> Result<void> {
                     const QString word = words.value(0, "on");
                     if (word != "on" && word != "off")
                         return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
                     stop_bounce(app, word == "on");
                     return {};
                 },
                 {}});
}

} // namespace ghost::ui
