#pragma once
// SPDX-License-Identifier: Apache-2.0
// For the tests of explain: a show of a fixture or two that is made here: a lamp of 10000 lm, 6 m above a
// floor.

#include "diagnose/explain.h"
#include "show/show.h"

#include "diagnose/explain_print.h"
#include "photometry/photometry.h"
#include "support/must.h"
#include "support/tiny_gdtf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ghost::scene::trial {

using glm::vec3;
using std::string;

inline string function(const string& name, const string& attribute, int from, float physical_from,
                       float physical_to, const string& more = "", const string& inside = "") {
    return "<ChannelFunction Name=\"" + name + "\" Attribute=\"" + attribute + "\" DMXFrom=\"" +
           std::to_string(from) + "/1\" PhysicalFrom=\"" + std::to_string(physical_from) +
           "\" PhysicalTo=\"" + std::to_string(physical_to) + "\" " + more + ">" + inside +
           "</ChannelFunction>";
}

inline string channel(const string& offset, const string& attribute, const string& functions,
                      const string& geometry = "Beam") {
    return "<DMXChannel Offset=\"" + offset + "\" Geometry=\"" + geometry +
           "\"><LogicalChannel Attribute=\"" + attribute + "\">" + functions +
           "</LogicalChannel></DMXChannel>";
}

inline string simple(const string& offset, const string& attribute, float from = 0, float to = 1,
                     const string& more = "") {
    return channel(offset, attribute, function(attribute, attribute, 0, from, to, more));
}

inline const string kDimmer = simple("1", "Dimmer");
inline const string kShutter =
    channel("2", "Shutter1",
            function("Open", "Shutter1", 8, 1, 1) + function("Closed", "Shutter1", 0, 0, 0) +
                function("Flash", "Shutter1Strobe", 128, 1, 10));
inline const string kBeam = "<Beam Name=\"Beam\" BeamType=\"Spot\" LuminousFlux=\"10000\" BeamAngle=\"20\" "
                            "FieldAngle=\"25\" BeamRadius=\"0.05\"/>";

inline std::shared_ptr<const fixture::Type> type_of(const string& channels, const string& beam = kBeam,
                                                    const string& wheels = "", const string& relations = "") {
    fixture::Description description;
    description.wheels = wheels;
    description.geometries = "<Geometry Name=\"Base\">" + beam + "</Geometry>";
    description.channels = channels;
    string xml = description.xml();
    const string end = "</DMXChannels>";
    xml.insert(xml.find(end) + end.size(), relations);
    return std::make_shared<const fixture::Type>(must(fixture::load_xml(xml)).type);
}

inline Mesh quad(const vec3& corner, const vec3& a, const vec3& b) {
    Mesh mesh;
    mesh.positions = {corner, corner + a, corner + a + b, corner + b};
    mesh.normals.assign(4, glm::normalize(glm::cross(a, b)));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

inline Mesh box(const vec3& half) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            vec3 n(0), a(0), b(0);
            n[axis] = side;
            a[(axis + 1) % 3] = 1;
            b = glm::cross(n, a);
            const Mesh face = quad((n - a - b) * half, 2.0f * a * half, 2.0f * b * half);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.insert(mesh.positions.end(), face.positions.begin(), face.positions.end());
            mesh.normals.insert(mesh.normals.end(), 4, n);
            for (const std::uint32_t k : face.indices) mesh.indices.push_back(first + k);
        }
    return mesh;
}

inline void hang(Stage& stage, const string& name, Mesh mesh, const vec3& place_m = vec3(0)) {
    glm::mat4 world(1.0f);
    world[3] = glm::vec4(place_m, 1.0f);
    stage.instances.push_back({name, static_cast<int>(stage.meshes.size()), world});
    stage.meshes.push_back(std::move(mesh));
}

