// SPDX-License-Identifier: Apache-2.0
// Stations by mDNS. The standard leaves open what the instance of the service is called; seen in the field:
// GROUP._mvrxchange._tcp.local, shared by all stations of a group (BlenderDMX), STATION.GROUP._mvrxchange..
// and STATION@GROUP._mvrxchange... All are read; we answer with the first to who asks for the service, and
// with the second to who asks for the group.
#include "base/print.h"
#include "xchange/protocol.h"

#include <algorithm>

namespace ghost::scene {

namespace {

using dmx::DnsName;
using dmx::DnsPacket;
using dmx::DnsQuestion;
using dmx::DnsRecord;
using dmx::DnsType;

constexpr std::uint32_t kTtl_s = 120;
constexpr std::size_t kMostStations = 64; // of a packet

const DnsName& service() {
    static const DnsName name{"_mvrxchange", "_tcp", "local"};
    return name;
}

DnsName under_service(std::vector<std::string> labels) {
    labels.insert(labels.end(), service().begin(), service().end());
    return labels;
}

std::string name_of(const std::string& text) {
    return one_line(text.substr(0, kMaxXchangeText));
}

// Texts of a record, each "key=value"; older stations write "StationName=..;StationUUID=.." in one.
std::vector<std::string> texts_of(const DnsRecord& record) {
    static constexpr std::string_view kSecond = ";StationUUID=";
    std::vector<std::string> texts;
    for (const std::string& text : record.texts) {
        const std::size_t second = text.rfind(kSecond);
        texts.push_back(text.substr(0, second));
        if (second != std::string::npos) texts.push_back(text.substr(second + 1));
    }
    return texts;
}

// Whatever capitals the key has.
std::string value_of(const DnsRecord& record, std::string_view key) {
    for (const std::string& text : texts_of(record)) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals != key.size()) continue;
        const bool same = std::equal(key.begin(), key.end(), text.begin(),
                                     [](char a, char b) { return (a | 0x20) == (b | 0x20); });
        if (same) return name_of(text.substr(equals + 1));
    }
    return "";
}

const DnsRecord* find(const DnsPacket& packet, DnsType type, const DnsName& name) {
    for (const DnsRecord& record : packet.records)
        if (record.type == type && dmx::same_name(record.name, name)) return &record;
    return nullptr;
}

// The sender's own address, if the station says that it has it: others may not be reached from here.
dmx::IpAddress address_of(const DnsPacket& packet, const DnsName& host, const dmx::IpAddress& from) {
    dmx::IpAddress first;
    for (const DnsRecord& record : packet.records) {
        if ((record.type != DnsType::a && record.type != DnsType::aaaa) || !dmx::same_name(record.name, host))
            continue;
        if (record.address == from) return from;
        const bool alike = record.address.is_ipv4() == from.is_ipv4();
        if (alike && first == dmx::IpAddress()) first = record.address;
    }
    return first == dmx::IpAddress() ? from : first;
}

std::string host_of(const XchangeStation& us) {
    return "ghostlight-" + us.uuid.substr(0, 8);
}

void describe(const XchangeStation& us, const DnsName& name, DnsPacket& packet) {
    const std::uint32_t ttl_s = us.gone ? 0 : kTtl_s;
    const DnsName host{host_of(us), "local"};
    packet.records.push_back({name, DnsType::srv, ttl_s, host, us.port, {}, {}});
    packet.records.push_back(
        {name, DnsType::txt, ttl_s, {}, 0, {}, {"StationName=" + us.name, "StationUUID=" + us.uuid}});
    packet.records.push_back(
        {host, us.address.is_ipv4() ? DnsType::a : DnsType::aaaa, ttl_s, {}, 0, us.address, {}});
}

// The two ways to be found.
struct Pointer {
    DnsName from, to;
};
std::vector<Pointer> pointers(const XchangeStation& us) {
    return {{service(), under_service({us.group})},
            {under_service({us.group}), under_service({us.name, us.group})}};
}

} // namespace

std::vector<XchangeStation> xchange_stations(const DnsPacket& packet, const dmx::IpAddress& from) {
    std::vector<XchangeStation> stations;
    if (!packet.response) return stations;
    for (const DnsRecord& record : packet.records) {
        if (record.type != DnsType::srv || !dmx::ends_with(record.name, service()) ||
            record.name.size() <= service().size() || stations.size() == kMostStations)
            continue;
        XchangeStation station;
        const std::string& last = record.name[record.name.size() - service().size() - 1];
        const std::size_t at = last.rfind('@');
        station.group = name_of(at == std::string::npos ? last : last.substr(at + 1));
        station.name = name_of(at == std::string::npos ? record.name.front() : last.substr(0, at));
        if (const DnsRecord* const text = find(packet, DnsType::txt, record.name)) {
            if (const std::string name = value_of(*text, "StationName"); !name.empty()) station.name = name;
            station.uuid = value_of(*text, "StationUUID");
            for (char& letter : station.uuid)
                if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
        }
        station.address = address_of(packet, record.target, from);
        station.port = record.port;
        station.gone = record.ttl_s == 0;
        if (station.port != 0 && std::find(stations.begin(), stations.end(), station) == stations.end())
            stations.push_back(std::move(station));
    }
    return stations;
}

DnsPacket xchange_question(const std::string& group) {
    return {false, {{service(), DnsType::ptr}, {under_service({group}), DnsType::ptr}}, {}};
}

std::optional<DnsPacket> xchange_answer(const DnsPacket& question, const XchangeStation& us) {
    if (question.response) return std::nullopt;
    DnsPacket answer{true, {}, {}};
    for (const Pointer& pointer : pointers(us)) {
        bool asked = false;
        for (const DnsQuestion& one : question.questions) {
            const bool any = one.type == DnsType::any;
            asked = asked || ((any || one.type == DnsType::ptr) && dmx::same_name(one.name, pointer.from)) ||
                    ((any || one.type == DnsType::srv || one.type == DnsType::txt) &&
                     dmx::same_name(one.name, pointer.to));
        }
        if (!asked) continue;
        answer.records.push_back({pointer.from, DnsType::ptr, kTtl_s, pointer.to, 0, {}, {}});
        describe(us, pointer.to, answer);
    }
    if (answer.records.empty()) return std::nullopt;
    return answer;
}

DnsPacket xchange_announcement(const XchangeStation& us) {
    DnsPacket packet{true, {}, {}};
    for (const Pointer& pointer : pointers(us)) {
        packet.records.push_back({pointer.from, DnsType::ptr, us.gone ? 0 : kTtl_s, pointer.to, 0, {}, {}});
        describe(us, pointer.to, packet);
    }
    return packet;
}

} // namespace ghost::scene
