// SPDX-License-Identifier: Apache-2.0
#include "plots/plot_types.h"

#include "base/text.h"
#include "fixture/patch.h"
#include "fixture_files/gdtf/gdtf.h"
#include "fixture_files/load_type.h"
#include "json_xml_toml/toml_reader.h"
#include "show/show.h"

#include "base/suggest.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ghost::scene {
namespace fs = std::filesystem;

namespace {

// "mode 2 - 8 bit": 2, 8
std::set<std::string> numbers_in(const std::string& text) {
    constexpr const char* kDigits = "0123456789";
    std::set<std::string> numbers;
    for (std::size_t at = text.find_first_of(kDigits); at != std::string::npos;) {
        const std::size_t end = std::min(text.find_first_not_of(kDigits, at), text.size());
        numbers.insert(text.substr(at, end - at));
        at = text.find_first_of(kDigits, end);
    }
    return numbers;
}

// Of a plot: each is compared with all modes of its file, and both come from outside.
constexpr std::size_t kMostWrongModes = 100;

int mode_named(const fixture::Type& type, const std::string& name) {
    const auto found = std::find_if(type.modes.begin(), type.modes.end(),
                                    [&](const auto& mode) { return mode.name == name; });
    return found == type.modes.end() ? -1 : static_cast<int>(found - type.modes.begin());
}

bool is_plain(const fs::path& file) {
    std::error_code code;
    return fs::is_regular_file(file, code);
}

} // namespace

int nearest_mode(const fixture::Type& type, const std::string& name) {
    constexpr std::size_t kLooked = 200; // letters: names come from outside
    const std::string wanted = lower(trimmed(name)).substr(0, kLooked);
    const std::set<std::string> wanted_numbers = numbers_in(wanted);
    if (const int same = mode_named(type, name); same >= 0) return same;
    int nearest = -1;
    std::pair<std::size_t, std::size_t> fewest; // numbers that are not there, letters that differ
    for (std::size_t k = 0; k < type.modes.size(); ++k) {
        const std::string other = lower(trimmed(type.modes[k].name)).substr(0, kLooked);
        const std::set<std::string> numbers = numbers_in(other);
        const auto missing = static_cast<std::size_t>(
            std::count_if(wanted_numbers.begin(), wanted_numbers.end(),
                          [&](const std::string& number) { return !numbers.contains(number); }));
        const std::pair differs(missing, edit_distance(wanted, other));
        if (nearest < 0 || differs < fewest) {
            nearest = static_cast<int>(k);
            fewest = differs;
        }
    }
    return nearest;
}

fs::path PlotTypes::beside(const std::string& spec) const {
    if (spec.empty() || spec.size() > 200) return {};
    const std::string name = fs::path(spec).filename().string();
    for (const fs::path& folder : {folder_, folder_ / "fixtures"}) {
        if (const fs::path file = folder / name; fixture::has_type_extension(file) && is_plain(file))
            return file;
        for (const std::string_view ending : fixture::kTypeEndings)
            if (const fs::path file = folder / (name + std::string(ending)); is_plain(file)) return file;
    }
    return {};
}

std::shared_ptr<const fixture::Type> PlotTypes::read(const PlotGdtf& gdtf, const File& file) {
    const std::string who = gdtf.objects == 1 ? "; its fixture stays dark" : "; its fixtures stay dark";
    const auto load = [&]() -> Result<fixture::LoadedType> {
        if (file.substitute || gdtf.member.empty()) return fixture::load_type(folder_ / file.name);
        TRY(const auto bytes, loaded_.archive.read(gdtf.member));
        return fixture::load_gdtf(bytes, loaded_.name + ": " + gdtf.member);
    };
    auto loaded = load();
    if (!loaded.ok()) {
        report_.add(Severity::error, loaded.error().where.empty() ? loaded_.name : loaded.error().where,
                    loaded.error().what + who);
        return nullptr;
    }
    for (const Message& message : loaded->messages)
        report_.add(message.severity, message.where, message.what);
    if (loaded->type.modes.empty()) {
        report_.add(Severity::error, loaded_.name + ": " + file.name.string(), "has no DMX mode" + who);
        return nullptr;
    }
    pictures_.take(loaded->type, loaded_.name + ": " + file.name.string(), report_);
    return std::make_shared<const fixture::Type>(std::move(loaded->type));
}

void PlotTypes::know(const std::vector<PatchedFixture>& fixtures) {
    known_.emplace();
    const ObjectIndex index(loaded_.plot);
    for (const PatchedFixture& fixture : fixtures) {
        const int object = fixture.uuid.empty() ? -1 : index.find(fixture.uuid);
        if (object < 0) continue;
        const int gdtf = loaded_.plot.objects[static_cast<std::size_t>(object)].device.gdtf;
        if (gdtf >= 0) known_->try_emplace({gdtf, fixture.gdtf}, fixture.type);
    }
}

