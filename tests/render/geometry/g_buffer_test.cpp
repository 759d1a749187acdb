// SPDX-License-Identifier: Apache-2.0
// The G-buffer against rays and planes worked out by hand: places, normals, colours, fractions of pixels,
// bounds.
#include "render/geometry/g_buffer.h"

#include "image/colour.h"
#include "shared/brdf.h"
#include "shared/haze.h"
#include "shared/push.h"
#include "support/g_buffer_picture.h"

#include <array>
#include <limits>
#include <set>

namespace ghost::render {
namespace {

using GBufferTest = RelightTest;

TEST_F(GBufferTest, PlacesLieWhereRaysMeetFloorAndWall) {
    const scene::Camera camera = camera_at({3, -20, 4}, {0, 10, 2}, 40, 160, 120); // the wall is 30 m away
    const Picture picture = drawn(room(), camera);
    expect_sound(picture);
    const Pose pose = pose_of(camera);
    scene::Passes passes;
    passes.width = camera.width;
    passes.height = camera.height;
    passes.camera_to_world = pose.camera_to_world;
    passes.fov_y_deg = camera.fov_y_deg;
    std::size_t floor = 0, wall = 0;
    for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel) {
        EXPECT_FLOAT_EQ(picture.coverage(pixel), 1.0f);
        for (const std::size_t k : picture.of(pixel)) {
            const glm::vec3 place(picture.places[k]);
            const glm::vec3 normal = picture.normal(k);
            const bool on_wall = normal.y < -0.5f;
            (on_wall ? wall : floor) += 1;
            EXPECT_NEAR(on_wall ? place.y : place.z, on_wall ? 10.0f : 0.0f, 2e-3f) << pixel;
            EXPECT_NEAR(glm::length(normal - (on_wall ? glm::vec3(0, -1, 0) : glm::vec3(0, 0, 1))), 0.0f,
                        2e-3f);
            EXPECT_LT(glm::length(picture.facet(k) - normal), 3e-3f);
            if (picture.places[k].w < 1.0f) continue;
            // The mean of the four samples is the plane's point in the middle of the pixel.
            const float x = static_cast<float>(pixel % 160) + 0.5f;
            const float y = static_cast<float>(pixel / 160) + 0.5f;
            const glm::vec3 way = ray_through(passes, x, y);
            const float t = on_wall ? (10.0f - camera.position_m.y) / way.y : -camera.position_m.z / way.z;
            const glm::vec3 expected = camera.position_m + t * way;
            const float off_m = glm::length(place - expected);
            EXPECT_LT(off_m, on_wall ? 2e-3f : 4e-2f) << pixel; // floor: the mean of a curve over the pixel
            EXPECT_LT(glm::length(glm::cross(place - camera.position_m, way)), 2e-2f);
        }
    }
    EXPECT_GT(floor, 2000u);
    EXPECT_GT(wall, 2000u);
}

TEST_F(GBufferTest, EdgeAgainstTheSkyCoversItsShare) {
    scene::Stage stage;
    stage.materials = {plain(glm::vec3(0.5f))};
    // In front of the camera at 10 m; the left edge leans 1 : 8.
    scene::Mesh mesh = quad({0, 0, -20}, {20, 0, 0}, {0, 0, 40});
    mesh.positions[0].x = -2.5f;
    mesh.positions[3].x = 2.5f;
    add(stage, mesh);
    const scene::Camera camera = camera_at({0, -10, 0}, {0, 0, 0}, 30, 96, 96);
    const Picture picture = drawn(stage, camera);
    expect_sound(picture);
    EXPECT_EQ(picture.extras, 0u) << "one surface and the sky";
    double worst = 0, sum = 0, sum_expected = 0;
    const float width_m = 2.0f * 10.0f * std::tan(glm::radians(15.0f)) / 96.0f; // of a pixel
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const float z = (48.0f - (static_cast<float>(y) + 0.5f)) * width_m;
            const float edge_x = z / 8.0f;
            const float left = (static_cast<float>(x) - 48.0f) * width_m;
            const float expected = std::clamp(1.0f - (edge_x - left) / width_m, 0.0f, 1.0f);
            const float coverage = picture.coverage(static_cast<std::size_t>(y * 96 + x));
            worst = std::max(worst, static_cast<double>(std::abs(coverage - expected)));
            sum += coverage;
            sum_expected += expected;
        }
    EXPECT_LT(worst, 0.3); // four samples
    EXPECT_NEAR(sum, sum_expected, 0.004 * sum_expected);
    EXPECT_LT(picture.places[0].w, 0.0f) << "sky";
}

