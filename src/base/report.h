#pragma once
// SPDX-License-Identifier: Apache-2.0
// Report: what was noticed while something was read: what was lost, repaired or guessed. Loading goes on; the
// caller shows the report. Values only.

#include <string>
#include <vector>

namespace ghost {

enum class Severity {
    note,    // odd, but nothing is lost
    warning, // something was repaired, replaced or guessed
    error,   // something that was asked for is missing
};

struct Message {
    Severity severity = Severity::warning;
    std::string where; // file:line, or a place in a file: "VL.gdtf: wheels/leaves.png"
    std::string what;  // one sentence with the expectation
};

struct Report {
    std::vector<Message> messages;

    void add(Severity severity, std::string where, std::string what) {
        messages.push_back({severity, std::move(where), std::move(what)});
    }
    bool lost_anything() const {
        for (const Message& message : messages)
            if (message.severity == Severity::error) return true;
        return false;
    }
};

} // namespace ghost
