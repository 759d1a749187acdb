// SPDX-License-Identifier: Apache-2.0
#include "live/engine/camera_pictures.h"

#include "light/rig.h"

#include <algorithm>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kPictureEvery_s = 1;
constexpr double kMovingEvery_s = 5; // a hundredth of the time, where one takes 50 ms
constexpr int kWidth = 160, kHeight = 90;

} // namespace

void CameraPictures::draw(const Session& session, const scene::FrameLights& lit, const Now& now,
                          const std::function<bool()>& stop) {
    const std::vector<scene::Camera>& cameras = session.show->cameras;
    if (now.moves) {
        of_s_ = -1; // all are drawn again when they rest
        if (next_ >= cameras.size()) next_ = 0;
    } else if (now.changed_s != of_s_) {
        of_s_ = now.changed_s;
        next_ = 0;
    }
    const double every_s = now.moves ? kMovingEvery_s : kPictureEvery_s;
    if (next_ >= cameras.size() || now.now_s - made_s_ < every_s || stop()) return;
    if (!small_) {
        if (!SmallPicture::fits(session)) return;
        small_ = std::make_unique<SmallPicture>(session, kWidth, kHeight);
    }
    const scene::Camera camera = scene::riding(cameras[next_], *session.rig);
    made_s_ = now.now_s;
    auto picture = small_->draw(camera, lit, now.air_s, stop);
    if (!picture) return;
    ++next_;
    const auto image = std::make_shared<const image::Image8>(std::move(*picture));
    const auto known = std::find_if(pictures_.begin(), pictures_.end(),
                                    [&](const ui::NamedPicture& one) { return one.name == camera.name; });
    if (known == pictures_.end())
        pictures_.push_back({camera.name, image});
    else
        known->image = image;
    link_.camera_pictures.put(pictures_);
    link_.on_news();
}

void CameraPictures::forget() {
    small_.reset();
    if (!pictures_.empty()) link_.camera_pictures.put({}); // who comes late must not take them for this one's
    pictures_.clear();
    of_s_ = made_s_ = -1;
}

} // namespace ghost::app
