// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/rigging.h"

#include "book/hangings.h"
#include "drawings/private/outlines.h"
#include "fixture/decode.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace ghost::scene {
namespace {

constexpr float kLeastBar_m = 0.8f;
constexpr float kBeside_m = 1.2f; // from a fixture to the bar that it hangs on
constexpr float kGap_m = 0.3f;    // between pieces of one truss, as joined() has it
constexpr float kSameLine_m = 0.06f;
constexpr double kLeastBody_m = 0.05, kLargestBody_m = 4;

struct Box {
    glm::vec3 low{1e30f}, high{-1e30f};
    void include(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    bool is_empty() const { return low.x > high.x; }
};

Box box_of(const Mesh& mesh) {
    Box box;
    for (const glm::vec3& position : mesh.positions) box.include(position);
    return box;
}

class Bodies {
public:
    Bodies(const Show& show, const Stage& stage) : show_(show), stage_(stage) {
        for (const Mesh& mesh : stage.meshes) boxes_.push_back(box_of(mesh));
        instances_.resize(show.fixtures.size());
        for (std::size_t i = 0; i < stage.instances.size(); ++i)
            if (const int owner = stage.instances[i].fixture; owner != kNone)
                instances_[static_cast<std::size_t>(owner)].push_back(i);
    }

    // Nothing: it has no body.
    std::optional<glm::dvec2> size_of(std::size_t index) {
        const PatchedFixture& fixture = show_.fixtures[index];
        if (fixture.wall) return glm::dvec2(fixture.wall->size_m.x, kWallDepth_m);
        if (!fixture.type || fixture.type->modes.empty()) return std::nullopt;
        const auto [found, is_new] = sizes_.try_emplace({fixture.type.get(), fixture.mode});
        if (is_new) found->second = measured(index);
        return found->second;
    }

private:
    std::optional<glm::dvec2> measured(std::size_t index) const {
        const std::vector<fixture::PartState> parts = straight_parts(show_.fixtures[index]);
        Box all;
        for (const std::size_t i : instances_[index]) {
            const Instance& instance = stage_.instances[i];
            const Box& box = boxes_[static_cast<std::size_t>(instance.mesh)];
            if (instance.part == kNone || box.is_empty()) continue;
            const glm::mat4 to_fixture =
                parts[static_cast<std::size_t>(instance.part)].to_fixture * instance.to_part;
            for (int corner = 0; corner < 8; ++corner)
                all.include(glm::vec3(to_fixture * glm::vec4(corner & 1 ? box.high.x : box.low.x,
                                                             corner & 2 ? box.high.y : box.low.y,
                                                             corner & 4 ? box.high.z : box.low.z, 1.0f)));
        }
        if (all.is_empty()) return std::nullopt;
        const glm::dvec2 size(glm::dvec3(all.high) - glm::dvec3(all.low));
        return glm::clamp(size, glm::dvec2(kLeastBody_m), glm::dvec2(kLargestBody_m));
    }

