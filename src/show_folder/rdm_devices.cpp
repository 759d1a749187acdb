// SPDX-License-Identifier: Apache-2.0
#include "show_folder/rdm_devices.h"
#include "show/show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

namespace ghost::scene {
namespace {

constexpr std::uint32_t kVersion = 0x00000100; // 0.1
constexpr std::uint32_t kPrime = 0x01000193, kSeed = 0x811C9DC5;
constexpr std::uint32_t kNobody = 0, kEverybody = 0xFFFFFFFF;

// FNV-1a.
std::uint32_t hash_of(std::string_view text, std::uint32_t seed = kSeed) {
    for (const char letter : text) seed = (seed ^ static_cast<std::uint8_t>(letter)) * kPrime;
    return seed;
}

// Slot labels of E1.20-2010, table C-2, by the beginning of a GDTF attribute; the first that fits.
struct Label {
    const char* attribute;
    std::uint16_t label;
};
constexpr Label kLabels[] = {
    {"Dimmer", 0x0001},      {"PanRotate", 0x0103},  {"TiltRotate", 0x0104}, {"Pan", 0x0101},
    {"Tilt", 0x0102},        {"ColorSub_C", 0x0202}, {"ColorSub_Y", 0x0203}, {"ColorSub_M", 0x0204},
    {"ColorAdd_RY", 0x0212}, {"ColorAdd_R", 0x0205}, {"ColorAdd_G", 0x0206}, {"ColorAdd_B", 0x0207},
    {"ColorAdd_W", 0x0212},  {"CTO", 0x0208},        {"CTC", 0x0208},        {"CTB", 0x0208},
    {"Color", 0x0201},       {"Gobo", 0x0301},       {"Prism", 0x0303},      {"Effects", 0x0304},
    {"Iris", 0x0401},        {"Focus", 0x0402},      {"Frost", 0x0403},      {"Shutter", 0x0404},
    {"StrobeMode", 0x0404},  {"Zoom", 0x0405},       {"Blade", 0x0406},      {"ShaperRot", 0x0407},
    {"Control", 0x0501},     {"Fan", 0x0501},
};

std::uint16_t label_of(const fixture::Channel& channel) {
    const std::string attribute = channel.logical.empty() ? "" : channel.logical.front().attribute;
    for (const Label& one : kLabels)
        if (attribute.starts_with(one.attribute)) return one.label;
    return rdm::kUndefinedSlot;
}

int footprint_of(const fixture::Mode& mode) {
    return mode.footprint.empty() ? 0 : mode.footprint.front();
}

std::vector<rdm::Slot> slots_of(const fixture::Mode& mode) {
    std::vector<rdm::Slot> slots(static_cast<std::size_t>(std::clamp(footprint_of(mode), 0, 512)));
    for (std::size_t i = 0; i < slots.size(); ++i) slots[i].name = "Channel " + std::to_string(i + 1);
    for (const fixture::Channel& channel : mode.channels) {
        if (channel.dmx_break != 1) continue;
        for (std::size_t byte = 0; byte < channel.offsets.size(); ++byte) {
            const int offset = channel.offsets[byte];
            if (offset < 0 || offset >= static_cast<int>(slots.size())) continue;
            rdm::Slot& slot = slots[static_cast<std::size_t>(offset)];
            const std::string attribute = channel.logical.empty() ? "" : channel.logical.front().attribute;
            slot.fine = byte > 0;
            slot.label =
                byte > 0 ? static_cast<std::uint16_t>(std::max(channel.offsets[0], 0)) : label_of(channel);
            slot.name = (attribute.empty() ? channel.name : attribute) + (byte > 0 ? " fine" : "");
        }
    }
    return slots;
}

// In tenths of a degree, as many as fit.
std::int16_t tenths(double degrees) {
    return static_cast<std::int16_t>(std::lround(std::clamp(degrees * 10.0, -32767.0, 32767.0)));
}

// What tells an angle as a sensor; null: the mode has no such channel.
const fixture::ChannelFunction* angle_of(const fixture::Mode& mode, std::string_view attribute) {
    for (const fixture::Channel& channel : mode.channels)
        if (!channel.logical.empty() && channel.logical.front().attribute == attribute &&
            !channel.functions.empty())
            return &channel.functions.front();
    return nullptr;
}

constexpr const char* kAngles[] = {"Pan", "Tilt"};

std::vector<rdm::Sensor> sensors_of(const fixture::Mode& mode, const fixture::State& state) {
    std::vector<rdm::Sensor> sensors;
    const std::vector<std::int16_t> values = rdm_angles(mode, state);
    for (const char* const attribute : kAngles) {
        const fixture::ChannelFunction* const angle = angle_of(mode, attribute);
        if (!angle) continue;
        rdm::Sensor sensor;
        sensor.name = attribute + std::string(" position");
        const double a = angle->physical_from, b = angle->physical_to;
        sensor.least = tenths(std::min(a, b));
        sensor.most = tenths(std::max(a, b));
        sensor.value = sensor.lowest = sensor.highest = values[sensors.size()];
        sensors.push_back(std::move(sensor));
    }
    return sensors;
}

} // namespace

std::vector<std::int16_t> rdm_angles(const fixture::Mode& mode, const fixture::State& state) {
    std::vector<std::int16_t> values;
    if (angle_of(mode, kAngles[0])) values.push_back(tenths(static_cast<double>(state.pan_deg)));
    if (angle_of(mode, kAngles[1])) values.push_back(tenths(static_cast<double>(state.tilt_deg)));
    return values;
}

std::vector<RdmFixture> rdm_devices(const Show& show, const std::vector<fixture::State>& states) {
    std::vector<RdmFixture> result;
    std::map<std::string, int> named;
    std::set<std::uint32_t> taken{kNobody, kEverybody};
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        const PatchedFixture& fixture = show.fixtures[i];
        const std::string key = fixture.uuid.empty() ? fixture.name : fixture.uuid;
        const int place = named[key]++;
        if (!fixture.type || fixture.address < 1 || fixture.universe < 1) continue;
        const fixture::Type& type = *fixture.type;
        if (fixture.mode < 0 || static_cast<std::size_t>(fixture.mode) >= type.modes.size()) continue;
        const fixture::Mode& mode = type.modes[static_cast<std::size_t>(fixture.mode)];
        rdm::Device device;
        std::uint32_t number = hash_of(std::to_string(place), hash_of(key));
        while (!taken.insert(number).second) number = number * kPrime + 1;
        device.uid = {rdm::kMaker, number};
        device.universe = static_cast<std::uint16_t>(std::min(fixture.universe, 63999));
        device.model = static_cast<std::uint16_t>(
            hash_of(type.fixture_type_id.empty() ? type.name : type.fixture_type_id));
        device.category = mode.axes.empty() ? rdm::kFixedFixture : rdm::kMovingYoke;
        device.model_name = type.name;
        device.maker_name = type.manufacturer;
        device.software = "Ghostlight virtual fixture";
        device.software_version = kVersion;
        device.label = fixture.name;
        for (const fixture::Mode& one : type.modes)
            if (device.personalities.size() < rdm::kMostPersonalities)
                device.personalities.push_back(
                    {one.name, static_cast<std::uint16_t>(std::clamp(footprint_of(one), 0, 512))});
        device.personality = static_cast<std::uint8_t>(std::min(fixture.mode + 1, 255));
        device.start_address = static_cast<std::uint16_t>(std::min(fixture.address, 512));
        device.slots = slots_of(mode);
        device.sensors = sensors_of(mode, i < states.size() ? states[i] : fixture::State{});
        result.push_back({i, std::move(device)});
    }
    return result;
}

} // namespace ghost::scene
