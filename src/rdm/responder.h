#pragma once
// SPDX-License-Identifier: Apache-2.0
// Responder: one device on an RDM line: answers a controller's messages as ANSI E1.20-2010 asks (section 7
// discovery, 9 to 11 parameters; E1.11 for addresses). It has no sub-devices. What somebody else changed is
// queued (E1.20 9.4), at most kMostQueued messages, the oldest goes. An answer that comes in parts goes on
// for who asked for it alone. now: of any steady clock. One thread.

#include "rdm/device.h"

#include <chrono>
#include <deque>
#include <functional>
#include <optional>
#include <span>

namespace ghost::rdm {

inline constexpr std::size_t kMostQueued = 16;
// Controllers that may be in the middle of an answer of one device at once.
inline constexpr std::size_t kMostInParts = 4;
// Who waits for longer asks anew: controllers repeat what was lost after 2 s, and go on at once.
inline constexpr std::chrono::milliseconds kPartsWait{1500};

enum class Pid : std::uint16_t {
    disc_unique_branch = 0x0001,
    disc_mute = 0x0002,
    disc_un_mute = 0x0003,
    queued_message = 0x0020,
    status_messages = 0x0030,
    supported_parameters = 0x0050,
    device_info = 0x0060,
    device_model_description = 0x0080,
    manufacturer_label = 0x0081,
    device_label = 0x0082,
    software_version_label = 0x00C0,
    dmx_personality = 0x00E0,
    dmx_personality_description = 0x00E1,
    dmx_start_address = 0x00F0,
    slot_info = 0x0120,
    slot_description = 0x0121,
    sensor_definition = 0x0200,
    sensor_value = 0x0201,
    identify_device = 0x1000,
};

class Responder {
public:
    // wants: asked for each change; a reason where it is not allowed, else the caller makes it.
    using Wants = std::function<std::optional<Nack>(const Change&)>;

    explicit Responder(Device device) : device_(std::move(device)) {}

    const Device& device() const { return device_; }
    // As the show has it now. What a desk would want to know is queued.
    void update(Device device);
    // What its sensors have now, in their order.
    void feel(std::span<const std::int16_t> values);

    // The response, if there is one: to a broadcast, and to what is meant for others, there is none. bytes:
    // of a discovery answer instead of a message.
    struct Reply {
        std::optional<Message> message;
        std::vector<std::uint8_t> discovery;
    };
    Reply take(const Message& message, const Wants& wants, std::chrono::nanoseconds now);
    bool muted() const { return muted_; }

private:
    struct Parameter;
    static const Parameter* find(std::uint16_t pid);
    // How much of an answer that did not fit a controller has.
    struct Told {
        Uid who;
        std::uint16_t pid = 0;
        std::size_t bytes = 0;
        std::chrono::nanoseconds time{0};
    };
    Reply discover(const Message& message, std::chrono::nanoseconds now);
    Message handle(const Message& message, const Wants& wants, std::chrono::nanoseconds now);
    Message respond(const Message& to, Answer answer) const;
    std::size_t take_told(const Message& to, std::chrono::nanoseconds now);
    Message acknowledge(const Message& to, std::vector<std::uint8_t> data, std::chrono::nanoseconds now);
    Message refuse(const Message& to, Nack why) const;
    Message queued(const Message& message, std::chrono::nanoseconds now);
    void queue(Pid pid);
    std::optional<Nack> set(const Message& message, const Wants& wants);
    std::variant<std::vector<std::uint8_t>, Nack> get(Pid pid, Bytes data) const;

    Device device_;
    bool muted_ = false;
    std::deque<Message> queue_;   // GET responses
    std::optional<Message> last_; // of the queue, for "the last message again"
    std::deque<Told> told_;       // the oldest first, each controller once
};

} // namespace ghost::rdm
