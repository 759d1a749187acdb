// SPDX-License-Identifier: Apache-2.0
#include "show/camera_moves.h"

#include "show/show.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kSteepest_rad = 1.5f; // 86 degrees: straight up there is no sideways
constexpr float kMost_m = static_cast<float>(kMaxCoordinate_m);
constexpr float kWidest_deg = 170;
constexpr float kOverFloor_m = 0.05f; // the floor is z = 0

struct Way {
    float around_rad = 0; // 0: along X
    float up_rad = 0;
    float length_m = 1;
};

Way way_of(const glm::vec3& way) {
    return {std::atan2(way.y, way.x), std::atan2(way.z, std::hypot(way.x, way.y)),
            std::max(glm::length(way), 1e-3f)};
}

glm::vec3 vector_of(const Way& way) {
    return way.length_m * glm::vec3(std::cos(way.up_rad) * std::cos(way.around_rad),
                                    std::cos(way.up_rad) * std::sin(way.around_rad), std::sin(way.up_rad));
}

Way tilted(Way way, float up_rad) {
    // A camera of a show that looks steeper keeps its way until it is moved up or down.
    if (up_rad != 0.0f) way.up_rad = std::clamp(way.up_rad + up_rad, -kSteepest_rad, kSteepest_rad);
    return way;
}

void move(Camera& camera, const glm::vec3& by_m) {
    const glm::vec3 eye_m = glm::clamp(camera.position_m + by_m, -kMost_m, kMost_m);
    camera.target_m += eye_m - camera.position_m;
    camera.position_m = eye_m;
}

float tan_half_height(const Camera& camera) {
    return std::tan(camera.fov_y_deg * kPi / 360.0f);
}

} // namespace

Camera camera_between(const Camera& from, const Camera& to, float share) {
    const float eased = share * share * (3.0f - 2.0f * share);
    Camera camera = from;
    camera.position_m = glm::mix(from.position_m, to.position_m, eased);
    // Turns the way of looking as a head does, around and up: mixing two targets may end in the eye itself.
    const Way a = way_of(from.target_m - from.position_m);
    const Way b = way_of(to.target_m - to.position_m);
    const float turn = std::remainder(b.around_rad - a.around_rad, 2 * kPi);
    camera.target_m =
        camera.position_m + vector_of({a.around_rad + turn * eased, glm::mix(a.up_rad, b.up_rad, eased),
                                       glm::mix(a.length_m, b.length_m, eased)});
    camera.fov_y_deg = glm::mix(from.fov_y_deg, to.fov_y_deg, eased);
    camera.ev100 = glm::mix(from.ev100, to.ev100, eased);
    return camera;
}

Camera orbited(const Camera& camera, float around_rad, float up_rad) {
    Way way = tilted(way_of(camera.target_m - camera.position_m), -up_rad);
    way.around_rad -= around_rad;
    Camera moved = camera;
    moved.position_m = camera.target_m - vector_of(way);
    if (camera.position_m.z > 0 && moved.position_m.z < kOverFloor_m) {
        way.up_rad = std::asin(std::clamp((camera.target_m.z - kOverFloor_m) / way.length_m, -1.0f, 1.0f));
        moved.position_m = camera.target_m - vector_of(way);
    }
    return moved;
}

Camera turned(const Camera& camera, float left_rad, float up_rad) {
    Way way = tilted(way_of(camera.target_m - camera.position_m), up_rad);
    way.around_rad += left_rad;
    Camera moved = camera;
    moved.target_m = camera.position_m + vector_of(way);
    return moved;
}

Camera panned(const Camera& camera, float right_share, float up_share) {
    const float height_m = 2.0f * glm::length(camera.target_m - camera.position_m) * tan_half_height(camera);
    const glm::mat4 axes = camera_to_world(camera);
    Camera moved = camera;
    move(moved, height_m * (right_share * glm::vec3(axes[0]) + up_share * glm::vec3(axes[1])));
    return moved;
}

