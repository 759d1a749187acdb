// SPDX-License-Identifier: Apache-2.0
#include "live/engine/followers.h"

#include "base/log.h"
#include "live/session/live_view.h"

#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace ghost::app {

namespace {

constexpr float kTooNear_m = 0.1f; // to look at

std::optional<glm::vec3> told_point_m(const scene::Show& show, const scene::TrackerUse& use,
                                      const dmx::Trackers& trackers) {
    const dmx::Tracker* tracker =
        use.id >= 0 ? trackers.find(static_cast<std::uint16_t>(use.id)) : trackers.find(use.name);
    if (!tracker) return std::nullopt;
    const auto& [x, y, z] = tracker->position_m;
    return show.tracking.to_world({x, y, z}) + use.offset_m;
}

// Sums of squares of what is farther are no numbers, and a camera that looks there has no picture.
bool is_of_a_stage(const glm::vec3& point_m) {
    constexpr auto kMost_m = static_cast<float>(scene::kMaxCoordinate_m);
    return std::abs(point_m.x) <= kMost_m && std::abs(point_m.y) <= kMost_m && std::abs(point_m.z) <= kMost_m;
}

} // namespace

std::optional<glm::vec3> tracked_point_m(const scene::Show& show, const scene::TrackerUse& use,
                                         const dmx::Trackers& trackers) {
    const auto point_m = told_point_m(show, use, trackers);
    return point_m && is_of_a_stage(*point_m) ? point_m : std::nullopt;
}

scene::Camera follow(const scene::Camera& camera, const scene::Show& show, const dmx::Trackers& trackers) {
    scene::Camera turned = camera;
    for (const scene::TrackerUse& use : show.tracking.uses) {
        if (use.camera.empty() || use.camera != camera.name) continue;
        const auto point_m = tracked_point_m(show, use, trackers);
        if (!point_m || glm::distance(turned.target_m, *point_m) < kStill_m ||
            glm::distance(turned.position_m, *point_m) < kTooNear_m)
            continue;
        turned.target_m = *point_m;
    }
    return turned;
}

void Followers::move_objects(Session& session, const scene::TrackerUse& use, const glm::vec3& point_m,
                             Home& home) {
    if (!session.live) {
        if (!std::exchange(said_passes_, true))
            log_warning("trackers: objects of baked passes do not move; --live draws them anywhere");
        return;
    }
    if (!home.known) {
        home.known = true;
        home.objects = session.live->objects_named(use.objects, steps_);
        home.at_m = session.live->track(home.objects);
        if (home.at_m && use.home_m) home.at_m = use.home_m;
        if (!home.at_m) {
            const std::size_t said = session.report.messages.size();
            session.report.add(
                Severity::error, use.where,
                steps_ == 0
                    ? std::string("[[tracker]] ") + kMatchStepsSpent
                    : "[[tracker]] objects names no object of the stage, or only such as movers carry");
            print_report(session.report, said);
        }
    }
    if (home.at_m) session.live->move_tracked(home.objects, point_m - *home.at_m);
}

void Followers::apply(Session& session, const dmx::Trackers& trackers) {
    const scene::Show& show = *session.show;
    homes_.resize(show.tracking.uses.size());
    for (std::size_t k = 0; k < show.tracking.uses.size(); ++k) {
        const scene::TrackerUse& use = show.tracking.uses[k];
        const auto point_m = told_point_m(show, use, trackers);
        if (!point_m) continue;
        if (!is_of_a_stage(*point_m)) {
            if (std::exchange(homes_[k].said_far, true)) continue;
            const std::size_t said = session.report.messages.size();
            session.report.add(Severity::warning, use.where,
                               "the tracker tells a place that is farther than 10 km away: what follows it "
                               "stays where it is");
            print_report(session.report, said);
            continue;
        }
        if (!homes_[k].fixtures) {
            const std::set<std::string_view> named(use.fixtures.begin(), use.fixtures.end());
            homes_[k].fixtures.emplace();
            for (std::size_t i = 0; i < show.fixtures.size(); ++i)
                if (named.contains(show.fixtures[i].name)) homes_[k].fixtures->push_back(i);
        }
        for (const std::size_t i : *homes_[k].fixtures) session.rig->aim_at(i, *point_m);
        if (!use.objects.empty()) move_objects(session, use, *point_m, homes_[k]);
    }
    heard_.resize(show.movers.size());
    for (std::size_t k = 0; k < show.movers.size(); ++k) {
        const scene::Mover& mover = show.movers[k];
        if (!mover.has_tracker()) continue;
        const dmx::Tracker* const tracker = mover.tracker_id >= 0
                                                ? trackers.find(static_cast<std::uint16_t>(mover.tracker_id))
                                                : trackers.find(mover.tracker);
        if (!tracker || tracker->heard == std::exchange(heard_[k], tracker->heard)) continue;
        const auto& [x, y, z] = tracker->position_m;
        session.rig->movers().follow(k, show.tracking.to_world({x, y, z}));
    }
}

} // namespace ghost::app
