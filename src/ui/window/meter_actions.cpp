// SPDX-License-Identifier: Apache-2.0
// The actions that measure and compare: false colours, the probe, the wipe.
#include "ui/window/private/meter_actions.h"

#include "ui/language/language.h"

#include <QCursor>

namespace ghost::ui {
namespace {

// From the dark of a hall to the middle of a beam.
constexpr image::Scale kLuxScale{1, 10000};
constexpr image::Scale kLuminanceScale{0.1f, 1000};
constexpr double kLeast = 1e-3, kMost = 1e7;

FalseColour usual(Measure measure) {
    return {measure, measure == Measure::lux ? kLuxScale : kLuminanceScale};
}

Result<void> set_false_colour(AppModel& app, const QStringList& words) {
    const QString what = words.value(0);
    FalseColour wanted;
    if (what == "lux")
        wanted = usual(Measure::lux);
    else if (what == "luminance")
        wanted = usual(Measure::luminance);
    else if (what != "off")
        return Error{"'" + what.toStdString() + "' is none of lux, luminance and off", ""};
    if (words.size() > 1 && what != "off") {
        TRY(const double low, number_of(words, 1, "least value", kLeast, kMost));
        TRY(const double high, number_of(words, 2, "largest value", kLeast, kMost));
        if (high < 1.5 * low)
            return Error{"the largest value must be at least half as large again as the least", ""};
        wanted.scale = {static_cast<float>(low), static_cast<float>(high)};
    }
    app.change_request([&](ViewRequest& request) { request.false_colour = wanted; });
    return {};
}

Result<void> set_probe(View& view, const QStringList& words) {
    const QString word = words.value(0, view.overlays.probe ? "off" : "on");
    if (words.size() > 1) {
        TRY(const double x, number_of(words, 0, "pixel from the left", 0, view.width()));
        TRY(const double y, number_of(words, 1, "pixel from the top", 0, view.height()));
        view.probe_at({x, y});
        return {};
    }
    if (word == "on")
        view.probe_at(view.mapFromGlobal(QCursor::pos()));
    else if (word == "off")
        view.end_probe();
    else
        return Error{"'" + word.toStdString() + "' is none of on, off and a place X Y", ""};
    return {};
}

} // namespace

void add_meter_actions(Actions& actions, AppModel& app, View& view) {
    actions.add({"wipe", "View", translated("Action", "Wipe between what is seen now and what comes"),
                 "Ctrl+B", "[on|off|SHARE]",
                 [&view](const QStringList& words) -> Result<void> {
                     const QString word = words.value(0, view.wipe().is_on() ? "off" : "on");
                     if (word == "off") {
                         view.end_wipe();
                         return {};
                     }
                     double share = view.wipe().share();
                     if (word != "on") {
                         TRY(share, number_of({word}, 0, "share of the width, on or off", 0, 1));
                     }
                     return view.begin_wipe(share);
                 },
                 [&view] { return view.wipe().is_on(); }});
    actions.add({"false-colour",
                 "",
                 "false-colour",
                 "",
                 "lux|luminance|off [LEAST LARGEST]",
                 [&app](const QStringList& words) { return set_false_colour(app, words); },
                 {}});
    const auto add = [&](const QString& name, const QString& text, const QString& key, Measure measure) {
        actions.add({name, "View", text, key, "",
                     [&app, measure](const QStringList&) -> Result<void> {
                         app.change_request([&](ViewRequest& request) {
                             const bool is_on = request.false_colour.measure == measure;
                             request.false_colour = is_on ? FalseColour{} : usual(measure);
                         });
                         return {};
                     },
                     [&app, measure] { return app.request().false_colour.measure == measure; }});
    };
    add("false-lux", translated("Action", "False colours: lux on surfaces"), "C", Measure::lux);
    add("false-luminance", translated("Action", "False colours: cd/m²"), "V", Measure::luminance);
    actions.add({"probe", "View", translated("Action", "Probe: cd/m² and lux under the mouse"), "P",
                 "[on|off|X Y]", [&view](const QStringList& words) { return set_probe(view, words); },
                 [&view] { return view.overlays.probe; }});
}

} // namespace ghost::ui
