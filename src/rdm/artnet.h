#pragma once
// SPDX-License-Identifier: Apache-2.0
// RDM in Art-Net 4: ArtTodRequest, ArtTodData, ArtTodControl, ArtRdm, as bytes and as values. Pure; whatever
// is no such packet is nothing.

#include "rdm/message.h"

#include <span>

namespace ghost::rdm {

inline constexpr std::size_t kMaxAddresses = 32;      // of an ArtTodRequest
inline constexpr std::size_t kMaxUidsPerPacket = 200; // of an ArtTodData

// "Who is at these ports?"
struct TodRequest {
    std::vector<std::uint16_t> port_addresses;
};
// Discovery of a port: flush asks for a new one.
struct TodControl {
    std::uint16_t port_address = 0;
    bool flush = false;
};
// By which BindIndex an ArtPollReply names a Port-Address, and as which of its ports (1 to 4).
struct Port {
    std::uint8_t bind_index = 1, number = 1;
};
// A table of devices, a packet of it: `total` of them in all.
struct TodData {
    std::uint16_t port_address = 0;
    Port port;
    std::uint16_t total = 0;
    std::uint8_t block = 0;
    std::vector<Uid> uids;
};
// A message on its way to or from a port.
struct ArtRdm {
    std::uint16_t port_address = 0;
    std::variant<Message, Fault> message = Fault::too_short;
};
using ArtPacket = std::variant<std::monostate, TodRequest, TodControl, TodData, ArtRdm>;

// Whether an Art-Net packet is one of these, by its operation code.
bool is_rdm(Bytes packet);
ArtPacket parse_artnet(Bytes packet);
std::vector<std::uint8_t> build_tod_data(const TodData& data);
std::vector<std::uint8_t> build_tod_request(const TodRequest& request);
std::vector<std::uint8_t> build_art_rdm(std::uint16_t port_address, const Message& message);

} // namespace ghost::rdm
