// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/projector_type.h"

#include "base/check.h"
#include "fixture_files/common/type_builder.h"

#include <utility>

namespace ghost::fixture {
namespace {

constexpr float kFlux_lm = 20000.0f; // of a large one on tour
constexpr float kLens_m = 0.04f;     // radius

ChannelDraft draft_of(const char* name, int place, std::uint32_t initial,
                      std::vector<ChannelFunction> functions) {
    ChannelDraft draft;
    draft.channel.name = name;
    draft.channel.offsets = {place};
    draft.channel.initial = initial;
    draft.channel.logical.push_back({functions.front().attribute});
    for (ChannelFunction& function : functions) function.dmx_default = initial;
    draft.channel.functions = std::move(functions);
    return draft;
}

std::shared_ptr<const Type> video_projector() {
    auto type = std::make_shared<Type>();
    type->name = "Video projector";
    type->manufacturer = "Ghostlight";
    ModeDraft mode;
    mode.name = "3 channels";
    mode.body.size_m = {0.6f, 0.25f, 0.6f};
    mode.body.cells = {{0, 0}};
    mode.body.cell_groups = {0};
    mode.body.beam.lamp_type = "LED";
    mode.body.beam.luminous_flux_lm = kFlux_lm;
    mode.body.beam.color_temperature_k = 6500.0f;
    mode.body.beam.beam_type = BeamType::rectangle;
    mode.body.beam.beam_angle_deg = mode.body.beam.field_angle_deg = 40.0f;
    mode.channels.push_back(draft_of("Dimmer", 0, 255, {make_function("Dimmer", 0, 255, 0.0f, 1.0f)}));
    mode.channels.push_back(draft_of(
        "Shutter", 1, 255,
        {make_function("Shutter1", 0, 127, 0.0f, 0.0f), make_function("Shutter1", 128, 255, 1.0f, 1.0f)}));
    mode.channels.push_back(draft_of("Focus", 2, 128, {make_function("Focus1", 0, 255, 0.0f, 1.0f)}));
    mode.footprint = 3;
    CHECK(TypeBuilder(*type).add_mode(std::move(mode)));
    for (Geometry& geometry : type->geometries)
        if (geometry.beam) geometry.beam->beam_radius_m = kLens_m;
    return type;
}

} // namespace

std::shared_ptr<const Type> video_projector_type() {
    static const std::shared_ptr<const Type> type = video_projector();
    return type;
}

} // namespace ghost::fixture
