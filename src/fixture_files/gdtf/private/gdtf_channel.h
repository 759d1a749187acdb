#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_gdtf: one DMXChannel element, before it is placed at its geometries.

#include "fixture_files/gdtf/private/gdtf_reader.h"

#include <string>
#include <vector>

namespace ghost::fixture {

struct ModeMaster {
    std::string link; // empty: none
    pugi::xml_node node;
};

struct ChannelTemplate {
    Channel channel; // node, name and masters still open
    std::string geometry;
    bool overwrite = false;          // DMXBreak="Overwrite"
    std::vector<ModeMaster> masters; // per Channel::functions
    pugi::xml_node node;
};

int bytes_of(const Channel& channel); // 1..4; a virtual channel counts as 4, as files write its values
// Once all sets of a function are read: what those have that leave it open.
void settle_sets(ChannelFunction& function);

ChannelTemplate read_channel(GdtfReader& reader, pugi::xml_node node);
std::uint32_t dmx_value(GdtfReader& reader, pugi::xml_node node, const char* attribute, int bytes,
                        std::uint32_t fallback);

} // namespace ghost::fixture
