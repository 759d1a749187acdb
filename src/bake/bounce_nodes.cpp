// SPDX-License-Identifier: Apache-2.0
#include "bake/private/bounce_nodes.h"

#include "rays/sampling.h"
#include "reference/reference_beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <tbb/parallel_for.h>
#include <tuple>

namespace ghost::bake {
namespace {

using scene::kNoNode;
using Lists = std::vector<std::vector<std::uint32_t>>;

constexpr float kSmallCell = 0.12f; // of a voxel: such parts join what they see
constexpr float kSmallBlock = 0.04f;
constexpr float kSmallSide = 0.1f; // of a voxel's face: such sides join the voxel's largest
constexpr int kJoinRounds = 8;
constexpr float kSkin_m = 2e-3f;        // before a surface
constexpr std::size_t kLeastPoints = 4; // of an instance: small round things reflect, too
constexpr std::size_t kMostPoints = 4'000'000;
constexpr std::uint32_t kWays = 32; // of light in and out, by which the albedo of a point is told

// Which neighbouring sub-voxels see each other, and which of them are in the room.
class Air {
public:
    Air(const Tracer& tracer, const BounceOptions& options, const scene::BounceGrid& grid)
        : grid_(grid), open_(grid.count(), 0), room_(grid.count(), 0) {
        const auto count = static_cast<int>(grid.count());
        constexpr int kBand = 4096;
        tbb::parallel_for(0, (count + kBand - 1) / kBand, [&](int band) {
            if (options.stop && options.stop()) return;
            const DenormalsOff mode;
            for (int i = band * kBand; i < std::min((band + 1) * kBand, count); ++i) look(tracer, i);
        });
        for (const glm::vec3& seed : options.seeds_m) flood(grid.sub_at(seed));
        for (int i = 0; i < count; ++i) {
            const glm::vec3 centre = grid.sub_centre_m(i);
            for (int k = 0; k < 3; ++k)
                if (centre[k] < options.box.low_m[k] || centre[k] > options.box.high_m[k])
                    room_[static_cast<std::size_t>(i)] = 0;
        }
    }

    bool has(int sub) const { return room_[static_cast<std::size_t>(sub)] != 0; }

    template <class Use>
    void neighbours(int i, const Use& use) const {
        const int nx = grid_.subs.x, layer = nx * grid_.subs.y;
        const auto open = [&](int k, int bit) { return (open_[static_cast<std::size_t>(k)] & bit) != 0; };
        if (open(i, 1)) use(i + 1);
        if (open(i, 2)) use(i + nx);
        if (open(i, 4)) use(i + layer);
        if (i % nx > 0 && open(i - 1, 1)) use(i - 1);
        if (i / nx % grid_.subs.y > 0 && open(i - nx, 2)) use(i - nx);
        if (i / layer > 0 && open(i - layer, 4)) use(i - layer);
    }

    // Parts of voxels that are joined through air; those below the least fraction of a voxel join a
    // neighbour. Gives each sub-voxel its part.
    Lists parts(int of_subs, float least, std::vector<std::uint32_t>& label) const {
        const auto count = static_cast<int>(grid_.count());
        label.assign(grid_.count(), kNoNode);
        Lists list;
        std::vector<int> stack;
        for (int i = 0; i < count; ++i) {
            if (!has(i) || label[static_cast<std::size_t>(i)] != kNoNode) continue;
            const auto id = static_cast<std::uint32_t>(list.size());
            const int voxel = grid_.voxel_at(grid_.sub_centre_m(i), of_subs);
            list.emplace_back();
            stack = {i};
            label[static_cast<std::size_t>(i)] = id;
            while (!stack.empty()) {
                const int sub = stack.back();
                stack.pop_back();
                list[id].push_back(static_cast<std::uint32_t>(sub));
                neighbours(sub, [&](int k) {
                    if (!has(k) || label[static_cast<std::size_t>(k)] != kNoNode ||
                        grid_.voxel_at(grid_.sub_centre_m(k), of_subs) != voxel)
                        return;
                    label[static_cast<std::size_t>(k)] = id;
                    stack.push_back(k);
                });
            }
        }
        const auto whole = static_cast<float>(of_subs * of_subs * of_subs);
        std::vector<std::uint32_t> small;
        for (std::uint32_t id = 0; id < list.size(); ++id)
            if (static_cast<float>(list[id].size()) < least * whole) small.push_back(id);
        for (int round = 0; round < kJoinRounds; ++round)
            for (const std::uint32_t id : small) join_neighbour(id, list, label);
        return list;
    }

private:
    void look(const Tracer& tracer, int i) {
        const int x = i % grid_.subs.x, y = i / grid_.subs.x % grid_.subs.y,
                  z = i / grid_.subs.x / grid_.subs.y;
        const glm::vec3 centre = grid_.sub_centre_m(i);
        const auto open = [&](const glm::vec3& step) {
            return sees(tracer, centre, centre + step * grid_.sub_m);
        };
        int bits = 0;
        if (x + 1 < grid_.subs.x && open({1, 0, 0})) bits |= 1;
        if (y + 1 < grid_.subs.y && open({0, 1, 0})) bits |= 2;
        if (z + 1 < grid_.subs.z && open({0, 0, 1})) bits |= 4;
        open_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(bits);
    }

