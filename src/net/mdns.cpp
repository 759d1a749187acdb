// SPDX-License-Identifier: Apache-2.0
#include "net/mdns.h"

#include "base/byte_writer.h"
#include "base/text.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

constexpr std::size_t kMostNameBytes = 255, kMostLabelBytes = 63, kMostTextBytes = 255;
constexpr std::uint16_t kResponse = 0x8400; // authoritative
constexpr std::uint16_t kResponseBit = 0x8000, kOpcodeBits = 0x7800;
constexpr std::uint16_t kInternet = 1, kClassBits = 0x7FFF; // the top bit: unicast wanted, or cache flush
constexpr std::uint8_t kPointer = 0xC0;

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool same_label(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

// A name that begins at reader's place; what it points to lies in all, before where it was read last.
std::optional<DnsName> read_name(ByteReader& reader, Bytes all) {
    DnsName name;
    std::size_t length = 1; // with the empty label at the end
    std::size_t begin = reader.position();
    ByteReader* from = &reader;
    std::optional<ByteReader> elsewhere;
    for (;;) {
        const std::uint8_t head = from->u8();
        if (!from->ok()) return std::nullopt;
        if (head == 0) return name;
        if ((head & kPointer) == kPointer) {
            const std::size_t place = static_cast<std::size_t>(head & ~kPointer) << 8 | from->u8();
            if (!from->ok() || place >= begin) return std::nullopt;
            begin = place;
            elsewhere.emplace(all);
            elsewhere->skip(place);
            from = &*elsewhere;
            continue;
        }
        if (head > kMostLabelBytes) return std::nullopt;
        const Bytes label = from->take(head);
        length += 1u + head;
        if (!from->ok() || length > kMostNameBytes) return std::nullopt;
        name.emplace_back(label.begin(), label.end());
    }
}

bool is_known(std::uint16_t type) {
    for (const DnsType known : {DnsType::a, DnsType::ptr, DnsType::txt, DnsType::aaaa, DnsType::srv})
        if (type == static_cast<std::uint16_t>(known)) return true;
    return false;
}

// The content of a record. False: not what its type says.
bool read_content(ByteReader& reader, Bytes all, std::size_t size, DnsRecord& record) {
    const std::size_t end = reader.position() + size;
    switch (record.type) {
    case DnsType::a:
        record.address = IpAddress(reader.u32_be());
        break;
    case DnsType::aaaa: {
        const Bytes bytes = reader.take(16);
        std::array<std::uint8_t, 16> address{};
        std::copy(bytes.begin(), bytes.end(), address.begin());
        record.address = IpAddress(address);
        break;
    }
    case DnsType::srv:
        reader.skip(4); // priority, weight
        record.port = reader.u16_be();
        [[fallthrough]];
    case DnsType::ptr: {
        auto target = read_name(reader, all);
        if (!target) return false;
        record.target = std::move(*target);
        break;
    }
    default:
        while (reader.ok() && reader.position() < end) {
            const Bytes text = reader.take(reader.u8());
            if (reader.ok() && !text.empty() && record.texts.size() < kMostDnsTexts)
                record.texts.emplace_back(text.begin(), text.end());
        }
    }
    return reader.ok() && reader.position() == end;
}

// Nothing where the packet is malformed from here on; a record of no type that we know is none.
std::optional<std::optional<DnsRecord>> read_record(ByteReader& reader, Bytes all) {
    auto name = read_name(reader, all);
    if (!name) return std::nullopt;
    const std::uint16_t type = reader.u16_be(), family = reader.u16_be();
    DnsRecord record;
    record.name = std::move(*name);
    record.ttl_s = reader.u32_be();
    const std::size_t size = reader.u16_be();
    if (!reader.ok() || size > reader.left()) return std::nullopt;
    if (!is_known(type) || (family & kClassBits) != kInternet) {
        reader.skip(size);
        return std::optional<DnsRecord>();
    }
    record.type = static_cast<DnsType>(type);
    if (!read_content(reader, all, size, record)) return std::nullopt;
    return record;
}

void put_text(std::vector<std::uint8_t>& out, const std::string& text, std::size_t most) {
    const std::size_t size = std::min(text.size(), most);
    out.push_back(static_cast<std::uint8_t>(size));
    out.insert(out.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
}

void put_name(std::vector<std::uint8_t>& out, const DnsName& name) {
    for (const std::string& label : name)
        if (!label.empty()) put_text(out, label, kMostLabelBytes);
    out.push_back(0);
}

void put_content(std::vector<std::uint8_t>& out, const DnsRecord& record) {
    switch (record.type) {
    case DnsType::a:
        out.insert(out.end(), record.address.bytes.begin() + 12, record.address.bytes.end());
        break;
    case DnsType::aaaa:
        out.insert(out.end(), record.address.bytes.begin(), record.address.bytes.end());
        break;
    case DnsType::srv:
        put_u16_be(out, 0);
        put_u16_be(out, 0);
        put_u16_be(out, record.port);
        [[fallthrough]];
    case DnsType::ptr:
        put_name(out, record.target);
        break;
    default:
        for (const std::string& text : record.texts) put_text(out, text, kMostTextBytes);
        if (record.texts.empty()) out.push_back(0);
    }
}

} // namespace

bool same_name(const DnsName& a, const DnsName& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_label);
}

