#pragma once
// SPDX-License-Identifier: Apache-2.0
// What server and page say to each other by WebSocket, protocol "ghostlight.1": pictures and levels as bytes,
// little-endian, all else as JSON with a "type" (docs/reference/web.md). Sizes before anything else. Pure.

#include "base/byte_reader.h"
#include "base/report.h"
#include "base/result.h"
#include "link/link.h"
#include "web/websocket.h"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace ghost::web {

inline constexpr int kMostWidth = 4096;                // that a page may ask for
inline constexpr std::size_t kMostMessagesShown = 200; // of the show and the network, the newest

// To the server.
struct Painted {
    std::uint32_t number = 0;
};
struct Watch {
    int width = 0; // pixels that the picture has on the page
    bool calm = false;
};
struct WantLevels {
    bool on = false;
};
struct Explain {
    std::size_t fixture = 0;
};
struct Ping {
    double t = 0; // comes back as it is
};
using ToServer = std::variant<Painted, Watch, WantLevels, Explain, Ping>;
// A text or binary frame.
Result<ToServer> read_message(Opcode opcode, Bytes payload);

// To the page. drawn_ms: of the server's clock, which a pong tells. desk_ms: from the first packet that the
// picture shows until it was drawn; NaN: no packet changed it.
struct PictureHead {
    std::uint32_t number = 0;
    double drawn_ms = 0;
    float desk_ms = 0;
    float ev100 = 0;
    int width = 0;
    int height = 0;
    bool coarse = false;
    bool baked = false;
    bool at_rest = false; // the best that there will be
    bool false_colours = false;
};
std::vector<std::uint8_t> picture_message(const PictureHead& head, Bytes jpeg);
std::vector<std::uint8_t> levels_message(std::uint16_t show_version, double at_ms,
                                         std::span<const ui::FixtureNow> fixtures);

struct Looker {
    std::string from; // address
    double seconds = 0;
    double rate_hz = 0; // of the pictures that he paints
    int width = 0;
};
struct StateNow {
    const ui::Picture* picture = nullptr; // null: none yet
    const ui::RigNow* rig = nullptr;
    const dmx::Statistics* network = nullptr; // null: nothing is listened to, or not yet
    const scene::Show* show = nullptr;
    std::vector<std::string> problems; // between desk and show
    std::vector<Looker> lookers;
};
std::string hello_text();
std::string show_text(std::uint16_t version, const ui::Opened& opened);
std::string state_text(const StateNow& now);
std::string explained_text(const ui::Explained& explained);
std::string messages_text(std::span<const Message> messages);
std::string pong_text(double t, double now_ms);

} // namespace ghost::web
