#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_ofl: OflSketcher makes functions of one channel, in the channel's own resolution. Its
// parts: the channel as a whole (ofl_channel.cpp), what a range of values does (ofl_ranges.cpp), slots of
// wheels, prisms and preset colours (ofl_slots.cpp).

#include "fixture_files/ofl/private/ofl_reader.h"

namespace ghost::fixture {

// What "slow" and "fast", or nothing at all, mean for each thing.
inline constexpr EntityScale kTurn{kSlowTurn_deg_s, kFastTurn_deg_s};
inline constexpr EntityScale kWheelTurn{kSlowWheel_deg_s, kFastWheel_deg_s};
inline constexpr EntityScale kAxisTurn{kSlowAxis_deg_s, kFastAxis_deg_s};
inline constexpr EntityScale kStrobe{kSlowStrobe_Hz, kFastStrobe_Hz};
inline constexpr EntityScale kShake{1.0f, 5.0f};
inline constexpr EntityScale kCircle{0.0f, 360.0f};
inline constexpr EntityScale kSeconds{0.0f, kSlowMove_s};
inline constexpr EntityScale kOne{};

class OflSketcher {
public:
    OflSketcher(OflReader& reader, const OflChannel& channel, const OflPhysical& physical,
                const OflStrobes& strobes);

    OflChannelSketch run();

private:
    void read_resolution();
    void read(const Json& capability, const std::string& pointer, bool whole);
    void convert(const std::string& type);
    void convert_generic();
    void centre_axes();
    void fill_gaps();
    void read_default();
    void list_losses();

    std::string comment() const { return text_at(*capability_, "comment"); }
    std::optional<OflRange> range(const char* key, Quantity quantity, const EntityScale& scale) {
        return entity_range(reader_, *capability_, here_, key, quantity, scale);
    }
    ChannelFunction& add(const std::string& attribute, OflRange physical);
    void ignore() { add("NoFeature", {0, 1}); }
    void miss(const std::string& type); // a picture would show it, but what it does is not in the file
    // Nothing stated: the whole way.
    void add_graded(const char* key, const std::string& attribute, Quantity quantity,
                    const EntityScale& scale, OflRange otherwise) {
        add(attribute, range(key, quantity, scale).value_or(otherwise));
    }

    std::string fog_attribute() const;
    std::string blade() const;
    void convert_brightness(const std::string& attribute, const char* key = "brightness");
    void convert_colour();
    void convert_shutter();
    void convert_strobe_speed();
    void convert_axis(const std::string& type);
    void convert_move();
    void convert_turn(const std::string& index, const std::string& rotate, const EntityScale& scale,
                      float sign);

    const OflWheel* find_wheel();
    Wheel& wheel_at(int index) { return reader_.loaded.type.wheels[static_cast<std::size_t>(index)]; }
    void convert_wheels(const std::string& type);
    std::optional<OflRange> slots_of(const OflWheel& wheel);
    ChannelFunction& add_slot(const OflWheel& wheel, const std::string& attribute, float place,
                              OflRange physical);
    bool add_stop(const OflWheel& wheel, float place);
    void convert_slot(const OflWheel& wheel);
    void convert_shake(const OflWheel& wheel);
    void convert_slot_rotation(const OflWheel& wheel);
    void convert_prism();
    void convert_preset();
    void add_preset(const std::string& name, const ColorCie& color);

    OflReader& reader_;
    const Json& channel_;
    const std::string& key_;
    const std::string& pointer_;
    const OflPhysical& physical_;
    const OflStrobes& strobes_;
    float lamp_k_ = 6000.0f;
    float narrow_ = 8.0f;
    float wide_ = 40.0f;
    OflChannelSketch sketch_;
    std::uint32_t max_ = 255;
    std::uint32_t low_ = 0;
    std::uint32_t high_ = 255;
    std::uint32_t last_high_ = 0;
    OflWheel virtual_wheel_;
    const Json* capability_ = nullptr;
    std::string here_;
    std::vector<std::string> missed_;
};

} // namespace ghost::fixture