TEST_F(GBufferTest, TwoSurfacesInOnePixelAreTwoFragments) {
    scene::Stage stage = room();
    add(stage, quad({-2, 2, -1}, {2.013f, 0, 0}, {0, 0, 9}, 1)); // 8 m before the wall
    const scene::Camera camera = camera_at({0, -10, 3}, {0, 10, 3}, 40, 128, 96);
    const Picture picture = drawn(stage, camera);
    expect_sound(picture);
    std::size_t both = 0;
    for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel) {
        EXPECT_FLOAT_EQ(picture.coverage(pixel), 1.0f);
        float nearest = 1e9f, farthest = 0;
        for (const std::size_t k : picture.of(pixel)) {
            const float y = picture.places[k].y;
            // Nothing floats between the surfaces.
            EXPECT_TRUE(std::abs(y - 2.0f) < 2e-3f || std::abs(y - 10.0f) < 2e-3f ||
                        std::abs(picture.places[k].z) < 2e-3f)
                << pixel << " " << y;
            nearest = std::min(nearest, y);
            farthest = std::max(farthest, y);
        }
        both += farthest - nearest > 7.9f ? 1 : 0;
    }
    EXPECT_GT(both, 40u);
}

TEST_F(GBufferTest, NormalsPointTowardsTheViewerFromBothSidesAndMirrored) {
    for (const bool mirrored : {false, true})
        for (const bool wound_wrongly : {false, true})
            for (const float side : {-1.0f, 1.0f}) {
                scene::Stage stage;
                stage.materials = {plain(glm::vec3(0.5f))};
                scene::Mesh mesh = quad({-5, 0, -5}, {10, 0, 0}, {0, 0, 10}); // normal -y
                for (glm::vec3& normal : mesh.normals) normal = glm::normalize(glm::vec3(0.3f, -1, 0));
                if (wound_wrongly)
                    std::swap(mesh.indices[1], mesh.indices[2]), std::swap(mesh.indices[4], mesh.indices[5]);
                glm::mat4 world(1.0f);
                if (mirrored) world[0][0] = -1.0f;
                add(stage, mesh, world);
                const Picture picture = drawn(stage, camera_at({0, 10 * side, 0}, {0, 0, 0}, 30, 32, 32));
                expect_sound(picture);
                const glm::vec3 expected =
                    glm::normalize(glm::vec3(mirrored ? -0.3f : 0.3f, -1, 0)) * (side < 0 ? 1.0f : -1.0f);
                EXPECT_LT(glm::length(picture.normal(16 * 32 + 16) - expected), 2e-3f)
                    << mirrored << wound_wrongly << side;
            }
}

// Bilinear, repeating, decoded before it is mixed: what the baker reads (rays/textures.h).
glm::vec3 expected_texel(const scene::Texture& texture, glm::vec2 uv) {
    const auto value = [&](int x, int y) {
        const int w = texture.pixels.width, h = texture.pixels.height;
        const std::uint8_t* t = texture.pixels.at((x % w + w) % w, (y % h + h) % h);
        glm::vec3 rgb(t[0], t[1], t[2]);
        rgb /= 255.0f;
        if (texture.is_colour)
            for (int c = 0; c < 3; ++c) rgb[c] = image::srgb_to_linear(rgb[c]);
        return rgb;
    };
    const float x = uv.x * static_cast<float>(texture.pixels.width) - 0.5f;
    const float y = uv.y * static_cast<float>(texture.pixels.height) - 0.5f;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const float fx = x - std::floor(x), fy = y - std::floor(y);
    return glm::mix(glm::mix(value(x0, y0), value(x0 + 1, y0), fx),
                    glm::mix(value(x0, y0 + 1), value(x0 + 1, y0 + 1), fx), fy);
}

