// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostTriangles = 200'000; // of a mesh whose edges are looked at
constexpr std::size_t kMostLines = 6'000;       // of an object
constexpr std::size_t kMostLinesOfAll = 120'000;
constexpr std::size_t kMostKeptEdges = 2'000'000; // of meshes that come again: 80 MB
constexpr std::size_t kMostObjects = 20'000;
constexpr float kSharp = 0.48f;    // cosine between its faces: sharper than a tube of six sides
constexpr double kDotOfLines = 60; // lines of an object: times the finest
constexpr float kFlat = 0.9999f;   // its faces are one
constexpr float kWelded = 1e-5f;   // of the mesh's size: corners so near are one

struct Edge {
    std::uint32_t from = 0, to = 0; // corners of the mesh
    int faces = 0;
    glm::vec3 normals[2]{};
};

// Edges of a mesh, each once.
std::vector<Edge> edges_of(const Mesh& mesh) {
    glm::vec3 low(1e30f), high(-1e30f);
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const float cell = std::max(glm::length(high - low) * kWelded, 1e-9f);
    std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t>, std::uint32_t> corners;
    std::vector<std::uint32_t> welded;
    welded.reserve(mesh.positions.size());
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 at = (mesh.positions[i] - low) / cell;
        welded.push_back(corners.try_emplace({std::llround(at.x), std::llround(at.y), std::llround(at.z)}, i)
                             .first->second);
    }
    std::unordered_map<std::uint64_t, std::size_t> known;
    std::vector<Edge> edges;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::uint32_t face[3];
        for (std::size_t k = 0; k < 3; ++k) face[k] = welded[mesh.indices[i + k]];
        const glm::vec3 across = glm::cross(mesh.positions[face[1]] - mesh.positions[face[0]],
                                            mesh.positions[face[2]] - mesh.positions[face[0]]);
        if (!(glm::dot(across, across) > 0)) continue;
        const glm::vec3 normal = glm::normalize(across);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = face[k], to = face[(k + 1) % 3];
            const std::uint64_t key =
                (std::uint64_t{std::min(from, to)} << 32) | std::uint64_t{std::max(from, to)};
            const auto [found, is_new] = known.try_emplace(key, edges.size());
            if (is_new) edges.push_back({from, to, 0, {}});
            Edge& edge = edges[found->second];
            if (edge.faces < 2) edge.normals[edge.faces] = normal;
            ++edge.faces;
        }
    }
    return edges;
}

// A line of the drawing, in steps of what is finest.
using Line = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int64_t>;

class Outliner {
public:
    Outliner(const Stage& stage, const View& view, double finest_m)
        : stage_(stage), view_(view), finest_m_(finest_m) {}

    Outlines draw() {
        Outlines all;
        for (std::size_t i = 0; i < stage_.instances.size(); ++i) {
            const Instance& instance = stage_.instances[i];
            if (!instance.shown || instance.fixture != kNone) continue;
            const Mesh& mesh = stage_.meshes[static_cast<std::size_t>(instance.mesh)];
            if (mesh.positions.empty()) continue;
            if (all.objects.size() == kMostObjects) {
                ++all.left_out;
                continue;
            }
            if (is_cut_away(instance, mesh)) continue;
            Outline outline{i, {}, {}};
            if (is_small(instance, mesh)) {
                draw_hull(instance, mesh, outline);
            } else if (!draw_edges(instance, mesh, outline)) {
                draw_hull(instance, mesh, outline);
                ++all.simplified;
            }
            for (const glm::dvec2& end : outline.ends_m) outline.extent.include(end);
            lines_ += outline.ends_m.size() / 2;
            if (!outline.ends_m.empty()) all.objects.push_back(std::move(outline));
        }
        return all;
    }

private:
    glm::vec3 world_of(const Instance& instance, const glm::vec3& position) const {
        return glm::vec3(instance.world * glm::vec4(position, 1.0f));
    }