bool ends_with(const DnsName& name, const DnsName& end) {
    return name.size() >= end.size() && std::equal(end.rbegin(), end.rend(), name.rbegin(), same_label);
}

std::string name_text(const DnsName& name) {
    std::string text;
    for (const std::string& label : name) text += (text.empty() ? "" : ".") + label;
    for (char& letter : text)
        if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F) letter = '?';
    return text;
}

std::optional<DnsPacket> parse_dns(Bytes bytes) {
    ByteReader reader(bytes);
    reader.skip(2); // number; multicast ones have none
    const std::uint16_t flags = reader.u16_be();
    const std::size_t questions = reader.u16_be();
    std::size_t records = reader.u16_be();
    records += reader.u16_be();
    records += reader.u16_be();
    if (!reader.ok() || (flags & kOpcodeBits) != 0) return std::nullopt;
    DnsPacket packet;
    packet.response = (flags & kResponseBit) != 0;
    for (std::size_t i = 0; i < questions; ++i) {
        auto name = read_name(reader, bytes);
        if (!name) return packet;
        const std::uint16_t type = reader.u16_be();
        const std::uint16_t family = reader.u16_be();
        if (!reader.ok()) return packet;
        if ((family & kClassBits) == kInternet && packet.questions.size() < kMostDnsQuestions)
            packet.questions.push_back({std::move(*name), static_cast<DnsType>(type)});
    }
    for (std::size_t i = 0; i < records && packet.records.size() < kMostDnsRecords; ++i) {
        auto record = read_record(reader, bytes);
        if (!record) return packet;
        if (*record) packet.records.push_back(std::move(**record));
    }
    return packet;
}

std::vector<std::uint8_t> build_dns(const DnsPacket& packet) {
    std::vector<std::uint8_t> out;
    put_u16_be(out, 0);
    put_u16_be(out, packet.response ? kResponse : 0);
    put_u16_be(out, packet.questions.size());
    // Known answers of a question are answers, too.
    put_u16_be(out, packet.records.size());
    put_u16_be(out, 0);
    put_u16_be(out, 0);
    for (const DnsQuestion& question : packet.questions) {
        put_name(out, question.name);
        put_u16_be(out, static_cast<std::uint16_t>(question.type));
        put_u16_be(out, kInternet);
    }
    for (const DnsRecord& record : packet.records) {
        put_name(out, record.name);
        put_u16_be(out, static_cast<std::uint16_t>(record.type));
        put_u16_be(out, kInternet); // never "flush": stations of a group may share a name
        put_u16_be(out, record.ttl_s >> 16);
        put_u16_be(out, record.ttl_s & 0xFFFF);
        std::vector<std::uint8_t> content;
        put_content(content, record);
        put_u16_be(out, content.size());
        out.insert(out.end(), content.begin(), content.end());
    }
    return out;
}

} // namespace ghost::dmx