    void flood(int from) {
        if (from < 0 || has(from)) return;
        std::vector<int> stack{from};
        room_[static_cast<std::size_t>(from)] = 1;
        while (!stack.empty()) {
            const int sub = stack.back();
            stack.pop_back();
            neighbours(sub, [&](int k) {
                if (has(k)) return;
                room_[static_cast<std::size_t>(k)] = 1;
                stack.push_back(k);
            });
        }
    }

    void join_neighbour(std::uint32_t id, Lists& list, std::vector<std::uint32_t>& label) const {
        std::uint32_t to = kNoNode;
        for (const std::uint32_t sub : list[id])
            neighbours(static_cast<int>(sub), [&](int k) {
                const std::uint32_t other = label[static_cast<std::size_t>(k)];
                if (other == kNoNode || other == id) return;
                if (to == kNoNode || list[other].size() > list[to].size()) to = other;
            });
        if (to == kNoNode) return;
        for (const std::uint32_t sub : list[id]) {
            label[sub] = to;
            list[to].push_back(sub);
        }
        list[id].clear();
    }

    const scene::BounceGrid& grid_;
    std::vector<std::uint8_t> open_; // bits: the next one along x, y, z is seen
    std::vector<std::uint8_t> room_;
};

// Cells of the parts that are left; the labels become their numbers.
void make_cells(const scene::BounceGrid& grid, int of_subs, Lists& parts, std::vector<std::uint32_t>& label,
                std::vector<scene::BounceCell>& cells, Lists& subs) {
    std::vector<std::uint32_t> number(parts.size(), kNoNode);
    for (std::size_t id = 0; id < parts.size(); ++id) {
        if (parts[id].empty()) continue;
        scene::BounceCell cell;
        const auto count = static_cast<float>(parts[id].size());
        for (const std::uint32_t sub : parts[id])
            cell.centre_m += grid.sub_centre_m(static_cast<int>(sub)) / count;
        cell.volume_m3 = count * grid.sub_m * grid.sub_m * grid.sub_m;
        cell.voxel = static_cast<std::uint32_t>(
            grid.voxel_at(grid.sub_centre_m(static_cast<int>(parts[id][0])), of_subs));
        number[id] = static_cast<std::uint32_t>(cells.size());
        cells.push_back(cell);
        subs.push_back(std::move(parts[id]));
    }
    for (std::uint32_t& part : label)
        if (part != kNoNode) part = number[part];
}

// Both sides of all surfaces, spread evenly over each instance.
std::vector<SurfacePoint> points_on(const scene::Stage& stage, float spacing_m) {
    struct Part {
        std::size_t instance;
        double area;
        std::vector<double> sums; // of its triangles
    };
    std::vector<Part> all;
    double total = 0;
    for (std::size_t k = 0; k < stage.instances.size(); ++k) {
        const scene::Instance& instance = stage.instances[k];
        if (instance.fixture != scene::kNone || instance.mesh < 0 ||
            instance.mesh >= static_cast<int>(stage.meshes.size()))
            continue;
        const scene::Mesh& mesh = stage.meshes[static_cast<std::size_t>(instance.mesh)];
        Part part{k, 0, {}};
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
            glm::vec3 corner[3];
            for (std::size_t c = 0; c < 3; ++c)
                corner[c] = glm::vec3(instance.world * glm::vec4(mesh.positions[mesh.indices[t + c]], 1));
            const float area = 0.5f * glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
            part.area += std::isfinite(area) ? static_cast<double>(area) : 0.0;
            part.sums.push_back(part.area);
        }
        if (!(part.area > 0) || part.area > 1e9) continue;
        total += part.area;
        all.push_back(std::move(part));
    }
    const double each = std::max(static_cast<double>(spacing_m) * static_cast<double>(spacing_m),
                                 total / static_cast<double>(kMostPoints));
    std::vector<SurfacePoint> points;
    BounceRandom random(11);
    for (const Part& part : all) {
        const scene::Instance& instance = stage.instances[part.instance];
        const scene::Mesh& mesh = stage.meshes[static_cast<std::size_t>(instance.mesh)];
        const std::size_t count = std::max(kLeastPoints, static_cast<std::size_t>(part.area / each));
        std::size_t t = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double at = (static_cast<double>(i) + static_cast<double>(random())) /
                              static_cast<double>(count) * part.area;
            while (t + 1 < part.sums.size() && part.sums[t] < at) ++t;
            glm::vec3 corner[3];
            for (std::size_t c = 0; c < 3; ++c)
                corner[c] = glm::vec3(instance.world * glm::vec4(mesh.positions[mesh.indices[3 * t + c]], 1));
            const float u = std::sqrt(random()), v = random();
            SurfacePoint point;
            point.place_m = corner[0] * (1 - u) + corner[1] * (u * (1 - v)) + corner[2] * (u * v);
            point.normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
            const float length = glm::length(point.normal);
            if (!(length > 0) || !std::isfinite(length)) continue;
            point.normal /= length;
            point.area_m2 = static_cast<float>(part.area / static_cast<double>(count));
            point.instance = static_cast<std::uint32_t>(part.instance);
            points.push_back(point);
            point.normal = -point.normal;
            points.push_back(point);
        }
    }
    return points;
}

