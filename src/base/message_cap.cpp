// SPDX-License-Identifier: Apache-2.0
#include "base/message_cap.h"

namespace ghost {
namespace {

constexpr std::size_t kMaxKind = 200; // bytes

// Without what stands in quotes, and digits as one.
std::string kind_of(int severity, const std::string& what) {
    std::string kind(1, static_cast<char>('0' + severity));
    bool quoted = false;
    for (std::size_t i = 0; i < what.size() && kind.size() < kMaxKind; ++i) {
        const char c = what[i];
        if (c == '\'') {
            quoted = !quoted;
            if (quoted) kind += '\'';
        } else if (quoted) {
            continue;
        } else if (c >= '0' && c <= '9') {
            if (kind.back() != '#') kind += '#';
        } else {
            kind += c;
        }
    }
    return kind;
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

} // namespace

bool MessageCap::takes(int severity, const std::string& what, std::size_t place) {
    const std::string kind = kind_of(severity, what);
    const auto known = kinds_.find(kind);
    const bool is_room = taken_ < most_;
    if (is_room || (known == kinds_.end() && taken_ < most_ + kMaxMessageKinds)) {
        ++taken_;
        if (known == kinds_.end()) kinds_.emplace(kind, place);
        return true;
    }
    ++left_out_[static_cast<std::size_t>(severity)];
    if (known != kinds_.end()) ++more_[known->second];
    return false;
}

std::size_t MessageCap::more_like(std::size_t place) const {
    const auto found = more_.find(place);
    return found == more_.end() ? 0 : found->second;
}

std::string MessageCap::text() const {
    const std::size_t all = left_out_[0] + left_out_[1] + left_out_[2];
    std::string parts;
    const auto add = [&](std::size_t count, const char* one, const char* many) {
        if (count > 0) parts += (parts.empty() ? "" : ", ") + counted(count, one, many);
    };
    add(left_out_[2], "loss", "losses");
    add(left_out_[1], "repair", "repairs");
    add(left_out_[0], "note", "notes");
    return counted(all, "more message is", "more messages are") +
           " not listed, but the first of each kind: " + parts;
}

} // namespace ghost
