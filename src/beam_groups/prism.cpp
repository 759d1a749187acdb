// SPDX-License-Identifier: Apache-2.0
#include "beam_groups/prism.h"

#include "base/text.h"
#include "image/colour.h"
#include "photometry/photometry.h"
#include "show/show.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace ghost::scene {
namespace {

using fixture::Role;
using glm::vec2;
using glm::vec3;

constexpr float kRing = 1.2f;      // of a stand-in's facets, gate radii
constexpr float kLineStep = 1.25f; // between the pictures of a linear stand-in
constexpr int kUsualFacets = 3;
constexpr float kFarthest = 20.0f; // gate radii; no prism turns light farther
constexpr float kMostScale = 20.0f;
constexpr float kStretched = 1.3f; // of two axes: from here a row of pictures
constexpr float kRowOverlap = 1.5f;
constexpr int kMostInRow = 12;
constexpr float kOut = 1e-3f; // of a prism on its way

std::vector<Copy> stand_in(const std::string& name) {
    int count = 0;
    bool linear = false;
    const std::string small = lower(name);
    linear = small.find("lin") != std::string::npos;
    // "6F", "8-facet", "5 - facet": the number before the word.
    for (std::size_t i = 0; i < small.size(); ++i) {
        if (std::isdigit(static_cast<unsigned char>(small[i])) == 0) continue;
        std::size_t end = i;
        int number = 0;
        while (end < small.size() && std::isdigit(static_cast<unsigned char>(small[end])) != 0 &&
               number < 1000)
            number = number * 10 + (small[end++] - '0');
        std::size_t word = end;
        while (word < small.size() && (small[word] == ' ' || small[word] == '-')) ++word;
        if (word < small.size() && small[word] == 'f' && number >= 2 && number < 1000) count = number;
        i = end;
    }
    if (count == 0) count = kUsualFacets;
    std::vector<Copy> facets;
    for (int k = 0; k < count; ++k) {
        const float at = static_cast<float>(k);
        const float angle = 2.0f * shared::kPi * at / static_cast<float>(count);
        facets.push_back({linear ? vec2(kLineStep * (at - 0.5f * static_cast<float>(count - 1)), 0.0f)
                                 : kRing * vec2(std::cos(angle), std::sin(angle)),
                          1.0f, vec3(1.0f / static_cast<float>(count))});
    }
    return facets;
}

// One facet: where its picture goes, how large it is.
void add_facet(const fixture::Facet& facet, std::vector<Copy>& copies) {
    const std::array<float, 9>& m = facet.rotation;
    const auto sane = [](float value, float most) {
        return std::isfinite(value) ? std::clamp(value, -most, most) : 0.0f;
    };
    const bool by_rows = m[6] != 0.0f || m[7] != 0.0f;
    const vec2 aside(sane(by_rows ? m[6] : m[2], kFarthest), sane(by_rows ? m[7] : m[5], kFarthest));
    // p' = p M: the longer and the shorter axis of what becomes of a circle.
    const vec2 x(sane(m[0], kMostScale), sane(m[1], kMostScale));
    const vec2 y(sane(m[3], kMostScale), sane(m[4], kMostScale));
    const float xx = x.x * x.x + y.x * y.x, yy = x.y * x.y + y.y * y.y, xy = x.x * x.y + y.x * y.y;
    const float half = std::sqrt(0.25f * (xx - yy) * (xx - yy) + xy * xy);
    const float longer = std::sqrt(0.5f * (xx + yy) + half);
    const float shorter = std::sqrt(std::max(0.5f * (xx + yy) - half, 0.0f));
    Copy copy{aside, 1.0f, vec3(1.0f)};
    const vec3 tint = image::xyy_to_rec2020({facet.color.x, facet.color.y, facet.color.Y / 100.0f});
    copy.fraction = glm::clamp(tint, vec3(0.0f), vec3(1.0f));
    if (!(longer > 0.05f)) {
        copies.push_back(copy);
        return;
    }
    if (longer < kStretched * shorter) {
        copy.scale = std::sqrt(longer * shorter);
        copies.push_back(copy);
        return;
    }
    const float width = std::max(shorter, longer / (kMostInRow / kRowOverlap));
    const int count = std::clamp(static_cast<int>(std::ceil(kRowOverlap * longer / width)), 2, kMostInRow);
    const float angle = 0.5f * std::atan2(2.0f * xy, xx - yy);
    for (int k = 0; k < count; ++k) {
        const float at = 2.0f * static_cast<float>(k) / static_cast<float>(count - 1) - 1.0f;
        Copy one = copy;
        one.aside += at * (longer - width) * vec2(std::cos(angle), std::sin(angle));
        one.scale = width;
        one.fraction /= static_cast<float>(count);
        copies.push_back(one);
    }
}

// Neighbours joined, in cells as small as will do.
std::vector<Copy> joined(const std::vector<Copy>& copies, int most) {
    if (static_cast<int>(copies.size()) <= most) return copies;
    std::vector<Copy> result;
    for (float cell = 0.05f;; cell *= 1.25f) {
        std::map<std::pair<int, int>, std::vector<const Copy*>> cells;
        for (const Copy& copy : copies)
            cells[{static_cast<int>(std::floor(copy.aside.x / cell + 0.5f)),
                   static_cast<int>(std::floor(copy.aside.y / cell + 0.5f))}]
                .push_back(&copy);
        if (static_cast<int>(cells.size()) > most) continue;
        for (const auto& [at, members] : cells) {
            Copy sum{vec2(0.0f), 0.0f, vec3(0.0f)};
            float weight = 0.0f, spread2 = 0.0f;
            for (const Copy* copy : members) {
                const float w = copy->fraction.x + copy->fraction.y + copy->fraction.z + 1e-6f;
                sum.aside += w * copy->aside;
                sum.scale += w * copy->scale;
                sum.fraction += copy->fraction;
                weight += w;
            }
            sum.aside /= weight;
            for (const Copy* copy : members) {
                const vec2 off = copy->aside - sum.aside;
                spread2 = std::max(spread2, glm::dot(off, off));
            }
            sum.scale = std::sqrt(sum.scale * sum.scale / (weight * weight) + spread2);
            result.push_back(sum);
        }
        return result;
    }
}

vec2 turned(const vec2& at, float deg) {
    const float c = std::cos(glm::radians(deg)), s = std::sin(glm::radians(deg));
    return {c * at.x - s * at.y, s * at.x + c * at.y};
}

const fixture::Slot* slot_of(const fixture::Type& type, int wheel, int slot) {
    if (wheel < 0 || slot < 0) return nullptr;
    const std::vector<fixture::Slot>& slots = type.wheels[static_cast<std::size_t>(wheel)].slots;
    return static_cast<std::size_t>(slot) < slots.size() ? &slots[static_cast<std::size_t>(slot)] : nullptr;
}

// How many pictures each prism of a beam (by its number) makes at most.
std::map<int, int> most_facets(const fixture::Type& type, const fixture::Mode& mode, int beam) {
    std::map<int, int> most;
    for (const fixture::Channel& channel : mode.channels) {
        if (std::find(channel.beams.begin(), channel.beams.end(), beam) == channel.beams.end()) continue;
        for (const fixture::ChannelFunction& function : channel.functions) {
            if (!is_prism(function.meaning.role)) continue;
            int& count = most[function.meaning.number];
            count = std::max(count, kUsualFacets);
            if (function.wheel < 0) continue;
            for (const fixture::Slot& slot : type.wheels[static_cast<std::size_t>(function.wheel)].slots)
                count = std::max(count, static_cast<int>(facets_of(slot).size()));
        }
    }
    return most;
}

// others: among its slots are other things than prisms.
void check_wheel(const fixture::Wheel& wheel, bool others, const std::string& file, Report& report) {
    for (std::size_t k = 0; k < wheel.slots.size(); ++k) {
        const fixture::Slot& slot = wheel.slots[k];
        if (others && slot.facets.empty()) continue;
        const std::string where = file + ": " + wheel.name + "/" + slot.name;
        const std::size_t count = facets_of(slot).size();
        if (slot.facets.empty() && k > 0)
            report.add(Severity::note, where,
                       "a prism without facets; drawn as " + std::to_string(count) +
                           ", by its name or as most are");
        else if (count > static_cast<std::size_t>(kMostCopies))
            report.add(Severity::warning, where,
                       "a prism that makes " + std::to_string(count) +
                           " pictures; neighbours are joined to " + std::to_string(kMostCopies) +
                           ", with as much light");
    }
}

} // namespace

