// SPDX-License-Identifier: Apache-2.0
#include "rdm/responder.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ghost::rdm {

namespace {

constexpr std::uint16_t kProtocolVersion = 0x0100; // E1.20-2010
constexpr std::uint16_t kNoAddress = 0xFFFF;
constexpr int kSlots = 512;
constexpr std::uint8_t kAngle = 0x11, kDegree = 0x16, kDeci = 0x01; // tables
constexpr std::uint8_t kLowestAndHighest = 0x02;                    // of a sensor: recorded
constexpr std::uint8_t kLastMessage = 0x01, kHighestStatus = 0x04;  // table A-4

using Data = std::vector<std::uint8_t>;

void put_word(Data& out, int value) {
    out.push_back(static_cast<std::uint8_t>(value >> 8));
    out.push_back(static_cast<std::uint8_t>(value));
}

// Names of ours are UTF-8: none ends in the middle of a letter.
void put_text(Data& out, const std::string& text) {
    std::size_t end = std::min(text.size(), kMaxLabelBytes);
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    out.insert(out.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end));
}

Data text(const std::string& value) {
    Data out;
    put_text(out, value);
    return out;
}

std::uint16_t u16_of(Bytes data) {
    return static_cast<std::uint16_t>(data[0] << 8 | data[1]);
}

Data device_info(const Device& device) {
    Data out;
    put_word(out, kProtocolVersion);
    put_word(out, device.model);
    put_word(out, device.category);
    put_word(out, static_cast<int>(device.software_version >> 16));
    put_word(out, static_cast<int>(device.software_version & 0xFFFF));
    put_word(out, device.footprint());
    out.push_back(device.personality);
    out.push_back(static_cast<std::uint8_t>(std::min(device.personalities.size(), kMostPersonalities)));
    put_word(out, device.footprint() > 0 ? device.start_address : kNoAddress);
    put_word(out, 0); // sub-devices
    out.push_back(static_cast<std::uint8_t>(std::min(device.sensors.size(), kMostSensors)));
    return out;
}

Data slot_info(const Device& device) {
    Data out;
    for (std::size_t i = 0; i < device.slots.size(); ++i) {
        put_word(out, static_cast<int>(i));
        out.push_back(device.slots[i].fine ? 1 : 0);
        put_word(out, device.slots[i].label);
    }
    return out;
}

Data sensor_definition(const Sensor& sensor, std::uint8_t number) {
    Data out{number, kAngle, kDegree, kDeci};
    for (const int value : {sensor.least, sensor.most, sensor.least, sensor.most}) put_word(out, value);
    out.push_back(kLowestAndHighest);
    put_text(out, sensor.name);
    return out;
}

Data sensor_value(const Sensor& sensor, std::uint8_t number) {
    Data out{number};
    for (const int value : {int{sensor.value}, int{sensor.lowest}, int{sensor.highest}, 0})
        put_word(out, value);
    return out;
}

} // namespace

// get_bytes, set_bytes: how long the data of a command is; least to most; none: not allowed.
struct Responder::Parameter {
    struct Bounds {
        std::size_t least = 1, most = 0;
        bool allowed() const { return least <= most; }
        bool has(std::size_t bytes) const { return bytes >= least && bytes <= most; }
    };
    Pid pid;
    Bounds get, set;
    bool listed; // in SUPPORTED_PARAMETERS: whatever is not required of every device (10.4.1)
};

const Responder::Parameter* Responder::find(std::uint16_t pid) {
    using B = Parameter::Bounds;
    static const std::array kAll = {
        Parameter{Pid::queued_message, B{1, 1}, B{}, true},
        Parameter{Pid::status_messages, B{1, 1}, B{}, true},
        Parameter{Pid::supported_parameters, B{0, 0}, B{}, false},
        Parameter{Pid::device_info, B{0, 0}, B{}, false},
        Parameter{Pid::device_model_description, B{0, 0}, B{}, true},
        Parameter{Pid::manufacturer_label, B{0, 0}, B{}, true},
        Parameter{Pid::device_label, B{0, 0}, B{0, kMaxLabelBytes}, true},
        Parameter{Pid::software_version_label, B{0, 0}, B{}, false},
        Parameter{Pid::dmx_personality, B{0, 0}, B{1, 1}, true},
        Parameter{Pid::dmx_personality_description, B{1, 1}, B{}, true},
        Parameter{Pid::dmx_start_address, B{0, 0}, B{2, 2}, false},
        Parameter{Pid::slot_info, B{0, 0}, B{}, true},
        Parameter{Pid::slot_description, B{2, 2}, B{}, true},
        Parameter{Pid::sensor_definition, B{1, 1}, B{}, true},
        Parameter{Pid::sensor_value, B{1, 1}, B{1, 1}, true},
        Parameter{Pid::identify_device, B{0, 0}, B{1, 1}, false},
    };
    for (const Parameter& one : kAll)
        if (static_cast<std::uint16_t>(one.pid) == pid) return &one;
    return nullptr;
}