    bool is_cut_away(const Instance& instance, const Mesh& mesh) const {
        return view_.cut_m && std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const auto& at) {
                   return view_.is_cut_away(world_of(instance, at));
               });
    }

    // So small on paper that nobody would see its edges.
    bool is_small(const Instance& instance, const Mesh& mesh) const {
        Extent2 extent;
        for (const glm::vec3& position : mesh.positions) {
            extent.include(view_.flat(world_of(instance, position)));
            if (std::max(extent.size().x, extent.size().y) > kDotOfLines * finest_m_) return false;
        }
        return true;
    }

    const std::vector<Edge>& edges(int mesh) {
        const auto [found, is_new] = edges_.try_emplace(mesh);
        if (!is_new) return found->second;
        std::vector<Edge> edges = edges_of(stage_.meshes[static_cast<std::size_t>(mesh)]);
        if (edges.size() > kMostKeptEdges - kept_) {
            edges_.clear();
            kept_ = 0;
        }
        kept_ += edges.size();
        return edges_[mesh] = std::move(edges);
    }

    // False: it has too many.
    bool draw_edges(const Instance& instance, const Mesh& mesh, Outline& outline) {
        if (mesh.indices.size() / 3 > kMostTriangles || lines_ >= kMostLinesOfAll) return false;
        const std::size_t most = std::min(kMostLines, kMostLinesOfAll - lines_);
        const glm::mat3 turn(instance.world);
        if (!(std::abs(glm::determinant(turn)) > 0)) return false;
        const glm::vec3 to_eye = glm::inverse(turn) * glm::vec3(view_.to_eye());
        for (const bool with_sharp : {true, false}) {
            std::set<Line> lines;
            for (const Edge& edge : edges(instance.mesh)) {
                const bool is_border = edge.faces != 2;
                const float bend = glm::dot(edge.normals[0], edge.normals[1]);
                if (!is_border && bend > kFlat) continue;
                const bool is_silhouette =
                    glm::dot(edge.normals[0], to_eye) * glm::dot(edge.normals[1], to_eye) <= 0;
                const bool is_sharp = with_sharp && bend < kSharp;
                if (!is_border && !is_silhouette && !is_sharp) continue;
                add(instance, mesh, edge, lines);
                if (lines.size() > most) break;
            }
            if (lines.size() > most) continue;
            for (const auto& [x, y, to_x, to_y] : lines) {
                outline.ends_m.emplace_back(static_cast<double>(x) * finest_m_,
                                            static_cast<double>(y) * finest_m_);
                outline.ends_m.emplace_back(static_cast<double>(to_x) * finest_m_,
                                            static_cast<double>(to_y) * finest_m_);
            }
            return true;
        }
        return false;
    }

    void add(const Instance& instance, const Mesh& mesh, const Edge& edge, std::set<Line>& lines) const {
        glm::vec3 from = world_of(instance, mesh.positions[edge.from]);
        glm::vec3 to = world_of(instance, mesh.positions[edge.to]);
        if (view_.is_cut_away(from) && view_.is_cut_away(to)) return;
        if (view_.is_cut_away(from)) std::swap(from, to);
        if (view_.is_cut_away(to)) {
            const double share = (*view_.cut_m - view_.depth(from)) / (view_.depth(to) - view_.depth(from));
            to = glm::mix(from, to, static_cast<float>(share));
        }
        const glm::dvec2 start = view_.flat(from) / finest_m_, end = view_.flat(to) / finest_m_;
        std::pair a{std::llround(start.x), std::llround(start.y)};
        std::pair b{std::llround(end.x), std::llround(end.y)};
        if (b < a) std::swap(a, b);
        if (a != b) lines.insert({a.first, a.second, b.first, b.second});
    }

    void draw_hull(const Instance& instance, const Mesh& mesh, Outline& outline) const {
        std::vector<glm::dvec2> points;
        points.reserve(mesh.positions.size());
        for (const glm::vec3& position : mesh.positions)
            if (const glm::vec3 at = world_of(instance, position); !view_.is_cut_away(at))
                points.push_back(view_.flat(at));
        const std::vector<glm::dvec2> hull = hull_of(std::move(points));
        for (std::size_t k = 0; k < hull.size(); ++k) {
            outline.ends_m.push_back(hull[k]);
            outline.ends_m.push_back(hull[(k + 1) % hull.size()]);
        }
    }

    const Stage& stage_;
    const View& view_;
    double finest_m_;
    std::size_t lines_ = 0;
    std::map<int, std::vector<Edge>> edges_; // of the last meshes
    std::size_t kept_ = 0;
};

} // namespace

std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
    const auto less = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    };
    std::sort(points.begin(), points.end(), less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    const auto turns_right = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= 0;
    };
    std::vector<glm::dvec2> hull;
    for (const bool is_upper : {false, true}) {
        const std::size_t begin = hull.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2& point = is_upper ? points[points.size() - 1 - i] : points[i];
            while (hull.size() >= begin + 2 && turns_right(hull[hull.size() - 2], hull.back(), point))
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
    }
    return hull;
}

Outlines outlines_of(const Stage& stage, const View& view, double finest_m) {
    return Outliner(stage, view, finest_m).draw();
}

} // namespace ghost::scene