Camera dollied(const Camera& camera, float factor) {
    Way way = way_of(camera.target_m - camera.position_m);
    way.length_m = std::clamp(way.length_m * factor, kNearest_m, kMost_m);
    Camera moved = camera;
    moved.position_m = camera.target_m - vector_of(way);
    return moved;
}

Camera flown(const Camera& camera, const glm::vec3& way_m) {
    const Way way = way_of(camera.target_m - camera.position_m);
    const glm::vec3 ahead(std::cos(way.around_rad), std::sin(way.around_rad), 0);
    Camera moved = camera;
    move(moved, glm::vec3(ahead.y, -ahead.x, 0) * way_m.x + ahead * way_m.y + glm::vec3(0, 0, way_m.z));
    return moved;
}

Camera focused(const Camera& camera, const glm::vec3& centre_m, float radius_m) {
    const float shape =
        static_cast<float>(std::max(camera.width, 1)) / static_cast<float>(std::max(camera.height, 1));
    const float half_rad = std::atan(tan_half_height(camera) * std::min(shape, 1.0f));
    Way way = way_of(camera.target_m - camera.position_m);
    way.length_m = std::clamp(radius_m / std::sin(half_rad), kNearest_m, kMost_m);
    Camera moved = camera;
    moved.target_m = centre_m;
    moved.position_m = centre_m - vector_of(way);
    return moved;
}

float share_of_frame(const Camera& camera, const glm::ivec2& frame) {
    if (frame.x <= 0 || frame.y <= 0 || camera.width <= 0 || camera.height <= 0) return 1;
    return std::min(static_cast<float>(camera.width) / static_cast<float>(camera.height) *
                        static_cast<float>(frame.y) / static_cast<float>(frame.x),
                    1.0f);
}

Camera with_frame(const Camera& camera, const glm::ivec2& frame) {
    const float share = share_of_frame(camera, frame);
    if (share >= 1) return camera; // exactly as it is
    Camera wide = camera;
    wide.fov_y_deg = std::min(std::atan(tan_half_height(camera) / share) * 360.0f / kPi, kWidest_deg);
    return wide;
}

std::optional<InPicture> project(const Camera& camera, const glm::vec3& point_m) {
    const glm::mat4 axes = camera_to_world(camera);
    const glm::vec3 way = point_m - glm::vec3(axes[3]);
    const float depth_m = -glm::dot(way, glm::vec3(axes[2]));
    if (!(depth_m > 1e-3f)) return std::nullopt;
    const float half_height = tan_half_height(camera);
    const float half_width =
        half_height * static_cast<float>(camera.width) / static_cast<float>(std::max(camera.height, 1));
    const glm::vec2 at(glm::dot(way, glm::vec3(axes[0])) / (depth_m * half_width),
                       glm::dot(way, glm::vec3(axes[1])) / (depth_m * half_height));
    return InPicture{{0.5f + 0.5f * at.x, 0.5f - 0.5f * at.y}, depth_m};
}

glm::vec3 way_through(const Camera& camera, const glm::vec2& place) {
    const glm::mat4 to_world = camera_to_world(camera);
    const float tan_y = std::tan(glm::radians(camera.fov_y_deg) * 0.5f);
    const float tan_x = tan_y * static_cast<float>(camera.width) / static_cast<float>(camera.height);
    return glm::normalize(-glm::vec3(to_world[2]) + glm::vec3(to_world[0]) * (tan_x * (2 * place.x - 1)) +
                          glm::vec3(to_world[1]) * (tan_y * (1 - 2 * place.y)));
}

glm::vec3 floor_along(const Camera& camera, const glm::vec3& way) {
    constexpr float kBehind =
        1.5f; // times as far as the target: a level look meets the floor in the next town
    float away_m = glm::distance(camera.position_m, camera.target_m);
    if (const float to_floor_m = -camera.position_m.z / way.z;
        std::isfinite(to_floor_m) && to_floor_m > 0.0f && to_floor_m < kBehind * away_m)
        away_m = to_floor_m;
    const glm::vec3 place_m = camera.position_m + away_m * way;
    return {place_m.x, place_m.y, 0.0f};
}

} // namespace ghost::scene
