#pragma once
// SPDX-License-Identifier: Apache-2.0
// What passes between the window and the engine of RDM: whether desks find the fixtures, what desks know of
// each, and what they want of the show. Plain values. Any thread.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ghost::ui {

inline constexpr std::size_t kMostRdmEdits = 4096; // on their way

enum class RdmAccess {
    off,  // no desk finds a fixture
    read, // desks find, read and identify them
    edit, // and set address, mode and name
};
inline constexpr const char* kRdmAccess[] = {"off", "read", "edit"};

// What a desk wants of a fixture: one of the three.
struct RdmEdit {
    std::uint64_t number = 0;   // grows; ViewRequest::rdm_answered says up to which they are done or refused
    std::size_t fixture = 0;    // of the show that the engine has
    std::string name;           // of it, with what was asked for before
    std::optional<int> address; // in its universe, 1-based
    std::optional<std::size_t> mode;
    std::optional<std::string> label; // its name from now on
};

// A fixture as desks know it.
struct RdmHead {
    std::size_t fixture = 0; // of the show
    std::string uid;
    bool is_found = false;      // a desk has asked who is there, and was told
    std::uint64_t messages = 0; // to it
    bool identifies = false;
    bool operator==(const RdmHead&) const = default;
};

struct RdmNow {
    RdmAccess access = RdmAccess::off;
    std::vector<RdmHead> heads; // in the order of the show
    std::uint64_t messages = 0;
    std::uint64_t faults = 0;  // messages that are none
    std::uint64_t refused = 0; // edits, for want of leave, or because the show cannot have that
    bool operator==(const RdmNow&) const = default;
};

} // namespace ghost::ui
