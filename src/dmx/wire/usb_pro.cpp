// SPDX-License-Identifier: Apache-2.0
#include "dmx/wire/usb_pro.h"

#include "base/check.h"

#include <algorithm>
#include <bit>
#include <cstdio>

namespace ghost::dmx {

namespace {

constexpr std::uint8_t kStart = 0x7E, kEnd = 0xE7;
constexpr std::size_t kHead = 4; // start, label, length low and high
constexpr std::size_t kChangeBits = 40;

constexpr std::uint8_t code_of(UsbProLabel label) {
    return static_cast<std::uint8_t>(label);
}

// Serial numbers are two decimal digits a byte, lowest first; all ones: none was ever set.
std::string serial_text(Bytes data) {
    std::string digits;
    for (std::size_t i = 4; i-- > 0;) {
        char two[4];
        std::snprintf(two, sizeof two, "%02X", data[i]);
        digits += two;
    }
    return digits;
}

} // namespace

std::vector<std::uint8_t> build_usb_pro(std::uint8_t label, Bytes data) {
    CHECK(data.size() <= kMostUsbProData);
    std::vector<std::uint8_t> bytes{kStart, label, static_cast<std::uint8_t>(data.size() & 255),
                                    static_cast<std::uint8_t>(data.size() >> 8)};
    bytes.insert(bytes.end(), data.begin(), data.end());
    bytes.push_back(kEnd);
    return bytes;
}

void UsbProReader::feed(Bytes bytes, const Take& take) {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    std::size_t at = 0;
    while (at < buffer_.size()) {
        const Bytes left = Bytes(buffer_).subspan(at);
        if (left[0] == kStart) {
            if (left.size() < kHead) break;
            const std::size_t length = static_cast<std::size_t>(left[2] | (left[3] << 8));
            if (length <= kMostUsbProData) {
                if (left.size() < kHead + length + 1) break;
                if (left[kHead + length] == kEnd) {
                    take(left[1], left.subspan(kHead, length));
                    at += kHead + length + 1;
                    continue;
                }
            }
        }
        ++at;
        ++skipped_bytes_;
    }
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at));
}

UsbProWidget::UsbProWidget(std::uint16_t universe, std::string port) : port_(std::move(port)) {
    packet_.protocol = packet_.source.protocol = Protocol::usb;
    packet_.universe = universe;
    packet_.source_name = port_;
    // Ports differ in their last letters: /dev/ttyUSB0, .../usb-ENTTEC_DMX_USB_PRO_EN123456-if00-port0.
    const std::size_t length = std::min(port_.size(), packet_.source.id.size());
    std::copy(port_.end() - static_cast<std::ptrdiff_t>(length), port_.end(), packet_.source.id.begin());
}

std::vector<std::uint8_t> UsbProWidget::hello() {
    constexpr std::uint8_t kNoUserData[2] = {0, 0};
    constexpr std::uint8_t kSendAlways[1] = {0};
    std::vector<std::uint8_t> bytes = build_usb_pro(code_of(UsbProLabel::parameters), kNoUserData);
    for (const auto& more : {build_usb_pro(code_of(UsbProLabel::serial), {}),
                             build_usb_pro(code_of(UsbProLabel::receive_mode), kSendAlways)})
        bytes.insert(bytes.end(), more.begin(), more.end());
    return bytes;
}

void UsbProWidget::feed(Bytes bytes, const std::function<void(const Packet&)>& take) {
    reader_.feed(bytes, [&](std::uint8_t label, Bytes data) { take_message(label, data, take); });
    counters_.skipped_bytes = reader_.skipped_bytes();
}

Packet UsbProWidget::goodbye() const {
    Packet packet = packet_;
    packet.terminated = true;
    return packet;
}

void UsbProWidget::take_message(std::uint8_t label, Bytes data,
                                const std::function<void(const Packet&)>& take) {
    bool levels = false;
    if (label == code_of(UsbProLabel::frame)) {
        levels = take_frame(data);
    } else if (label == code_of(UsbProLabel::changes)) {
        levels = take_changes(data);
    } else if (label == code_of(UsbProLabel::parameters) && data.size() >= 5) {
        firmware_ = std::to_string(data[1]) + "." + std::to_string(data[0]);
    } else if (label == code_of(UsbProLabel::serial) && data.size() == 4) {
        serial_ = serial_text(data);
        packet_.source_name = "DMX USB Pro " + serial_ + " at " + port_;
    } else {
        const bool known = label == code_of(UsbProLabel::parameters) || label == code_of(UsbProLabel::serial);
        ++(known ? counters_.malformed : counters_.other_labels);
        return;
    }
    answered_ = true;
    if (!levels) return;
    ++counters_.frames;
    take(packet_);
}

// Status, start code, slots. Status 0: whole; bit 0: the widget's queue ran over, bit 1: it lost bytes.
bool UsbProWidget::take_frame(Bytes data) {
    if (data.size() < 2 || data.size() > 2 + kSlots) {
        ++counters_.malformed;
        return false;
    }
    if (data[0] != 0) {
        ++counters_.overruns;
        return false;
    }
    if (data[1] != 0) {
        ++counters_.not_levels;
        return false;
    }
    start_code_ = 0;
    const Bytes slots = data.subspan(2);
    packet_.slots = {};
    std::copy(slots.begin(), slots.end(), packet_.slots.begin());
    packet_.slot_count = static_cast<std::uint16_t>(slots.size());
    return true;
}

// First byte / 8, forty bits, one byte for each bit that is set. Byte 0 is the start code, byte n address n.
bool UsbProWidget::take_changes(Bytes data) {
    ByteReader reader(data);
    const std::size_t first = std::size_t{8} * reader.u8();
    const Bytes bits = reader.take(kChangeBits / 8);
    int changed = 0;
    for (const std::uint8_t eight : bits) changed += std::popcount(eight);
    const Bytes values = reader.take(static_cast<std::size_t>(changed));
    if (!reader.ok() || first > kSlots) {
        ++counters_.malformed;
        return false;
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < kChangeBits; ++i) {
        if ((bits[i / 8] >> (i % 8) & 1) == 0) continue;
        const std::size_t place = first + i;
        const std::uint8_t value = values[next++];
        if (place == 0) {
            start_code_ = value;
        } else if (place <= kSlots && start_code_ == 0) {
            packet_.slots[place - 1] = value;
            packet_.slot_count = std::max(packet_.slot_count, static_cast<std::uint16_t>(place));
        }
    }
    if (start_code_ != 0) ++counters_.not_levels;
    return start_code_ == 0;
}

} // namespace ghost::dmx
