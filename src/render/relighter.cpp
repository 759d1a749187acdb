// SPDX-License-Identifier: Apache-2.0
#include "render/relighter.h"

#include "base/check.h"
#include "shaders/cull.h"
#include "shaders/develop.h"
#include "shaders/meter.h"
#include "shaders/relight.h"
#include "shared/haze.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace ghost::render {
namespace {

constexpr std::uint64_t kImageBytesPerPixel = 8; // four half floats
constexpr float kNoSurface_m = 60.0f;            // length of a ray that leaves the hall

std::uint32_t groups(std::uint32_t items, std::uint32_t size) {
    return (items + size - 1) / size;
}

shared::View make_view(const scene::Passes& passes, const shared::Haze& haze) {
    const glm::mat4& m = passes.camera_to_world;
    const float tan_y = std::tan(passes.fov_y_deg * 0.5f * shared::kPi / 180.0f);
    const float tan_x = tan_y * static_cast<float>(passes.width) / static_cast<float>(passes.height);
    shared::View view{};
    view.eye_m = glm::vec3(m[3]);
    view.width = static_cast<std::uint32_t>(passes.width);
    view.height = static_cast<std::uint32_t>(passes.height);
    view.forward = -glm::vec3(m[2]);
    view.right = glm::vec3(m[0]) * tan_x;
    view.up = glm::vec3(m[1]) * tan_y;
    view.far_m = kNoSurface_m;
    view.haze = haze;
    return view;
}

float distance_m(const glm::vec4& fragment, const glm::vec3& eye_m) {
    return fragment.w < 0 ? kNoSurface_m : glm::length(glm::vec3(fragment) - eye_m);
}

// Farthest fragment of every tile: no light beyond it can be seen there.
std::vector<float> farthest_per_tile(const scene::Passes& passes, std::uint32_t tiles_x,
                                     std::uint32_t tiles_y) {
    const glm::vec3 eye_m(passes.camera_to_world[3]);
    std::vector<float> far(static_cast<std::size_t>(tiles_x) * tiles_y, 0.0f);
    for (int y = 0; y < passes.height; ++y)
        for (int x = 0; x < passes.width; ++x) {
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(passes.width) +
                               static_cast<std::size_t>(x);
            float& tile = far[static_cast<std::size_t>(y) / shared::kTileHeight * tiles_x +
                              static_cast<std::size_t>(x) / shared::kTileWidth];
            tile = std::max(tile, distance_m(passes.fragments[pixel], eye_m));
            for (std::uint32_t k = passes.extra_first[pixel]; k < passes.extra_first[pixel + 1]; ++k)
                tile = std::max(tile, distance_m(passes.fragments[passes.pixel_count() + k], eye_m));
        }
    return far;
}

// The picture without lights: ambient and emission, seen through the haze.
std::vector<std::uint64_t> base_image(const scene::Passes& passes, float ambient_lux,
                                      const shared::Haze& haze) {
    const glm::vec3 eye_m(passes.camera_to_world[3]);
    const auto light_of = [&](std::size_t fragment) {
        glm::vec3 sum(0.0f);
        if (fragment < passes.ambient.size()) sum += glm::vec3(passes.ambient[fragment]) * ambient_lux;
        if (fragment < passes.emission.size()) sum += glm::vec3(passes.emission[fragment]);
        return sum * shared::haze_transmittance(haze, distance_m(passes.fragments[fragment], eye_m));
    };
    std::vector<std::uint64_t> base(passes.pixel_count());
    for (std::size_t pixel = 0; pixel < base.size(); ++pixel) {
        glm::vec3 sum = light_of(pixel);
        for (std::uint32_t k = passes.extra_first[pixel]; k < passes.extra_first[pixel + 1]; ++k)
            sum += light_of(passes.pixel_count() + k);
        base[pixel] =
            glm::packHalf4x16(glm::vec4(glm::min(sum * shared::kImageScale, glm::vec3(65000.0f)), 0.0f));
    }
    return base;
}

} // namespace

int image_slots(std::uint64_t memory_bytes, int width, int height, int light_count) {
    const std::uint64_t image =
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * kImageBytesPerPixel;
    const auto full_tree = static_cast<std::uint64_t>(std::max(2 * light_count - 1, 1));
    return static_cast<int>(std::min(memory_bytes / std::max<std::uint64_t>(image, 1), full_tree));
}

