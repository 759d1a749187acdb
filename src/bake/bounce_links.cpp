// SPDX-License-Identifier: Apache-2.0
// Rows by rays: every node looks about itself, cosine-weighted from surfels, everywhere from cells, and what
// its rays cross and meet becomes its links. So each row sums to what the node sees, without any factor.
#include "bake/private/bounce_balance.h"
#include "bake/private/bounce_nodes.h"

#include "passes/passes_file.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <mutex>
#include <numbers>
#include <span>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace ghost::bake {
namespace {

using scene::kNoNode;

constexpr float kNearFrom = 1.0f / 3; // blocks: nearer than this all light goes by fine links
constexpr float kNearTo = 1.0f;       // farther, by coarse ones
constexpr float kPieces = 0.25f;      // of a cell: chords are cut as short where the two fade
constexpr std::size_t kMostVisible = 16;
constexpr float kGolden = 0.61803399f, kPlastic = 0.75487767f;
constexpr float kPi = std::numbers::pi_v<float>;

float part_of(float number) {
    return number - std::floor(number);
}

glm::vec3 even_direction(float u, float v) {
    const float z = 1 - 2 * u, radius = std::sqrt(std::max(0.0f, 1 - z * z)), angle = 2 * kPi * v;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

glm::vec3 cosine_about(const glm::vec3& n, float u, float v) {
    const float sign = n.z >= 0 ? 1.0f : -1.0f, a = -1 / (sign + n.z), b = n.x * n.y * a;
    const glm::vec3 s(1 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    const glm::vec3 t(b, sign + n.y * n.y * a, -n.y);
    const float radius = std::sqrt(u), angle = 2 * kPi * v;
    return s * (radius * std::cos(angle)) + t * (radius * std::sin(angle)) +
           n * std::sqrt(std::max(0.0f, 1 - u));
}

// Sums of what the rays of one node meet; kept by each thread.
struct Sums {
    struct Sum {
        std::uint32_t node;
        glm::vec3 way; // weighted, from emitter to receiver
        float weight, weight_m;
    };
    struct Chord {
        std::uint32_t cell;
        float begin_m, end_m;
    };
    std::vector<Chord> chords; // of one ray
    std::vector<Sum> all;
    std::vector<std::uint32_t> where; // of each node, in all
    // By bin, or of a surfel: rays, and what of their light comes from far away.
    std::array<float, scene::kBounceBins> rays, far;
};

class Links {
public:
    Links(const Tracer& tracer, const BounceOptions& options, const BounceNodes& nodes, scene::Bounce& bounce)
        : tracer_(tracer), options_(options), nodes_(nodes), bounce_(bounce), index_(bounce),
          block_m_(bounce.grid.sub_m * scene::kSubsOfBlock), cell_m_(bounce.grid.sub_m * scene::kSubsOfCell) {
    }

    // Of all work it is that from one fraction to the other.
    bool make(bool is_coarse, double from, double to) {
        const scene::BounceLevel& level = is_coarse ? bounce_.coarse : bounce_.fine;
        const std::size_t count = level.cells.size() + level.surfels.size();
        std::vector<std::vector<FoundLink>> rows(count);
        if (!is_coarse) bounce_.far_share.assign(level.slots(), 0);
        // As many nodes as have work for some tenths of a second.
        const std::size_t of_part = is_coarse ? 8 * kBand : 64 * kBand;
        std::vector<std::atomic<std::size_t>> left((count + of_part - 1) / of_part); // nodes of each part
        std::atomic<std::size_t> done{0};
        const auto rows_of = [&](std::size_t part) {
            return std::span(rows).subspan(part * of_part, std::min(of_part, count - part * of_part));
        };
        const auto shares_of = [&](std::size_t part) {
            if (is_coarse) return std::span<float>();
            const std::size_t first = level.first_slot(part * of_part),
                              end = level.first_slot(part * of_part + rows_of(part).size());
            return std::span(bounce_.far_share).subspan(first, end - first);
        };
        for (std::size_t part = 0; part < left.size(); ++part) {
            left[part] = rows_of(part).size();
            if (!options_.parts ||
                !options_.parts->take(level, is_coarse, part * of_part, rows_of(part), shares_of(part)))
                continue;
            done += left[part].exchange(0);
        }
        tbb::enumerable_thread_specific<Sums> sums;
        std::mutex saying;
        tbb::parallel_for(std::size_t{0}, (count + kBand - 1) / kBand, [&](std::size_t band) {
            const std::size_t first = band * kBand, end = std::min(first + kBand, count),
                              part = first / of_part;
            if (left[part] == 0 || (options_.stop && options_.stop())) return;
            const DenormalsOff mode;
            for (std::size_t node = first; node < end; ++node) row(is_coarse, node, sums.local(), rows[node]);
            if ((left[part] -= end - first) == 0 && options_.parts)
                options_.parts->keep(is_coarse, part * of_part, rows_of(part), shares_of(part));
            done += end - first;
            if (!options_.progress) return;
            if (const std::unique_lock lock(saying, std::try_to_lock); lock)
                options_.progress(from +
                                  (to - from) * static_cast<double>(done) / static_cast<double>(count));
        });
        if (options_.stop && options_.stop()) return false;
        make_reciprocal(level, rows);
        scene::BounceRows& out = is_coarse ? bounce_.far : bounce_.near;
        out = {};
        out.start.assign(level.slots() + 1, 0);
        std::size_t total = 0;
        for (const auto& row : rows) total += row.size();
        out.links.reserve(total);
        // Nodes stand in the order of their slots, links of a node in that of its bins.
        for (const auto& row : rows)
            for (const FoundLink& found : row) {
                ++out.start[found.receiver + 1];
                out.links.push_back(
                    {found.emitter, scene::to_half(found.weight), scene::to_half(found.distance_m)});
            }
        for (std::size_t k = 0; k + 1 < out.start.size(); ++k) out.start[k + 1] += out.start[k];
        return true;
    }

private:
    static constexpr std::size_t kBand = 16;

    // Fraction of the light at a distance that fine links carry.
    float near_fraction(float distance_m) const {
        const float u = glm::clamp((kNearTo - distance_m / block_m_) / (kNearTo - kNearFrom), 0.0f, 1.0f);
        return u * u * (3 - 2 * u);
    }

    glm::vec3 place_in_cell(const std::vector<std::uint32_t>& subs, float pick, BounceRandom& random,
                            std::uint32_t& cell) const {
        const std::size_t at =
            std::min(static_cast<std::size_t>(pick * static_cast<float>(subs.size())), subs.size() - 1);
        const glm::vec3 centre = bounce_.grid.sub_centre_m(static_cast<int>(subs[at]));
        const float x = random(), y = random(), z = random();
        const glm::vec3 place = centre + (glm::vec3(x, y, z) - 0.5f) * bounce_.grid.sub_m;
        cell = bounce_.cell_of[subs[at]];
        return sees(tracer_, centre, place) ? place : centre;
    }

    void row(bool is_coarse, std::size_t node, Sums& sums, std::vector<FoundLink>& found) const {
        const scene::BounceLevel& level = is_coarse ? bounce_.coarse : bounce_.fine;
        const bool is_cell = node < level.cells.size();
        const std::size_t surfel = is_cell ? 0 : node - level.cells.size();
        const auto& members = is_cell
                                  ? (is_coarse ? nodes_.subs_of_block : nodes_.subs_of_cell)[node]
                                  : (is_coarse ? nodes_.points_of_cluster : nodes_.points_of_surfel)[surfel];
        const int rays = is_coarse ? options_.rays_of_block
                         : is_cell ? options_.rays_of_cell
                                   : options_.rays_of_surfel;
        BounceRandom random(2 * node + (is_coarse ? 1 : 0) + 5);
        sums.all.clear();
        sums.rays.fill(0);
        sums.far.fill(0);
        sums.where.resize(bounce_.fine.cells.size() + bounce_.fine.surfels.size(), kNoNode);
        const float unit = (is_cell ? 4 * kPi : kPi) / static_cast<float>(rays), turn = random(),
                    shift = random();
        for (int k = 0; k < rays; ++k) {
            const float u = (static_cast<float>(k) + random()) / static_cast<float>(rays);
            const float v = part_of(turn + static_cast<float>(k) * kGolden);
            const float pick = part_of(shift + static_cast<float>(k) * kPlastic);
            if (is_cell) {
                std::uint32_t cell = kNoNode;
                const glm::vec3 place_m = place_in_cell(members, pick, random, cell);
                const glm::vec3 way = even_direction(u, v);
                look(is_coarse, place_m, way, cell, unit, scene::bounce_bin(-way), sums);
                continue;
            }
            const std::size_t at = std::min(
                static_cast<std::size_t>(pick * static_cast<float>(members.size())), members.size() - 1);
            const SurfacePoint& point = nodes_.points[members[at]];
            look(is_coarse, point.place_m + point.normal * 1e-3f, cosine_about(point.normal, u, v),
                 point.cell, unit, 0, sums);
        }
        for (std::size_t bin = 0; !is_coarse && bin < (is_cell ? scene::kBounceBins : 1); ++bin)
            if (sums.rays[bin] > 0)
                bounce_.far_share[level.first_slot(node) + bin] = sums.far[bin] / sums.rays[bin];
        for (const Sums::Sum& sum : sums.all) {
            sums.where[sum.node] = kNoNode;
            if (!(sum.weight > 0)) continue;
            const std::size_t bin = scene::bounce_bin(sum.way);
            found.push_back({static_cast<std::uint32_t>(is_cell ? node * scene::kBounceBins + bin
                                                                : level.surfel_slot(surfel)),
                             slot_of(level, sum.node, bin), sum.weight, sum.weight_m / sum.weight});
        }
        std::sort(found.begin(), found.end(), [](const FoundLink& a, const FoundLink& b) {
            return a.receiver != b.receiver ? a.receiver < b.receiver : a.emitter < b.emitter;
        });
    }

    static std::uint32_t slot_of(const scene::BounceLevel& level, std::uint32_t node, std::size_t bin) {
        const std::size_t cells = level.cells.size();
        return static_cast<std::uint32_t>(node < cells ? node * scene::kBounceBins + bin
                                                       : level.surfel_slot(node - cells));
    }

    static void add(Sums& sums, std::uint32_t node, const glm::vec3& way, float weight, float distance_m) {
        if (!(weight > 0)) return;
        if (sums.where[node] == kNoNode) {
            sums.where[node] = static_cast<std::uint32_t>(sums.all.size());
            sums.all.push_back({node, glm::vec3(0), 0, 0});
        }
        Sums::Sum& sum = sums.all[sums.where[node]];
        sum.way -= way * weight;
        sum.weight += weight;
        sum.weight_m += weight * distance_m;
    }

    // Of the air that a ray came through to a surface. Where a wall cuts the last sub-voxel, that may be a
    // cell of its other side.
    std::uint32_t cell_before(const glm::vec3& met_m, const glm::vec3& normal,
                              const std::vector<Sums::Chord>& chords, std::uint32_t last,
                              std::uint32_t own_cell) const {
        const std::uint32_t before = chords.size() > 1 ? chords[chords.size() - 2].cell : own_cell;
        if (last == kNoNode || before == kNoNode || before == last) return last;
        constexpr float kFarther = 4; // sub-voxels
        if (chords.back().end_m - chords.back().begin_m > kFarther * bounce_.grid.sub_m) return last;
        const glm::vec3 at_m = met_m + normal * 2e-3f;
        const int sub = bounce_.grid.sub_at(at_m);
        return sub < 0 || sees(tracer_, at_m, bounce_.grid.sub_centre_m(sub)) ? last : before;
    }

    // One ray of a receiver in a cell; unit: steradians it stands for; bin: of the light along it, 0 of a
    // surfel.
    void look(bool is_coarse, const glm::vec3& from_m, const glm::vec3& way, std::uint32_t own_cell,
              float unit, std::size_t bin, Sums& sums) const {
        const float reach_m = is_coarse ? 1e4f : block_m_ * kNearTo;
        const Tracer::Meeting meeting = tracer_.meet(from_m, way, reach_m);
        const auto fraction_at = [&](float distance_m) {
            return is_coarse ? 1 - near_fraction(distance_m) : near_fraction(distance_m);
        };
        sums.rays[bin] += 1;
        sums.far[bin] += meeting.instance >= 0 ? 1 - near_fraction(meeting.distance_m) : 1;
        std::vector<Sums::Chord>& chords = sums.chords;
        chords.clear();
        const std::uint32_t last = scene::walk_cells(bounce_, from_m, way, meeting.distance_m,
                                                     [&](std::uint32_t cell, float a, float b) {
                                                         chords.push_back({cell, a, b});
                                                     });
        const glm::vec3 met_m = from_m + way * meeting.distance_m;
        std::uint32_t surfel = kNoNode;
        if (meeting.instance >= 0) {
            const std::uint32_t before = cell_before(met_m, meeting.normal, chords, last, own_cell);
            if (before != last) chords.back().cell = before;
            surfel = index_.surfel_at(met_m, meeting.normal, before);
        }
        // A sub-voxel that a wall cuts is a cell of one of its sides; a ray of the other side does not get
        // there.
        if (!chords.empty() && surfel != kNoNode) {
            Sums::Chord& chord = chords.back();
            const float depth_m = (chord.end_m - chord.begin_m) * std::abs(glm::dot(way, meeting.normal));
            if (depth_m < bounce_.grid.sub_m) chord.cell = bounce_.fine.surfels[surfel].cell;
        }
        if (!chords.empty() && own_cell != kNoNode) chords.front().cell = own_cell;
        for (const Sums::Chord& chord : chords) {
            const std::uint32_t node = is_coarse ? bounce_.fine.cells[chord.cell].block : chord.cell;
            const bool fades = chord.begin_m < block_m_ * kNearTo;
            const float whole = chord.end_m - chord.begin_m;
            const int pieces = fades ? static_cast<int>(whole / (kPieces * cell_m_)) + 1 : 1;
            for (int k = 0; k < pieces; ++k) {
                const float length = whole / static_cast<float>(pieces);
                const float middle = chord.begin_m + length * (static_cast<float>(k) + 0.5f);
                add(sums, node, way, unit * length * fraction_at(middle), middle);
            }
        }
        if (surfel == kNoNode) return;
        const std::size_t node = is_coarse
                                     ? bounce_.coarse.cells.size() + bounce_.fine.surfels[surfel].cluster
                                     : bounce_.fine.cells.size() + surfel;
        add(sums, static_cast<std::uint32_t>(node), way, unit * fraction_at(meeting.distance_m),
            meeting.distance_m);
    }

    const Tracer& tracer_;
    const BounceOptions& options_;
    const BounceNodes& nodes_;
    scene::Bounce& bounce_;
    const SurfelIndex index_;
    const float block_m_, cell_m_;
};

// What fine nodes take of coarse ones.
class Parents {
public:
    Parents(const Tracer& tracer, const BounceNodes& nodes, scene::Bounce& bounce)
        : tracer_(tracer), nodes_(nodes), bounce_(bounce), blocks_(bounce.grid.voxels(scene::kSubsOfBlock)) {
        const auto count = static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.y) *
                           static_cast<std::size_t>(blocks_.z);
        cells_at_.resize(count);
        surfels_at_.resize(count);
        for (std::uint32_t k = 0; k < bounce.coarse.cells.size(); ++k)
            cells_at_[bounce.coarse.cells[k].voxel].push_back(k);
        for (std::uint32_t k = 0; k < bounce.coarse.surfels.size(); ++k)
            surfels_at_[bounce.coarse.surfels[k].voxel].push_back(k);
    }

    bool make(const BounceOptions& options) {
        bounce_.cell_parents.resize(bounce_.fine.cells.size());
        bounce_.surfel_parents.resize(bounce_.fine.surfels.size());
        const std::size_t cells = bounce_.fine.cells.size(), count = cells + bounce_.fine.surfels.size();
        tbb::parallel_for(std::size_t{0}, (count + 63) / 64, [&](std::size_t band) {
            if (options.stop && options.stop()) return;
            const DenormalsOff mode;
            for (std::size_t node = band * 64; node < std::min((band + 1) * 64, count); ++node)
                node < cells ? of_cell(node) : of_surfel(node - cells);
        });
        return !(options.stop && options.stop());
    }

private:
    using Candidates = std::vector<std::pair<float, std::uint32_t>>;

    // Coarse nodes about a place, with their trilinear fractions.
    template <class Use>
    void about(const glm::vec3& place_m, const std::vector<std::vector<std::uint32_t>>& at,
               const Use& use) const {
        const glm::vec3 where =
            (place_m - bounce_.grid.low_m) / (bounce_.grid.sub_m * scene::kSubsOfBlock) - 0.5f;
        const glm::ivec3 low(glm::floor(where));
        const glm::vec3 fraction = where - glm::vec3(low);
        for (int k = 0; k < 8; ++k) {
            const glm::ivec3 corner(k & 1, (k >> 1) & 1, k >> 2);
            const glm::ivec3 block = low + corner;
            if (glm::any(glm::lessThan(block, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(block, blocks_)))
                continue;
            float weight = 1;
            for (int axis = 0; axis < 3; ++axis)
                weight *= corner[axis] == 1 ? fraction[axis] : 1 - fraction[axis];
            const auto index =
                static_cast<std::size_t>((block.z * blocks_.y + block.y) * blocks_.x + block.x);
            for (const std::uint32_t node : at[index]) use(node, weight);
        }
    }

    template <class Place, class Other>
    float visible(const Place& place, const Other& other) const {
        int seen = 0;
        for (std::size_t k = 0; k < kMostVisible; ++k) seen += sees(tracer_, place(), other()) ? 1 : 0;
        return static_cast<float>(seen) / static_cast<float>(kMostVisible);
    }

    glm::vec3 in_cell(const std::vector<std::uint32_t>& subs, BounceRandom& random) const {
        const std::size_t k =
            std::min(static_cast<std::size_t>(random() * static_cast<float>(subs.size())), subs.size() - 1);
        return bounce_.grid.sub_centre_m(static_cast<int>(subs[k]));
    }
    glm::vec3 on_surfel(const std::vector<std::uint32_t>& points, BounceRandom& random) const {
        const std::size_t k = std::min(static_cast<std::size_t>(random() * static_cast<float>(points.size())),
                                       points.size() - 1);
        const SurfacePoint& point = nodes_.points[points[k]];
        return point.place_m + point.normal * 0.05f;
    }

    void of_cell(std::size_t c) {
        BounceRandom random(4 * c + 3);
        Candidates found;
        about(bounce_.fine.cells[c].centre_m, cells_at_, [&](std::uint32_t node, float weight) {
            const float seen = visible([&] { return in_cell(nodes_.subs_of_cell[c], random); },
                                       [&] { return in_cell(nodes_.subs_of_block[node], random); });
            if (weight * seen > 0) found.emplace_back(weight * seen, node);
        });
        bounce_.cell_parents[c] = chosen(found, bounce_.fine.cells[c].block);
    }

    void of_surfel(std::size_t s) {
        constexpr float kAlike = 0.3f, kLeastCosine = 0.05f;
        const scene::BounceSurfel& surfel = bounce_.fine.surfels[s];
        BounceRandom random(4 * s + 1);
        Candidates found;
        about(surfel.place_m, surfels_at_, [&](std::uint32_t node, float weight) {
            const scene::BounceSurfel& other = bounce_.coarse.surfels[node];
            const float cosine = glm::dot(other.normal, surfel.normal);
            if (node != surfel.cluster && (other.side != surfel.side || cosine < kAlike)) return;
            const float seen = visible([&] { return on_surfel(nodes_.points_of_surfel[s], random); },
                                       [&] { return on_surfel(nodes_.points_of_cluster[node], random); });
            weight *= seen * std::max(kLeastCosine, cosine);
            if (weight > 0) found.emplace_back(weight, node);
        });
        bounce_.surfel_parents[s] = chosen(found, surfel.cluster);
    }

    static scene::BounceParents chosen(Candidates& found, std::uint32_t own) {
        constexpr float kLeast = 1e-3f;
        scene::BounceParents parents;
        parents.node.fill(kNoNode);
        parents.fraction.fill(0);
        std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
            return a.first != b.first ? a.first > b.first : a.second < b.second;
        });
        if (found.size() > parents.node.size()) found.resize(parents.node.size());
        float sum = 0;
        for (const auto& [weight, node] : found) sum += weight;
        if (sum < kLeast) {
            parents.node[0] = own;
            parents.fraction[0] = 1;
            return parents;
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            parents.node[k] = found[k].second;
            parents.fraction[k] = found[k].first / sum;
        }
        return parents;
    }

    const Tracer& tracer_;
    const BounceNodes& nodes_;
    scene::Bounce& bounce_;
    const glm::ivec3 blocks_;
    std::vector<std::vector<std::uint32_t>> cells_at_, surfels_at_;
};

} // namespace

bool make_bounce_links(const Tracer& tracer, const BounceOptions& options, const BounceNodes& nodes,
                       scene::Bounce& bounce) {
    Links links(tracer, options, nodes, bounce);
    if (!links.make(false, kNodesMade, kNearMade)) return false;
    if (!links.make(true, kNearMade, kFarMade)) return false;
    return Parents(tracer, nodes, bounce).make(options);
}

} // namespace ghost::bake