scene::Texture patches(bool is_colour) {
    scene::Texture texture;
    texture.is_colour = is_colour;
    texture.pixels = image::Image8(8, 4, 4);
    std::mt19937 random(7);
    for (std::uint8_t& sample : texture.pixels.samples)
        sample = static_cast<std::uint8_t>(60 + random() % 160);
    return texture;
}

TEST_F(GBufferTest, MaterialsAreReadAsTheBakerReadsThem) {
    scene::Stage stage;
    stage.textures = {patches(true), patches(false), patches(true)};
    scene::Material material = plain({0.9f, 0.8f, 0.7f});
    material.roughness = 0.9f;
    material.metalness = 0.8f;
    material.specular = 0.5f;
    material.emission = {20, 30, 40};
    material.base_texture = 0;
    material.surface_texture = 1;
    material.emission_texture = 2;
    stage.materials = {material};
    add(stage, quad({-5, 0, -5}, {10, 0, 0}, {0, 0, 10}));
    const scene::Camera camera = camera_at({0, -10, 0}, {0, 0, 0}, 40, 128, 128);
    Surroundings surroundings;
    surroundings.ambient = {2, 3, 4};
    surroundings.haze.extinction_per_m = 0.05f;
    const Picture picture = drawn(stage, camera, surroundings);
    expect_sound(picture);
    for (int y = 5; y < 123; y += 9)
        for (int x = 5; x < 123; x += 7) {
            const auto pixel = static_cast<std::size_t>(y * 128 + x);
            const glm::vec3 place(picture.places[pixel]);
            const glm::vec2 uv(place.x / 10.0f + 0.5f, 0.5f - place.z / 10.0f);
            const glm::vec3 base =
                material.base_colour * image::rec709_to_rec2020(expected_texel(stage.textures[0], uv));
            const glm::vec3 data = expected_texel(stage.textures[1], uv);
            const shared::Brdf brdf = shared::brdf_of(base, 0.9f * data.y, 0.8f * data.z, 0.5f);
            const glm::vec3 emission =
                material.emission * image::rec709_to_rec2020(expected_texel(stage.textures[2], uv));
            const glm::vec3 way = place - camera.position_m;
            const float cosine = glm::normalize(way).y;
            const glm::vec3 light =
                (surroundings.ambient * shared::brdf_albedo(brdf, std::abs(cosine)) / shared::kPi +
                 emission) *
                shared::haze_transmittance(surroundings.haze, glm::length(way));
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(picture.diffuse[pixel][c], brdf.diffuse[c], 0.006f);
                EXPECT_NEAR(picture.specular[pixel][c], brdf.f0[c], 0.008f);
                EXPECT_NEAR(picture.base[pixel][c], light[c], 0.01f * light[c] + 0.1f);
            }
            EXPECT_NEAR(picture.diffuse[pixel].w, brdf.alpha, 0.008f);
            EXPECT_NEAR(picture.specular[pixel].w, brdf.f90, 0.006f);
        }
}

// What faces the lamp over the viewer's shoulder is brighter than what turns away, nothing is black, and
// without it all is.
TEST_F(GBufferTest, AWorkLightShowsShapes) {
    scene::Stage stage;
    stage.materials = {plain({0.5f, 0.5f, 0.5f})};
    add(stage, quad({-5, 0, 0}, {10, 0, 0}, {0, 0, 5}));   // a wall that faces the camera
    add(stage, quad({-5, -5, -1}, {10, 0, 0}, {0, 5, 0})); // a floor
    const scene::Camera camera = camera_at({0, -12, 1}, {0, 0, 0}, 40, 128, 128);
    Surroundings surroundings;
    const auto at = [](const Picture& picture, int x, int y) {
        return picture.base[static_cast<std::size_t>(y * 128 + x)].y;
    };
    const Picture dark = drawn(stage, camera, surroundings);
    EXPECT_EQ(at(dark, 64, 40), 0);
    surroundings.work_lux = 100;
    const Picture lit = drawn(stage, camera, surroundings);
    const float diffuse_cd_m2 = 100 * 0.5f / shared::kPi;
    EXPECT_GT(at(lit, 64, 40), 0.7f * diffuse_cd_m2);
    EXPECT_LT(at(lit, 64, 40), diffuse_cd_m2);
    EXPECT_GT(at(lit, 64, 90), 0.3f * diffuse_cd_m2);
    EXPECT_LT(at(lit, 64, 90), 0.8f * at(lit, 64, 40)) << "floor and wall look alike";
}

