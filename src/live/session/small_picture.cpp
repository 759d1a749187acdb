// SPDX-License-Identifier: Apache-2.0
#include "live/session/small_picture.h"

#include "gpu/device_memory.h"

#include "show/camera_moves.h"

namespace ghost::app {
namespace {

constexpr std::uint64_t kRoom = std::uint64_t{256} << 20; // of the device, with what else may be wanted
constexpr std::uint64_t kFewImages = 1;                   // bytes: it keeps none

} // namespace

bool SmallPicture::fits(const Session& session) {
    return session.live && session.device->memory().left_bytes() > kRoom;
}

SmallPicture::SmallPicture(const Session& session, int width, int height)
    : session_(session), width_(width), height_(height), g_buffer_(*session.device, width, height) {}

std::optional<image::Image8> SmallPicture::draw(const scene::Camera& camera, const scene::FrameLights& lit,
                                                double air_s, const std::function<bool()>& stop) {
    scene::Camera from = camera;
    from.width = width_;
    from.height = height_;
    from = scene::with_frame(from, {camera.width, camera.height});
    if (!session_.live->draw_beside(from, g_buffer_, stop)) return std::nullopt;
    if (!relighter_) {
        render::Settings settings = draw_settings(session_.atmosphere(), from, session_.options);
        settings.reuse = false;
        settings.workers = false;
        settings.image_memory_bytes = kFewImages;
        relighter_ = std::make_unique<render::Relighter>(*session_.device, g_buffer_,
                                                         session_.live->distances(), session_.gobos.images,
                                                         static_cast<int>(lit.lights.size()), settings);
        relighter_->set_flies(true); // the next one is from elsewhere
    }
    relighter_->forget();
    relighter_->set_exposure(from.ev100, from.auto_exposure);
    relighter_->set_tone(session_.options.tone);
    relighter_->set_air(session_.atmosphere().field(air_s));
    relighter_->set_slides(session_.gobos.images.slides);
    if (relighter_->draw(lit, stop).stopped) return std::nullopt;
    return relighter_->picture();
}

} // namespace ghost::app
