// SPDX-License-Identifier: Apache-2.0
// Modes: matrix inserts spread out, keys resolved, bytes joined.
#include "fixture/values.h"
#include "fixture_files/ofl/private/ofl_mode_maker.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxModes = 512;
constexpr std::size_t kMaxModeChannels = 8192;
constexpr std::size_t kMaxAllChannels = 65536; // of all modes

std::string name_of(const OflEntry& entry, const std::string& key, const std::string& pixel) {
    const std::string stated = text_at(*entry.channel, "name");
    return stated.empty() ? key.substr(0, 256) : with_pixel(stated, pixel);
}

} // namespace

std::size_t OflModeMaker::run(std::size_t room) {
    draft_.name = text_at(json_, "name");
    if (draft_.name.empty()) draft_.name = text_at(json_, "shortName");
    read_physical();
    list_keys(std::min(room, kMaxModeChannels));
    draft_.footprint = static_cast<int>(list_.size());
    resolve();
    find_strobes();
    find_cells();
    for (std::size_t place = 0; place < list_.size(); ++place) make_channel(place);
    link_switches();
    find_groups();
    find_layers();
    link_turns();
    make_body();
    mix_colours(reader_.loaded.type, builder_, draft_.channels, presets_);
    const std::size_t made = list_.size();
    if (!builder_.add_mode(std::move(draft_)))
        reader_.say(Severity::error, pointer_,
                    "the mode is left out: the fixture has more than 65536 nodes or functions");
    return made;
}

void OflModeMaker::read_physical() {
    const Json& own = member(json_, "physical");
    if (!own.is_object()) return;
    const OflPhysical stated = read_ofl_physical(reader_, own, pointer_ + "/physical");
    LampFacts& lamp = physical_.lamp;
    if (!stated.lamp.bulb.empty()) lamp.bulb = stated.lamp.bulb;
    if (!stated.lamp.lens.empty()) lamp.lens = stated.lamp.lens;
    if (stated.lamp.lumens > 0.0f) lamp.lumens = stated.lamp.lumens;
    if (stated.lamp.power_w > 0.0f) lamp.power_w = stated.lamp.power_w;
    if (stated.lamp.color_temperature_k > 0.0f) lamp.color_temperature_k = stated.lamp.color_temperature_k;
    if (stated.lamp.degrees_max > 0.0f) {
        lamp.degrees_min = stated.lamp.degrees_min;
        lamp.degrees_max = stated.lamp.degrees_max;
    }
    if (stated.size_m != glm::vec3(0.0f)) physical_.size_m = stated.size_m;
    if (!stated.focus.empty()) physical_.focus = stated.focus;
    if (stated.pan_max_deg > 0.0f) physical_.pan_max_deg = stated.pan_max_deg;
    if (stated.tilt_max_deg > 0.0f) physical_.tilt_max_deg = stated.tilt_max_deg;
}

void OflModeMaker::push(const Json& key, const std::string& pixel, std::size_t limit,
                        const std::string& pointer) {
    if (list_.size() == limit) {
        if (!full_)
            reader_.say(Severity::error, pointer, "more channels than 8192 in a mode or 65536 in all");
        full_ = true;
        return;
    }
    if (!key.is_string() && !key.is_null())
        reader_.say(Severity::error, pointer,
                    "expected a channel's key, null or an insert of matrixChannels");
    list_.push_back(key.is_string() ? with_pixel(key.get_ref<const std::string&>(), pixel) : "");
    pointers_.push_back(pointer);
}

void OflModeMaker::insert_matrix(const Json& insert, std::size_t limit, const std::string& pointer) {
    const Json& templates = member(insert, "templateChannels");
    const std::vector<std::string> pixels =
        repeat_keys(reader_, member(insert, "repeatFor"), pointer + "/repeatFor");
    if (!templates.is_array() || pixels.empty()) {
        reader_.say(Severity::error, pointer, "an insert without templateChannels or pixels to repeat for");
        return;
    }
    const bool per_channel = text_at(insert, "channelOrder") == "perChannel";
    const std::size_t outer = per_channel ? templates.size() : pixels.size();
    const std::size_t inner = per_channel ? pixels.size() : templates.size();
    for (std::size_t i = 0; i < outer && !full_; ++i)
        for (std::size_t k = 0; k < inner && !full_; ++k) {
            const std::size_t which = per_channel ? i : k;
            push(templates[which], pixels[per_channel ? k : i], limit,
                 pointer + "/templateChannels/" + std::to_string(which));
        }
}

