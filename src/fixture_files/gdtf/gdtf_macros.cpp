// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/gdtf/private/gdtf_macros.h"

#include "fixture_files/gdtf/private/gdtf_channel.h"

#include <utility>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxMacros = 256; // per mode
constexpr std::size_t kMaxSteps = 4096; // per macro

} // namespace

void read_macros(GdtfReader& reader, pugi::xml_node list, const FindChannels& find_channels, bool say_missing,
                 Mode& mode) {
    for (const pugi::xml_node node : list.children("FTMacro")) {
        if (reader.is_full(node, mode.macros.size(), kMaxMacros, "macros in a mode")) return;
        Macro macro;
        macro.name = reader.text(node, "Name");
        bool all_known = true;
        for (const pugi::xml_node step_node : node.child("MacroDMX").children("MacroDMXStep")) {
            if (reader.is_full(step_node, macro.steps.size(), kMaxSteps, "steps in a macro")) break;
            Macro::Step step;
            step.duration_s = reader.number(step_node, "Duration", 1.0f, 0.0f, 1e6f);
            for (const pugi::xml_node value_node : step_node.children("MacroDMXValue")) {
                const std::string link = reader.text(value_node, "DMXChannel");
                const std::vector<int> channels = find_channels(link);
                if (channels.empty()) {
                    all_known = false;
                    if (say_missing)
                        reader.say(Severity::error, value_node,
                                   "the macro's channel '" + link + "' does not exist in this mode");
                }
                if (!reader.take_bytes(channels.size() * sizeof(Macro::Value))) break;
                for (const int channel : channels)
                    step.values.push_back(
                        {channel, dmx_value(reader, value_node, "Value",
                                            bytes_of(mode.channels[static_cast<std::size_t>(channel)]), 0)});
            }
            macro.steps.push_back(std::move(step));
        }
        if (all_known || say_missing) mode.macros.push_back(std::move(macro));
    }
}

} // namespace ghost::fixture
