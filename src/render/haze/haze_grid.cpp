// SPDX-License-Identifier: Apache-2.0
#include "render/haze/private/haze_grid.h"

#include "render/geometry/beam_reach.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::render {
namespace {

using glm::dvec3;

constexpr double kHalfTurn = double{shared::kPi};
constexpr double kColumn_px = 12;   // along the beam, from column to column
constexpr double kMostGridBend = 1; // more would put the last columns far apart
constexpr float kMostDoubt = 0.2f;  // fraction of the light of a place
constexpr double kLeastGain = 1.5;  // pixels to a node: filling one costs as much as a pixel
constexpr double kSpareReach = 1.02;
constexpr int kProbes = 33; // rows that are looked at
constexpr float kRim = 0.999f;
constexpr double kMostAngle = 3.1;  // a ray away from the lamp
constexpr double kBeforeLens = 1.5; // of its radius

// Angles of rays from the way to the lamp.
struct Angles {
    double from = 4;
    double to = 0;
    bool empty() const { return to <= from; }
};

class SeenPart {
public:
    SeenPart(const shared::Light& light, const shared::Fan& fan, const shared::View& view, float reach_m)
        : fan_(fan), pole_(fan.beam.pole), reach_m_(reach_m), light_(light) {
        const dvec3 forward(view.forward), right(view.right), up(view.up);
        const dvec3 aside = right / glm::dot(right, right), above = up / glm::dot(up, up);
        edges_ = {forward + aside, forward - aside, forward + above, forward - above};
        for (int k = 0; k < 4; ++k)
            corners_[static_cast<std::size_t>(k)] =
                glm::normalize(forward + right * (k % 2 ? 1.0 : -1.0) + up * (k / 2 ? 1.0 : -1.0));
        look(view);
    }

    Angles angles;
    double widest_sine = 0; // of these angles
    double area_sr = 0;     // that the beam covers in the picture

private:
    // Angles at the lamp, from the pole, of the chord of a meridian.
    struct Meridian {
        glm::vec2 turn;
        double middle;
        double half;
        dvec3 aside;
    };

    Meridian meridian_of(float row) const {
        const glm::vec2 turn = shared::fan_meridian(fan_.beam, row);
        const glm::vec4 chord = shared::fan_chord(fan_.beam, turn);
        return {turn, std::atan2(double{chord.y}, double{chord.x}), std::atan(double{chord.w}),
                dvec3(fan_.beam.along) * double{turn.x} + dvec3(fan_.beam.across) * double{turn.y}};
    }

    // The part of a meridian's half plane that lies within the edges of the picture, and meets the beam.
    Angles within_picture(const Meridian& meridian) const {
        constexpr double kQuarter = kHalfTurn / 2;
        double from = std::max(meridian.middle - meridian.half, 0.0), to = kHalfTurn; // from the pole
        for (const dvec3& edge : edges_) {
            const double at = std::atan2(glm::dot(edge, meridian.aside), glm::dot(edge, pole_));
            if (at < -kQuarter) {
                from = std::max(from, at + 3 * kQuarter);
            } else {
                from = std::max(from, at - kQuarter);
                to = std::min(to, at + kQuarter);
            }
        }
        return {kHalfTurn - to, kHalfTurn - from};
    }

    double farthest_lit(const Meridian& meridian) const {
        double farthest = 0;
        for (const double angle :
             {meridian.middle - meridian.half, meridian.middle, meridian.middle + meridian.half}) {
            const double along = std::cos(angle) * double{fan_.beam.cos_axis} +
                                 std::sin(angle) * double{fan_.beam.sin_axis} * double{meridian.turn.x};
            const double distance_m = kSpareReach * double{reach_m_} / std::max(along, 1e-3);
            farthest = std::max(farthest, std::atan2(distance_m * std::max(std::sin(angle), 0.0),
                                                     double{fan_.beam.eye_m} - distance_m * std::cos(angle)));
        }
        return farthest;
    }

