#pragma once
// SPDX-License-Identifier: Apache-2.0
// PollAnswers: who gets which ArtPollReply when. A poll of 14 bytes asks for a reply of 239 bytes per
// universe, so whoever forges its sender could have us flood somebody: an address is answered once in
// kPollerRest, whoever asks meanwhile at its end (of two programs on one machine both get theirs within the 3
// s of Art-Net 4), replies to all together are paced (2000 a second, 0.5 MB), at most kMaxPollers wait, and
// only addresses of local networks are answered. Art-Net 4 has one port per reply, and the bind index, which
// tells the replies of one address apart, ends at 255; where that does not do, neighbours share a reply as
// Art-Net 3 has it, up to four. No clock, no sockets.

#include "dmx/wire/packet.h"
#include "net/socket.h"

#include <chrono>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kMaxPollers = 32;
inline constexpr std::chrono::milliseconds kPollerRest{2000}; // controllers poll every 2.5 to 3 s
inline constexpr std::chrono::milliseconds kReplyEvery{4};
inline constexpr std::size_t kRepliesAtOnce = 8;

// On a network of ours, or an address that the internet does not route (RFC 1918, 3927, loopback), or one of
// 2.0.0.0/8, which Art-Net uses as if it were.
bool is_local(std::uint32_t ipv4, std::span<const NetInterface> interfaces);

class PollAnswers {
public:
    // What is announced, in this order.
    explicit PollAnswers(const std::vector<std::uint16_t>& port_addresses) { announce(port_addresses); }
    // Instead of those; who is just being told hears of these from the beginning. Sorted.
    void announce(const std::vector<std::uint16_t>& port_addresses);

    struct Reply {
        std::uint32_t to_ipv4 = 0;
        std::uint32_t our_ipv4 = 0;
        std::vector<std::uint16_t> ports; // 1 to 4, of one net and sub-net
        std::uint8_t bind_index = 1;      // past 255 replies (as many as 1020 ports may need) it stays 255
        bool asked = false;               // else the hello at start
    };

    // Where the replies name a Port-Address: by which bind index, as which of its ports (1 to 4); nothing of
    // one that they do not name.
    struct Place {
        std::uint8_t bind_index = 1, port = 1;
    };
    std::optional<Place> place_of(std::uint16_t port_address) const;

    // A node says hello when it comes up, so that controllers need not wait for their next poll.
    void hello(std::uint32_t broadcast, std::uint32_t our_ipv4, std::chrono::nanoseconds now);
    // False: not answered, because too many ask, or it did so meanwhile already.
    bool asked(const PollPacket& poll, std::uint32_t from_ipv4, std::uint32_t our_ipv4,
               std::chrono::nanoseconds now);
    // The next reply to send at this time. Call until there is none.
    std::optional<Reply> next(std::chrono::nanoseconds now);
    // Until next() may have one; none: nobody waits.
    std::optional<std::chrono::nanoseconds> wait(std::chrono::nanoseconds now) const;

private:
    // Replies to one address.
    struct Run {
        std::uint32_t to_ipv4 = 0;
        std::uint32_t our_ipv4 = 0;
        PollPacket range;
        std::size_t next = 0;              // index in replies_
        std::chrono::nanoseconds start{0}; // of the first
        std::chrono::nanoseconds rests{0}; // until it may ask again
        bool asked = false;
        bool once_more = false; // at the end of its rest
    };
    void wake(std::chrono::nanoseconds now);
    bool waits(const Run& run) const { return run.next < replies_.size(); }

    std::vector<std::vector<std::uint16_t>> replies_; // the ports of each
    std::deque<Run> runs_;
    std::chrono::nanoseconds slice_{0}; // start of the current kReplyEvery
    std::size_t sent_in_slice_ = 0;
};

} // namespace ghost::dmx
