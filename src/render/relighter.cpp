// SPDX-License-Identifier: Apache-2.0
#include "render/relighter.h"

#include "base/check.h"
#include "render/layout.h"
#include "shaders/bounce.h"
#include "shaders/cull.h"
#include "shaders/develop.h"
#include "shaders/fold.h"
#include "shaders/haze.h"
#include "shaders/meter.h"
#include "shaders/sum.h"
#include "shaders/surface.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace ghost::render {
namespace {

constexpr std::uint64_t kImageBytesPerPixel = 8; // four half floats
constexpr std::uint64_t kChunkAlign = 256;       // offset of a uniform buffer, at most, on every device
constexpr std::uint64_t kChunkBytes = shared::kLightsPerChunk * sizeof(shared::Light);
constexpr VkDescriptorType kUniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType kStorage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType kSampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType kStored = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
constexpr std::uint64_t kMaxLayers = 2048; // of an image, on every device

std::uint32_t groups(std::uint32_t items, std::uint32_t size) {
    return (items + size - 1) / size;
}

std::uint32_t batch_size(const gpu::Device& device, const Settings& settings) {
    if (settings.lights_per_dispatch > 0)
        return settings.lights_per_dispatch == 1 ? 1 : shared::kLightsPerChunk;
    return device.is_cpu() ? 1 : shared::kLightsPerChunk;
}

} // namespace

int image_slots(std::uint64_t memory_bytes, int width, int height, int light_count) {
    const std::uint64_t image =
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * kImageBytesPerPixel;
    const auto full_tree = static_cast<std::uint64_t>(std::max(2 * light_count - 1, 1));
    return static_cast<int>(
        std::min({memory_bytes / std::max<std::uint64_t>(image, 1), full_tree, kMaxLayers - 2}));
}

