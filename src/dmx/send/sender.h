#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sender: sends levels as sACN or Art-Net, for `play` and tests. Unicast to one address, else sACN multicast
// and Art-Net broadcast through the chosen interface. The caller paces: send() sends each universe that it
// is given once, with as many slots as it has.
// ArtDmx leaves from its own port where no other program has that, as Art-Net 4 wants.
// What the system refuses (no cable, no route, an interface that is gone) is counted and left out; the
// interface is looked for again once a second, so that sending goes on when the link comes back. One thread.

#include "base/result.h"
#include "dmx/merge/merge.h"
#include "dmx/wire/packet.h"

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace ghost::dmx {

class UdpSocket;

struct SenderOptions {
    Protocol protocol = Protocol::sacn;
    std::string
        destination; // IPv4 or (sACN) IPv6 address; empty: sACN multicast, Art-Net broadcast of the interface
    std::string interface; // name or IPv4 address; empty: the system's choice
    std::uint8_t priority = 100;
    std::string source_name = "Ghostlight";
    int artnet_offset = 1;  // Port-Address = universe - this; -32768 to 63999
    std::uint16_t port = 0; // 0: the protocol's own
};

class Sender {
public:
    static Result<Sender> open(const SenderOptions& options);
    Sender(Sender&&) noexcept;
    ~Sender();

    // Error: a universe that has no Port-Address.
    Result<void> send(const Universes& universes);
    // sACN: three stream-terminated packets per universe that was sent (E1.31 6.2.6); Art-Net: nothing. How
    // many went.
    std::uint64_t terminate();
    std::uint64_t packets() const { return packets_; } // of levels, sent
    std::uint64_t refused() const { return refused_; } // of levels, that could not be sent
    // Why the newest packet could not be sent; nothing where it could.
    const std::optional<Error>& trouble() const { return trouble_; }

private:
    Sender(SenderOptions options, std::unique_ptr<UdpSocket> socket);
    // The chosen interface, as it is now; where Art-Net goes without an address.
    Result<void> choose_interface();
    bool put(Bytes bytes, std::uint16_t universe);
    IpAddress destination(std::uint16_t universe) const;

    SenderOptions options_;
    std::unique_ptr<UdpSocket> socket_;
    std::optional<IpAddress> target_; // none: the multicast group of the universe
    std::array<std::uint8_t, 16> cid_{};
    std::map<std::uint16_t, std::uint8_t> sequence_;
    std::uint64_t packets_ = 0, refused_ = 0;
    std::optional<Error> trouble_;
    std::chrono::steady_clock::time_point look_again_{};
};

} // namespace ghost::dmx
