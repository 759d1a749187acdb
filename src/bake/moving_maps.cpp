// SPDX-License-Identifier: Apache-2.0
#include "bake/moving_maps.h"

#include "bake/private/distance_trace.h"
#include "passes/distance_maps.h"
#include "shared/brdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tbb/parallel_for.h>
#include <utility>

namespace ghost::bake {
namespace {

// A beam leaves a lens, not a point, and shadows are soft: it looks beside its cone, too.
constexpr float kBeside_rad = 0.06f;
// So far from the lens the way from the map's place to what is lit is that of the beam, but for kBeside_rad.
constexpr float kFromLens_m = 1.0f;
constexpr float kToCorners = 1.42f; // of a slide and a scanner
constexpr float kTight = 1e-3f;     // rounding: metres, radians
constexpr int kBlock = scene::kDistanceBlock;

std::array<glm::vec3, 8> corners_of(const scene::Box& box) {
    std::array<glm::vec3, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = {k & 1 ? box.high_m.x : box.low_m.x, k & 2 ? box.high_m.y : box.low_m.y,
                      k & 4 ? box.high_m.z : box.low_m.z};
    return corners;
}

} // namespace

bool MovingMaps::Cone::meets(const Cone& other) const {
    const float reach_rad = angle_rad + other.angle_rad;
    return reach_rad >= shared::kPi ||
           std::acos(std::clamp(glm::dot(axis, other.axis), -1.0f, 1.0f)) <= reach_rad;
}

// Its beam from kFromLens_m before the lens on, seen from the map's place.
MovingMaps::Cone MovingMaps::seen_by(const shared::Light& light) {
    const glm::vec3 lens_m = light.off_map_m + light.lens_m * light.axis_w;
    const float ahead_m = glm::dot(lens_m, light.axis_w);
    const float opening = kToCorners * light.tan_field * std::max(light.cut_radius, 1.0f);
    const float beside_m = glm::length(lens_m - ahead_m * light.axis_w) +
                           (light.lens_m + kFromLens_m) * opening + light.disc_radius_m + light.lens_radius_m;
    const float angle_rad =
        std::max(std::atan(opening), std::atan2(beside_m, kFromLens_m + ahead_m)) + kBeside_rad;
    if (!std::isfinite(angle_rad) || light.panel_m > 0) return {};
    return {light.axis_w, angle_rad};
}

// Of a box from a place; everything where the place is inside or near.
MovingMaps::Cone MovingMaps::cone_of(const scene::Box& box, const glm::vec3& from_m) {
    const glm::vec3 way = box.middle_m() - from_m;
    if (!(glm::length(way) > 0.5f * glm::length(box.size_m()) + kTight)) return {};
    const glm::vec3 axis = glm::normalize(way);
    float least = 1.0f;
    for (const glm::vec3& corner : corners_of(box))
        least = std::min(least, glm::dot(axis, glm::normalize(corner - from_m)));
    return {axis, std::acos(std::clamp(least, -1.0f, 1.0f)) + kTight};
}

MovingMaps::MovingMaps(const scene::Stage& stage, int size, const std::vector<glm::vec3>& places_m, Made made)
    : stage_(stage), sight_(size), instances_(stage.instances.size()) {
    if (made == Made::here) tracer_.emplace(stage);
    add_blocks();
    for (const scene::Mesh& mesh : stage.meshes) {
        scene::Box& box = mesh_boxes_.emplace_back();
        for (const glm::vec3& position : mesh.positions)
            if (std::isfinite(position.x + position.y + position.z)) box.add(position);
    }
    for (std::size_t k = 0; k < instances_.size(); ++k) {
        const scene::Instance& instance = stage.instances[k];
        instances_[k] = {instance.world, instance.shown, false, box_of(k, instance.world)};
        if (!instance.shown && tracer_) tracer_->move(k, instance.world, false);
    }
    if (tracer_) tracer_->commit();
    for (const glm::vec3& place_m : places_m)
        maps_.push_back({place_m, std::vector<Texels>(blocks_.size(), Texels::blank), {}});
}

void MovingMaps::add_blocks() {
    const int size = sight_.size();
    for (int y = 0; y < size; y += kBlock)
        for (int x = 0; x < size; x += kBlock) {
            Block block{x, y, std::min(x + kBlock, size), std::min(y + kBlock, size), {glm::vec3(0), 0}};
            std::vector<glm::vec3> ways;
            for (int v = block.y0; v < block.y1; ++v)
                for (int u = block.x0; u < block.x1; ++u)
                    ways.push_back(sight_.directions()[static_cast<std::size_t>(v * size + u)]);
            for (const glm::vec3& way : ways) block.cone.axis += way;
            // What is spread over all of the sphere has no middle.
            const float length = glm::length(block.cone.axis);
            block.cone.axis = length > kTight ? block.cone.axis / length : ways.front();
            float least = 1;
            for (const glm::vec3& way : ways) least = std::min(least, glm::dot(way, block.cone.axis));
            block.cone.angle_rad = std::acos(std::clamp(least, -1.0f, 1.0f)) + kTight;
            blocks_.push_back(block);
        }
}

scene::Box MovingMaps::box_of(std::size_t index, const glm::mat4& world) const {
    scene::Box box;
    const int mesh = stage_.instances[index].mesh;
    if (mesh < 0 || mesh >= static_cast<int>(mesh_boxes_.size())) return box;
    const scene::Box& own = mesh_boxes_[static_cast<std::size_t>(mesh)];
    if (own.is_empty()) return box;
    for (const glm::vec3& corner : corners_of(own)) box.add(glm::vec3(world * glm::vec4(corner, 1.0f)));
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
    std::fill(map.blocks.begin(), map.blocks.end(), Texels::blank);
}

void MovingMaps::outdate(const scene::Box& box) {
    if (box.is_empty()) return;
    tbb::parallel_for(std::size_t{0}, maps_.size(), [&](std::size_t m) {
        Map& map = maps_[m];
        const Cone cone = cone_of(box, map.position_m);
        for (std::size_t b = 0; b < blocks_.size(); ++b)
            if (map.blocks[b] == Texels::right && blocks_[b].cone.meets(cone))
                map.blocks[b] = Texels::outdated;
    });
}

MovingMaps::News MovingMaps::update(const std::vector<shared::Light>& lights) {
    bool has_moved = false;
    for (std::size_t k = 0; k < instances_.size(); ++k) {
        Moved& moved = instances_[k];
        if (!std::exchange(moved.is_new, false)) continue;
        if (tracer_) tracer_->move(k, moved.world, moved.is_shown);
        has_moved = true;
        outdate(moved.box);
        moved.box = box_of(k, moved.world);
        outdate(moved.box);
    }
    if (has_moved && tracer_) tracer_->commit();

    News news;
    std::map<std::size_t, std::vector<int>> wanted;
    for (const shared::Light& light : lights) {
        if (light.map == 0 || light.map > maps_.size() || light.intensity_cd == glm::vec3(0)) continue;
        Map& map = maps_[light.map - 1];
        const Cone cone = seen_by(light);
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            if (map.blocks[b] == Texels::right || !blocks_[b].cone.meets(cone)) continue;
            news.is_seen_by_resting |= map.blocks[b] == Texels::outdated;
            map.blocks[b] = Texels::right;
            wanted[light.map - 1].push_back(static_cast<int>(b));
        }
    }
    for (auto& [index, blocks] : wanted) {
        for (const int block : blocks) {
            const Block& part = blocks_[static_cast<std::size_t>(block)];
            news.rays +=
                static_cast<std::uint64_t>(part.x1 - part.x0) * static_cast<std::uint64_t>(part.y1 - part.y0);
        }
        news.maps.push_back({index, std::move(blocks)});
    }
    if (tracer_) trace(news);
    return news;
}

void MovingMaps::trace(const News& news) {
    struct Task {
        Map* map;
        const Block* block;
    };
    std::vector<Task> tasks;
    for (const auto& [index, blocks] : news.maps) {
        Map& map = maps_[index];
        if (map.distance.empty()) map.distance.assign(sight_.directions().size(), scene::kNoSurface);
        for (const int block : blocks) tasks.push_back({&map, &blocks_[static_cast<std::size_t>(block)]});
    }
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t k) {
        const Block& block = *tasks[k].block;
        Map& map = *tasks[k].map;
        trace_distances(sight_, {block.x0, block.y0, block.x1, block.y1}, map.position_m, *tracer_,
                        map.distance, nullptr);
    });
}

} // namespace ghost::bake