// Fraction of even light that leaves again, everywhere.
glm::vec3 albedo_of(const shared::Brdf& brdf, std::uint32_t seed) {
    const glm::vec3 up(0, 0, 1);
    glm::dvec3 sum(0);
    for (std::uint32_t k = 0; k < kWays; ++k) {
        const glm::dvec3 in(cosine_direction(up, sobol_2d(k, seed))),
            out(cosine_direction(up, sobol_2d(k, hash_u32(seed, 1))));
        if (out.z > 0)
            sum += reference_brdf_times_cosine(brdf, glm::dvec3(up), in, out) * (glm::pi<double>() / out.z);
    }
    return glm::clamp(glm::vec3(sum / static_cast<double>(kWays)), 0.0f, 1.0f);
}

// Finds the albedo of a point and the cell before it; false: it is in a solid, or in a hole of its surface.
bool settle(const Tracer& tracer, const scene::Bounce& bounce, const scene::BounceBox& box,
            std::uint32_t seed, SurfacePoint& point) {
    const scene::BounceGrid& grid = bounce.grid;
    const glm::vec3 before_m = point.place_m + point.normal * kSkin_m;
    for (int k = 0; k < 3; ++k)
        if (before_m[k] < box.low_m[k] - 0.01f || before_m[k] > box.high_m[k] + 0.01f) return false;
    int home = grid.sub_at(before_m + point.normal * (0.5f * grid.sub_m));
    if (home < 0) home = grid.sub_at(before_m);
    if (home < 0) return false;
    const glm::ivec3 at(home % grid.subs.x, home / grid.subs.x % grid.subs.y,
                        home / grid.subs.x / grid.subs.y);
    std::vector<std::pair<float, int>> near;
    for (int k = 0; k < 27; ++k) {
        const int row = k / 3;
        const glm::ivec3 to = at + glm::ivec3(k % 3, row % 3, row / 3) - 1;
        if (glm::any(glm::lessThan(to, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(to, grid.subs)))
            continue;
        const int sub = (to.z * grid.subs.y + to.y) * grid.subs.x + to.x;
        if (bounce.cell_of[static_cast<std::size_t>(sub)] == kNoNode) continue;
        const glm::vec3 way = grid.sub_centre_m(sub) - before_m;
        if (glm::dot(way, point.normal) > 0) near.emplace_back(glm::length(way), sub);
    }
    std::sort(near.begin(), near.end());
    for (const auto& [distance, sub] : near) {
        if (!sees(tracer, before_m, grid.sub_centre_m(sub))) continue;
        point.cell = bounce.cell_of[static_cast<std::size_t>(sub)];
        break;
    }
    if (point.cell == kNoNode) return false;
    const Surface surface =
        tracer.first_hit(before_m, -point.normal, to_unit(hash_u32(seed, 3)), Sees::no_bodies);
    if (surface.instance < 0 || surface.distance_m > 2 * kSkin_m) return false;
    point.albedo = albedo_of(surface.brdf, hash_u32(seed, 5));
    return true;
}

// Points by voxel, cell before them and side.
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
using Bags = std::map<Key, std::vector<std::uint32_t>>;

float area_of(const std::vector<SurfacePoint>& points, const std::vector<std::uint32_t>& bag) {
    float sum = 0;
    for (const std::uint32_t k : bag) sum += points[k].area_m2;
    return sum;
}

// Small sides of a voxel and cell join the largest one. moved: the key that each one has now.
void join_sides(const std::vector<SurfacePoint>& points, float face_m2, Bags& bags,
                std::map<Key, Key>& moved) {
    for (auto first = bags.begin(); first != bags.end();) {
        auto end = first;
        auto largest = first;
        const auto same = [&](const Key& key) {
            return std::get<0>(key) == std::get<0>(first->first) &&
                   std::get<1>(key) == std::get<1>(first->first);
        };
        for (; end != bags.end() && same(end->first); ++end)
            if (area_of(points, end->second) > area_of(points, largest->second)) largest = end;
        for (auto bag = first; bag != end;) {
            const bool joins = bag != largest && area_of(points, bag->second) < kSmallSide * face_m2;
            moved[bag->first] = joins ? largest->first : bag->first;
            if (!joins) {
                ++bag;
                continue;
            }
            largest->second.insert(largest->second.end(), bag->second.begin(), bag->second.end());
            bag = bags.erase(bag);
        }
        first = end;
    }
}

void make_surfels(const std::vector<SurfacePoint>& points, const Bags& bags,
                  std::vector<scene::BounceSurfel>& surfels, Lists& lists) {
    for (const auto& [key, bag] : bags) {
        scene::BounceSurfel surfel;
        std::tie(surfel.voxel, surfel.cell, surfel.side) = key;
        for (const std::uint32_t k : bag) {
            surfel.area_m2 += points[k].area_m2;
            surfel.place_m += points[k].place_m * points[k].area_m2;
            surfel.normal += points[k].normal * points[k].area_m2;
            surfel.albedo += points[k].albedo * points[k].area_m2;
        }
        surfel.place_m /= surfel.area_m2;
        surfel.albedo /= surfel.area_m2;
        const float length = glm::length(surfel.normal);
        surfel.normal = length > 0 ? surfel.normal / length : points[bag[0]].normal;
        surfels.push_back(surfel);
        lists.push_back(bag);
    }
}

} // namespace

