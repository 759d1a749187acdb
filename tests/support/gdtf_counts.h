#pragma once
// SPDX-License-Identifier: Apache-2.0
// What readings of a GDTF file are compared by, as their JSON has it.

#include "fixture/type.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace ghost::fixture {

inline nlohmann::json json_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return file ? nlohmann::json::parse(file) : nlohmann::json();
}

inline nlohmann::json footprint_of(const Mode& mode) {
    nlohmann::json footprint = nlohmann::json::object();
    for (std::size_t b = 0; b < mode.footprint.size(); ++b)
        if (mode.footprint[b] > 0) footprint[std::to_string(b + 1)] = mode.footprint[b];
    return footprint;
}

inline nlohmann::json bytes_used(const Mode& mode) {
    std::map<int, std::set<int>> used;
    for (const Channel& channel : mode.channels)
        for (const int offset : channel.offsets) used[channel.dmx_break].insert(offset);
    nlohmann::json result = nlohmann::json::object();
    for (const auto& [dmx_break, bytes] : used) result[std::to_string(dmx_break)] = bytes.size();
    return result;
}

// The other readings count Beam elements only.
inline std::size_t beams_of(const Type& type, const Mode& mode) {
    return static_cast<std::size_t>(std::count_if(mode.beams.begin(), mode.beams.end(), [&](int node) {
        const int index = mode.nodes[static_cast<std::size_t>(node)].geometry;
        const Geometry& geometry = type.geometries[static_cast<std::size_t>(index)];
        return geometry.kind == GeometryKind::beam && !geometry.beam->is_assumed;
    }));
}

inline std::size_t measurements_of(const Type& type) {
    std::size_t count = 0;
    for (const Emitter& emitter : type.emitters) count += emitter.measurements.size();
    for (const Filter& filter : type.filters) count += filter.measurements.size();
    return count;
}

} // namespace ghost::fixture
