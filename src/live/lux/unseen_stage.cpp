// SPDX-License-Identifier: Apache-2.0
#include "live/lux/unseen_stage.h"

#include "live/lux/light_meter.h"
#include "show/camera_moves.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace ghost::app {
namespace {

constexpr int kAcross = 16, kDown = 9; // rays
constexpr std::size_t kMostHeads = 100;
constexpr float kAtHead_m = 0.5f; // nearer to a head it is what the head hangs in

std::string name_of(const bake::Tracer& tracer, int instance) {
    return tracer.stage().instances[static_cast<std::size_t>(instance)].name;
}

struct Heads {
    int seen = 0, hidden = 0;
    std::map<int, int> hidden_by; // instance: how many
};

Heads heads_in(const scene::Camera& camera, const std::vector<glm::vec3>& heads_m,
               const bake::Tracer& tracer) {
    Heads heads;
    const std::size_t step = std::max<std::size_t>(heads_m.size() / kMostHeads, 1);
    for (std::size_t i = 0; i < heads_m.size(); i += step) {
        const auto at = scene::project(camera, heads_m[i]);
        if (!at || at->at.x < 0 || at->at.x > 1 || at->at.y < 0 || at->at.y > 1) continue;
        const glm::vec3 way = heads_m[i] - camera.position_m;
        const float far_m = glm::length(way);
        const bake::Surface hit =
            tracer.first_hit(camera.position_m, way / far_m, -1.0f, bake::Sees::no_bodies);
        if (hit.instance < 0 || hit.distance_m > far_m - kAtHead_m) {
            ++heads.seen;
        } else {
            ++heads.hidden;
            ++heads.hidden_by[hit.instance];
        }
    }
    return heads;
}

} // namespace

std::optional<std::string> unseen_stage(const scene::Camera& camera, const std::vector<glm::vec3>& heads_m,
                                        const bake::Tracer& tracer, bool is_black, bool is_unlit) {
    if (!is_black && !is_unlit) return std::nullopt;
    const Heads heads = heads_in(camera, heads_m, tracer);
    if (heads.seen > 0) return std::nullopt;
    std::set<int> met; // -1: nothing
    for (int y = 0; y < kDown; ++y)
        for (int x = 0; x < kAcross; ++x) {
            const glm::vec2 place((static_cast<float>(x) + 0.5f) / kAcross,
                                  (static_cast<float>(y) + 0.5f) / kDown);
            met.insert(surface_at(camera, place, tracer).instance);
        }
    const bool is_one = met.size() == 1;
    if (is_one && *met.begin() < 0) return "";
    if (is_one && (is_black || heads.hidden > 0)) return name_of(tracer, *met.begin());
    if (!is_black || heads.hidden == 0) return std::nullopt;
    const auto most = std::max_element(heads.hidden_by.begin(), heads.hidden_by.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return name_of(tracer, most->first);
}

bool is_black(const image::Image8& picture) {
    constexpr int kStep = 5, kBlack = 12; // pixels; of 255
    if (picture.channels < 3) return false;
    for (int y = 0; y < picture.height; y += kStep)
        for (int x = 0; x < picture.width; x += kStep) {
            const auto pixel = static_cast<std::size_t>(y * picture.width + x);
            const std::uint8_t* const at =
                picture.samples.data() + pixel * static_cast<std::size_t>(picture.channels);
            if (std::max({at[0], at[1], at[2]}) > kBlack) return false;
        }
    return true;
}

} // namespace ghost::app
