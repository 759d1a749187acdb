// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_views.h"

#include "base/check.h"
#include "base/interrupt.h"
#include "image/metrics.h"
#include "photometry/photometry.h"
#include "reference/reference.h"
#include "shared/octahedral.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <thread>

namespace ghost::app {
namespace {

using glm::vec3;

constexpr float kPeak_cd = 20000.0f;
constexpr int kRound = 32;         // quads round a ball
constexpr int kPacket = 8;         // rays of Tracer::distances
constexpr float kPivot_m = 0.255f; // of a head, behind its lens

scene::Mesh box_mesh() {
    scene::Mesh mesh;
    mesh.name = "box";
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            vec3 normal(0), u(0);
            normal[axis] = side;
            u[(axis + 1) % 3] = 1;
            const vec3 v = glm::cross(normal, u);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const vec3& corner : {normal - u - v, normal + u - v, normal + u + v, normal - u + v}) {
                mesh.positions.push_back(0.5f * corner);
                mesh.normals.push_back(normal);
            }
            for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
        }
    return mesh;
}

scene::Mesh ball_mesh() {
    scene::Mesh mesh;
    mesh.name = "ball";
    for (int y = 0; y <= kRound / 2; ++y)
        for (int x = 0; x <= kRound; ++x) {
            const float around = 2 * shared::kPi * static_cast<float>(x) / kRound;
            const float down = 2 * shared::kPi * static_cast<float>(y) / kRound;
            const vec3 normal(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around),
                              std::cos(down));
            mesh.positions.push_back(normal);
            mesh.normals.push_back(normal);
        }
    constexpr std::uint32_t kRow = kRound + 1;
    for (std::uint32_t y = 0; y < kRound / 2; ++y)
        for (std::uint32_t x = 0; x < kRound; ++x) {
            const std::uint32_t a = y * kRow + x;
            mesh.indices.insert(mesh.indices.end(), {a, a + kRow, a + 1, a + 1, a + kRow, a + kRow + 1});
        }
    return mesh;
}

void add_instance(scene::Stage& stage, int mesh, const glm::mat4& world) {
    scene::Instance instance;
    instance.name =
        stage.meshes[static_cast<std::size_t>(mesh)].name + " " + std::to_string(stage.instances.size() + 1);
    instance.mesh = mesh;
    instance.world = world;
    stage.instances.push_back(std::move(instance));
}

void put_gobo(shared::Light& light, std::uint32_t layer, float turn_deg) {
    const float turn = glm::radians(turn_deg);
    light.wheel[light.wheel_count++] = {layer, 0, 0.0f, std::cos(turn), std::sin(turn), 0.0f};
    light.haze_samples = 10; // the paper's number for lights with gobos
}

scene::Camera camera_at(const vec3& eye_m, const vec3& target_m, float fov_y_deg) {
    scene::Camera camera;
    camera.position_m = eye_m;
    camera.target_m = target_m;
    camera.fov_y_deg = fov_y_deg;
    camera.width = 256;
    camera.height = 144;
    return camera;
}

scene::Stage room() {
    scene::Stage stage = empty_stage();
    add_box(stage, {-20, -20, -0.2f}, {20, 6.2f, 0});
    add_box(stage, {-20, 6, 0}, {20, 6.2f, 12});
    add_box(stage, {-2.6f, 2.4f, 0}, {-1.4f, 3.6f, 1});
    add_box(stage, {2.2f, 3.4f, 0}, {3, 4.2f, 1.8f});
    return stage;
}

// Two chords and their lattice across the way of the light.
void add_truss(scene::Stage& stage) {
    for (const float z : {4.9f, 5.4f})
        for (const float x : {-2.6f, -2.1f})
            add_box(stage, {x - 0.025f, -2, z - 0.025f}, {x + 0.025f, 6, z + 0.025f});
    for (int k = 0; k < 16; ++k) {
        const float y = -2 + 0.5f * static_cast<float>(k);
        add_box(stage, {-2.62f, y, 4.9f}, {-2.58f, y + 0.04f, 5.4f});
        add_box(stage, {-2.6f, y + 0.25f, 5.38f}, {-2.1f, y + 0.29f, 5.42f});
    }
}

