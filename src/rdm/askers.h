#pragma once
// SPDX-License-Identifier: Apache-2.0
// Askers: which controllers asked for the table of which port, and whom of them it is sent to unasked when it
// changes. Whoever forges a sender could have us tell somebody who never asked: so many controllers and ports
// at most (who was silent for longest gives way), a table of a port to one of them once in kTableRest, and
// who sends no RDM for kAskerStays is forgotten. IPv4 addresses in host byte order; now: of any steady clock.
// No sockets, one thread, no errors.

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>

namespace ghost::rdm {

inline constexpr std::size_t kMaxAskers = 32;
inline constexpr std::size_t kMaxAskedPorts = 1024; // of one controller; others it must ask for again
inline constexpr std::chrono::seconds kTableRest{1};
inline constexpr std::chrono::hours kAskerStays{1};

class Askers {
public:
    // It gets the table of a port of ours now, because it asked.
    void asked(std::uint32_t ipv4, std::uint16_t port_address, std::chrono::nanoseconds now);
    // It sent RDM of any kind: who asked before is still there.
    void heard(std::uint32_t ipv4, std::chrono::nanoseconds now);
    // The table of a port is another one.
    void changed(std::uint16_t port_address);

    struct Due {
        std::uint32_t ipv4 = 0;
        std::uint16_t port_address = 0;
        bool operator==(const Due&) const = default;
    };
    // Who gets which table now, in turn. Call until there is none.
    std::optional<Due> next(std::chrono::nanoseconds now);

private:
    struct Table {
        std::chrono::nanoseconds rests{0}; // until then it is not sent
        bool is_due = false;
    };
    struct Asker {
        std::chrono::nanoseconds heard{0};
        std::map<std::uint16_t, Table> tables; // by port
    };
    void forget(std::uint32_t ipv4);

    std::map<std::uint32_t, Asker> askers_;
    std::deque<Due> due_; // what is_due says, in turn
};

} // namespace ghost::rdm
