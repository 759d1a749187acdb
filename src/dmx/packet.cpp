// SPDX-License-Identifier: Apache-2.0
#include "dmx/packet.h"

namespace ghost::dmx {

const char* protocol_name(Protocol protocol) {
    return protocol == Protocol::sacn ? "sACN" : "Art-Net";
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
    case Drop::bad_start_code:
    case Drop::kCount:
        break;
    }
    return "bad_start_code";
}

} // namespace ghost::dmx
