// SPDX-License-Identifier: Apache-2.0
#include "mvr/mvr_load.h"
#include "plots/plot_changes.h"
#include "plots/plot_show.h"
#include "plots/plot_stage.h"
#include "show/movers.h"
#include "show_folder/load_show.h"
#include "show_folder/private/show_types.h"

#include <algorithm>

namespace ghost::scene {

Result<Show> preview_edit(const Show& before, const std::string& text, KnownTypes known) {
    Report unsaid; // whoever opens the text says it
    TRY(ParsedShow parsed, parse_show(text, before.file, unsaid));
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
    if (before.plot) {
        Plot plot = before.plot->unchanged ? *before.plot->unchanged : before.plot->plot;
        apply_changes(plot, parsed.changes, before.plot_origin_m, unsaid);
        add_known_fixtures(show, plot, shown_objects(plot, before.hidden_layers, before.hidden_classes),
                           parsed.substitutes, parsed.walls, before.fixtures);
        apply_circuits(show, parsed.changes);
    }
    show.movers = std::move(parsed.show.movers);
    check_movers(show, unsaid); // finds what carries each fixture
    return show;
}

} // namespace ghost::scene
