// SPDX-License-Identifier: Apache-2.0
// What the engine says to the window: each piece of news whole, as often as it changes or as a person can
// read it.
#include "live/engine/engine.h"

#include "beam_groups/light_places.h"
#include "diagnose/explain_print.h"
#include "photometry/photometry.h"

#include <algorithm>
#include <cmath>

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

void Engine::publish_opened(Opening opening) {
    ui::Opened news = opened_from(*session_);
    auto own = std::make_shared<scene::Show>(*news.show); // without what hands set
    look_->take_off(*own);
    news.show = std::move(own);
    news.recording_s = input_->recording_s();
    news.opens = opens_;
    news.again = opening == Opening::newer_plot;
    news.is_edit = opening == Opening::edit;
    news.text = text_;
    link_.opened.put(std::move(news));
    publish_messages();
    link_.on_news();
}

void Engine::publish_rest(double now_s, bool drew) {
    const bool has_text = !request_.text || request_.text == text_;
    const bool rests = !drew && has_text && !reopening_.valid() && now_s - last_change_s_ >= kRest_s &&
                       !session_->live->is_making_maps() && !baked_loading_.valid();
    if (!rests || settled_ == request_.number) return;
    settled_ = request_.number;
    link_.settled.put(settled_);
    link_.on_news();
}

void Engine::publish_picture(const render::FrameStatistics& statistics, double draw_ms) {
    ui::Picture picture;
    picture.image = request_.false_colour.measure == ui::Measure::none
                        ? std::make_shared<const image::Image8>(relighter().picture())
                        : probe_.false_colours(request_.false_colour, shown());
    picture.false_colour = false_colour_ = request_.false_colour;
    picture.camera = drawn_from_;
    picture.framed = framed_;
    picture.ev100 = relighter().ev100_used();
    picture.draw_ms = draw_ms;
    picture.lights_drawn = statistics.drawn;
    picture.is_baked = shows_baked_;
    picture.supply = supply_sent_ = supply_;
    picture.is_coarse = !shows_baked_ && request_.quality.percent == 0 && drawn_from_.width < whole_.x;
    picture.missing_maps = session_->live->missing_maps();
    picture.has_work_light = !shows_baked_ && work_lux_ > 0;
    picture.arrival = std::exchange(arrival_, std::chrono::nanoseconds{0});
    link_.picture.put(std::move(picture), [](const ui::Picture& unread, ui::Picture& next) {
        if (unread.arrival.count() > 0) next.arrival = unread.arrival;
    });
    link_.on_news();
}

void Engine::publish_rig(double now_s) {
    if (now_s - rig_sent_s_ < kRigEvery_s) return;
    rig_sent_s_ = now_s;
    ui::RigNow rig;
    rig.universes = input_->universes();
    rig.from_desk = input_->shows_desk();
    rig.at_s = input_->at_s();
    rig.recording_s = input_->recording_s();
    if (const std::optional<double> recorded_s = recorder_.seconds()) rig.recorded_s = *recorded_s;
    const std::vector<fixture::State>& states = session_->rig->states();
    std::size_t face = 0; // one for each beam of a fixture with a type
    for (std::size_t i = 0; i < states.size(); ++i) {
        const scene::PatchedFixture& fixture = session_->show->fixtures[i];
        ui::FixtureNow now;
        now.light_m = scene::light_position_m(fixture, 0);
        now.pan_deg = states[i].pan_deg;
        now.tilt_deg = states[i].tilt_deg;
        float brightest_cd = -1;
        for (const fixture::BeamState& beam : states[i].beams) {
            if (!fixture.type || face >= drawn_.faces.size()) break;
            const shared::Light& shines = drawn_.faces[face++].light;
            const glm::vec3& cd = shines.intensity_cd;
            const float most_cd = std::max({cd.x, cd.y, cd.z});
            now.candela += most_cd * scene::measured_share(shines);
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
        now.asked = {.intensity = now.dimmer,
                     .zoom_deg = now.zoom_deg,
                     .pan_deg = now.pan_deg,
                     .tilt_deg = now.tilt_deg};
        if (const fixture::Programmer* asked = session_->rig->asked(i)) now.asked = *asked;
        rig.fixtures.push_back(now);
    }
    link_.rig.put(std::move(rig));
    link_.on_news();
}

void Engine::publish_explanation(double now_s) {
    const bool explains_one = request_.explained && *request_.explained < session_->show->fixtures.size() &&
                              now_s - explained_s_ >= kExplainEvery_s;
    const bool explains_all = request_.explains_all && now_s - verdicts_s_ >= kVerdictsEvery_s;
    if (!explains_one && !explains_all) return;
    const bake::DenormalsOff mode;
    const bake::Tracer& rays = probe_.tracer(*session_);
    const scene::Stage& stage = rays.stage();
    const scene::Reception reception = input_->reception(patch_);
    const scene::ExplainInput input{
        .show = *session_->show,
        .report = session_->report,
        .rig = *session_->rig,
        .gobos = session_->gobos,
        .universes = input_->universes(),
        .reception = reception,
        .now_s = input_->now_s(),
        .stage = stage.instances.empty() ? nullptr : &stage,
        .first_hit =
            [&](const glm::vec3& origin, const glm::vec3& direction) {
                const bake::Surface hit = rays.first_hit(origin, direction, -1.0f, bake::Sees::no_bodies);
                return scene::ExplainInput::Seen{hit.instance, hit.distance_m, hit.facet_normal};
            },
    };
    const scene::Explainer explainer(input);
    if (explains_one) {
        explained_s_ = now_s;
        ui::Explained explained;
        explained.fixture = *request_.explained;
        explained.explanation = explainer.explain(explained.fixture);
        explained.words = scene::words_of(explained.explanation, reception);
        link_.explained.put(std::move(explained));
    }
    if (explains_all) {
        verdicts_s_ = now_s;
        link_.verdicts.put(verdicts_of(explainer, session_->show->fixtures.size()));
    }
    link_.on_news();
}

void Engine::publish_messages() {
    messages_sent_ = session_->report.messages.size();
    std::vector<Message> all = of_receiver_;
    all.insert(all.end(), news_.begin(), news_.end());
    all.insert(all.end(), session_->report.messages.begin(), session_->report.messages.end());
    link_.messages.put(std::move(all));
    link_.on_news();
}

} // namespace ghost::app
