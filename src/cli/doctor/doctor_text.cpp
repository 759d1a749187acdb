// SPDX-License-Identifier: Apache-2.0
#include "cli/doctor/doctor_text.h"

#include "base/print.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace ghost::app {
namespace {

constexpr std::size_t kColumns = 79; // a terminal of 80 breaks no line
constexpr std::size_t kListedFiles = 12;
constexpr std::size_t kListedFaults = 5;

struct Counts {
    std::size_t lost = 0;
    std::size_t repaired = 0;
    std::size_t notes = 0;
};

Counts counts_of(const Checked& checked) {
    return {checked.count(Severity::error), checked.count(Severity::warning), checked.count(Severity::note)};
}

std::string state_of(const Checked& checked) {
    if (!checked.is_done) return "not checked";
    const Counts counts = counts_of(checked);
    return counts.lost > 0 ? "lost" : counts.repaired > 0 ? "repaired" : "ok";
}

bool is_unreadable(const Checked& checked) {
    return checked.is_done && checked.summary.empty() && checked.count(Severity::error) > 0;
}

std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

// The end counts most in a file's name, the start in a sentence.
std::string cut(const std::string& text, std::size_t width, bool keep_end) {
    if (letters(text) <= width) return text;
    std::size_t skip = letters(text) - width + 3;
    std::string result = keep_end ? "..." : "";
    std::size_t seen = 0;
    for (const char c : text) {
        if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) ++seen;
        if (keep_end ? seen > skip : seen <= width - 3) result += c;
    }
    return keep_end ? result : result + "...";
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, letters(text)), ' ');
}

std::string right(std::size_t number, std::size_t width) {
    const std::string text = std::to_string(number);
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

// What all files have in front of their names says nothing in a list.
std::string common_folder(std::span<const Checked> all) {
    std::string common = all.front().file;
    for (const Checked& checked : all) {
        std::size_t same = 0;
        while (same < common.size() && same < checked.file.size() && common[same] == checked.file[same])
            ++same;
        common.resize(same);
    }
    const std::size_t slash = common.rfind('/');
    return slash == std::string::npos ? "" : common.substr(0, slash + 1);
}

struct Fault {
    Severity severity = Severity::note;
    std::string what;
    std::size_t times = 0;
    std::set<std::size_t> files;
};

std::vector<Fault> most_frequent(std::span<const Checked> all) {
    std::map<std::pair<int, std::string>, Fault> faults;
    for (std::size_t k = 0; k < all.size(); ++k)
        for (const scene::Finding& finding : all[k].findings) {
            if (finding.severity == Severity::note) continue;
            const std::string key = scene::fault_key(finding.what);
            Fault& fault = faults[{finding.severity == Severity::error ? 0 : 1, key}];
            if (fault.what.empty()) fault.what = finding.what;
            // Said of one thing: as it stands; of many: what they share.
            if (fault.what != finding.what) fault.what = key;
            fault.severity = finding.severity;
            fault.times += static_cast<std::size_t>(std::max(1, finding.times));
            fault.files.insert(k);
        }
    std::vector<Fault> sorted;
    for (auto& [key, fault] : faults) sorted.push_back(std::move(fault));
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Fault& a, const Fault& b) { return a.times > b.times; });
    return sorted;
}

std::string totals_line(std::span<const Checked> all) {
    std::size_t ok = 0, repaired = 0, lost = 0, left = 0, unreadable = 0;
    for (const Checked& checked : all) {
        const std::string state = state_of(checked);
        unreadable += is_unreadable(checked);
        ++(state == "ok" ? ok : state == "repaired" ? repaired : state == "lost" ? lost : left);
    }
    return std::to_string(all.size()) + " files: " + std::to_string(ok) + " ok, " + std::to_string(repaired) +
           " repaired, " + std::to_string(lost) + " with losses" +
           (unreadable ? " (" + std::to_string(unreadable) + " cannot be read at all)" : "") +
           (left ? ", " + std::to_string(left) + " not checked (interrupted)" : "");
}

} // namespace

