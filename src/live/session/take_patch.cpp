// SPDX-License-Identifier: Apache-2.0
#include "live/session/take_patch.h"

#include "light/beam_shape.h"
#include "light/led_wall_light.h"

#include <algorithm>

namespace ghost::app {
namespace {

// As many lights, and the same panel.
bool is_same_wall(const std::optional<scene::LedWall>& a, const std::optional<scene::LedWall>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return a->size_m == b->size_m && scene::cells_of(*a) == scene::cells_of(*b) && a->has_body == b->has_body;
}

bool is_same_shape(const std::shared_ptr<const scene::BeamShape>& a,
                   const std::shared_ptr<const scene::BeamShape>& b) {
    if (!a || !b) return a == b;
    return a->file == b->file && a->texels == b->texels && a->flux_lm == b->flux_lm;
}

bool hangs_the_same(const scene::PatchedFixture& a, const scene::PatchedFixture& b) {
    const bool has_types = (a.type == nullptr) == (b.type == nullptr);
    return has_types && a.gdtf == b.gdtf && a.mode == b.mode && a.uuid == b.uuid &&
           a.stops_m() == b.stops_m() && a.rotation_deg == b.rotation_deg &&
           a.home_pan_deg == b.home_pan_deg && a.home_tilt_deg == b.home_tilt_deg &&
           a.track.has_value() == b.track.has_value() && a.mover == b.mover && is_same_wall(a.wall, b.wall) &&
           is_same_shape(a.shape, b.shape);
}

} // namespace

bool take_patch(Session& session, const scene::Show& edited, const Report& report) {
    std::vector<scene::PatchedFixture>& fixtures = session.show->fixtures;
    if (!std::equal(fixtures.begin(), fixtures.end(), edited.fixtures.begin(), edited.fixtures.end(),
                    hangs_the_same))
        return false;
    if (edited.movers.size() != session.show->movers.size()) return false;
    for (std::size_t i = 0; i < fixtures.size(); ++i) {
        auto type = std::move(fixtures[i].type); // gobos and bodies are those of the old one
        auto shape = std::move(fixtures[i].shape);
        fixtures[i] = edited.fixtures[i];
        fixtures[i].type = std::move(type);
        fixtures[i].shape = std::move(shape);
    }
    session.show->cues = edited.cues;
    session.show->palettes = edited.palettes;
    session.show->movers = edited.movers; // channels of fixtures may be elsewhere
    const std::unique_ptr<scene::Rig> before = std::move(session.rig);
    session.rig = std::make_unique<scene::Rig>(*session.show);
    std::vector<std::optional<std::size_t>> same;
    for (std::size_t i = 0; i < fixtures.size(); ++i) same.emplace_back(i);
    session.rig->go_on_from(*before, same);
    std::vector<Message>& messages = session.report.messages;
    messages.erase(messages.begin(), messages.begin() + static_cast<std::ptrdiff_t>(session.of_show_file));
    messages.insert(messages.begin(), report.messages.begin(), report.messages.end());
    session.of_show_file = report.messages.size();
    return true;
}

} // namespace ghost::app
