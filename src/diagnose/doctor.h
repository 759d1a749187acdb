#pragma once
// SPDX-License-Identifier: Apache-2.0
// Doctor: what the import doctor says of a file: the messages of the loaders and its own, each with a stable
// word for its kind, its place taken apart, and what to do about it. Pure; any thread. No errors: a sentence
// that is not known keeps the kind "reading".

#include "base/report.h"

#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

// note: odd, nothing is lost; warning: repaired or guessed; error: lost.
struct Finding {
    Severity severity = Severity::warning;
    std::string kind;  // "overlap", "unpatched", "missing_media", ...; docs/guide/import-doctor.md lists all
    std::string where; // as Message::where
    std::string what;
    std::string advice;  // what to do; empty: nothing that we know
    int times = 1;       // how often it was met; the place is that of the first
    bool is_sum = false; // what says itself how many it concerns; it is never put together with others
};

const char* name_of(Severity severity); // "note", "warning", "error"

// "show.mvr: GeneralSceneDescription.xml:120: Scene/Layers/Fixture 'Spot 3'" taken apart.
struct Place {
    std::string file; // "show.mvr: GeneralSceneDescription.xml"
    int line = 0;     // 0: not known
    std::string element;
};
Place split_where(const std::string& where);

// A loader's message with the kind, the count and the advice that its sentence gives.
Finding finding_of(const Message& message);

// What two sentences of one fault share: names in quotes, numbers and file names are left out.
std::string fault_key(const std::string& what);

// The same fault in one checked file: one line for all of them.
struct FindingGroup {
    Finding first;
    int times = 0; // of all together
    int findings = 0;
    std::vector<int> lines; // of the others in the same member of the archive, in order, at most kListedLines
    bool is_one_sentence = true;
};
inline constexpr std::size_t kListedLines = 6;

// Errors first, then warnings, then notes; each in reading order.
std::vector<FindingGroup> grouped(std::span<const Finding> findings);

// "error: where: what (4 times: lines 66, 76, 88, 105)", and the advice in a line of its own.
std::string text_of(const FindingGroup& group);

} // namespace ghost::scene
