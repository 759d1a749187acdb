// SPDX-License-Identifier: Apache-2.0
#include "ui/model/lamp_drag.h"

#include "show_folder/hang.h"
#include "ui/language/language.h"

#include <algorithm>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr float kMost_m = 100;      // that a mouse drags
constexpr float kLeastSine = 0.02f; // between a line of sight and what it runs along

// How far along a line through the origin the nearest place to a line of sight is.
std::optional<float> nearest_along(const glm::vec3& along, const glm::vec3& eye_m, const glm::vec3& way) {
    const float cosine = glm::dot(along, way);
    const float sine2 = 1 - cosine * cosine;
    if (sine2 < kLeastSine * kLeastSine) return std::nullopt;
    return (glm::dot(along, eye_m) - cosine * glm::dot(way, eye_m)) / sine2;
}

} // namespace

LampDrag::LampDrag(const glm::vec3& place_m, const glm::vec3& hangs_m, const std::vector<Object>& objects)
    : place_m_(place_m) {
    std::vector<scene::Bar> pieces;
    std::vector<std::size_t> of_piece;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (!objects[i].bar || !objects[i].shown || !scene::is_slender(*objects[i].bar)) continue;
        pieces.push_back(*objects[i].bar);
        of_piece.push_back(i);
    }
    float nearest_m = INFINITY;
    std::optional<std::size_t> nearest;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const std::optional<float> away_m = scene::hangs_away_m(pieces[k], hangs_m);
        if (!away_m || *away_m >= nearest_m) continue;
        nearest_m = *away_m;
        nearest = k;
    }
    if (!nearest) return;
    const scene::Bar bar = scene::joined(pieces[*nearest], pieces);
    along_ = (bar.to_m - bar.from_m) / bar.length_m();
    low_m_ = -glm::dot(hangs_m - bar.from_m, along_);
    high_m_ = bar.length_m() + low_m_;
    bar_ = objects[of_piece[*nearest]].name;
}

void LampDrag::take_along(const LampDrag& other) {
    constexpr float kParallel = 0.999f;
    const float cosine = glm::dot(along_, other.along_); // 0 where one of them hangs under nothing
    if (std::abs(cosine) < kParallel) return;
    low_m_ = std::max(low_m_, cosine > 0 ? other.low_m_ : -other.high_m_);
    high_m_ = std::min(high_m_, cosine > 0 ? other.high_m_ : -other.low_m_);
}

// Where a line of sight meets what the light runs along, from the light's place; never far behind the
// horizon.
std::optional<glm::vec3> LampDrag::met_m(const glm::vec3& eye_m, const glm::vec3& way, bool upright) const {
    const glm::vec3 eye = eye_m - place_m_;
    if (upright || along_ != glm::vec3(0)) {
        const glm::vec3 along = upright ? glm::vec3(0, 0, 1) : along_;
        const std::optional<float> so_far = nearest_along(along, eye, way);
        return so_far ? std::optional(along * *so_far) : std::nullopt;
    }
    if (std::abs(way.z) < kLeastSine || eye.z / way.z >= 0) return std::nullopt;
    const glm::vec3 met = eye - way * (eye.z / way.z);
    return glm::vec3(met.x, met.y, 0);
}

glm::vec3 LampDrag::by_m(const glm::vec3& eye_m, const glm::vec3& from_way, const glm::vec3& way,
                         bool upright) const {
    const auto from = met_m(eye_m, from_way, upright), to = met_m(eye_m, way, upright);
    if (!from || !to) return glm::vec3(0);
    glm::vec3 by = *to - *from;
    if (!upright && along_ != glm::vec3(0)) { // whole centimetres that leave it on its truss
        constexpr float kRounding_cm = 0.01f;
        const float least_cm = std::ceil(low_m_ * 100 - kRounding_cm);
        const float most_cm = std::floor(high_m_ * 100 + kRounding_cm);
        const float cm = std::round(glm::dot(by, along_) * 100);
        return glm::round(along_ * std::clamp(cm, std::min(least_cm, most_cm), most_cm) * 10.0f) / 1000.0f;
    }
    if (glm::length(by) > kMost_m) by *= kMost_m / glm::length(by);
    return glm::round(by * 100.0f) / 100.0f;
}

QString LampDrag::words(const glm::vec3& by_m) const {
    const QString far = QString("%1 m").arg(static_cast<double>(glm::length(by_m)), 0, 'f', 2);
    const bool upright = by_m.z != 0 && by_m.x == 0 && by_m.y == 0;
    return upright ? (by_m.z > 0 ? translated("Picture", "%1 up") : translated("Picture", "%1 down")).arg(far)
           : bar_.empty() ? far
                          : translated("Picture", "%1 along %2").arg(far, QString::fromStdString(bar_));
}

} // namespace ghost::ui
