// SPDX-License-Identifier: Apache-2.0
#include "render/haze/haze_pass.h"

#include "base/check.h"
#include "render/haze/fan.h"
#include "render/haze/private/haze_grid.h"
#include "shaders/fan.h"
#include "shaders/fan_shade.h"
#include "shaders/gate.h"
#include "shaders/haze.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ghost::render {
namespace {

constexpr std::uint64_t kAlign = 256; // offset of a uniform buffer, at most, on every device
constexpr std::uint64_t kChunkBytes = shared::kLightsPerChunk * sizeof(shared::Fan);
constexpr std::uint32_t kRowsPerGroup = 16; // fan.comp
// While things move shades are coarse from here on, and where light is coarse: else that costs 3 dB of 47.
constexpr std::size_t kManyTables = 24;
constexpr std::uint64_t kFanBytes = std::uint64_t{6} << 20;      // tables and grid
constexpr std::uint64_t kBatchFanBytes = std::uint64_t{4} << 20; // tables alone
// From here on shaped beams have plain tables: many lie over each other.
constexpr std::uint32_t kManyLights = 100;
constexpr std::uint32_t kOfPlaces = 2; // kFocus of gate.comp, for shaped beams

// Rows of all levels; of no light in particular: at most.
std::uint32_t rows_of(const shared::Fan& fan, bool shaped) {
    if (fan.levels == 0) return shaped ? shared::kFanNodes * shared::kFinestNode : shared::kFanWidth;
    if (!shaped) return shared::fan_left(fan, fan.levels);
    std::uint32_t rows = 0;
    for (std::uint32_t k = 0; k < fan.levels; ++k) rows += shared::fan_node_side(fan.place[k]);
    return rows;
}

std::uint32_t tables_that_fit(const gpu::Device& device, std::uint32_t wanted, bool single) {
    const std::uint64_t room =
        single ? share_of(Kept::tables, device) / kFanBytes : share_of(Kept::batch, device) / kBatchFanBytes;
    return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(room, 1, wanted));
}

// A bit more than half a texel of a distance map: what the edge of a shadow may be off. A whole texel costs
// 0.1 % of the haze before a floor, nothing doubles the time.
float shade_doubt_rad(std::uint32_t map_side) {
    return 0.6f * std::sqrt(4 * shared::kPi) / static_cast<float>(map_side);
}

} // namespace

std::uint64_t fan_room(std::uint32_t lights) {
    return (lights * sizeof(shared::Fan) + kAlign - 1) / kAlign * kAlign;
}

// As many chunks as the relighter may draw in a frame (LightPainter).
std::uint64_t fan_buffer_bytes(std::uint32_t light_count) {
    return (kMostDraws * std::uint64_t{light_count} + shared::kBeamClasses) * fan_room(1) + kChunkBytes;
}

