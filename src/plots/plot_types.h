#pragma once
// SPDX-License-Identifier: Apache-2.0
// PlotTypes: the fixture types that a plot asks for: from its archive, or, where a file is not in it, from
// the folder of the plot. Each file is read once; faults are said once, with how many fixtures have them.
// One thread.

#include "base/name_index.h"
#include "base/report.h"
#include "base/text.h"
#include "fixture_files/common/picture_budget.h"
#include "mvr/mvr_load.h"
#include "show/plot_entries.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ghost::scene {

struct PatchedFixture; // show/show.h

// The mode of that name; where there is none, the one that lacks fewest of its numbers, then fewest edits
// away, whatever the case. -1: the type has no mode.
int nearest_mode(const fixture::Type& type, const std::string& name);

class PlotTypes {
public:
    PlotTypes(LoadedPlot& loaded, std::filesystem::path folder,
              const std::vector<SubstituteEntry>& substitutes, Report& report)
        : loaded_(loaded), folder_(std::move(folder)), substitutes_(substitutes), report_(report) {
        for (const SubstituteEntry& entry : substitutes) specs_.push_back(lower(entry.spec));
    }

    // Of fixtures that this plot had before. Of files that none of them is of only substitutes are read from
    // now on, for the archive is read by who opens the plot; other fixtures have no type.
    void know(const std::vector<PatchedFixture>& fixtures);

    struct Found {
        std::shared_ptr<const fixture::Type> type; // null: the fixture stays dark
        int mode = 0;
        bool is_mode_known = true; // false: the plot names none of the type's, and it gets one
    };
    // where: of the fixture, for messages.
    Found find(const PlotDevice& device, const std::string& where);

    // Its fixture file as a name for people; no path that leads anywhere.
    std::filesystem::path file_of(const PlotDevice& device);

    void finish(); // gives the messages that count fixtures

private:
    struct File {
        std::shared_ptr<const fixture::Type> type;
        std::filesystem::path name;
        const SubstituteEntry* substitute = nullptr;
        bool is_read = false;
    };
    struct WrongMode {
        Severity severity = Severity::error;
        std::string where;
        std::string what;
        int mode = 0; // that it gets
        int fixtures = 0;
    };
    File& file(int gdtf);
    std::filesystem::path beside(const std::string& spec) const;
    std::shared_ptr<const fixture::Type> read(const PlotGdtf& gdtf, const File& file);
    const SubstituteEntry* substitute_for(const PlotGdtf& gdtf);
    void forgive(const PlotGdtf& gdtf, const std::string& instead);

    LoadedPlot& loaded_;
    std::filesystem::path folder_;
    const std::vector<SubstituteEntry>& substitutes_;
    std::vector<std::string> specs_;        // of substitutes_, in small letters
    std::uint64_t steps_ = kMostMatchSteps; // that are left to compare them
    Report& report_;
    fixture::PictureBudget pictures_;
    std::map<int, File> files_;
    // By Plot::gdtf_files and File::name.
    using KnownFiles = std::map<std::pair<int, std::filesystem::path>, std::shared_ptr<const fixture::Type>>;
    std::optional<KnownFiles> known_; // nothing: files may be read
    std::map<std::pair<int, std::string>, WrongMode> wrong_modes_;
    std::size_t more_wrong_modes_ = 0; // fixtures that were not compared any more
};

} // namespace ghost::scene
