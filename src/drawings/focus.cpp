// SPDX-License-Identifier: Apache-2.0
#include "drawings/focus.h"

#include "book/fixture_values.h"
#include "book/hangings.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

constexpr float kLevel = 0.8f; // upward part of a floor's normal
constexpr int kEdge = 48;      // points of a pool
constexpr float kFarthest_m = 300;
constexpr float kOnLine_m = 0.005f;
constexpr float kOpen = 0.995f;     // an iris that narrows nothing
constexpr float kBehind_m = 0.001f; // what is looked through
constexpr float kSeam_m = 0.01f;    // from the middle of a beam to what closes a gap between two decks

// A file without a Beam has been given one, and where its zooms have no range they have been given the angle
// of its first Beam at both ends.
bool is_angle_said(const fixture::Type& type, const fixture::Mode& mode, const fixture::BeamState& shown) {
    const auto& beam = type.geometries[static_cast<std::size_t>(shown.geometry)].beam;
    if (!beam) return true; // of a laser
    if (beam->is_assumed) return false;
    const auto first = std::find_if(type.geometries.begin(), type.geometries.end(),
                                    [](const fixture::Geometry& one) { return one.beam.has_value(); });
    const float given_deg = first->beam->field_angle_deg;
    bool has_zoom = false, has_range = false;
    for (const fixture::Channel& channel : mode.channels)
        for (const fixture::ChannelFunction& function : channel.functions) {
            if (function.meaning.role != fixture::Role::zoom) continue;
            has_zoom = true;
            has_range |= function.physical_from != given_deg || function.physical_to != given_deg;
        }
    return !has_zoom || has_range;
}

// A pan or tilt without a range has been given one.
bool is_range_said(const fixture::Mode& mode, fixture::Role role) {
    for (const fixture::Channel& channel : mode.channels)
        for (const fixture::ChannelFunction& function : channel.functions)
            if (function.meaning.role == role && function.is_range_assumed) return false;
    return true;
}

// Its opening is a share of the field's diameter.
float angle_behind_iris_deg(const fixture::Optics& optics) {
    return glm::degrees(2 * std::atan(optics.iris * std::tan(glm::radians(0.5f * optics.zoom_deg))));
}

// The middle of all its beams.
void aim(const glm::mat4& to_world, const fixture::State& state, FocusLamp& lamp) {
    glm::vec3 lens(0), way(0);
    for (const fixture::BeamState& beam : state.beams) {
        const glm::mat4 frame = to_world * beam.to_fixture;
        lens += glm::vec3(frame[3]) / static_cast<float>(state.beams.size());
        way -= glm::normalize(glm::vec3(frame[2]));
    }
    if (!(glm::length(way) > 1e-3f)) way = -glm::vec3((to_world * state.beams[0].to_fixture)[2]);
    lamp.lens_m = lens;
    lamp.way = glm::normalize(way);
    lamp.angle_deg = angle_behind_iris_deg(state.beams[0].optics);
}

// Across the way.
glm::vec3 aside_of(const glm::vec3& way) {
    return glm::normalize(glm::cross(way, std::abs(way.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0)));
}

// What the middle of a beam would meet if it did not fall through a gap narrower than two centimetres: both
// of its sides then meet it at one distance, in front of what the middle meets.
std::optional<FocusHit> beside_seam(const glm::vec3& from_m, const glm::vec3& way, const FindHit& find,
                                    const std::optional<FocusHit>& middle) {
    const glm::vec3 aside = aside_of(way), up = glm::cross(aside, way);
    for (const glm::vec3& across : {aside, up, glm::normalize(aside + up), glm::normalize(aside - up)}) {
        const std::optional<FocusHit> one = find(from_m + kSeam_m * across, way);
        const std::optional<FocusHit> other = find(from_m - kSeam_m * across, way);
        if (!one || !other || one->is_bar || other->is_bar || glm::dot(one->normal, other->normal) < kLevel)
            continue;
        const float distance_m = 0.5f * (one->distance_m + other->distance_m);
        // A slope between two sides as far apart as they are: what both lie on.
        const float apart_m = std::abs(one->distance_m - other->distance_m);
        const float slope = std::abs(glm::dot(one->normal, way));
        if (apart_m * slope > 2.1f * kSeam_m || (middle && distance_m + kSeam_m > middle->distance_m))
            continue;
        FocusHit closed = *one;
        closed.distance_m = distance_m;
        return closed;
    }
    return std::nullopt;
}