TEST_F(GBufferTest, BumpsBendTheNormalAlongThePicture) {
    scene::Texture bumps;
    bumps.is_colour = false;
    bumps.pixels = image::Image8(1, 1, 4);
    const std::array<std::uint8_t, 4> texel{204, 178, 230, 255}; // 0.6, 0.4, 0.8
    std::copy(texel.begin(), texel.end(), bumps.pixels.samples.begin());
    for (const bool tangents : {false, true}) {
        scene::Stage stage;
        stage.textures = {bumps};
        stage.materials = {plain(glm::vec3(0.5f))};
        stage.materials[0].normal_texture = 0;
        stage.materials[0].normal_scale = 0.5f;
        scene::Mesh mesh = quad({-5, 0, -5}, {10, 0, 0}, {0, 0, 10}); // u along x, the picture's up along z
        if (tangents) mesh.tangents.assign(4, glm::vec4(1, 0, 0, 1));
        add(stage, mesh);
        const Picture picture = drawn(stage, camera_at({0, -10, 0}, {0, 0, 0}, 30, 32, 32));
        const glm::vec3 expected = glm::normalize(glm::vec3(0.3f, -0.8f, 0.2f));
        EXPECT_LT(glm::length(picture.normal(500) - expected), 6e-3f) << tangents;
    }
}

TEST_F(GBufferTest, MaskedAndBlendedSurfacesLeaveTheirShareToWhatIsBehind) {
    for (const scene::AlphaMode mode : {scene::AlphaMode::mask, scene::AlphaMode::blend}) {
        scene::Stage stage = room();
        scene::Material veil = plain({0.8f, 0.8f, 0.8f});
        veil.alpha_mode = mode;
        veil.alpha = mode == scene::AlphaMode::mask ? 1.0f : 0.4f;
        if (mode == scene::AlphaMode::mask) { // the left half is open
            scene::Texture holes;
            holes.pixels = image::Image8(64, 1, 4);
            for (int x = 0; x < 64; ++x) {
                std::fill_n(holes.pixels.at(x, 0), 3, std::uint8_t{255});
                holes.pixels.at(x, 0)[3] = x < 32 ? 0 : 255;
            }
            stage.textures = {holes};
            veil.base_texture = 0;
        }
        stage.materials.push_back(veil);
        add(stage, quad({-20, 0, -1}, {40, 0, 0}, {0, 0, 40}, 2));
        const Picture picture = drawn(stage, camera_at({0, -10, 6}, {0, 0, 6}, 30, 96, 96));
        expect_sound(picture);
        double on_veil = 0, left = 0;
        for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel) {
            EXPECT_FLOAT_EQ(picture.coverage(pixel), 1.0f);
            for (const std::size_t k : picture.of(pixel)) {
                if (std::abs(picture.places[k].y) > 0.01f || picture.places[k].z < 0.01f) continue;
                on_veil += picture.places[k].w;
                if (pixel % 96 < 46) left += picture.places[k].w;
            }
        }
        const double pixels = static_cast<double>(picture.pixels());
        EXPECT_NEAR(on_veil / pixels, mode == scene::AlphaMode::mask ? 0.5 : 0.4, 0.02);
        if (mode == scene::AlphaMode::mask) {
            EXPECT_EQ(left, 0.0);
        }
    }
}