HazePass::HazePass(const gpu::Device& device, const HazeIntegrator& settings, const Fragments& fragments,
                   std::uint32_t batch_size, std::uint32_t light_count, const DistanceImages* distances,
                   FanDetail detail, std::uint32_t most_kept)
    : settings_(settings), batch_size_(batch_size),
      wanted_tables_(std::clamp(light_count, 1u, batch_size == 1 ? most_kept : batch_size)),
      tables_(settings.beams == Beams::gate ? tables_that_fit(device, wanted_tables_, batch_size == 1)
                                            : wanted_tables_),
      distances_(distances), detail_(light_count < kManyLights ? detail : FanDetail::plain) {
    const std::uint32_t single = batch_size == 1 ? 1 : 0;
    if (settings.beams != Beams::gate) {
        for (std::uint32_t kind = 0; kind < shared::kBeamClasses; ++kind) {
            samples_[kind] = gpu::LateProgram(device, shaders::kShader_haze,
                                              std::vector{kind, single, settings.uneven ? 1u : 0u});
            if (kind < shared::kPlanesClass) (void)samples_[kind].get();
            if (shared::may_be_of_wheels(kind)) samples_[kind].expect();
        }
        return;
    }
    for (std::uint32_t kind = 0; kind < shared::kBeamClasses; ++kind) {
        fill_[kind] = gpu::LateProgram(device, shaders::kShader_fan, std::vector{kind, single});
        if (kind < shared::kPlanesClass) (void)fill_[kind].get();
        if (shared::may_be_of_wheels(kind)) fill_[kind].expect();
    }
    for (std::uint32_t focus = 0; focus < gate_.size(); ++focus) {
        const auto gate = [&](bool wide, bool thin, bool panels) {
            return gpu::LateProgram(device, shaders::kShader_gate,
                                    std::vector{focus, single, distances ? 1u : 0u, settings.uneven ? 1u : 0u,
                                                wide ? 1u : 0u, thin ? 1u : 0u, panels ? 1u : 0u});
        };
        gate_[focus] = gate(false, false, false);
        thin_gate_[focus] = gate(false, true, false);
        if (focus == 0) panel_gate_ = gate(false, false, true);
        if (focus == 0 && settings.most_wide_step > 1) wide_panel_gate_ = gate(true, false, true);
        if (settings.most_wide_step > 1) wide_gate_[focus] = gate(true, false, false);
        gate_[focus].expect();
        if (focus == kOfPlaces) continue;
        (void)gate_[focus].get();
        if (settings.most_wide_step > 1) (void)wide_gate_[focus].get();
    }
    if (settings.grid && batch_size == 1)
        grid_ = std::make_unique<GridPass>(device, fragments.width, fragments.height, tables_,
                                           distances != nullptr, settings.uneven);
    no_rays_ = gpu::Texture(device, {1, 1, 1, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    no_lonely_ = gpu::Texture(device, {1, 1, 1, 1, VK_FORMAT_R16_UINT, true, false});
    if (distances)
        shade_fill_ =
            std::make_unique<gpu::Program>(device, shaders::kShader_fan_shade, std::vector{0u, single});
    fans_ = gpu::Buffer(device, fan_buffer_bytes(light_count), gpu::Access::upload);
    if (batch_size == 1) filled_.resize(tables_);
    // Sums in 0..1: 16 bits are enough, half floats are not (3 % in the narrowest segments).
    constexpr std::array kFormats{VK_FORMAT_R16G16B16A16_UNORM, VK_FORMAT_R32G32B32A32_SFLOAT};
    const VkFormat format = device.first_format(
        kFormats, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT);
    table_ = gpu::Texture(device, {shared::kFanWidth, shared::kFinestFan, tables_, 1, format, true, true});
    shade_ = gpu::Texture(device, {2 * shared::kFinestShade, 2 * shared::kFinestShade,
                                   distances ? tables_ : 1, 1, VK_FORMAT_R32G32_SFLOAT, true, false});
    // Filtering may touch, with no weight, texels that no fan has filled.
    gpu::Commands commands(device);
    commands.begin();
    commands.clear(table_);
    commands.submit_and_wait();
}

void HazePass::set_quality(const HazeQuality& quality) {
    settings_.curvature = quality.curvature;
    settings_.most_segments = quality.most_segments;
    uses_grid_ = quality.grid;
}

void HazePass::reset() {
    forget();
    uses_ = 0;
    is_clean_ = false;
}

void HazePass::record(gpu::Commands& commands, const LightChunk& chunk) {
    if (!is_clean_ && settings_.beams == Beams::gate) {
        commands.clear(table_);
        commands.clear(shade_);
    }
    is_clean_ = true;
    if (settings_.beams == Beams::gate)
        record_gate(commands, chunk);
    else
        record_samples(commands, chunk);
}

void HazePass::record_samples(gpu::Commands& commands, const LightChunk& chunk) {
    const std::uint32_t march_steps =
        settings_.beams == Beams::march ? static_cast<std::uint32_t>(std::max(settings_.march_steps, 1)) : 0u;
    shared::RelightPush push{
        chunk.count(), 0, chunk.fragments.tiles_x, chunk.tiles(), chunk.fragments.blocks, march_steps, 0, 0};
    commands.begin_span("haze");
    for (push.batch = 0; push.batch < chunk.batches(); ++push.batch) {
        commands.dispatch_indirect(
            samples_[chunk.beam_class].get(), push,
            shaders::HazeBindings{.gobo_stack = gpu::sampled(chunk.gobos),
                                  .view = gpu::uniform(chunk.fragments.view),
                                  .lights = gpu::uniform(chunk.light_buffer, chunk.light_offset),
                                  .masks = gpu::storage(chunk.masks),
                                  .lists = gpu::storage(chunk.lists),
                                  .fragments = gpu::stored(chunk.fragments.places),
                                  .drawn = gpu::stored(chunk.drawn),
                                  .air = gpu::uniform(chunk.air),
                                  .slides = gpu::sampled(chunk.slides)},
            chunk.groups, chunk.haze_groups(push.batch));
        commands.barrier();
    }
}

// The next picture is seen from elsewhere, or by other light.
bool HazePass::is_of_moment() const {
    return flies_ || uses_grid_;
}

ShadeDetail HazePass::shade_detail() const {
    if (!is_of_moment()) return ShadeDetail::full;
    const bool many = filled_.size() >= kManyTables;
    return flies_ || many || detail_ == FanDetail::plain ? ShadeDetail::coarse : ShadeDetail::seen;
}

std::pair<std::uint32_t, bool> HazePass::layer_for(const shared::Light& light, const shared::Fan& fan) {
    shared::Light weightless = light;
    weightless.intensity_cd = weightless.bounce_cd = glm::vec3(0.0f);
    std::size_t oldest = 0;
    for (std::size_t k = 0; k < filled_.size(); ++k) {
        Filled& filled = filled_[k];
        if (filled.used > 0 && std::memcmp(&filled.light, &weightless, sizeof weightless) == 0 &&
            std::memcmp(&filled.fan, &fan, sizeof fan) == 0) {
            filled.used = ++uses_;
            return {static_cast<std::uint32_t>(k), false};
        }
        if (filled.used < filled_[oldest].used) oldest = k;
    }
    filled_[oldest] = {weightless, fan, {}, ++uses_};
    return {static_cast<std::uint32_t>(oldest), true};
}

float HazePass::reach_m(const shared::Light& light, const Fragments& fragments) const {
    return distances_ ? distances_->reach_m(light) : reach_in(fragments.seen, light);
}

void HazePass::record_gate(gpu::Commands& commands, const LightChunk& chunk) {
    CHECK(fans_used_ + kChunkBytes <= fans_.bytes());
    const std::uint64_t offset = fans_used_;
    auto* fans = reinterpret_cast<shared::Fan*>(static_cast<std::uint8_t*>(fans_.mapped()) + offset);
    const bool shaped = shared::is_shaped(chunk.beam_class);
    bool focus = false;
    bool thin = false;
    std::vector<bool> fills; // of single lights
    for (std::uint32_t k = 0; k < chunk.count(); ++k) {
        const shared::Light& light = chunk.lights[k];
        shared::Fan fan = make_fan(
            light, chunk.fragments.eye_m, chunk.fragments.pixels_per_rad, reach_m(light, chunk.fragments),
            is_of_moment() ? FanDetail::plain : detail_, k % batch_size_, shade_detail());
        if (!filled_.empty()) {
            fan.layer = 0;
            const auto [layer, is_new] = layer_for(light, fan);
            fan.layer = layer;
            fills.push_back(is_new);
        }
        focus = focus || fan.levels > 1;
        thin = thin || fan.thin != 0;
        std::memcpy(fans + k, &fan, sizeof fan);
    }
    fans_used_ += fan_room(chunk.count());

    const float segments_per_rad = 1.0f / std::sqrt(settings_.curvature);
    const float shade_rad = distances_ ? shade_doubt_rad(distances_->side()) : 0.0f;
    shared::GatePush push{chunk.count(),
                          0,
                          chunk.fragments.tiles_x,
                          chunk.tiles(),
                          chunk.fragments.blocks,
                          segments_per_rad,
                          static_cast<std::uint32_t>(settings_.most_segments),
                          shade_rad,
                          chunk.wide ? chunk.wide->step() : 1};
    for (push.batch = 0; push.batch < chunk.batches(); ++push.batch) {
        const std::uint32_t first = push.batch * batch_size_;
        const std::uint32_t lights = std::min(batch_size_, chunk.count() - first);
        const std::uint32_t rows = rows_of(batch_size_ == 1 ? fans[first] : shared::Fan{}, shaped);
        const std::uint32_t shade_rows =
            batch_size_ == 1 ? shared::fan_shade_rows(fans[first]) : 2 * shared::kFinestShade;
        const bool fill = fills.empty() || fills[first];
        commands.begin_span("fan");
        if (fill)
            commands.dispatch(
                fill_[chunk.beam_class].get(), shared::FanPush{first},
                shaders::FanBindings{.gobo_stack = gpu::sampled(chunk.gobos),
                                     .lights = gpu::uniform(chunk.light_buffer, chunk.light_offset),
                                     .fans = gpu::uniform(fans_, offset),
                                     .table = gpu::stored(table_),
                                     .slides = gpu::sampled(chunk.slides)},
                (rows + kRowsPerGroup - 1) / kRowsPerGroup, lights);
        if (distances_ && fill)
            commands.dispatch(
                *shade_fill_, shared::FanPush{first},
                shaders::FanShadeBindings{.lights = gpu::uniform(chunk.light_buffer, chunk.light_offset),
                                          .fans = gpu::uniform(fans_, offset),
                                          .shade = gpu::stored(shade_),
                                          .distance_maps = gpu::sampled(distances_->texture())},
                shade_rows / kRowsPerGroup, lights);
        commands.barrier();
        const std::uint32_t kind = shaped ? kOfPlaces : (focus ? 1u : 0u);
        if (record_grid(commands, chunk, push, fans[first], kind, offset)) continue;
        commands.begin_span("gate");
        gpu::LateProgram& open = (chunk.wide ? wide_gate_ : (thin ? thin_gate_ : gate_))[kind];
        gpu::LateProgram& panels = chunk.wide ? wide_panel_gate_ : panel_gate_;
        commands.dispatch_indirect(
            (chunk.beam_class == shared::kPanelClass ? panels : open).get(), push,
            shaders::GateBindings{.view = gpu::uniform(chunk.fragments.view),
                                  .lights = gpu::uniform(chunk.light_buffer, chunk.light_offset),
                                  .fans = gpu::uniform(fans_, offset),
                                  .masks = gpu::storage(chunk.masks),
                                  .lists = gpu::storage(chunk.lists),
                                  .places = gpu::stored(chunk.fragments.places),
                                  .drawn = gpu::stored(chunk.drawn),
                                  .table = gpu::sampled(table_),
                                  .shade = gpu::sampled(shade_),
                                  .air = gpu::uniform(chunk.air),
                                  .lonely = gpu::stored(chunk.wide ? chunk.wide->lonely() : no_lonely_),
                                  .rays = gpu::stored(chunk.wide ? chunk.wide->rays() : no_rays_)},
            chunk.groups, chunk.haze_groups(push.batch));
        commands.barrier();
    }
}

bool HazePass::record_grid(gpu::Commands& commands, const LightChunk& chunk, const shared::GatePush& push,
                           const shared::Fan& fan, std::uint32_t focus, std::uint64_t fans_offset) {
    if (!grid_ || !uses_grid_ || chunk.wide || fan.thin != 0 || chunk.beam_class == shared::kPanelClass)
        return false;
    const Fragments& f = chunk.fragments;
    const shared::Light& light = chunk.lights[push.batch];
    const auto grid = make_grid(light, fan, f.camera, f.pixels_per_rad, reach_m(light, f));
    if (!grid) return false;
    // Surfaces that moved since it was filled end rays elsewhere, which the look-up finds out.
    Filled& filled = filled_[fan.layer];
    const bool fill = std::memcmp(&filled.grid, &*grid, sizeof *grid) != 0;
    filled.grid = *grid;
    grid_->record(commands, chunk, {push, *grid, shared::kGridLayers * fan.layer}, fill, focus,
                  {fans_, fans_offset, table_, shade_});
    return true;
}

} // namespace ghost::render
