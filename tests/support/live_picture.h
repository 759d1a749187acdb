#pragma once
// SPDX-License-Identifier: Apache-2.0
// The live renderer's picture of any stage under any lights, for tests against references: stage and camera
// through StageModel and GBuffer, shadows from distance maps that are traced here, haze by the gate. One
// device, with validation, for a test binary.

#include "bake/distance_sight.h"
#include "rays/tracer.h"
#include "render/geometry/g_buffer.h"
#include "render/geometry/stage_model.h"
#include "render/haze/distance_images.h"
#include "render/relight/relighter.h"
#include "show/camera.h"
#include "support/must.h"
#include "support/one_device.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace ghost::app {

// One map for each light, in their order, made where Light::off_map_m says; sets Light::map. Lights of one
// place share none.
inline scene::DistanceMaps trace_maps(const bake::Tracer& tracer, std::vector<shared::Light>& lights,
                                      int size) {
    const bake::DistanceSight sight(size);
    scene::DistanceMaps maps;
    maps.size = size;
    for (shared::Light& light : lights) {
        scene::DistanceMap map;
        map.fixture = std::to_string(maps.maps.size());
        map.position_m = light.position_m - light.off_map_m;
        map.distance.resize(sight.directions().size());
        std::atomic<int> next{0};
        const auto rows = [&] {
            const bake::DenormalsOff mode;
            for (int row = next++; row < size; row = next++)
                for (int x = 0; x < size; x += 8) {
                    const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                                       static_cast<std::size_t>(x);
                    float distance_m[8];
                    int instance[8];
                    tracer.distances(map.position_m, sight.directions().data() + first, 8,
                                     scene::kNoSurface_m, distance_m, instance);
                    for (std::size_t k = 0; k < 8; ++k)
                        map.distance[first + k] =
                            instance[k] < 0 ? scene::kNoSurface : glm::packHalf1x16(distance_m[k]);
                }
        };
        std::vector<std::thread> threads;
        for (unsigned k = 0; k < std::max(std::thread::hardware_concurrency(), 1u); ++k)
            threads.emplace_back(rows);
        for (std::thread& thread : threads) thread.join();
        scene::measure(map);
        maps.maps.push_back(std::move(map));
        light.map = static_cast<std::uint32_t>(maps.maps.size());
    }
    return maps;
}

struct LiveScene {
    const render::StageModel& model;
    scene::Camera camera;
    std::vector<shared::Light> lights; // Light::map set
    const shared::Gobos& gobos;
    const scene::DistanceMaps& maps;
    render::Settings settings;
    std::shared_ptr<const scene::BounceVolumes> bounced; // bounced light beside that of the lamps, or none
};

// Drawn factor times as large, then averaged.
inline image::ImageF live_picture(const LiveScene& scene, int factor = 1) {
    const int width = scene.camera.width * factor, height = scene.camera.height * factor;
    render::GBuffer g_buffer(device(), width, height);
    g_buffer.draw(scene.model, {scene::camera_to_world(scene.camera), scene.camera.fov_y_deg, width, height},
                  {scene.settings.ambient, scene.settings.haze});
    const render::DistanceImages distances(device(), scene.maps);
    render::Relighter relighter(device(), g_buffer, &distances, scene.gobos,
                                static_cast<int>(scene.lights.size()), scene.settings);
    relighter.set_room_light(scene.bounced);
    relighter.draw(scene.lights);
    EXPECT_EQ(device().validation_errors(), 0u);
    return image::averaged(relighter.frame(), factor);
}

} // namespace ghost::app
