// SPDX-License-Identifier: Apache-2.0
// The part of Relighter that draws lights: a sum of the tree, its lights by chunks, their surfaces.
#include "base/check.h"
#include "render/relight/relighter.h"
#include "shaders/bounce.h"
#include "shaders/clear_tiles.h"
#include "shaders/cull.h"
#include "shaders/fold.h"
#include "shaders/silhouettes.h"
#include "shaders/sum.h"
#include "shaders/surface.h"
#include "shaders/surface_live.h"
#include "shaders/visibility.h"
#include "shared/figure.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace ghost::render {
namespace {

// Units of visibility that are made in a frame (shared/visibility.h), each 0.1 ms of two slow cores: a part
// of all there are, so that a picture of a new size is not late and has them soon.
constexpr std::uint32_t kLeastMade = 256, kPartMade = 8;
constexpr std::uint32_t kGroupsAcross = 1024; // of a dispatch, whose sides have limits

// Facets of prisms that are not in the beam, and lamps that are out.
bool is_dark(const shared::Light& light) {
    return light.intensity_cd == glm::vec3(0.0f) && light.bounce_cd == glm::vec3(0.0f);
}

// Narrower than two pixels of the picture, wherever a surface is. A curve that is swept is drawn at any
// width.
bool may_be_thin(const shared::Light& light, const Fragments& f) {
    constexpr float kMost_pixels =
        10; // where it is as far from the eye: dots lie up to five times nearer to their lamp
    return light.figure.kind == shared::kNoFigure &&
           2 * light.tan_field * light.cut_radius * f.pixels_per_rad < kMost_pixels;
}

} // namespace

void Relighter::clear_drawn() {
    const Fragments& f = fragments();
    const std::uint32_t listed = mended_tiles_ > 0 ? dirty_tiles_->drawn_count() : 0;
    if (listed == 0 && device_.is_cpu()) { // where that is memset
        commands_.clear(drawn_);
        return;
    }
    const std::uint32_t tiles = f.tiles_x * f.tiles_y;
    const shared::ClearPush push{
        listed > 0 ? listed : tiles + f.blocks, listed > 0 ? 1u : 0u, tiles, f.tiles_x, f.width, f.height};
    const std::uint32_t across = std::min(push.count, kGroupsAcross);
    commands_.barrier(); // earlier readers are done
    commands_.dispatch(
        clear_, push,
        shaders::ClearTilesBindings{
            .tile_list = gpu::storage(listed > 0 ? dirty_tiles_->drawn_tiles() : f.tile_bounds),
            .rooms = gpu::storage(listed > 0 ? rooms() : f.tile_bounds),
            .drawn = gpu::stored(drawn_)},
        across, gpu::groups(push.count, across));
    commands_.barrier();
}

