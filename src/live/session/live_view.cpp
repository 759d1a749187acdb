// SPDX-License-Identifier: Apache-2.0
#include "live/session/live_view.h"

#include "bake/distance_maps.h"
#include "base/interrupt.h"
#include "light/bodies.h"
#include "live/session/session.h"
#include "passes/distance_maps_file.h"

#include "base/check.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/progress.h"
#include "base/steady_time.h"

#include <chrono>
#include <cmath>
#include <set>
#include <string>

namespace ghost::app {
namespace {

// Of a picture, for the maps that came meanwhile; the rest waits for the next one. A few hundred at once
// would hold up the picture, another show and the end of the window for as long as they take.
constexpr double kTakeMaps_s = 0.02;
constexpr float kFlightError_px = 1; // of the stage, which is seen from there for a moment

// 2 MB a light, and from kManyLights on half a megabyte: shadows get coarser, not fewer. The same where the
// machine's memory does not hold what the show asks for.
int map_size(const scene::Show& show, Report& report) {
    constexpr std::size_t kManyLights = 256;
    const std::uint64_t count = scene::distance_places(show, scene::kDistanceMapSize).size();
    const bool few = count < kManyLights;
    const int wanted = show.distance_map_size > 0 ? show.distance_map_size
                       : few                      ? 2 * scene::kDistanceMapSize
                                                  : scene::kDistanceMapSize;
    const std::uint64_t room = free_memory_bytes() / 2; // drawing needs some, too
    const auto bytes = [&](int size) {
        return count * sizeof(std::uint16_t) * static_cast<std::uint64_t>(size) *
               static_cast<std::uint64_t>(size);
    };
    int size = wanted;
    while (room > 0 && size > scene::kMinDistanceMapSize && bytes(size) > room) size /= 2;
    if (size < wanted)
        report.add(Severity::warning, show.file.string(),
                   "memory is short for " + std::to_string(count) + " distance maps of " +
                       std::to_string(wanted) + " texels a side (" + std::to_string(bytes(wanted) >> 20) +
                       " MB): they are made with " + std::to_string(size));
    return size;
}

// Lights whose map the device does not hold have none.
void leave_out(scene::DistanceMaps& maps, std::size_t held, Report& report) {
    if (held >= maps.maps.size()) return;
    report.add(Severity::warning, "distance maps",
               "the device holds " + std::to_string(held) + " of " + std::to_string(maps.maps.size()) +
                   "; lights beyond throw no shadows");
    maps.maps.resize(held);
}

Result<scene::DistanceMaps> make_maps(const scene::Show& show, const scene::Stage& stage, bool quiet,
                                      Report& report) {
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

bool has_size(const std::unique_ptr<render::GBuffer>& one, const scene::Camera& camera) {
    return one && one->fragments().width == static_cast<std::uint32_t>(camera.width) &&
           one->fragments().height == static_cast<std::uint32_t>(camera.height);
}

} // namespace

LiveView::LiveView(const gpu::Device& device, const scene::Show& show, scene::Stage stage,
                   const scene::Camera& camera, Atmosphere air, Report& report)
    : device_(device), show_(show), stage_(std::move(stage)), moving_(scene::moving_instances(show, stage_)),
      carried_(scene::carried_objects(show, stage_)), model_(device, stage_, report), air_(std::move(air)) {
    for (const std::size_t instance : moving_) model_.mark_moving(instance);
    for (const scene::CarriedObject& object : carried_) model_.mark_moving(object.instance);
    for (std::size_t i = 0; i < stage_.instances.size(); ++i) {
        if (stage_.instances[i].shown) continue;
        model_.show(i, false);
        if (!solid_) solid_ = scene::visible(stage_);
    }
    look_from(camera);
}

Result<std::unique_ptr<LiveView>> LiveView::open(const gpu::Device& device, scene::Show& show,
                                                 const scene::Camera& camera, const LiveOptions& options,
                                                 Report& report) {
    const auto ends = [&] { return options.stop && options.stop(); };
    const Error interruption{"interrupted while opening the stage", ""};
    load_stage(show, report);
    if (ends()) return interruption;
    scene::Stage stage = scene::stage_with_bodies(
        show, report, options.keep_hidden ? scene::HiddenObjects::kept : scene::HiddenObjects::left_out);
    if (ends()) return interruption;
    auto view = std::unique_ptr<LiveView>(new LiveView(device, show, std::move(stage), camera,
                                                       options.air.value_or(atmosphere_of(show)), report));
    if (ends()) return interruption;
    if (!options.shadows) return view;
    if (!show.movers.empty()) {
        view->begin_moving_maps(options.moving_maps, report);
        return view;
    }
    if (options.maps_in_background) {
        view->begin_maps(report);
        return view;
    }
    TRY(view->maps_, make_maps(show, view->solid(), options.quiet, report));
    if (view->maps_.maps.empty()) return view;
    view->distances_ = std::make_unique<render::DistanceImages>(device, view->maps_);
    leave_out(view->maps_, view->distances_->count(), report);
    for (scene::DistanceMap& map : view->maps_.maps) map.distance = {};
    return view;
}

void LiveView::begin_maps(Report& report) {
    const int size = map_size(show_, report);
    const std::vector<scene::DistancePlace> places = scene::distance_places(show_, size);
    if (places.empty()) return;
    const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    Report unheard; // the maker says it again
    auto found = scene::load_distance_maps(show_, size, unheard);
    maps_ = {size, std::vector<scene::DistanceMap>(places.size())};
    std::set<std::size_t> known;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const int index = found.ok() ? found->find(places[k].fixture, places[k].stop, places[k].place) : -1;
        if (index < 0) {
            maps_.maps[k].distance.assign(texels, scene::kNoSurface);
            continue;
        }
        maps_.maps[k] = std::move(found->maps[static_cast<std::size_t>(index)]);
        known.insert(k);
    }
    distances_ = std::make_unique<render::DistanceImages>(device_, maps_);
    leave_out(maps_, distances_->count(), report);
    for (scene::DistanceMap& map : maps_.maps) map.distance = {};
    for (std::size_t k = maps_.maps.size(); k < places.size(); ++k) known.insert(k);
    missing_maps_ = places.size() - known.size();
    if (missing_maps_ > 0)
        log_info(
            std::to_string(missing_maps_) + " of " + std::to_string(places.size()) +
            " distance maps are missing and are made meanwhile; until then these lights throw no shadows");
    maker_ = std::make_unique<MapMaker>(show_, solid(), size, std::move(known));
}

void LiveView::begin_moving_maps(MovingMapsBy by, Report& report) {
    const int size = map_size(show_, report);
    const std::vector<scene::DistancePlace> places = scene::distance_places(show_, size);
    if (places.empty()) return;
    const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    std::vector<glm::vec3> places_m;
    maps_ = {size, {}};
    std::size_t fixture = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const scene::DistancePlace& place = places[k];
        maps_.maps.push_back({place.fixture, place.stop, place.place, place.position_m,
                              std::vector<std::uint16_t>(texels, scene::kNoSurface)});
        places_m.push_back(place.position_m);
        // Places are in the order of the fixtures.
        while (fixture < show_.fixtures.size() && show_.fixtures[fixture].name != place.fixture) ++fixture;
        CHECK(fixture < show_.fixtures.size());
        if (show_.fixtures[fixture].mover == scene::kNoMover) continue;
        if (carried_fixtures_.empty() || carried_fixtures_.back().fixture != fixture)
            carried_fixtures_.push_back({fixture, k, {}});
        carried_fixtures_.back().places_m.push_back(place.position_m);
    }
    using render::DistanceImages;
    const bool draws = by == MovingMapsBy::device || (by == MovingMapsBy::choice && !device_.is_cpu());
    distances_ = std::make_unique<DistanceImages>(
        device_, maps_, draws ? DistanceImages::Made::by_the_device : DistanceImages::Made::elsewhere);
    if (draws && !distances_->can_draw()) {
        const std::string text = distances_->lack() + "; the processor traces them";
        if (by == MovingMapsBy::device)
            report.add(Severity::warning, "distance maps", text);
        else
            log_info("distance maps: " + text);
    }
    leave_out(maps_, distances_->count(), report);
    for (scene::DistanceMap& map : maps_.maps) map.distance = {};
    using bake::MovingMaps;
    moving_maps_ = std::make_unique<MovingMaps>(stage_, size, places_m,
                                                distances_->can_draw() ? MovingMaps::Made::elsewhere
                                                                       : MovingMaps::Made::here);
}

