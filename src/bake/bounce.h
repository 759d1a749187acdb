#pragma once
// SPDX-License-Identifier: Apache-2.0
// Makes scene::Bounce of a stage: a flood from the lamps tells air from the insides of solids; what of a
// voxel is joined through air is a cell; surfaces become surfels of the voxel, the side they face and the
// cell before them; rays from each of them become links. Fixture bodies take no part. Any thread; uses all
// cores; the same stage gives the same bytes on any number of threads.

#include "base/result.h"
#include "bounce/bounce.h"
#include "bounce/bounce_box.h"
#include "bounce/bounce_parts.h"
#include "rays/tracer.h"

#include <functional>
#include <memory>
#include <vector>

namespace ghost::bake {

// A part of a surface that a surfel stands for.
struct BouncePoint {
    std::uint32_t surfel = 0;
    std::uint32_t instance = 0; // of the stage
    float area_m2 = 0;
    glm::vec3 albedo{0};
};

struct BounceOptions {
    scene::BounceBox box;
    std::vector<glm::vec3> seeds_m; // places in the air: lamps, cameras
    float cell_m = 0;               // 0: as fine as the limits below allow, from 1 m on
    std::size_t most_surfels = 18'000;
    std::size_t most_cells = 8'000;
    int rays_of_surfel = 256;
    int rays_of_cell = 512;
    int rays_of_block = 2048;
    int threads = 0;                            // 0: one per core
    std::vector<BouncePoint>* points = nullptr; // filled for measurements
    scene::BounceParts* parts = nullptr;        // what a stopped one left is taken up, and kept for the next
    std::function<bool()> stop;                 // asked from any thread
    std::function<void(double fraction)> progress; // never two calls at once
};

// Error: stopped; no room at all (an empty box, or seeds that are all in solids).
Result<scene::Bounce> make_bounce(const Tracer& tracer, const BounceOptions& options);

// Finds surfels. The bounce must outlive it.
class SurfelIndex {
public:
    explicit SurfelIndex(const scene::Bounce& bounce);
    // That a surface belongs to; cell: of the air before it or kNoNode. kNoNode: there is none near.
    std::uint32_t surfel_at(const glm::vec3& place_m, const glm::vec3& normal, std::uint32_t cell) const;

private:
    const scene::Bounce& bounce_;
    std::vector<std::uint32_t> first_; // of each voxel, in list_
    std::vector<std::uint32_t> list_;
};

// What light from there lands on; size: texels a side.
scene::LampSight lamp_sight(const Tracer& tracer, const scene::Bounce& bounce, const SurfelIndex& index,
                            const glm::vec3& position_m, int size = scene::kLampSightSize);

} // namespace ghost::bake