void Responder::queue(Pid pid) {
    Message message;
    message.pid = static_cast<std::uint16_t>(pid);
    const auto data = get(pid, {});
    if (const Data* found = std::get_if<Data>(&data)) message.data = *found;
    std::erase_if(queue_, [&](const Message& one) { return one.pid == message.pid; });
    if (queue_.size() == kMostQueued) queue_.pop_front();
    queue_.push_back(std::move(message));
}

void Responder::feel(std::span<const std::int16_t> values) {
    for (std::size_t i = 0; i < std::min(values.size(), device_.sensors.size()); ++i) {
        Sensor& sensor = device_.sensors[i];
        sensor.value = values[i];
        sensor.lowest = std::min(sensor.lowest, values[i]);
        sensor.highest = std::max(sensor.highest, values[i]);
    }
}

void Responder::update(Device device) {
    const Device before = std::exchange(device_, std::move(device));
    for (std::size_t i = 0; i < device_.sensors.size(); ++i) {
        Sensor& sensor = device_.sensors[i];
        const bool known = i < before.sensors.size();
        sensor.lowest = std::min(known ? before.sensors[i].lowest : sensor.value, sensor.value);
        sensor.highest = std::max(known ? before.sensors[i].highest : sensor.value, sensor.value);
    }
    if (!told_.empty() &&
        (device_.personality != before.personality || slot_info(device_) != slot_info(before)))
        told_.clear();
    if (device_.start_address != before.start_address) queue(Pid::dmx_start_address);
    if (device_.personality != before.personality) queue(Pid::dmx_personality);
    if (device_.label != before.label) queue(Pid::device_label);
    if (device_.identifies != before.identifies) queue(Pid::identify_device);
}

Message Responder::respond(const Message& to, Answer answer) const {
    Message response;
    response.to = to.from;
    response.from = device_.uid;
    response.transaction = to.transaction;
    response.port_or_answer = static_cast<std::uint8_t>(answer);
    response.queued = static_cast<std::uint8_t>(queue_.size());
    response.sub_device = to.sub_device;
    response.command = to.command;
    response.is_response = true;
    response.pid = to.pid;
    return response;
}

// Whatever else a controller asks ends the answer that it was told a part of.
std::size_t Responder::take_told(const Message& to, std::chrono::nanoseconds now) {
    const auto found =
        std::find_if(told_.begin(), told_.end(), [&](const Told& one) { return one.who == to.from; });
    if (found == told_.end()) return 0;
    const bool goes_on = to.command == Command::get && found->pid == to.pid && now - found->time < kPartsWait;
    const std::size_t bytes = goes_on ? found->bytes : 0;
    told_.erase(found);
    return bytes;
}

Message Responder::acknowledge(const Message& to, Data data, std::chrono::nanoseconds now) {
    const std::size_t told = std::min(take_told(to, now), data.size());
    data.erase(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(told));
    const bool goes_on = data.size() > kMaxDataBytes; // the next GET of it brings the next part (6.3.2)
    if (goes_on) {
        data.resize(kMaxDataBytes);
        if (told_.size() == kMostInParts) told_.pop_front();
        told_.push_back({to.from, to.pid, told + kMaxDataBytes, now});
    }
    Message response = respond(to, goes_on ? Answer::ack_overflow : Answer::ack);
    response.data = std::move(data);
    return response;
}

Message Responder::refuse(const Message& to, Nack why) const {
    Message response = respond(to, Answer::nack);
    put_word(response.data, static_cast<int>(why));
    return response;
}

