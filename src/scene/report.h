#pragma once
// SPDX-License-Identifier: Apache-2.0
// Report: what was noticed while something was read: what was lost, repaired or guessed. Loading goes on; the
// caller shows the report. Values only.

#include <string>
#include <vector>

namespace ghost::scene {

enum class Severity {
    note,
    warning,
    error
}; // error: something the user asked for is missing from the picture

struct Message {
    Severity severity = Severity::warning;
    std::string where; // file:line or file:element
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

} // namespace ghost::scene
