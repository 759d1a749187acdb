#pragma once
// SPDX-License-Identifier: Apache-2.0
// MovingMaps: the distance maps (passes/distance_maps.h) of lights in a stage in which lights and objects
// move all the time. Nothing is on disk: a block of kDistanceBlock texels a side is traced when a beam looks
// through it for the first time since its light, or something that may be seen through it, has moved. World
// metres. One thread, which uses all cores; the stage must outlive it and must not change.
//
// Where somebody else makes them (render/haze/map_drawer.h), it says which blocks are wanted, and no ray is
// traced.

#include "bake/distance_sight.h"
#include "rays/tracer.h"
#include "shared/types.h"
#include "stage/box.h"
#include "stage/stage.h"

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace ghost::bake {

class MovingMaps {
public:
    enum class Made { here, elsewhere };
    // places_m: of each map. Hidden objects of the stage stop nothing.
    MovingMaps(const scene::Stage& stage, int size, const std::vector<glm::vec3>& places_m,
               Made made = Made::here);

    // From the next update on.
    void move(std::size_t instance, const glm::mat4& world);
    void show(std::size_t instance, bool shown);
    void hang(std::size_t map, const glm::vec3& position_m);

    struct Changed {
        std::size_t map = 0;
        std::vector<int> blocks; // row by row
    };
    struct News {
        std::vector<Changed> maps;       // that have other texels
        bool is_seen_by_resting = false; // something moved before a light that may not have changed itself
        std::uint64_t rays = 0;          // texels made
    };
    // What these lights need; Light::map says which is whose.
    News update(const std::vector<shared::Light>& lights);

    const glm::vec3& position_m(std::size_t map) const { return maps_[map].position_m; }
    // Where nothing was needed yet: kNoSurface; empty where they are made elsewhere.
    const std::vector<std::uint16_t>& distance(std::size_t map) const { return maps_[map].distance; }

private:
    struct Cone {
        glm::vec3 axis{0, 0, -1};
        float angle_rad = 4; // everything

        bool meets(const Cone& other) const;
    };
    struct Block {
        int x0, y0, x1, y1; // texels; x1, y1 excluded
        Cone cone;          // round all their directions
    };
    enum class Texels : std::uint8_t { right, blank, outdated };
    struct Map {
        glm::vec3 position_m{0};
        std::vector<Texels> blocks;
        std::vector<std::uint16_t> distance; // empty: never needed
    };
    struct Moved {
        glm::mat4 world{1.0f};
        bool is_shown = true;
        bool is_new = false; // since the last update
        scene::Box box;      // where it was traced
    };
    static Cone seen_by(const shared::Light& light);
    static Cone cone_of(const scene::Box& box, const glm::vec3& from_m);
    void add_blocks();
    scene::Box box_of(std::size_t instance, const glm::mat4& world) const;
    void outdate(const scene::Box& box);
    void trace(const News& news);

    const scene::Stage& stage_;
    const DistanceSight sight_;
    std::vector<Block> blocks_;
    std::optional<Tracer> tracer_; // where they are made here
    std::vector<scene::Box> mesh_boxes_;
    std::vector<Moved> instances_;
    std::vector<Map> maps_;
};

} // namespace ghost::bake
