// SPDX-License-Identifier: Apache-2.0
#include "show/plot_entries.h"
#include "show_folder/load_show.h"
#include "show_folder/private/show_types.h"

#include <algorithm>

namespace ghost::scene {

Result<Show> preview_edit(const Show& before, const std::string& text) {
    Report unsaid; // whoever opens the text says it
    TRY(ParsedShow parsed, parse_show(text, before.file, unsaid));
    KnownTypes known;
    for (const PatchedFixture& fixture : before.fixtures)
        if (fixture.type) known[(before.folder / fixture.gdtf).lexically_normal()] = fixture.type;
    load_types(parsed, std::move(known), unsaid);
    Show show = before;
    show.fixtures = std::move(parsed.show.fixtures);
    if (!parsed.show.cameras.empty())
        show.cameras = std::move(parsed.show.cameras); // else those that were made
    show.circuits = std::move(parsed.show.circuits);
    show.cues = std::move(parsed.show.cues);
    show.palettes = std::move(parsed.show.palettes);
    show.haze = parsed.show.haze;
    show.hazers = std::move(parsed.show.hazers);
    show.bounce = parsed.show.bounce;
    for (PatchedFixture& fixture : show.fixtures) {
        const auto same =
            std::find_if(before.fixtures.begin(), before.fixtures.end(), [&](const PatchedFixture& one) {
                return one.uuid.empty() && one.name == fixture.name;
            });
        if (same != before.fixtures.end()) fixture.shape = same->shape;
    }
    for (PatchedFixture fixture : before.fixtures) {
        if (fixture.uuid.empty()) continue;
        bool hidden = false;
        for (const ChangeEntry& change : parsed.changes) {
            if (change.uuid != fixture.uuid) continue;
            if (change.name) fixture.name = *change.name;
            if (change.position_m) {
                fixture.position_m = *change.position_m;
                fixture.is_place_known = true;
            }
            if (change.rotation_deg) {
                fixture.rotation_deg = *change.rotation_deg;
                fixture.is_rotation_known = true;
            }
            if (change.hidden) hidden = *change.hidden;
            if (change.circuit) fixture.circuit = *change.circuit;
            if (change.address && change.dmx_break == 1) {
                fixture.universe = change.address->universe;
                fixture.address = change.address->channel;
                fixture.is_address_known |= fixture.more_addresses.empty();
            }
            if (change.mode && fixture.type)
                if (const auto mode = fixture::find_mode(*fixture.type, *change.mode); mode.ok()) {
                    fixture.mode = *mode;
                    fixture.is_mode_known = true;
                }
        }
        if (!hidden) show.fixtures.push_back(std::move(fixture));
    }
    return show;
}

} // namespace ghost::scene
