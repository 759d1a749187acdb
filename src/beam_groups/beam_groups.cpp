// SPDX-License-Identifier: Apache-2.0
#include "beam_groups/beam_groups.h"

#include "base/text.h"
#include "beam_groups/prism.h"
#include "fixture/laser_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>

#include <glm/glm.hpp>

namespace ghost::scene {
namespace {

using fixture::Role;
using glm::vec3;

constexpr float kSamePlace_m = 0.001f;
constexpr float kLeastAngle_deg = 0.1f; // as photometry.h
constexpr float kMostAngle_deg = 170.0f;

// What the cells of one light must have in common: the channels of these.
bool shapes_beam(Role role) {
    switch (role) {
    case Role::zoom:
    case Role::focus:
    case Role::iris:
    case Role::iris_strobe:
    case Role::iris_pulse:
    case Role::frost:
        return true;
    default:
        return false;
    }
}

// Makes a picture of its own: such a beam is a light of its own.
bool makes_picture(Role role) {
    return (role >= Role::gobo_wheel && role <= Role::gobo_rotate) ||
           (role >= Role::gobo_wheel_random && role <= Role::shaper_macro) ||
           (role >= Role::laser_figure && role <= Role::laser_running);
}

struct Cell {
    int beam = 0;
    vec3 lens_m{0.0f};
    vec3 axis{0, 0, -1};
    vec3 anchor_m{0.0f}; // what stays when heads turn
    int joint = -1;      // node that turns next to it
    float lumens = 0.0f;
    float narrowest = 0.0f;   // half the beam angle at the narrowest zoom, radians
    std::vector<int> shaping; // Mode::channels
    bool has_picture = false;
};

std::vector<glm::mat4> rest_matrices(const fixture::Mode& mode) {
    std::vector<glm::mat4> matrices;
    for (const fixture::Node& node : mode.nodes)
        matrices.push_back(node.parent < 0 ? node.local
                                           : matrices[static_cast<std::size_t>(node.parent)] * node.local);
    return matrices;
}

class Reader {
public:
    Reader(const fixture::Type& type, const fixture::Mode& mode)
        : type_(type), mode_(mode), matrices_(rest_matrices(mode)), cells_(mode.beams.size()) {
        for (std::size_t c = 0; c < mode.channels.size(); ++c) read(mode.channels[c], static_cast<int>(c));
    }

    Cell cell(int beam) const {
        const auto node = static_cast<std::size_t>(mode_.beams[static_cast<std::size_t>(beam)]);
        const fixture::Beam& light = source(beam);
        Cell cell = cells_[static_cast<std::size_t>(beam)];
        cell.beam = beam;
        cell.lens_m = vec3(matrices_[node][3]);
        cell.axis = -glm::normalize(vec3(matrices_[node][2]));
        cell.lumens = light.luminous_flux_lm;
        cell.has_picture = cell.has_picture || light.beam_type == fixture::BeamType::area;
        // So far the field at the narrowest zoom, in degrees.
        const float field_deg = cell.narrowest > 0.0f ? cell.narrowest : light.field_angle_deg;
        cell.narrowest =
            0.5f *
            glm::radians(std::clamp(field_deg * light.beam_angle_deg / std::max(light.field_angle_deg, 0.01f),
                                    kLeastAngle_deg, kMostAngle_deg));
        anchor(cell);
        return cell;
    }
    const fixture::Beam& source(int beam) const {
        const fixture::Node& node =
            mode_.nodes[static_cast<std::size_t>(mode_.beams[static_cast<std::size_t>(beam)])];
        return *type_.geometries[static_cast<std::size_t>(node.geometry)].beam;
    }

private:
    void read(const fixture::Channel& channel, int index) {
        bool shapes = false;
        bool has_picture = false;
        float least_deg = 0.0f;
        for (const fixture::ChannelFunction& function : channel.functions) {
            shapes = shapes || shapes_beam(function.meaning.role);
            has_picture = has_picture || makes_picture(function.meaning.role);
            if (function.meaning.role != Role::zoom) continue;
            const float field_deg = std::min(function.physical_from, function.physical_to);
            least_deg = least_deg > 0.0f ? std::min(least_deg, field_deg) : field_deg;
        }
        for (const int beam : channel.beams) {
            Cell& cell = cells_[static_cast<std::size_t>(beam)];
            if (shapes) cell.shaping.push_back(index);
            cell.has_picture = cell.has_picture || has_picture;
            if (!(least_deg > 0.0f)) continue;
            cell.narrowest = cell.narrowest > 0.0f ? std::min(cell.narrowest, least_deg) : least_deg;
        }
    }

