// SPDX-License-Identifier: Apache-2.0
#include "ui/model/palette_values.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/head_parameters.h"
#include "ui/model/head_values.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

using fixture::Role;
using scene::PaletteKind;

std::optional<PaletteKind> kind_of(const fixture::Channel& channel) {
    const Role role = role_of(channel);
    if (role == Role::pan || role == Role::tilt) return PaletteKind::position;
    if (role == Role::zoom) return PaletteKind::beam;
    const QString group = group_of(channel);
    if (group == "Position") return PaletteKind::position;
    if (group == "Colour") return PaletteKind::colour;
    if (group == "Gobo") return PaletteKind::gobo;
    if (group == "Beam" || group == "Shutter" || group == "Blades" || group == "Laser")
        return PaletteKind::beam;
    return std::nullopt;
}

} // namespace

scene::PaletteValues palette_values_of(PaletteKind kind, const scene::PatchedFixture& fixture,
                                       const fixture::Programmer& by_hand) {
    const fixture::Programmer programmer = in_channels(fixture, by_hand);
    scene::PaletteValues values;
    if (kind == PaletteKind::position) {
        values.pan_deg = programmer.pan_deg;
        values.tilt_deg = programmer.tilt_deg;
    }
    if (kind == PaletteKind::colour) values.colour = programmer.colour;
    if (kind == PaletteKind::beam) values.zoom_deg = programmer.zoom_deg;
    if (kind == PaletteKind::gobo) values.gobo = programmer.gobo;
    if (!fixture.type) return values;
    const fixture::Patch patch = fixture.patch();
    for (const fixture::Channel& channel : patch.mode_of().channels)
        if (const auto share = programmer.channels.find(channel.name);
            share != programmer.channels.end() && kind_of(channel) == kind)
            values.attributes.try_emplace(attribute_of(channel), share->second);
    return values;
}

scene::PaletteValues merged(const scene::PaletteValues& before, const scene::PaletteValues& now) {
    scene::PaletteValues values = now;
    if (!values.pan_deg) values.pan_deg = before.pan_deg;
    if (!values.tilt_deg) values.tilt_deg = before.tilt_deg;
    if (!values.zoom_deg) values.zoom_deg = before.zoom_deg;
    // One value stands above several attributes: what was said last is meant.
    static const auto kWheel = QRegularExpression("^Gobo\\d+$");
    const auto is_of = [](const char* begin, const auto& one) { return one.first.starts_with(begin); };
    const bool mixes = std::any_of(now.attributes.begin(), now.attributes.end(),
                                   [&](const auto& one) { return is_of("Color", one); });
    if (!values.colour && !mixes) values.colour = before.colour;
    const bool chooses = std::any_of(now.attributes.begin(), now.attributes.end(), [](const auto& one) {
        return kWheel.match(QString::fromStdString(one.first)).hasMatch();
    });
    if (!values.gobo && !chooses) values.gobo = before.gobo;
    for (const auto& one : before.attributes)
        if (!now.colour || !is_of("Color", one)) values.attributes.insert(one);
    return values;
}

bool give_values(const scene::PaletteValues& values, const scene::PatchedFixture& fixture,
                 fixture::Programmer& programmer) {
    bool any = false;
    const auto give = [&](const std::string& word, const HeadValue& value) {
        any = any || has_value(fixture, word);
        set_value(fixture, word, value, programmer);
    };
    // A value that stands above attributes is to win.
    for (const auto& [attribute, share] : values.attributes) give(attribute, share);
    if (values.pan_deg) give("pan", *values.pan_deg);
    if (values.tilt_deg) give("tilt", *values.tilt_deg);
    if (values.colour) give("colour", *values.colour);
    if (values.zoom_deg) give("zoom", *values.zoom_deg);
    if (values.gobo) give("gobo", static_cast<float>(*values.gobo));
    return any;
}

QString words_of(const scene::PaletteValues& values) {
    QStringList words;
    const auto degrees = [&](const QString& what, const std::optional<float>& deg) {
        if (deg) words << QString("%1 %2\u00b0").arg(what).arg(static_cast<double>(*deg), 0, 'f', 1);
    };
    degrees(translated("Parameter", "pan"), values.pan_deg);
    degrees(translated("Parameter", "tilt"), values.tilt_deg);
    degrees(translated("Parameter", "zoom"), values.zoom_deg);
    if (values.colour) words << translated("Parameter", "a colour");
    if (values.gobo) words << translated("Parameter", "gobo %1").arg(*values.gobo);
    for (const auto& [attribute, share] : values.attributes)
        words << QString("%1 %2 %").arg(attribute_words(attribute)).arg(std::lround(100 * share));
    return words.join(", ");
}

QStringList names_of(const scene::PaletteValues& values) {
    QStringList names;
    if (values.pan_deg) names << translated("Parameter", "pan");
    if (values.tilt_deg) names << translated("Parameter", "tilt");
    if (values.zoom_deg) names << translated("Parameter", "zoom");
    if (values.colour) names << translated("Parameter", "a colour");
    if (values.gobo) names << translated("Parameter", "a gobo");
    for (const auto& [attribute, share] : values.attributes) names << attribute_words(attribute);
    return names;
}

} // namespace ghost::ui
