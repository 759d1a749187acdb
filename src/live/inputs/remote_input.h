#pragma once
// SPDX-License-Identifier: Apache-2.0
// RemoteInput: OSC from a UDP port of ours, read by the thread that draws, between two frames. Never answers.
// At most kMostPacketsPerPoll packets are read at once, what comes faster is dropped by the kernel; what is
// not understood is said once in five seconds at most.

#include "live/inputs/remote.h"
#include "net/socket.h"

#include <cstdint>
#include <memory>
#include <string>

namespace ghost::app {

struct PortOption {
    std::uint32_t ipv4 = 0x7F000001; // this machine alone
    std::uint16_t port = 0;
};

// "9000" (127.0.0.1), "192.168.1.20:9000" or "0.0.0.0:9000" (whoever can reach us). option: for messages.
Result<PortOption> parse_port(const std::string& text, const std::string& option);

class RemoteInput {
public:
    static Result<std::unique_ptr<RemoteInput>> open(const PortOption& where);

    // What has arrived goes to the remote. now_s: any steady seconds.
    void poll(Remote& remote, double now_s);

private:
    explicit RemoteInput(std::unique_ptr<dmx::UdpSocket> socket) : socket_(std::move(socket)) {}
    void complain(const std::string& text, double now_s);

    std::unique_ptr<dmx::UdpSocket> socket_;
    double quiet_until_s_ = 0;
    long unsaid_ = 0; // complaints that were not printed
};

} // namespace ghost::app
