#pragma once
// SPDX-License-Identifier: Apache-2.0
// Receiver: a thread that listens for sACN (UDP 5568: unicast, multicast, broadcast) and Art-Net (UDP 6454:
// unicast, broadcast), merges, and publishes the newest levels; nothing is queued, so a reader that slept
// sees the present at once. Answers ArtPoll with one paced ArtPollReply per universe (Art-Net 4: one port per
// reply, bind index), else many desks send nothing. Times are std::chrono::steady_clock since its epoch.

#include "base/mailbox.h"
#include "base/result.h"
#include "dmx/merge.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::dmx {

inline constexpr std::uint16_t kSacnPort = 5568;
inline constexpr std::uint16_t kArtnetPort = 6454;

struct ReceiverOptions {
    std::string interface; // name ("eth0") or IPv4 address of ours; empty: every interface
    bool sacn = true;
    bool artnet = true;
    // Universes to join, to announce and to accept. Empty: 1 to 64 are joined and announced, whatever arrives
    // is accepted.
    std::vector<std::uint16_t> universes;
    int artnet_offset = 1; // Ghostlight universe = Port-Address + this; -32768 to 63999
    bool show_preview = false;
    bool answer_polls = true;
    bool slot_status = false;              // statistics say what each source sends, slot by slot
    std::uint16_t sacn_port = kSacnPort; // other values for tests
    std::uint16_t artnet_port = kArtnetPort;
};

struct Statistics {
    std::chrono::nanoseconds time{0}; // when it was taken
    std::uint64_t packets_sacn = 0;   // everything that arrived on the port, but our own replies
    std::uint64_t packets_artnet = 0;
    std::uint64_t unlisted = 0; // for universes that were not asked for
    std::uint64_t overflow = 0; // dropped by the kernel: socket buffer full
    std::array<std::uint64_t, static_cast<std::size_t>(Notice::kCount)> notices{};
    std::array<std::uint64_t, static_cast<std::size_t>(Drop::kCount)> drops{};
    std::uint64_t poll_replies_sent = 0;  // to those who asked
    std::uint64_t announcements_sent = 0; // the same replies, unasked, at start
    MergeCounters merge;
    std::vector<SourceStatus> sources; // by universe
};

class Receiver {
public:
    // Opens the sockets and starts the thread. Error: unknown interface, or a port that is taken (named).
    static Result<std::unique_ptr<Receiver>> start(const ReceiverOptions& options);
    ~Receiver(); // stops the thread (within 0.1 s)
    Receiver(const Receiver&) = delete;
    Receiver& operator=(const Receiver&) = delete;

    // The newest levels since the last take, if anything arrived or was lost since.
    std::optional<Universes> take() { return levels_.take(); }
    // The newest statistics since the last take; made four times a second.
    std::optional<Statistics> take_statistics() { return statistics_.take(); }
    // Things a person should know about the set-up (a smaller socket buffer than asked for, a join that
    // failed).
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    struct Loop; // sockets and thread, receiver.cpp

    Receiver();

    Mailbox<Universes> levels_;
    Mailbox<Statistics> statistics_;
    std::vector<std::string> warnings_;
    std::unique_ptr<Loop> loop_;
};

} // namespace ghost::dmx
