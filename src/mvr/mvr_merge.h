#pragma once
// SPDX-License-Identifier: Apache-2.0
// merge_plots: the designer sends a new version of the plot. Objects are the same where their UUIDs are; what
// the user changed in the old one is done again in the new one. Pure: the same plots and changes give the
// same result. Any thread.

#include "mvr/plot.h"

#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

struct MergeEntry {
    std::string uuid;
    ObjectKind kind = ObjectKind::scene_object;
    std::string name;
    std::string fixture_id; // the fixture's number; "" where it has none
    std::string what;       // "moved 1.20 m", "address 1.1 is now 2.17", ...
};

struct KeptChange {
    PlotChange change;
    std::string name; // of the object
    std::string fixture_id;
    bool both = false;     // the new plot changed the same thing, too: the user's change won
    std::string plot_says; // both: what the new plot says
};

struct MergeReport {
    std::vector<MergeEntry> added;
    std::vector<MergeEntry> removed;
    std::vector<MergeEntry> moved;     // its world matrix is another one
    std::vector<MergeEntry> repatched; // addresses
    std::vector<MergeEntry> changed;   // name, fixture file, mode, class, layer, what hangs on what
    std::vector<KeptChange> kept;      // the user's changes, done again
    std::vector<PlotChange> gone;      // changes whose object is no longer there
    std::size_t unchanged = 0;         // objects of which nothing above is to be said
    bool unrelated = false;            // both plots have objects, but not one UUID in common: another show?
};

struct MergedPlot {
    Plot plot; // the new one, with the changes kept
    MergeReport report;
};

// Several changes of the same thing of one object (and break): the last one counts. Objects without UUID, and
// all but the first of one UUID, are matched by kind, layer, name and their number among those.
MergedPlot merge_plots(const Plot& old_plot, const Plot& new_plot, std::span<const PlotChange> changes);

// A few lines for people: "3 added, 1 removed ..", then each by name.
std::string text_of(const MergeReport& report);

} // namespace ghost::scene