std::optional<FocusHit> hit_of(FocusLamp& lamp, const FindHit& find) {
    for (float gone_m = 0;;) {
        const glm::vec3 from_m = lamp.lens_m + gone_m * lamp.way;
        std::optional<FocusHit> hit = find(from_m, lamp.way);
        if (auto closed = beside_seam(from_m, lamp.way, find, hit)) hit = std::move(closed);
        if (!hit) return hit;
        hit->distance_m += gone_m;
        if (!hit->is_bar || hit->distance_m >= kAtLens_m) return hit;
        lamp.is_looked_past = true;
        gone_m = hit->distance_m + kBehind_m;
    }
}

void add_pool(FocusLamp& lamp) {
    const float floor_m = lamp.aim_m().z;
    const glm::vec3 aside = aside_of(lamp.way), up = glm::cross(aside, lamp.way);
    const float half = glm::radians(0.5f * lamp.angle_deg);
    std::size_t after_gap = 0; // the first point behind where the edge misses the floor
    for (int k = 0; k < kEdge; ++k) {
        const float round = 6.2831853f * static_cast<float>(k) / kEdge;
        const glm::vec3 way =
            std::cos(half) * lamp.way + std::sin(half) * (std::cos(round) * aside + std::sin(round) * up);
        const float distance = (floor_m - lamp.lens_m.z) / way.z;
        if (way.z < -1e-4f && distance < kFarthest_m) {
            lamp.pool_m.emplace_back(lamp.lens_m.x + distance * way.x, lamp.lens_m.y + distance * way.y);
        } else {
            lamp.is_pool_whole = false;
            after_gap = lamp.pool_m.size();
        }
    }
    std::rotate(lamp.pool_m.begin(), lamp.pool_m.begin() + static_cast<std::ptrdiff_t>(after_gap),
                lamp.pool_m.end());
}

std::string hit_text(const FocusChart& chart, const FocusLamp& lamp) {
    if (lamp.hit) return lamp.hit->what;
    return chart.has_stage && lamp.is_aim_known() ? chart.style("hits nothing") : "";
}

std::string place_text(const PrintStyle& style, const glm::vec3& at_m) {
    return across_text(style, static_cast<double>(at_m.x)) + ", " +
           along_text(style, static_cast<double>(at_m.y)) + ", z " +
           style.length_said(static_cast<double>(at_m.z));
}

} // namespace

std::string across_text(const PrintStyle& style, double x_m) {
    if (std::abs(x_m) < kOnLine_m) return style.length_said(0);
    const std::string length = style.length_said(std::abs(x_m));
    return x_m > 0 ? style("%1 right", {length}) : style("%1 left", {length});
}

std::string along_text(const PrintStyle& style, double y_m) {
    if (std::abs(y_m) < kOnLine_m) return style.length_said(0);
    const std::string length = style.length_said(std::abs(y_m));
    return y_m > 0 ? style("%1 up-stage", {length}) : style("%1 to the house", {length});
}