Relighter::Relighter(const gpu::Device& device, const scene::Passes& passes, const shared::Gobos& gobos,
                     int light_count, const Settings& settings)
    : device_(device), settings_(settings), width_(passes.width), height_(passes.height),
      tiles_x_(groups(static_cast<std::uint32_t>(passes.width), shared::kTileWidth)),
      tiles_y_(groups(static_cast<std::uint32_t>(passes.height), shared::kTileHeight)),
      light_count_(light_count),
      tree_(light_count, image_slots(settings.image_memory_bytes, passes.width, passes.height, light_count)),
      cull_(device, shaders::kShader_cull), relight_(device, shaders::kShader_relight),
      meter_(device, shaders::kShader_meter), develop_(device, shaders::kShader_develop),
      gobos_(device, shared::kGoboSize, static_cast<std::uint32_t>(gobos.layers), gobos.texels),
      commands_(device) {
    using gpu::Access;
    using gpu::Buffer;
    const std::uint64_t pixels = passes.pixel_count();
    const auto lights = static_cast<std::uint64_t>(std::max(light_count, 1));
    const std::uint64_t tiles = static_cast<std::uint64_t>(tiles_x_) * tiles_y_;

    const shared::View view = make_view(passes, settings.haze);
    view_ = Buffer(device, sizeof view, Access::device);
    view_.write(&view, sizeof view);
    fragments_ = Buffer(device, passes.fragments.size() * sizeof(glm::vec4), Access::device);
    fragments_.write(std::span(passes.fragments));
    extra_first_ = Buffer(device, passes.extra_first.size() * sizeof(std::uint32_t), Access::device);
    extra_first_.write(std::span(passes.extra_first));
    const std::vector<float> far = farthest_per_tile(passes, tiles_x_, tiles_y_);
    tile_far_ = Buffer(device, far.size() * sizeof(float), Access::device);
    tile_far_.write(std::span(far));
    const std::vector<std::uint64_t> base = base_image(passes, settings.ambient_lux, settings.haze);
    base_ = Buffer(device, pixels * kImageBytesPerPixel, Access::device);
    base_.write(std::span(base));

    std::vector<std::uint64_t> table;
    const std::vector<std::uint64_t> dark(passes.fragment_count(), 0);
    dark_pass_ = Buffer(device, dark.size() * sizeof(std::uint64_t), Access::device);
    dark_pass_.write(std::span(dark));
    for (const scene::LightPass& pass : passes.lights) {
        if (pass.radiance.empty()) {
            table.push_back(dark_pass_.address());
            continue;
        }
        CHECK_EQ(pass.radiance.size(), passes.fragment_count() * 4);
        passes_.emplace_back(device, pass.radiance.size() * sizeof(std::uint16_t), Access::device);
        passes_.back().write(std::span(pass.radiance));
        table.push_back(passes_.back().address());
    }
    table.push_back(dark_pass_.address());
    pass_table_ = Buffer(device, table.size() * sizeof(std::uint64_t), Access::device);
    pass_table_.write(std::span(table));

    lights_ = Buffer(device, lights * sizeof(shared::Light), Access::upload);
    // In one frame every light is listed at most twice (drawn into an image and into the frame), every image
    // added once.
    lists_ = Buffer(device, 2 * lights * sizeof(std::uint32_t), Access::upload);
    addends_ = Buffer(device, (4 * lights + 4) * sizeof(std::uint64_t), Access::upload);
    tile_count_ = Buffer(device, tiles * sizeof(std::uint32_t), Access::device);
    tile_light_ = Buffer(device, tiles * lights * sizeof(std::uint32_t), Access::device);
    frame_ = Buffer(device, pixels * sizeof(glm::vec4), Access::readback);
    pixels_ = Buffer(device, pixels * sizeof(std::uint32_t), Access::readback);
    exposure_ = Buffer(device, sizeof(glm::vec4), Access::readback);
}

Relighter::~Relighter() = default;

