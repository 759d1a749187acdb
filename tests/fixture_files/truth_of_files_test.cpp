// SPDX-License-Identifier: Apache-2.0
// What must hold of any fixture, asked of the 77 GDTF files of other makers: no value jumps but where a set
// says so; what a channel points, it points while the others rest; a lamp at rest is white; a preset of a
// lamp that mixes its colours shines.
#include "fixture/curves.h"
#include "fixture/decode.h"
#include "fixture/programmer.h"
#include "fixture/slot_meanings.h"
#include "fixture/sweep.h"
#include "fixture_files/gdtf/gdtf.h"
#include "fixture_files/load_type.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ghost::fixture {
namespace {

const std::filesystem::path kFiles = std::filesystem::path(GHOST_SOURCE_DIR) / "../shared/fixtures/gdtf";

#define SKIP_WITHOUT_FILES()                                                                                 \
    if (!std::filesystem::exists(kFiles)) GTEST_SKIP() << "no ../shared/fixtures beside the checkout"

struct Driven {
    const std::string& file;
    const Type& type;
    const Mode& mode;
    Patch patch;
    std::vector<std::uint8_t> rest; // all channels where their file has them

    std::string name() const { return file + " '" + mode.name + "' "; }

    void put(const Channel& channel, std::uint32_t raw, std::vector<std::uint8_t>& levels) const {
        std::size_t begin = 0;
        for (int k = 1; k < channel.dmx_break; ++k)
            begin += static_cast<std::size_t>(mode.footprint.at(static_cast<std::size_t>(k - 1)));
        for (std::size_t i = channel.offsets.size(); i-- > 0; raw >>= 8)
            levels.at(begin + static_cast<std::size_t>(channel.offsets[i])) =
                static_cast<std::uint8_t>(raw & 255u);
    }
    Targets at(const std::vector<std::uint8_t>& levels) const { return decode_levels(patch, levels); }
};

struct File {
    std::string name;
    Type type;
};

const std::vector<File>& files() {
    static const std::vector<File> all = [] {
        std::vector<File> loaded;
        for (const auto& entry : std::filesystem::directory_iterator(kFiles))
            if (Result<LoadedType> one = load_gdtf(entry.path()))
                loaded.push_back({entry.path().filename().string(), std::move(one->type)});
        return loaded;
    }();
    return all;
}

void each_mode_of(const File& file, const std::function<void(const Driven&)>& use) {
    for (std::size_t m = 0; m < file.type.modes.size(); ++m) {
        const Mode& mode = file.type.modes[m];
        Driven driven{file.name,
                      file.type,
                      mode,
                      {.name = file.name, .type = &file.type, .mode = static_cast<int>(m), .addresses = {}},
                      {}};
        int channel = 1;
        for (const int bytes : mode.footprint) {
            driven.patch.addresses.push_back({1 + (channel - 1) / 512, 1 + (channel - 1) % 512});
            channel += bytes;
        }
        driven.rest.assign(level_count(mode), 0);
        for (const Channel& one : mode.channels) driven.put(one, one.initial, driven.rest);
        use(driven);
    }
}

void for_each_mode(const std::function<void(const Driven&)>& use) {
    for (const File& file : files()) each_mode_of(file, use);
}

// Whether a second channel moves the same part of the same beams.
bool has_rival(const Mode& mode, const Channel& channel, const ChannelFunction& function, bool (*is)(Role)) {
    return std::any_of(mode.channels.begin(), mode.channels.end(), [&](const Channel& other) {
        return &other != &channel && other.beams == channel.beams &&
               std::any_of(other.functions.begin(), other.functions.end(), [&](const ChannelFunction& rival) {
                   return is(rival.meaning.role) && rival.meaning.number == function.meaning.number;
               });
    });
}

// Of one kind each: a list of hundreds says no more than its first lines.
class Findings {
public:
    void add(const std::string& text) { found_.insert(text); }
    std::string text() const {
        std::string all;
        std::size_t count = 0;
        for (const std::string& line : found_)
            if (++count <= 60) all += "  " + line + "\n";
        return all + (count > 60 ? "  and " + std::to_string(count - 60) + " more\n" : "");
    }

private:
    std::set<std::string> found_;
};

bool is_even(Role role) {
    switch (role) {
    case Role::dimmer:
    case Role::pan:
    case Role::tilt:
    case Role::color_add:
    case Role::color_sub_c:
    case Role::color_sub_m:
    case Role::color_sub_y:
    case Role::iris:
    case Role::zoom:
    case Role::focus:
    case Role::frost:
    case Role::cct:
    case Role::strobe:
    case Role::strobe_random:
    case Role::strobe_pulse:
    case Role::strobe_effect:
        return true;
    default:
        return false;
    }
}

// "Closed" at 180 of 65535, where 180 of 255 is meant.
bool contradicts_itself(const std::string& file, const std::string& attribute) {
    return file == "ogl_Robe@Robin_DL7S_Profile.gdtf" && attribute == "Iris";
}

TEST(truth_of_files, no_value_jumps_but_where_a_stated_set_begins) {
    SKIP_WITHOUT_FILES();
    constexpr double kJump = 0.1; // of the range
    Findings findings;
    int functions = 0;
    for_each_mode([&](const Driven& driven) {
        for (const Channel& channel : driven.mode.channels)
            for (const ChannelFunction& function : channel.functions) {
                if (!is_even(function.meaning.role) || function.sets.empty() || function.dmx_profile >= 0)
                    continue;
                ++functions;
                double low = static_cast<double>(std::min(function.physical_from, function.physical_to));
                double high = static_cast<double>(std::max(function.physical_from, function.physical_to));
                for (const ChannelSet& set : function.sets)
                    for (const float end : {set.physical_from, set.physical_to}) {
                        low = std::min(low, static_cast<double>(end));
                        high = std::max(high, static_cast<double>(end));
                    }
                for (std::size_t k = 1; k < function.sets.size(); ++k) {
                    const ChannelSet& before = function.sets[k - 1];
                    const ChannelSet& set = function.sets[k];
                    if (set.is_stated || set.slot >= 0 || before.slot >= 0) continue;
                    const double jump =
                        std::abs(static_cast<double>(physical_at(driven.type, function, set.dmx_from) -
                                                     physical_at(driven.type, function, before.dmx_to)));
                    const double values = static_cast<double>(function.dmx_to) - function.dmx_from;
                    if (jump > std::max(kJump, 1.01 / std::max(values, 1.0)) * (high - low) &&
                        !contradicts_itself(driven.file, function.attribute))
                        findings.add(driven.file + " " + function.attribute + " '" + before.name + "' | '" +
                                     set.name + "' at " + std::to_string(set.dmx_from) + ": " +
                                     std::to_string(before.physical_to) + " | " +
                                     std::to_string(set.physical_from));
                }
            }
    });
    EXPECT_GT(functions, 500);
    EXPECT_EQ(findings.text(), "");
}

TEST(truth_of_files, a_wheel_that_stands_beside_its_slots_stands_half_way) {
    SKIP_WITHOUT_FILES();
    Findings findings;
    int wheels = 0;
    for_each_mode([&](const Driven& driven) {
        for (const Channel& channel : driven.mode.channels)
            for (const ChannelFunction& function : channel.functions) {
                if (!function.is_beside_slots || channel.beams.empty() || function.master_channel >= 0)
                    continue;
                const bool is_color = function.meaning.role == Role::color_wheel;
                if (!is_color && function.meaning.role != Role::gobo_wheel) continue;
                float most = 0.0f;
                bool mixes = false;
                for (std::uint64_t step = 0; step <= 512; ++step) {
                    const auto raw = static_cast<std::uint32_t>(
                        function.dmx_from + step * (function.dmx_to - function.dmx_from) / 512);
                    std::vector<std::uint8_t> levels = driven.rest;
                    driven.put(channel, raw, levels);
                    const Optics optics =
                        driven.at(levels).beams.at(static_cast<std::size_t>(channel.beams.front()));
                    mixes = mixes || !optics.emitters.empty();
                    for (const WheelState& wheel : is_color ? optics.color_wheels : optics.gobo_wheels)
                        if (wheel.number == function.meaning.number) {
                            const float beside = wheel.position - std::floor(wheel.position);
                            most = std::max(most, std::min(beside, 1.0f - beside));
                        }
                }
                if (mixes) continue;
                ++wheels;
                if (most < 0.3f)
                    findings.add(driven.name() + function.attribute + " " + std::to_string(most));
            }
    });
    EXPECT_GT(wheels, 10);
    EXPECT_EQ(findings.text(), "");
}

TEST(truth_of_files, what_points_moves_while_all_else_rests) {
    SKIP_WITHOUT_FILES();
    Findings findings;
    int pointed = 0;
    for_each_mode([&](const Driven& driven) {
        for (const Channel& channel : driven.mode.channels) {
            if (channel.offsets.empty()) continue;
            for (const ChannelFunction& function : channel.functions) {
                const Role role = function.meaning.role;
                const bool is_axis = role == Role::pan || role == Role::tilt;
                const bool is_picture = role == Role::gobo_index || role == Role::prism_index;
                if ((!is_axis && (!is_picture || channel.beams.empty())) ||
                    function.physical_from == function.physical_to || function.dmx_from >= function.dmx_to)
                    continue;
                std::vector<std::uint8_t> levels = driven.rest;
                if (function.master_channel >= 0) {
                    const Channel& master =
                        driven.mode.channels.at(static_cast<std::size_t>(function.master_channel));
                    if (master.offsets.empty()) continue;
                    driven.put(master, function.master_from + (function.master_to - function.master_from) / 2,
                               levels);
                }
                const auto value = [&](std::uint32_t raw) {
                    driven.put(channel, raw, levels);
                    const Targets targets = driven.at(levels);
                    if (is_axis) {
                        for (std::size_t a = 0; a < driven.mode.axes.size(); ++a)
                            if (driven.mode.axes[a].node == channel.node &&
                                driven.mode.axes[a].pan == (role == Role::pan))
                                return targets.axes[a].spinning ? 0.0f : targets.axes[a].deg;
                        return 0.0f;
                    }
                    const Optics& optics = targets.beams.at(static_cast<std::size_t>(channel.beams.front()));
                    if (role == Role::gobo_index) {
                        for (const WheelState& wheel : optics.gobo_wheels)
                            if (wheel.number == function.meaning.number)
                                return wheel.rotating ? 0.0f : wheel.gobo_deg;
                        return 1000.0f; // no wheel to turn
                    }
                    for (const Insert& prism : optics.prisms)
                        if (prism.number == function.meaning.number) return prism.rotating ? 0.0f : prism.deg;
                    return 1000.0f;
                };
                const auto is_index = [](Role other) {
                    return other == Role::gobo_index || other == Role::prism_index;
                };
                if (is_picture && has_rival(driven.mode, channel, function, is_index)) continue;
                const std::uint32_t span = function.dmx_to - function.dmx_from;
                if (physical_at(driven.type, function, function.dmx_from + span / 5) ==
                    physical_at(driven.type, function, function.dmx_from + span / 5 * 2))
                    continue;
                const float a = value(function.dmx_from + span / 5),
                            b = value(function.dmx_from + span / 5 * 2);
                if (a == 1000.0f) continue;
                ++pointed;
                if (a == b) findings.add(driven.name() + channel.name + " " + function.name);
            }
        }
    });
    EXPECT_GT(pointed, 200);
    EXPECT_EQ(findings.text(), "");
}

// Of QLC+'s own definitions, where they are installed (qlcplus-data).
TEST(truth_of_files, heads_of_qlc_follow_their_pan_while_all_else_rests) {
    const std::filesystem::path installed = "/usr/share/qlcplus/fixtures";
    if (!std::filesystem::exists(installed))
        GTEST_SKIP() << "QLC+ definitions are not installed (qlcplus-data)";
    Findings findings;
    int heads = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(installed)) {
        if (entry.path().extension() != ".qxf") continue;
        Result<LoadedType> loaded = load_type(entry.path());
        ASSERT_TRUE(loaded) << entry.path();
        const File file{entry.path().filename().string(), std::move(loaded->type)};
        each_mode_of(file, [&](const Driven& driven) {
            for (const Channel& channel : driven.mode.channels) {
                if (channel.functions.size() != 1 || channel.functions[0].meaning.role != Role::pan) continue;
                const auto pan = [&](std::uint32_t raw) {
                    std::vector<std::uint8_t> levels = driven.rest;
                    driven.put(channel, raw, levels);
                    const Targets targets = driven.at(levels);
                    for (std::size_t a = 0; a < driven.mode.axes.size(); ++a)
                        if (driven.mode.axes[a].node == channel.node && driven.mode.axes[a].pan)
                            return targets.axes[a].spinning ? 0.0f : targets.axes[a].deg;
                    return 0.0f;
                };
                ++heads;
                if (pan(0) == pan(channel.max)) findings.add(driven.name() + channel.name);
            }
        });
    }
    EXPECT_GT(heads, 500);
    EXPECT_EQ(findings.text(), "");
}