    // Without a joint it is the lens; the pivot turns with nothing; where one axis is all that turns, what
    // lies along that axis stays, too.
    void anchor(Cell& cell) const {
        int turning = 0;
        vec3 along(0.0f);
        for (int node = mode_.beams[static_cast<std::size_t>(cell.beam)]; node >= 0;
             node = mode_.nodes[static_cast<std::size_t>(node)].parent)
            for (const fixture::Axis& axis : mode_.axes) {
                if (axis.node != node) continue;
                if (cell.joint < 0) cell.joint = node;
                along = vec3(matrices_[static_cast<std::size_t>(node)][axis.pan ? 2 : 0]);
                ++turning;
            }
        cell.anchor_m = cell.lens_m;
        if (cell.joint < 0) return;
        const vec3 pivot_m(matrices_[static_cast<std::size_t>(cell.joint)][3]);
        cell.anchor_m = pivot_m;
        if (turning != 1 || mode_.beams.size() == 1 || !(glm::length(along) > 0.0f)) return;
        along = glm::normalize(along);
        cell.anchor_m += along * glm::dot(cell.lens_m - pivot_m, along);
    }

    const fixture::Type& type_;
    const fixture::Mode& mode_;
    std::vector<glm::mat4> matrices_;
    std::vector<Cell> cells_; // what the channels say of each beam
};

struct Box {
    vec3 low, high;
    vec3 middle() const { return 0.5f * (low + high); }
};

template <class Place>
Box box_of(const std::vector<int>& items, Place place) {
    Box box{place(items.front()), place(items.front())};
    for (const int item : items) {
        box.low = glm::min(box.low, place(item));
        box.high = glm::max(box.high, place(item));
    }
    return box;
}

// Parts of which no item is farther than limit_m from the middle: slices of equal width across the longest
// side, and so on.
template <class Place>
void split(const std::vector<int>& items, float limit_m, Place place, std::vector<std::vector<int>>& parts) {
    const Box box = box_of(items, place);
    float radius_m = 0.0f;
    for (const int item : items) radius_m = std::max(radius_m, glm::distance(place(item), box.middle()));
    const vec3 size = box.high - box.low;
    const int side = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    // A size that is no number comes from places that are none; they are left together.
    if (!(radius_m > limit_m) || !(size[side] > 0.0f) || !std::isfinite(size[side])) {
        parts.push_back(items);
        return;
    }
    const float most = static_cast<float>(items.size());
    const auto count = static_cast<std::size_t>(
        std::clamp(std::ceil(size[side] / (2.0f * limit_m)), 2.0f, std::max(most, 2.0f)));
    std::vector<std::vector<int>> slices(count);
    for (const int item : items) {
        const float along = (place(item)[side] - box.low[side]) / size[side] * static_cast<float>(count);
        slices[std::min(static_cast<std::size_t>(along), count - 1)].push_back(item);
    }
    for (const std::vector<int>& slice : slices)
        if (!slice.empty()) split(slice, limit_m, place, parts);
}

// Alike, and pointing the same way as the first.
std::vector<std::vector<int>> alike(const std::vector<Cell>& cells, const Reader& reader) {
    using Key = std::tuple<int, int, float, float, std::vector<int>, int>;
    std::map<Key, std::vector<std::vector<int>>> found;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const Cell& cell = cells[c];
        const fixture::Beam& beam = reader.source(cell.beam);
        const int alone = cell.has_picture ? static_cast<int>(c) + 1 : 0;
        auto& groups = found[{cell.joint, static_cast<int>(beam.beam_type), beam.beam_angle_deg,
                              beam.field_angle_deg, cell.shaping, alone}];
        const auto near = std::find_if(groups.begin(), groups.end(), [&](const std::vector<int>& group) {
            const vec3 axis = cells[static_cast<std::size_t>(group.front())].axis;
            return glm::length(glm::cross(axis, cell.axis)) <= std::sin(kMergeTurn * cell.narrowest) &&
                   glm::dot(axis, cell.axis) > 0.0f;
        });
        if (near == groups.end())
            groups.push_back({static_cast<int>(c)});
        else
            near->push_back(static_cast<int>(c));
    }
    std::vector<std::vector<int>> all;
    for (auto& [key, groups] : found)
        for (std::vector<int>& group : groups) all.push_back(std::move(group));
    return all;
}

// Lumens of a file that says 0 weigh nothing, unless all of them do.
std::vector<float> weights_of(const std::vector<Cell>& cells, const std::vector<int>& part) {
    std::vector<float> weights;
    for (const int c : part) weights.push_back(std::max(cells[static_cast<std::size_t>(c)].lumens, 0.0f));
    const float sum = std::accumulate(weights.begin(), weights.end(), 0.0f);
    for (float& weight : weights) weight = sum > 0.0f ? weight / sum : 1.0f / static_cast<float>(part.size());
    return weights;
}

} // namespace

