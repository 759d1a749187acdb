#pragma once
// SPDX-License-Identifier: Apache-2.0
// One stage, its lights and one relighter for many cameras: what the tests of the thesis's list
// (docs/measurements/thesis.md) draw, and the pictures in that document. Pictures are written to the folder
// that GHOST_THESIS_PICTURES names (tools/thesis_pictures.sh) by cases that are disabled, as no tests.

#include "bench/bench_views.h"
#include "image/ldr.h"
#include "reference/reference.h"
#include "support/likeness.h"
#include "support/live_picture.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

namespace ghost::app {

inline constexpr int kNoMaps = 0; // nothing throws shadows

class LiveStage {
public:
    // map_size: of the distance maps, or kNoMaps. Lights get their maps here.
    LiveStage(scene::Stage stage, std::vector<shared::Light> lights, int width, int height,
              const render::Settings& settings, int map_size = kNoMaps)
        : lights_(std::move(lights)), stage_(std::move(stage)), tracer_(stage_),
          model_(device(), stage_, report_), settings_(settings), g_buffer_(device(), width, height) {
        if (map_size != kNoMaps) distances_.emplace(device(), trace_maps(tracer_, lights_, map_size));
        look({{0, -12, 3}, {0, 4, 3}});
        renew(settings, bench_gobos());
    }

    struct Eye {
        glm::vec3 position_m;
        glm::vec3 target_m;
        float fov_y_deg = 40;
    };

    scene::Camera camera_at(const Eye& eye) const {
        scene::Camera camera;
        camera.position_m = eye.position_m;
        camera.target_m = eye.target_m;
        camera.fov_y_deg = eye.fov_y_deg;
        camera.width = static_cast<int>(g_buffer_.fragments().width);
        camera.height = static_cast<int>(g_buffer_.fragments().height);
        return camera;
    }
    void look(const Eye& eye) {
        camera_ = camera_at(eye);
        look(scene::camera_to_world(camera_), eye.fov_y_deg);
    }
    void look(const glm::mat4& camera_to_world, float fov_y_deg) {
        g_buffer_.draw(model_,
                       {camera_to_world, fov_y_deg, static_cast<int>(g_buffer_.fragments().width),
                        static_cast<int>(g_buffer_.fragments().height)},
                       {settings_.ambient, settings_.haze});
        if (relighter_) relighter_->forget();
    }
    // Another relighter over the same stage and camera.
    void renew(const render::Settings& settings, const shared::Gobos& gobos) {
        settings_ = settings;
        gobos_ = gobos;
        relighter_ =
            std::make_unique<render::Relighter>(device(), g_buffer_, distances_ ? &*distances_ : nullptr,
                                                gobos_, static_cast<int>(lights_.size()), settings_);
    }
    image::ImageF draw(const std::vector<shared::Light>& lights) {
        statistics = relighter_->draw(lights);
        EXPECT_EQ(device().validation_errors(), 0u);
        return relighter_->frame();
    }
    image::ImageF draw() { return draw(lights_); }
    // Only one light shines.
    image::ImageF draw_alone(std::size_t light) {
        std::vector<shared::Light> dark = lights_;
        for (std::size_t k = 0; k < dark.size(); ++k)
            if (k != light) dark[k].intensity_cd = glm::vec3(0);
        return draw(dark);
    }
    // By brute force, for the camera of the last look(Eye).
    image::ImageF reference(int air_samples, const bake::HazeDensity& density = {},
                            int lens_samples = 1) const {
        bake::ReferenceOptions options;
        options.lens_samples = lens_samples;
        options.air_samples = air_samples;
        options.surfaces = settings_.surfaces;
        options.air = settings_.air;
        options.shadows = distances_.has_value();
        options.density = density;
        options.attenuation = settings_.air_field.attenuation;
        auto made = bake::reference_picture(&tracer_, camera_, lights_, gobos_, settings_.haze, 0, options);
        EXPECT_TRUE(made.ok()) << made.error().text();
        return made.ok() ? std::move(*made) : image::ImageF();
    }

