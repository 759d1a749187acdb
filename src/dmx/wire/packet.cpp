// SPDX-License-Identifier: Apache-2.0
#include "dmx/wire/packet.h"

#include <cstdio>

namespace ghost::dmx {

const char* protocol_name(Protocol protocol) {
    return protocol == Protocol::sacn ? "sACN" : protocol == Protocol::artnet ? "Art-Net" : "USB";
}

const char* notice_name(Notice notice) {
    switch (notice) {
    case Notice::sync:
        return "sync";
    case Notice::discovery:
        return "discovery";
    case Notice::poll:
        return "poll";
    case Notice::poll_reply:
        return "poll_reply";
    case Notice::timecode:
        return "timecode";
    case Notice::trigger:
        return "trigger";
    case Notice::other_start_code:
        return "other_start_code";
    case Notice::other:
    case Notice::kCount:
        break;
    }
    return "other";
}

const char* drop_name(Drop drop) {
    switch (drop) {
    case Drop::too_short:
        return "too_short";
    case Drop::not_ours:
        return "not_ours";
    case Drop::bad_version:
        return "bad_version";
    case Drop::bad_vector:
        return "bad_vector";
    case Drop::bad_priority:
        return "bad_priority";
    case Drop::bad_universe:
        return "bad_universe";
    case Drop::bad_value:
    case Drop::kCount:
        break;
    }
    return "bad_value";
}

std::optional<Notice> notice_of(const Parsed& parsed) {
    if (std::holds_alternative<SyncPacket>(parsed)) return Notice::sync;
    if (const auto* discovery = std::get_if<DiscoveryPacket>(&parsed))
        return discovery->source.protocol == Protocol::artnet ? Notice::poll_reply : Notice::discovery;
    if (std::holds_alternative<PollPacket>(parsed)) return Notice::poll;
    if (std::holds_alternative<TimeCode>(parsed)) return Notice::timecode;
    if (std::holds_alternative<Trigger>(parsed)) return Notice::trigger;
    if (std::holds_alternative<Passing>(parsed)) return Notice::other_start_code;
    if (const Notice* notice = std::get_if<Notice>(&parsed)) return *notice;
    return std::nullopt;
}

std::string timecode_text(const TimeCode& time) {
    static constexpr const char* kRates[] = {"film 24", "EBU 25", "drop-frame 29.97", "SMPTE 30"};
    char text[48];
    std::snprintf(text, sizeof text, "%02d:%02d:%02d:%02d %s", time.hours, time.minutes, time.seconds,
                  time.frames, kRates[static_cast<std::size_t>(time.rate) & 3]);
    return text;
}

std::string trigger_text(const Trigger& trigger) {
    static constexpr const char* kKeys[] = {"ASCII", "macro", "soft key", "show"};
    char text[48];
    if (trigger.key < 4)
        std::snprintf(text, sizeof text, "%s %d", kKeys[trigger.key], trigger.sub_key);
    else
        std::snprintf(text, sizeof text, "key %d, sub-key %d of OEM 0x%04X", trigger.key, trigger.sub_key,
                      trigger.oem);
    return text;
}

} // namespace ghost::dmx
