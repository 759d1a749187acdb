#pragma once
// SPDX-License-Identifier: Apache-2.0
// A moving head and a controller, for tests of RDM.
#include "base/report.h"
#include "rdm/responder.h"

#include <gtest/gtest.h>

namespace ghost::rdm {

inline const Uid kController{0x7A70, 0x00000001}; // OLA's maker number
inline const Uid kAll{0xFFFF, 0xFFFFFFFF}, kAllOfOurs{kMaker, 0xFFFFFFFF};

inline constexpr std::chrono::nanoseconds kNow{1'000'000'000};

inline Device head(std::uint32_t number = 1) {
    Device device;
    device.uid = {kMaker, number};
    device.universe = 1;
    device.model = 0x1234;
    device.category = kMovingYoke;
    device.model_name = "VL2500 Spot";
    device.maker_name = "Vari-Lite";
    device.software = "Ghostlight";
    device.software_version = 0x00010203;
    device.label = "Spot " + std::to_string(number);
    device.personalities = {{"Standard 22 channels", 22}, {"Long", 60}};
    device.start_address = 23;
    device.slots = {{0x0001, false, "Dimmer"}, {0x0101, false, "Pan"}, {1, true, "Pan fine"}};
    device.sensors = {{"Pan", -2700, 2700, -15, -15, -15}, {"Tilt", -1350, 1350, 565, 565, 565}};
    return device;
}

inline Message ask(Command command, Pid pid, std::vector<std::uint8_t> data = {}, Uid to = {kMaker, 1}) {
    Message message;
    message.to = to;
    message.from = kController;
    message.transaction = 7;
    message.command = command;
    message.pid = static_cast<std::uint16_t>(pid);
    message.data = std::move(data);
    return message;
}

// Everything is allowed; what was asked for last.
struct Leave {
    std::vector<Change> changes;
    Responder::Wants wants() {
        return [this](const Change& change) -> std::optional<Nack> {
            changes.push_back(change);
            return std::nullopt;
        };
    }
};

inline std::optional<Nack> nobody_may(const Change&) {
    return Nack::write_protect;
}

} // namespace ghost::rdm
