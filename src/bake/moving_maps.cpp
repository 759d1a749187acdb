// SPDX-License-Identifier: Apache-2.0
#include "bake/moving_maps.h"

#include "bake/private/distance_trace.h"
#include "passes/distance_maps.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>
#include <utility>

namespace ghost::bake {
namespace {

// A beam leaves a lens, not a point, and shadows are soft: it looks through tiles beside its cone, too.
constexpr float kBeside_rad = 0.12f;
// So far from the lens the way from the map's place to what is lit is that of the beam, but for kBeside_rad.
constexpr float kFromLens_m = 1.0f;
constexpr float kAll_rad = 3.2f;

struct Cone {
    glm::vec3 axis{0, 0, -1};
    float angle_rad = kAll_rad;
};

Cone seen_by(const shared::Light& light) {
    const float opening = light.tan_field * std::max(light.cut_radius, 1.0f);
    // A slide and a scanner reach into corners.
    const float corner_rad = std::atan(1.42f * opening);
    const float lens_m =
        glm::length(light.off_map_m) + light.lens_m * opening + light.disc_radius_m + light.lens_radius_m;
    const float beside_rad = kBeside_rad + std::atan(lens_m / kFromLens_m);
    if (!std::isfinite(corner_rad + beside_rad) || light.panel_m > 0) return {};
    return {light.axis_w, corner_rad + beside_rad};
}

// Of a box from a place; everything where the place is inside.
Cone cone_of(const scene::Box& box, const glm::vec3& from_m) {
    const glm::vec3 way = box.middle_m() - from_m;
    const float away_m = glm::length(way), radius_m = 0.5f * glm::length(box.size_m()) + 1e-3f;
    if (!(away_m > radius_m)) return {};
    const glm::vec3 axis = way / away_m;
    if (box.holds(from_m)) return {};
    // The corners say it closer than the ball.
    float least = 1.0f;
    for (int k = 0; k < 8; ++k) {
        const glm::vec3 corner(k & 1 ? box.high_m.x : box.low_m.x, k & 2 ? box.high_m.y : box.low_m.y,
                               k & 4 ? box.high_m.z : box.low_m.z);
        const glm::vec3 to = corner - from_m;
        least = std::min(least, glm::dot(axis, to) / std::max(glm::length(to), 1e-6f));
    }
    return {axis, std::acos(std::clamp(least, -1.0f, 1.0f)) + 1e-3f};
}

bool meets(const DistanceSight::Tile& tile, const Cone& cone) {
    return cone.angle_rad >= kAll_rad || tile.meets(cone.axis, cone.angle_rad);
}

} // namespace

MovingMaps::MovingMaps(const scene::Stage& stage, int size, const std::vector<glm::vec3>& places_m)
    : stage_(stage), sight_(size), tracer_(stage), instances_(stage.instances.size()) {
    for (const scene::Mesh& mesh : stage.meshes) {
        scene::Box& box = mesh_boxes_.emplace_back();
        for (const glm::vec3& position : mesh.positions)
            if (std::isfinite(position.x + position.y + position.z)) box.add(position);
    }
    for (std::size_t k = 0; k < instances_.size(); ++k) {
        const scene::Instance& instance = stage.instances[k];
        instances_[k] = {instance.world, instance.shown, false, box_of(k, instance.world)};
        if (!instance.shown) tracer_.move(k, instance.world, false);
    }
    tracer_.commit();
    for (const glm::vec3& place_m : places_m)
        maps_.push_back({place_m, std::vector<Texels>(sight_.tiles().size(), Texels::blank), {}});
}

scene::Box MovingMaps::box_of(std::size_t index, const glm::mat4& world) const {
    scene::Box box;
    const scene::Instance& instance = stage_.instances[index];
    if (instance.mesh < 0 || instance.mesh >= static_cast<int>(mesh_boxes_.size())) return box;
    const scene::Box& own = mesh_boxes_[static_cast<std::size_t>(instance.mesh)];
    if (own.is_empty()) return box;
    for (int k = 0; k < 8; ++k)
        box.add(glm::vec3(world * glm::vec4(k & 1 ? own.high_m.x : own.low_m.x,
                                            k & 2 ? own.high_m.y : own.low_m.y,
                                            k & 4 ? own.high_m.z : own.low_m.z, 1.0f)));
    return box;
}

void MovingMaps::move(std::size_t instance, const glm::mat4& world) {
    Moved& moved = instances_[instance];
    if (moved.world == world) return;
    moved.world = world;
    moved.is_new = true;
}

void MovingMaps::show(std::size_t instance, bool shown) {
    Moved& moved = instances_[instance];
    if (std::exchange(moved.is_shown, shown) != shown) moved.is_new = true;
}

void MovingMaps::hang(std::size_t index, const glm::vec3& position_m) {
    Map& map = maps_[index];
    if (map.position_m == position_m) return;
    map.position_m = position_m;
    std::fill(map.tiles.begin(), map.tiles.end(), Texels::blank);
}

void MovingMaps::outdate(const scene::Box& box) {
    if (box.is_empty()) return;
    tbb::parallel_for(std::size_t{0}, maps_.size(), [&](std::size_t m) {
        Map& map = maps_[m];
        const Cone cone = cone_of(box, map.position_m);
        for (std::size_t t = 0; t < map.tiles.size(); ++t)
            if (map.tiles[t] == Texels::right && meets(sight_.tiles()[t], cone))
                map.tiles[t] = Texels::outdated;
    });
}

MovingMaps::News MovingMaps::update(const std::vector<shared::Light>& lights) {
    bool has_moved = false;
    for (std::size_t k = 0; k < instances_.size(); ++k) {
        Moved& moved = instances_[k];
        if (!std::exchange(moved.is_new, false)) continue;
        tracer_.move(k, moved.world, moved.is_shown);
        has_moved = true;
        outdate(moved.box);
        moved.box = box_of(k, moved.world);
        outdate(moved.box);
    }
    if (has_moved) tracer_.commit();

    struct Task {
        std::size_t map, tile;
    };
    std::vector<Task> tasks;
    News news;
    for (const shared::Light& light : lights) {
        if (light.map == 0 || light.map > maps_.size() || light.intensity_cd == glm::vec3(0)) continue;
        Map& map = maps_[light.map - 1];
        const Cone cone = seen_by(light);
        const std::size_t before = tasks.size();
        for (std::size_t t = 0; t < map.tiles.size(); ++t) {
            if (map.tiles[t] == Texels::right || !meets(sight_.tiles()[t], cone)) continue;
            news.is_seen_by_resting |= map.tiles[t] == Texels::outdated;
            map.tiles[t] = Texels::right;
            tasks.push_back({light.map - 1, t});
        }
        if (tasks.size() == before) continue;
        if (map.distance.empty()) map.distance.assign(sight_.directions().size(), scene::kNoSurface);
        news.maps.push_back(light.map - 1);
    }
    std::sort(news.maps.begin(), news.maps.end());
    news.maps.erase(std::unique(news.maps.begin(), news.maps.end()), news.maps.end());
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t k) {
        const DistanceSight::Tile& tile = sight_.tiles()[tasks[k].tile];
        Map& map = maps_[tasks[k].map];
        trace_distances(sight_, {tile.x0, tile.y0, tile.x1, tile.y1}, map.position_m, tracer_, map.distance,
                        nullptr);
    });
    for (const Task& task : tasks) {
        const DistanceSight::Tile& tile = sight_.tiles()[task.tile];
        news.rays +=
            static_cast<std::uint64_t>(tile.x1 - tile.x0) * static_cast<std::uint64_t>(tile.y1 - tile.y0);
    }
    return news;
}

} // namespace ghost::bake
