#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests: zip archives (stored) and small GDTF files made in memory.

#include "disk/crc32.h"
#include "fixture_files/gdtf/gdtf.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace ghost::fixture {

inline std::uint32_t crc_of(const std::string& data) {
    return crc32(Bytes(reinterpret_cast<const std::uint8_t*>(data.data()), data.size()));
}

inline void put(std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

inline std::vector<std::uint8_t> make_zip(const std::vector<std::pair<std::string, std::string>>& files,
                                          std::uint32_t method = 0) {
    std::vector<std::uint8_t> out;
    std::vector<std::uint8_t> directory;
    for (const auto& [name, data] : files) {
        const auto offset = static_cast<std::uint32_t>(out.size());
        const auto size = static_cast<std::uint32_t>(data.size());
        std::vector<std::uint8_t> common;
        put(common, 20, 2); // version, flags, method, time, date, crc, sizes, name length, extra length
        put(common, 0, 2);
        put(common, method, 2);
        put(common, 0, 2);
        put(common, 0x21, 2);
        put(common, crc_of(data), 4);
        put(common, size, 4);
        put(common, size, 4);
        put(common, static_cast<std::uint32_t>(name.size()), 2);
        put(common, 0, 2);
        put(out, 0x04034b50, 4);
        out.insert(out.end(), common.begin(), common.end());
        out.insert(out.end(), name.begin(), name.end());
        out.insert(out.end(), data.begin(), data.end());
        put(directory, 0x02014b50, 4);
        put(directory, 20, 2);
        directory.insert(directory.end(), common.begin(), common.end());
        put(directory, 0, 2);
        put(directory, 0, 2);
        put(directory, 0, 2);
        put(directory, 0, 4);
        put(directory, offset, 4);
        directory.insert(directory.end(), name.begin(), name.end());
    }
    const auto start = static_cast<std::uint32_t>(out.size());
    out.insert(out.end(), directory.begin(), directory.end());
    put(out, 0x06054b50, 4);
    put(out, 0, 4);
    put(out, static_cast<std::uint32_t>(files.size()), 2);
    put(out, static_cast<std::uint32_t>(files.size()), 2);
    put(out, static_cast<std::uint32_t>(directory.size()), 4);
    put(out, start, 4);
    put(out, 0, 2);
    return out;
}

// The parts of a description.xml; each has a working default.
struct Description {
    std::string attributes; // inside of AttributeDefinitions
    std::string physical;   // inside of PhysicalDescriptions
    std::string wheels;
    std::string models;
    std::string geometries = R"(<Geometry Name="Base"><Beam Name="Beam"/></Geometry>)";
    std::string channels = R"(<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Dimmer">
        <ChannelFunction Name="Dimmer" Attribute="Dimmer"/></LogicalChannel></DMXChannel>)";
    std::string mode_geometry = R"(Geometry="Base")";
    std::string mode_end; // after DMXChannels: Relations, FTMacros
    std::string end;      // after DMXModes: Revisions, FTPresets, Protocols

    std::string xml() const {
        return R"(<?xml version="1.0"?>
<GDTF DataVersion="1.2"><FixtureType Name="Tiny" Manufacturer="Test">)" +
               (attributes.empty() ? "" : "<AttributeDefinitions>" + attributes + "</AttributeDefinitions>") +
               (physical.empty() ? "" : "<PhysicalDescriptions>" + physical + "</PhysicalDescriptions>") +
               "\n<Wheels>" + wheels + "</Wheels><Models>" + models + "</Models><Geometries>" + geometries +
               "</Geometries>\n<DMXModes><DMXMode Name=\"Standard\" " + mode_geometry + "><DMXChannels>\n" +
               channels + "\n</DMXChannels>" + mode_end + "</DMXMode></DMXModes>" + end +
               "</FixtureType></GDTF>";
    }
};

inline Result<LoadedType> load_xml(const std::string& xml) {
    const std::vector<std::uint8_t> zip = make_zip({{"description.xml", xml}});
    return load_gdtf(zip, "tiny.gdtf");
}

inline LoadedType loaded(const Description& description) {
    Result<LoadedType> result = load_xml(description.xml());
    EXPECT_TRUE(result) << result.error().text();
    return result ? std::move(result).value() : LoadedType{};
}

inline std::vector<std::uint8_t> file_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Whether a message holds all of the words.
inline bool says(const LoadedType& loaded, const std::vector<std::string>& words) {
    for (const Message& message : loaded.messages) {
        const std::string text = message.where + ": " + message.what;
        bool all = true;
        for (const std::string& word : words) all = all && text.find(word) != std::string::npos;
        if (all) return true;
    }
    return false;
}

} // namespace ghost::fixture
