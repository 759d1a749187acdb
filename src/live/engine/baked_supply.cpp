// SPDX-License-Identifier: Apache-2.0
#include "live/engine/baked_supply.h"

#include "disk/files.h"
#include "passes/passes_file.h"

#include <filesystem>

namespace ghost::app {
namespace {

constexpr double kLookEvery_s = 1;

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

// That of the show which stands there, but for the one of the live picture; or null.
const scene::Camera* standing_as(const scene::Camera& camera, float fov_y_deg, const Session& session) {
    const std::vector<scene::Camera>& cameras = session.show->cameras;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        if (i != session.camera && cameras[i].position_m == camera.position_m &&
            cameras[i].target_m == camera.target_m && cameras[i].fov_y_deg == fov_y_deg)
            return &cameras[i];
    return nullptr;
}

} // namespace

bool BakedSupply::choose(const Session& session, const Wanted& wanted, double now_s) {
    const scene::Camera* const stands = standing_as(wanted.camera, wanted.fov_y_deg, session);
    if (!stands) {
        words_ = "live: a free camera";
        return false;
    }
    if (now_s - looked_s_ >= kLookEvery_s || camera_ != stands->name) {
        looked_s_ = now_s;
        camera_ = stands->name;
        look(session, *stands, wanted);
    }
    take(session);
    const bool has_passes = view_ && view_->camera().name == stands->name;
    const std::string why_not =
        !wanted.needs_live.empty() ? wanted.needs_live
        : is_unsaved_              ? "the show has changes that are not saved"
        : has_passes ? why_too_coarse(view_->camera(), {wanted.camera.width, wanted.camera.height})
                     : why_not_;
    words_ = why_not.empty()
                 ? "baked: " + stands->name + ", " + std::to_string(view_->pass_count()) + " passes"
                 : "live: " + stands->name + ", because " + why_not;
    return why_not.empty();
}

void BakedSupply::look(const Session& session, const scene::Camera& stands, const Wanted& wanted) {
    const scene::Show& show = *session.show;
    const auto saved =
        wanted.text ? read_text_file(show.file, scene::kMaxShowBytes) : Result<std::string>("");
    is_unsaved_ = wanted.text && (!saved.ok() || *saved != *wanted.text);
    const std::string stamp = stamp_of(show, stands);
    if (stamp == stamp_ || reading_.valid()) return;
    view_.reset();
    stamp_.clear();
    // Reading and uploading what is not shown would only take time from the live picture.
    std::error_code code;
    if (stands.foreign_passes.empty() &&
        std::filesystem::exists(scene::passes_folder(show, stands.name) / "manifest.json", code)) {
        why_not_ = why_too_coarse(stands, {wanted.camera.width, wanted.camera.height});
        if (!why_not_.empty()) return;
    }
    stamp_ = stamp;
    why_not_ = "its passes are being read";
    reading_ = std::async(std::launch::async, load_baked, std::cref(show), stands);
}

void BakedSupply::take(const Session& session) {
    if (!reading_.valid() || reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    BakedPasses read = reading_.get();
    why_not_ = read.why_not;
    if (!why_not_.empty()) return;
    auto view = BakedView::create(session, std::move(read));
    if (view.ok())
        view_ = std::move(*view);
    else
        why_not_ = view.error().text();
}

void BakedSupply::forget() {
    if (reading_.valid()) reading_.wait();
    reading_ = {};
    view_.reset();
    camera_.clear();
    stamp_.clear();
}

} // namespace ghost::app
