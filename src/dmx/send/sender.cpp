// SPDX-License-Identifier: Apache-2.0
#include "dmx/send/sender.h"

#include "dmx/wire/build.h"
#include "net/socket.h"

#include <random>

namespace ghost::dmx {

namespace {

constexpr std::chrono::seconds kLookAgain{1};
constexpr int kBufferBytes = 64 << 10;

} // namespace

Sender::Sender(SenderOptions options, std::unique_ptr<UdpSocket> socket)
    : options_(std::move(options)), socket_(std::move(socket)) {
    if (options_.port == 0) options_.port = options_.protocol == Protocol::sacn ? kSacnPort : kArtnetPort;
    // A new source each time: the receivers' sequence rules start afresh.
    std::random_device random;
    for (auto& byte : cid_) byte = static_cast<std::uint8_t>(random());
    cid_[6] = static_cast<std::uint8_t>((cid_[6] & 0x0F) | 0x40); // a version 4 UUID
    cid_[8] = static_cast<std::uint8_t>((cid_[8] & 0x3F) | 0x80);
}

Sender::Sender(Sender&&) noexcept = default;
Sender::~Sender() = default;

Result<Sender> Sender::open(const SenderOptions& options) {
    std::optional<IpAddress> target;
    if (!options.destination.empty()) {
        TRY(target, parse_address(options.destination));
    }
    const bool ipv6 = target && !target->is_ipv4();
    if (ipv6 && options.protocol == Protocol::artnet)
        return Error{"Art-Net knows no IPv6, expected an IPv4 address", options.destination};
    std::unique_ptr<UdpSocket> socket;
    if (options.protocol == Protocol::artnet) {
        auto own = UdpSocket::open_if_free(options.port == 0 ? kArtnetPort : options.port, kBufferBytes);
        if (own.ok()) socket = std::move(*own);
    }
    if (!socket) {
        TRY(socket, ipv6 ? UdpSocket::open_ipv6(0, kBufferBytes) : UdpSocket::open(0, 0, kBufferBytes));
    }
    Sender sender(options, std::move(socket));
    sender.target_ = target;
    TRY_VOID(sender.choose_interface());
    return sender;
}

Result<void> Sender::choose_interface() {
    const bool broadcasts = options_.destination.empty() && options_.protocol == Protocol::artnet;
    if (broadcasts) target_ = IpAddress(0xFFFFFFFFu);
    if (options_.interface.empty()) return {};
    TRY(const NetInterface interface, find_interface(options_.interface));
    TRY_VOID(socket_->send_multicast_through(interface));
    if (broadcasts) target_ = IpAddress(interface.broadcast);
    return {};
}

IpAddress Sender::destination(std::uint16_t universe) const {
    return target_ ? *target_ : IpAddress(sacn_group(universe));
}

bool Sender::put(Bytes bytes, std::uint16_t universe) {
    const auto now = std::chrono::steady_clock::now();
    if (trouble_ && now >= look_again_) {
        look_again_ = now + kLookAgain;
        (void)choose_interface(); // one that is gone shows when it is sent through
    }
    const Result<void> sent = socket_->send(bytes, destination(universe), options_.port);
    if (sent.ok())
        trouble_.reset();
    else
        trouble_ = sent.error();
    return sent.ok();
}

Result<void> Sender::send(const Universes& universes) {
    for (const Universe& universe : universes.list) {
        std::uint8_t& sequence = sequence_[universe.number];
        ++sequence;
        const Bytes levels = Bytes(*universe.levels).first(universe.slot_count);
        std::vector<std::uint8_t> bytes;
        if (options_.protocol == Protocol::sacn) {
            bytes = build_sacn(universe.number, levels, sequence,
                               {options_.priority, cid_, options_.source_name});
        } else {
            const int port_address = universe.number - options_.artnet_offset;
            if (port_address < 0 || port_address > 0x7FFF)
                return Error{"universe " + std::to_string(universe.number) + " minus the Art-Net offset " +
                                 std::to_string(options_.artnet_offset) + " is " +
                                 std::to_string(port_address) + ", no Port-Address, expected 0 to 32767",
                             ""};
            if (sequence == 0) sequence = 1; // 0 would mean "not numbered"
            bytes = build_artdmx(static_cast<std::uint16_t>(port_address), levels, sequence);
        }
        ++(put(bytes, universe.number) ? packets_ : refused_);
    }
    return {};
}

std::uint64_t Sender::terminate() {
    std::uint64_t went = 0;
    if (options_.protocol != Protocol::sacn) return went;
    for (int round = 0; round < 3; ++round)
        for (auto& [number, sequence] : sequence_)
            went += put(build_sacn(number, {}, ++sequence, {options_.priority, cid_, options_.source_name},
                                   {0x40}),
                        number)
                        ? 1
                        : 0;
    return went;
}

} // namespace ghost::dmx