// Every triangle of the stage (Moeller and Trumbore 1997).
inline ExplainInput::Seen first_hit(const Stage& stage, const vec3& origin, const vec3& way) {
    ExplainInput::Seen seen;
    float best = std::numeric_limits<float>::max();
    for (std::size_t k = 0; k < stage.instances.size(); ++k) {
        const Mesh& mesh = stage.meshes[static_cast<std::size_t>(stage.instances[k].mesh)];
        const auto corner = [&](std::size_t i) {
            return vec3(stage.instances[k].world * glm::vec4(mesh.positions[mesh.indices[i]], 1.0f));
        };
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const vec3 a = corner(i + 1) - corner(i), b = corner(i + 2) - corner(i);
            const vec3 p = glm::cross(way, b);
            const float det = glm::dot(a, p);
            if (std::abs(det) < 1e-9f) continue;
            const vec3 from = origin - corner(i);
            const float u = glm::dot(from, p) / det;
            const vec3 q = glm::cross(from, a);
            const float v = glm::dot(way, q) / det;
            const float t = glm::dot(b, q) / det;
            if (u < 0 || v < 0 || u + v > 1 || t < 1e-5f || t > best) continue;
            best = t;
            seen = {static_cast<int>(k), t, glm::normalize(glm::cross(a, b))};
        }
    }
    return seen;
}

struct Trial {
    Show show;
    Report report;
    Stage stage;
    bool has_stage = true;
    std::map<int, dmx::Levels> levels;
    std::map<std::size_t, fixture::Programmer> hands; // by fixture
    dmx::Universes universes;                         // instead of levels, where it has any
    Reception reception;
    double dt_s = 1.0 / 30;
    int steps = 1;
    bool leaves_unasked_dark = false;
    int beam = -1; // of the first fixture: what is asked about

    Trial() {
        hang(stage, "floor", quad({-20, -20, 0}, {40, 0, 0}, {0, 40, 0}));
        show.haze.extinction_per_m = 0;
        reception.kind = Reception::Kind::recording;
        reception.recording = "test.show";
    }
    explicit Trial(const std::shared_ptr<const fixture::Type>& type) : Trial() { add("Lamp", type, 1); }

    PatchedFixture& add(const string& name, const std::shared_ptr<const fixture::Type>& type, int address) {
        PatchedFixture fixture;
        fixture.name = name;
        fixture.gdtf = "lamps/tiny.gdtf";
        fixture.type = type;
        fixture.address = address;
        fixture.position_m = {0, 0, 6};
        show.fixtures.push_back(fixture);
        return show.fixtures.back();
    }
    Trial& set(int address, int value, int universe = 1) {
        levels[universe][static_cast<std::size_t>(address - 1)] = static_cast<std::uint8_t>(value);
        return *this;
    }
    Explanation explain(std::size_t fixture = 0) { return all().at(fixture); }
    std::vector<Explanation> all() {
        for (const auto& [number, values] : levels) {
            universes.at(static_cast<std::uint16_t>(number)).levels =
                std::make_shared<const dmx::Levels>(values);
            reception.first_frames_s.emplace_back(number, 0.0);
        }
        const GoboStack gobos = build_gobos(show, report);
        Rig rig(show);
        rig.leave_unasked_dark(leaves_unasked_dark);
        for (int step = 0; step < steps; ++step) rig.step(universes, dt_s, hands);
        ExplainInput input{show, report, rig, gobos, universes, reception};
        input.now_s = 10;
        if (has_stage) {
            input.stage = &stage;
            input.first_hit = [&](const vec3& o, const vec3& d) { return first_hit(stage, o, d); };
        }
        const Explainer explainer(input);
        std::vector<Explanation> explanations;
        for (std::size_t i = 0; i < show.fixtures.size(); ++i)
            explanations.push_back(explainer.explain(i, i == 0 ? beam : -1));
        return explanations;
    }
};

inline void expect(const Explanation& explanation, Visibility visibility, Cause cause,
                   const std::vector<string>& words) {
    EXPECT_STREQ(visibility_name(explanation.visibility), visibility_name(visibility)) << explanation.verdict;
    EXPECT_STREQ(cause_name(explanation.cause), cause_name(cause)) << explanation.verdict;
    for (const string& word : words)
        EXPECT_NE(explanation.verdict.find(word), string::npos)
            << "'" << word << "' in: " << explanation.verdict;
}

inline const Reason* find(const Explanation& explanation, Cause cause) {
    for (const Reason& finding : explanation.findings)
        if (finding.cause == cause) return &finding;
    return nullptr;
}

} // namespace ghost::scene::trial
