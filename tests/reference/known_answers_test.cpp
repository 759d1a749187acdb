// SPDX-License-Identifier: Apache-2.0
// Pictures whose pixels can be worked out on paper.
#include "passes/relight_cpu.h"
#include "reference/trace_lit.h"
#include "support/test_show.h"

#include <gtest/gtest.h>

namespace ghost::bake {
namespace {

scene::Camera looking(const glm::vec3& from, const glm::vec3& to, float fov_y_deg, int width, int height) {
    scene::Camera camera;
    camera.name = "eye";
    camera.position_m = from;
    camera.target_m = to;
    camera.fov_y_deg = fov_y_deg;
    camera.width = width;
    camera.height = height;
    return camera;
}

Frame frame_of(const scene::Stage& stage, const scene::Camera& camera, const std::vector<glm::vec3>& lights_m,
               int spp = 16, int bounces = 0) {
    const Tracer tracer(stage);
    FrameRequest request;
    request.spp = spp;
    request.bounces = bounces;
    request.lights_m = lights_m;
    std::uint64_t rays = 0;
    return trace_frame(tracer, camera, request, rays);
}

std::size_t pixel_at(const Frame& frame, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x);
}

// The issue's own answer: a white wall shows I cos / d^2 * albedo / pi, from the show to the relit picture.
TEST(KnownAnswers, WhiteWallThroughTheWholePipeline) {
    const TestFolder folder;
    scene::Show show;
    show.folder = folder.path;
    const glm::vec3 albedo(0.8f, 0.6f, 0.4f);
    place(show.stage, add_mesh(show.stage, quad_mesh({-5, 4, -5}, {10, 0, 0}, {0, 0, 10}),
                               add_material(show.stage, albedo)));
    show.cameras = {looking({0, 0, 0}, {0, 4, 0}, 60, 64, 48)};
    const glm::vec3 lamp(1.0f, 1.0f, 1.5f);
    add_fixture(show, "Lamp", lamp);
    Report report;
    const auto stats = bake_show(show, {}, report);
    ASSERT_TRUE(stats.ok()) << stats.error().text();
    const auto passes = scene::load_passes(scene::passes_folder(show, "eye"), true, report);
    ASSERT_TRUE(passes.ok()) << passes.error().text();
    EXPECT_FALSE(report.lost_anything());

    shared::Light light = spot(lamp, {0.2f, 4, 0}, 60, 0);
    light.profile_scale = 0.0f; // even
    light.intensity_cd = {500, 300, 100};
    const image::ImageF picture = scene::relight_cpu(*passes, std::span(&light, 1), {}, {});
    double worst = 0;
    for (int y = 4; y < 44; ++y)
        for (int x = 4; x < 60; ++x) {
            const glm::vec3 at(passes->fragments[static_cast<std::size_t>(y * 64 + x)]);
            const glm::vec3 way = lamp - at;
            const float d2 = glm::dot(way, way);
            const glm::vec3 expected =
                light.intensity_cd * albedo * (-way.y / std::sqrt(d2) / d2 / shared::kPi);
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, std::abs(static_cast<double>(picture.at(x, y)[c] / expected[c]) - 1));
        }
    std::printf("white wall: worst error %.3f %%\n", 100 * worst);
    EXPECT_LT(worst, 0.005);
}

