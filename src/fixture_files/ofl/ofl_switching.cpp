// SPDX-License-Identifier: Apache-2.0
// Switching channels: one byte that is another channel for each setting of the channel that switches it.
#include "fixture/values.h"
#include "fixture_files/ofl/private/ofl_mode_maker.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxSettings = 1024;

bool is_light(const std::vector<ChannelFunction>& functions) {
    return std::any_of(functions.begin(), functions.end(), is_shown);
}

} // namespace

OflKeys::Found OflModeMaker::target_of(std::size_t place, const Json& capability, std::string& wanted) const {
    const OflKeys::Found& alias = places_[place].found;
    wanted = with_pixel(text_at(member(capability, "switchChannels"), alias.entry->alias), alias.pixel);
    OflKeys::Found target = wanted.empty() ? OflKeys::Found{} : keys_.find(wanted);
    if (target.entry && target.entry->kind != OflEntry::Kind::coarse) target.entry = nullptr;
    return target;
}

void OflModeMaker::make_switched(std::size_t place) {
    ChannelDraft draft;
    draft.channel.name = list_[place].substr(0, 256);
    draft.channel.offsets = {static_cast<int>(place)};
    draft.channel.logical.push_back({.attribute = "NoFeature"});
    places_[place].draft = static_cast<int>(draft_.channels.size());
    names_.push_back(draft.channel.name);
    draft_.channels.push_back(std::move(draft));
}

// A rate that a channel of its own sets: the effects of the others have it, too.
void OflModeMaker::find_strobes() {
    const auto look_at = [this](const Json& channel) {
        const Json& list = member(channel, "capabilities");
        const auto look = [&](const Json& capability) {
            const std::string type = text_at(capability, "type");
            const std::string effect = text_at(capability, "shutterEffect");
            if (type == "StrobeSpeed") strobe_rates_.insert(&channel);
            if (type != "ShutterStrobe" || effect == "Open" || effect == "Closed") return;
            for (const char* rate : {"speed", "speedStart", "duration", "durationStart"})
                if (!member(capability, rate).is_null()) return;
            strobe_kinds_.insert(&channel);
        };
        look(member(channel, "capability"));
        for (std::size_t i = 0; list.is_array() && i < list.size() && i < kMaxSettings; ++i) look(list[i]);
    };
    for (std::size_t place = 0; place < places_.size(); ++place) {
        const OflEntry* entry = places_[place].found.entry;
        if (!entry) continue;
        if (entry->kind == OflEntry::Kind::coarse) look_at(*entry->channel);
        if (entry->kind != OflEntry::Kind::switching) continue;
        const Json& capabilities = member(*entry->channel, "capabilities");
        std::string wanted;
        for (std::size_t i = 0; capabilities.is_array() && i < capabilities.size() && i < kMaxSettings; ++i)
            if (const OflKeys::Found target = target_of(place, capabilities[i], wanted); target.entry)
                look_at(*target.entry->channel);
    }
}

void OflModeMaker::link_switches() {
    for (std::size_t place = 0; place < places_.size(); ++place)
        if (is_switching(place)) link_switch(place);
}

void OflModeMaker::link_switch(std::size_t place) {
    const OflKeys::Found found = places_[place].found;
    const auto trigger = place_of_.find(with_pixel(found.entry->key, found.pixel));
    const int master = trigger == place_of_.end() ? -1 : places_[trigger->second].draft;
    if (master < 0)
        reader_.say(Severity::error, pointers_[place],
                    "what switches '" + list_[place].substr(0, 80) +
                        "' is not in this mode: it does what its "
                        "first setting says");
    const Json& capabilities = member(*found.entry->channel, "capabilities");
    const OflChannelSketch& switching = sketch_of(*found.entry);
    const int master_bytes =
        master < 0
            ? 1
            : static_cast<int>(draft_.channels[static_cast<std::size_t>(master)].channel.offsets.size());
    for (std::size_t i = 0; capabilities.is_array() && i < capabilities.size() && i < kMaxSettings; ++i) {
        const Json& range = member(capabilities[i], "dmxRange");
        std::string wanted;
        const OflKeys::Found target = target_of(place, capabilities[i], wanted);
        if (!target.entry || !range.is_array() || range.size() != 2) {
            if (!wanted.empty() || !range.is_array())
                reader_.say(Severity::error, found.entry->pointer + "/capabilities/" + std::to_string(i),
                            "switches to '" + wanted.substr(0, 80) +
                                "', which is no channel of one byte or more");
            continue;
        }
        ChannelFunction condition;
        if (master >= 0) {
            const float limit = static_cast<float>(dmx_max(switching.bytes));
            const auto raw = [&](const Json& value) {
                return ofl_scaled(
                    static_cast<std::uint32_t>(std::clamp(number_in(value).value_or(0.0f), 0.0f, limit)),
                    switching.bytes, master_bytes);
            };
            condition.master_channel = master;
            condition.master_from = raw(range[0]);
            condition.master_to = raw(range[1]);
            if (switching.bytes < master_bytes)
                condition.master_to |= dmx_max(master_bytes - switching.bytes);
        }
        add_target(place, target, wanted, condition);
        if (master < 0) break;
    }
}

// Targets that light other pixels, or have other bytes, are channels of their own on the alias's byte.
void OflModeMaker::add_target(std::size_t place, const OflKeys::Found& target, const std::string& name,
                              const ChannelFunction& condition) {
    if (functions_made_ > kMaxBuiltFunctions) return;
    const OflChannelSketch& sketch = sketch_of(*target.entry);
    const auto first = static_cast<std::size_t>(places_[place].draft);
    std::size_t index = first;
    if (is_light(sketch.functions)) {
        const std::vector<int> offsets = offsets_of(*target.entry, target.pixel, place);
        const std::vector<int> cells = cells_of(target.pixel);
        const auto fits = [&](const ChannelDraft& draft) {
            const Channel& channel = draft.channel;
            if (channel.offsets[0] != static_cast<int>(place)) return false;
            if (channel.functions.empty()) return true;
            return channel.offsets == offsets && (!is_light(channel.functions) || draft.cells == cells);
        };
        while (index < draft_.channels.size() && !fits(draft_.channels[index])) ++index;
        if (index == draft_.channels.size()) {
            ChannelDraft draft;
            draft.channel.name = draft_.channels[first].channel.name;
            draft.channel.logical = draft_.channels[first].channel.logical;
            names_.push_back(name);
            draft_.channels.push_back(std::move(draft));
        }
        draft_.channels[index].channel.offsets = offsets;
        draft_.channels[index].cells = cells;
        names_[index] = name;
        has_gobos_ |= sketch.gobo;
        if (sketch.preset && (presets_.empty() || presets_.back() != index)) presets_.push_back(index);
    }
    Channel& channel = draft_.channels[index].channel;
    const int bytes = static_cast<int>(channel.offsets.size());
    if (channel.functions.empty()) channel.initial = ofl_scaled(sketch.initial, sketch.bytes, bytes);
    channel.max = dmx_max(bytes);
    std::vector<ChannelFunction> made = ofl_fitted(sketch, bytes);
    set_numbers(made);
    for (ChannelFunction& function : made) {
        if (++functions_made_ > kMaxBuiltFunctions)
            return reader_.say(Severity::error, pointer_, "the mode has more than 65536 functions");
        function.master_channel = condition.master_channel;
        function.master_from = condition.master_from;
        function.master_to = condition.master_to;
        channel.functions.push_back(std::move(function));
    }
}

} // namespace ghost::fixture
