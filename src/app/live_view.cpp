// SPDX-License-Identifier: Apache-2.0
#include "app/live_view.h"

#include "app/interrupt.h"
#include "app/session.h"
#include "bake/distance_maps.h"
#include "scene/bodies.h"
#include "scene/distance_maps_file.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/progress.h"

#include <chrono>
#include <cmath>
#include <set>
#include <string>

namespace ghost::app {
namespace {

double steady_now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// 2 MB a light, and from kManyLights on half a megabyte: shadows get coarser, not fewer. The same where the
// machine's memory does not hold what the show asks for.
int map_size(const scene::Show& show, scene::Report& report) {
    constexpr std::size_t kManyLights = 256;
    const bool few = show.fixtures.size() < kManyLights;
    const int wanted = show.distance_map_size > 0 ? show.distance_map_size
                       : few                      ? 2 * scene::kDistanceMapSize
                                                  : scene::kDistanceMapSize;
    const std::uint64_t room = free_memory_bytes() / 2; // drawing needs some, too
    const std::uint64_t count = scene::distance_places(show).size();
    const auto bytes = [&](int size) {
        return count * sizeof(std::uint16_t) * static_cast<std::uint64_t>(size) *
               static_cast<std::uint64_t>(size);
    };
    int size = wanted;
    while (room > 0 && size > scene::kMinDistanceMapSize && bytes(size) > room) size /= 2;
    if (size < wanted)
        report.add(scene::Severity::warning, show.file.string(),
                   "memory is short for " + std::to_string(count) + " distance maps of " +
                       std::to_string(wanted) + " texels a side (" + std::to_string(bytes(wanted) >> 20) +
                       " MB): they are made with " + std::to_string(size));
    return size;
}

// Lights whose map the device does not hold have none.
void leave_out(scene::DistanceMaps& maps, std::size_t held, scene::Report& report) {
    if (held >= maps.maps.size()) return;
    report.add(scene::Severity::warning, "distance maps",
               "the device holds " + std::to_string(held) + " of " + std::to_string(maps.maps.size()) +
                   "; lights beyond throw no shadows");
    maps.maps.resize(held);
}

Result<scene::DistanceMaps> make_maps(const scene::Show& show, const scene::Stage& stage, bool quiet,
                                      scene::Report& report) {
    catch_interrupts();
    Progress progress("distance maps", quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    bake::DistanceMapOptions options;
    options.size = map_size(show, report);
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

// Turns the way of looking as a head does, around and up: mixing two targets may end in the eye itself.
glm::vec3 way_between(const glm::vec3& from, const glm::vec3& to, float share) {
    const auto around = [](const glm::vec3& way) { return std::atan2(way.y, way.x); };
    const auto up = [](const glm::vec3& way) { return std::atan2(way.z, std::hypot(way.x, way.y)); };
    const float turn = std::remainder(around(to) - around(from), 2 * shared::kPi);
    const float yaw = around(from) + turn * share;
    const float pitch = glm::mix(up(from), up(to), share);
    return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
}

} // namespace

LiveView::LiveView(const gpu::Device& device, const scene::Show& show, scene::Stage stage,
                   const scene::Camera& camera, scene::Report& report)
    : show_(show), stage_(std::move(stage)), moving_(scene::moving_instances(show, stage_)),
      model_(device, stage_, report), g_buffer_(device, camera.width, camera.height) {
    for (const std::size_t instance : moving_) model_.mark_moving(instance);
    look_from(camera);
}

Result<std::unique_ptr<LiveView>> LiveView::open(const gpu::Device& device, scene::Show& show,
                                                 const scene::Camera& camera, const LiveOptions& options,
                                                 scene::Report& report) {
    load_stage(show, report);
    auto view = std::unique_ptr<LiveView>(
        new LiveView(device, show, scene::stage_with_bodies(show, report), camera, report));
    if (!options.shadows) return view;
    if (options.maps_in_background) {
        view->begin_maps(device, report);
        return view;
    }
    TRY(view->maps_, make_maps(show, view->stage_, options.quiet, report));
    if (view->maps_.maps.empty()) return view;
    view->distances_ = std::make_unique<render::DistanceImages>(device, view->maps_);
    leave_out(view->maps_, view->distances_->count(), report);
    for (scene::DistanceMap& map : view->maps_.maps) map.distance = {};
    return view;
}

void LiveView::begin_maps(const gpu::Device& device, scene::Report& report) {
    const std::vector<scene::DistancePlace> places = scene::distance_places(show_);
    if (places.empty()) return;
    const int size = map_size(show_, report);
    const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    scene::Report unheard; // the maker says it again
    auto found = scene::load_distance_maps(show_, size, unheard);
    maps_ = {size, std::vector<scene::DistanceMap>(places.size())};
    std::set<std::size_t> known;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const int index = found.ok() ? found->find(places[k].fixture, places[k].stop) : -1;
        if (index < 0) {
            maps_.maps[k].distance.assign(texels, scene::kNoSurface);
            continue;
        }
        maps_.maps[k] = std::move(found->maps[static_cast<std::size_t>(index)]);
        known.insert(k);
    }
    distances_ = std::make_unique<render::DistanceImages>(device, maps_);
    leave_out(maps_, distances_->count(), report);
    for (scene::DistanceMap& map : maps_.maps) map.distance = {};
    for (std::size_t k = maps_.maps.size(); k < places.size(); ++k) known.insert(k);
    missing_maps_ = places.size() - known.size();
    if (missing_maps_ > 0)
        log_info(
            std::to_string(missing_maps_) + " of " + std::to_string(places.size()) +
            " distance maps are missing and are made meanwhile; until then these lights throw no shadows");
    maker_ = std::make_unique<MapMaker>(show_, stage_, size, std::move(known));
}

bool LiveView::take_maps(scene::Report& report) {
    if (!maker_) return false;
    bool replaced = false;
    const std::size_t missing_before = missing_maps_;
    for (MapMaker::Made& made : maker_->take()) {
        if (made.index >= maps_.maps.size()) continue; // left out
        distances_->set(made.index, made.map);
        scene::DistanceMap& place = maps_.maps[made.index];
        if (place.fixture.empty())
            --missing_maps_;
        else
            replaced = true;
        place = std::move(made.map);
        place.distance = {};
    }
    if (missing_maps_ == 0 && missing_before > 0)
        log_info("all " + std::to_string(maps_.maps.size()) + " distance maps are made");
    if (auto outcome = maker_->outcome()) {
        for (scene::Message& message : outcome->report.messages)
            report.messages.push_back(std::move(message));
        if (outcome->error)
            report.add(scene::Severity::error, outcome->error->where,
                       outcome->error->what + "; lights without a distance map throw no shadows");
        maker_.reset();
    }
    return replaced;
}

bool LiveView::follow(const scene::Rig& rig) {
    for (const std::size_t instance : moving_)
        model_.move(instance, scene::body_to_world(show_, rig, stage_.instances[instance]));
    return g_buffer_.update(model_);
}

void LiveView::look_from(const scene::Camera& camera) {
    g_buffer_.draw(model_, {scene::camera_to_world(camera), camera.fov_y_deg, camera.width, camera.height},
                   {show_.ambient_colour * show_.ambient_lux, haze_of(show_)});
}

scene::Camera camera_between(const scene::Camera& from, const scene::Camera& to, float share) {
    const float eased = share * share * (3.0f - 2.0f * share);
    scene::Camera camera = from;
    camera.position_m = glm::mix(from.position_m, to.position_m, eased);
    const glm::vec3 from_way = from.target_m - from.position_m, to_way = to.target_m - to.position_m;
    camera.target_m = camera.position_m + way_between(from_way, to_way, eased) *
                                              glm::mix(glm::length(from_way), glm::length(to_way), eased);
    camera.fov_y_deg = glm::mix(from.fov_y_deg, to.fov_y_deg, eased);
    camera.ev100 = glm::mix(from.ev100, to.ev100, eased);
    return camera;
}

} // namespace ghost::app