TEST(KnownAnswers, ShadowEdge) {
    scene::Stage stage;
    const int white = add_material(stage, glm::vec3(0.8f));
    place(stage, add_mesh(stage, quad_mesh({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), white));
    // Half way up, from x = 0.5 on: the shadow begins at x = 1.
    place(stage, add_mesh(stage, quad_mesh({0.5f, -9, 2}, {9, 0, 0}, {0, 18, 0}), white));
    const scene::Camera camera = looking({1, 0, 1.5f}, {1, 0, 0}, 40, 200, 20);
    const Frame frame = frame_of(stage, camera, {{0, 0, 4}}, 64);
    double lit = 0;
    for (int x = 0; x < 200; ++x) {
        const auto p = pixel_at(frame, x, 10);
        const glm::vec3 way = glm::vec3(0, 0, 4) - glm::vec3(frame.centre_position[p]);
        const float d2 = glm::dot(way, way);
        lit += frame.lights[0][p].x / (0.8f / shared::kPi * way.z / std::sqrt(d2) / d2);
    }
    const float left_m = frame.centre_position[pixel_at(frame, 0, 10)].x;
    const float right_m = frame.centre_position[pixel_at(frame, 199, 10)].x;
    const double pixel_m = static_cast<double>(right_m - left_m) / 199;
    EXPECT_NEAR(static_cast<double>(left_m) + (lit - 0.5) * pixel_m, 1.0, 0.1 * pixel_m);
}

// A card between lamp and floor, seen by neither camera.
Frame under_card(scene::Material material, const image::Image8* texture) {
    scene::Stage stage;
    place(stage, add_mesh(stage, quad_mesh({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}),
                          add_material(stage, glm::vec3(0.8f))));
    if (texture != nullptr) {
        stage.textures.push_back({"card", *texture, true});
        material.base_texture = 0;
    }
    stage.materials.push_back(material);
    place(stage, add_mesh(stage, quad_mesh({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}), 1));
    return frame_of(stage, looking({0, 0, 1}, {0, 0, 0}, 60, 32, 32), {{0, 0, 4}});
}

TEST(KnownAnswers, BlendedCardLetsItsShareThrough) {
    scene::Material open;
    open.alpha_mode = scene::AlphaMode::blend;
    open.alpha = 0.0f;
    scene::Material quarter = open;
    quarter.alpha = 0.25f;
    const Frame clear = under_card(open, nullptr);
    const Frame dimmed = under_card(quarter, nullptr);
    for (const int x : {3, 16, 28}) {
        const auto p = pixel_at(clear, x, 16);
        ASSERT_GT(clear.lights[0][p].x, 0.0f);
        EXPECT_NEAR(dimmed.lights[0][p].x / clear.lights[0][p].x, 0.75f, 1e-4f);
    }
}

TEST(KnownAnswers, MaskedCardCutsWhereItsTextureSays) {
    image::Image8 half(64, 64, 4);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            half.at(x, y)[0] = half.at(x, y)[1] = half.at(x, y)[2] = 255;
            half.at(x, y)[3] = x < 32 ? 0 : 255;
        }
    scene::Material masked;
    masked.alpha_mode = scene::AlphaMode::mask;
    const Frame frame = under_card(masked, &half);
    EXPECT_GT(frame.lights[0][pixel_at(frame, 4, 16)].x, 0.01f);
    EXPECT_EQ(frame.lights[0][pixel_at(frame, 27, 16)].x, 0.0f);
}

TEST(KnownAnswers, BlendedCardCoversItsShareOfAPixel) {
    scene::Stage stage;
    place(stage, add_mesh(stage, quad_mesh({-9, 6, -9}, {18, 0, 0}, {0, 0, 18}),
                          add_material(stage, glm::vec3(0.8f))));
    scene::Material card;
    card.alpha_mode = scene::AlphaMode::blend;
    card.alpha = 0.25f;
    stage.materials.push_back(card);
    place(stage, add_mesh(stage, quad_mesh({-2, 3, -2}, {4, 0, 0}, {0, 0, 4}), 1));
    const Frame frame = frame_of(stage, looking({0, 0, 0.1f}, {0, 6, 0.1f}, 30, 16, 16), {}, 16);
    const auto p = pixel_at(frame, 8, 4);
    ASSERT_EQ(frame.extra_first[p + 1] - frame.extra_first[p], 1u);
    const glm::vec4& front = frame.fragments[256 + frame.extra_first[p]];
    EXPECT_NEAR(front.w, 0.25f, 1.01f / 16); // one sample more or less
    EXPECT_NEAR(front.y, 3.0f, 1e-4f);
    EXPECT_EQ(frame.fragments[p].w + front.w, 1.0f);
}

TEST(KnownAnswers, CoarseSmoothSphereHasNoDarkFacets) {
    scene::Stage stage;
    place(stage, add_mesh(stage, sphere_mesh(1.0f, 9), add_material(stage, glm::vec3(0.8f))));
    const glm::vec3 lamp(0, -20, 20);
    const Frame frame = frame_of(stage, looking({0, -8, 0}, {0, 0, 0}, 16, 96, 96), {lamp});
    int seen = 0;
    for (std::size_t p = 0; p < frame.centre_position.size(); ++p) {
        if (frame.centre_position[p].w == 0) continue;
        const float cosine = glm::dot(frame.centre_normal[p], glm::normalize(lamp));
        if (cosine < 0.1f || frame.fragments[p].w < 1) continue;
        ++seen;
        EXPECT_GT(frame.lights[0][p].x, 0.0f) << "pixel " << p << " cosine " << cosine;
    }
    EXPECT_GT(seen, 1000);
}

