#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests: a GDTF file of one beam by its channels, their functions and sets.

#include "fixture/decode.h"
#include "fixture/programmer.h"
#include "support/tiny_gdtf.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ghost::fixture::tiny {

inline std::string channel(int offset, const std::string& functions) {
    return "<DMXChannel Offset=\"" + std::to_string(offset) +
           "\" Geometry=\"Beam\"><LogicalChannel Attribute=\"X\">" + functions +
           "</LogicalChannel></DMXChannel>";
}

inline std::string function(const std::string& attribute, const std::string& more, const std::string& sets) {
    return "<ChannelFunction Name=\"" + attribute + "\" Attribute=\"" + attribute + "\" " + more + ">" +
           sets + "</ChannelFunction>";
}

inline std::string set(int from, const std::string& name, int slot = 0, const std::string& more = "") {
    return "<ChannelSet DMXFrom=\"" + std::to_string(from) + "/1\" Name=\"" + name + "\" WheelSlotIndex=\"" +
           std::to_string(slot) + "\" " + more + "/>";
}

inline std::string physical(float value) {
    const std::string text = std::to_string(value);
    return "PhysicalFrom=\"" + text + "\" PhysicalTo=\"" + text + "\"";
}

struct Tiny {
    LoadedType loaded;
    Patch patch;
    explicit Tiny(const std::string& channels, const std::string& wheels = "")
        : loaded([&] {
              Description description;
              description.channels = channels;
              description.wheels = wheels;
              return std::move(load_xml(description.xml()).value());
          }()) {
        patch = {.name = "tiny", .type = &loaded.type, .mode = 0, .addresses = {{1, 1}}};
    }
    Tiny(const Tiny&) = delete;
    Tiny& operator=(const Tiny&) = delete;
    Targets targets(std::vector<std::uint8_t> levels) const { return decode_levels(patch, levels); }
    Optics at(std::vector<std::uint8_t> levels) const { return targets(std::move(levels)).beams.at(0); }
};

} // namespace ghost::fixture::tiny