PlotTypes::File& PlotTypes::file(int index) {
    File& file = files_[index];
    if (file.is_read) return file;
    file.is_read = true;
    const PlotGdtf& gdtf = loaded_.plot.gdtf_files[static_cast<std::size_t>(index)];
    file.name = fs::path(gdtf.member.empty() ? gdtf.spec : gdtf.member).filename();
    if (const SubstituteEntry* substitute = substitute_for(gdtf)) {
        file.substitute = substitute;
        file.name = substitute->gdtf;
        forgive(gdtf, file.name.string());
    } else if (gdtf.member.empty()) {
        const fs::path found = beside(gdtf.spec);
        if (found.empty()) return file; // the reader of the plot has said so
        file.name = found.lexically_relative(folder_);
        forgive(gdtf, found.string());
    }
    const auto known = known_ ? known_->find({index, file.name}) : KnownFiles::iterator{};
    if (known_ && known != known_->end())
        file.type = known->second;
    else if (!known_ || file.substitute) // who chose what stands in sees it at once
        file.type = read(gdtf, file);
    return file;
}

// What the reader said of the archive is right, and no loss any more.
void PlotTypes::forgive(const PlotGdtf& gdtf, const std::string& instead) {
    for (Message& message : report_.messages)
        if (message.severity == Severity::error &&
            message.what.find("'" + gdtf.spec + "' is not in the archive") != std::string::npos) {
            message.severity = Severity::note;
            message.what += "; " + instead + " is taken";
        }
}

const SubstituteEntry* PlotTypes::substitute_for(const PlotGdtf& gdtf) {
    const std::string names[] = {lower(gdtf.spec), lower(gdtf.member)};
    for (std::size_t k = 0; k < substitutes_.size(); ++k)
        for (const std::string& name : names)
            if (!name.empty() && matches(specs_[k], name, steps_)) return &substitutes_[k];
    return nullptr;
}

PlotTypes::Found PlotTypes::find(const PlotDevice& device, const std::string& where) {
    if (device.gdtf < 0) return {};
    const File& file_of_plot = file(device.gdtf);
    Found found{.type = file_of_plot.type};
    if (!found.type) return found;
    const bool is_chosen = file_of_plot.substitute && !file_of_plot.substitute->mode.empty();
    const std::string& wanted = is_chosen ? file_of_plot.substitute->mode : device.gdtf_mode;
    if (wanted.empty()) { // programs that know one mode only leave its name out
        found.is_mode_known = found.type->modes.size() == 1;
        return found;
    }
    if (const int same = mode_named(*found.type, wanted); same >= 0) return {found.type, same};
    found.is_mode_known = false;
    if (wrong_modes_.size() >= kMostWrongModes && !wrong_modes_.contains({device.gdtf, wanted})) {
        ++more_wrong_modes_;
        return found;
    }
    WrongMode& wrong = wrong_modes_[{device.gdtf, wanted}];
    if (wrong.fixtures++ == 0) {
        wrong.mode = nearest_mode(*found.type, wanted);
        const std::string& taken = found.type->modes[static_cast<std::size_t>(wrong.mode)].name;
        // Another maker's fixture has other modes; only one that was asked for by name is missing.
        if (file_of_plot.substitute && !is_chosen) wrong.severity = Severity::warning;
        wrong.where = is_chosen ? file_of_plot.substitute->where : where;
        const auto mode = fixture::find_mode(*found.type, wanted);
        wrong.what = (mode.ok() ? "" : mode.error().what) + "; it gets '" + taken + "'";
    }
    found.mode = wrong.mode;
    return found;
}

fs::path PlotTypes::file_of(const PlotDevice& device) {
    return device.gdtf >= 0 ? file(device.gdtf).name : fs::path(device.gdtf_spec).filename();
}

void PlotTypes::finish() {
    if (steps_ == 0)
        report_.add(Severity::error, substitutes_.front().where,
                    std::string("[[substitute]] ") + kMatchStepsSpent);
    for (const auto& [key, wrong] : wrong_modes_)
        report_.add(wrong.severity, wrong.where,
                    wrong.what +
                        (wrong.fixtures > 1 ? " (" + std::to_string(wrong.fixtures) + " fixtures)" : ""));
    if (more_wrong_modes_ > 0)
        report_.add(Severity::error, loaded_.name,
                    std::to_string(more_wrong_modes_) +
                        " more fixtures name other modes that their files do not have; they get the first. "
                        "The nearest is looked for " +
                        std::to_string(kMostWrongModes) + " times");
    wrong_modes_.clear();
    more_wrong_modes_ = 0;
    for (const SubstituteEntry& entry : substitutes_) {
        const bool used = std::any_of(files_.begin(), files_.end(),
                                      [&](const auto& file) { return file.second.substitute == &entry; });
        if (!used && !entry.spec.empty())
            report_.add(Severity::warning, entry.where,
                        "[[substitute]] for '" + entry.spec.substr(0, 80) +
                            "': no fixture of the plot asks for a file of that name");
    }
}

} // namespace ghost::scene