std::vector<Copy> facets_of(const fixture::Slot& slot) {
    if (slot.facets.empty()) return stand_in(slot.name);
    std::vector<Copy> copies;
    for (const fixture::Facet& facet : slot.facets) add_facet(facet, copies);
    // A facet is as large as the others: its fraction of the light.
    for (Copy& copy : copies) copy.fraction /= static_cast<float>(slot.facets.size());
    return copies;
}

std::vector<Copy> copies_of(const fixture::Type& type, const fixture::Optics& optics, int most) {
    std::vector<Copy> all(1);
    for (const fixture::Insert& prism : optics.prisms) {
        const float in = std::clamp(prism.in, 0.0f, 1.0f);
        if (!(in > kOut)) continue;
        const fixture::Slot* slot = slot_of(type, prism.wheel, prism.slot);
        std::vector<Copy> facets = slot ? facets_of(*slot) : stand_in("");
        for (Copy& facet : facets) facet.fraction *= in;
        if (in < 1.0f - kOut) facets.push_back({vec2(0.0f), 1.0f, vec3(1.0f - in)});
        std::vector<Copy> product;
        for (const Copy& before : all)
            for (const Copy& facet : facets)
                product.push_back({before.aside + turned(facet.aside, prism.deg) * before.scale,
                                   before.scale * facet.scale, before.fraction * facet.fraction});
        // Stacked prisms multiply: what will be joined in the end is joined on the way.
        all = joined(product, kMostCopies);
    }
    return joined(all, most);
}