TEST_F(GBufferTest, BadInputIsLeftOutAndTheRestIsDrawn) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scene::Stage stage = room();
    scene::Mesh odd = quad({-1, 0, 0}, {2, 0, 0}, {0, 0, 2});
    odd.indices.insert(odd.indices.end(), {0, 0, 1, 2, 2, 2}); // lines and points
    odd.positions.push_back(glm::vec3(nan));
    odd.normals.push_back(glm::vec3(nan));
    odd.uvs.push_back(glm::vec2(nan));
    odd.indices.insert(odd.indices.end(), {0, 1, 4});
    add(stage, odd);
    add(stage, quad({-3, 0, 0}, {1, 0, 0}, {0, 0, 1}), glm::mat4(nan));
    stage.instances.back().name = "lost";
    scene::Mesh broken = quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    broken.name = "broken";
    broken.indices.push_back(99);
    add(stage, broken);
    stage.instances.push_back({"astray", 77, glm::mat4(1.0f), scene::kNone});
    stage.materials[1].roughness = nan;
    Report report;
    const StageModel model(device(), stage, report);
    std::string words;
    for (const Message& message : report.messages) words += message.where + ": " + message.what + "\n";
    for (const char* name : {"lost", "broken", "astray"})
        EXPECT_NE(words.find(name), std::string::npos) << words;
    expect_sound(drawn(stage, camera_at({0, -10, 3}, {0, 10, 3}, 60, 64, 48)));
    expect_sound(drawn(stage, camera_at({0, 10, 3}, {0, 20, 3}, 60, 64, 48)));      // inside the wall
    expect_sound(drawn(stage, camera_at({0, 9.9999f, 0}, {1, 10, 0}, 60, 64, 48))); // in its corner
}

TEST_F(GBufferTest, EmptyStageIsSky) {
    Surroundings surroundings;
    surroundings.ambient = glm::vec3(5.0f);
    const Picture picture =
        drawn(scene::Stage{}, camera_at({0, -10, 3}, {0, 10, 3}, 60, 50, 30), surroundings);
    expect_sound(picture);
    for (std::size_t k = 0; k < picture.pixels(); ++k) {
        EXPECT_LT(picture.places[k].w, 0.0f);
        EXPECT_EQ(picture.base[k], glm::vec4(0.0f));
    }
    EXPECT_LT(picture.bounds[0].w, 0.0f);
    EXPECT_FLOAT_EQ(picture.bounds[1].x, 60.0f);
}

