// SPDX-License-Identifier: Apache-2.0
#include "diagnose/doctor.h"

#include "base/print.h"
#include "base/text.h"
#include "fixture/values.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

namespace ghost::scene {
namespace {

constexpr std::string_view kTwoNames = "'..', '..'"; // as fault_key writes them

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// The words by which the loaders' sentences are known. The first that fits counts.
struct KnownSentence {
    std::string_view words;
    const char* kind;
    const char* advice;
};
constexpr KnownSentence kSentences[] = {
    {"entries that lead out", "unsafe_name", "export the file again"},
    {"names that lead out", "unsafe_name", "export the file again"},
    {"two files of one name", "duplicate_name", "keep one of them, or give them names of their own"},
    {"no such file", "missing_file", "put the file there, or correct its name"},
    {"GDTFSpec '", "guessed_fixture_file", "see that this is the fixture that was meant"},
    {"fixture file '", "missing_fixture_file",
     "put the file into the archive or beside the plot, or name another one in [[substitute]] of the show "
     "file"},
    {"without a GDTFSpec", "missing_fixture_file",
     "give the fixture a type in the program that drew the plot"},
    {"its fixtures stay dark", "unreadable_fixture_file", "get the file again from its maker"},
    {"its fixture stays dark", "unreadable_fixture_file", "get the file again from its maker"},
    {"no Beam or Laser geometry", "no_beam", "fine for machines; for a lamp get a newer file from its maker"},
    {"has no DMX mode", "no_mode", "get a newer file from its maker"},
    {"has no mode '", "unknown_mode", "choose a mode that the file has, in the plot or in the show file"},
    {"a striped card is shown until it can be read", "unreadable_media",
     "get the file again, or make one of it that FFmpeg plays"},
    {"no mesh '", "missing_media", "get the file again, with its models; a plain shape stands in"},
    {"texture '", "missing_media", "export the model again, with its textures"},
    {"the picture ", "missing_media", "get the file again, with its pictures; the gobo is open until then"},
    {"expected a PNG", "missing_media", "get the file again, with its pictures; the gobo is open until then"},
    {"gobo '", "missing_media", "export the plot again, with its gobo pictures"},
    {"the mesh is left out", "missing_media", "get the file again; a plain shape stands in"},
    {"a plain shape stands in", "missing_media", "get the file again"},
    {"mesh '", "missing_media", "export the plot again, with its models"},
    {"media '", "missing_media", "export the plot again, with its media"},
    {"source '", "missing_media", "export the plot again, with its media"},
    {"names does not exist", "missing_link",
     "nothing is drawn by it; export again if grouping by it matters"},
    {"there is no Symdef", "missing_link", "export the plot again, with its symbols"},
    {"means nothing to", "unknown_element", ""},
    {"not used, as neither", "not_used", ""},
    {"no physical range", "guessed_value", "get a newer file from its maker, or see that the range is right"},
    {"taking ", "guessed_value", ""},
    {"taken as ", "guessed_value", ""},
    {"taken is ", "guessed_value", ""},
    {"it gets '", "guessed_value", ""},
};

// "... (87 times, first here)": the count, which leaves the sentence.
int take_times(std::string& what) {
    const std::string_view end = " times, first here)";
    if (!what.ends_with(end)) return 1;
    const std::size_t open = what.rfind(" (");
    if (open == std::string::npos) return 1;
    const auto count =
        fixture::parse_int(std::string_view(what).substr(open + 2, what.size() - end.size() - open - 2));
    if (!count || *count < 1) return 1;
    what.resize(open);
    return *count;
}

bool is_file_name(std::string_view word) {
    const std::size_t dot = word.rfind('.');
    if (dot == word.npos || dot == 0) return false;
    const std::string end = lower(word.substr(dot + 1));
    for (const char* known :
         {"png", "jpg", "jpeg", "svg", "3ds", "glb", "gltf", "gdtf", "qxf", "json", "bmp", "mov"})
        if (end == known) return true;
    return false;
}

} // namespace

const char* name_of(Severity severity) {
    switch (severity) {
    case Severity::note:
        return "note";
    case Severity::warning:
        return "warning";
    case Severity::error:
        return "error";
    }
    return "error";
}

Place split_where(const std::string& where) {
    // The first ":<digits>" that ends a part is the line: names of elements come after it.
    Place place;
    for (std::size_t colon = where.find(':'); colon != std::string::npos;
         colon = where.find(':', colon + 1)) {
        std::size_t end = colon + 1;
        while (end < where.size() && end - colon <= 9 && is_digit(where[end])) ++end;
        if (end == colon + 1) continue;
        if (end < where.size() && where.compare(end, 2, ": ") != 0) continue;
        place.file = where.substr(0, colon);
        place.line =
            fixture::parse_int(std::string_view(where).substr(colon + 1, end - colon - 1)).value_or(0);
        if (end < where.size()) place.element = where.substr(end + 2);
        return place;
    }
    // Without a line the description's name ends the file.
    if (const std::size_t xml = where.find(".xml: "); xml != std::string::npos) {
        place.file = where.substr(0, xml + 4);
        place.element = where.substr(xml + 6);
        return place;
    }
    place.file = where;
    return place;
}

Finding finding_of(const Message& message) {
    Finding finding{message.severity, "reading", message.where, message.what, "", 1};
    finding.times = take_times(finding.what);
    for (const KnownSentence& known : kSentences)
        if (finding.what.find(known.words) != std::string::npos) {
            finding.kind = known.kind;
            finding.advice = known.advice;
            break;
        }
    return finding;
}

std::string fault_key(const std::string& what) {
    // What stands in brackets at the end counts, or lists names.
    std::string_view sentence = what;
    if (const std::size_t open = what.rfind(" ("); what.ends_with(')') && open != std::string::npos)
        sentence = sentence.substr(0, open);
    std::string key;
    std::string word;
    const auto take_word = [&] {
        if (is_file_name(word)) word = "FILE";
        key += word;
        word.clear();
    };
    bool quoted = false;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        const char c = sentence[i];
        // An apostrophe inside of a word ("maker's") opens nothing; inside of quotes it closes only at an
        // end.
        const bool after_letter = i > 0 && std::isalnum(static_cast<unsigned char>(sentence[i - 1]));
        const bool before_letter =
            i + 1 < sentence.size() && std::isalnum(static_cast<unsigned char>(sentence[i + 1]));
        if (c == '\'' && !(after_letter && before_letter)) {
            quoted = !quoted;
            if (quoted) {
                take_word();
                key += "'..'";
            }
            continue;
        }
        if (quoted) continue;
        if (c == ' ' || c == ',' || c == ';' || c == ':') {
            take_word();
            key += c;
        } else if (is_digit(c)) {
            if (word.empty() || word.back() != '#') word += '#';
        } else {
            word += c;
        }
    }
    take_word();
    // A list of names is one name.
    for (std::size_t list = key.find(kTwoNames); list != std::string::npos; list = key.find(kTwoNames, list))
        key.erase(list, kTwoNames.size() / 2 + 1);
    return key;
}

