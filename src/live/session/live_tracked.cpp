// SPDX-License-Identifier: Apache-2.0
// Objects that go with trackers and movers, objects that hands hide or show, and lamps that travel: on the
// device, and in the distance maps of the lights that see them.
#include "live/session/live_view.h"

#include "base/steady_time.h"
#include "stage/overrides.h"

#include <algorithm>
#include <limits>
#include <set>

#include <glm/gtc/matrix_transform.hpp>

namespace ghost::app {

namespace {

constexpr float kShadowStep_m = 0.01f; // maps are made again for more

} // namespace

// As [[object]] does: the name of the object, else that of its mesh. What a mover carries goes with that.
std::vector<std::size_t> LiveView::objects_named(const std::vector<std::string>& patterns,
                                                 std::uint64_t& steps) {
    if (!names_) {
        names_.emplace();
        for (std::size_t i = 0; i < stage_.instances.size(); ++i) {
            const scene::Instance& instance = stage_.instances[i];
            if (instance.fixture != scene::kNone || instance.mesh < 0) continue;
            if (std::ranges::binary_search(carried_, i, {}, &scene::CarriedObject::instance)) continue;
            names_->by_name.add(instance.name, i);
            names_->by_mesh.add(stage_.meshes[static_cast<std::size_t>(instance.mesh)].name, i);
        }
    }
    for (const NameIndex* const names : {&names_->by_name, &names_->by_mesh}) {
        std::set<std::size_t> found;
        for (const std::string& pattern : patterns) {
            const std::vector<std::size_t> of_pattern = names->find(pattern, steps);
            found.insert(of_pattern.begin(), of_pattern.end());
        }
        if (!found.empty()) return {found.begin(), found.end()};
    }
    return {};
}

std::optional<glm::vec3> LiveView::track(const std::vector<std::size_t>& objects) {
    glm::vec3 low_m(std::numeric_limits<float>::max()), high_m(-low_m);
    for (const std::size_t i : objects) {
        const scene::Instance& instance = stage_.instances[i];
        for (const glm::vec3& position : stage_.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            const glm::vec3 at_m(instance.world * glm::vec4(position, 1.0f));
            low_m = glm::min(low_m, at_m);
            high_m = glm::max(high_m, at_m);
        }
        model_.mark_moving(i);
    }
    if (low_m.x > high_m.x) return std::nullopt;
    return glm::vec3(0.5f * (low_m.x + high_m.x), 0.5f * (low_m.y + high_m.y), low_m.z);
}

void LiveView::move_tracked(const std::vector<std::size_t>& objects, const glm::vec3& by_m) {
    for (const std::size_t i : objects) {
        const auto moved = moved_.find(i);
        const glm::vec3 before_m(moved == moved_.end() ? glm::vec4(0) : moved->second[3]);
        if (glm::distance(before_m, by_m) >= kStill_m) move(i, glm::translate(glm::mat4(1.0f), by_m));
    }
}

void LiveView::move(std::size_t instance, const glm::mat4& by) {
    glm::mat4& moved = moved_.try_emplace(instance, 1.0f).first->second;
    if (moved == by) return;
    moved = by;
    const glm::mat4 world = by * stage_.instances[instance].world;
    model_.move(instance, world);
    if (moving_maps_) moving_maps_->move(instance, world);
}

void LiveView::show(std::size_t instance, bool shown) {
    model_.show(instance, shown);
    if (instance >= stage_.instances.size()) return;
    const auto by_hand = shown_by_hand_.find(instance);
    const bool before = by_hand == shown_by_hand_.end() ? stage_.instances[instance].shown : by_hand->second;
    if (shown == before) return;
    ++shown_changes_;
    if (moving_maps_) moving_maps_->show(instance, shown);
    if (shown == stage_.instances[instance].shown)
        shown_by_hand_.erase(instance);
    else
        shown_by_hand_[instance] = shown;
}

scene::Stage LiveView::solid_now() const {
    scene::Stage stage = stage_;
    for (const auto& [instance, shown] : shown_by_hand_) stage.instances[instance].shown = shown;
    for (const auto& [instance, by] : moved_)
        stage.instances[instance].world = by * stage.instances[instance].world;
    return scene::visible(std::move(stage));
}

void LiveView::begin_changed_maps() {
    const auto mapped = [&](const auto& entry) {
        const auto place = mapped_.find(entry.first);
        const glm::vec3 then_m(place == mapped_.end() ? glm::vec4(0) : place->second[3]);
        return glm::distance(then_m, glm::vec3(entry.second[3])) < kShadowStep_m;
    };
    if (!distances_ || (std::all_of(moved_.begin(), moved_.end(), mapped) && shown_by_hand_ == mapped_shown_))
        return;
    const bool is_first = changed_show_.cache_name.empty();
    if (is_first) {
        changed_show_ = show_;
        changed_show_.stage = {};
        changed_show_.cache_name = (show_.cache_name.empty() ? "" : show_.cache_name + "-") + "tracked";
    }
    if (!changed_stage_ || shown_by_hand_ != mapped_shown_) {
        changed_stage_ = solid_now();
    } else {
        std::size_t shown = 0; // of changed_stage_, which is without the hidden ones
        for (std::size_t i = 0; i < stage_.instances.size(); ++i) {
            const auto by_hand = shown_by_hand_.find(i);
            if (!(by_hand == shown_by_hand_.end() ? stage_.instances[i].shown : by_hand->second)) continue;
            if (const auto moved = moved_.find(i); moved != moved_.end())
                changed_stage_->instances[shown].world = moved->second * stage_.instances[i].world;
            ++shown;
        }
    }
    mapped_ = moved_;
    mapped_shown_ = shown_by_hand_;
    std::set<std::size_t> known;
    for (std::size_t k = 0; k < maps_.maps.size(); ++k) known.insert(k);
    // What is right for the show as it is, is right for most lights wherever the objects are.
    maker_ = std::make_unique<MapMaker>(changed_show_, *changed_stage_, maps_.size, std::move(known),
                                        is_first ? &show_ : nullptr);
}

void LiveView::hang_lamps(const scene::Rig& rig) {
    for (const CarriedFixture& carried : carried_fixtures_)
        for (std::size_t p = 0; p < carried.places_m.size(); ++p)
            moving_maps_->hang(carried.first_map + p,
                               glm::vec3(rig.moved(carried.fixture) * glm::vec4(carried.places_m[p], 1.0f)));
}

bool LiveView::update_maps(const std::vector<shared::Light>& lights) {
    if (!moving_maps_) return false;
    const double begin_s = steady_now_s();
    const bake::MovingMaps::News news = moving_maps_->update(lights);
    const double traced_s = steady_now_s();
    if (distances_->can_draw()) {
        std::vector<render::MapDrawer::Job> jobs;
        for (const bake::MovingMaps::Changed& changed : news.maps)
            jobs.push_back({static_cast<std::uint32_t>(changed.map), moving_maps_->position_m(changed.map),
                            changed.blocks});
        distances_->draw(model_, jobs);
        map_work_ = {news.rays, 0, 0, 1e3 * (steady_now_s() - begin_s)};
        return news.is_seen_by_resting;
    }
    std::vector<render::DistanceImages::Change> changes;
    for (const bake::MovingMaps::Changed& changed : news.maps)
        if (changed.map < maps_.maps.size()) // else left out
            changes.push_back({changed.map, moving_maps_->distance(changed.map), changed.blocks});
    distances_->set_blocks(changes);
    distances_->finish();
    map_work_ = {news.rays, 1e3 * (traced_s - begin_s), 1e3 * (steady_now_s() - traced_s), 0};
    return news.is_seen_by_resting;
}

} // namespace ghost::app
