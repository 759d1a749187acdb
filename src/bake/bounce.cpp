// SPDX-License-Identifier: Apache-2.0
#include "bake/bounce.h"

#include "bake/private/bounce_nodes.h"

#include "passes/passes_file.h"
#include "rays/sampling.h"
#include "reference/reference_beam.h"
#include "shared/octahedral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace ghost::bake {
namespace {

using scene::kNoNode;

constexpr std::array<float, 9> kSizes_m{1, 1.25f, 1.5f, 2, 2.5f, 3, 4, 6, 8};

// Sub-voxels of whole blocks.
double subs_of(const glm::vec3& size_m, double sub_m) {
    double blocks = 1;
    for (int k = 0; k < 3; ++k)
        blocks *= std::ceil(static_cast<double>(size_m[k]) / (sub_m * scene::kSubsOfBlock));
    return blocks * scene::kSubsOfBlock * scene::kSubsOfBlock * scene::kSubsOfBlock;
}

Result<scene::Bounce> made(const Tracer& tracer, const BounceOptions& options) {
    const glm::vec3 size = options.box.high_m - options.box.low_m;
    if (!(size.x > 0 && size.y > 0 && size.z > 0) || !std::isfinite(size.x + size.y + size.z))
        return Error{"there is no room for light to bounce in: neither stage nor lamps", "bounced light"};
    std::vector<float> sizes(kSizes_m.begin(), kSizes_m.end());
    if (options.cell_m > 0) sizes = {options.cell_m};
    // Half of the work may be to find out which size fits.
    const auto known = std::find(sizes.begin(), sizes.end(), options.parts ? options.parts->cell_m() : 0);
    const bool is_known = known != sizes.end();
    if (is_known) sizes.erase(sizes.begin(), known);
    scene::Bounce bounce;
    BounceNodes nodes;
    const Error stopped{"stopped before the links were made", "bounced light"};
    for (const float cell_m : sizes) {
        const double sub_m = static_cast<double>(cell_m) / scene::kSubsOfCell;
        const double subs = static_cast<double>(size.x) * static_cast<double>(size.y) *
                            static_cast<double>(size.z) / (sub_m * sub_m * sub_m);
        const bool last = cell_m == sizes.back();
        const bool is_too_large = subs_of(size, sub_m) > static_cast<double>(scene::kMostBounceSubs);
        if (is_too_large && !last) continue;
        if (is_too_large)
            return Error{"a room of " + std::to_string(static_cast<int>(size.x)) + " x " +
                             std::to_string(static_cast<int>(size.y)) + " x " +
                             std::to_string(static_cast<int>(size.z)) + " m is too large",
                         "bounced light"};
        // Each cell has 64 sub-voxels, but where solids cut it.
        if (!last && subs / 64 > 1.3 * static_cast<double>(options.most_cells)) continue;
        if (!make_bounce_nodes(tracer, options, cell_m, bounce, nodes)) return stopped;
        if (options.cell_m > 0 || last ||
            (bounce.fine.cells.size() <= options.most_cells &&
             bounce.fine.surfels.size() <= options.most_surfels))
            break;
    }
    if (bounce.fine.cells.empty())
        return Error{"no lamp hangs in the air: light has no room to bounce in", "bounced light"};
    if (options.parts && !is_known) options.parts->keep_cell_m(bounce.grid.sub_m * scene::kSubsOfCell);
    if (options.progress) options.progress(kNodesMade);
    if (!make_bounce_links(tracer, options, nodes, bounce)) return stopped;
    if (options.progress) options.progress(1);
    if (options.points)
        for (std::uint32_t s = 0; s < nodes.points_of_surfel.size(); ++s)
            for (const std::uint32_t k : nodes.points_of_surfel[s]) {
                const SurfacePoint& point = nodes.points[k];
                options.points->push_back({s, point.instance, point.area_m2, point.albedo});
            }
    return bounce;
}

} // namespace

Result<scene::Bounce> make_bounce(const Tracer& tracer, const BounceOptions& options) {
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    Result<scene::Bounce> bounce = Error{"", ""};
    arena.execute([&] { bounce = made(tracer, options); });
    return bounce;
}

SurfelIndex::SurfelIndex(const scene::Bounce& bounce) : bounce_(bounce) {
    const glm::ivec3 voxels = bounce.grid.voxels(scene::kSubsOfSurfel);
    const std::size_t count = static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y) *
                              static_cast<std::size_t>(voxels.z);
    first_.assign(count + 1, 0);
    for (const scene::BounceSurfel& surfel : bounce.fine.surfels) ++first_[surfel.voxel + 1];
    for (std::size_t k = 0; k < count; ++k) first_[k + 1] += first_[k];
    list_.resize(bounce.fine.surfels.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < bounce.fine.surfels.size(); ++k)
        list_[next[bounce.fine.surfels[k].voxel]++] = k;
}

