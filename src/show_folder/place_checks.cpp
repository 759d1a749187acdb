// SPDX-License-Identifier: Apache-2.0
#include "show_folder/place_checks.h"

#include "base/text.h"
#include "beam_groups/light_places.h"
#include "fixture/decode.h"
#include "show/show.h"
#include "stage/box.h"
#include "stage/stage_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ghost::scene {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kPi = 3.14159265358979;
constexpr std::size_t kWindingTriangles = 20'000'000; // of all lights together
constexpr double kClosed = 0.98;                      // winding number

// Where each instance is, so that few have to be looked at triangle by triangle.
class Around {
public:
    explicit Around(const Stage& stage) : stage_(stage), boxes_(boxes_of(stage)) {
        // Small ones first: a hall of millions of triangles must not hide the crate in it.
        order_.resize(boxes_.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(),
                         [this](std::size_t a, std::size_t b) { return triangles(a) < triangles(b); });
    }
    int find(const vec3& point_m) {
        for (const std::size_t k : order_) {
            const Instance& instance = stage_.instances[k];
            if (!instance.shown || instance.fixture != kNone || !boxes_[k].holds(point_m)) continue;
            if (triangles(k) > triangles_left_) {
                skipped_.insert(name_of(stage_, static_cast<int>(k)));
                continue;
            }
            triangles_left_ -= triangles(k);
            winding_ = winding_number(stage_.meshes[static_cast<std::size_t>(instance.mesh)], instance.world,
                                      point_m);
            if (winding_ > 0.5) return static_cast<int>(k);
        }
        return kNone;
    }
    // Of the first of these places that is inside of something.
    int find_any(const std::vector<vec3>& points_m) {
        for (const vec3& point_m : points_m)
            if (const int object = find(point_m); object != kNone) return object;
        return kNone;
    }
    // What find() found has no opening through which light gets out.
    bool is_closed() const { return winding_ > kClosed; }
    // Objects of too many triangles for all that was asked.
    const std::set<std::string>& skipped() const { return skipped_; }

private:
    std::size_t triangles(std::size_t k) const {
        return stage_.meshes[static_cast<std::size_t>(stage_.instances[k].mesh)].indices.size() / 3;
    }

    const Stage& stage_;
    std::vector<Box> boxes_;
    std::vector<std::size_t> order_;
    std::set<std::string> skipped_;
    double winding_ = 0;
    std::size_t triangles_left_ = kWindingTriangles;
};

std::string degrees(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", static_cast<double>(value));
    return text;
}

bool zoom_fits(float deg) {
    return deg >= fixture::kMinZoom_deg && deg <= fixture::kMaxZoom_deg;
}

// Each type once, under the name of the first fixture that has it.
void check_optics(const Show& show, Report& report) {
    std::set<const fixture::Type*> seen;
    for (const PatchedFixture& patched : show.fixtures) {
        if (!patched.type || !seen.insert(patched.type.get()).second) continue;
        const std::string who = "fixture '" + patched.name + "' (" + patched.gdtf.string() + "): ";
        const auto warn = [&](const std::string& what) {
            report.add(Severity::warning, show.file.string(), who + what);
        };
        const std::string range =
            " degrees, drawn are " + degrees(fixture::kMinZoom_deg) + " to " + degrees(fixture::kMaxZoom_deg);
        for (const fixture::Geometry& geometry : patched.type->geometries) {
            if (!geometry.beam) continue;
            if (!(geometry.beam->beam_radius_m > 0.0f))
                warn("the lens of '" + geometry.name +
                     "' has no size; it throws sharp shadows and is seen as large as a usual one");
            if (!zoom_fits(geometry.beam->field_angle_deg))
                warn("the field of '" + geometry.name + "' is " + degrees(geometry.beam->field_angle_deg) +
                     range);
        }
        bool said = false;
        for (const fixture::Mode& mode : patched.type->modes)
            for (const fixture::Channel& channel : mode.channels)
                for (const fixture::ChannelFunction& function : channel.functions) {
                    if (said || function.meaning.role != fixture::Role::zoom) continue;
                    if (zoom_fits(function.physical_from) && zoom_fits(function.physical_to)) continue;
                    warn("zoom '" + function.name + "' goes from " + degrees(function.physical_from) +
                         " to " + degrees(function.physical_to) + range);
                    said = true;
                }
    }
}

} // namespace

double winding_number(const Mesh& mesh, const glm::mat4& world, const vec3& point_m) {
    const glm::dmat4 to_world(world);
    const double side = glm::determinant(glm::dmat3(to_world)) < 0.0 ? -1.0 : 1.0;
    double sum = 0.0;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        dvec3 corner[3];
        double length[3];
        vec3 normal(0);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = mesh.indices[k + c];
            corner[c] = dvec3(to_world * glm::dvec4(dvec3(mesh.positions[v]), 1.0)) - dvec3(point_m);
            length[c] = glm::length(corner[c]);
            normal += mesh.normals[v];
        }
        // Solid angle of a triangle (Van Oosterom and Strackee 1983).
        const double volume = glm::dot(corner[0], glm::cross(corner[1], corner[2]));
        const double below = length[0] * length[1] * length[2] + glm::dot(corner[0], corner[1]) * length[2] +
                             glm::dot(corner[1], corner[2]) * length[0] +
                             glm::dot(corner[2], corner[0]) * length[1];
        const double angle = 2.0 * std::atan2(volume, below);
        // Files disagree about winding, so only the normals say which side is the front.
        const vec3 facet = glm::cross(mesh.positions[mesh.indices[k + 1]] - mesh.positions[mesh.indices[k]],
                                      mesh.positions[mesh.indices[k + 2]] - mesh.positions[mesh.indices[k]]);
        if (!std::isfinite(angle)) continue;
        sum += glm::dot(facet, normal) < 0.0f ? -angle : angle;
    }
    return side * sum / (4.0 * kPi);
}

int instance_around(const Stage& stage, const vec3& point_m) {
    return Around(stage).find(point_m);
}

void check_places(const Show& show, const Stage& stage, std::span<const Camera> cameras, Report& report) {
    check_optics(show, report);
    Around around(stage);
    for (const Camera& camera : cameras)
        if (const int object = around.find(camera.position_m); object != kNone)
            report.add(Severity::warning, show.file.string(),
                       "camera '" + camera.name + "' stands inside '" + name_of(stage, object) +
                           "' and sees that from within");
    for (const PatchedFixture& fixture : show.fixtures) {
        if (!fixture.type) continue;
        for (std::size_t stop = 0; stop < fixture.stops_m().size(); ++stop)
            if (const int object = around.find_any(light_places_m(fixture, stop)); object != kNone) {
                report.add(
                    Severity::warning, show.file.string(),
                    "the light of fixture '" + fixture.name + "' is inside '" + name_of(stage, object) +
                        (around.is_closed() ? "' and lights only that, from within"
                                            : "', which is open: only what leaves it is seen outside"));
                break;
            }
    }
    if (!around.skipped().empty())
        report.add(Severity::note, show.file.string(),
                   "whether all cameras and lights are outside of these objects was not looked at, they have "
                   "too many triangles: " +
                       name_list({around.skipped().begin(), around.skipped().end()}));
}

} // namespace ghost::scene
