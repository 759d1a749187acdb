#pragma once
// SPDX-License-Identifier: Apache-2.0
// What server and page say to each other by WebSocket, protocol "ghostlight.1": pictures and levels as bytes,
// little-endian, all else as JSON with a "type" (docs/reference/web.md). Sizes before anything else. Pure.

#include "base/byte_reader.h"
#include "base/report.h"
#include "base/result.h"
#include "link/link.h"
#include "web/site.h"
#include "web/websocket.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ghost::web {

inline constexpr int kMostWidth = 4096;                // that a page may ask for
inline constexpr std::size_t kMostArguments = 8;       // of one Do
inline constexpr std::size_t kMostWordBytes = 32;      // of what is to be done
inline constexpr std::size_t kMostArgumentBytes = 256; // of one that is a text
inline constexpr std::size_t kMostMessagesShown = 200; // of the show and the network, the newest

// To the server.
struct Painted {
    std::uint32_t number = 0;
};
// A camera that a page has chosen freely.
struct OwnCamera {
    glm::vec3 position_m{0};
    glm::vec3 target_m{0};
    float fov_y_deg = 40;
    bool operator==(const OwnCamera&) const = default;
};
struct Watch {
    int width = 0; // pixels that the picture has on the page
    bool calm = false;
    std::string camera;             // of the show; empty: the window's picture, or `own`
    std::optional<OwnCamera> own;   // instead of one of the show
    std::optional<glm::vec2> probe; // what is measured there; not of the window's picture
};
struct WantLevels {
    bool on = false;
};
struct WantPictures {
    bool on = false; // small ones, of cameras and looks
};
struct Do {
    std::uint32_t n = 0; // that the answer has
    ui::Command command; // without its number
};
struct Unread {}; // a Do of somebody who may not
struct Explain {
    std::size_t fixture = 0;
};
struct Ping {
    double t = 0; // comes back as it is
};
using ToServer = std::variant<Painted, Watch, WantLevels, WantPictures, Explain, Ping, Do, Unread>;
// A text or binary frame. may_control: else what is to be done is not looked at.
Result<ToServer> read_message(Opcode opcode, Bytes payload, bool may_control = false);

// To the page. drawn_ms: of the server's clock, which a pong tells. desk_ms: from the first packet that the
// picture shows until it was drawn; NaN: no packet changed it.
struct PictureHead {
    int stream = 0; // 0: the window's; 1: a side view
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
    bool still = false; // it is renewed when the show rests, and not before
};
std::vector<std::uint8_t> picture_message(const PictureHead& head, Bytes jpeg);
enum class SmallKind : std::uint8_t { camera, look };
std::vector<std::uint8_t> small_message(SmallKind kind, std::string_view name, Bytes jpeg);
std::vector<std::uint8_t> levels_message(std::uint16_t show_version, double at_ms,
                                         std::span<const ui::FixtureNow> fixtures);

struct Looker {
    std::string from; // address
    double seconds = 0;
    double rate_hz = 0; // of the pictures that he paints
    int width = 0;
    bool controls = false;
};
struct StateNow {
    const ui::Picture* picture = nullptr; // null: none yet
    const ui::RigNow* rig = nullptr;
    const dmx::Statistics* network = nullptr; // null: nothing is listened to, or not yet
    std::string cue;                          // that the show is in; "": none is known
    std::vector<std::string> problems;        // between desk and show
    std::vector<Looker> lookers;
};
std::string hello_text(Right right);
std::string looks_text(const ui::LooksNow& looks);
std::string measure_text(const ui::SideMeasure& measure);
std::string done_text(std::uint32_t n);
// n 0: it was no Do.
std::string refused_text(std::uint32_t n, const std::string& why);
std::string bye_text(const std::string& why);
std::string show_text(std::uint16_t version, const ui::Opened& opened);
std::string state_text(const StateNow& now);
std::string explained_text(const ui::Explained& explained);
std::string messages_text(std::span<const Message> messages);
std::string pong_text(double t, double now_ms);

} // namespace ghost::web