image::ImageF mean_of_corners(const image::ImageF& corners) {
    image::ImageF picture(corners.width - 1, corners.height - 1, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                picture.at(x, y)[c] = 0.25f * (corners.at(x, y)[c] + corners.at(x + 1, y)[c] +
                                               corners.at(x, y + 1)[c] + corners.at(x + 1, y + 1)[c]);
    return picture;
}

// 1 where a pixel and its neighbours show one surface each, by the instances at 3 x 3 points.
std::vector<std::uint8_t> away_from_silhouettes(const scene::Camera& camera, const bake::Tracer& tracer) {
    const bake::DenormalsOff mode;
    const glm::mat4 world = scene::camera_to_world(camera);
    const float tan_y = std::tan(glm::radians(camera.fov_y_deg) * 0.5f);
    const float tan_x = tan_y * static_cast<float>(camera.width) / static_cast<float>(camera.height);
    const int columns = 2 * camera.width + 1, rows = 2 * camera.height + 1;
    std::vector<int> seen;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const float right = tan_x * (static_cast<float>(x) / static_cast<float>(camera.width) - 1);
            const float up = tan_y * (1 - static_cast<float>(y) / static_cast<float>(camera.height));
            const vec3 way = glm::normalize(-vec3(world[2]) + right * vec3(world[0]) + up * vec3(world[1]));
            seen.push_back(tracer.first_hit(camera.position_m, way, 0.5f, bake::Sees::everything).instance);
        }
    std::vector<std::uint8_t> counts;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto at = [&](int u, int v) {
                return seen[static_cast<std::size_t>(std::clamp(v, 0, rows - 1) * columns +
                                                     std::clamp(u, 0, columns - 1))];
            };
            bool one = true;
            for (int v = 2 * y - 2; v <= 2 * y + 4; ++v)
                for (int u = 2 * x - 2; u <= 2 * x + 4; ++u)
                    one = one && at(u, v) == at(2 * x + 1, 2 * y + 1);
            counts.push_back(one ? 1 : 0);
        }
    return counts;
}

} // namespace

scene::Stage empty_stage() {
    scene::Stage stage;
    scene::Material grey;
    grey.name = "grey";
    grey.base_colour = vec3(0.3f);
    grey.specular = 0;
    stage.materials.push_back(grey);
    stage.meshes = {box_mesh(), ball_mesh()};
    return stage;
}

void add_box(scene::Stage& stage, const vec3& low_m, const vec3& high_m) {
    add_instance(stage, 0, glm::scale(glm::translate(glm::mat4(1), 0.5f * (low_m + high_m)), high_m - low_m));
}

void add_ball(scene::Stage& stage, const vec3& centre_m, float radius_m) {
    add_instance(stage, 1, glm::scale(glm::translate(glm::mat4(1), centre_m), vec3(radius_m)));
}

shared::Light aimed_light(const vec3& from_m, const vec3& to_m, float field_deg, bool hard_edge) {
    const scene::Profile profile =
        scene::make_profile(field_deg * (hard_edge ? 0.85f : 0.6f), field_deg, hard_edge);
    shared::Light light{};
    light.position_m = from_m;
    light.axis_w = glm::normalize(to_m - from_m);
    const vec3 aside = std::abs(light.axis_w.z) > 0.9f ? vec3(0, 1, 0) : vec3(0, 0, 1);
    light.axis_u = glm::normalize(glm::cross(light.axis_w, aside));
    light.axis_v = glm::cross(light.axis_u, light.axis_w);
    light.lens_m = kPivot_m;
    light.tan_field = profile.tan_field;
    light.cut_radius = profile.cut_radius;
    light.profile_power = profile.power;
    light.profile_scale = profile.scale;
    light.intensity_cd = vec3(1.0f, 0.7f, 0.4f) * kPeak_cd;
    light.colour_b = vec3(1.0f);
    light.split = shared::kNoSplit;
    light.iris_radius = profile.aperture;
    light.edge = profile.edge;
    light.focus_per_m = 0.1f;
    light.lens_radius_m = hard_edge ? 0.07f : 0.0f;
    light.haze_samples = 4; // the paper's number for simple lights
    return light;
}