void OflModeMaker::list_keys(std::size_t limit) {
    const Json& channels = member(json_, "channels");
    if (!channels.is_array()) {
        reader_.say(Severity::error, pointer_, "the mode has no list of channels");
        return;
    }
    for (std::size_t i = 0; i < channels.size() && !full_; ++i) {
        const std::string pointer = pointer_ + "/channels/" + std::to_string(i);
        if (channels[i].is_object())
            insert_matrix(channels[i], limit, pointer);
        else
            push(channels[i], "", limit, pointer);
    }
}

void OflModeMaker::resolve() {
    places_.resize(list_.size());
    for (std::size_t place = 0; place < list_.size(); ++place) {
        if (list_[place].empty()) continue;
        places_[place].found = keys_.find(list_[place]);
        if (!places_[place].found.entry) {
            reader_.say(Severity::error, pointers_[place],
                        "there is no channel '" + list_[place].substr(0, 80) + "' in this file");
            continue;
        }
        place_of_.emplace(list_[place], place);
    }
}
// Bytes of a channel in this mode: its coarse place, then fine ones as far as they follow without a gap.
std::vector<int> OflModeMaker::offsets_of(const OflEntry& entry, const std::string& pixel,
                                          std::size_t coarse) const {
    std::vector<int> offsets{static_cast<int>(coarse)};
    const Json& fine = member(*entry.channel, "fineChannelAliases");
    for (std::size_t i = 0; fine.is_array() && i < fine.size() && i < 3; ++i) {
        if (!fine[i].is_string()) break;
        const auto found = place_of_.find(with_pixel(fine[i].get_ref<const std::string&>(), pixel));
        if (found == place_of_.end()) break;
        offsets.push_back(static_cast<int>(found->second));
    }
    return offsets;
}

std::uint32_t ofl_scaled(std::uint32_t value, int from_bytes, int to_bytes) {
    return from_bytes <= to_bytes ? value << (8 * (to_bytes - from_bytes))
                                  : value >> (8 * (from_bytes - to_bytes));
}

std::vector<ChannelFunction> ofl_fitted(const OflChannelSketch& sketch, int bytes) {
    std::vector<ChannelFunction> functions;
    for (ChannelFunction function : sketch.functions) {
        if (bytes >= sketch.bytes) {
            widen(function, sketch.bytes, bytes);
        } else {
            const int shift = 8 * (sketch.bytes - bytes);
            function.dmx_from >>= shift;
            function.dmx_to >>= shift;
            function.dmx_default >>= shift;
            for (ChannelSet& set : function.sets) {
                set.dmx_from >>= shift;
                set.dmx_to >>= shift;
            }
            // A border inside of a coarse step goes to the range that starts there.
            if (!functions.empty() && functions.back().dmx_to >= function.dmx_from) {
                if (functions.back().dmx_from >= function.dmx_from) continue;
                functions.back().dmx_to = function.dmx_from - 1;
                for (ChannelSet& set : functions.back().sets)
                    set.dmx_to = std::min(set.dmx_to, function.dmx_from - 1);
            }
        }
        functions.push_back(std::move(function));
    }
    return functions;
}

void OflModeMaker::set_numbers(std::vector<ChannelFunction>& functions) {
    for (ChannelFunction& function : functions) {
        const std::size_t at = function.attribute.find('#');
        if (at == std::string::npos) continue;
        const std::string prefix = function.attribute.substr(0, at);
        std::map<int, int>& numbers = numbers_[prefix];
        const auto [known, is_new] =
            numbers.try_emplace(function.wheel, static_cast<int>(numbers.size()) + 1);
        function.attribute.replace(at, 1, std::to_string(known->second));
        if (const std::size_t in_name = function.name.find('#');
            in_name != std::string::npos && function.name.starts_with(prefix + "#"))
            function.name.replace(in_name, 1, std::to_string(known->second));
        function.meaning = attribute_from(function.attribute);
    }
}