int most_copies(const fixture::Type& type, const fixture::Mode& mode, int beam) {
    int most = 1;
    for (const auto& [number, facets] : most_facets(type, mode, beam))
        most = std::min(most * (facets + 1), kMostCopies);
    return most;
}

shared::Light copied(const shared::Light& light, const Copy& copy) {
    shared::Light result = light;
    const vec2 aside = copy.aside * light.tan_field;
    result.axis_w = glm::normalize(light.axis_w + aside.x * light.axis_u + aside.y * light.axis_v);
    result.axis_u = glm::normalize(light.axis_u - result.axis_w * glm::dot(light.axis_u, result.axis_w));
    const vec3 across = glm::cross(result.axis_u, result.axis_w);
    result.axis_v = glm::dot(across, light.axis_v) < 0.0f ? -across : across;
    vec3 fraction = copy.fraction;
    if (copy.scale != 1.0f && copy.scale > 0.0f) {
        const auto solid_angle = [](const shared::Light& of) {
            const Profile profile{.tan_field = of.tan_field,
                                  .power = of.profile_power,
                                  .scale = of.profile_scale,
                                  .edge = of.edge,
                                  .cut_radius = of.cut_radius};
            return beam_solid_angle(profile, of.iris_radius);
        };
        result.tan_field *= copy.scale;
        result.lens_m /= copy.scale;
        fraction *= solid_angle(light) / std::max(solid_angle(result), 1e-9f);
    }
    // It turns about the lens.
    const vec3 moved_m = light.lens_m * light.axis_w - result.lens_m * result.axis_w;
    result.position_m += moved_m;
    result.off_map_m += moved_m;
    result.intensity_cd = light.intensity_cd * fraction;
    result.bounce_cd = light.bounce_cd * copy.fraction;
    return result;
}

void check_prisms(const fixture::Type& type, const std::string& file, Report& report) {
    std::set<int> seen; // wheels
    for (const fixture::Mode& mode : type.modes)
        for (const fixture::Channel& channel : mode.channels)
            for (const fixture::ChannelFunction& function : channel.functions)
                if (is_prism(function.meaning.role) && function.wheel >= 0 &&
                    seen.insert(function.wheel).second)
                    check_wheel(type.wheels[static_cast<std::size_t>(function.wheel)],
                                fixture::attribute_from(function.attribute).role != function.meaning.role,
                                file, report);
}

void check_prisms(const Show& show, Report& report) {
    std::set<const fixture::Type*> seen;
    for (const PatchedFixture& fixture : show.fixtures)
        if (fixture.type && seen.insert(fixture.type.get()).second)
            check_prisms(*fixture.type, fixture.gdtf.string(), report);
}

} // namespace ghost::scene
