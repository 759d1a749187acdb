// SPDX-License-Identifier: Apache-2.0
#include "live/engine/rig_news.h"

#include "beam_groups/light_places.h"
#include "diagnose/explain_print.h"
#include "live/lux/light_meter.h"
#include "photometry/photometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kRigEvery_s = 0.05;
constexpr double kExplainEvery_s = 0.25;
constexpr double kVerdictsEvery_s = 3;

std::vector<ui::Verdict> verdicts_of(const scene::Explainer& explainer, std::size_t fixtures) {
    std::vector<ui::Verdict> verdicts;
    for (std::size_t i = 0; i < fixtures; ++i) {
        const scene::Explanation explanation = explainer.explain(i);
        const auto why = std::find_if(explanation.findings.begin(), explanation.findings.end(),
                                      [](const scene::Reason& reason) { return reason.blocks; });
        verdicts.push_back({explanation.visibility, explanation.cause,
                            why == explanation.findings.end() ? explanation.verdict : why->group});
    }
    return verdicts;
}

} // namespace

void RigNews::publish(const Session& session, const LiveInput& input, const RemoteRequest& remote,
                      const scene::FrameLights& drawn, std::optional<double> recorded_s, double now_s) {
    if (now_s - sent_s_ < kRigEvery_s) return;
    sent_s_ = now_s;
    ui::RigNow rig;
    rig.universes = input.universes();
    rig.from_desk = input.shows_desk();
    rig.at_s = input.at_s();
    rig.seeks = input.seeks();
    rig.recording_s = input.recording_s();
    rig.timecode = input.timecode_text();
    rig.remote = {remote.master, remote.blackout, remote.haze, remote.ev100, remote.tone};
    if (recorded_s) rig.recorded_s = *recorded_s;
    for (std::size_t k = 0; k < session.show->movers.size(); ++k)
        rig.movers.push_back({session.rig->movers().values(k), session.rig->movers().goals(k),
                              session.rig->movers().goals_without_hand(k)});
    const std::vector<fixture::State>& states = session.rig->states();
    std::size_t face = 0; // one for each beam of a fixture with a type
    for (std::size_t i = 0; i < states.size(); ++i) {
        const scene::PatchedFixture& fixture = session.show->fixtures[i];
        ui::FixtureNow now;
        now.light_m = glm::vec3(session.rig->moved(i) * glm::vec4(scene::light_position_m(fixture, 0), 1.0f));
        now.turned = glm::mat3(session.rig->moved(i));
        now.pan_deg = states[i].pan_deg;
        now.tilt_deg = states[i].tilt_deg;
        float brightest_cd = -1;
        for (const fixture::BeamState& beam : states[i].beams) {
            if (!fixture.type || face >= drawn.faces.size()) break;
            const shared::Light& shines = drawn.faces[face++].light;
            const glm::vec3& cd = shines.intensity_cd;
            const float most_cd = std::max({cd.x, cd.y, cd.z});
            now.candela += most_cd * scene::measured_fraction(shines);
            if (most_cd <= brightest_cd) continue;
            brightest_cd = most_cd;
            now.light_m = shines.position_m + shines.lens_m * shines.axis_w;
            now.direction = shines.axis_w;
            now.colour = most_cd > 0 ? cd / most_cd : glm::vec3(0);
            now.dimmer = beam.optics.dimmer * beam.optics.shutter;
            now.zoom_deg = beam.optics.zoom_deg;
            now.gobo.reset();
            if (!beam.optics.gobo_wheels.empty() && !beam.optics.gobo_wheels.front().spinning)
                now.gobo = static_cast<int>(std::lround(beam.optics.gobo_wheels.front().position));
        }
        if (session.rig->is_left_dark(i)) now.dimmer = 0; // whatever its file says
        now.asked = {.intensity = now.dimmer,
                     .zoom_deg = now.zoom_deg,
                     .pan_deg = now.pan_deg,
                     .tilt_deg = now.tilt_deg};
        if (const fixture::Programmer* asked = session.rig->asked(i)) now.asked = *asked;
        if (session.rig->is_left_dark(i)) now.asked.intensity = 0.0f;
        now.is_dark_without_hands = session.rig->is_dark_without_hands(i);
        rig.fixtures.push_back(now);
    }
    link_.rig.put(std::move(rig));
    link_.on_news();
}

void RigNews::explain(const Question& question, const Session& session, const LiveInput& input,
                      const scene::PatchMap& patch, const std::function<const bake::Tracer&()>& rays_of,
                      double now_s) {
    const auto is_due = [&](const std::optional<std::size_t>& fixture, double last_s) {
        return fixture && *fixture < session.show->fixtures.size() && now_s - last_s >= kExplainEvery_s;
    };
    // Nothing is said of another one until it is.
    if (question.fixture != std::exchange(asked_, question.fixture)) explained_s_ = -kExplainEvery_s;
    const bool explains_one = is_due(question.fixture, explained_s_);
    const bool explains_hovered = is_due(question.hovered, hovered_s_);
    const bool explains_all = question.all && now_s - verdicts_s_ >= kVerdictsEvery_s;
    const std::size_t of_second = link_.question.take().value_or(session.show->fixtures.size());
    const bool explains_second = of_second < session.show->fixtures.size();
    if (!explains_one && !explains_hovered && !explains_all && !explains_second) return;
    const bake::DenormalsOff mode;
    const bake::Tracer& rays = rays_of();
    const scene::Stage& stage = rays.stage();
    const scene::Reception reception = input.reception(patch);
    const Atmosphere air = session.atmosphere();
    const scene::ExplainInput asked{
        .show = *session.show,
        .report = session.report,
        .rig = *session.rig,
        .gobos = session.gobos,
        .universes = input.universes(),
        .reception = reception,
        .now_s = input.now_s(),
        .haze = &air.haze,
        .stage = stage.instances.empty() ? nullptr : &stage,
        .first_hit =
            [&](const glm::vec3& origin, const glm::vec3& direction) {
                const bake::Surface hit = rays.first_hit(origin, direction, -1.0f, bake::Sees::no_bodies);
                return scene::ExplainInput::Seen{hit.instance, hit.distance_m, hit.facet_normal};
            },
        .bounced_lx = bounced_lx_in(session.bounced.get()),
    };
    const scene::Explainer explainer(asked);
    const auto explained = [&](std::size_t fixture) {
        ui::Explained news;
        news.fixture = fixture;
        news.explanation = explainer.explain(fixture);
        news.words = scene::words_of(news.explanation, reception);
        return news;
    };
    if (explains_one) {
        explained_s_ = now_s;
        link_.explained.put(explained(*question.fixture));
    }
    if (explains_hovered) {
        hovered_s_ = now_s;
        link_.hovered.put(explained(*question.hovered));
    }
    if (explains_second) link_.answer.put(explained(of_second));
    if (explains_all) {
        verdicts_s_ = now_s;
        link_.verdicts.put(verdicts_of(explainer, session.show->fixtures.size()));
    }
    link_.on_news();
}

} // namespace ghost::app
