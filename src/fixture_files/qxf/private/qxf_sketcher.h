#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_qxf: QxfSketcher makes functions of one byte of one channel. Its parts: what the channel is
// about (qxf_channel.cpp), what a range of values does (qxf_ranges.cpp), wheels and their slots
// (qxf_wheels.cpp).

#include "fixture_files/qxf/private/qxf_reader.h"

#include <algorithm>

namespace ghost::fixture {

struct SlotRequest { // what a capability asks for; second: half of one slot, half of another
    int first = -1;
    int second = -1;
};

class QxfSketcher {
public:
    QxfSketcher(QxfReader& reader, int index, const QxfPhysical& physical)
        : reader_(reader), index_(index), channel_(reader.channels[static_cast<std::size_t>(index)]),
          physical_(physical) {}

    Sketch run();

private:
    // A channel without capabilities is one range.
    std::vector<QxfCapability> capabilities() const {
        if (!channel_.capabilities.empty()) return channel_.capabilities;
        QxfCapability whole;
        whole.high = 255;
        whole.line = channel_.line;
        return {whole};
    }
    bool single() const { return channel_.capabilities.size() <= 1; }
    void find_subject();
    bool names_gobos() const;
    bool any_capability(std::initializer_list<const char*> words) const {
        return std::any_of(
            channel_.capabilities.begin(), channel_.capabilities.end(),
            [&](const QxfCapability& capability) { return has_word(capability.words, words); });
    }
    bool any_preset(std::initializer_list<std::string_view> names) const {
        return std::any_of(channel_.capabilities.begin(), channel_.capabilities.end(),
                           [&](const QxfCapability& capability) {
                               return std::find(names.begin(), names.end(), capability.preset) != names.end();
                           });
    }
    void add(ChannelFunction function) { sketch_.functions.push_back(std::move(function)); }
    void add(const QxfCapability& capability, const std::string& attribute, Range range) {
        ChannelFunction function =
            make_function(attribute, capability.low, capability.high, range.from, range.to);
        if (!capability.name.empty()) function.name = capability.name;
        add(std::move(function));
    }
    void ignore(const QxfCapability& capability) { add(capability, "NoFeature", {0, 1}); }
    // A picture would show it, but what it does is not in the file.
    void miss(const QxfCapability& capability) {
        ignore(capability);
        if (!has_word(capability.words,
                      {"reset", "lamp", "no function", "no effect", "not used", "unused", "reserved"}))
            missed_.push_back(capability.name.empty() ? channel_.name : capability.name);
    }
    bool is_service(const QxfCapability& capability);
    void convert(const QxfCapability& capability);
    // The part of the channel's whole way that a capability covers.
    Range part(const QxfCapability& capability, Range whole) const {
        const auto at = [&](std::uint32_t raw) {
            return whole.from + (whole.to - whole.from) * static_cast<float>(raw) / 255.0f;
        };
        return {at(capability.low), at(capability.high)};
    }
    void convert_fixed(const QxfCapability& capability);
    void convert_dimmer(const QxfCapability& capability);
    static bool is_strobe(const QxfCapability& capability);
    void add_strobe(const QxfCapability& capability, const std::string& attribute);
    void convert_shutter(const QxfCapability& capability);
    void convert_temperature(const QxfCapability& capability);
    void convert_turn(const QxfCapability& capability, const std::string& index, const std::string& rotate,
                      float sign, float slow, float fast);
    void convert_graded(const QxfCapability& capability, const std::string& attribute, float low, float high);
    void convert_zoom(const QxfCapability& capability);
    void convert_frost(const QxfCapability& capability);
    void convert_time(const QxfCapability& capability);
    int slot_of(Wheel& wheel, const std::string& slot_name, const ColorCie& color, const std::string& media);
    static std::string slot_name(const QxfCapability& capability);
    SlotRequest request_colour(Wheel& wheel, const QxfCapability& capability);
    SlotRequest request_gobo(Wheel& wheel, const QxfCapability& capability);
    SlotRequest request_prism(Wheel& wheel, const QxfCapability& capability);
    bool wheel_turns(const QxfCapability& capability) const;
    static bool shuts(const QxfCapability& capability);
    static float between(Wheel& wheel, SlotRequest request);
    void make_wheel();
    void add_slot(const QxfCapability& capability, const std::string& attribute, int slot);
    void fill_gaps();
    void list_losses();

    QxfReader& reader_;
    int index_;
    const QxfChannel& channel_;
    const QxfPhysical& physical_;
    const ChannelPreset* preset_ = nullptr;
    Sketch sketch_;
    std::vector<std::string> missed_;
    bool guessed_rate_ = false;
    bool guessed_colour_ = false;
};

} // namespace ghost::fixture