TEST_F(GBufferTest, InstancesAreHiddenAndMoved) {
    scene::Stage stage;
    stage.materials = {plain(glm::vec3(0.5f))};
    add(stage, quad({-1, 0, -1}, {2, 0, 0}, {0, 0, 2}));
    stage.instances.push_back(stage.instances[0]);
    Report report;
    StageModel model(device(), stage, report);
    GBuffer buffer(device(), 64, 64);
    const Pose pose = pose_of(camera_at({0, -10, 0}, {0, 0, 0}, 30, 64, 64));
    const auto middle_y = [&] {
        buffer.draw(model, pose, {});
        const Picture picture = read(buffer);
        expect_sound(picture);
        const glm::vec4 place = picture.places[32 * 64 + 32];
        return place.w < 0 ? 99.0f : place.y;
    };
    EXPECT_NEAR(middle_y(), 0.0f, 1e-3f);
    glm::mat4 nearer(1.0f);
    nearer[3].y = -3;
    model.move(1, nearer);
    EXPECT_NEAR(middle_y(), -3.0f, 1e-3f);
    model.show(1, false);
    EXPECT_NEAR(middle_y(), 0.0f, 1e-3f);
    model.show(0, false);
    EXPECT_EQ(middle_y(), 99.0f);
    model.show(1, true);
    model.move(1, glm::mat4(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(middle_y(), 99.0f);
}

// Stopped after every piece, with another pose begun in between: the bits of one that was never stopped.
TEST_F(GBufferTest, AStoppedOneGoesOnWhereItWas) {
    scene::Stage stage = room();
    for (int row = 0; row < 40; ++row)
        for (int k = 0; k < 60; ++k) {
            stage.instances.push_back(stage.instances[0]);
            stage.instances.back().world[3] +=
                glm::vec4(0.1f * static_cast<float>(k), 0, 0.1f * static_cast<float>(row), 0);
        }
    Report report;
    StageModel model(device(), stage, report);
    const Pose pose = pose_of(camera_at({0, -10, 3}, {0, 10, 3}, 40, 100, 75));
    GBuffer whole(device(), 100, 75), stopped(device(), 100, 75);
    EXPECT_TRUE(whole.draw(model, pose, {}));
    int stops = 0;
    const auto stop = [] { return true; };
    EXPECT_FALSE(stopped.draw(model, pose_of(camera_at({3, -10, 3}, {0, 10, 3}, 40, 100, 75)), {}, stop));
    while (!stopped.draw(model, pose, {}, stop)) {
        EXPECT_FALSE(stopped.shows(pose, {}));
        ASSERT_LT(++stops, 1000);
    }
    EXPECT_GT(stops, 0);
    EXPECT_TRUE(stopped.shows(pose, {}));
    const Picture a = read(whole), b = read(stopped);
    EXPECT_EQ(a.extras, b.extras);
    for (std::size_t pixel = 0; pixel < a.pixels(); ++pixel) {
        ASSERT_EQ(a.places[pixel], b.places[pixel]) << pixel;
        ASSERT_EQ(a.base[pixel], b.base[pixel]) << pixel;
    }
}

// The stage takes a second to draw, what is around it a few milliseconds.
TEST_F(GBufferTest, OtherSurroundingsNeedNoOtherSamples) {
    scene::Stage stage = room();
    add(stage, quad({-2, 2, -1}, {2.013f, 0, 0.3f}, {0, 0, 9}, 1));
    Report report;
    StageModel model(device(), stage, report);
    model.mark_moving(1);
    const Pose pose = pose_of(camera_at({0, -10, 3}, {0, 10, 3}, 40, 100, 75));
    Surroundings before, after;
    before.ambient = glm::vec3(2);
    after.ambient = glm::vec3(1, 3, 5);
    after.haze.extinction_per_m = 0.05f;
    after.work_lux = 100;
    GBuffer one(device(), 100, 75), other(device(), 100, 75);
    one.draw(model, pose, before);
    model.move(1, glm::translate(glm::mat4(1.0f), glm::vec3(0.3f, 0, 0)));
    EXPECT_TRUE(one.draw(model, pose, after));
    EXPECT_TRUE(one.shows(pose, after));
    EXPECT_FALSE(one.shows(pose, before));
    for (const gpu::Span& span : one.spans()) EXPECT_NE(span.name, "raster");
    other.draw(model, pose, after);
    const Picture a = read(one), b = read(other);
    EXPECT_EQ(a.extras, b.extras);
    for (std::size_t pixel = 0; pixel < a.pixels(); ++pixel) {
        ASSERT_EQ(a.places[pixel], b.places[pixel]) << pixel;
        ASSERT_EQ(a.base[pixel], b.base[pixel]) << pixel;
        ASSERT_EQ(a.diffuse[pixel], b.diffuse[pixel]) << pixel;
    }
}

TEST_F(GBufferTest, AnotherModelFromTheSamePlaceIsDrawnAnew) {
    scene::Stage stage = room();
    Report report;
    const StageModel empty(device(), stage, report);
    add(stage, quad({-2, 2, -1}, {2.013f, 0, 0.3f}, {0, 0, 9}, 1));
    const StageModel wall(device(), stage, report);
    const scene::Camera camera = camera_at({0, -10, 3}, {0, 10, 3}, 40, 100, 75);
    GBuffer buffer(device(), 100, 75);
    buffer.draw(empty, pose_of(camera), {});
    buffer.draw(wall, pose_of(camera), {});
    EXPECT_EQ(read(buffer).base, drawn(stage, camera).base);
}

TEST_F(GBufferTest, TheSameCameraGivesTheSameBits) {
    scene::Stage stage = room();
    add(stage, quad({-2, 2, -1}, {2.013f, 0, 0.3f}, {0, 0, 9}, 1));
    const scene::Camera camera = camera_at({0, -10, 3}, {0, 10, 3}, 40, 100, 75);
    const Picture a = drawn(stage, camera);
    const Picture b = drawn(stage, camera);
    ASSERT_GT(a.extras, 20u);
    for (std::size_t pixel = 0; pixel < a.pixels(); ++pixel) {
        const std::vector<std::size_t> in_a = a.of(pixel),
                                       in_b = b.of(pixel); // tiles may have changed places
        ASSERT_EQ(in_a.size(), in_b.size());
        for (std::size_t k = 0; k < in_a.size(); ++k) {
            EXPECT_EQ(a.places[in_a[k]], b.places[in_b[k]]);
            EXPECT_EQ(a.diffuse[in_a[k]], b.diffuse[in_b[k]]);
            EXPECT_EQ(a.normals[in_a[k]], b.normals[in_b[k]]);
        }
    }
    EXPECT_EQ(a.base, b.base);
}

TEST_F(GBufferTest, MeshesHaveAnEndTogether) {
    const scene::Stage stage = room(); // two squares
    const std::uint64_t square = 4 * sizeof(StageVertex) + 3 * 6 * sizeof(std::uint32_t);
    for (const std::uint64_t bytes : {2 * square, 2 * square - 1, square - 1}) {
        Report report;
        const StageModel model(device(), stage, report, StageModel::kTextureBytes, bytes);
        const std::size_t drawn = bytes / square;
        EXPECT_EQ(model.drawn_triangles(), 2 * drawn);
        ASSERT_EQ(report.messages.size(), 2 - drawn);
        for (const Message& message : report.messages)
            EXPECT_NE(message.what.find("the mesh is not drawn"), std::string::npos) << message.what;
    }
}

// Pixels beyond the room for extra fragments keep one, which stands for all.
TEST_F(GBufferTest, NoRoomForExtrasKeepsTheMainFragment) {
    scene::Stage stage = room();
    std::mt19937 random(3);
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    scene::Mesh confetti; // about the size of pixels, several deep
    for (int k = 0; k < 40000; ++k) {
        const scene::Mesh one = quad({16 * unit() - 8, 8 * unit(), 12 * unit() - 1},
                                     {0.15f, 0.1f * unit(), 0.05f}, {0.03f, 0.1f * unit(), 0.15f});
        const auto first = static_cast<std::uint32_t>(confetti.positions.size());
        for (const std::uint32_t index : one.indices) confetti.indices.push_back(first + index);
        confetti.positions.insert(confetti.positions.end(), one.positions.begin(), one.positions.end());
        confetti.normals.insert(confetti.normals.end(), one.normals.begin(), one.normals.end());
    }
    add(stage, confetti);
    const Picture picture = drawn(stage, camera_at({0, -10, 4}, {0, 10, 6}, 60, 48, 48));
    expect_sound(picture);
    EXPECT_GT(picture.dropped, 0u);
    EXPECT_GT(picture.extras, 1000u);
    EXPECT_LE(picture.extras, 48u * 48u);
    for (std::size_t k = 0; k < picture.pixels(); ++k) EXPECT_FLOAT_EQ(picture.coverage(k), 1.0f);
}

TEST_F(GBufferTest, LargeTexturesLoseLevelsWithAWarning) {
    scene::Stage stage;
    scene::Texture big;
    big.pixels = image::Image8(512, 256, 4);
    std::fill(big.pixels.samples.begin(), big.pixels.samples.end(), std::uint8_t{128});
    stage.textures = {big};
    stage.materials = {plain(glm::vec3(1.0f))};
    stage.materials[0].base_texture = 0;
    add(stage, quad({-5, 0, -5}, {10, 0, 0}, {0, 0, 10}));
    Report report;
    const StageModel model(device(), stage, report, 100'000);
    ASSERT_EQ(report.messages.size(), 1u);
    EXPECT_NE(report.messages[0].what.find("at most 128 texels"), std::string::npos)
        << report.messages[0].what;
    EXPECT_EQ(model.texture(1).shape().width, 128u);
    EXPECT_EQ(model.texture(1).shape().height, 64u);
}

} // namespace
} // namespace ghost::render