void OflModeMaker::make_channel(std::size_t place) {
    const OflKeys::Found& found = places_[place].found;
    if (!found.entry || found.entry->kind == OflEntry::Kind::switching) {
        if (found.entry) make_switched(place);
        return;
    }
    if (found.entry->kind == OflEntry::Kind::fine) {
        if (!place_of_.count(with_pixel(found.entry->key, found.pixel)) &&
            std::none_of(places_.begin(), places_.end(), [](const Place& other) {
                return other.found.entry && other.found.entry->kind == OflEntry::Kind::switching;
            }))
            reader_.say(Severity::error, pointers_[place],
                        "the fine channel '" + list_[place].substr(0, 80) +
                            "' has no coarse one in this mode");
        return;
    }
    if (place_of_.at(list_[place]) != place) {
        reader_.say(Severity::error, pointers_[place],
                    "the channel '" + list_[place].substr(0, 80) + "' a second time, the first counts");
        return;
    }
    const OflEntry& entry = *found.entry;
    ChannelDraft draft;
    draft.channel.name = name_of(entry, list_[place], found.pixel);
    draft.channel.offsets = offsets_of(entry, found.pixel, place);
    const int bytes = static_cast<int>(draft.channel.offsets.size());
    const OflChannelSketch& sketch = sketch_of(entry);
    draft.channel.max = dmx_max(bytes);
    functions_made_ += sketch.functions.size();
    if (functions_made_ <= kMaxBuiltFunctions)
        draft.channel.functions = ofl_fitted(sketch, bytes);
    else
        reader_.say(Severity::error, pointer_, "the mode has more than 65536 functions");
    draft.channel.initial = ofl_scaled(sketch.initial, sketch.bytes, bytes);
    set_numbers(draft.channel.functions);
    const ChannelFunction* shown = nullptr;
    for (const ChannelFunction& function : draft.channel.functions)
        if (!shown && is_shown(function)) shown = &function;
    draft.channel.logical.push_back({.attribute = shown ? shown->attribute : "NoFeature"});
    draft.cells = cells_of(found.pixel);
    has_gobos_ |= sketch.gobo;
    places_[place].draft = static_cast<int>(draft_.channels.size());
    if (sketch.preset) presets_.push_back(draft_.channels.size());
    names_.push_back(list_[place]);
    draft_.channels.push_back(std::move(draft));
}

const OflChannelSketch& OflModeMaker::sketch_of(const OflEntry& entry) {
    const auto [known, is_new] = sketches_.try_emplace(entry.pointer);
    if (is_new) {
        const auto elsewhere = [&](const std::set<const Json*>& channels) {
            return channels.size() > channels.count(entry.channel);
        };
        const OflStrobes strobes{elsewhere(strobe_rates_), elsewhere(strobe_kinds_)};
        known->second =
            sketch_ofl_channel(reader_, {*entry.channel, entry.key, entry.pointer}, physical_, strobes);
    }
    return known->second;
}

// A turning channel that names no wheel of its own number turns nothing; prisms without a wheel do.
void OflModeMaker::link_turns() {
    int prism = -1;
    for (const ChannelDraft& draft : draft_.channels)
        for (const ChannelFunction& function : draft.channel.functions)
            if (function.meaning.role == Role::prism || function.meaning.role == Role::prism_select_spin)
                prism = function.wheel;
    for (ChannelDraft& draft : draft_.channels)
        for (ChannelFunction& function : draft.channel.functions)
            if (function.wheel < 0 &&
                (function.meaning.role == Role::prism_index || function.meaning.role == Role::prism_rotate))
                function.wheel = prism;
}

void convert_ofl_modes(OflReader& reader) {
    const OflKeys keys(reader);
    TypeBuilder builder(reader.loaded.type);
    const Json& modes = member(reader.document, "modes");
    std::size_t room = kMaxAllChannels;
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const std::string pointer = "/modes/" + std::to_string(i);
        if (i == kMaxModes) {
            reader.say(Severity::error, pointer, "more than 512 modes");
            return;
        }
        if (!modes[i].is_object()) {
            reader.say(Severity::error, pointer, "expected a mode");
            continue;
        }
        room -= std::min(room, OflModeMaker(reader, builder, keys, modes[i], pointer).run(room));
    }
}

} // namespace ghost::fixture
