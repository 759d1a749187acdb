#pragma once
// SPDX-License-Identifier: Apache-2.0
// The serial protocol of the Enttec DMX USB Pro and its kin (API 1.44): messages 7E label length data E7, of
// which a widget that receives DMX sends 5 (a frame), 9 (changes), 3 (parameters) and 10 (serial number).
// Bytes in, packets out; any bytes are taken, what is no message is counted and skipped. No clock, no port
// (usb_ports.h has both).

#include "dmx/wire/packet.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kMostUsbProData = 600; // of a message, by its API

enum class UsbProLabel : std::uint8_t {
    parameters = 3,
    frame = 5,
    receive_mode = 8,
    changes = 9,
    serial = 10
};

// data: at most kMostUsbProData bytes.
std::vector<std::uint8_t> build_usb_pro(std::uint8_t label, Bytes data);

// Finds messages in a stream: a length above the limit or a missing E7 was no message, and the search goes on
// one byte further. Keeps less than one message.
class UsbProReader {
public:
    // data: valid during the call only.
    using Take = std::function<void(std::uint8_t label, Bytes data)>;
    void feed(Bytes bytes, const Take& take);
    std::uint64_t skipped_bytes() const { return skipped_bytes_; } // outside of messages

private:
    std::vector<std::uint8_t> buffer_;
    std::uint64_t skipped_bytes_ = 0;
};

struct UsbProCounters {
    std::uint64_t frames = 0;        // with levels, of label 5 and 9
    std::uint64_t overruns = 0;      // dropped: the widget says that it lost part of them
    std::uint64_t not_levels = 0;    // dropped: another start code (text, RDM)
    std::uint64_t malformed = 0;     // dropped: shorter than their own head says
    std::uint64_t other_labels = 0;  // dropped: not asked for
    std::uint64_t skipped_bytes = 0; // between messages
};

// What one widget told, as packets of one universe.
class UsbProWidget {
public:
    // port: tells this widget from others, and is shown.
    UsbProWidget(std::uint16_t universe, std::string port);

    // What to write when the port opens: asks for parameters and serial number, and to send every frame. The
    // last one matters: a widget that has sent DMX before stays in output until it hears it.
    static std::vector<std::uint8_t> hello();

    void feed(Bytes bytes, const std::function<void(const Packet&)>& take);
    // The port is gone: what its source says last.
    Packet goodbye() const;

    bool answered() const { return answered_; }               // it is a widget: one message was understood
    const std::string& serial() const { return serial_; }     // decimal digits; empty: not told yet
    const std::string& firmware() const { return firmware_; } // "1.44"; empty: not told yet
    const UsbProCounters& counters() const { return counters_; }

private:
    bool take_frame(Bytes data);
    bool take_changes(Bytes data);
    void take_message(std::uint8_t label, Bytes data, const std::function<void(const Packet&)>& take);

    UsbProReader reader_;
    UsbProCounters counters_;
    Packet packet_; // levels so far
    std::string port_;
    std::string serial_, firmware_;
    std::uint8_t start_code_ = 0; // as changes (label 9) left it
    bool answered_ = false;
};

} // namespace ghost::dmx
