#pragma once
// SPDX-License-Identifier: Apache-2.0
// Report: what was noticed while something was read: what was lost, repaired or guessed. Loading goes on; the
// caller shows the report. A file may give rise to millions of messages: beyond kMostReported only the first
// of each kind is kept, and one that says how many are not. Values only.

#include "base/message_cap.h"
#include "base/suggest.h"

#include <cstddef>
#include <string>
#include <utility>
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

inline constexpr std::size_t kMostReported = 10'000;

struct Report {
    std::vector<Message> messages;
    Suggestions suggestions; // for names in all that is read with it

    void add(Severity severity, std::string where, std::string what) {
        if (cap_.takes(static_cast<int>(severity), what, messages.size()))
            messages.push_back({severity, std::move(where), std::move(what)});
        else
            say_left_out(where);
    }
    bool lost_anything() const {
        for (const Message& message : messages)
            if (message.severity == Severity::error) return true;
        return false;
    }

private:
    void say_left_out(const std::string& where) {
        if (said_.empty() || sum_ >= messages.size() || messages[sum_].what != said_) {
            sum_ = messages.size();
            messages.push_back({Severity::note, where, ""});
        }
        messages[sum_].severity = static_cast<Severity>(cap_.worst());
        messages[sum_].what = said_ = cap_.text();
    }

    MessageCap cap_{kMostReported};
    std::size_t sum_ = 0; // which of the messages is on those that are not kept
    std::string said_;    // what it says; empty: there is none
};

} // namespace ghost