bool only_glows(const fixture::Beam& beam) {
    return beam.beam_type == fixture::BeamType::none || beam.beam_type == fixture::BeamType::glow;
}

BeamGroups beam_groups_of(const fixture::Type& type, const fixture::Mode& mode, bool is_laser) {
    BeamGroups result;
    if (mode.beams.empty()) {
        result.places_m.push_back(result.middle_m);
        return result;
    }
    const Reader reader(type, mode);
    std::vector<Cell> cells;
    for (int beam = 0; beam < static_cast<int>(mode.beams.size()); ++beam)
        if (!only_glows(reader.source(beam))) cells.push_back(reader.cell(beam));
    if (cells.empty()) {
        result.middle_m = reader.cell(0).anchor_m;
        return result;
    }
    const auto cell_of = [&](int c) -> const Cell& { return cells[static_cast<std::size_t>(c)]; };
    std::vector<std::vector<int>> parts;
    for (const std::vector<int>& group : alike(cells, reader)) {
        const float limit_m = kMergeShare * kMergeDistance_m * std::tan(cell_of(group.front()).narrowest);
        split(
            group, limit_m, [&](int c) { return cell_of(c).lens_m; }, parts);
    }
    std::sort(parts.begin(), parts.end());
    std::vector<vec3> anchors;
    std::vector<int> all;
    for (const std::vector<int>& part : parts) {
        BeamGroup& light = result.lights.emplace_back();
        light.weights = weights_of(cells, part);
        vec3 anchor_m(0.0f);
        for (std::size_t k = 0; k < part.size(); ++k) {
            light.beams.push_back(cell_of(part[k]).beam);
            light.copies = std::max(light.copies, most_copies(type, mode, cell_of(part[k]).beam));
            if (is_laser || draws_figures(mode, cell_of(part[k]).beam)) light.copies = fixture::kMostRays;
            anchor_m += light.weights[k] * cell_of(part[k]).anchor_m;
        }
        // Exactly the pivot, where that is what all have.
        const vec3 first_m = cell_of(part.front()).anchor_m;
        anchors.push_back(glm::distance(anchor_m, first_m) < kSamePlace_m ? first_m : anchor_m);
        all.push_back(static_cast<int>(all.size()));
    }
    const auto anchor_of = [&](int light) { return anchors[static_cast<std::size_t>(light)]; };
    std::vector<std::vector<int>> shared;
    split(all, kMapShare_m, anchor_of, shared);
    std::sort(shared.begin(), shared.end());
    for (const std::vector<int>& lights : shared) {
        const Box box = box_of(lights, anchor_of);
        const bool one = glm::distance(box.low, box.high) < kSamePlace_m;
        for (const int light : lights)
            result.lights[static_cast<std::size_t>(light)].place = static_cast<int>(result.places_m.size());
        result.places_m.push_back(one ? anchor_of(lights.front()) : box.middle());
    }
    std::vector<int> places(result.places_m.size());
    std::iota(places.begin(), places.end(), 0);
    const auto place_of = [&](int place) { return result.places_m[static_cast<std::size_t>(place)]; };
    result.middle_m = places.size() == 1 ? place_of(0) : box_of(places, place_of).middle();
    return result;
}

int beam_group_of(const BeamGroups& emitters, int beam) {
    for (std::size_t k = 0; k < emitters.lights.size(); ++k) {
        const std::vector<int>& beams = emitters.lights[k].beams;
        if (std::find(beams.begin(), beams.end(), beam) != beams.end()) return static_cast<int>(k);
    }
    return -1;
}

bool draws_figures(const fixture::Mode& mode, int beam) {
    for (const fixture::Channel& channel : mode.channels) {
        if (std::find(channel.beams.begin(), channel.beams.end(), beam) == channel.beams.end()) continue;
        for (const fixture::ChannelFunction& function : channel.functions)
            if (function.meaning.role == fixture::Role::laser_figure) return true;
    }
    return false;
}

} // namespace ghost::scene
