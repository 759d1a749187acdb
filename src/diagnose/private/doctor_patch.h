#pragma once
// SPDX-License-Identifier: Apache-2.0
// The doctor on a patch: shared, missing and impossible addresses, modes whose length the patch contradicts,
// fixtures that give no light, numbers given twice. Faults of equal fixtures are one finding. Pure; any
// thread.

#include "diagnose/doctor.h"
#include "fixture/type.h"

#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

struct PatchedFixture;
struct Show;

struct PatchEntry {
    const PatchedFixture* fixture = nullptr; // not owned
    std::string where;
    std::string spec;           // the fixture file that it asks for
    std::string mode;           // that it asks for
    bool of_plot = false;       // else of the show file
    bool is_multipatch = false; // the plot says that it follows another one
};

// One for each fixture of the show, in its order; the show file is read again for its lines.
std::vector<PatchEntry> entries_of(const Show& show);

std::vector<Finding> check_rig(std::span<const PatchEntry> entries);

// How many channels apart equal fixtures stand: the distance that at least half of the neighbours keep, two
// times or more; 0: none. Fixtures of others between two of them make no neighbours of them.
int spacing_of(std::span<const PatchEntry> entries, std::span<const std::size_t> equal);

// Mode of the type with so many channels in break 1; -1: none.
int mode_of_length(const fixture::Type& type, int channels);

} // namespace ghost::scene
