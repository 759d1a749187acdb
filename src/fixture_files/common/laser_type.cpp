// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/laser_type.h"

#include "base/check.h"
#include "fixture/laser_curve.h"
#include "fixture_files/common/type_builder.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace ghost::fixture {
namespace {

constexpr float kOutput_w = 10.0f;
constexpr float kDiameter_m = 0.005f;
constexpr float kDivergence_mrad = 1.0f;
constexpr float kTurning_deg_s = 180.0f;
constexpr float kRunning_hz = 5.0f;
constexpr std::uint32_t kPerFigure = 37; // values of the channel
constexpr int kLeastRays = 1;

struct Draft {
    const char* name;
    std::uint32_t initial;
    std::vector<ChannelFunction> functions;
};

// Back, at rest, and on.
std::vector<ChannelFunction> both_ways(const char* attribute, float most) {
    return {make_function(attribute, 0, 125, -most, 0.0f), make_function(attribute, 126, 129, 0.0f, 0.0f),
            make_function(attribute, 130, 255, 0.0f, most)};
}

std::vector<ChannelFunction> figures() {
    std::vector<ChannelFunction> functions;
    for (std::size_t k = 0; k < kFigureNames.size(); ++k) {
        const auto from = static_cast<std::uint32_t>(k) * kPerFigure;
        const bool is_last = k + 1 == kFigureNames.size();
        ChannelFunction& function =
            functions.emplace_back(make_function("LaserFigure", from, is_last ? 255 : from + kPerFigure - 1,
                                                 static_cast<float>(k), static_cast<float>(k)));
        function.name = kFigureNames[k];
    }
    return functions;
}

// Lasers of 638, 520 and 450 nm, balanced to white: share of the lumens.
ChannelFunction colour(TypeBuilder& builder, const char* attribute, const char* name, const ColorCie& cie) {
    ChannelFunction function = make_function(attribute, 0, 255, 0.0f, 1.0f);
    function.emitter = builder.add_emitter(name, cie);
    return function;
}

std::shared_ptr<const Type> show_laser() {
    auto type = std::make_shared<Type>();
    type->name = "Show laser";
    type->manufacturer = "Ghostlight";
    Laser laser;
    laser.output_w = kOutput_w;
    laser.diameter_m = kDiameter_m;
    laser.divergence_min_mrad = laser.divergence_max_mrad = kDivergence_mrad;
    laser.scan_pan_deg = laser.scan_tilt_deg = kWidestFigure_deg;
    ModeDraft mode;
    mode.body.size_m = {0.4f, 0.3f, 0.2f};
    mode.body.cells = {{0, 0}};
    mode.body.cell_groups = {0};
    mode.body.beam = beam_of(laser);
    TypeBuilder builder(*type);
    const Draft drafts[] = {
        {"Dimmer", 255, {make_function("Dimmer", 0, 255, 0.0f, 1.0f)}},
        {"Shutter",
         255,
         {make_function("Shutter1", 0, 63, 0.0f, 0.0f), make_function("Shutter1Strobe", 64, 191, 1.0f, 20.0f),
          make_function("Shutter1", 192, 255, 1.0f, 1.0f)}},
        {"Red", 255, {colour(builder, "ColorAdd_R", "638 nm", {0.7183f, 0.2815f, 25.0f})}},
        {"Green", 255, {colour(builder, "ColorAdd_G", "520 nm", {0.0743f, 0.8338f, 68.0f})}},
        {"Blue", 255, {colour(builder, "ColorAdd_B", "450 nm", {0.1566f, 0.0177f, 7.0f})}},
        {"Figure", 0, figures()},
        {"Rays", 60, {make_function("LaserRays", 0, 255, kLeastRays, kMostRays)}},
        {"Width", 85, {make_function("LaserWidth", 0, 255, 0.0f, kWidestFigure_deg)}},
        {"Height", 43, {make_function("LaserHeight", 0, 255, 0.0f, kWidestFigure_deg)}},
        {"Turn", 0, {make_function("LaserTurn", 0, 255, 0.0f, 360.0f)}},
        {"Turning", 128, both_ways("LaserTurning", kTurning_deg_s)},
        {"Running", 128, both_ways("LaserRunning", kRunning_hz)},
    };
    for (const Draft& draft : drafts) {
        ChannelDraft made;
        made.channel.name = draft.name;
        made.channel.offsets = {mode.footprint++};
        made.channel.initial = draft.initial;
        made.channel.logical.push_back({draft.functions.front().attribute});
        made.channel.functions = draft.functions;
        for (ChannelFunction& function : made.channel.functions) function.dmx_default = draft.initial;
        mode.channels.push_back(std::move(made));
    }
    mode.name = std::to_string(mode.footprint) + " channels";
    CHECK(builder.add_mode(std::move(mode)));
    for (Geometry& geometry : type->geometries)
        if (geometry.beam) {
            geometry.kind = GeometryKind::laser;
            geometry.laser = laser;
            geometry.beam = beam_of(laser);
        }
    return type;
}

} // namespace

Beam beam_of(const Laser& laser) {
    constexpr float kDegPerMrad = 0.0572958f, kLeast_deg = 0.05f;
    Beam beam;
    beam.lamp_type = "Laser";
    beam.luminous_flux_lm = kLaserLumensPerWatt * laser.output_w;
    beam.beam_radius_m = 0.5f * laser.diameter_m;
    const float divergence_mrad = std::max(laser.divergence_max_mrad, laser.divergence_min_mrad);
    beam.beam_angle_deg = beam.field_angle_deg = std::max(kLeast_deg, divergence_mrad * kDegPerMrad);
    beam.beam_type = BeamType::spot;
    beam.emitter = laser.emitter;
    return beam;
}

std::shared_ptr<const Type> show_laser_type() {
    static const std::shared_ptr<const Type> type = show_laser();
    return type;
}

} // namespace ghost::fixture
