// SPDX-License-Identifier: Apache-2.0
// Where the camera stands as one of the show whose passes are fresh, these are shown instead of the live
// picture; else the window says why not.
#include "live/engine/engine.h"

#include "files/files.h"
#include "passes/passes_file.h"

#include <filesystem>

namespace ghost::app {
namespace {

constexpr double kLookEvery_s = 1;

bool stands_as(const scene::Camera& a, const scene::Camera& b) {
    return a.position_m == b.position_m && a.target_m == b.target_m;
}

// Another one means that it was baked meanwhile.
std::string stamp_of(const scene::Show& show, const scene::Camera& camera) {
    std::error_code code;
    const auto folder = camera.foreign_passes.empty() ? scene::passes_folder(show, camera.name)
                                                      : camera.foreign_passes.parent_path();
    std::string stamp = camera.name;
    for (const char* const file : {"manifest.json", "sources.txt"}) {
        const auto time = std::filesystem::last_write_time(folder / file, code);
        stamp += " " + (code ? std::string("none") : std::to_string(time.time_since_epoch().count()));
    }
    return stamp;
}

} // namespace

// Why the picture has to be drawn live whatever is baked; empty: it need not be.
std::string Engine::needs_live() const {
    const ui::Look& look = request_.look;
    if (!request_.takes_baked) return "baked pictures are turned off";
    if (has_work_light()) return "the work light is on";
    if (request_.quality.percent > 0) return "a share of the pixels is asked for";
    if (request_.false_colour.measure == ui::Measure::lux) return "lux are measured on surfaces";
    if (!look.shown.empty()) return "objects are hidden or shown by hand";
    if (!look.surfaces.empty()) return "surfaces are set by hand";
    if (!(look.scene == ui::SceneLook{})) return "air, even light or shadows are set by hand";
    if (remote_request_.haze != 1.0f) return "a remote control sets the haze";
    if (trackers_) return "trackers may move what is on stage";
    if (is_unsaved_) return "the show has changes that are not saved";
    return "";
}

bool Engine::choose_baked(double now_s) {
    const std::vector<scene::Camera>& cameras = session_->show->cameras;
    const scene::Camera* stands = nullptr;
    for (std::size_t i = 0; i < cameras.size() && !stands; ++i)
        if (i != session_->camera && stands_as(cameras[i], wanted_camera_) &&
            cameras[i].fov_y_deg == request_.camera.fov_y_deg)
            stands = &cameras[i];
    if (!stands) {
        supply_ = "live: a free camera";
        return false;
    }
    if (now_s - baked_looked_s_ >= kLookEvery_s || baked_for_ != stands->name) {
        baked_looked_s_ = now_s;
        baked_for_ = stands->name;
        const auto saved =
            text_ ? read_text_file(session_->show->file, scene::kMaxShowBytes) : Result<std::string>("");
        is_unsaved_ = text_ && (!saved.ok() || *saved != *text_);
        const std::string stamp = stamp_of(*session_->show, *stands);
        if (stamp != baked_stamp_ && !baked_loading_.valid()) {
            baked_stamp_ = stamp;
            baked_.reset();
            baked_why_not_ = "its passes are being read";
            baked_loading_ = std::async(std::launch::async, load_baked, std::cref(*session_->show), *stands);
        }
    }
    take_baked();
    const bool has_passes = baked_ && baked_->camera().name == stands->name;
    const std::string why_live = needs_live();
    const std::string why_not =
        !why_live.empty() ? why_live
        : has_passes      ? why_too_coarse(baked_->camera(), {wanted_camera_.width, wanted_camera_.height})
                          : baked_why_not_;
    supply_ = why_not.empty()
                  ? "baked: " + stands->name + ", " + std::to_string(baked_->pass_count()) + " passes"
                  : "live: " + stands->name + ", because " + why_not;
    return why_not.empty();
}

void Engine::take_baked() {
    if (!baked_loading_.valid() ||
        baked_loading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    BakedPasses loaded = baked_loading_.get();
    baked_why_not_ = loaded.why_not;
    if (!baked_why_not_.empty()) return;
    auto view = BakedView::create(*session_, std::move(loaded));
    if (view.ok())
        baked_ = std::move(*view);
    else
        baked_why_not_ = view.error().text();
}

void Engine::forget_baked() {
    if (baked_loading_.valid()) baked_loading_.wait();
    baked_loading_ = {};
    baked_.reset();
    baked_for_.clear();
    baked_stamp_.clear();
    shows_baked_ = false;
}

} // namespace ghost::app
