#pragma once
// SPDX-License-Identifier: Apache-2.0
// MVR-xchange (DIN SPEC 15801, 1.6): what stations say to each other over TCP: packages of JSON messages and
// of .mvr files, and who a station is by its mDNS records. Pure; read liberally, for the standard contradicts
// itself and programs differ: numbers and truth values may be texts, commits may be called files, the number
// and the count of packages may change places. Every size is bounded.

#include "base/byte_reader.h"
#include "base/result.h"
#include "net/mdns.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

inline constexpr std::size_t kXchangeHeaderBytes = 28;
inline constexpr std::size_t kMaxXchangeMessageBytes = 1u << 20;
inline constexpr std::uint64_t kMaxXchangeFileBytes = 1ull << 30;
inline constexpr std::uint32_t kMaxXchangePackages = 65'536; // of a message
inline constexpr std::size_t kMostXchangeCommits = 256;      // of a message
inline constexpr std::size_t kMaxXchangeText = 256;          // bytes of a name, comment ..

enum class XchangePayload : std::uint32_t { message = 0, file = 1 };

// number counts from 0.
std::vector<std::uint8_t> build_xchange_header(XchangePayload payload, std::uint64_t bytes,
                                               std::uint32_t number = 0, std::uint32_t count = 1);

// Takes a connection's bytes as they come and hands on what they say.
class XchangeReader {
public:
    struct Sink {
        std::function<Result<void>(std::string_view json)> message;
        // A piece of a file; last: it is complete.
        std::function<Result<void>(Bytes piece, bool last)> file;
    };
    // Error: the connection is of no use any more: foreign bytes, over a limit, or what the sink says.
    Result<void> take(Bytes bytes, const Sink& sink);
    // Something began and is not complete.
    bool inside() const { return !head_.empty() || left_ > 0 || next_number_ > 0; }

private:
    Result<void> begin_package();
    Result<void> take_content(Bytes content, const Sink& sink);

    std::vector<std::uint8_t> head_; // of a package, until it is whole
    XchangePayload payload_ = XchangePayload::message;
    std::uint64_t left_ = 0; // of this package
    bool last_ = true;       // package of its message
    std::uint32_t next_number_ = 0, count_ = 1;
    std::uint64_t total_ = 0; // of the message so far
    std::string json_;
};

// A version of a plot that a station has.
struct XchangeCommit {
    std::string file_uuid;
    std::string asked_as; // file_uuid as its station writes it: some compare letters
    std::string station_uuid;
    std::string file_name;
    std::string comment;
    std::uint64_t file_size = 0;           // bytes; 0: not told
    std::vector<std::string> for_stations; // UUIDs; empty: for all
    std::string station_asked_as;          // station_uuid as its station writes it
};

struct XchangeMessage {
    std::string type; // "MVR_JOIN" .., capitals
    bool ok = true;   // of answers
    std::string text; // what went wrong
    std::string provider;
    std::string station_name;
    std::string station_uuid;           // who speaks, where it says so; of a request, whom is asked
    std::string file_uuid;              // of a request
    std::vector<XchangeCommit> commits; // of a commit: the one

    bool is_answer() const { return type.ends_with("_RET"); }
};

// UUIDs come out in small letters and without braces, texts without control characters and cut.
Result<XchangeMessage> parse_xchange_message(std::string_view json);
// Type decides what of it is written.
std::string xchange_message_text(const XchangeMessage& message);

// A station as its mDNS answer tells it.
struct XchangeStation {
    std::string name;
    std::string uuid;
    std::string group;
    dmx::IpAddress address;
    std::uint16_t port = 0;
    bool gone = false; // it says goodbye

    bool operator==(const XchangeStation&) const = default;
};
// Those that one packet describes; from: who sent it.
std::vector<XchangeStation> xchange_stations(const dmx::DnsPacket& packet, const dmx::IpAddress& from);
// What a station asks the network, and what it answers. Null: nothing that was asked is ours.
dmx::DnsPacket xchange_question(const std::string& group);
std::optional<dmx::DnsPacket> xchange_answer(const dmx::DnsPacket& question, const XchangeStation& us);
// Unasked: that we are here, or (us.gone) that we leave.
dmx::DnsPacket xchange_announcement(const XchangeStation& us);

// The same for the same parts: who we are, what a file is.
std::string uuid_of(std::span<const std::string_view> parts);
// Fit for a file system everywhere, ends in ".mvr"; never empty.
std::string plot_file_name(const std::string& wanted);

} // namespace ghost::scene
