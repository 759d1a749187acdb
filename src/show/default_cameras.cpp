// SPDX-License-Identifier: Apache-2.0
#include "show/default_cameras.h"
#include "show/show.h"
#include "stage/box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ghost::scene {
namespace {

using glm::vec3;

constexpr float kHouseFov_deg = 40.0f;
constexpr float kRoomFov_deg = 65.0f;
constexpr float kWidestFov_deg = 75.0f;
constexpr float kCloseFov_deg = 60.0f;
constexpr float kHighFov_deg = 45.0f;
constexpr float kAspect = 16.0f / 9.0f;
constexpr float kEye_m = 1.7f;
constexpr float kNear_m = 3.0f;        // what stands nearer hides too much
constexpr float kOpticalDepth = 0.35f; // of the haze between the house and the middle of the stage

// A few that stand far off (a follow spot, a spare part beside the drawing) do not make the picture.
Box most_of(std::vector<vec3> places_m) {
    Box box;
    if (places_m.empty()) return box;
    const std::size_t skipped = places_m.size() / 20;
    for (int k = 0; k < 3; ++k) {
        std::sort(places_m.begin(), places_m.end(),
                  [k](const vec3& a, const vec3& b) { return a[k] < b[k]; });
        box.low_m[k] = places_m[skipped][k];
        box.high_m[k] = places_m[places_m.size() - 1 - skipped][k];
    }
    return box;
}

// The stage for a few rays, without a tree: boxes first.
class Sight {
public:
    explicit Sight(const Stage& stage) : stage_(stage), boxes_(boxes_of(stage)) {}

    const std::vector<Box>& boxes() const { return boxes_; }

    // How far it is to the first surface, at most reach_m; direction is a unit.
    float clear_m(const vec3& from_m, const vec3& direction, float reach_m) const {
        float nearest = reach_m;
        for (std::size_t k = 0; k < boxes_.size(); ++k) {
            if (!stage_.instances[k].shown || !meets(boxes_[k], from_m, direction, nearest)) continue;
            nearest = std::min(nearest, hit(stage_.instances[k], from_m, direction, nearest));
        }
        return nearest;
    }

private:
    static bool meets(const Box& box, const vec3& from, const vec3& direction, float reach) {
        float enter = 0.0f;
        float leave = reach;
        for (int k = 0; k < 3; ++k) {
            if (std::abs(direction[k]) < 1e-9f) {
                if (from[k] < box.low_m[k] || from[k] > box.high_m[k]) return false;
                continue;
            }
            const float a = (box.low_m[k] - from[k]) / direction[k];
            const float b = (box.high_m[k] - from[k]) / direction[k];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return enter <= leave;
    }

    // Moeller and Trumbore 1997, both sides, in the mesh's own space.
    float hit(const Instance& instance, const vec3& from_m, const vec3& direction, float reach) const {
        const glm::mat4 inverse = glm::inverse(instance.world);
        const vec3 from(inverse * glm::vec4(from_m, 1.0f));
        const vec3 way(inverse * glm::vec4(direction, 0.0f)); // not a unit: t stays in world metres
        const Mesh& mesh = stage_.meshes[static_cast<std::size_t>(instance.mesh)];
        for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
            const vec3& a = mesh.positions[mesh.indices[k]];
            const vec3 ab = mesh.positions[mesh.indices[k + 1]] - a;
            const vec3 ac = mesh.positions[mesh.indices[k + 2]] - a;
            const vec3 p = glm::cross(way, ac);
            const float volume = glm::dot(ab, p);
            if (volume == 0.0f) continue;
            const vec3 s = from - a;
            const float u = glm::dot(s, p) / volume;
            const vec3 q = glm::cross(s, ab);
            const float v = glm::dot(way, q) / volume;
            const float t = glm::dot(ac, q) / volume;
            if (u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > 1e-4f && t < reach) reach = t;
        }
        return reach;
    }

