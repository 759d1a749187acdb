// SPDX-License-Identifier: Apache-2.0
#include "live/engine/side_views.h"

#include "base/steady_time.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kRestsPerTime = 4;         // a fifth of the engine's time
constexpr double kRestsPerHurriedTime = 24; // a twenty-fifth
constexpr int kHurriedWidth = 320, kHurriedHeight = 180;
constexpr int kStillWidth = 640, kStillHeight = 360;
constexpr int kSideWidth = 854, kSideHeight = 480;

} // namespace

void SideViews::take_requests() {
    auto wanted = link_.side_views.take();
    if (!wanted) return;
    if (wanted->size() > ui::kMostSideViews) wanted->resize(ui::kMostSideViews);
    // One that is still wanted keeps its place, and with it what is drawn.
    std::vector<ui::SideView> anew;
    for (Side& side : sides_) side.is_wanted = false;
    for (ui::SideView& view : *wanted) {
        const auto same = std::find_if(sides_.begin(), sides_.end(),
                                       [&](const Side& side) { return side.view.number == view.number; });
        if (same == sides_.end())
            anew.push_back(std::move(view));
        else
            same->is_wanted = true;
    }
    for (ui::SideView& view : anew) {
        const auto free =
            std::find_if(sides_.begin(), sides_.end(), [](const Side& side) { return !side.is_wanted; });
        free->view = std::move(view);
        free->is_wanted = true;
        free->drawn = {};
        free->of_changed_s = -1;
    }
    for (Side& side : sides_) {
        if (side.is_wanted) continue;
        side = {};
    }
}

void SideViews::draw(const Session& session, const scene::FrameLights& lit, const Now& now,
                     PictureProbe& probe, const std::function<bool()>& stop) {
    take_requests();
    const bool is_still = session.device->is_cpu();
    const bool is_hurried = is_still && !now.rests;
    if (is_hurried ? now.now_s < may_go_s_ : !is_still && (!now.is_whole || now.now_s < may_go_s_)) return;
    for (std::size_t step = 1; step <= sides_.size(); ++step) {
        const std::size_t index = (last_ + step) % sides_.size();
        Side& side = sides_[index];
        const bool is_new = side.drawn.number != side.view.number || side.of_changed_s != now.changed_s;
        if (!side.is_wanted || !is_new || stop()) continue;
        const double begin_s = steady_now_s();
        const auto rest = [&] {
            const double taken_s = steady_now_s() - begin_s;
            may_go_s_ = now.now_s + (1 + (is_hurried ? kRestsPerHurriedTime : kRestsPerTime)) * taken_s;
        };
        SmallPicture* const small = small_of(side, session, is_hurried);
        if (!small) return;
        const scene::Camera camera = scene::riding(side.view.camera, *session.rig);
        auto picture = small->draw(camera, lit, now.air_s, stop);
        if (!picture) return rest();
        last_ = index;
        side.of_changed_s = is_hurried ? -1 : now.changed_s;
        side.drawn = {side.view.number,
                      std::make_shared<const image::Image8>(std::move(*picture)),
                      small->ev100_used(),
                      is_still,
                      {}};
        if (side.view.probe) side.drawn.measure = measure(side, *small, camera, session, lit, probe);
        rest();
        publish();
        return;
    }
}

SmallPicture* SideViews::small_of(Side& side, const Session& session, bool is_hurried) {
    std::unique_ptr<SmallPicture>& small = is_hurried ? hurried_ : side.small;
    if (small) return small.get();
    if (!SmallPicture::fits(session)) return nullptr;
    if (is_hurried)
        small = std::make_unique<SmallPicture>(session, kHurriedWidth, kHurriedHeight);
    else if (session.device->is_cpu())
        small = std::make_unique<SmallPicture>(session, kStillWidth, kStillHeight);
    else
        small = std::make_unique<SmallPicture>(session, kSideWidth, kSideHeight);
    return small.get();
}

ui::SideMeasure SideViews::measure(const Side& side, SmallPicture& small, scene::Camera camera,
                                   const Session& session, const scene::FrameLights& lit,
                                   PictureProbe& probe) const {
    camera.width = side.drawn.image->width;
    camera.height = side.drawn.image->height;
    return probe.measure(*side.view.probe, luminance_of(small.frame()), camera, session, lit);
}

void SideViews::publish() {
    std::vector<ui::SidePicture> all;
    for (const Side& side : sides_)
        if (side.is_wanted && side.drawn.number != 0) all.push_back(side.drawn);
    link_.side_pictures.put(std::move(all));
    link_.on_news();
}

void SideViews::forget() {
    hurried_.reset();
    for (Side& side : sides_) {
        side.small.reset();
        side.drawn = {};
    }
}

} // namespace ghost::app
