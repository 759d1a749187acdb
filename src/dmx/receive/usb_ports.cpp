// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/usb_ports.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kLookEvery = 1s;
constexpr std::chrono::nanoseconds kHelloEvery = 2s; // a widget that was just plugged in is deaf for a moment
constexpr int kReadsPerTurn = 16;

} // namespace

UsbPorts::UsbPorts(std::vector<UsbPortOptions> wanted, std::filesystem::path by_id)
    : wanted_(std::move(wanted)), by_id_(std::move(by_id)) {
    for (const UsbPortOptions& one : wanted_)
        if (one.path != "auto") ports_.push_back({one.path, one.universe, nullptr, nullptr, "", 0, {}});
}

// A widget keeps the universe that it got when it was first seen.
void UsbPorts::find_new() {
    for (const UsbPortOptions& one : wanted_) {
        if (one.path != "auto") continue;
        for (const std::string& path : list_usb_pro_ports(by_id_)) {
            const auto same = [&](const Port& port) { return port.path == path; };
            if (ports_.size() >= kMostUsbPorts || std::any_of(ports_.begin(), ports_.end(), same)) continue;
            int universe = one.universe;
            const auto taken = [&](const Port& port) { return port.universe == universe; };
            while (std::any_of(ports_.begin(), ports_.end(), taken)) ++universe;
            if (universe > kMaxUniverse) return;
            ports_.push_back({path, static_cast<std::uint16_t>(universe), nullptr, nullptr, "", 0, {}});
        }
    }
}

void UsbPorts::open(Port& port, std::chrono::nanoseconds now) {
    auto opened = SerialPort::open(port.path);
    if (!opened.ok()) {
        port.problem = opened.error().what;
        return;
    }
    port.serial = std::move(*opened);
    port.widget = std::make_unique<UsbProWidget>(port.universe, port.path);
    port.problem.clear();
    port.next_hello = now;
    ++port.openings;
}

void UsbPorts::lose(Port& port, const Take& take) {
    take(port.widget->goodbye());
    port.serial.reset();
    port.problem = "was pulled out";
}

void UsbPorts::look(std::chrono::nanoseconds now) {
    if (now >= next_look_) {
        next_look_ = now + kLookEvery;
        find_new();
        for (Port& port : ports_)
            if (!port.serial) open(port, now);
    }
    for (Port& port : ports_) {
        if (!port.serial || port.widget->answered() || now < port.next_hello) continue;
        port.next_hello = now + kHelloEvery;
        // A full buffer is asked again; a port that is gone shows when it is read.
        (void)port.serial->send(UsbProWidget::hello());
    }
}

void UsbPorts::take(std::chrono::nanoseconds now, const Take& take) {
    receive(take);
    look(now);
}

void UsbPorts::receive(const Take& take) {
    for (Port& port : ports_) {
        for (int turn = 0; port.serial && turn < kReadsPerTurn; ++turn) {
            const std::optional<Bytes> bytes = port.serial->receive();
            if (!bytes)
                lose(port, take);
            else if (bytes->empty())
                break;
            else
                port.widget->feed(*bytes, take);
        }
    }
}

std::vector<int> UsbPorts::handles() const {
    std::vector<int> result;
    for (const Port& port : ports_)
        if (port.serial) result.push_back(port.serial->handle());
    return result;
}

std::vector<UsbPortStatus> UsbPorts::status() const {
    std::vector<UsbPortStatus> result;
    for (const Port& port : ports_) {
        UsbPortStatus status;
        status.path = port.path;
        status.universe = port.universe;
        status.open = port.serial != nullptr;
        status.problem = port.problem;
        status.openings = port.openings;
        if (port.widget) {
            status.answered = status.open && port.widget->answered();
            status.serial = port.widget->serial();
            status.firmware = port.widget->firmware();
            status.counters = port.widget->counters();
        }
        result.push_back(std::move(status));
    }
    return result;
}

} // namespace ghost::dmx
