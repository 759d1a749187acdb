// SPDX-License-Identifier: Apache-2.0
// Side views: what viewers watch beside the window's picture, shared by all who watch the same.
#include "web/private/server_loop.h"

#include "show/show.h"

#include <algorithm>
#include <utility>

namespace ghost::web {
namespace {

constexpr double kNewSideEvery_s = 0.1; // of one viewer
constexpr const char* kNoCamera = "the show has no such camera";
constexpr const char* kNoPlace =
    "two other views are drawn already, for others who look on; it comes when one of them is free";

bool watch_the_same(const Watch& a, const Watch& b) {
    return a.camera == b.camera && a.own == b.own && a.probe == b.probe;
}

bool is_of_window(const Watch& watch) {
    return watch.camera.empty() && !watch.own;
}

} // namespace

void ServerLoop::watch(Guest& guest, const Watch& watch) {
    Viewer& viewer = *guest.viewer;
    viewer.flow.want(watch.width, watch.calm);
    viewer.wants_watch = watch;
    go_to_watch(guest);
}

void ServerLoop::go_to_watch(Guest& guest) {
    Viewer& viewer = *guest.viewer;
    if (!viewer.wants_watch || now_s() - viewer.watched_s < kNewSideEvery_s) return;
    const Watch watch = std::move(*std::exchange(viewer.wants_watch, std::nullopt));
    if (watch_the_same(viewer.watch, watch)) {
        if (viewer.watch.width == watch.width && viewer.watch.calm == watch.calm) { // chosen again
            viewer.flow.send_again();
            viewer.measure = 0;
        }
        viewer.watch = watch;
        return;
    }
    viewer.watched_s = now_s();
    viewer.watch = watch;
    if (is_of_window(watch)) return;
    if (!side_of(watch)) {
        viewer.watch = {};
        guest.connection.put(build_text(refused_text(0, kNoCamera)));
        return;
    }
    choose_sides();
    if (side_for(viewer)) return;
    guest.connection.put(build_text(refused_text(0, kNoPlace))); // the request stays: choose_sides()
}

std::optional<ui::SideView> ServerLoop::side_of(const Watch& watch) const {
    if (!opened_ || !opened_->show) return std::nullopt;
    ui::SideView view;
    view.probe = watch.probe;
    if (!watch.own) {
        const auto& cameras = opened_->show->cameras;
        const auto camera = std::find_if(cameras.begin(), cameras.end(),
                                         [&](const scene::Camera& one) { return one.name == watch.camera; });
        if (camera == cameras.end()) return std::nullopt;
        view.camera = *camera;
        return view;
    }
    view.camera.position_m = watch.own->position_m;
    view.camera.target_m = watch.own->target_m;
    view.camera.fov_y_deg = watch.own->fov_y_deg;
    if (picture_) view.camera.ev100 = picture_->ev100; // as bright as the window's
    return view;
}

ServerLoop::Side* ServerLoop::side_for(const Viewer& viewer) {
    const auto side = std::find_if(sides_.begin(), sides_.end(),
                                   [&](const Side& one) { return watch_the_same(one.watch, viewer.watch); });
    return side == sides_.end() ? nullptr : &*side;
}

// Cameras of another show have other places, or none.
void ServerLoop::look_at_sides_anew() {
    for (Side& side : sides_) side.is_stale = true;
    for (Guest& guest : guests_) {
        if (!guest.viewer || is_of_window(guest.viewer->watch) || side_of(guest.viewer->watch)) continue;
        guest.viewer->watch = {};
        guest.connection.put(build_text(refused_text(0, kNoCamera)));
    }
    choose_sides();
}

// Those that somebody watches, as many as have a place; who moves his own camera keeps his.
void ServerLoop::choose_sides() {
    const auto watched = [&](const Watch& watch) {
        return std::any_of(guests_.begin(), guests_.end(), [&](const Guest& guest) {
            return guest.viewer && watch_the_same(guest.viewer->watch, watch);
        });
    };
    bool is_new =
        sides_.remove_if([&](const Side& side) { return side.is_stale || !watched(side.watch); }) > 0;
    for (const Guest& guest : guests_) {
        if (sides_.size() >= ui::kMostSideViews) break;
        if (!guest.viewer || is_of_window(guest.viewer->watch) || side_for(*guest.viewer)) continue;
        std::optional<ui::SideView> view = side_of(guest.viewer->watch);
        if (!view) continue;
        view->number = ++side_numbers_;
        sides_.push_back(
            {guest.viewer->watch, std::move(*view),
             PicturePacker(numbers_, 1, encoder_, [this](const Encoded& one) { take_encoded(one); }),
             nullptr});
        is_new = true;
    }
    if (!is_new) return;
    std::vector<ui::SideView> wanted;
    for (const Side& side : sides_) wanted.push_back(side.view);
    link_.side_views.put(std::move(wanted)); // a wake-up would end a picture that rests
}

void ServerLoop::take_side(const ui::SidePicture& drawn) {
    const auto side = std::find_if(sides_.begin(), sides_.end(),
                                   [&](const Side& one) { return one.view.number == drawn.number; });
    if (side == sides_.end() || side->image == drawn.image) return;
    side->image = drawn.image;
    ui::Picture picture;
    picture.image = drawn.image;
    picture.ev100 = drawn.ev100;
    side->packer.put(std::move(picture), 1e3 * steady_now_s(), drawn.is_still);
    side->measure.reset();
    if (drawn.measure)
        side->measure =
            std::make_shared<const std::vector<std::uint8_t>>(build_text(measure_text(*drawn.measure)));
    for (Guest& guest : guests_)
        if (guest.viewer && watch_the_same(guest.viewer->watch, side->watch)) guest.viewer->measure = 0;
}

} // namespace ghost::web