void Relighter::draw_sum(const ImageSum& sum) {
    if (!sum.lights.empty()) {
        commands_.begin_span("clear");
        clear_drawn();
    }
    const Fragments& f = fragments();
    const auto light_of = [&](int index) {
        return sum.at_unit ? units_.at_unit(index) : units_.lights()[static_cast<std::size_t>(index)];
    };
    const auto wide = [&](const shared::Light& light) {
        // What is mended lacks the rays of the tiles beside it.
        return wide_ && wide_step_ > 1 && settings_.air && mended_tiles_ == 0 &&
               is_wide(light, f.eye_m, f.pixels_per_rad);
    };
    const bool any_wide =
        std::any_of(sum.lights.begin(), sum.lights.end(), [&](int index) { return wide(light_of(index)); });
    if (any_wide && !std::exchange(wide_prepared_, true)) wide_->prepare(commands_, f, wide_step_);
    if (any_wide) commands_.clear(wide_->rays());
    // Lights of a class share a shader that has just what is in their gates.
    for (std::uint32_t kind = 0; kind < (any_wide ? 2 : 1) * shared::kBeamClasses; ++kind) {
        const std::uint32_t beam_class = kind % shared::kBeamClasses;
        const bool is_wide = kind >= shared::kBeamClasses;
        std::vector<shared::Light> chunk;
        for (const int index : sum.lights) {
            const shared::Light light = light_of(index);
            if (is_dark(light) || shared::beam_class(light) != beam_class || wide(light) != is_wide) continue;
            chunk.push_back(light);
            if (chunk.size() == (stop_ ? 1 : shared::kLightsPerChunk)) {
                if (!draw_lights(chunk, beam_class, is_wide) || wants_stop()) return;
                chunk.clear();
            }
        }
        if (!chunk.empty()) draw_lights(chunk, beam_class, is_wide);
    }
    if (any_wide) wide_->spread(commands_, drawn_);
    const gpu::Buffer& tile_list =
        dirty_tiles_ ? dirty_tiles_->tiles() : f.tile_bounds; // only read where tiles are mended
    if (!sum.lights.empty() && f.edge_count > 0) {
        commands_.begin_span("fold");
        if (settings_.air && !std::exchange(silhouettes_known_, true)) {
            commands_.dispatch(silhouettes_, shared::FoldPush{f.edge_count, 0u},
                               shaders::SilhouettesBindings{.view = gpu::uniform(f.view),
                                                            .edges = gpu::sampled(f.edges),
                                                            .places = gpu::stored(f.places),
                                                            .sources = gpu::stored(haze_sources_)},
                               gpu::groups(f.edge_count, 64));
            commands_.barrier();
        }
        if (on_processor_ && mended_tiles_ == 0) {
            fold_on_processor();
        } else {
            commands_.dispatch(
                fold_, shared::FoldPush{f.edge_count, mended_tiles_ > 0 ? 1u : 0u},
                shaders::FoldBindings{.view = gpu::uniform(f.view),
                                      .edges = gpu::sampled(f.edges),
                                      .drawn = gpu::stored(drawn_),
                                      .places = gpu::stored(f.places),
                                      .rooms = gpu::storage(g_buffer_ ? rooms() : f.tile_bounds),
                                      .tile_list = gpu::storage(tile_list),
                                      .sources = gpu::stored(haze_sources_)},
                mended_tiles_ > 0 ? mended_tiles_ : gpu::groups(f.edge_count, 64));
            commands_.barrier();
        }
    }
    add_images(sum);
}

void Relighter::add_images(const ImageSum& sum) {
    if (on_processor_ && mended_tiles_ == 0) {
        add_on_processor(sum);
        return;
    }
    const Fragments& f = fragments();
    const gpu::Buffer& tile_list = dirty_tiles_ ? dirty_tiles_->tiles() : f.tile_bounds;
    CHECK(sum.addends.size() <= shared::kMostAddends);
    shared::SumPush push{};
    push.target = static_cast<std::uint32_t>(std::max(sum.target, 0));
    const std::uint32_t parts = (sum.target < 0 ? shared::kSumToFrame : 0) |
                                (sum.base && !settings_.illuminance ? shared::kSumBase : 0) |
                                (sum.lights.empty() ? 0 : shared::kSumDrawn);
    push.tiles_x = f.tiles_x;
    push.listed = mended_tiles_ > 0 ? 1u : 0u;
    const std::uint64_t offset = addends_used_;
    CHECK(offset + kAddendBytes <= addends_.bytes());
    auto* to = reinterpret_cast<shared::Addend*>(static_cast<std::uint8_t*>(addends_.mapped()) + offset);
    for (const Addend& addend : sum.addends) {
        const glm::vec3 weight = weight_of(addend);
        if (weight == glm::vec3(0.0f)) continue;
        to[push.addend_count++] = {static_cast<std::uint32_t>(addend.slot), weight};
    }
    addends_used_ +=
        (push.addend_count * sizeof(shared::Addend) + kChunkAlign - 1) / kChunkAlign * kChunkAlign;
    commands_.begin_span("add");
    commands_.dispatch(sum_of(parts, std::min(push.addend_count, shared::kManyAddends)), push,
                       shaders::SumBindings{.base = gpu::stored(f.base),
                                            .drawn = gpu::stored(drawn_),
                                            .kept = gpu::stored(kept_),
                                            .tile_list = gpu::storage(tile_list),
                                            .addends = gpu::uniform(addends_, offset),
                                            .frame = gpu::stored(frame_),
                                            .coarse = gpu::stored(coarse_ ? coarse_->sums() : kept_)},
                       (mended_tiles_ > 0 ? mended_tiles_ : f.tiles_x) * (coarse_ ? 2 : 1),
                       mended_tiles_ > 0 ? 1 : f.tiles_y);
    commands_.barrier();
}