    const Show& show_;
    const Stage& stage_;
    std::vector<Box> boxes_;
    std::vector<std::vector<std::size_t>> instances_; // of each fixture
    std::map<std::pair<const fixture::Type*, int>, std::optional<glm::dvec2>> sizes_;
};

float distance_m(const Bar& bar, const glm::vec3& point) {
    const glm::vec3 along = bar.to_m - bar.from_m;
    const float share = std::clamp(glm::dot(point - bar.from_m, along) / glm::dot(along, along), 0.0f, 1.0f);
    return glm::distance(point, bar.from_m + share * along);
}

// The positions of those that hang there; "": they have none.
std::string most_of(const std::map<std::string, std::size_t>& names) {
    std::string best;
    std::size_t most = 0;
    for (const auto& [name, count] : names)
        if (!name.empty() && count > most) {
            best = name;
            most = count;
        }
    return best;
}

using Pieces = std::vector<std::pair<std::size_t, Bar>>; // by instance

Pieces pieces_of(const Stage& stage) {
    Pieces bars;
    for (std::size_t i = 0; i < stage.instances.size(); ++i) {
        const Instance& instance = stage.instances[i];
        if (instance.fixture != kNone || !instance.shown) continue;
        const Mesh& mesh = stage.meshes[static_cast<std::size_t>(instance.mesh)];
        if (const auto bar = bar_of(mesh.positions, instance.world); bar && is_slender(*bar))
            bars.emplace_back(i, *bar);
    }
    return bars;
}

// As many points of a mesh as its outermost line needs.
std::vector<glm::vec3> outermost(const Mesh& mesh) {
    constexpr int kRings = 7, kOfRing = 14;
    std::vector<glm::vec3> points;
    for (int ring = 0; ring < kRings; ++ring)
        for (int k = 0; k < kOfRing; ++k) {
            const float up = -1.0f + 2.0f * static_cast<float>(ring) / (kRings - 1);
            const float round = std::sqrt(std::max(0.0f, 1.0f - up * up));
            const float angle = 6.2831853f * static_cast<float>(k) / kOfRing;
            const glm::vec3 way(round * std::cos(angle), round * std::sin(angle), up);
            const glm::vec3* best = &mesh.positions.front();
            float farthest = -1e30f;
            for (const glm::vec3& position : mesh.positions)
                if (const float reach = glm::dot(position, way); reach > farthest) {
                    farthest = reach;
                    best = &position;
                }
            points.push_back(*best);
        }
    std::sort(points.begin(), points.end(), [](const glm::vec3& a, const glm::vec3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

// Whether some fixture may hang on a piece, or on what it is joined to.
class Neighbours {
public:
    explicit Neighbours(const Show& show) {
        for (const PatchedFixture& fixture : show.fixtures)
            if (fixture.is_place_known && std::isfinite(fixture.position_m.x))
                places_m_.push_back(fixture.position_m);
        std::sort(places_m_.begin(), places_m_.end(), is_left);
    }
    bool has(const Bar& piece) const {
        const glm::vec3 reach(kBeside_m + kGap_m);
        const glm::vec3 low = glm::min(piece.from_m, piece.to_m) - reach;
        const glm::vec3 high = glm::max(piece.from_m, piece.to_m) + reach;
        for (auto at = std::lower_bound(places_m_.begin(), places_m_.end(), low, is_left);
             at != places_m_.end() && at->x <= high.x; ++at)
            if (distance_m(piece, *at) < reach.x) return true;
        return false;
    }

private:
    static bool is_left(const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; }
    std::vector<glm::vec3> places_m_;
};

std::vector<RiggedFixture> rigged_fixtures(const Show& show, const Stage& stage) {
    Bodies bodies(show, stage);
    const std::vector<Hanging> hangings = hangings_of(show);
    std::vector<RiggedFixture> all;
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        if (!show.fixtures[i].is_place_known) continue;
        RiggedFixture& rigged = all.emplace_back();
        rigged.fixture = i;
        rigged.kind = symbol_of(show.fixtures[i]);
        rigged.to_world = fixture_to_world(show.fixtures[i], 0);
        rigged.position = hangings[i].position;
        rigged.unit = hangings[i].unit;
        if (const auto size = bodies.size_of(i)) {
            rigged.size_m = *size;
            rigged.is_size_known = true;
        }
    }
    return all;
}

// Whole trusses that have a fixture near.
std::vector<HungBar> whole_bars(const Show& show, const Stage& stage, const Pieces& pieces,
                                std::size_t& left_out) {
    const Neighbours neighbours(show);
    std::vector<Bar> seeds, others;
    std::vector<std::size_t> instances; // of the seeds
    for (const auto& [instance, bar] : pieces) {
        if (seeds.size() < kMostBars && neighbours.has(bar)) {
            seeds.push_back(bar);
            instances.push_back(instance);
        } else {
            others.push_back(bar);
        }
    }
    const std::size_t more = std::min(others.size(), kMostBars - seeds.size());
    left_out = others.size() - more;
    std::vector<Bar> all = seeds;
    all.insert(all.end(), others.begin(), others.begin() + static_cast<std::ptrdiff_t>(more));
    std::vector<HungBar> whole;
    for (std::size_t k = 0; k < seeds.size(); ++k) {
        const bool is_known = std::any_of(whole.begin(), whole.end(), [&](const HungBar& one) {
            return distance_m(one.bar, seeds[k].from_m) < kSameLine_m &&
                   distance_m(one.bar, seeds[k].to_m) < kSameLine_m;
        });
        if (is_known) continue;
        const Bar bar = joined(seeds[k], all);
        if (bar.length_m() >= kLeastBar_m) whole.push_back({bar, stage.instances[instances[k]].name});
    }
    return whole;
}

std::vector<HungBar> hung_bars(const Show& show, const std::vector<RiggedFixture>& fixtures,
                               std::vector<HungBar> whole) {
    std::vector<std::map<std::string, std::size_t>> names(whole.size());
    for (const RiggedFixture& fixture : fixtures) {
        std::size_t best = whole.size();
        float nearest = kBeside_m;
        for (std::size_t k = 0; k < whole.size(); ++k)
            if (const float distance = distance_m(whole[k].bar, show.fixtures[fixture.fixture].position_m);
                distance < nearest) {
                nearest = distance;
                best = k;
            }
        if (best < whole.size()) ++names[best][fixture.position];
    }
    std::vector<HungBar> hung;
    for (std::size_t k = 0; k < whole.size(); ++k) {
        if (names[k].empty()) continue;
        if (const std::string name = most_of(names[k]); !name.empty()) whole[k].name = name;
        hung.push_back(std::move(whole[k]));
    }
    return hung;
}

} // namespace

std::vector<fixture::PartState> straight_parts(const PatchedFixture& fixture) {
    const fixture::Patch patch = fixture.patch();
    fixture::State state = fixture::make_state(patch);
    fixture::Targets targets = fixture::decode(patch, {});
    for (auto& axis : targets.axes) axis = {};
    fixture::step(state, patch, targets, 0.0);
    return state.parts;
}

Rigging rigging_of(const Show& show, const Stage& stage) {
    Rigging rigging;
    rigging.fixtures = rigged_fixtures(show, stage);
    const Pieces pieces = pieces_of(stage);
    rigging.are_slender.resize(stage.instances.size());
    for (const auto& [instance, bar] : pieces) rigging.are_slender[instance] = true;
    rigging.bars =
        hung_bars(show, rigging.fixtures, whole_bars(show, stage, pieces, rigging.pieces_left_out));
    return rigging;
}

std::vector<std::vector<std::vector<glm::dvec2>>> bodies_seen(const Show& show, const Stage& stage,
                                                              const View& view) {
    std::vector<std::vector<std::vector<glm::dvec2>>> all(show.fixtures.size());
    std::map<int, std::vector<glm::vec3>> points;
    for (const Instance& instance : stage.instances) {
        if (instance.fixture == kNone) continue;
        const Mesh& mesh = stage.meshes[static_cast<std::size_t>(instance.mesh)];
        if (mesh.positions.empty()) continue;
        const auto [found, is_new] = points.try_emplace(instance.mesh);
        if (is_new) found->second = outermost(mesh);
        std::vector<glm::dvec2> seen;
        for (const glm::vec3& point : found->second)
            seen.push_back(view.flat(glm::vec3(instance.world * glm::vec4(point, 1.0f))));
        all[static_cast<std::size_t>(instance.fixture)].push_back(hull_of(std::move(seen)));
    }
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        const std::optional<LedWall>& wall = show.fixtures[i].wall;
        if (!wall) continue;
        // Its origin is the middle of its front.
        const glm::mat4 to_world = fixture_to_world(show.fixtures[i], 0);
        std::vector<glm::dvec2> seen;
        for (const float x : {-0.5f, 0.5f})
            for (const float y : {0.0f, kWallDepth_m})
                for (const float z : {-0.5f, 0.5f})
                    seen.push_back(view.flat(
                        glm::vec3(to_world * glm::vec4(x * wall->size_m.x, y, z * wall->size_m.y, 1.0f))));
        all[i].push_back(hull_of(std::move(seen)));
    }
    return all;
}

} // namespace ghost::scene