Responder::Reply Responder::discover(const Message& message, std::chrono::nanoseconds now) {
    const auto pid = static_cast<Pid>(message.pid);
    if (pid == Pid::disc_unique_branch) {
        if (muted_ || message.data.size() != 12 || !message.to.is_broadcast()) return {};
        ByteReader reader{Bytes(message.data)};
        const auto read = [&] {
            const std::uint64_t maker = reader.u16_be();
            return maker << 32 | reader.u32_be();
        };
        const std::uint64_t low = read(), high = read(), own = device_.uid.number();
        if (own < low || own > high) return {};
        return {{}, build_discovery_answer(device_.uid)};
    }
    if (pid != Pid::disc_mute && pid != Pid::disc_un_mute) return {};
    if (!message.data.empty()) return {}; // no response to a discovery message that is wrong (7.3)
    muted_ = pid == Pid::disc_mute;
    if (message.to.is_broadcast()) return {};
    return {acknowledge(message, {0, 0}, now), {}}; // control field: no proxy, no sub-devices, no boot loader
}

Responder::Reply Responder::take(const Message& message, const Wants& wants, std::chrono::nanoseconds now) {
    if (message.is_response || !message.to.means(device_.uid)) return {};
    if (message.command == Command::discovery) return discover(message, now);
    if (message.to.is_broadcast()) {
        if (message.command == Command::set) (void)handle(message, wants, now);
        return {};
    }
    return {handle(message, wants, now), {}};
}

Message Responder::handle(const Message& message, const Wants& wants, std::chrono::nanoseconds now) {
    const Parameter* const parameter = find(message.pid);
    if (!parameter) return refuse(message, Nack::unknown_pid);
    if (message.sub_device != 0) return refuse(message, Nack::sub_device_out_of_range);
    const Parameter::Bounds& bounds = message.command == Command::get ? parameter->get : parameter->set;
    if (!bounds.allowed()) return refuse(message, Nack::unsupported_command);
    if (!bounds.has(message.data.size())) return refuse(message, Nack::format_error);
    if (message.command == Command::set) {
        if (const auto why = set(message, wants)) return refuse(message, *why);
        Data echo; // only a sensor says again which it is, and its value (10.7.2)
        if (parameter->pid == Pid::sensor_value && message.data[0] != 0xFF)
            echo = sensor_value(device_.sensors[message.data[0]], message.data[0]);
        else if (parameter->pid == Pid::sensor_value)
            echo = Data{0xFF, 0, 0, 0, 0, 0, 0, 0, 0};
        return acknowledge(message, echo, now);
    }
    if (parameter->pid == Pid::queued_message) return queued(message, now);
    auto got = get(parameter->pid, message.data);
    if (const Nack* why = std::get_if<Nack>(&got)) return refuse(message, *why);
    return acknowledge(message, std::move(std::get<Data>(got)), now);
}

// E1.20 9.4: a message that waits, or, where none does, a status message without any status.
Message Responder::queued(const Message& message, std::chrono::nanoseconds now) {
    const std::uint8_t kind = message.data[0];
    if (kind < kLastMessage || kind > kHighestStatus) return refuse(message, Nack::data_out_of_range);
    if (kind != kLastMessage || !last_) {
        std::optional<Message> next;
        if (!queue_.empty()) {
            next.emplace(std::move(queue_.front()));
            queue_.pop_front();
        }
        last_ = std::move(next);
    }
    Message as = message;
    as.pid = last_ ? last_->pid : static_cast<std::uint16_t>(Pid::status_messages);
    return acknowledge(as, last_ ? last_->data : Data{}, now);
}