const gpu::Program& Relighter::sum_of(std::uint32_t parts, std::uint32_t addends) {
    // A shader for each number pays where a loop loads its values for every lane.
    if (!device_.is_cpu() && addends > 0) addends = shared::kManyAddends;
    std::unique_ptr<gpu::Program>& program = sums_[{parts, addends}];
    if (!program)
        program = std::make_unique<gpu::Program>(
            device_, shaders::kShader_sum,
            std::vector{settings_.beams.beams == Beams::gate ? 0u : 1u, coarse_ ? 1u : 0u, parts, addends});
    return *program;
}

bool Relighter::draw_lights(const std::vector<shared::Light>& lights, std::uint32_t beam_class, bool wide) {
    const std::uint64_t offset = lights_used_;
    const std::uint64_t bytes = lights.size() * sizeof(shared::Light);
    CHECK(offset + kChunkBytes <= lights_.bytes());
    std::memcpy(static_cast<std::uint8_t*>(lights_.mapped()) + offset, lights.data(), bytes);
    lights_used_ += (bytes + kChunkAlign - 1) / kChunkAlign * kChunkAlign;

    const Visibility::Chunk kept = visibility_ ? visibility_->add(lights) : Visibility::Chunk{};
    const LightChunk chunk{
        lights,  beam_class, fragments(), gobos_, slides_, drawn_,      air_,
        lights_, offset,     masks_,      lists_, groups_, batch_size_, wide ? wide_.get() : nullptr};
    const Fragments& f = fragments();
    const shared::CullPush cull{chunk.count(),
                                batch_size_,
                                f.tiles_x,
                                chunk.tiles(),
                                f.blocks,
                                settings_.surfaces ? 1u : 0u,
                                settings_.air ? 1u : 0u,
                                wide ? wide_step_ * wide_step_ : 1u,
                                keeps_visibility() ? kept.now : 0,
                                visibility_ ? visibility_->page_count() : 0,
                                visibility_ ? visibility_->units() : 0,
                                visibility_ ? std::max(kLeastMade, visibility_->units() / kPartMade) : 0,
                                batch_size_ == 1            ? ~0u
                                : settings_.most_groups > 0 ? settings_.most_groups
                                                            : device_.limits().work_groups};
    commands_.begin_span("cull");
    const std::uint32_t slices = visibility_slices(f, batch_size_);
    commands_.write(groups_,
                    std::vector<shared::TileGroups>(
                        chunk.batches(), {{0, 1, 1, 0}, {0, 1, 1, 0}, {0, slices, 1, 0}, {0, 1, 1, 0}}));
    commands_.write(lists_, std::vector<std::uint32_t>(std::size_t{4} * chunk.batches()));
    commands_.dispatch(
        cull_, cull,
        shaders::CullBindings{
            .view = gpu::uniform(f.view),
            .lights = gpu::uniform(lights_, offset),
            .tile_bounds = gpu::storage(mended_tiles_ > 0 ? dirty_tiles_->bounds() : f.tile_bounds),
            .masks = gpu::storage(masks_),
            .groups = gpu::storage(groups_),
            .lists = gpu::storage(lists_),
            .work = gpu::storage(work_),
            .keeps = gpu::uniform(visibility_ ? visibility_->keeps() : nothing_, kept.offset),
            .entries = gpu::storage(visibility_ ? visibility_->entries() : nothing_),
            .changed = gpu::storage(visibility_ ? visibility_->changed_at() : nothing_)},
        gpu::groups(chunk.tiles() + f.blocks, 64), chunk.batches());
    commands_.barrier();
    if (settings_.air) haze_.record(commands_, chunk);
    if (!settings_.surfaces) return true;
    if (wants_stop()) return false;
    record_surfaces(chunk, kept.offset);
    return true;
}

