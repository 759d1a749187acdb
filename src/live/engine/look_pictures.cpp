// SPDX-License-Identifier: Apache-2.0
#include "live/engine/look_pictures.h"

#include <utility>

namespace ghost::app {
namespace {

constexpr double kLookPictureEvery_s = 1;
constexpr int kLookWidth = 320, kLookHeight = 180;
constexpr std::size_t kMostLookPictures = 100;
constexpr double kLampsWarm_s = 10; // whatever a lamp takes to its full light

scene::FrameLights lit_by(scene::Rig& rig, const scene::StoredLook& look, Session& session) {
    const fixture::Motion motion = std::exchange(session.show->motion, fixture::Motion::as_commanded);
    rig.movers().drive(scene::movers_of(look, *session.show));
    rig.step({}, kLampsWarm_s, scene::programmer_of(look, *session.show));
    session.show->motion = motion;
    return rig.lit(session.gobos, session.live->maps());
}

// The session in the scene of a look, without work light; then as it was before.
class AsOfLook {
public:
    AsOfLook(Session& session, const scene::SceneLook& scene)
        : session_(session), scene_(std::exchange(session.scene_look, scene)),
          work_lux_(session.live->work_light()) {
        session_.live->set_atmosphere(session_.atmosphere());
        session_.live->set_work_light(0);
    }
    ~AsOfLook() {
        session_.scene_look = scene_;
        session_.live->set_atmosphere(session_.atmosphere());
        session_.live->set_work_light(work_lux_);
    }
    AsOfLook(const AsOfLook&) = delete;
    AsOfLook& operator=(const AsOfLook&) = delete;

private:
    Session& session_;
    const scene::SceneLook scene_;
    const float work_lux_;
};

} // namespace

void LookPictures::draw(Session& session, double now_s, const std::function<bool()>& stop) {
    if (auto news = link_.looks.take()) {
        const bool are_others = !news->looks || !now_.looks || *news->looks != *now_.looks;
        now_ = std::move(*news);
        if (are_others) next_ = 0;
    }
    const std::size_t count = now_.looks ? std::min(now_.looks->size(), kMostLookPictures) : 0;
    if (next_ >= count || session.show->cameras.empty() || now_s - made_s_ < kLookPictureEvery_s || stop())
        return;
    const scene::StoredLook& look = (*now_.looks)[next_];
    if (next_ == 0) pictures_.clear();
    made_s_ = now_s;
    if (!rig_) rig_ = std::make_unique<scene::Rig>(*session.show);
    std::optional<image::Image8> picture;
    {
        const AsOfLook as_of_look(session, look.scene);
        picture = drawn(session, look, stop);
    }
    if (!picture) return;
    ++next_;
    pictures_.push_back({look.name, std::make_shared<const image::Image8>(std::move(*picture))});
    link_.look_pictures.put(pictures_);
    link_.on_news();
}

std::optional<image::Image8> LookPictures::drawn(Session& session, const scene::StoredLook& look,
                                                 const std::function<bool()>& stop) {
    if (!small_ || drawn_in_ != look.scene) { // its programs know one air
        small_.reset();
        if (SmallPicture::fits(session))
            small_ = std::make_unique<SmallPicture>(session, kLookWidth, kLookHeight);
        drawn_in_ = look.scene;
    }
    if (!small_) return std::nullopt;
    return small_->draw(session.show->cameras.front(), lit_by(*rig_, look, session), 0, stop);
}

void LookPictures::forget() {
    small_.reset();
    rig_.reset();
    if (!pictures_.empty()) link_.look_pictures.put({}); // who comes late must not take them for this one's
    pictures_.clear();
    next_ = 0;
    made_s_ = -1;
}

} // namespace ghost::app
