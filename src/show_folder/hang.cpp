// SPDX-License-Identifier: Apache-2.0
#include "show_folder/hang.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ghost::scene {
namespace {

constexpr float kSlender = 3; // times as long as wide
constexpr float kWidestTruss_m = 1.3f;
constexpr float kLonger_m = 1e-3f; // than rounding makes it
constexpr float kLeastLength_m = 0.4f;
constexpr float kLeastHeight_m = 0.03f; // the thinnest pipe that carries a lamp has 38 mm
constexpr float kLower_m = 0.5f;        // below what hangs, is not what is meant
constexpr float kGap_m = 0.3f;          // between pieces of one truss
constexpr float kBeside_m = 0.05f;    // that they may lie beside or below each other, or a lamp beyond an end
constexpr float kAboveLamp_m = 0.6f;  // of a fixture's place: the underside of the bar that it hangs under
constexpr float kBelowLamp_m = 0.3f;  // likewise: clamps reach round it
constexpr float kBesideLamp_m = 0.5f; // beyond the bar's own half width
constexpr float kSameWay = 0.999f;    // cosine, 2.5 degrees
constexpr float kEnd = 0.1f; // of its length, at either end and in the middle: where a bow is measured
constexpr float kLeastBow_m = 0.1f;
constexpr float kBetween_m = 0.02f;  // two that hang side by side
constexpr float kRounding_m = 1e-4f; // of sums of widths

struct Extent {
    float low = std::numeric_limits<float>::max();
    float high = -std::numeric_limits<float>::max();
    void include(float value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    float length() const { return high - low; }
    float middle() const { return 0.5f * (low + high); }
};

// The direction in which points of the floor plan scatter most.
glm::vec2 main_way(std::span<const glm::vec2> points) {
    glm::dvec2 mean(0);
    for (const glm::vec2& point : points) mean += glm::dvec2(point) / static_cast<double>(points.size());
    double xx = 0, xy = 0, yy = 0;
    for (const glm::vec2& point : points) {
        const glm::dvec2 d = glm::dvec2(point) - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

glm::vec3 way_of(const Bar& bar) {
    return glm::normalize(bar.to_m - bar.from_m);
}

// Whether the other one goes on where this one ends, on either side.
bool goes_on(const Bar& bar, const Bar& other) {
    if (other.length_m() < kLeastLength_m || std::abs(glm::dot(way_of(bar), way_of(other))) < kSameWay)
        return false;
    const glm::vec3 way = way_of(bar);
    Extent along;
    for (const glm::vec3& end : {other.from_m, other.to_m}) {
        const glm::vec3 from_start = end - bar.from_m;
        const float at_m = glm::dot(from_start, way);
        if (glm::length(from_start - at_m * way) > kBeside_m) return false;
        along.include(at_m);
    }
    return along.high > -kGap_m && along.low < bar.length_m() + kGap_m;
}

// How far the middle of what lies along a way is from its ends, to the left; 0: it is straight, or an S.
float bow_of(std::span<const glm::vec2> plan, const glm::vec2& way, const Extent& along) {
    Extent begin, middle, end;
    for (const glm::vec2& point : plan) {
        const float at = (glm::dot(point, way) - along.low) / along.length();
        const float beside_m = glm::dot(point, {-way.y, way.x});
        if (at < kEnd) begin.include(beside_m);
        if (at > 1 - kEnd) end.include(beside_m);
        if (std::abs(at - 0.5f) < kEnd / 2) middle.include(beside_m);
    }
    if (begin.length() < 0 || middle.length() < 0 || end.length() < 0) return 0; // nothing is there
    const float from_begin_m = middle.middle() - begin.middle(), from_end_m = middle.middle() - end.middle();
    const bool bends = std::min(std::abs(from_begin_m), std::abs(from_end_m)) >= kLeastBow_m;
    // Of the parabola of place_m() that much lies between the middles of where it was measured.
    constexpr float kSeen = 1 - 4 * (kEnd / 2) * (1 - kEnd / 2);
    return bends && from_begin_m * from_end_m > 0 ? 0.5f * (from_begin_m + from_end_m) / kSeen : 0;
}

float along_m(const Bar& bar, const glm::vec3& place_m) {
    return std::clamp(glm::dot(place_m - bar.from_m, way_of(bar)), 0.0f, bar.length_m());
}

// A stretch of a bar, in metres from where it begins.
struct Stretch {
    float from_m = 0;
    float to_m = 0;
    float length() const { return to_m - from_m; }
};

// What is free of a bar, in its order. Whatever hangs at an end may stand out beyond it.
std::vector<Stretch> free_stretches(float length_m, std::vector<Stretch> taken) {
    std::sort(taken.begin(), taken.end(),
              [](const Stretch& a, const Stretch& b) { return a.from_m < b.from_m; });
    std::vector<Stretch> free;
    float from_m = 0;
    for (const Stretch& one : taken) {
        if (one.from_m > from_m) free.push_back({from_m, std::min(one.from_m, length_m)});
        from_m = std::max(from_m, one.to_m);
    }
    if (from_m < length_m) free.push_back({from_m, length_m});
    return free;
}

// The middle of something that wide that is nearest to where it is wanted; nothing: it fits nowhere.
std::optional<float> nearest_room(const std::vector<Stretch>& free, float width_m, float wanted_m) {
    std::optional<float> nearest;
    for (const Stretch& one : free) {
        if (one.length() < width_m - kRounding_m) continue;
        const float low_m = one.from_m + width_m / 2;
        const float at_m = std::clamp(wanted_m, low_m, std::max(low_m, one.to_m - width_m / 2));
        if (!nearest || std::abs(at_m - wanted_m) < std::abs(*nearest - wanted_m)) nearest = at_m;
    }
    return nearest;
}

// Where something is that many metres into what is free.
float along_free(const std::vector<Stretch>& free, float into_m) {
    for (const Stretch& one : free) {
        if (into_m <= one.length()) return one.from_m + into_m;
        into_m -= one.length();
    }
    return free.empty() ? 0 : free.back().to_m;
}

} // namespace

glm::vec3 Bar::place_m(float at) const {
    const glm::vec3 run = to_m - from_m;
    const float length = std::hypot(run.x, run.y);
    if (bow_m == 0 || length <= 0) return from_m + at * run;
    // The line runs through the middle of what it bends round; a parabola is near enough to an arc.
    const glm::vec3 left(-run.y / length, run.x / length, 0);
    return from_m + at * run + bow_m * (4 * at * (1 - at) - 0.5f) * left;
}

std::optional<Bar> bar_of(std::span<const glm::vec3> positions, const glm::mat4& world) {
    if (positions.empty()) return std::nullopt;
    std::vector<glm::vec2> plan;
    plan.reserve(positions.size());
    Extent height;
    for (const glm::vec3& position : positions) {
        const glm::vec3 at_m(world * glm::vec4(position, 1.0f));
        plan.emplace_back(at_m);
        height.include(at_m.z);
    }
    // Its own axes are exact where one of them is right; a mesh whose axes are the world's needs its own way.
    std::vector<glm::vec2> ways{main_way(plan)};
    for (int axis = 0; axis < 3; ++axis)
        if (const glm::vec2 own(world[axis]); glm::length(own) > 1e-6f) ways.push_back(glm::normalize(own));
    glm::vec2 best_way{1, 0};
    Extent best_along, best_across;
    for (const glm::vec2& way : ways) {
        Extent along, across;
        for (const glm::vec2& point : plan) {
            along.include(glm::dot(point, way));
            across.include(glm::dot(point, {-way.y, way.x}));
        }
        if (along.length() < across.length()) continue; // another one runs along it
        if (best_along.length() > 0 && across.length() >= best_across.length()) continue;
        best_way = way;
        best_along = along;
        best_across = across;
    }
    if (!(best_along.length() >= kLeastLength_m) || best_along.length() < height.length())
        return std::nullopt;
    const glm::vec2 middle = best_across.middle() * glm::vec2(-best_way.y, best_way.x);
    Bar bar{{best_along.low * best_way + middle, height.low},
            {best_along.high * best_way + middle, height.low},
            std::max(best_across.length(), height.length()),
            height.length(),
            bow_of(plan, best_way, best_along)};
    const glm::vec3 run = bar.to_m - bar.from_m;
    if (std::abs(run.x) > 0.01f * bar.length_m() ? run.x < 0 : run.y < 0) {
        std::swap(bar.from_m, bar.to_m);
        bar.bow_m = -bar.bow_m;
    }
    return bar;
}

bool is_slender(const Bar& bar) {
    return bar.length_m() >= kSlender * bar.across_m && bar.across_m <= kWidestTruss_m &&
           bar.length_m() >= kLeastLength_m && bar.height_m >= kLeastHeight_m;
}

Bar joined(const Bar& piece, std::span<const Bar> all) {
    std::vector<bool> taken;
    return joined(piece, all, taken);
}

Bar joined(const Bar& piece, std::span<const Bar> all, std::vector<bool>& taken) {
    Bar whole = piece;
    const glm::vec3 way = way_of(piece);
    taken.assign(all.size(), false);
    for (bool grew = true; grew;) {
        grew = false;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (taken[i] || !goes_on(whole, all[i])) continue;
            taken[i] = grew = true;
            const float was_m = whole.length_m();
            Extent along;
            for (const glm::vec3& end : {whole.from_m, whole.to_m, all[i].from_m, all[i].to_m})
                along.include(glm::dot(end - piece.from_m, way));
            whole.from_m = piece.from_m + along.low * way;
            whole.to_m = piece.from_m + along.high * way;
            // The piece itself is among all of them.
            if (whole.length_m() > was_m + kLonger_m) whole.bow_m = 0;
        }
    }
    return whole;
}

std::optional<float> hangs_away_m(const Bar& bar, const glm::vec3& place_m) {
    const float length_m = bar.length_m();
    const float at_m = glm::dot(place_m - bar.from_m, way_of(bar));
    const glm::vec3 off = bar.place_m(at_m / length_m) - place_m;
    if (at_m < -kBeside_m || at_m > length_m + kBeside_m || off.z > kAboveLamp_m ||
        off.z < -kBelowLamp_m - bar.height_m || std::hypot(off.x, off.y) > kBesideLamp_m + bar.across_m / 2)
        return std::nullopt;
    return glm::length(off);
}

std::optional<std::size_t> nearest_bar(std::span<const Bar> all, const glm::vec3& to_m) {
    std::optional<std::size_t> nearest;
    float nearest_m = std::numeric_limits<float>::max();
    bool nearest_is_low = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!is_slender(all[i])) continue;
        const glm::vec3 place_m = places_under(all[i], std::array{to_m}).front();
        const bool is_low = place_m.z < to_m.z - kLower_m;
        const float away_m = glm::distance(place_m, to_m);
        if (nearest && (is_low != nearest_is_low ? is_low : away_m >= nearest_m)) continue;
        nearest_is_low = is_low;
        nearest_m = away_m;
        nearest = i;
    }
    return nearest;
}

