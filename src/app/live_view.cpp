// SPDX-License-Identifier: Apache-2.0
#include "app/live_view.h"

#include "app/interrupt.h"
#include "app/session.h"
#include "bake/distance_maps.h"

#include "base/progress.h"

#include <chrono>

namespace ghost::app {
namespace {

double steady_now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// 2 MB a light, and from kManyLights on half a megabyte: shadows get coarser, not fewer.
int map_size(const scene::Show& show) {
    constexpr std::size_t kManyLights = 256;
    if (show.distance_map_size > 0) return show.distance_map_size;
    return show.fixtures.size() < kManyLights ? 2 * scene::kDistanceMapSize : scene::kDistanceMapSize;
}

Result<scene::DistanceMaps> make_maps(const scene::Show& show, const scene::Stage& stage, bool quiet,
                                      scene::Report& report) {
    catch_interrupts();
    Progress progress("distance maps", quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    bake::DistanceMapOptions options;
    options.size = map_size(show);
    options.stop = interrupted;
    options.progress = [&](double share, const std::string& note) {
        progress.update(share, steady_now_s(), note);
    };
    scene::DistanceMaps maps;
    const auto stats = bake::update_distance_maps(show, stage, options, maps, report);
    progress.finish();
    if (!stats.ok()) return stats.error();
    if (stats->interrupted)
        return Error{"interrupted while making distance maps; finished ones are kept", ""};
    return maps;
}

} // namespace

LiveView::LiveView(const gpu::Device& device, const scene::Show& show, scene::Stage stage,
                   const scene::Camera& camera, scene::Report& report)
    : show_(show), stage_(std::move(stage)), model_(device, stage_, report),
      g_buffer_(device, camera.width, camera.height) {
    look_from(camera);
}

Result<std::unique_ptr<LiveView>> LiveView::open(const gpu::Device& device, scene::Show& show,
                                                 const scene::Camera& camera, bool shadows, bool quiet,
                                                 scene::Report& report) {
    load_stage(show, report);
    auto view = std::unique_ptr<LiveView>(
        new LiveView(device, show, scene::stage_with_bodies(show, report), camera, report));
    if (!shadows) return view;
    TRY(view->maps_, make_maps(show, view->stage_, quiet, report));
    if (view->maps_.maps.empty()) return view;
    view->distances_ = std::make_unique<render::DistanceImages>(device, view->maps_);
    for (scene::DistanceMap& map : view->maps_.maps) map.distance = {};
    return view;
}

void LiveView::look_from(const scene::Camera& camera) {
    g_buffer_.draw(model_, {scene::camera_to_world(camera), camera.fov_y_deg, camera.width, camera.height},
                   {show_.ambient_colour * show_.ambient_lux, haze_of(show_)});
}

scene::Camera camera_between(const scene::Camera& from, const scene::Camera& to, float share) {
    const float eased = share * share * (3.0f - 2.0f * share);
    scene::Camera camera = from;
    camera.position_m = glm::mix(from.position_m, to.position_m, eased);
    camera.target_m = glm::mix(from.target_m, to.target_m, eased);
    camera.fov_y_deg = glm::mix(from.fov_y_deg, to.fov_y_deg, eased);
    camera.ev100 = glm::mix(from.ev100, to.ev100, eased);
    return camera;
}

} // namespace ghost::app