bool LiveView::take_maps(Report& report) {
    if (!maker_ && !moving_maps_) begin_changed_maps();
    if (!maker_) return false;
    bool replaced = false;
    const std::size_t missing_before = missing_maps_;
    const double begin_s = steady_now_s();
    while (auto made = maker_->take()) {
        if (made->index >= maps_.maps.size()) continue; // left out
        distances_->set(made->index, made->map.distance);
        scene::DistanceMap& place = maps_.maps[made->index];
        if (place.fixture.empty())
            --missing_maps_;
        else
            replaced = true;
        place = std::move(made->map);
        place.distance = {};
        if (steady_now_s() - begin_s >= kTakeMaps_s) break;
    }
    distances_->finish();
    if (missing_maps_ == 0 && missing_before > 0)
        log_info("all " + std::to_string(maps_.maps.size()) + " distance maps are made");
    if (auto outcome = maker_->outcome()) {
        for (Message& message : outcome->report.messages) report.messages.push_back(std::move(message));
        if (outcome->error)
            report.add(Severity::error, outcome->error->where,
                       outcome->error->what + "; lights without a distance map throw no shadows");
        maker_.reset();
    }
    return replaced;
}

void LiveView::light_bodies(const std::set<std::size_t>& fixtures, float cd_m2) {
    for (std::size_t i = 0; i < stage_.instances.size(); ++i) {
        const int fixture = stage_.instances[i].fixture;
        const bool shines = fixture != scene::kNone && fixtures.contains(static_cast<std::size_t>(fixture));
        model_.set_glow(i, shines ? cd_m2 : 0.0f);
    }
}

