#pragma once
// SPDX-License-Identifier: Apache-2.0
// MessageCap: which messages are kept of a file that gives rise to more than anybody reads. The first ones,
// and of what comes after them the first of every kind, so that a limit or an error is never drowned by a
// thousand notes. Kinds are sentences that differ in names and numbers only. Readers' sentences are a few
// hundred, so the list stays bounded whatever a file says. One thread.

#include <array>
#include <cstddef>
#include <map>
#include <string>

namespace ghost {

inline constexpr std::size_t kMaxMessages = 500;
inline constexpr std::size_t kMaxMessageKinds = 500; // beyond those

class MessageCap {
public:
    explicit MessageCap(std::size_t most = kMaxMessages) : most_(most) {}

    // severity: 0 note, 1 repair, 2 loss. place: where the message will stand in the caller's list.
    bool takes(int severity, const std::string& what, std::size_t place);
    // How many of the kind of the message at this place were not taken.
    std::size_t more_like(std::size_t place) const;
    bool is_over() const { return left_out_[0] + left_out_[1] + left_out_[2] > 0; }
    int worst() const {
        return left_out_[2] > 0 ? 2 : left_out_[1] > 0 ? 1 : 0;
    } // severity of what was not taken
    // "1208 more messages are not listed, but the first of each kind: 3 losses, 5 repairs, 1200 notes".
    std::string text() const;

private:
    std::map<std::string, std::size_t> kinds_; // place of the first of each
    std::map<std::size_t, std::size_t> more_;  // by place
    std::array<std::size_t, 3> left_out_{};
    std::size_t most_;
    std::size_t taken_ = 0;
};

} // namespace ghost
