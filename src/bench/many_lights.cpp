// SPDX-License-Identifier: Apache-2.0
#include "bench/private/many_lights.h"

#include "bench/bench_views.h"

#include <cmath>

namespace ghost::app {
namespace {

using glm::vec3;

constexpr std::size_t kMostLights = 1000;

void add_line(std::vector<Place>& places, const vec3& from_m, const vec3& to_m, int count, bool stands) {
    for (int i = 0; i < count; ++i)
        places.push_back(
            {glm::mix(from_m, to_m, static_cast<float>(i) / static_cast<float>(count - 1)), stands});
}

shared::Light festival_light(std::size_t index, const Place& place, double seconds) {
    const auto phase = static_cast<float>(seconds * 0.9 + 0.37 * static_cast<double>(index));
    const float up = place.stands ? 1.0f : -1.0f;
    const vec3 way(0.7f * std::sin(phase), -0.45f + 0.5f * std::cos(0.7f * phase), up);
    const bool wash = index % 4 == 3;
    shared::Light light = aimed_light(place.position_m, place.position_m + way, wash ? 28.0f : 11.0f, !wash);
    light.intensity_cd *= 0.5f + 0.5f * vec3(std::sin(phase), std::sin(phase + 2), std::sin(phase + 4));
    if (!wash && index % 2 == 0) {
        light.wheel[light.wheel_count++] = {1, 0, 0.0f, std::cos(2 * phase), std::sin(2 * phase), 0.0f};
        light.haze_samples = 10;
    }
    light.map = static_cast<std::uint32_t>(index + 1);
    return light;
}

} // namespace

std::vector<Place> festival_places() {
    std::vector<Place> places;
    for (int line = 0; line < 10; ++line) {
        const float share = static_cast<float>(line) / 9;
        const float z = 11.0f - 2.9f * share;
        for (const float side : {-0.22f, 0.22f}) {
            const float y = 0.5f + 10.9f * share + side;
            add_line(places, {-11.6f, y, z}, {11.6f, y, z}, 30, false);
        }
    }
    for (const float y : {11.9f, 12.3f}) add_line(places, {-11.3f, y, 2}, {11.3f, y, 2}, 40, true);
    add_line(places, {-13, -1.1f, 0.2f}, {13, -1.1f, 0.2f}, 50, true);
    add_line(places, {-7, 12.5f, 8.1f}, {7, 12.5f, 8.1f}, 26, false);
    for (const float side : {-1.0f, 1.0f}) {
        for (const float y : {3.0f, 10.0f})
            add_line(places, {side * 12.55f, y, 3.4f}, {side * 12.55f, y, 9.4f}, 12, false);
        for (const float y : {0.4f, 0.8f})
            add_line(places, {side * 14.6f, y, 9.3f}, {side * 20.4f, y, 9.3f}, 11, false);
        add_line(places, {side * 5.4f, 0.6f, 2}, {side * 11.5f, 0.6f, 2}, 12, true);
        add_line(places, {side * 6.8f, 8.6f, 2}, {side * 11.4f, 8.6f, 2}, 9, true);
        for (const float z : {5.8f, 7.3f})
            add_line(places, {side * 16, -43.1f, z}, {side * 16, -44.9f, z}, 4, false);
        for (const float x : {7.9f, 9.2f, 10.5f})
            add_line(places, {side * x, 12.4f, 2.9f}, {side * x, 12.4f, 8.2f}, 9, false);
    }
    while (places.size() < kMostLights) // what is left hangs over the apron
        places.push_back({{-11.0f + 0.55f * static_cast<float>(places.size() % 41), -0.6f, 11.2f}, false});
    places.resize(kMostLights);
    return places;
}

scene::Stage festival_stage() {
    scene::Stage stage = empty_stage();
    add_box(stage, {-60, -70, -0.2f}, {60, 40, 0});                // ground
    add_box(stage, {-12, 0, 0}, {12, 14, 1.8f});                   // deck
    add_box(stage, {-7, 12.9f, 2.6f}, {7, 13.2f, 7.6f});           // LED wall
    add_box(stage, {-13, 14, 1.8f}, {13, 14.1f, 13});              // cloth
    add_box(stage, {-13.6f, -0.5f, 13.4f}, {13.6f, 14.5f, 13.6f}); // roof
    for (int line = 0; line < 10; ++line) {
        const float share = static_cast<float>(line) / 9;
        const float y = 0.5f + 10.9f * share, z = 11.3f - 2.9f * share;
        for (const float low : {0.0f, 0.3f})
            for (const float side : {-0.15f, 0.15f})
                add_box(stage, {-12, y + side - 0.03f, z + low}, {12, y + side + 0.03f, z + low + 0.06f});
    }
    for (const float side : {-1.0f, 1.0f}) {
        for (const float y : {0.0f, 14.0f})
            add_box(stage, {side * 13.4f - 0.3f, y - 0.3f, 0}, {side * 13.4f + 0.3f, y + 0.3f, 13.4f});
        add_box(stage, {side * 17.5f - 0.7f, -0.2f, 4}, {side * 17.5f + 0.7f, 1.4f, 9}); // line array
        add_box(stage, {side * 16 - 0.3f, -44.3f, 0}, {side * 16 + 0.3f, -43.7f, 9});    // delay tower
    }
    for (int k = 0; k < 24; ++k) { // band, risers and wedges
        const float x = -9.0f + 3.6f * static_cast<float>(k % 6);
        const float y = 1.5f + 2.6f * static_cast<float>(k / 6);
        add_box(stage, {x - 0.4f, y - 0.3f, 1.8f},
                {x + 0.4f, y + 0.3f, 2.3f + 0.3f * static_cast<float>(k % 4)});
        add_ball(stage, {x, y, 3.6f}, 0.2f);
    }
    for (int k = 0; k < 400; ++k) { // crowd
        const float x = -14.0f + 0.72f * static_cast<float>(k % 40) + 0.3f * static_cast<float>(k / 40 % 2);
        const float y = -3.0f - 1.4f * static_cast<float>(k / 40);
        add_box(stage, {x - 0.2f, y - 0.15f, 0},
                {x + 0.2f, y + 0.15f, 1.5f + 0.05f * static_cast<float>(k % 7)});
    }
    return stage;
}

std::vector<shared::Light> festival_lights(const std::vector<Place>& places, std::size_t count,
                                           double seconds) {
    std::vector<shared::Light> lights;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = count == 1 ? 15 : i * places.size() / count;
        lights.push_back(festival_light(index, places[index], seconds));
    }
    return lights;
}

} // namespace ghost::app