std::uint32_t SurfelIndex::surfel_at(const glm::vec3& place_m, const glm::vec3& normal,
                                     std::uint32_t cell) const {
    constexpr float kPerSquare = 0.02f, kGoodEnough = 0.5f, kNextVoxel = 0.5f, kSameBlock = 0.5f;
    const float sub_m = bounce_.grid.sub_m;
    const auto side = static_cast<std::uint32_t>(scene::bounce_side(normal));
    std::uint32_t found = kNoNode;
    float best = -1e9f;
    const auto look = [&](int voxel, float base) {
        for (std::uint32_t k = first_[static_cast<std::size_t>(voxel)];
             k < first_[static_cast<std::size_t>(voxel) + 1]; ++k) {
            const scene::BounceSurfel& surfel = bounce_.fine.surfels[list_[k]];
            float score = base + glm::dot(normal, surfel.normal) + (surfel.side == side ? 1.0f : 0.0f);
            if (cell != kNoNode) {
                if (surfel.cell == cell)
                    score += 1;
                else if (bounce_.fine.cells[surfel.cell].block == bounce_.fine.cells[cell].block)
                    score += kSameBlock;
            }
            const glm::vec3 off = place_m - surfel.place_m;
            score -= kPerSquare * glm::dot(off, off) / (sub_m * sub_m);
            if (score > best) {
                best = score;
                found = list_[k];
            }
        }
    };
    const glm::ivec3 voxels = bounce_.grid.voxels(scene::kSubsOfSurfel);
    const int home = bounce_.grid.voxel_at(place_m + normal * (0.01f * sub_m), scene::kSubsOfSurfel);
    look(home, 0);
    if (found != kNoNode && best > kGoodEnough) return found;
    const glm::ivec3 at(home % voxels.x, home / voxels.x % voxels.y, home / voxels.x / voxels.y);
    for (int k = 0; k < 27; ++k) {
        const int row = k / 3;
        const glm::ivec3 to = at + glm::ivec3(k % 3, row % 3, row / 3) - 1;
        if (glm::any(glm::lessThan(to, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(to, voxels)))
            continue;
        look((to.z * voxels.y + to.y) * voxels.x + to.x, -kNextVoxel);
    }
    return found;
}

scene::LampSight lamp_sight(const Tracer& tracer, const scene::Bounce& bounce, const SurfelIndex& index,
                            const glm::vec3& position_m, int size) {
    constexpr float kFar_m = 1e4f;
    scene::LampSight sight;
    sight.position_m = position_m;
    sight.size = size;
    sight.surfel.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), kNoNode);
    sight.distance_m.assign(sight.surfel.size(), 0);
    sight.albedo.assign(sight.surfel.size(), 0);
    const auto texels = static_cast<float>(size);
    tbb::parallel_for(0, size, [&](int y) {
        const DenormalsOff mode;
        for (int x = 0; x < size; ++x) {
            const glm::vec3 way = shared::direction_from_octahedral(
                {(static_cast<float>(x) + 0.5f) / texels, (static_cast<float>(y) + 0.5f) / texels});
            const Tracer::Meeting meeting = tracer.meet(position_m, way, kFar_m);
            if (meeting.instance < 0) continue;
            const auto texel = static_cast<std::size_t>(y * size + x);
            const glm::vec3 place_m = position_m + way * meeting.distance_m;
            sight.distance_m[texel] = scene::to_half(std::max(meeting.distance_m, 1e-3f));
            // Not of the other side of a wall that cuts its sub-voxel.
            const glm::vec3 before_m = place_m + meeting.normal * (0.4f * bounce.grid.sub_m);
            const int sub = bounce.grid.sub_at(before_m);
            const bool is_its = sub >= 0 && sees(tracer, before_m, bounce.grid.sub_centre_m(sub));
            const std::uint32_t cell = is_its ? bounce.cell_of[static_cast<std::size_t>(sub)] : kNoNode;
            sight.surfel[texel] = index.surfel_at(place_m, meeting.normal, cell);
            const Surface surface = tracer.first_hit(
                position_m, way, to_unit(hash_u32(static_cast<std::uint32_t>(texel), 3)), Sees::no_bodies);
            if (surface.instance < 0) continue;
            const double cosine = -glm::dot(glm::dvec3(surface.facet_normal), glm::dvec3(way));
            sight.albedo[texel] =
                scene::packed_albedo(glm::vec3(reference_brdf_albedo(surface.brdf, cosine)));
        }
    });
    return sight;
}

} // namespace ghost::bake