bool make_bounce_nodes(const Tracer& tracer, const BounceOptions& options, float cell_m,
                       scene::Bounce& bounce, BounceNodes& nodes) {
    bounce = {};
    nodes = {};
    scene::BounceGrid& grid = bounce.grid;
    grid.low_m = options.box.low_m;
    grid.sub_m = cell_m / scene::kSubsOfCell;
    const glm::vec3 blocks = (options.box.high_m - options.box.low_m) / (grid.sub_m * scene::kSubsOfBlock);
    grid.subs = glm::max(glm::ivec3(glm::ceil(blocks)), 1) * scene::kSubsOfBlock;
    const auto stopped = [&] { return options.stop && options.stop(); };

    const Air air(tracer, options, grid);
    if (stopped()) return false;
    Lists cells = air.parts(scene::kSubsOfCell, kSmallCell, bounce.cell_of);
    make_cells(grid, scene::kSubsOfCell, cells, bounce.cell_of, bounce.fine.cells, nodes.subs_of_cell);
    std::vector<std::uint32_t> block_of;
    Lists blocks_parts = air.parts(scene::kSubsOfBlock, kSmallBlock, block_of);
    make_cells(grid, scene::kSubsOfBlock, blocks_parts, block_of, bounce.coarse.cells, nodes.subs_of_block);
    for (std::size_t c = 0; c < bounce.fine.cells.size(); ++c) { // the block that has most of it
        std::map<std::uint32_t, std::size_t> votes;
        for (const std::uint32_t sub : nodes.subs_of_cell[c]) ++votes[block_of[sub]];
        std::size_t most = 0;
        for (const auto& [block, count] : votes)
            if (count > most) {
                most = count;
                bounce.fine.cells[c].block = block;
            }
    }

    std::vector<SurfacePoint> points = points_on(tracer.stage(), 0.5f * grid.sub_m);
    std::vector<std::uint8_t> kept(points.size(), 0);
    tbb::parallel_for(std::size_t{0}, (points.size() + 255) / 256, [&](std::size_t band) {
        if (stopped()) return;
        const DenormalsOff mode;
        for (std::size_t k = band * 256; k < std::min((band + 1) * 256, points.size()); ++k)
            kept[k] = settle(tracer, bounce, options.box, static_cast<std::uint32_t>(k), points[k]) ? 1 : 0;
    });
    if (stopped()) return false;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (kept[k] != 0) nodes.points.push_back(points[k]);

    Bags surfels, clusters;
    std::map<Key, Key> joined, moved;
    const auto voxel_of = [&](const glm::vec3& place_m, const glm::vec3& normal, int of_subs) {
        return static_cast<std::uint32_t>(grid.voxel_at(place_m + normal * (0.01f * grid.sub_m), of_subs));
    };
    for (std::uint32_t k = 0; k < nodes.points.size(); ++k) {
        const SurfacePoint& point = nodes.points[k];
        surfels[{voxel_of(point.place_m, point.normal, scene::kSubsOfSurfel), point.cell,
                 static_cast<std::uint32_t>(scene::bounce_side(point.normal))}]
            .push_back(k);
    }
    const float face_m = grid.sub_m * scene::kSubsOfSurfel;
    join_sides(nodes.points, face_m * face_m, surfels, joined);
    make_surfels(nodes.points, surfels, bounce.fine.surfels, nodes.points_of_surfel);
    std::vector<Key> keys;
    for (std::size_t f = 0; f < bounce.fine.surfels.size(); ++f) {
        const scene::BounceSurfel& surfel = bounce.fine.surfels[f];
        keys.emplace_back(voxel_of(surfel.place_m, surfel.normal, scene::kSubsOfBlock),
                          bounce.fine.cells[surfel.cell].block, surfel.side);
        std::vector<std::uint32_t>& cluster = clusters[keys.back()];
        cluster.insert(cluster.end(), nodes.points_of_surfel[f].begin(), nodes.points_of_surfel[f].end());
    }
    const float block_m = grid.sub_m * scene::kSubsOfBlock;
    join_sides(nodes.points, block_m * block_m, clusters, moved);
    make_surfels(nodes.points, clusters, bounce.coarse.surfels, nodes.points_of_cluster);
    std::map<Key, std::uint32_t> number;
    for (const auto& [key, bag] : clusters) number.emplace(key, static_cast<std::uint32_t>(number.size()));
    for (std::size_t f = 0; f < keys.size(); ++f)
        bounce.fine.surfels[f].cluster = number.at(moved.at(keys[f]));
    return true;
}

} // namespace ghost::bake