std::string text_of(const Checked& checked, Detail detail) {
    std::string text;
    std::vector<scene::FindingGroup> groups;
    if (detail == Detail::all)
        for (const scene::Finding& finding : checked.findings)
            groups.push_back({finding, finding.times, 1, {}, true});
    else
        groups = scene::grouped(checked.findings);
    for (const scene::FindingGroup& group : groups)
        if (detail != Detail::losses || group.first.severity == Severity::error)
            text += scene::text_of(group) + "\n";
    if (detail == Detail::losses) return text;
    const Counts counts = counts_of(checked);
    text += one_line(checked.file) + ": ";
    if (!checked.is_done)
        text += "not checked (interrupted)";
    else if (counts.lost == 0 && counts.repaired == 0)
        text += "ok";
    else
        text += (counts.lost ? std::to_string(counts.lost) + " lost" : "") +
                (counts.lost && counts.repaired ? ", " : "") +
                (counts.repaired ? std::to_string(counts.repaired) + " repaired or guessed" : "");
    if (!checked.summary.empty()) text += ", " + one_line(checked.summary);
    return text + "\n";
}

std::string summary_of(std::span<const Checked> all, bool is_long) {
    if (all.empty()) return "nothing to check\n";
    std::vector<const Checked*> order;
    for (const Checked& checked : all) order.push_back(&checked);
    // What cannot be read at all has one message, and has lost everything.
    std::stable_sort(order.begin(), order.end(), [](const Checked* a, const Checked* b) {
        const Counts x = counts_of(*a), y = counts_of(*b);
        if (is_unreadable(*a) != is_unreadable(*b)) return is_unreadable(*a);
        return x.lost != y.lost ? x.lost > y.lost : x.repaired > y.repaired;
    });
    const std::string folder = common_folder(all);
    const auto shown_name = [&](const Checked& checked) {
        return one_line(std::string_view(checked.file).substr(folder.size()));
    };
    const std::size_t shown = is_long ? order.size() : std::min(order.size(), kListedFiles);
    constexpr std::size_t kNumber = 9;
    constexpr std::size_t kName = kColumns - 3 * kNumber - 2;
    std::string text = "\n" + padded(cut(folder.empty() ? "file" : one_line(folder), kName, true), kName) +
                       "       lost repaired    notes\n";
    for (std::size_t k = 0; k < shown; ++k) {
        const Checked& checked = *order[k];
        const Counts counts = counts_of(checked);
        const std::string name =
            padded(is_long ? shown_name(checked) : cut(shown_name(checked), kName, true), kName) + "  ";
        if (!checked.is_done)
            text += name + " not checked\n";
        else if (is_unreadable(checked))
            text += name + "  cannot be read at all\n";
        else if (counts.lost + counts.repaired == 0)
            text += name + right(0, kNumber) + std::string(kNumber - 2, ' ') + "ok" +
                    right(counts.notes, kNumber) + "\n";
        else
            text += name + right(counts.lost, kNumber) + right(counts.repaired, kNumber) +
                    right(counts.notes, kNumber) + "\n";
    }
    if (shown < order.size()) text += "... and " + std::to_string(order.size() - shown) + " more (--all)\n";
    text += totals_line(all) + "\n";
    const std::vector<Fault> faults = most_frequent(all);
    if (!faults.empty()) text += "most frequent:\n";
    for (std::size_t k = 0; k < faults.size() && k < (is_long ? 4 * kListedFaults : kListedFaults); ++k) {
        const std::string line = right(faults[k].times, 5) + " x in " + right(faults[k].files.size(), 3) +
                                 (faults[k].severity == Severity::error ? "  lost      " : "  repaired  ") +
                                 one_line(faults[k].what);
        text += (is_long ? line : cut(line, kColumns, false)) + "\n";
    }
    return text;
}

nlohmann::json json_of(const Checked& checked) {
    nlohmann::json messages = nlohmann::json::array();
    for (const scene::Finding& finding : checked.findings) {
        const scene::Place place = scene::split_where(finding.where);
        messages.push_back({{"severity", scene::name_of(finding.severity)},
                            {"kind", finding.kind},
                            {"where", finding.where},
                            {"file", place.file},
                            {"line", place.line},
                            {"element", place.element},
                            {"what", finding.what},
                            {"do", finding.advice},
                            {"times", finding.times}});
    }
    const Counts counts = counts_of(checked);
    return {{"file", checked.file},
            {"state", state_of(checked)},
            {"lost", counts.lost > 0},
            {"readable", !is_unreadable(checked)},
            {"counts", {{"error", counts.lost}, {"warning", counts.repaired}, {"note", counts.notes}}},
            {"facts", checked.facts},
            {"messages", messages}};
}

} // namespace ghost::app
