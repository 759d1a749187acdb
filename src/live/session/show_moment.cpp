// SPDX-License-Identifier: Apache-2.0
#include "live/session/show_moment.h"

#include "beam_groups/prism.h"
#include "dmx/record/recording_tasks.h"
#include "light/bodies.h"
#include "live/session/media_player.h"

#include "base/log.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::app {

Result<std::unique_ptr<ShowMoment>> ShowMoment::open(const SessionOptions& options, const std::string& replay,
                                                     const dmx::CaptureOptions& capture, Report& report) {
    auto moment = std::unique_ptr<ShowMoment>(new ShowMoment);
    TRY(scene::Show opened, open_show(options.show, false, options.quiet, report));
    moment->show_ = std::make_unique<scene::Show>(std::move(opened));
    scene::Show& show = *moment->show_;
    show.motion = options.motion.value_or(show.motion);
    load_stage(show, report);
    moment->gobos_ = scene::build_gobos(show, report);
    scene::check_prisms(show, report);
    moment->stage_ = scene::stage_with_bodies(show, report);
    moment->carried_ = scene::carried_objects(show, moment->stage_);
    moment->rig_ = std::make_unique<scene::Rig>(show);
    const std::filesystem::path file = replay.empty() ? show.recording : std::filesystem::path(replay);
    if (file.empty()) return Error{"has no recording; name one with --replay FILE", show.file.string()};
    TRY(dmx::Recording recording, open_recording(file, capture, options.quiet));
    moment->player_.emplace(std::move(recording));
    return moment;
}

void ShowMoment::step_to(double at_s, int fps, Report& report) {
    if (at_s > player_->duration_s())
        log_warning("the recording ends at " + std::to_string(player_->duration_s()) +
                    " s; what is drawn is its last look");
    const double rate = fps;
    for (const long last = std::lround(std::max(at_s, 0.0) * rate); next_ <= last; ++next_) {
        rig_->set_time(static_cast<double>(next_) / rate);
        rig_->step(player_->at(static_cast<double>(next_) / rate), 1.0 / rate);
    }
    log_damage(*player_);
    if (!show_->media.empty()) MediaPlayer(*show_, gobos_).show(std::max(at_s, 0.0), true, gobos_, report);
    scene::pose_bodies(*show_, *rig_, stage_);
    scene::pose_objects(*rig_, carried_, stage_);
}

std::vector<shared::Light> ShowMoment::lights() const {
    return rig_->lit(gobos_, scene::DistanceMaps{}, scene::Cells::apart).lights;
}

} // namespace ghost::app