TEST(KnownAnswers, BodiesAreLitButThrowNoShadow) {
    scene::Stage stage;
    const int white = add_material(stage, glm::vec3(0.8f));
    place(stage, add_mesh(stage, quad_mesh({-9, 4, -9}, {18, 0, 0}, {0, 0, 18}), white));
    const scene::Camera camera = looking({0, 0, 0}, {0, 4, 0}, 60, 16, 16);
    const Frame bare = frame_of(stage, camera, {{0.2f, 1, 0}, {0.2f, -3, 0}});
    place(stage, add_mesh(stage, box_mesh(glm::vec3(0.2f)), white),
          glm::translate(glm::mat4(1.0f), {0.2f, 1, 0}), 0);
    const Frame hung = frame_of(stage, camera, {{0.2f, 1, 0}, {0.2f, -3, 0}});
    const auto wall = pixel_at(bare, 2, 2);
    EXPECT_EQ(bare.lights[0][wall], hung.lights[0][wall]);
    EXPECT_EQ(bare.lights[1][wall], hung.lights[1][wall]);
    int covered = 0;
    for (std::size_t p = 0; p < 256; ++p)
        if (hung.centre_distance_m[p] < 1.5f && hung.centre_position[p].w > 0) {
            ++covered;
            EXPECT_GT(hung.lights[1][p].x, 0.0f);
        }
    EXPECT_GT(covered, 0);
}

TEST(KnownAnswers, EvenLightAndEmission) {
    scene::Stage stage;
    const int glowing = add_material(stage, glm::vec3(0.5f));
    stage.materials.back().emission = {3, 2, 1};
    place(stage, add_mesh(stage, quad_mesh({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}), glowing));
    const Frame frame = frame_of(stage, looking({0, 0, 3}, {0, 0, 0}, 40, 8, 8), {});
    for (std::size_t p = 0; p < 64; ++p) {
        EXPECT_NEAR(frame.ambient[p].x, 0.5f / shared::kPi, 0.005f * 0.5f);
        EXPECT_NEAR(frame.emission[p].x, 3.0f, 1e-5f);
        EXPECT_NEAR(frame.emission[p].z, 1.0f, 1e-5f);
    }
}

// Inside a ball of albedo rho with the lamp in its middle, every bounce adds rho times the one before.
TEST(KnownAnswers, BouncesInsideABall) {
    scene::Stage stage;
    const float rho = 0.6f;
    place(stage, add_mesh(stage, sphere_mesh(4.0f, 64), add_material(stage, glm::vec3(rho))));
    const Frame frame = frame_of(stage, looking({0, 0.5f, 0}, {0, 2, 0}, 60, 16, 16), {{0, 0, 0}}, 64, 2);
    const double direct = static_cast<double>(rho) / 16 / 3.14159265;
    double mean = 0;
    for (std::size_t p = 0; p < 256; ++p) {
        EXPECT_NEAR(frame.lights[0][p].x, direct, 0.01 * direct);
        mean += static_cast<double>(frame.indirect[0][p].x) / 256;
    }
    EXPECT_NEAR(mean, direct * (rho + rho * rho), 0.01 * direct);
}

// A map whose normals lean up the picture brightens a wall lit from above.
TEST(KnownAnswers, NormalMapLeansTheRightWay) {
    const auto brightness = [](std::uint8_t green, std::uint8_t red, const glm::vec3& lamp) {
        scene::Stage stage;
        image::Image8 map(2, 2, 4);
        for (std::size_t k = 0; k < 16; k += 4) {
            map.samples[k] = red;
            map.samples[k + 1] = green;
            map.samples[k + 2] = 220;
            map.samples[k + 3] = 255;
        }
        stage.textures.push_back({"map", map, false});
        add_material(stage, glm::vec3(0.8f));
        stage.materials[0].normal_texture = 0;
        place(stage, add_mesh(stage, quad_mesh({-5, 4, -5}, {10, 0, 0}, {0, 0, 10}), 0));
        const Frame frame = frame_of(stage, looking({0, 0, 0}, {0, 4, 0}, 20, 8, 8), {lamp});
        return frame.lights[0][pixel_at(frame, 4, 4)].x;
    };
    const glm::vec3 above(0, 2, 3);
    const glm::vec3 right(3, 2, 0);
    EXPECT_GT(brightness(200, 128, above), 1.1f * brightness(128, 128, above));
    EXPECT_LT(brightness(60, 128, above), 0.9f * brightness(128, 128, above));
    EXPECT_GT(brightness(128, 200, right), 1.1f * brightness(128, 128, right));
}

