// SPDX-License-Identifier: Apache-2.0
// Where a beam arrives: what its middle meets first, how many lux there, and what hides it.
#include "diagnose/explain_parts.h"

#include "shared/beam.h"
#include "show/show.h"
#include "show_folder/place_checks.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene::explained {
namespace {

constexpr float kBehind_m = 0.1f; // an object nearer to the lens than this stops the beam at the fixture
constexpr float kEdge = 0.7f;     // where else the beam is looked along, of its half extent
constexpr int kEdgeRays = 8;

// What a beam that leaves the stage does, in words.
std::string way_out(const glm::vec3& direction) {
    const double deg = glm::degrees(std::asin(std::clamp(static_cast<double>(direction.z), -1.0, 1.0)));
    if (std::abs(deg) < 0.5) return "level";
    return number(std::abs(deg)) + " degrees " + (deg > 0 ? "upwards" : "downwards");
}

std::string object_name(const Stage& stage, int instance) {
    const Instance& found = stage.instances[static_cast<std::size_t>(instance)];
    if (!found.name.empty()) return found.name;
    return stage.meshes[static_cast<std::size_t>(found.mesh)].name;
}

bool is_inside(const Stage& stage, int instance, const glm::vec3& point_m) {
    const Instance& found = stage.instances[static_cast<std::size_t>(instance)];
    const Mesh& mesh = stage.meshes[static_cast<std::size_t>(found.mesh)];
    if (mesh.normals.size() != mesh.positions.size()) return false;
    glm::vec3 low(1e30f), high(-1e30f);
    for (const glm::vec3& position : mesh.positions) {
        const glm::vec3 world(found.world * glm::vec4(position, 1.0f));
        low = glm::min(low, world);
        high = glm::max(high, world);
    }
    return glm::all(glm::lessThan(low, point_m)) && glm::all(glm::lessThan(point_m, high)) &&
           winding_number(mesh, found.world, point_m) > 0.5;
}

} // namespace

void look(const ExplainInput& input, const shared::Light& light, BeamFacts& facts) {
    const LitGate lit = lit_gate(light, input.gobos);
    const shared::Light outline = outline_of(light);
    const auto way_through = [&](const glm::vec2& gate) {
        const glm::vec2 aside = light.tan_field * gate;
        return glm::normalize(light.axis_w + aside.x * light.axis_u + aside.y * light.axis_v);
    };
    const auto first_hit = [&](const glm::vec3& way) {
        const float lens_m = light.lens_m / glm::dot(way, light.axis_w);
        auto seen = input.first_hit(light.position_m + way * lens_m, way);
        seen.distance_m += lens_m;
        return seen;
    };
    const glm::vec3 way = way_through(lit.middle);
    const auto seen = first_hit(way);
    if (seen.instance >= 0) {
        HitFacts hit;
        hit.object = object_name(*input.stage, seen.instance);
        hit.distance_m = seen.distance_m - light.lens_m / glm::dot(way, light.axis_w);
        hit.position_m = light.position_m + way * seen.distance_m;
        // What is a picture counts as the mean that it lets through.
        const glm::vec3 candela =
            shared::beam_candela(outline, shared::to_gate(light, way * seen.distance_m), input.gobos.images);
        const float towards_cd = facts.picture * facts.gobo * facts.animation * glm::dot(candela, kLuminance);
        hit.facing_lx = towards_cd / std::max(seen.distance_m * seen.distance_m, 1e-6f);
        hit.illuminance_lx = hit.facing_lx * std::abs(glm::dot(seen.normal, way));
        if (input.bounced_lx)
            hit.bounced_lx =
                input.bounced_lx(hit.position_m, glm::dot(seen.normal, way) > 0 ? -seen.normal : seen.normal);
        hit.lens_inside = is_inside(*input.stage, seen.instance, facts.lens_m);
        facts.hit = hit;
        return;
    }
    for (int k = 0; k < kEdgeRays && facts.edge_object.empty(); ++k) {
        const float angle = 2.0f * shared::kPi * static_cast<float>(k) / kEdgeRays;
        const glm::vec2 gate = lit.middle + kEdge * lit.half * glm::vec2(std::cos(angle), std::sin(angle));
        const float z = light.lens_m + 1.0f / std::max(light.focus_per_m, 1e-4f);
        const glm::vec3 at = glm::vec3(gate * light.tan_field, 1.0f) * z;
        if (shared::beam_candela(outline, at, input.gobos.images) == glm::vec3(0.0f)) continue;
        const auto beside = first_hit(way_through(gate));
        if (beside.instance >= 0) facts.edge_object = object_name(*input.stage, beside.instance);
    }
}

// Light leaves, but it is not seen.
void add_unseen(const ExplainInput& input, BeamFacts& facts) {
    if (facts.hit && facts.hit->lens_inside) {
        facts.findings.push_back(
            {Cause::hidden,
             true,
             "its lens is inside of '" + facts.hit->object + "' and lights only that, from within",
             "they are inside of an object",
             {}});
    } else if (facts.hit && facts.hit->distance_m < kBehind_m) {
        facts.findings.push_back(
            {Cause::hidden,
             true,
             "'" + facts.hit->object + "' is right before its lens (" +
                 number(static_cast<double>(std::max(facts.hit->distance_m, 0.0f)) * 100.0, 1) +
                 " cm) and stops the light",
             "an object is right before their lens",
             {}});
    }
    if (facts.hit || !facts.edge_object.empty()) return;
    const HazeMedium& air = input.haze ? *input.haze : input.show.haze;
    const bool haze = air.extinction_per_m > 0.0f && air.albedo > 0.0f;
    facts.findings.push_back(
        {Cause::away,
         !haze,
         "it points " + way_out(facts.direction) + " and away from everything; " +
             (haze ? "only its beam in the haze is seen" : "there is no haze to show its beam"),
         "they point away from everything",
         {}});
}

std::string width_text(const BeamFacts& facts) {
    const std::string extent = number(static_cast<double>(facts.lit_deg.x), 1) + " x " +
                               number(static_cast<double>(facts.lit_deg.y), 1) + " deg";
    if (facts.projects) return "picture " + extent;
    return "beam " + number(static_cast<double>(facts.beam_deg), 1) + " deg" +
           (facts.is_cut ? ", cut to " + extent : "");
}

std::string hit_text(const Explanation& explanation, const BeamFacts& facts) {
    if (facts.glows) return "it glows and throws no beam";
    if (!explanation.is_place_known) return "what it hits is not known (nobody says its place)";
    if (!explanation.is_rotation_known) return "what it hits is not known (nobody says how it is turned)";
    if (!explanation.looked) return "what it hits is not known (no stage)";
    if (facts.hit)
        return "hits '" + facts.hit->object + "' at " +
               number(static_cast<double>(facts.hit->distance_m), 1) + " m with " +
               number(static_cast<double>(facts.hit->illuminance_lx),
                      facts.hit->illuminance_lx < 10.0f ? 2 : 0) +
               " lx";
    if (!facts.edge_object.empty()) return "its middle hits nothing, its edge '" + facts.edge_object + "'";
    return "hits nothing: it leaves the stage " + way_out(facts.direction);
}

} // namespace ghost::scene::explained