bool LiveView::follow(const scene::Rig& rig) {
    for (const std::size_t instance : moving_)
        model_.move(instance, scene::body_to_world(show_, rig, stage_.instances[instance]));
    for (const scene::CarriedObject& object : carried_)
        move(object.instance, rig.movers().moved(object.mover));
    if (moving_maps_) hang_lamps(rig);
    return g_buffer_->update(model_);
}

render::Pose LiveView::pose_of(const scene::Camera& camera, bool flies) const {
    return {scene::camera_to_world(camera),
            camera.fov_y_deg,
            camera.width,
            camera.height,
            flies ? kFlightError_px : 0.0f,
            flies};
}

render::Surroundings LiveView::surroundings() const {
    shared::Haze seen = haze();
    seen.extinction_per_m -= forward_per_m_;
    return {air_.ambient, seen, work_lux_};
}

LiveView::Seen LiveView::look_from(const scene::Camera& camera, bool parks, bool flies, bool splits) {
    const auto fits = [&](const std::unique_ptr<render::GBuffer>& one) {
        return has_size(one, camera) && (!splits || one->pose().single == flies);
    };
    camera_ = camera;
    bool is_anew = false;
    if (!fits(g_buffer_)) {
        std::swap(g_buffer_, parked_);
        if (!parks) parked_.reset();
        is_anew = std::exchange(parked_is_anew_, false);
    }
    if (!fits(g_buffer_)) {
        g_buffer_.reset();
        g_buffer_ = std::make_unique<render::GBuffer>(device_, camera.width, camera.height);
    }
    if (g_buffer_->shows(pose_of(camera, flies), surroundings())) {
        g_buffer_->update(model_);
        return is_anew ? Seen::anew : Seen::where_it_changed;
    }
    g_buffer_->draw(model_, pose_of(camera, flies), surroundings());
    return Seen::anew;
}

bool LiveView::prepare(const scene::Camera& camera, const std::function<bool()>& stop) {
    CHECK(!has_size(g_buffer_, camera) || g_buffer_->pose().single);
    if (!has_size(parked_, camera) || parked_->pose().single) {
        parked_.reset();
        parked_ = std::make_unique<render::GBuffer>(device_, camera.width, camera.height);
    }
    if (parked_->shows(pose_of(camera, false), surroundings())) return true;
    parked_is_anew_ = true;
    return parked_->draw(model_, pose_of(camera, false), surroundings(), stop);
}

} // namespace ghost::app
