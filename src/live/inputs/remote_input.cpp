// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/remote_input.h"

#include "base/log.h"
#include "base/print.h"

#include <charconv>

namespace ghost::app {

namespace {

constexpr int kRemoteBufferBytes = 128 << 10;
constexpr int kMostRemoteBatches = 4; // of 64 packets
constexpr double kQuiet_s = 5;
constexpr std::size_t kMostLettersShown = 80;

} // namespace

Result<PortOption> parse_port(const std::string& text, const std::string& option) {
    PortOption result;
    const std::size_t colon = text.rfind(':');
    const std::string number = colon == std::string::npos ? text : text.substr(colon + 1);
    if (colon != std::string::npos) {
        const auto address = dmx::parse_ipv4(text.substr(0, colon));
        if (!address.ok()) return Error{address.error().what, option};
        result.ipv4 = *address;
    }
    const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), result.port);
    if (failed != std::errc() || end != number.data() + number.size() || result.port == 0)
        return Error{"'" + text +
                         "', expected a port like 9000, or an address of ours and a port like 0.0.0.0:9000",
                     option};
    return result;
}

Result<std::unique_ptr<RemoteInput>> RemoteInput::open(const PortOption& where) {
    TRY(auto socket, dmx::UdpSocket::open(where.ipv4, where.port, kRemoteBufferBytes));
    return std::unique_ptr<RemoteInput>(new RemoteInput(std::move(socket)));
}

void RemoteInput::complain(const std::string& text, double now_s) {
    if (now_s < quiet_until_s_) {
        ++unsaid_;
        return;
    }
    const std::string more =
        unsaid_ > 0 ? " (and " + std::to_string(unsaid_) + " more since the last one)" : "";
    const bool is_long = text.size() > kMostLettersShown;
    log_warning("remote control: " + one_line(is_long ? text.substr(0, kMostLettersShown) + ".." : text) +
                more);
    quiet_until_s_ = now_s + kQuiet_s;
    unsaid_ = 0;
}

void RemoteInput::poll(Remote& remote, double now_s) {
    for (int batch = 0; batch < kMostRemoteBatches; ++batch) {
        const auto datagrams = socket_->receive();
        if (datagrams.empty()) break;
        for (const dmx::Datagram& datagram : datagrams) {
            const dmx::OscPacket packet = dmx::parse_osc(datagram.bytes);
            if (packet.malformed > 0)
                complain("a packet of " + dmx::address_text(datagram.from) + " is no OSC", now_s);
            for (const dmx::OscMessage& message : packet.messages)
                if (const auto done = remote.apply(message); !done.ok()) complain(done.error().text(), now_s);
        }
    }
}

} // namespace ghost::app