void leave_lens(shared::Light& light, float radius_m) {
    const vec3 lens_m = light.position_m;
    light.lens_m = radius_m / light.tan_field;
    light.position_m = lens_m - light.lens_m * light.axis_w;
    light.off_map_m = light.position_m - (lens_m - kPivot_m * light.axis_w);
    light.disc_radius_m = radius_m;
    light.lens_radius_m = radius_m;
}

std::vector<BenchView> bench_views() {
    const scene::Camera house = camera_at({0, -12, 3}, {0, 4, 3}, 26);
    const vec3 left(-4, 2, 6), right(4, 2, 0.5f);
    std::vector<BenchView> all;
    all.push_back({"narrow, 3 degrees", room(), house, aimed_light(left, right, 3, true)});
    all.push_back({"wide wash", room(), house, aimed_light({0, 3, 7}, {0, 2, 0}, 50, false)});
    shared::Light light = aimed_light(left, right, 30, true);
    put_gobo(light, 1, 20);
    all.push_back({"gobo", room(), house, light});
    shared::Light soft = light;
    soft.focus_per_m = 1.0f / 2.0f; // 2 m; the beam is 10 m long
    put_gobo(light, 2, 50);
    all.push_back({"two gobos", room(), house, light});
    all.push_back({"soft, out of focus", room(), house, soft});
    all.push_back(
        {"at the camera, from outside", room(), house, aimed_light({1, 5, 6}, {2.6f, -12, 3}, 12, true)});
    all.push_back(
        {"into the camera, in the cone", room(), house, aimed_light({1, 5, 6}, {0, -12, 3}, 20, true)});
    all.push_back({"away from the camera", room(), house, aimed_light({2, -9, 5}, {-1, 6, 2}, 25, true)});
    all.push_back({"from below", room(), camera_at({2, -6, 1.5f}, {0, 4, 3.5f}, 50),
                   aimed_light({0, 3, 0.3f}, {1, 3, 9}, 18, false)});
    BenchView truss{"light through a truss", room(), house, aimed_light(left, right, 24, true)};
    add_truss(truss.stage);
    all.push_back(std::move(truss));
    light = aimed_light(left, right, 30, true);
    put_gobo(light, 2, 0);
    BenchView bars{"beam behind bars", room(), house, light};
    for (int k = -8; k <= 8; ++k)
        add_box(bars.stage, {0.5f * static_cast<float>(k) - 0.04f, -3, 0},
                {0.5f * static_cast<float>(k) + 0.04f, -2.92f, 8});
    all.push_back(std::move(bars));
    all.push_back({"near the lens", room(), camera_at({-5, 0.5f, 6.3f}, {-3.5f, 2, 5.6f}, 50),
                   aimed_light(left, right, 14, true)});
    BenchView lens{"bar before a wide lens", room(), house, aimed_light({-4, 2, 4}, {4, 2, 4}, 10, true)};
    leave_lens(lens.light, 0.07f);
    add_box(lens.stage, {-3.025f, 1.5f, 4.02f}, {-2.975f, 2.5f, 4.07f});
    all.push_back(std::move(lens));
    return all;
}

BenchView thesis_view() {
    BenchView view{"thesis", empty_stage(), camera_at({0, -9, 3}, {0, 2, 2.6f}, 40), {}};
    view.camera.width = view.camera.height = 256;
    add_box(view.stage, {-12, -12, -0.2f}, {12, 5.2f, 0});
    add_box(view.stage, {-12, 5, 0}, {12, 5.2f, 10});
    add_box(view.stage, {-0.9f, 0.6f, 0}, {0.1f, 1.6f, 1});
    add_box(view.stage, {1.3f, 2.2f, 0}, {1.9f, 2.8f, 1.7f});
    add_box(view.stage, {0.5f, -0.4f, 0}, {1, 0.1f, 0.5f});
    add_ball(view.stage, {0.3f, 1.6f, 2.4f}, 0.45f);
    view.light = aimed_light({-2.2f, 1, 5.6f}, {1, 1.8f, 0}, 26, true);
    put_gobo(view.light, 2, 15);
    return view;
}

