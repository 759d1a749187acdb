#pragma once
// SPDX-License-Identifier: Apache-2.0
// Receiver: a thread that listens for sACN (UDP 5568 over IPv4 and IPv6: unicast, multicast, broadcast) and
// Art-Net (UDP 6454: unicast, broadcast), merges, and publishes the newest levels; nothing is queued, so a
// reader that slept sees the present at once, and so does one after the whole program was stopped. Answers
// ArtPoll with one paced ArtPollReply per universe (Art-Net 4: one port per reply, bind index), else many
// desks send nothing. Times are std::chrono::steady_clock since its epoch.

#include "base/mailbox.h"
#include "base/result.h"
#include "dmx/receive/receiver_options.h"
#include "dmx/receive/statistics.h"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::dmx {

class Receiver {
public:
    // Opens the sockets and starts the thread. Error: unknown interface, or a port that is taken (named).
    static Result<std::unique_ptr<Receiver>> start(const ReceiverOptions& options);
    ~Receiver(); // stops the thread (within 0.1 s)
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

    // Joins, announces and accepts these universes from now on (ReceiverOptions::universes); those that stay
    // lose nothing, what was known of others goes. Any thread.
    void listen_to(std::vector<std::uint16_t> universes);

    // The newest levels since the last take, if anything arrived or was lost since.
    std::optional<Universes> take() { return levels_.take(); }
    // The newest statistics since the last take; made four times a second.
    std::optional<Statistics> take_statistics() { return statistics_.take(); }
    // Who sends is still being found out, nothing is shown yet (ReceiverOptions::sampling).
    bool sampling() const { return sampling_.load(std::memory_order_relaxed); }
    // Things a person should know about the set-up (a smaller socket buffer than asked for, a join that
    // failed).
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    struct Loop; // sockets and thread, receiver.cpp

    Receiver();

    Mailbox<Universes> levels_;
    Mailbox<Statistics> statistics_;
    Mailbox<std::vector<std::uint16_t>> wanted_; // for listen_to
    std::atomic<bool> sampling_{false};
    std::vector<std::string> warnings_;
    std::unique_ptr<Loop> loop_;
};

} // namespace ghost::dmx
