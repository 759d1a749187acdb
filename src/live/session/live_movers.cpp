// SPDX-License-Identifier: Apache-2.0
// The distance maps of a show with movers: a lamp that travels and a truss that flies before a lamp have
// their shadows in the same picture.
#include "live/session/live_view.h"

#include "live/session/map_size.h"
#include "passes/distance_maps_file.h"

namespace ghost::app {

void LiveView::begin_moving_maps(Report& report) {
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
        while (show_.fixtures[fixture].name != place.fixture) ++fixture;
        if (show_.fixtures[fixture].mover == scene::kNoMover) continue;
        if (hung_.empty() || hung_.back().fixture != fixture) hung_.push_back({fixture, k, {}});
        hung_.back().places_m.push_back(place.position_m);
    }
    distances_ = std::make_unique<render::DistanceImages>(device_, maps_);
    leave_out_maps(maps_, distances_->count(), report);
    for (scene::DistanceMap& map : maps_.maps) map.distance = {};
    moving_maps_ = std::make_unique<bake::MovingMaps>(stage_, size, places_m);
}

void LiveView::hang_lamps(const scene::Rig& rig) {
    for (const Hung& hung : hung_)
        for (std::size_t p = 0; p < hung.places_m.size(); ++p)
            moving_maps_->hang(hung.first_map + p,
                               glm::vec3(rig.moved(hung.fixture) * glm::vec4(hung.places_m[p], 1.0f)));
}

bool LiveView::update_maps(const std::vector<shared::Light>& lights) {
    if (!moving_maps_) return false;
    const bake::MovingMaps::News news = moving_maps_->update(lights);
    for (const std::size_t index : news.maps) {
        if (index >= maps_.maps.size()) continue; // left out
        distances_->set(index, moving_maps_->distance(index));
    }
    return news.is_seen_by_resting;
}

} // namespace ghost::app
