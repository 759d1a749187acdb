// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/load_type.h"
#include "project/load_show.h"
#include "project/private/made_types.h"
#include "show/plot_entries.h"
#include "show_file/show_toml.h"

#include <algorithm>
#include <map>
#include <memory>

namespace ghost::scene {

Result<Show> preview_edit(const Show& before, const std::string& text) {
    Report unsaid; // whoever opens the text says it
    TRY(ParsedShow parsed, parse_show(text, before.file, unsaid));
    std::map<std::filesystem::path, std::shared_ptr<const fixture::Type>> types;
    for (const PatchedFixture& fixture : before.fixtures) types[fixture.gdtf] = fixture.type;
    const auto type_of = [&](const std::filesystem::path& gdtf) {
        const auto known = types.find(gdtf);
        if (known != types.end()) return known->second;
        const std::filesystem::path file = before.folder / gdtf;
        auto loaded = fixture::load_type(file); // what is wrong with it, whoever opens the text says
        return types[gdtf] =
                   loaded.ok() ? std::make_shared<const fixture::Type>(std::move(loaded->type)) : nullptr;
    };
    Show show = before;
    show.fixtures = std::move(parsed.show.fixtures);
    if (!parsed.show.cameras.empty())
        show.cameras = std::move(parsed.show.cameras); // else those that were made
    show.cues = std::move(parsed.show.cues);
    show.haze = parsed.show.haze;
    show.hazers = std::move(parsed.show.hazers);
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        PatchedFixture& fixture = show.fixtures[i];
        const auto same =
            std::find_if(before.fixtures.begin(), before.fixtures.end(), [&](const PatchedFixture& one) {
                return one.uuid.empty() && one.name == fixture.name;
            });
        if (same != before.fixtures.end()) fixture.shape = same->shape;
        fixture.type = fixture.gdtf.empty() ? type_without_file(fixture) : type_of(fixture.gdtf);
        if (!fixture.type) continue;
        if (const auto mode = fixture::find_mode(*fixture.type, parsed.sources[i].mode); mode.ok())
            fixture.mode = *mode;
    }
    for (PatchedFixture fixture : before.fixtures) {
        if (fixture.uuid.empty()) continue;
        bool hidden = false;
        for (const ChangeEntry& change : parsed.changes) {
            if (change.uuid != fixture.uuid) continue;
            if (change.name) fixture.name = *change.name;
            if (change.position_m) fixture.position_m = *change.position_m;
            if (change.rotation_deg) fixture.rotation_deg = *change.rotation_deg;
            if (change.hidden) hidden = *change.hidden;
            if (change.address && change.dmx_break == 1) {
                fixture.universe = change.address->universe;
                fixture.address = change.address->channel;
            }
            if (change.mode && fixture.type)
                if (const auto mode = fixture::find_mode(*fixture.type, *change.mode); mode.ok())
                    fixture.mode = *mode;
        }
        if (!hidden) show.fixtures.push_back(std::move(fixture));
    }
    return show;
}

} // namespace ghost::scene
