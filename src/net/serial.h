#pragma once
// SPDX-License-Identifier: Apache-2.0
// Serial ports: all that dmx asks of the operating system about them. Raw bytes, never waiting. A port
// belongs to one program: opening locks it. One thread per port. Errors name the port.

#include "base/byte_reader.h"
#include "base/result.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::dmx {

class SerialPort {
public:
    // 8 bits, no parity, no flow control; 57600 baud, which widgets behind a USB converter ignore.
    static Result<std::unique_ptr<SerialPort>> open(const std::string& path);
    // One that MIDI comes by, to be read only: a raw device of ALSA, a serial port or a pipe.
    static Result<std::unique_ptr<SerialPort>> open_midi(const std::string& path);
    ~SerialPort();
    SerialPort(const SerialPort&) = delete;
    SerialPort& operator=(const SerialPort&) = delete;

    // What has arrived, at most 4 KiB, valid until the next call; empty: nothing. nullopt: the port is gone.
    std::optional<Bytes> receive();
    // False: not all could be written.
    bool send(Bytes bytes);
    int handle() const { return handle_; } // to wait for, together with sockets

private:
    struct Overlapped; // what Windows has on its way; elsewhere nothing
    explicit SerialPort(int handle);

    int handle_;
    std::vector<std::uint8_t> buffer_;
    std::unique_ptr<Overlapped> overlapped_;
};

// Where Linux names serial ports by what is plugged in.
inline const std::filesystem::path kSerialPortsById = "/dev/serial/by-id";

// Ports of DMX USB Pro widgets and those that name themselves alike (DMXking), sorted by name.
std::vector<std::string> list_usb_pro_ports(const std::filesystem::path& folder);

} // namespace ghost::dmx