void Relighter::record_surfaces(const LightChunk& chunk, std::uint64_t keeps_offset) {
    const Fragments& f = fragments();
    if (passes_.bounces.bytes() > 0) {
        commands_.begin_span("bounces");
        commands_.dispatch(bounce_, shared::BouncePush{chunk.count()},
                           shaders::BounceBindings{.view = gpu::uniform(f.view),
                                                   .lights = gpu::uniform(lights_, chunk.light_offset),
                                                   .fragments = gpu::stored(f.places),
                                                   .bounces = gpu::stored(passes_.bounces),
                                                   .drawn = gpu::stored(drawn_)},
                           f.tiles_x, f.tiles_y);
        commands_.barrier();
    }
    std::vector<gpu::Binding> bindings;
    if (g_buffer_)
        bindings = shaders::SurfaceLiveBindings{
            .gobo_stack = gpu::sampled(gobos_),
            .view = gpu::uniform(f.view),
            .lights = gpu::uniform(lights_, chunk.light_offset),
            .masks = gpu::storage(masks_),
            .lists = gpu::storage(lists_),
            .places = gpu::stored(f.places),
            .drawn = gpu::stored(drawn_),
            .diffuse = gpu::stored(coarse_ ? coarse_->diffuse() : g_buffer_->diffuse()),
            .distance_maps = gpu::sampled(distances_ ? distances_->texture() : gobos_),
            .specular = gpu::stored(coarse_ ? coarse_->specular() : g_buffer_->specular()),
            .normals = gpu::stored(normals()),
            .air = gpu::uniform(air_),
            .blockers = gpu::sampled(distances_ ? distances_->blockers() : gobos_),
            .slides = gpu::sampled(slides_),
            .keeps = gpu::uniform(visibility_ ? visibility_->keeps() : nothing_, keeps_offset),
            .entries = gpu::storage(visibility_ ? visibility_->entries() : nothing_),
            .pages = gpu::stored(visibility_ ? visibility_->pages() : no_pages_)};
    else
        bindings = shaders::SurfaceBindings{.gobo_stack = gpu::sampled(gobos_),
                                            .view = gpu::uniform(f.view),
                                            .lights = gpu::uniform(lights_, chunk.light_offset),
                                            .masks = gpu::storage(masks_),
                                            .lists = gpu::storage(lists_),
                                            .fragments = gpu::stored(f.places),
                                            .drawn = gpu::stored(drawn_),
                                            .passes = gpu::stored(passes_.radiance),
                                            .air = gpu::uniform(air_),
                                            .slides = gpu::sampled(slides_)};
    const bool thin = std::any_of(chunk.lights.begin(), chunk.lights.end(),
                                  [&](const shared::Light& light) { return may_be_thin(light, f); });
    shared::RelightPush push{
        chunk.count(), 0, f.tiles_x, chunk.tiles(), f.blocks, 0, visibility_ ? visibility_->units() : 0, 0};
    for (push.batch = 0; push.batch < chunk.batches(); ++push.batch) {
        if (keeps_visibility()) {
            commands_.begin_span("visibility");
            commands_.dispatch_indirect(
                visible_.get(), push,
                shaders::VisibilityBindings{.view = gpu::uniform(f.view),
                                            .lights = gpu::uniform(lights_, chunk.light_offset),
                                            .masks = gpu::storage(masks_),
                                            .lists = gpu::storage(lists_),
                                            .distance_maps = gpu::sampled(distances_->texture()),
                                            .blockers = gpu::sampled(distances_->blockers()),
                                            .places = gpu::stored(f.places),
                                            .normals = gpu::stored(normals()),
                                            .keeps = gpu::uniform(visibility_->keeps(), keeps_offset),
                                            .entries = gpu::storage(visibility_->entries()),
                                            .pages = gpu::stored(visibility_->pages())},
                groups_, chunk.made_groups(push.batch));
            commands_.barrier();
        }
        commands_.begin_span("surfaces");
        gpu::LateProgram& direct = direct_surface_[chunk.beam_class];
        const bool all_direct = distances_ && !keeps_visibility();
        gpu::LateProgram& listed = all_direct ? direct : (thin ? thin_surface_ : surface_)[chunk.beam_class];
        commands_.dispatch_indirect(listed.get(), push, bindings, groups_, chunk.surface_groups(push.batch));
        if (keeps_visibility() && batch_size_ == 1) {
            // Other tiles than those above.
            push.direct = 1;
            commands_.dispatch_indirect(direct.get(), push, bindings, groups_,
                                        chunk.direct_groups(push.batch));
            push.direct = 0;
        }
        commands_.barrier();
    }
}

} // namespace ghost::render
