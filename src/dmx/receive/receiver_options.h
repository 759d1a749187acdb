#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the receiver listens to and what it makes of it. Values only.

#include "dmx/merge/merge.h"
#include "dmx/receive/poll_answers.h"
#include "dmx/receive/usb_ports.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ghost::dmx {

inline constexpr int kMaxPortAddress = 0x7FFF;

inline constexpr std::size_t kMaxAnswers = 200;
inline constexpr std::chrono::milliseconds kAnswersEvery{50};

struct ReceiverOptions {
    std::string interface; // name ("eth0") or IPv4 address of ours; empty: every interface
    bool sacn = true;
    bool artnet = true;
    std::vector<UsbPortOptions> usb; // may be plugged in later; any universe
    std::string midi;                // port to read time code from, instead of Art-Net's; empty: none
    // Universes to join, to announce and to accept. Empty: 1 to 64 are joined and announced, whatever arrives
    // is accepted.
    std::vector<std::uint16_t> universes;
    // While one of them is silent others are listened for, too, to say what comes instead (wider.h), and on
    // other interfaces than the chosen one.
    bool listen_wider = false;
    bool accept_others = false; // whatever else arrives is accepted, too
    int artnet_offset = 1;      // Ghostlight universe = Port-Address + this; -32768 to 63999
    bool show_preview = false;
    std::vector<std::uint16_t> preview_universes; // only of these; empty: of all
    bool artnet_ltp = false;
    LossPolicy loss;
    bool answer_polls = true;
    bool slot_status = false; // statistics say what each source sends, slot by slot
    // Shorter for tests.
    std::chrono::nanoseconds sampling = kSamplingPeriod;
    std::chrono::nanoseconds priority_wait = kPriorityWait;
    std::filesystem::path usb_by_id = kSerialPortsById;
    std::uint16_t sacn_port = kSacnPort;
    std::uint16_t artnet_port = kArtnetPort;
    // For recording: gets every publication, on the receiver's thread, and must be quick. A packet never
    // takes the place of levels that it did not get.
    std::function<void(const Universes&, std::chrono::nanoseconds now)> on_levels;
    // Levels that changed can be taken now; on the receiver's thread, and must be quick.
    std::function<void()> on_change;
    // Gets every Art-Net packet of a local network that is none of ours (packet.h), RDM for one; what it
    // returns goes back to who sent it, at most kMaxAnswers in kAnswersEvery. On the receiver's thread, and
    // must be quick. place_of: of a Port-Address in our ArtPollReplies, if they name it.
    using Packets = std::vector<std::vector<std::uint8_t>>;
    using PlaceOf = std::function<std::optional<PollAnswers::Place>(std::uint16_t port_address)>;
    std::function<Packets(const Datagram& datagram, const PlaceOf& place_of)> answer_artnet;
    // Asked several times a second for what goes out though nobody asks just now, until there is nothing.
    // Those packets count among kMaxAnswers. On the receiver's thread, and must be quick.
    struct Unasked {
        std::uint32_t to_ipv4 = 0;
        Packets packets;
    };
    std::function<std::optional<Unasked>(std::chrono::nanoseconds now, const PlaceOf& place_of)> unasked;
    // Whether ArtPollReply says now that our ports know RDM; on the receiver's thread.
    std::function<bool()> knows_rdm;
    // Gets every time code, of the MIDI port where one is named, else of Art-Net; on the receiver's thread,
    // and must be quick. arrival: of Art-Net as the kernel stamped it.
    std::function<void(const TimeCode&, std::chrono::nanoseconds arrival)> on_timecode;
};

// The universes that find a place whatever else arrives: those that are joined, and of the USB ports; of an
// automatic one as many as it may take. Sorted, each once.
std::vector<std::uint16_t> asked_universes(const ReceiverOptions& options);

} // namespace ghost::dmx