TEST(truth_of_files, no_filter_that_nobody_chose_is_in_the_light) {
    SKIP_WITHOUT_FILES();
    Findings findings;
    int wheels = 0;
    for_each_mode([&](const Driven& driven) {
        const std::vector<std::uint8_t> zeros(driven.rest.size());
        for (const bool at_rest : {true, false}) {
            const Targets targets = driven.at(at_rest ? driven.rest : zeros);
            std::vector<std::set<int>> chosen(targets.beams.size());
            for (const Channel& channel : driven.mode.channels)
                for (const ChannelFunction& function : channel.functions)
                    for (const ChannelSet& set : function.sets) {
                        const std::uint32_t raw = at_rest || channel.offsets.empty() ? channel.initial : 0;
                        if (set.slot >= 0 && raw >= set.dmx_from && raw <= set.dmx_to &&
                            is_color_wheel(function.meaning.role))
                            for (const int beam : channel.beams)
                                chosen.at(static_cast<std::size_t>(beam)).insert(set.slot);
                    }
            for (std::size_t b = 0; b < targets.beams.size(); ++b)
                for (const WheelState& wheel : targets.beams[b].color_wheels) {
                    ++wheels;
                    if (!wheel.in || wheel.spinning) continue;
                    const Wheel& of = driven.type.wheels.at(static_cast<std::size_t>(wheel.wheel));
                    const int slot = static_cast<int>(wheel.position);
                    if (slot != open_slot(driven.type, of) && !chosen[b].contains(slot))
                        findings.add(driven.name() + of.name + " stands at '" +
                                     of.slots.at(static_cast<std::size_t>(slot)).name + "'");
                }
        }
    });
    EXPECT_GT(wheels, 50);
    EXPECT_EQ(findings.text(), "");
}