// Reflected fraction of light from all sides, by midpoint sums over the hemisphere.
glm::vec3 reflected(const shared::Brdf& brdf, float view_deg) {
    const glm::vec3 n(0, 0, 1);
    const glm::vec3 v(std::sin(glm::radians(view_deg)), 0, std::cos(glm::radians(view_deg)));
    glm::dvec3 sum(0);
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const float z = (static_cast<float>(i) + 0.5f) / kSteps;
            const float phi = 2 * shared::kPi * (static_cast<float>(j) + 0.5f) / kSteps;
            const float s = std::sqrt(1 - z * z);
            sum +=
                glm::dvec3(shared::brdf_times_cosine(brdf, n, v, {s * std::cos(phi), s * std::sin(phi), z}));
        }
    return glm::vec3(sum * (2 * static_cast<double>(shared::kPi) / kSteps / kSteps));
}

TEST(KnownAnswers, BrdfKeepsEnergy) {
    EXPECT_NEAR(reflected(shared::brdf_of(glm::vec3(0.7f), 1.0f, 0.0f, 0.0f), 30).x, 0.7f, 1e-3f);
    // Worked out apart from this program, by sampling visible normals (Heitz 2018) in doubles. glTF's own
    // layering gives a little too much at grazing angles; a single GGX lobe, without what it scatters within,
    // too little.
    struct Known {
        float roughness, view_deg, paint, metal, gloss; // of white paint, of white metal, of black paint
    };
    for (const Known& known : {Known{0.3f, 0, 0.9996f, 0.9907f, 0.0396f},
                               {0.3f, 45, 1.0010f, 0.9854f, 0.0427f},
                               {0.3f, 75, 1.1489f, 0.9345f, 0.2010f},
                               {0.6f, 0, 0.9929f, 0.8245f, 0.0330f},
                               {0.6f, 45, 0.9936f, 0.7954f, 0.0353f},
                               {0.6f, 75, 1.0287f, 0.8059f, 0.0807f},
                               {1.0f, 0, 0.9722f, 0.3069f, 0.0123f},
                               {1.0f, 45, 0.9742f, 0.3768f, 0.0159f},
                               {1.0f, 75, 0.9815f, 0.5906f, 0.0336f}}) {
        SCOPED_TRACE(std::to_string(known.roughness) + ", " + std::to_string(known.view_deg) + " degrees");
        const shared::Brdf paint = shared::brdf_of(glm::vec3(1.0f), known.roughness, 0.0f, 1.0f);
        const shared::Brdf metal = shared::brdf_of(glm::vec3(1.0f), known.roughness, 1.0f, 1.0f);
        const shared::Brdf gloss = shared::brdf_of(glm::vec3(0.0f), known.roughness, 0.0f, 1.0f);
        EXPECT_NEAR(reflected(paint, known.view_deg).x, known.paint, 1e-3f);
        EXPECT_NEAR(reflected(metal, known.view_deg).x, known.metal, 1e-3f);
        EXPECT_NEAR(reflected(gloss, known.view_deg).x, known.gloss, 1e-3f);
        // The fit that lights a stage evenly.
        const float nv = std::cos(glm::radians(known.view_deg));
        EXPECT_NEAR(shared::brdf_albedo(paint, nv).x, 1.0f, 1e-6f);
        EXPECT_NEAR(shared::brdf_albedo(gloss, nv).x, known.gloss, 0.035f);
        // In Karis's own formula all but this cancels: up to 0.16 from the integral.
        EXPECT_NEAR(shared::brdf_albedo(metal, nv).x, 1.0f - 0.55f * known.roughness, 1e-5f);
    }
}

} // namespace
} // namespace ghost::bake