FocusChart focus_of(const Show& show, std::span<const fixture::State> states, const FindHit& find,
                    const PrintStyle& style, const std::string& moment, std::span<const glm::mat4> moved) {
    FocusChart chart;
    chart.show = show.name.empty() ? show.folder.filename().string() : show.name;
    chart.style = style;
    chart.moment = moment;
    chart.has_stage = find != nullptr;
    const std::vector<Hanging> hangings = hangings_of(show);
    std::vector<std::string> beamless, unsaid, turnless, aimless, angleless, irised, looked_past, near;
    for (const std::size_t i : in_hanging_order(hangings)) {
        const PatchedFixture& fixture = show.fixtures[i];
        if (!fixture.type || i >= states.size() || states[i].beams.empty()) {
            beamless.push_back(fixture.name);
            continue;
        }
        if (!fixture.is_place_known || !fixture.is_mode_known) {
            unsaid.push_back(fixture.name);
            continue;
        }
        FocusLamp& lamp = chart.lamps.emplace_back();
        lamp.name = fixture.name;
        lamp.number = fixture.fixture_id;
        lamp.position = hangings[i].position;
        lamp.unit = hangings[i].unit;
        lamp.focus_point = hangings[i].focus;
        const glm::mat4 by = i < moved.size() ? moved[i] : glm::mat4(1.0f);
        lamp.place_m = glm::vec3(by * glm::vec4(fixture.position_m, 1.0f));
        lamp.pan_deg = states[i].pan_deg;
        lamp.tilt_deg = states[i].tilt_deg;
        lamp.has_axes = !states[i].axes.empty();
        lamp.light_percent = values_of(*fixture.type, states[i]).light_percent;
        aim(by * fixture_to_world(fixture, 0), states[i], lamp);
        const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
        lamp.is_rotation_known = fixture.is_rotation_known;
        lamp.is_pan_known = is_range_said(mode, fixture::Role::pan);
        lamp.is_tilt_known = is_range_said(mode, fixture::Role::tilt);
        lamp.is_angle_known = is_angle_said(*fixture.type, mode, states[i].beams.front());
        if (!lamp.is_rotation_known)
            turnless.push_back(fixture.name);
        else if (!lamp.is_aim_known())
            aimless.push_back(fixture.name);
        else if (find)
            lamp.hit = hit_of(lamp, find);
        else if (lamp.way.z < -1e-3f && lamp.lens_m.z > 0)
            lamp.hit = FocusHit{-lamp.lens_m.z / lamp.way.z, {0, 0, 1}, ""};
        lamp.is_on_floor = lamp.hit && lamp.hit->normal.z > kLevel;
        if (lamp.is_on_floor && lamp.is_angle_known) add_pool(lamp);
        if (!lamp.is_angle_known) angleless.push_back(fixture.name);
        if (lamp.is_angle_known && states[i].beams.front().optics.iris < kOpen)
            irised.push_back(fixture.name);
        if (lamp.is_looked_past) looked_past.push_back(fixture.name);
        if (find && lamp.hit && lamp.hit->distance_m < kAtLens_m) near.push_back(fixture.name);
    }
    const std::string at_lens = style.length_said(static_cast<double>(kAtLens_m));
    if (show.fixtures.empty()) chart.unknown.push_back(style("The show has no fixtures."));
    if (!find)
        chart.unknown.push_back(
            show.stage_file.empty()
                ? style("The show has no stage model: what a beam hits is not known, and its floor is z = 0.")
                : style("The stage model could not be read: what a beam hits is not known, and its floor is "
                        "z = 0."));
    if (!beamless.empty())
        chart.unknown.push_back(style("Without a beam, or without a file that could be read: %1.",
                                      {names_text(beamless, style)}));
    if (!unsaid.empty())
        chart.unknown.push_back(
            style("Left out, for nobody says a place that can be used, or a mode that the type has: %1.",
                  {names_text(unsaid, style)}));
    if (!turnless.empty())
        chart.unknown.push_back(
            style("Nobody says how they are turned: where the beam goes is not known of %1.",
                  {names_text(turnless, style)}));
    if (!aimless.empty())
        chart.unknown.push_back(
            style("Pan or tilt without a range in the file: where the beam goes is not known of %1.",
                  {names_text(aimless, style)}));
    if (!angleless.empty())
        chart.unknown.push_back(style("Nobody says the angle of %1 (no Beam in the file, or a zoom without a "
                                      "range): no pool is drawn.",
                                      {names_text(angleless, style)}));
    if (!irised.empty())
        chart.unknown.push_back(style("The iris narrows angle and pool of %1.", {names_text(irised, style)}));
    if (!looked_past.empty())
        chart.unknown.push_back(style("Looked through is a truss or pipe within %1 of the lens of %2.",
                                      {at_lens, names_text(looked_past, style)}));
    if (!near.empty())
        chart.unknown.push_back(style("What is hit within %1 of the lens may be a mistake of the model: %2.",
                                      {at_lens, names_text(near, style)}));
    return chart;
}

PaperTable table_of(const FocusChart& chart) {
    const PrintStyle& style = chart.style;
    const std::string m = " " + style.length_unit();
    PaperTable table{"focus", style("Focus charts"), {}, {}, chart.unknown};
    table.unknown.insert(table.unknown.begin(), chart.moment);
    table.columns = {{style("hangs on")},
                     {style("unit"), true},
                     {style("number")},
                     {style("name")},
                     {style("place")},
                     {style("focus point")},
                     {style("aims at")},
                     {style("hits")},
                     {style("throw") + m, true},
                     {style("angle"), true},
                     {style("pan"), true},
                     {style("tilt"), true},
                     {style("light") + " %", true}};
    for (const FocusLamp& lamp : chart.lamps)
        table.rows.push_back(
            {{lamp.position, lamp.unit, lamp.number, lamp.name, place_text(style, lamp.place_m),
              lamp.focus_point, lamp.hit ? place_text(style, lamp.aim_m()) : "", hit_text(chart, lamp),
              lamp.hit ? style.length(static_cast<double>(lamp.hit->distance_m)) : "",
              lamp.is_angle_known ? style.number(static_cast<double>(lamp.angle_deg), 1) : "",
              lamp.has_axes && lamp.is_pan_known ? style.number(static_cast<double>(lamp.pan_deg), 1) : "",
              lamp.has_axes && lamp.is_tilt_known ? style.number(static_cast<double>(lamp.tilt_deg), 1) : "",
              style.number(static_cast<double>(lamp.light_percent), 0)}});
    return table;
}

} // namespace ghost::scene
