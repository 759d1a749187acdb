#pragma once
// SPDX-License-Identifier: Apache-2.0
// UsbPorts: the DMX USB Pro widgets that somebody asked for, plugged in or not. A port that is not there is
// looked for once a second; one that goes away says goodbye for its source, and is opened again when it comes
// back. No clock: calls get the time. One thread, that of the receiver.

#include "dmx/wire/usb_pro.h"
#include "net/serial.h"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kMostUsbPorts = 64;

struct UsbPortOptions {
    std::string path; // "/dev/ttyUSB0"; "auto": every widget in kSerialPortsById, universes counted up
    std::uint16_t universe = 1; // of auto: the first one's
};

// One port, for people.
struct UsbPortStatus {
    std::string path;
    std::uint16_t universe = 0;
    bool open = false;
    bool answered = false; // open, and a widget speaks there
    std::string problem;   // why it is not open
    std::string serial;
    std::string firmware;
    UsbProCounters counters;
    std::uint64_t openings = 0; // 1: never pulled out
};

class UsbPorts {
public:
    // by_id: where "auto" looks.
    UsbPorts(std::vector<UsbPortOptions> wanted, std::filesystem::path by_id);

    using Take = std::function<void(const Packet&)>;
    // Reads what has arrived, at most 64 KiB of each port; opens what has come, says hello again where nobody
    // answers. Call when a handle has bytes, and a few times a second.
    void take(std::chrono::nanoseconds now, const Take& take);
    // Of the ports that are open.
    std::vector<int> handles() const;
    std::vector<UsbPortStatus> status() const;

private:
    struct Port {
        std::string path;
        std::uint16_t universe = 0;
        std::unique_ptr<SerialPort> serial;   // null: not open
        std::unique_ptr<UsbProWidget> widget; // of the last opening
        std::string problem;
        std::uint64_t openings = 0;
        std::chrono::nanoseconds next_hello{0};
    };
    void look(std::chrono::nanoseconds now);
    void receive(const Take& take);
    void find_new();
    void open(Port& port, std::chrono::nanoseconds now);
    void lose(Port& port, const Take& take);

    std::vector<UsbPortOptions> wanted_;
    std::filesystem::path by_id_;
    std::vector<Port> ports_;
    std::chrono::nanoseconds next_look_{0};
};

} // namespace ghost::dmx
