// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/wall_type.h"

#include "fixture_files/common/type_builder.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace ghost::fixture {
namespace {

constexpr float kBefore_m = 0.02f; // of the panel: there the lights stand, free of it
// Makers' viewing angle, where a wall has half its luminance times cosine.
constexpr float kBeam_deg = 120.0f;
constexpr float kField_deg = 160.0f;

void add(Type& type, Mode& mode, const std::string& name, int parent, const glm::mat4& local) {
    Geometry geometry;
    geometry.kind = parent < 0 ? GeometryKind::geometry : GeometryKind::beam;
    geometry.name = name;
    geometry.local = local;
    geometry.parent = parent;
    if (parent >= 0)
        type.geometries[static_cast<std::size_t>(parent)].children.push_back(
            static_cast<int>(type.geometries.size()));
    Node node;
    node.name = name;
    node.geometry = static_cast<int>(type.geometries.size());
    node.parent = parent;
    node.local = local;
    type.geometries.push_back(std::move(geometry));
    mode.nodes.push_back(std::move(node));
}

Channel dimmer(int cells) {
    Channel channel;
    channel.name = "Dimmer";
    channel.offsets = {0};
    channel.initial = 255;
    channel.logical.push_back({"Dimmer"});
    ChannelFunction function = make_function("Dimmer", 0, 255, 0.0f, 1.0f);
    function.dmx_default = 255;
    channel.functions.push_back(std::move(function));
    for (int cell = 0; cell < cells; ++cell) channel.beams.push_back(cell);
    return channel;
}

} // namespace

std::shared_ptr<const Type> led_wall_type(const glm::vec2& size_m, const glm::ivec2& cells, float nits,
                                          const glm::mat4& place) {
    auto type = std::make_shared<Type>();
    type->name = "LED wall";
    type->manufacturer = "Ghostlight";
    Mode mode;
    mode.name = "1 channel";
    add(*type, mode, "Wall", -1, place);
    const glm::vec2 step_m = size_m / glm::vec2(cells);
    for (int row = 0; row < cells.y; ++row)
        for (int column = 0; column < cells.x; ++column) {
            // Light leaves along local -Z; local X stays the wall's right.
            glm::mat4 local(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0),
                            glm::vec4(0, 0, 0, 1));
            local[3] = {(static_cast<float>(column) + 0.5f) * step_m.x - 0.5f * size_m.x, -kBefore_m,
                        0.5f * size_m.y - (static_cast<float>(row) + 0.5f) * step_m.y, 1.0f};
            mode.beams.push_back(static_cast<int>(mode.nodes.size()));
            add(*type, mode, "Cell " + std::to_string(mode.beams.size()), 0, local);
            Beam beam;
            beam.lamp_type = "LED";
            beam.beam_type = BeamType::area;
            beam.color_temperature_k = 6500.0f;
            beam.luminous_flux_lm = std::numbers::pi_v<float> * nits * step_m.x * step_m.y;
            beam.beam_angle_deg = kBeam_deg;
            beam.field_angle_deg = kField_deg;
            beam.beam_radius_m =
                std::sqrt(step_m.x * step_m.y / std::numbers::pi_v<float>); // a disc as large
            type->geometries.back().beam = beam;
        }
    mode.channels.push_back(dimmer(cells.x * cells.y));
    mode.order = {0};
    mode.footprint = {1};
    type->modes.push_back(std::move(mode));
    return type;
}

} // namespace ghost::fixture
