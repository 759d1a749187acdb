// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/tone_actions.h"

#include "ui/language/language.h"

namespace ghost::ui {

void add_tone_actions(Actions& actions, AppModel& app) {
    actions.add({"tone",
                 "Camera",
                 translated("Action", "The next tone curve"),
                 "T",
                 "[agx|aces|linear]",
                 [&app](const QStringList& words) -> Result<void> {
                     const auto next =
                         (static_cast<std::size_t>(app.request().tone) + 1) % image::kTones.size();
                     image::Tone tone = image::kTones[next];
                     if (!words.isEmpty()) {
                         TRY(tone, image::tone_from(words[0].toStdString()));
                     }
                     app.change_request([&](ViewRequest& request) { request.tone = tone; });
                     return {};
                 },
                 {}});
    const auto add = [&](const QString& text, image::Tone tone) {
        actions.add({"tone-" + QString::fromStdString(image::name_of(tone)), "Camera", text, "", "",
                     [&app, tone](const QStringList&) -> Result<void> {
                         app.change_request([&](ViewRequest& request) { request.tone = tone; });
                         return {};
                     },
                     [&app, tone] { return app.request().tone == tone; }});
    };
    add(translated("Action", "Tone curve: AgX, like film"), image::Tone::agx);
    add(translated("Action", "Tone curve: ACES, more contrast"), image::Tone::aces);
    add(translated("Action", "Tone curve: none, clipped"), image::Tone::linear);
}

} // namespace ghost::ui
