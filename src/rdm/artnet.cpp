// SPDX-License-Identifier: Apache-2.0
#include "rdm/artnet.h"

#include "base/check.h"

#include <algorithm>

namespace ghost::rdm {

namespace {

constexpr std::uint8_t kIdentifier[8] = {'A', 'r', 't', '-', 'N', 'e', 't', 0};
constexpr std::uint16_t kTodRequest = 0x8000, kTodData = 0x8100, kTodControl = 0x8200, kRdm = 0x8300;
constexpr std::size_t kArtnetHeaderBytes = 12;
constexpr std::uint8_t kRdmVersion = 1; // of E1.20
constexpr std::uint8_t kFull = 0x00, kFlush = 0x01;

// 0 where it is no Art-Net of our version.
std::uint16_t operation_of(Bytes packet) {
    ByteReader reader(packet);
    const Bytes identifier = reader.take(sizeof kIdentifier);
    const std::uint16_t operation = reader.u16_le();
    const std::uint16_t version = reader.u16_be();
    const bool good = reader.ok() && version >= 14 &&
                      std::equal(identifier.begin(), identifier.end(), std::begin(kIdentifier));
    return good ? operation : std::uint16_t{0};
}

std::uint16_t address_of(std::uint8_t net, std::uint8_t sub_uni) {
    return static_cast<std::uint16_t>((net & 0x7F) << 8 | sub_uni);
}

ArtPacket parse_request(ByteReader reader) {
    reader.skip(2 + 7);
    const std::uint8_t net = reader.u8(), command = reader.u8();
    const std::size_t count = reader.u8();
    if (!reader.ok() || command != kFull || count > kMaxAddresses) return {};
    TodRequest request;
    for (const std::uint8_t address : reader.take(count))
        request.port_addresses.push_back(address_of(net, address));
    return reader.ok() ? ArtPacket(request) : ArtPacket();
}

ArtPacket parse_control(ByteReader reader) {
    reader.skip(2 + 7);
    const std::uint8_t net = reader.u8(), command = reader.u8(), address = reader.u8();
    if (!reader.ok()) return {};
    return TodControl{address_of(net, address), command == kFlush};
}

ArtPacket parse_tod(ByteReader reader) {
    TodData data;
    reader.skip(1);
    data.port.number = reader.u8();
    reader.skip(6);
    data.port.bind_index = reader.u8();
    const std::uint8_t net = reader.u8(), response = reader.u8(), address = reader.u8();
    data.port_address = address_of(net, address);
    data.total = reader.u16_be();
    data.block = reader.u8();
    const std::size_t count = reader.u8();
    if (!reader.ok() || response != kFull || count > kMaxUidsPerPacket) return {};
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint16_t maker = reader.u16_be();
        data.uids.push_back({maker, reader.u32_be()});
    }
    return reader.ok() ? ArtPacket(data) : ArtPacket();
}

ArtPacket parse_message(ByteReader reader) {
    reader.skip(2 + 7);
    const std::uint8_t net = reader.u8();
    reader.skip(1); // command: process
    const std::uint8_t address = reader.u8();
    if (!reader.ok()) return {};
    std::vector<std::uint8_t> bytes{kStartCode}; // Art-Net leaves it out
    const Bytes rest = reader.take(reader.left());
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return ArtRdm{address_of(net, address), parse(bytes)};
}

std::vector<std::uint8_t> header(std::uint16_t operation) {
    std::vector<std::uint8_t> out(std::begin(kIdentifier), std::end(kIdentifier));
    for (const int byte : {operation & 0xFF, operation >> 8, 0, 14})
        out.push_back(static_cast<std::uint8_t>(byte));
    return out;
}

} // namespace

bool is_rdm(Bytes packet) {
    const std::uint16_t operation = operation_of(packet);
    return operation == kTodRequest || operation == kTodData || operation == kTodControl || operation == kRdm;
}

ArtPacket parse_artnet(Bytes packet) {
    const std::uint16_t operation = operation_of(packet);
    ByteReader reader(packet);
    reader.skip(kArtnetHeaderBytes);
    switch (operation) {
    case kTodRequest:
        return parse_request(reader);
    case kTodControl:
        return parse_control(reader);
    case kTodData:
        return parse_tod(reader);
    case kRdm:
        return parse_message(reader);
    default:
        return {};
    }
}

std::vector<std::uint8_t> build_tod_data(const TodData& data) {
    CHECK(data.uids.size() <= kMaxUidsPerPacket);
    std::vector<std::uint8_t> out = header(kTodData);
    out.push_back(kRdmVersion);
    out.push_back(data.port.number);
    out.insert(out.end(), 6, 0); // spare
    out.push_back(data.port.bind_index);
    out.push_back(static_cast<std::uint8_t>(data.port_address >> 8));
    out.push_back(kFull);
    out.push_back(static_cast<std::uint8_t>(data.port_address));
    out.push_back(static_cast<std::uint8_t>(data.total >> 8));
    out.push_back(static_cast<std::uint8_t>(data.total));
    out.push_back(data.block);
    out.push_back(static_cast<std::uint8_t>(data.uids.size()));
    for (const Uid& uid : data.uids)
        for (int shift = 40; shift >= 0; shift -= 8)
            out.push_back(static_cast<std::uint8_t>(uid.number() >> shift));
    return out;
}

std::vector<std::uint8_t> build_tod_request(const TodRequest& request) {
    CHECK(!request.port_addresses.empty() && request.port_addresses.size() <= kMaxAddresses);
    std::vector<std::uint8_t> out = header(kTodRequest);
    out.insert(out.end(), 2 + 7, 0);
    out.push_back(static_cast<std::uint8_t>(request.port_addresses.front() >> 8));
    out.push_back(kFull);
    out.push_back(static_cast<std::uint8_t>(request.port_addresses.size()));
    for (const std::uint16_t address : request.port_addresses)
        out.push_back(static_cast<std::uint8_t>(address));
    return out;
}

std::vector<std::uint8_t> build_art_rdm(std::uint16_t port_address, const Message& message) {
    std::vector<std::uint8_t> out = header(kRdm);
    out.push_back(kRdmVersion);
    out.push_back(0);
    out.insert(out.end(), 7, 0);
    out.push_back(static_cast<std::uint8_t>(port_address >> 8));
    out.push_back(0); // process
    out.push_back(static_cast<std::uint8_t>(port_address));
    const std::vector<std::uint8_t> bytes = build(message);
    out.insert(out.end(), bytes.begin() + 1, bytes.end());
    return out;
}

} // namespace ghost::rdm