    const Stage& stage_;
    std::vector<Box> boxes_;
};

// What the pictures are of: the fixtures and the ground below them, or all that stands there.
Box subject_of(const Show& show, const Sight& sight) {
    std::vector<vec3> places_m;
    for (const PatchedFixture& fixture : show.fixtures)
        for (const vec3& stop_m : fixture.stops_m()) places_m.push_back(stop_m);
    Box things;
    std::vector<vec3> middles_m;
    for (const Box& box : sight.boxes()) {
        if (box.is_empty()) continue;
        things.add(box.low_m);
        things.add(box.high_m);
        middles_m.push_back(box.middle_m());
    }
    Box box = most_of(places_m.empty() ? middles_m : places_m);
    if (box.is_empty()) box = {vec3(-3, -2, 0), vec3(3, 2, 3)};
    // Floors of plots are at zero, unless the whole plot is somewhere else.
    float floor_m = 0.0f;
    if (!things.is_empty() && (things.low_m.z > 1.0f || things.low_m.z < -3.0f))
        floor_m = std::clamp(things.low_m.z, box.low_m.z - 12.0f, box.low_m.z);
    // Fixtures alone: with room for their light below them.
    if (things.is_empty() && (box.low_m.z < 1.0f || box.low_m.z > 20.0f)) floor_m = box.low_m.z - 3.0f;
    box.low_m.z = std::min(box.low_m.z, floor_m);
    if (places_m.size() > 0 && box.low_m.z < floor_m - 0.01f) box.low_m.z = floor_m;
    box.high_m.z = std::max(box.high_m.z + 0.5f, box.low_m.z + 3.5f);
    const vec3 half = 0.5f * glm::max(box.size_m(), vec3(6.0f, 4.0f, 0.0f));
    const vec3 middle = box.middle_m();
    for (int k = 0; k < 2; ++k) {
        box.low_m[k] = middle[k] - half[k];
        box.high_m[k] = middle[k] + half[k];
    }
    return box;
}

Camera camera(const char* name, const vec3& position_m, const vec3& target_m, float fov_y_deg) {
    Camera made;
    made.name = name;
    made.position_m = position_m;
    made.target_m = target_m;
    made.fov_y_deg = fov_y_deg;
    made.auto_exposure = true;
    return made;
}

float half_tangent(float fov_deg) {
    return std::tan(glm::radians(0.5f * fov_deg));
}

// Walls between the place and what is looked at: the camera steps before them. Nothing where that leaves too
// little of the way.
std::optional<vec3> before_walls(const Sight& sight, const vec3& from_m, const vec3& wanted_m) {
    const float way_m = glm::distance(from_m, wanted_m);
    if (way_m < 0.5f) return wanted_m;
    const vec3 direction = (wanted_m - from_m) / way_m;
    const float clear_m = sight.clear_m(from_m, direction, way_m + 0.5f);
    if (clear_m >= way_m + 0.5f) return wanted_m;
    if (clear_m < 0.35f * way_m) return std::nullopt;
    return from_m + direction * std::max(clear_m - 0.5f, 0.2f);
}

// Lights that fill a room leave no place before them: by its front wall, with a wide lens.
Camera in_the_room(const Sight& sight, const Box& box, float eye_z) {
    const vec3 middle = box.middle_m();
    const float half_m = std::max(0.5f * box.size_m().y, 2.0f);
    const float clear_m = sight.clear_m({middle.x, middle.y, eye_z}, vec3(0, -1, 0), half_m + 1.0f);
    const vec3 eye_m(middle.x, middle.y - std::max(clear_m - 0.6f, 0.0f), eye_z);
    return camera("house", eye_m, {middle.x, box.high_m.y, box.low_m.z + 0.5f * box.size_m().z},
                  kRoomFov_deg);
}

// Of nine rays over most of the picture, how many something near stops.
int blocked_rays(const Sight& sight, const vec3& from_m, const vec3& target_m) {
    const vec3 ahead = glm::normalize(target_m - from_m);
    const vec3 right = glm::normalize(glm::cross(ahead, vec3(0, 0, 1)));
    const vec3 up = glm::cross(right, ahead);
    int blocked = 0;
    for (const float x : {-0.4f, 0.0f, 0.4f})
        for (const float y : {-0.2f, 0.0f, 0.25f})
            blocked += sight.clear_m(from_m, glm::normalize(ahead + x * right + y * up), kNear_m) < kNear_m;
    return blocked;
}

// On whatever one can stand on there, left of the middle, looking through the rig; elsewhere at the front
// where a performer or a set piece stands before the lens.
vec3 among_the_lights(const Sight& sight, const Box& box, const vec3& target_m) {
    const vec3 size = box.size_m();
    const float drop_m = std::max(0.6f * size.z, 2.5f);
    vec3 best_m(0.0f);
    int fewest = std::numeric_limits<int>::max();
    for (const float along : {-0.18f, 0.18f, -0.3f, 0.3f, -0.06f, 0.06f}) {
        vec3 eye_m(box.middle_m().x + along * size.x, box.low_m.y + 0.1f * size.y, box.low_m.z + kEye_m);
        const float to_floor_m =
            sight.clear_m({eye_m.x, eye_m.y, box.low_m.z + drop_m}, vec3(0, 0, -1), drop_m + 0.1f);
        if (to_floor_m < drop_m) eye_m.z = box.low_m.z + drop_m - to_floor_m + kEye_m;
        const int blocked = blocked_rays(sight, eye_m, target_m);
        if (blocked < fewest) best_m = eye_m;
        fewest = std::min(fewest, blocked);
        if (fewest == 0) break;
    }
    return best_m;
}

// With all fixtures in the picture, as far as a lens can be that wide.
Camera seeing_all(Camera camera, const Show& show) {
    constexpr float kMargin = 1.06f;
    constexpr float kLeastAhead = 0.3f; // of the way: what is beside the camera no lens brings into it
    const vec3 ahead = glm::normalize(camera.target_m - camera.position_m);
    const vec3 right = glm::normalize(glm::cross(ahead, vec3(0, 0, 1)));
    const vec3 up = glm::cross(right, ahead);
    float tangent = half_tangent(camera.fov_y_deg);
    for (const PatchedFixture& fixture : show.fixtures)
        for (const vec3& stop_m : fixture.stops_m()) {
            const vec3 way = stop_m - camera.position_m;
            const float depth_m = glm::dot(way, ahead);
            if (depth_m < kLeastAhead * glm::length(way)) continue;
            tangent = std::max({tangent, kMargin * std::abs(glm::dot(way, up)) / depth_m,
                                kMargin * std::abs(glm::dot(way, right)) / (kAspect * depth_m)});
        }
    camera.fov_y_deg = std::min(glm::degrees(2 * std::atan(tangent)), kWidestFov_deg);
    return camera;
}

Camera in_the_house(const Sight& sight, const Box& box) {
    const vec3 size = box.size_m();
    const vec3 middle = box.middle_m();
    const float width_m = std::max(size.x / (2.0f * half_tangent(kHouseFov_deg) * kAspect),
                                   size.z / (2.0f * half_tangent(kHouseFov_deg)));
    const float away_m = 1.2f * width_m + 1.0f;

    // A little above the heads, looking at two fifths of the height.
    const float house_z = box.low_m.z + std::clamp(0.25f * size.z, kEye_m, 5.0f);
    const vec3 house_target(middle.x, middle.y, box.low_m.z + 0.5f * size.z);
    const float front_y = box.low_m.y - 0.5f, back_y = box.low_m.y - away_m;
    std::optional<vec3> house_m;
    for (const float lift_m : {0.0f, 1.0f, 2.0f, 3.5f}) { // over who stands in the way
        const float z = house_z + lift_m;
        const auto found_m = before_walls(sight, {middle.x, front_y, z}, {middle.x, back_y, z});
        if (found_m && (!house_m || found_m->y < house_m->y - 0.5f)) house_m = found_m;
        if (house_m && house_m->y <= back_y + 0.01f) break;
    }
    return house_m ? camera("house", *house_m, house_target, kHouseFov_deg)
                   : in_the_room(sight, box, house_z);
}

} // namespace