    void look(const shared::View& view) {
        const bool ends = reach_m_ < kEndless_m / 10;
        double farthest = ends ? 0.0 : 4.0;
        for (int k = 0; k < kProbes; ++k) {
            const float row = std::clamp(2.0f * static_cast<float>(k) / (kProbes - 1) - 1.0f, -kRim, kRim);
            const Meridian meridian = meridian_of(row);
            Angles part = within_picture(meridian);
            if (ends && !part.empty()) {
                const double lit = farthest_lit(meridian);
                part.to = std::min(part.to, lit);
                farthest = std::max(farthest, lit);
            }
            if (part.empty()) continue;
            add(part.from, part.to);
            const bool sideways = part.from < kHalfTurn / 2 && part.to > kHalfTurn / 2;
            widest_sine =
                std::max(widest_sine, sideways ? 1.0 : std::max(std::sin(part.from), std::sin(part.to)));
            const Meridian next = meridian_of(std::min(row + 2.0f / (kProbes - 1), 1.0f));
            const double turn = std::acos(std::clamp(double{glm::dot(next.turn, meridian.turn)}, -1.0, 1.0));
            area_sr += (std::cos(part.from) - std::cos(part.to)) * turn;
        }
        // A corner of the picture may lie between two of the rows.
        for (const dvec3& corner : corners_) {
            const double cosine = glm::dot(corner, pole_);
            const dvec3 aside = corner - cosine * pole_;
            const double sine = std::max(glm::length(aside), 1e-9);
            const float row =
                shared::fan_row(fan_.beam, static_cast<float>(glm::dot(aside, dvec3(fan_.beam.along)) / sine),
                                static_cast<float>(glm::dot(aside, dvec3(fan_.beam.across)) / sine));
            if (std::abs(row) > 1) continue;
            const double angle = std::acos(std::clamp(-cosine, -1.0, 1.0));
            add(angle, std::min(angle, std::max(farthest, angles.to)));
            widest_sine = std::max(widest_sine, std::sin(angle));
        }
        if (fan_.beam.row_scale > 0) from_lens(view);
        angles.to = std::min(angles.to, kMostAngle);
    }

    void add(double from, double to) {
        angles.from = std::min(angles.from, from);
        angles.to = std::max(angles.to, to);
    }

    // Nothing is lit before the lens.
    void from_lens(const shared::View& view) {
        const dvec3 way =
            dvec3(light_.position_m) + dvec3(light_.axis_w) * double{light_.lens_m} - dvec3(view.eye_m);
        const double away_m = std::max(glm::length(way), 1e-3);
        const double angle = std::acos(std::clamp(-glm::dot(way, pole_) / away_m, -1.0, 1.0));
        angles.from = std::max(angles.from, angle - kBeforeLens * double{light_.lens_radius_m} / away_m);
    }

    const shared::Fan& fan_;
    dvec3 pole_;
    float reach_m_;
    const shared::Light& light_;
    std::array<dvec3, 4> edges_, corners_;
};

} // namespace

std::optional<shared::HazeGrid> make_grid(const shared::Light& light, const shared::Fan& fan,
                                          const shared::View& view, float pixels_per_rad, float reach_m) {
    const SeenPart seen(light, fan, view, reach_m);
    if (seen.angles.empty()) return std::nullopt;
    const double near_h = std::tan(seen.angles.from / 2), far_h = std::tan(seen.angles.to / 2);
    if (!(far_h > near_h)) return std::nullopt;
    shared::HazeGrid grid{};
    grid.near_h = static_cast<float>(near_h);
    grid.per_h = static_cast<float>(1 / (far_h - near_h));
    grid.bend = static_cast<float>(
        std::clamp(std::sqrt(far_h / std::max(near_h, far_h / 1000)) - 1, 0.0, kMostGridBend));
    grid.most_doubt = kMostDoubt;
    const double columns = (seen.angles.to - seen.angles.from) * double{pixels_per_rad} / kColumn_px;
    grid.columns =
        std::clamp(static_cast<std::uint32_t>(std::ceil(columns)) + 1, 6u, shared::kMostGridColumns);
    const double turn = fan.beam.row_scale > 0 ? 2 * std::asin(1 / double{fan.beam.row_scale}) : kHalfTurn;
    // The fan's own table tells no more rows apart.
    const double rows =
        std::min(turn * seen.widest_sine * double{pixels_per_rad}, static_cast<double>(fan.size));
    grid.rows = std::clamp((static_cast<std::uint32_t>(rows) / 8 + 1) * 8, 8u, shared::kMostGridRows);
    const double pixels = seen.area_sr * double{pixels_per_rad} * double{pixels_per_rad};
    if (pixels < kLeastGain * grid.columns * grid.rows) return std::nullopt;
    return grid;
}

} // namespace ghost::render
