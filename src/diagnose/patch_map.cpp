// SPDX-License-Identifier: Apache-2.0
#include "diagnose/patch_map.h"

#include "dmx/wire/universes.h"
#include "show/show.h"

#include <algorithm>
#include <set>

namespace ghost::scene {
namespace {

constexpr int kSlots = static_cast<int>(dmx::kSlots);

// A fixture that runs past channel 512 goes on in the next universe.
std::pair<int, int> place_of(const fixture::Address& address, int offset) {
    const int channel = address.channel - 1 + offset;
    return {address.universe + channel / kSlots, channel % kSlots + 1};
}

std::string byte_text(const fixture::Channel& channel, std::size_t byte) {
    if (channel.offsets.size() < 2) return channel.name;
    return channel.name + " (" + std::to_string(byte + 1) + " of " + std::to_string(channel.offsets.size()) +
           ")";
}

bool dims(const fixture::Channel& channel) {
    return std::any_of(channel.functions.begin(), channel.functions.end(),
                       [](const auto& function) { return function.meaning.role == fixture::Role::dimmer; });
}

struct Byte {
    std::string name;
    bool dims = false;
};

// What each byte of a break is.
std::vector<Byte> bytes_of(const fixture::Mode& mode, std::size_t part) {
    std::vector<Byte> bytes;
    for (int i = 0; i < mode.footprint[part]; ++i) bytes.push_back({"channel " + std::to_string(i + 1)});
    for (const fixture::Channel& channel : mode.channels) {
        if (channel.dmx_break != static_cast<int>(part) + 1) continue;
        for (std::size_t byte = 0; byte < channel.offsets.size(); ++byte) {
            const int offset = channel.offsets[byte];
            if (offset >= 0 && offset < mode.footprint[part])
                bytes[static_cast<std::size_t>(offset)] = {byte_text(channel, byte), dims(channel)};
        }
    }
    return bytes;
}

} // namespace

PatchMap::PatchMap(const Show& show) {
    std::map<int, std::set<std::size_t>> fixtures;     // by universe
    std::map<int, std::map<std::size_t, int>> runs_on; // by universe, fixture: where it begins
    // Movers come after the fixtures.
    const auto name_of = [&](std::size_t index) {
        const std::size_t count = show.fixtures.size();
        return index < count ? show.fixtures[index].name : show.movers[index - count].name;
    };
    const auto add = [&](std::pair<int, int> place, std::size_t index, const std::string& channel,
                         bool dims = false) {
        if (place.first < 1 || place.first > dmx::kMaxUniverse) return;
        slots_.emplace(place, PatchedSlot{index, name_of(index), channel, dims});
        fixtures[place.first].insert(index);
    };
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        const PatchedFixture& fixture = show.fixtures[i];
        if (fixture.track && fixture.track->address > 0)
            for (int byte = 0; byte < 2; ++byte)
                add(place_of({fixture.track->universe, fixture.track->address}, byte), i,
                    "track (" + std::to_string(byte + 1) + " of 2)");
        if (!fixture.type) continue;
        const fixture::Patch patch = fixture.patch();
        const fixture::Mode& mode = patch.mode_of();
        for (std::size_t part = 0; part < std::min(patch.addresses.size(), mode.footprint.size()); ++part) {
            if (patch.addresses[part].channel < 1) continue;
            const std::vector<Byte> bytes = bytes_of(mode, part);
            for (std::size_t byte = 0; byte < bytes.size(); ++byte) {
                const std::pair<int, int> place = place_of(patch.addresses[part], static_cast<int>(byte));
                add(place, i, bytes[byte].name, bytes[byte].dims);
                if (place.first != patch.addresses[part].universe)
                    runs_on[place.first].emplace(i, patch.addresses[part].universe);
            }
        }
    }
    for (std::size_t m = 0; m < show.movers.size(); ++m)
        for (const MoverAxis& axis : show.movers[m].axes)
            for (std::size_t byte = 0; axis.fixture.empty() && byte < axis.levels.size(); ++byte)
                add({axis.levels[byte].universe, axis.levels[byte].channel}, show.fixtures.size() + m,
                    axis.name + " (" + std::to_string(byte + 1) + " of " +
                        std::to_string(axis.levels.size()) + ")");
    for (const auto& [universe, indices] : fixtures) {
        const auto& from = runs_on[universe];
        universes_.push_back({static_cast<std::uint16_t>(universe), indices.size(), name_of(*indices.begin()),
                              from.size() == indices.size() ? from.begin()->second : 0});
    }
}

std::vector<std::uint16_t> PatchMap::universe_numbers() const {
    std::vector<std::uint16_t> numbers;
    for (const PatchedUniverse& one : universes_) numbers.push_back(one.universe);
    return numbers;
}

bool PatchMap::has(int universe) const {
    return std::any_of(universes_.begin(), universes_.end(),
                       [&](const PatchedUniverse& one) { return one.universe == universe; });
}

std::vector<int> PatchMap::dimmers(int universe) const {
    std::vector<int> result;
    const auto last = slots_.upper_bound({universe, kSlots});
    for (auto slot = slots_.lower_bound({universe, 1}); slot != last; ++slot)
        if (slot->second.dims && (result.empty() || result.back() != slot->first.second))
            result.push_back(slot->first.second);
    return result;
}

std::vector<const PatchedSlot*> PatchMap::at(int universe, int address) const {
    std::vector<const PatchedSlot*> result;
    const auto [first, last] = slots_.equal_range({universe, address});
    for (auto slot = first; slot != last; ++slot) result.push_back(&slot->second);
    return result;
}

std::vector<std::string> PatchMap::readers_past(int universe, int address) const {
    std::map<std::size_t, std::string> readers;
    const auto last = slots_.upper_bound({universe, kSlots});
    const auto end = slots_.upper_bound({universe, address});
    for (auto slot = end; slot != last; ++slot)
        readers.emplace(slot->second.fixture, slot->second.fixture_name);
    for (auto slot = slots_.lower_bound({universe, 1}); slot != end; ++slot)
        readers.erase(slot->second.fixture);
    std::vector<std::string> names;
    for (const auto& [fixture, name] : readers) names.push_back(name);
    return names;
}

} // namespace ghost::scene