std::uint32_t darkest(const Type& type, const Channel& channel) {
    const ChannelFunction& first = channel.functions.front();
    return physical_at(type, first, 0) <= physical_at(type, first, channel.max) ? 0 : channel.max;
}

TEST(truth_of_files, each_preset_of_a_lamp_that_mixes_gives_light) {
    SKIP_WITHOUT_FILES();
    Findings findings;
    int presets = 0;
    for_each_mode([&](const Driven& driven) {
        const std::vector<std::uint8_t> open = sweep_of(driven.patch, 2).rest;
        std::vector<std::uint8_t> dark = open;
        for (const Channel& channel : driven.mode.channels)
            if (!channel.offsets.empty() && !channel.functions.empty() &&
                channel.functions.front().meaning.role == Role::color_add)
                driven.put(channel, darkest(driven.type, channel), dark);
        for (const Channel& channel : driven.mode.channels)
            for (const ChannelFunction& function : channel.functions) {
                if (channel.offsets.empty() || channel.beams.empty() || function.wheel < 0 ||
                    function.meaning.role != Role::color_wheel || function.master_channel >= 0 ||
                    has_rival(driven.mode, channel, function, is_color_wheel))
                    continue;
                const auto beam = static_cast<std::size_t>(channel.beams.front());
                if (driven.at(open).beams.at(beam).emitters.empty()) continue;
                const std::vector<Slot>& slots =
                    driven.type.wheels.at(static_cast<std::size_t>(function.wheel)).slots;
                for (const ChannelSet& set : function.sets) {
                    if (set.slot < 0) continue;
                    const Slot& slot = slots.at(static_cast<std::size_t>(set.slot));
                    if (is_named_open(slot) || (set.slot == 0 && is_open_slot(driven.type, slot))) continue;
                    ++presets;
                    std::vector<std::uint8_t> levels = dark;
                    driven.put(channel, set.dmx_from, levels);
                    const Optics optics = driven.at(levels).beams.at(beam);
                    if (!optics.has_mix || optics.mix.Y <= 0.0f)
                        findings.add(driven.name() + function.attribute + " '" + set.name + "'");
                }
            }
    });
    EXPECT_GT(presets, 20);
    EXPECT_EQ(findings.text(), "");
}

#undef SKIP_WITHOUT_FILES

} // namespace
} // namespace ghost::fixture