FrameStatistics Relighter::draw(const std::vector<shared::Light>& lights) {
    const auto start = std::chrono::steady_clock::now();
    CHECK_EQ(static_cast<int>(lights.size()), light_count_);
    if (!settings_.reuse) {
        tree_.invalidate_all();
        last_lights_.clear();
    }
    std::vector<int> changed;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (i >= last_lights_.size() || std::memcmp(&lights[i], &last_lights_[i], sizeof(shared::Light)) != 0)
            changed.push_back(static_cast<int>(i));
    last_lights_ = lights;

    const Plan plan = tree_.plan(changed);
    FrameStatistics statistics;
    statistics.changed = static_cast<int>(changed.size());
    statistics.drawn = plan.drawn;
    statistics.additions = plan.additions;
    if (!plan.sums.empty()) {
        if (!lights.empty())
            std::memcpy(lights_.mapped(), lights.data(), lights.size() * sizeof(shared::Light));
        list_used_ = 0;
        addends_used_ = 0;
        commands_.begin();
        commands_.bind(gobos_);
        for (const ImageSum& sum : plan.sums) draw_sum(sum);
        develop();
        commands_.submit_and_wait();
        statistics.spans = commands_.spans();
    }
    statistics.draw_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

void Relighter::draw_sum(const ImageSum& sum) {
    auto* list = static_cast<std::uint32_t*>(lists_.mapped()) + list_used_;
    auto* addends = static_cast<std::uint64_t*>(addends_.mapped()) + addends_used_;
    const auto list_count = static_cast<std::uint32_t>(sum.lights.size());
    const bool is_frame = sum.target < 0;

    shared::CullPush cull{};
    cull.view = view_.address();
    cull.lights = lights_.address();
    cull.list = lists_.address() + list_used_ * sizeof(std::uint32_t);
    cull.tile_far = tile_far_.address();
    cull.tile_count = tile_count_.address();
    cull.tile_light = tile_light_.address();
    cull.list_count = list_count;
    cull.tiles_x = tiles_x_;
    cull.tiles_y = tiles_y_;
    CHECK((list_used_ + list_count) * sizeof(std::uint32_t) <= lists_.bytes());
    for (const int light : sum.lights) *list++ = static_cast<std::uint32_t>(light);
    list_used_ += list_count;

    shared::RelightPush relight{};
    relight.view = cull.view;
    relight.lights = cull.lights;
    relight.tile_count = cull.tile_count;
    relight.tile_light = cull.tile_light;
    relight.fragments = fragments_.address();
    relight.extra_first = extra_first_.address();
    relight.passes = pass_table_.address();
    relight.addends = addends_.address() + addends_used_ * sizeof(std::uint64_t);
    relight.frame = frame_.address();
    for (const int slot : sum.addends) *addends++ = images_[static_cast<std::size_t>(slot)].address();
    relight.addend_count = static_cast<std::uint32_t>(sum.addends.size());
    if (is_frame) {
        *addends++ = base_.address();
        ++relight.addend_count;
    } else {
        const auto slot = static_cast<std::size_t>(sum.target);
        if (slot >= images_.size()) images_.resize(slot + 1);
        if (!images_[slot].valid()) {
            const std::uint64_t bytes = static_cast<std::uint64_t>(width_) *
                                        static_cast<std::uint64_t>(height_) * kImageBytesPerPixel;
            images_[slot] = gpu::Buffer(device_, bytes, gpu::Access::device);
            image_bytes_ += bytes;
        }
        relight.image = images_[slot].address();
    }
    addends_used_ += relight.addend_count;
    CHECK(addends_used_ * sizeof(std::uint64_t) <= addends_.bytes());
    relight.list_count = list_count;
    relight.tiles_x = tiles_x_;
    relight.march_steps = static_cast<std::uint32_t>(std::max(settings_.march_steps, 1));
    relight.flags =
        (settings_.surfaces ? shared::kDrawSurfaces : 0u) | (settings_.air ? shared::kDrawHaze : 0u) |
        (settings_.beams == Beams::march ? shared::kMarch : 0u) | (is_frame ? shared::kOutputFloat : 0u);

    commands_.begin_span("cull");
    commands_.dispatch(cull_, cull, groups(tiles_x_ * tiles_y_, 64));
    commands_.barrier();
    commands_.begin_span("relight");
    commands_.dispatch(relight_, relight, tiles_x_, tiles_y_);
    commands_.barrier();
}

void Relighter::develop() {
    const auto pixel_count = static_cast<std::uint32_t>(width_ * height_);
    const shared::MeterPush meter{frame_.address(), exposure_.address(), pixel_count, settings_.ev100,
                                  settings_.auto_exposure ? 1u : 0u};
    commands_.begin_span("meter");
    commands_.dispatch(meter_, meter, 1);
    commands_.barrier();
    const shared::DevelopPush develop{frame_.address(), exposure_.address(), pixels_.address(), pixel_count};
    commands_.begin_span("develop");
    commands_.dispatch(develop_, develop, groups(pixel_count, 256));
}

image::Image8 Relighter::picture() const {
    image::Image8 result(width_, height_, 4);
    std::memcpy(result.samples.data(), pixels_.mapped(), result.samples.size());
    return result;
}

image::ImageF Relighter::frame() const {
    image::ImageF result(width_, height_, 3);
    const auto* from = static_cast<const glm::vec4*>(frame_.mapped());
    for (std::size_t i = 0; i < result.samples.size() / 3; ++i)
        for (int c = 0; c < 3; ++c) result.samples[i * 3 + static_cast<std::size_t>(c)] = from[i][c];
    return result;
}

float Relighter::ev100_used() const {
    return static_cast<const glm::vec4*>(exposure_.mapped())->y;
}

std::uint64_t Relighter::memory_bytes() const {
    std::uint64_t sum = image_bytes_;
    for (const gpu::Buffer& pass : passes_) sum += pass.bytes();
    for (const gpu::Buffer* buffer :
         {&view_, &lights_, &fragments_, &extra_first_, &tile_far_, &base_, &frame_, &exposure_, &pixels_,
          &dark_pass_, &pass_table_, &lists_, &addends_, &tile_count_, &tile_light_})
        sum += buffer->bytes();
    return sum;
}

} // namespace ghost::render