std::optional<Nack> Responder::set(const Message& message, const Wants& wants) {
    const Data& data = message.data;
    Change change;
    change.uid = device_.uid;
    switch (static_cast<Pid>(message.pid)) {
    case Pid::dmx_start_address: {
        const int address = u16_of(data), last = address + std::max<int>(device_.footprint(), 1) - 1;
        if (device_.footprint() == 0 || address < 1 || last > kSlots) return Nack::data_out_of_range;
        change.what = Change::What::start_address;
        change.number = static_cast<std::uint16_t>(address);
        break;
    }
    case Pid::dmx_personality:
        if (data[0] < 1 || data[0] > device_.personalities.size()) return Nack::data_out_of_range;
        if (const int footprint = device_.personalities[data[0] - 1u].footprint;
            device_.footprint() > 0 && device_.start_address + footprint - 1 > kSlots)
            return Nack::data_out_of_range; // it would end beyond the universe
        change.what = Change::What::personality;
        change.number = data[0];
        break;
    case Pid::device_label:
        change.what = Change::What::label;
        change.label.assign(data.begin(), data.end());
        break;
    case Pid::identify_device:
        if (data[0] > 1) return Nack::data_out_of_range;
        change.what = Change::What::identify;
        change.number = data[0];
        break;
    case Pid::sensor_value: {
        const std::size_t first = data[0] == 0xFF ? 0 : data[0];
        if (data[0] != 0xFF && first >= device_.sensors.size()) return Nack::data_out_of_range;
        const std::size_t last = data[0] == 0xFF ? device_.sensors.size() : first + 1;
        for (std::size_t i = first; i < last; ++i)
            device_.sensors[i].lowest = device_.sensors[i].highest = device_.sensors[i].value;
        return std::nullopt;
    }
    default:
        return Nack::unsupported_command;
    }
    if (const auto why = wants(change)) return why;
    // Who asked need not be told by the queue as well, and what waits there is the value before.
    std::erase_if(queue_, [&](const Message& one) { return one.pid == message.pid; });
    switch (change.what) {
    case Change::What::start_address:
        device_.start_address = change.number;
        break;
    case Change::What::personality:
        device_.personality = static_cast<std::uint8_t>(change.number);
        told_.clear();
        break;
    case Change::What::label:
        device_.label = change.label;
        break;
    case Change::What::identify:
        device_.identifies = change.number != 0;
        break;
    }
    return std::nullopt;
}

std::variant<Data, Nack> Responder::get(Pid pid, Bytes data) const {
    switch (pid) {
    case Pid::supported_parameters: {
        Data out;
        for (int one = 1; one <= 0x1000; ++one)
            if (const Parameter* found = find(static_cast<std::uint16_t>(one)); found && found->listed)
                put_word(out, one);
        return out;
    }
    case Pid::device_info:
        return device_info(device_);
    case Pid::device_model_description:
        return text(device_.model_name);
    case Pid::manufacturer_label:
        return text(device_.maker_name);
    case Pid::device_label:
        return text(device_.label);
    case Pid::software_version_label:
        return text(device_.software);
    case Pid::dmx_personality:
        return Data{device_.personality,
                    static_cast<std::uint8_t>(std::min(device_.personalities.size(), kMostPersonalities))};
    case Pid::dmx_personality_description: {
        if (data[0] < 1 || data[0] > device_.personalities.size()) return Nack::data_out_of_range;
        const Personality& personality = device_.personalities[data[0] - 1u];
        Data out{data[0]};
        put_word(out, personality.footprint);
        put_text(out, personality.name);
        return out;
    }
    case Pid::dmx_start_address: {
        Data out;
        put_word(out, device_.footprint() > 0 ? device_.start_address : kNoAddress);
        return out;
    }
    case Pid::slot_info:
        return slot_info(device_);
    case Pid::slot_description: {
        const std::size_t slot = u16_of(data);
        if (slot >= device_.slots.size()) return Nack::data_out_of_range;
        Data out(data.begin(), data.end());
        put_text(out, device_.slots[slot].name);
        return out;
    }
    case Pid::sensor_definition:
    case Pid::sensor_value:
        if (data[0] >= device_.sensors.size()) return Nack::data_out_of_range;
        return pid == Pid::sensor_value ? sensor_value(device_.sensors[data[0]], data[0])
                                        : sensor_definition(device_.sensors[data[0]], data[0]);
    case Pid::identify_device:
        return Data{static_cast<std::uint8_t>(device_.identifies ? 1 : 0)};
    case Pid::status_messages: // nothing ever happens to a fixture that is not there
        if (data[0] > kHighestStatus) return Nack::data_out_of_range;
        return Data{};
    default:
        return Nack::unknown_pid;
    }
}

} // namespace ghost::rdm