std::vector<glm::vec3> places_under(const Bar& bar, std::span<const glm::vec3> are_m) {
    std::vector<glm::vec3> places;
    const glm::vec3 way = way_of(bar);
    for (std::size_t i = 0; i < are_m.size(); ++i) {
        const float at = are_m.size() == 1
                             ? std::clamp(glm::dot(are_m[0] - bar.from_m, way) / bar.length_m(), 0.0f, 1.0f)
                             : (static_cast<float>(i) + 0.5f) / static_cast<float>(are_m.size());
        places.push_back(bar.place_m(at));
    }
    return places;
}

std::optional<std::vector<glm::vec3>> places_beside(const Bar& bar, std::span<const BarLoad> shall,
                                                    std::span<const BarLoad> there) {
    if (there.empty()) {
        std::vector<glm::vec3> are_m;
        for (const BarLoad& one : shall) are_m.push_back(one.place_m);
        return places_under(bar, are_m);
    }
    const float length_m = bar.length_m();
    std::vector<Stretch> taken;
    for (const BarLoad& one : there) {
        const float at_m = along_m(bar, one.place_m), half_m = one.width_m / 2 + kBetween_m;
        taken.push_back({at_m - half_m, at_m + half_m});
    }
    const std::vector<Stretch> free = free_stretches(length_m, taken);
    float free_m = 0;
    for (const Stretch& one : free) free_m += one.length();
    // First where they are wanted, or near; where that leaves rests too small, one behind the other.
    for (const bool packs : {false, true}) {
        std::vector<Stretch> all = taken;
        std::vector<float> at_m;
        for (std::size_t i = 0; i < shall.size(); ++i) {
            const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(shall.size());
            const float wanted_m = packs               ? 0
                                   : shall.size() == 1 ? along_m(bar, shall[0].place_m)
                                                       : along_free(free, share * free_m);
            const auto found = nearest_room(free_stretches(length_m, all), shall[i].width_m, wanted_m);
            if (!found) break;
            at_m.push_back(*found);
            const float half_m = shall[i].width_m / 2 + kBetween_m;
            all.push_back({*found - half_m, *found + half_m});
        }
        if (at_m.size() < shall.size()) continue;
        const bool are_alike = std::all_of(shall.begin(), shall.end(), [&](const BarLoad& one) {
            return std::abs(one.width_m - shall[0].width_m) < kRounding_m;
        });
        if (are_alike) std::sort(at_m.begin(), at_m.end()); // the first stays leftmost
        std::vector<glm::vec3> places;
        for (const float one_m : at_m) places.push_back(bar.place_m(one_m / length_m));
        return places;
    }
    return std::nullopt;
}

} // namespace ghost::scene
