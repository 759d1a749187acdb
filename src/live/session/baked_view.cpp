// SPDX-License-Identifier: Apache-2.0
#include "live/session/baked_view.h"

#include "gpu/device_memory.h"
#include "live/session/passes_sources.h"
#include "passes/passes_file.h"
#include "render/geometry/pass_images.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace ghost::app {
namespace {

// Light pictures on the device, with an even share for all else that drawing needs.
std::uint64_t bytes_of(const scene::Passes& passes) {
    constexpr std::uint64_t kBytesPerTexel = 8;
    return 2 * kBytesPerTexel * passes.fragments.size() * (passes.lights.size() + 8);
}

} // namespace

BakedPasses load_baked(const scene::Show& show, const scene::Camera& camera) {
    BakedPasses baked;
    baked.camera = camera;
    Report report;
    std::error_code code;
    if (!camera.foreign_passes.empty()) {
        auto passes = scene::load_foreign_passes(camera.foreign_passes, report);
        if (passes.ok())
            baked.passes = std::move(*passes);
        else
            baked.why_not = passes.error().text();
    } else if (!std::filesystem::exists(scene::passes_folder(show, camera.name) / "manifest.json", code)) {
        baked.why_not = "it is not baked";
    } else if (!passes_are_of(show, camera.name, passes_fingerprint(show))) {
        const auto manifest = scene::read_manifest(scene::passes_folder(show, camera.name));
        baked.why_not = manifest.ok() && manifest->version < scene::kPassesVersion
                            ? "its passes are of an earlier version of Ghostlight: bake it again, once"
                            : "files of the show changed since its bake: bake it again";
    } else {
        auto passes = scene::load_passes(scene::passes_folder(show, camera.name), true, report);
        if (passes.ok())
            baked.passes = std::move(*passes);
        else
            baked.why_not = passes.error().text();
    }
    if (baked.why_not.empty() && report.lost_anything())
        baked.why_not = "its passes are not whole: bake it again";
    if (baked.why_not.empty()) {
        baked.camera.width = baked.passes.width;
        baked.camera.height = baked.passes.height;
    }
    return baked;
}

std::string why_too_coarse(const scene::Camera& passes, const glm::ivec2& window) {
    const double scale =
        std::min(static_cast<double>(window.x) / passes.width, static_cast<double>(window.y) / passes.height);
    if (scale <= 1) return "";
    const auto text = [&](double times) {
        return std::to_string(std::lround(times * passes.width)) + "x" +
               std::to_string(std::lround(times * passes.height));
    };
    return "its passes have " + text(1) + " pixels, and the window shows it with " + text(scale);
}

Result<std::unique_ptr<BakedView>> BakedView::create(const Session& session, BakedPasses baked) {
    if (const std::uint64_t bytes = bytes_of(baked.passes); bytes > session.device->memory().left_bytes() / 2)
        return Error{"its passes need " + std::to_string(bytes >> 20) +
                         " MB on the device, which has not got them",
                     ""};
    if (const std::string beyond = render::beyond_device(*session.device, baked.passes); !beyond.empty())
        return Error{"its passes need " + beyond, ""};
    return std::unique_ptr<BakedView>(new BakedView(session, std::move(baked)));
}

BakedView::BakedView(const Session& session, BakedPasses baked)
    : session_(session), camera_(std::move(baked.camera)), passes_(std::move(baked.passes)) {
    relighter_ = std::make_unique<render::Relighter>(
        *session.device, passes_, session.gobos.images, static_cast<int>(lit().lights.size()),
        draw_settings(session.atmosphere(), camera_, session.options));
    for (scene::LightPass& pass : passes_.lights) {
        pass.radiance = {};
        pass.indirect = {};
    }
}

scene::FrameLights BakedView::lit() const {
    scene::FrameLights lit = session_.rig->lit(session_.gobos, passes_);
    const auto dim = [&](shared::Light& light) {
        light.intensity_cd *= session_.master;
        light.bounce_cd *= session_.master;
    };
    for (shared::Light& light : lit.lights) dim(light);
    for (scene::LensFace& face : lit.faces) dim(face.light);
    for (shared::LedWall& wall : lit.walls) wall.radiance *= session_.master;
    return lit;
}

render::FrameStatistics BakedView::draw(const scene::Camera& exposure, double air_s,
                                        const render::HazeQuality& haze, const std::function<bool()>& stop) {
    relighter_->set_quality(haze);
    relighter_->set_exposure(exposure.ev100, exposure.auto_exposure);
    relighter_->set_tone(session_.options.tone);
    relighter_->set_air(session_.atmosphere().field(air_s));
    relighter_->set_slides(session_.gobos.images.slides);
    return relighter_->draw(lit(), stop);
}

} // namespace ghost::app