scene::DistanceMap trace_distances(const bake::Tracer& tracer, const vec3& position_m, int map_side) {
    CHECK(map_side > 0 && map_side % kPacket == 0);
    scene::DistanceMap map;
    map.position_m = position_m;
    const auto side = static_cast<std::size_t>(map_side);
    map.distance.assign(side * side, scene::kNoSurface);
    std::atomic<int> next_row{0};
    const auto work = [&] {
        const bake::DenormalsOff mode;
        for (int y = next_row++; y < map_side; y = next_row++)
            for (int x = 0; x < map_side; x += kPacket) {
                vec3 ways[kPacket];
                float distances_m[kPacket];
                int instances[kPacket];
                for (int k = 0; k < kPacket; ++k)
                    ways[k] = shared::direction_from_octahedral(
                        glm::vec2(static_cast<float>(x + k) + 0.5f, static_cast<float>(y) + 0.5f) /
                        static_cast<float>(map_side));
                tracer.distances(position_m, ways, kPacket, scene::kNoSurface_m, distances_m, instances);
                for (int k = 0; k < kPacket; ++k)
                    if (instances[k] >= 0)
                        map.distance[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x + k)] =
                            glm::packHalf1x16(distances_m[k]);
            }
    };
    {
        std::vector<std::jthread> others;
        for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) others.emplace_back(work);
        work();
    }
    scene::measure(map);
    return map;
}

BenchStages::BenchStages(const gpu::Device& device, std::vector<BenchView> views, int map_side)
    : views_(std::move(views)), g_buffer_(device, views_[0].camera.width, views_[0].camera.height) {
    scene::DistanceMaps maps;
    maps.size = map_side;
    Report report; // of stages made in code: nothing to say
    for (std::size_t k = 0; k < views_.size(); ++k) {
        tracers_.push_back(std::make_unique<bake::Tracer>(views_[k].stage));
        models_.push_back(std::make_unique<render::StageModel>(device, views_[k].stage, report));
        maps.maps.push_back(
            trace_distances(*tracers_[k], views_[k].light.position_m - views_[k].light.off_map_m, map_side));
        views_[k].light.map = static_cast<std::uint32_t>(k + 1);
    }
    distances_ = std::make_unique<render::DistanceImages>(device, maps);
}

void BenchStages::look(std::size_t view, float aside_m) {
    scene::Camera camera = views_[view].camera;
    camera.position_m.x += aside_m;
    g_buffer_.draw(*models_[view],
                   {scene::camera_to_world(camera), camera.fov_y_deg, camera.width, camera.height},
                   {vec3(0), bench_settings().haze});
}

Result<References> reference_haze(const BenchView& view, const bake::Tracer& tracer, int air_samples) {
    bake::ReferenceOptions options;
    options.air_samples = air_samples;
    options.surfaces = false;
    options.stop = interrupted;
    const shared::Gobos gobos = bench_gobos();
    const shared::Haze haze = bench_settings().haze;
    References references;
    TRY(references.gate,
        bake::reference_picture(&tracer, view.camera, {view.light}, gobos, haze, 0, options));
    // The corners of the pixels are the middles of a picture one larger.
    scene::Camera corners = view.camera;
    const float tangent = std::tan(glm::radians(view.camera.fov_y_deg) * 0.5f);
    corners.fov_y_deg = 2.0f * glm::degrees(std::atan(tangent * static_cast<float>(view.camera.height + 1) /
                                                      static_cast<float>(view.camera.height)));
    ++corners.width;
    ++corners.height;
    options.shadows = false;
    TRY(const image::ImageF rays,
        bake::reference_picture(&tracer, corners, {view.light}, gobos, haze, 0, options));
    references.samples = mean_of_corners(rays);
    references.counts = away_from_silhouettes(view.camera, tracer);
    return references;
}

Result<Accuracy> accuracy_of(image::ImageF picture, const image::ImageF& reference,
                             const std::vector<std::uint8_t>& counts) {
    TRY(image::PicturePair pair, image::pair_up(std::move(picture), reference, {}));
    pair.counted = 0;
    for (std::size_t p = 0; p < counts.size(); ++p) {
        pair.counts[p] &= counts[p];
        pair.counted += pair.counts[p];
    }
    if (pair.counted == 0) return Error{"every pixel of the view is at a silhouette", "bench"};
    return Accuracy{image::psnr_db(pair, image::p75_curve(pair)), 100 * image::relative_errors(pair).bias,
                    100 * static_cast<double>(pair.counted) / static_cast<double>(counts.size())};
}

} // namespace ghost::app
