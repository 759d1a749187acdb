#pragma once
// SPDX-License-Identifier: Apache-2.0
// The doctor on a show or a plot that was opened: the loaders' report with kinds and advice, the patch
// (doctor_patch.h), names and UUIDs given twice, and for each fixture file that is missing the nearest one
// that is there. One thread per show.

#include "base/report.h"
#include "diagnose/doctor.h"
#include "fixture/type.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;

// Fixture files that may stand in for missing ones. Those in the plot's own archive need not be listed.
struct FixtureOffers {
    std::vector<std::string> names;           // what files and their fixtures are called, for comparing
    std::vector<std::filesystem::path> files; // one per name
    std::function<std::shared_ptr<const fixture::Type>(std::size_t)> load; // null: cannot be read
};

// No desk lights it: it has no beam, or a stand-in that hands alone light.
bool is_dark_by_desk(const fixture::Type& type, const fixture::Mode& mode);

std::vector<Finding> findings_of(const Show& show, const Report& report, const FixtureOffers& offers);

} // namespace ghost::scene