Camera house_camera(const Show& show, const Stage& stage) {
    const Sight sight(stage);
    return seeing_all(in_the_house(sight, subject_of(show, sight)), show);
}

std::vector<Camera> default_cameras(const Show& show) {
    const Sight sight(show.stage);
    const Box box = subject_of(show, sight);
    const vec3 size = box.size_m();
    const vec3 middle = box.middle_m();
    const vec3 close_target(middle.x + 0.1f * size.x, box.high_m.y, box.low_m.z + 0.5f * size.z);
    const vec3 close = among_the_lights(sight, box, close_target);

    const float reach_m = 0.75f * glm::length(vec3(size.x, size.y, size.z)) + 2.0f;
    const vec3 high_wanted = middle + reach_m * glm::normalize(vec3(-0.75f, -0.95f, 0.55f));
    const vec3 high_from = middle + vec3(0, 0, 0.3f * size.z);
    const vec3 high = before_walls(sight, high_from, high_wanted).value_or(high_wanted);
    return {seeing_all(in_the_house(sight, box), show), camera("close", close, close_target, kCloseFov_deg),
            camera("high", high, {middle.x, middle.y, box.low_m.z + 0.3f * size.z}, kHighFov_deg)};
}

float default_extinction_per_m(const std::vector<Camera>& cameras) {
    if (cameras.empty()) return HazeMedium{}.extinction_per_m;
    const float way_m = glm::distance(cameras.front().position_m, cameras.front().target_m);
    return std::clamp(kOpticalDepth / std::max(way_m, 1.0f), 0.002f, HazeMedium{}.extinction_per_m);
}

} // namespace ghost::scene