Relighter::Relighter(const gpu::Device& device, const scene::Passes& passes, const shared::Gobos& gobos,
                     int light_count, const Settings& settings)
    : device_(device), settings_(settings), width_(static_cast<std::uint32_t>(passes.width)),
      height_(static_cast<std::uint32_t>(passes.height)), tiles_x_(groups(width_, shared::kTileWidth)),
      tiles_y_(groups(height_, shared::kTileHeight)), batch_size_(batch_size(device, settings)),
      light_count_(light_count),
      slot_count_(image_slots(settings.image_memory_bytes, passes.width, passes.height, light_count)),
      tree_(light_count, slot_count_),
      cull_(device, shaders::kShader_cull, {kUniform, kUniform, kStorage, kStorage, kStorage, kStorage}),
      sum_(device, shaders::kShader_sum, {kStored, kStored, kStored}),
      bounce_(device, shaders::kShader_bounce, {kUniform, kUniform, kStored, kStored, kStored}),
      fold_(device, shaders::kShader_fold, {kUniform, kSampled, kStored}),
      meter_(device, shaders::kShader_meter, {kStored, kStorage}),
      develop_(device, shaders::kShader_develop, {kStored, kUniform, kStored}), commands_(device) {
    using gpu::Access;
    using gpu::Buffer;
    using gpu::Texture;
    const std::uint32_t single = batch_size_ == 1 ? 1 : 0;
    for (std::uint32_t wheels = 0; wheels < kClasses; ++wheels) {
        surface_[wheels] = std::make_unique<gpu::Program>(
            device, shaders::kShader_surface,
            std::vector{kSampled, kUniform, kUniform, kStorage, kStorage, kStored, kStored, kStored},
            std::vector{wheels, single});
        haze_[wheels] = std::make_unique<gpu::Program>(
            device, shaders::kShader_haze,
            std::vector{kSampled, kUniform, kUniform, kStorage, kStorage, kStored, kStored},
            std::vector{wheels, single});
    }
    // In one frame every light is drawn at most twice, into an image to keep and into the frame; each draw
    // begins a chunk.
    const std::uint64_t draws = 2 * static_cast<std::uint64_t>(light_count) + kClasses;
    lights_ = Buffer(device, draws * kChunkAlign + kChunkBytes, Access::upload);
    const std::uint64_t batches =
        batch_size_ == 1 ? std::min<std::uint64_t>(shared::kLightsPerChunk, draws) : 1;
    groups_ = Buffer(device, batches * sizeof(shared::TileGroups), Access::device);
    exposure_ = Buffer(device, sizeof(glm::vec4), Access::readback);
    pixels_ = Buffer(device, passes.pixel_count() * 4, Access::readback);
    // Layer 0 is the frame, the others are the slots of the tree and its image of all that rests.
    images_ = Texture(device, {width_, height_, static_cast<std::uint32_t>(slot_count_) + 2, 1,
                               VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    picture_ = Texture(device, {width_, height_, 1, 1, VK_FORMAT_R8G8B8A8_UNORM, true, false});
    upload(passes, gobos, batches);
    upload_bounces(passes);
}

Relighter::~Relighter() = default;

void Relighter::upload(const scene::Passes& passes, const shared::Gobos& gobos, std::uint64_t batches) {
    using gpu::Access;
    using gpu::Buffer;
    using gpu::Texture;
    const shared::View view = make_view(passes, settings_.haze);
    view_ = Buffer(device_, sizeof view, Access::device);
    view_.write(&view, sizeof view);
    const Layout layout = make_layout(passes, tiles_x_, tiles_y_);
    blocks_ = layout.blocks;
    edge_count_ = static_cast<std::uint32_t>(layout.edges.size());
    tile_bounds_ = Buffer(device_, layout.bounds.size() * sizeof(glm::vec4), Access::device);
    tile_bounds_.write(layout.bounds);
    const std::uint64_t tiles = static_cast<std::uint64_t>(tiles_x_) * tiles_y_;
    masks_ =
        Buffer(device_, 2 * (tiles + blocks_) * shared::kMaskWords * sizeof(std::uint32_t), Access::device);
    lists_ = Buffer(device_, batches * (2 * tiles + blocks_) * sizeof(std::uint32_t), Access::device);
    const std::vector<glm::vec4> base = base_image(passes, settings_.ambient_lux, settings_.haze);
    base_ = Texture(device_, {width_, height_, 1, 1, VK_FORMAT_R32G32B32A32_SFLOAT, true, false});
    base_.write(0, base.data(), base.size() * sizeof(glm::vec4));
    std::vector<glm::uvec2> edges = layout.edges;
    const std::uint32_t edge_rows = std::max(groups(edge_count_, width_), 1u);
    edges.resize(static_cast<std::size_t>(edge_rows) * width_);
    edges_ = Texture(device_, {width_, edge_rows, 1, 1, VK_FORMAT_R32G32_UINT});
    edges_.write(0, edges.data(), edges.size() * sizeof(glm::uvec2));

    gobos_ = Texture(device_, {shared::kGoboSize, shared::kGoboSize, static_cast<std::uint32_t>(gobos.layers),
                               shared::kGoboLevels, VK_FORMAT_R8G8B8A8_UNORM, false, true});
    for (std::uint32_t level = 0; level < shared::kGoboLevels; ++level)
        gobos_.write(level, gobos.texels[level].data(), gobos.texels[level].size());

    // Whole blocks, so that the last one needs no bound; what no fragment fills is no surface.
    const std::uint32_t rows = height_ + groups(blocks_ * shared::kTilePixels, width_);
    const std::size_t places = static_cast<std::size_t>(rows) * width_;
    std::vector<glm::vec4> fragments(places, glm::vec4(0, 0, 0, -1));
    for (std::size_t i = 0; i < layout.order.size(); ++i) fragments[i] = passes.fragments[layout.order[i]];
    fragments_ = Texture(device_, {width_, rows, 1, 1, VK_FORMAT_R32G32B32A32_SFLOAT, true, false});
    fragments_.write(0, fragments.data(), fragments.size() * sizeof(glm::vec4));
    drawn_ = Texture(device_, {width_, rows, 2, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    const auto layers = static_cast<std::uint32_t>(passes.lights.size()) + 1; // the last one is dark
    passes_ = Texture(device_, {width_, rows, layers, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    std::vector<std::uint64_t> radiance(places); // four half floats each
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        std::fill(radiance.begin(), radiance.end(), std::uint64_t{0});
        if (layer + 1 < layers && !passes.lights[layer].radiance.empty()) {
            const std::vector<std::uint16_t>& from = passes.lights[layer].radiance;
            CHECK_EQ(from.size(), passes.fragment_count() * 4);
            for (std::size_t i = 0; i < layout.order.size(); ++i)
                std::memcpy(&radiance[i], &from[std::size_t{4} * layout.order[i]], sizeof radiance[i]);
        }
        passes_.write_layer(layer, radiance.data(), radiance.size() * sizeof(std::uint64_t));
    }
}

void Relighter::upload_bounces(const scene::Passes& passes) {
    const bool any = std::any_of(passes.lights.begin(), passes.lights.end(),
                                 [](const scene::LightPass& pass) { return !pass.indirect.empty(); });
    if (!any) return;
    const auto layers = static_cast<std::uint32_t>(passes.lights.size()) + 1;
    bounces_ =
        gpu::Texture(device_, {width_, height_, layers, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    const std::vector<std::uint16_t> none(passes.pixel_count() * 4, 0);
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        const bool has = layer + 1 < layers && !passes.lights[layer].indirect.empty();
        const std::vector<std::uint16_t>& from = has ? passes.lights[layer].indirect : none;
        CHECK_EQ(from.size(), none.size());
        bounces_.write_layer(layer, from.data(), from.size() * sizeof(std::uint16_t));
    }
}

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
        lights_used_ = 0;
        commands_.begin();
        for (const ImageSum& sum : plan.sums) draw_sum(sum, lights);
        develop();
        commands_.submit_and_wait();
        statistics.spans = commands_.spans();
    }
    statistics.draw_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

void Relighter::draw_sum(const ImageSum& sum, const std::vector<shared::Light>& lights) {
    if (!sum.lights.empty()) {
        commands_.begin_span("clear");
        commands_.clear(drawn_);
    }
    // Lights with the same number of gobo wheels share a shader that has just these.
    for (std::uint32_t wheels = 0; wheels < kClasses; ++wheels) {
        std::vector<shared::Light> chunk;
        for (const int index : sum.lights) {
            const shared::Light& light = lights[static_cast<std::size_t>(index)];
            if (light.wheel_count != wheels) continue;
            chunk.push_back(light);
            if (chunk.size() == shared::kLightsPerChunk) {
                draw_lights(chunk, wheels);
                chunk.clear();
            }
        }
        if (!chunk.empty()) draw_lights(chunk, wheels);
    }
    if (!sum.lights.empty() && settings_.surfaces && edge_count_ > 0) {
        commands_.begin_span("fold");
        commands_.dispatch(fold_, shared::FoldPush{edge_count_},
                           {gpu::uniform(view_), gpu::sampled(edges_), gpu::stored(drawn_)},
                           groups(edge_count_, 64));
        commands_.barrier();
    }
    std::size_t added = 0;
    for (bool first = true; first || added < sum.addends.size(); first = false) {
        shared::SumPush push{};
        push.target = static_cast<std::uint32_t>(sum.target + 1);
        push.accumulate = first ? 0u : 1u;
        push.add_base = first && sum.base ? 1u : 0u;
        push.add_drawn = first && !sum.lights.empty() ? 1u : 0u;
        for (; added < sum.addends.size() && push.addend_count < shared::kMaxAddends; ++added)
            push.addend[push.addend_count++] = static_cast<std::uint32_t>(sum.addends[added] + 1);
        commands_.begin_span("add");
        commands_.dispatch(sum_, push, {gpu::stored(base_), gpu::stored(drawn_), gpu::stored(images_)},
                           groups(width_, shared::kTileWidth), groups(height_, shared::kTileHeight));
        commands_.barrier();
    }
}

void Relighter::draw_lights(const std::vector<shared::Light>& lights, std::uint32_t wheels) {
    const std::uint64_t offset = lights_used_;
    const std::uint64_t bytes = lights.size() * sizeof(shared::Light);
    CHECK(offset + kChunkBytes <= lights_.bytes());
    std::memcpy(static_cast<std::uint8_t*>(lights_.mapped()) + offset, lights.data(), bytes);
    lights_used_ += (bytes + kChunkAlign - 1) / kChunkAlign * kChunkAlign;

    const auto count = static_cast<std::uint32_t>(lights.size());
    const std::uint32_t batches = groups(count, batch_size_);
    const std::uint32_t tiles = tiles_x_ * tiles_y_;
    const shared::CullPush cull{
        count, batch_size_, tiles_x_, tiles, blocks_, settings_.surfaces ? 1u : 0u, settings_.air ? 1u : 0u};
    commands_.begin_span("cull");
    commands_.write(groups_, std::vector<shared::TileGroups>(batches, {{0, 1, 1, 0}, {0, 1, 1, 0}}));
    commands_.dispatch(cull_, cull,
                       {gpu::uniform(view_), gpu::uniform(lights_, offset), gpu::storage(tile_bounds_),
                        gpu::storage(masks_), gpu::storage(groups_), gpu::storage(lists_)},
                       groups(tiles + blocks_, 64), batches);
    commands_.barrier();
    const std::uint32_t march_steps =
        settings_.beams == Beams::march ? static_cast<std::uint32_t>(std::max(settings_.march_steps, 1)) : 0u;
    const std::vector<gpu::Binding> air{
        gpu::sampled(gobos_), gpu::uniform(view_),  gpu::uniform(lights_, offset),
        gpu::storage(masks_), gpu::storage(lists_), gpu::stored(fragments_),
        gpu::stored(drawn_)};
    std::vector<gpu::Binding> surfaces = air;
    surfaces.push_back(gpu::stored(passes_));
    shared::RelightPush push{count, 0, tiles_x_, tiles, blocks_, march_steps};
    if (settings_.air) commands_.begin_span("haze");
    for (push.batch = 0; settings_.air && push.batch < batches; ++push.batch) {
        commands_.dispatch_indirect(*haze_[wheels], push, air, groups_,
                                    push.batch * sizeof(shared::TileGroups) +
                                        offsetof(shared::TileGroups, haze));
        commands_.barrier();
    }
    if (settings_.surfaces && bounces_.bytes() > 0) {
        commands_.begin_span("bounces");
        commands_.dispatch(bounce_, shared::BouncePush{count},
                           {gpu::uniform(view_), gpu::uniform(lights_, offset), gpu::stored(fragments_),
                            gpu::stored(bounces_), gpu::stored(drawn_)},
                           tiles_x_, tiles_y_);
        commands_.barrier();
    }
    if (settings_.surfaces) commands_.begin_span("surfaces");
    for (push.batch = 0; settings_.surfaces && push.batch < batches; ++push.batch) {
        commands_.dispatch_indirect(*surface_[wheels], push, surfaces, groups_,
                                    push.batch * sizeof(shared::TileGroups) +
                                        offsetof(shared::TileGroups, surface));
        commands_.barrier();
    }
}

void Relighter::develop() {
    const shared::MeterPush meter{width_, height_, settings_.ev100, settings_.auto_exposure ? 1u : 0u};
    commands_.begin_span("meter");
    commands_.dispatch(meter_, meter, {gpu::stored(images_), gpu::storage(exposure_)}, 1);
    commands_.barrier();
    commands_.begin_span("develop");
    commands_.dispatch(develop_, std::uint32_t{0},
                       {gpu::stored(images_), gpu::uniform(exposure_), gpu::stored(picture_)},
                       groups(width_, 16), groups(height_, 8));
    commands_.barrier();
    commands_.begin_span("read back");
    commands_.copy(picture_, pixels_);
}

image::Image8 Relighter::picture() const {
    image::Image8 result(width(), height(), 4);
    std::memcpy(result.samples.data(), pixels_.mapped(), result.samples.size());
    return result;
}

image::ImageF Relighter::frame() const {
    image::ImageF result(width(), height(), 3);
    const gpu::Buffer buffer(device_, static_cast<std::uint64_t>(width_) * height_ * kImageBytesPerPixel,
                             gpu::Access::readback);
    commands_.begin();
    commands_.copy(images_, buffer);
    commands_.submit_and_wait();
    const auto* halves = static_cast<const std::uint16_t*>(buffer.mapped());
    for (std::size_t i = 0; i < result.samples.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            result.samples[i * 3 + c] = glm::unpackHalf1x16(halves[i * 4 + c]);
    return result;
}

float Relighter::ev100_used() const {
    return static_cast<const glm::vec4*>(exposure_.mapped())->y;
}

std::uint64_t Relighter::memory_bytes() const {
    std::uint64_t sum = 0;
    for (const gpu::Buffer* buffer :
         {&view_, &lights_, &tile_bounds_, &masks_, &lists_, &groups_, &exposure_, &pixels_})
        sum += buffer->bytes();
    for (const gpu::Texture* texture :
         {&gobos_, &passes_, &fragments_, &edges_, &base_, &images_, &bounces_, &drawn_, &picture_})
        sum += texture->bytes();
    return sum;
}

} // namespace ghost::render
