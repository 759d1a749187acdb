#pragma once
// SPDX-License-Identifier: Apache-2.0
// Multicast DNS (RFC 6762) as far as finding and announcing a service needs it (RFC 6763): packets of
// questions and of PTR, SRV, TXT, A and AAAA records (RFC 1035, 2782, 3596), read and written. Pure; any
// bytes are taken. A name is its labels, for labels may hold dots; upper and lower case are the same.

#include "base/byte_reader.h"
#include "net/address.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ghost::dmx {

inline constexpr std::uint32_t kMdnsGroup = 0xE00000FB; // 224.0.0.251
inline constexpr std::uint16_t kMdnsPort = 5353;
inline constexpr std::size_t kMostDnsQuestions = 64; // of a packet that we read; the rest is left out
inline constexpr std::size_t kMostDnsRecords = 256;
inline constexpr std::size_t kMostDnsTexts = 64;

using DnsName = std::vector<std::string>;
bool same_name(const DnsName& a, const DnsName& b);
bool ends_with(const DnsName& name, const DnsName& end);
// Labels with dots between them, for people; what cannot be printed is a '?'.
std::string name_text(const DnsName& name);

enum class DnsType : std::uint16_t { a = 1, ptr = 12, txt = 16, aaaa = 28, srv = 33, any = 255 };

struct DnsQuestion {
    DnsName name;
    DnsType type = DnsType::any; // may be one that we do not know

    bool operator==(const DnsQuestion&) const = default;
};

struct DnsRecord {
    DnsName name;
    DnsType type = DnsType::ptr;    // one of those above
    std::uint32_t ttl_s = 120;      // 0: it is gone
    DnsName target;                 // PTR, SRV
    std::uint16_t port = 0;         // SRV
    IpAddress address;              // A, AAAA
    std::vector<std::string> texts; // TXT: "key=value"

    bool operator==(const DnsRecord&) const = default;
};

struct DnsPacket {
    bool response = false;
    std::vector<DnsQuestion> questions;
    std::vector<DnsRecord> records; // answers, authorities and additional ones; other types are left out

    bool operator==(const DnsPacket&) const = default;
};

// Up to what is malformed or cut; nothing where not even the header is one. Names are at most 255 bytes long,
// and a compressed one points backwards only, so no packet makes a loop.
std::optional<DnsPacket> parse_dns(Bytes bytes);

// Without compression. Labels and texts longer than 63 and 255 bytes are cut.
std::vector<std::uint8_t> build_dns(const DnsPacket& packet);

} // namespace ghost::dmx