std::vector<FindingGroup> grouped(std::span<const Finding> findings) {
    std::vector<FindingGroup> groups;
    std::map<std::string, std::size_t> index;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note})
        for (const Finding& finding : findings) {
            if (finding.severity != severity) continue;
            const Place place = split_where(finding.where);
            std::string key = std::string(name_of(severity)) + "\n" + finding.kind + "\n" +
                              fault_key(finding.what) + "\n" + finding.advice;
            if (finding.is_sum) key += "\n" + std::to_string(groups.size());
            const auto [entry, is_new] = index.emplace(key, groups.size());
            if (is_new) groups.push_back({.first = finding, .lines = {}});
            FindingGroup& group = groups[entry->second];
            group.times += finding.times;
            ++group.findings;
            if (is_new) continue;
            group.is_one_sentence = group.is_one_sentence && finding.what == group.first.what;
            if (place.line > 0 && group.lines.size() < kListedLines &&
                place.file == split_where(group.first.where).file)
                group.lines.push_back(place.line);
        }
    return groups;
}

std::string text_of(const FindingGroup& group) {
    std::string text = std::string(name_of(group.first.severity)) + ": ";
    if (!group.first.where.empty()) text += group.first.where + ": ";
    text += group.first.what;
    if (group.times > 1 && !group.first.is_sum) {
        text += group.is_one_sentence ? " (" + std::to_string(group.times) + " times, first here"
                                      : " (and " + std::to_string(group.findings - 1) + " more like it";
        for (std::size_t k = 0; k < group.lines.size(); ++k)
            text += (k                                                ? ", "
                     : group.lines.size() == 1 && group.findings == 2 ? "; line "
                                                                      : "; lines ") +
                    std::to_string(group.lines[k]);
        if (!group.lines.empty() && static_cast<std::size_t>(group.findings) > group.lines.size() + 1)
            text += ", ...";
        text += ")";
    }
    text = one_line(text);
    if (!group.first.advice.empty()) text += "\n    do: " + one_line(group.first.advice);
    return text;
}

} // namespace ghost::scene
