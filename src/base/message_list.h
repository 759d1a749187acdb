#pragma once
// SPDX-License-Identifier: Apache-2.0
// MessageList: what a converter (QXF, Open Fixture Library) could not keep, as Messages. A sentence that fits
// many places is listed once, at the first place, with how many more there are. Bounded. One thread.

#include "base/message_cap.h"
#include "base/report.h"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ghost {

// What was not taken is said: by the first of each kind, and as a sum at the end.
inline void finish_messages(const MessageCap& cap, const std::string& name, std::vector<Message>& messages) {
    for (std::size_t i = 0; i < messages.size(); ++i)
        if (const std::size_t more = cap.more_like(i); more > 0)
            messages[i].what += " (and " + std::to_string(more) + " more of this kind)";
    if (cap.is_over()) messages.push_back({static_cast<Severity>(cap.worst()), name, cap.text()});
}

class MessageList {
public:
    // where: the place as a user finds it: "VL.qxf:120", "par.json: /modes/0/channels/3".
    void say(Severity severity, const std::string& where, const std::string& what) {
        const auto [entry, is_new] = known_.try_emplace({severity, what}, messages_.size());
        if (!is_new) {
            if (entry->second < counts_.size()) ++counts_[entry->second];
            return;
        }
        if (!cap_.takes(static_cast<int>(severity), what, messages_.size())) {
            known_.erase(entry);
            return;
        }
        messages_.push_back({severity, where, what});
        counts_.push_back(0);
    }

    std::vector<Message> take() && {
        for (std::size_t i = 0; i < messages_.size(); ++i)
            if (counts_[i] > 0)
                messages_[i].what += " (and " + std::to_string(counts_[i]) + " more of this kind)";
        if (!messages_.empty()) finish_messages(cap_, messages_.front().where, messages_);
        return std::move(messages_);
    }

private:
    std::vector<Message> messages_;
    std::vector<std::size_t> counts_; // of the same sentence again
    std::map<std::pair<Severity, std::string>, std::size_t> known_;
    MessageCap cap_;
};

} // namespace ghost