    std::vector<shared::Light>& lights() { return lights_; }
    render::StageModel& model() { return model_; }
    render::Relighter& relighter() { return *relighter_; }
    const render::Settings& settings() const { return settings_; }
    const bake::Tracer& tracer() const { return tracer_; }

    render::FrameStatistics statistics; // of the last draw

private:
    std::vector<shared::Light> lights_;
    scene::Stage stage_;
    Report report_;
    bake::Tracer tracer_;
    render::StageModel model_;
    render::Settings settings_;
    shared::Gobos gobos_;
    scene::Camera camera_;
    std::optional<render::DistanceImages> distances_;
    render::GBuffer g_buffer_;
    std::unique_ptr<render::Relighter> relighter_;
};

inline const LiveStage::Eye kHouse{{0, -12, 3}, {0, 4, 3}, 30};

// Floor, back wall, two crates and a ball, as far as a small stage.
inline scene::Stage small_stage() {
    scene::Stage stage = empty_stage();
    add_box(stage, {-30, -30, -0.2f}, {30, 6.2f, 0});
    add_box(stage, {-30, 9, 0}, {30, 9.2f, 14});
    add_box(stage, {-2.6f, 2.4f, 0}, {-1.4f, 3.6f, 1});
    add_box(stage, {2.2f, 3.4f, 0}, {3, 4.2f, 1.8f});
    add_ball(stage, {0.4f, 1.2f, 0.6f}, 0.6f);
    return stage;
}

inline render::Settings haze_only() {
    render::Settings settings = bench_settings();
    settings.surfaces = false;
    return settings;
}

inline double mean_of(const image::ImageF& picture) {
    double sum = 0;
    for (const float value : picture.samples) sum += static_cast<double>(value);
    return sum / static_cast<double>(picture.samples.size());
}

inline std::size_t non_finite_of(const image::ImageF& picture) {
    std::size_t count = 0;
    for (const float value : picture.samples) count += std::isfinite(value) ? 0 : 1;
    return count;
}

// Where pictures for docs/measurements/thesis.md go; nothing in an ordinary run.
inline std::optional<std::filesystem::path> picture_folder() {
    const char* folder = std::getenv("GHOST_THESIS_PICTURES");
    return folder ? std::optional<std::filesystem::path>(folder) : std::nullopt;
}

inline constexpr int kPictureWidth = 512;
inline constexpr int kPictureHeight = 288;

// As the free camera shows it: lenses and glare.
inline render::Settings picture_settings(float ev100) {
    render::Settings settings = bench_settings();
    settings.ambient = glm::vec3(1.5f);
    settings.lens.on = true;
    settings.glare.strength = 0.05f;
    settings.ev100 = ev100;
    return settings;
}

// Pictures of one size beside and below each other, with thin lines between them.
inline image::Image8 panels(const std::vector<image::Image8>& pictures, int columns) {
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    const int width = pictures[0].width, height = pictures[0].height;
    image::Image8 sheet(width * columns, height * rows, 4);
    std::fill(sheet.samples.begin(), sheet.samples.end(), std::uint8_t{255});
    for (int k = 0; k < static_cast<int>(pictures.size()); ++k)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int column = k % columns, row = k / columns;
                const bool line = (column > 0 && x == 0) || (row > 0 && y == 0);
                std::uint8_t* to = sheet.at(column * width + x, row * height + y);
                for (int c = 0; c < 3; ++c)
                    to[c] = line ? std::uint8_t{128} : pictures[static_cast<std::size_t>(k)].at(x, y)[c];
            }
    return sheet;
}

inline void write_picture(const std::string& name, const image::Image8& picture) {
    const auto written = image::write_png(*picture_folder() / (name + ".png"), picture);
    EXPECT_TRUE(written.ok()) << written.error().text();
}

} // namespace ghost::app
