// SPDX-License-Identifier: Apache-2.0
// The part of Relighter that draws lights: a sum of the tree, its lights by chunks, their surfaces.
#include "base/check.h"
#include "render/relight/planes.h"
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
// Work of a light, of which one is seen in the whole picture: its tables, and where it rests and little of
// the picture is drawn again. Looked for in so many parts across and down.
constexpr double kWorkOfTables = 0.12, kWorkOfResting = 0.1;
constexpr int kWorkParts = 4;
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

void Relighter::clear_drawn(LightPainter& painter) {
    const Fragments& f = fragments();
    const std::uint32_t listed = painter.mended_tiles > 0 ? painter.mending->drawn_count() : 0;
    if (listed == 0 && device_.is_cpu()) { // where that is memset
        painter.commands.clear(*painter.into);
        return;
    }
    const std::uint32_t tiles = f.tiles_x * f.tiles_y;
    const shared::ClearPush push{
        listed > 0 ? listed : tiles + f.blocks, listed > 0 ? 1u : 0u, tiles, f.tiles_x, f.width, f.height};
    const std::uint32_t across = std::min(push.count, kGroupsAcross);
    painter.commands.barrier(); // earlier readers are done
    painter.commands.dispatch(
        painter.clear, push,
        shaders::ClearTilesBindings{
            .tile_list = gpu::storage(listed > 0 ? painter.mending->drawn_tiles() : f.tile_bounds),
            .rooms = gpu::storage(listed > 0 ? rooms() : f.tile_bounds),
            .drawn = gpu::stored(*painter.into)},
        across, gpu::groups(push.count, across));
    painter.commands.barrier();
}

// Largest first, each to the one that has least to do, or to the one whose tables it has where that leaves
// nobody idle; lights of a place have one painter (render/haze/visibility.h).
std::vector<Relighter::Share> Relighter::shares_of(const std::vector<int>& lights,
                                                   const std::vector<int>& resting) {
    if (lights.empty() && resting.empty()) return {};
    if (!uses_workers() || lights.size() + resting.size() == 1) return {{&main_, lights, resting, 0}};
    struct Part {
        int light;
        bool rests;
        double work;
    };
    std::vector<Part> parts;
    for (const int light : lights) parts.push_back({light, false, work_of(light)});
    for (const int light : resting) parts.push_back({light, true, kWorkOfResting});
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.work > b.work; });
    std::vector<Share> shares;
    for (const auto& painter : painters_) shares.push_back({painter.get(), {}, {}, 0});
    std::map<std::uint32_t, std::size_t> painter_of_place;
    for (const Part& part : parts) {
        std::size_t least = 0;
        for (std::size_t k = 1; k < shares.size(); ++k)
            if (shares[k].work < shares[least].work) least = k;
        const auto light = static_cast<std::size_t>(part.light);
        std::size_t& known = painter_of_[light];
        if (known >= shares.size() || shares[known].work > shares[least].work) known = least;
        if (const std::uint32_t place = units_.lights()[light].map; place > 0)
            known = painter_of_place.emplace(place, known).first->second;
        (part.rests ? shares[known].resting : shares[known].lights).push_back(part.light);
        shares[known].work += part.work;
    }
    std::erase_if(shares, [](const Share& share) { return share.lights.empty() && share.resting.empty(); });
    return shares;
}

// By how much of the picture it may be seen in.
double Relighter::work_of(int light) const {
    const Fragments& f = fragments();
    const auto at = [](std::uint32_t size, int k) { return static_cast<int>(size) * k / kWorkParts; };
    int reached = 0;
    for (int row = 0; row < kWorkParts; ++row)
        for (int column = 0; column < kWorkParts; ++column)
            reached += may_reach(units_.lights()[static_cast<std::size_t>(light)], f.camera,
                                 {at(f.width, column), at(f.height, row), at(f.width, column + 1),
                                  at(f.height, row + 1)})
                           ? 1
                           : 0;
    return kWorkOfTables + static_cast<double>(reached) / (kWorkParts * kWorkParts);
}

// What is worked out of shadows just where light falls is the shaders' alone.
bool Relighter::leaves_surfaces(const LightPainter& painter) const {
    return lights_on_processor_ && adds_on_processor(painter) && (!distances_ || keeps_visibility(painter));
}

void Relighter::draw_sum(const ImageSum& sum) {
    if (on_processor_) {
        draw_patched(sum, {}, {});
        return;
    }
    if (!sum.lights.empty() && !draw_share(main_, sum, sum.lights)) return;
    add_images(main_, sum);
}

// Images that are stale in some tiles are as if they were drawn again there: patch.
void Relighter::draw_patched(const ImageSum& sum, const ImageSum& patch, const TileSet& tiles) {
    std::vector<DrawnLights> drawn, patched;
    on_all([](LightPainter& painter) { painter.left.clear(); });
    const Fragments& f = fragments();
    const auto planes = [&](const gpu::Texture& texture) {
        return DrawnLights{plane_of(texture, 0), plane_of(texture, 1)};
    };
    const std::vector<Share> shares = shares_of(sum.lights, patch.lights);
    for (const Share& share : shares) {
        LightPainter& painter = *share.painter;
        record_on(painter);
        if (lights_on_processor_) painter.begin_marks();
        if (!share.lights.empty()) {
            if (!draw_share(painter, sum, share.lights)) return;
            drawn.push_back(planes(painter.drawn));
        }
        if (share.resting.empty()) continue;
        painter.expect_patches();
        painter.into = &painter.patch;
        painter.mended_tiles = painter.mending->record(painter.commands, rooms(), tiles);
        draw_share(painter, patch, share.resting);
        painter.mended_tiles = 0;
        painter.into = &painter.drawn;
        patched.push_back(planes(painter.patch));
    }
    // Where silhouettes have their haze from one painter has to know: who does already, or has least to do.
    const auto folds = std::min_element(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
        return std::pair(!a.painter->silhouettes_known, a.work) <
               std::pair(!b.painter->silhouettes_known, b.work);
    });
    if (folds != shares.end()) find_silhouettes(*folds->painter);
    if (!drawn.empty()) light_on_processor(false, drawn.front().surfaces);
    if (!patched.empty()) light_on_processor(true, patched.front().surfaces);
    if (!drawn.empty() && f.edge_count > 0) fold_on_processor(*folds->painter, drawn, nullptr);
    if (!patched.empty() && f.edge_count > 0) fold_on_processor(*folds->painter, patched, &tiles);
    add_on_processor(sum, drawn, {});
    if (tiles.empty()) return;
    drawn.insert(drawn.end(), patched.begin(), patched.end());
    add_on_processor(patch, drawn, tiles.rects());
}

// Only the tiles that a painter mends.
void Relighter::draw_part(LightPainter& painter, const ImageSum& sum) {
    if (!sum.lights.empty()) draw_share(painter, sum, sum.lights);
    add_images(painter, sum);
}

// Where they have their haze from, once for each picture of the stage.
void Relighter::find_silhouettes(LightPainter& painter) {
    const Fragments& f = fragments();
    if (!settings_.air || f.edge_count == 0 || std::exchange(painter.silhouettes_known, true)) return;
    painter.commands.begin_span("silhouettes");
    painter.commands.dispatch(painter.silhouettes, shared::FoldPush{f.edge_count, 0u},
                              shaders::SilhouettesBindings{.view = gpu::uniform(f.view),
                                                           .edges = gpu::sampled(f.edges),
                                                           .places = gpu::stored(f.places),
                                                           .sources = gpu::stored(painter.haze_sources)},
                              gpu::groups(f.edge_count, 64));
    painter.commands.barrier();
}

// False: it was stopped.
bool Relighter::draw_share(LightPainter& painter, const ImageSum& sum, const std::vector<int>& lights) {
    gpu::Commands& commands = painter.commands;
    commands.begin_span("clear");
    clear_drawn(painter);
    const Fragments& f = fragments();
    const auto wide = [&](const shared::Light& light) {
        // What is mended lacks the rays of the tiles beside it.
        return painter.wide && wide_step_ > 1 && settings_.air && painter.mended_tiles == 0 &&
               is_wide(light, f.eye_m, f.pixels_per_rad);
    };
    const bool any_wide =
        std::any_of(lights.begin(), lights.end(), [&](int index) { return wide(light_of(sum, index)); });
    if (any_wide && !std::exchange(painter.wide_prepared, true))
        painter.wide->prepare(commands, f, wide_step_);
    if (any_wide) commands.clear(painter.wide->rays());
    const bool may_leave = leaves_surfaces(painter); // but those of dots narrower than two pixels
    // Lights of a class share a shader that has just what is in their gates.
    for (std::uint32_t kind = 0; kind < 4 * shared::kBeamClasses; ++kind) {
        const std::uint32_t beam_class = kind % shared::kBeamClasses;
        const bool is_wide = (kind / shared::kBeamClasses & 1) != 0;
        const bool leaves = kind >= 2 * shared::kBeamClasses; // their surfaces
        if ((is_wide && !any_wide) || (leaves && !may_leave)) continue;
        std::vector<shared::Light> chunk;
        std::vector<int> left;
        for (const int index : lights) {
            const shared::Light light = light_of(sum, index);
            if (is_dark(light) || shared::beam_class(light) != beam_class || wide(light) != is_wide ||
                (may_leave && !may_be_thin(light, f)) != leaves)
                continue;
            chunk.push_back(light);
            if (leaves) left.push_back(index);
            if (chunk.size() == (stop_ ? 1 : painter.haze.most_lights())) {
                if (!draw_lights(painter, chunk, left, beam_class, is_wide) || wants_stop(painter))
                    return false;
                chunk.clear();
                left.clear();
            }
        }
        if (!chunk.empty()) draw_lights(painter, chunk, left, beam_class, is_wide);
    }
    if (any_wide) painter.wide->spread(commands, *painter.into);
    if (f.edge_count == 0) return true;
    if (adds_on_processor(painter)) return true; // fold_on_processor
    find_silhouettes(painter);
    commands.begin_span("fold");
    const gpu::Buffer& tile_list =
        painter.mending ? painter.mending->tiles() : f.tile_bounds; // only read where tiles are mended
    commands.dispatch(painter.fold, shared::FoldPush{f.edge_count, painter.mended_tiles > 0 ? 1u : 0u},
                      shaders::FoldBindings{.view = gpu::uniform(f.view),
                                            .edges = gpu::sampled(f.edges),
                                            .drawn = gpu::stored(*painter.into),
                                            .places = gpu::stored(f.places),
                                            .rooms = gpu::storage(g_buffer_ ? rooms() : f.tile_bounds),
                                            .tile_list = gpu::storage(tile_list),
                                            .sources = gpu::stored(painter.haze_sources)},
                      painter.mended_tiles > 0 ? painter.mended_tiles : gpu::groups(f.edge_count, 64));
    commands.barrier();
    return true;
}

void Relighter::add_images(LightPainter& painter, const ImageSum& sum) {
    const Fragments& f = fragments();
    const gpu::Buffer& tile_list = painter.mending ? painter.mending->tiles() : f.tile_bounds;
    CHECK(sum.addends.size() <= shared::kMostAddends);
    shared::SumPush push{};
    push.target = static_cast<std::uint32_t>(std::max(sum.target, 0));
    const std::uint32_t parts = (sum.target < 0 ? shared::kSumToFrame : 0) |
                                (sum.base && !settings_.illuminance ? shared::kSumBase : 0) |
                                (sum.lights.empty() ? 0 : shared::kSumDrawn);
    push.tiles_x = f.tiles_x;
    push.listed = painter.mended_tiles > 0 ? 1u : 0u;
    const std::uint64_t offset = painter.addends_used;
    CHECK(offset + LightPainter::kAddendBytes <= painter.addends.bytes());
    auto* to =
        reinterpret_cast<shared::Addend*>(static_cast<std::uint8_t*>(painter.addends.mapped()) + offset);
    for (const Addend& addend : sum.addends) {
        const glm::vec3 weight = weight_of(addend);
        if (weight == glm::vec3(0.0f)) continue;
        to[push.addend_count++] = {static_cast<std::uint32_t>(addend.slot), weight};
    }
    painter.addends_used += (push.addend_count * sizeof(shared::Addend) + LightPainter::kChunkAlign - 1) /
                            LightPainter::kChunkAlign * LightPainter::kChunkAlign;
    painter.commands.begin_span("add");
    painter.commands.dispatch(painter.sum_of(parts, std::min(push.addend_count, shared::kManyAddends)), push,
                              shaders::SumBindings{.base = gpu::stored(f.base),
                                                   .drawn = gpu::stored(*painter.into),
                                                   .kept = gpu::stored(kept_),
                                                   .tile_list = gpu::storage(tile_list),
                                                   .addends = gpu::uniform(painter.addends, offset),
                                                   .frame = gpu::stored(frame_),
                                                   .coarse = gpu::stored(coarse_ ? coarse_->sums() : kept_)},
                              (painter.mended_tiles > 0 ? painter.mended_tiles : f.tiles_x) *
                                  (coarse_ ? 2 : 1),
                              painter.mended_tiles > 0 ? 1 : f.tiles_y);
    painter.commands.barrier();
}

// Workers have their own counts.
std::uint32_t Relighter::most_made(const LightPainter& painter) const {
    const std::uint32_t most = std::max(kLeastMade, visibility_->units() / kPartMade);
    return &painter == &main_ ? most : most / static_cast<std::uint32_t>(painters_.size());
}

bool Relighter::draw_lights(LightPainter& painter, const std::vector<shared::Light>& lights,
                            const std::vector<int>& indices, std::uint32_t beam_class, bool wide) {
    const std::uint64_t offset = painter.lights_used;
    const std::uint64_t bytes = lights.size() * sizeof(shared::Light);
    CHECK(offset + LightPainter::kChunkBytes <= painter.lights.bytes());
    std::memcpy(static_cast<std::uint8_t*>(painter.lights.mapped()) + offset, lights.data(), bytes);
    painter.lights_used +=
        (bytes + LightPainter::kChunkAlign - 1) / LightPainter::kChunkAlign * LightPainter::kChunkAlign;

    const Visibility::Chunk kept = visibility_ ? visibility_->add(lights) : Visibility::Chunk{};
    const LightChunk chunk{lights,        beam_class,
                           fragments(),   gobos_,
                           slides_,       *painter.into,
                           air_,          painter.lights,
                           offset,        painter.masks,
                           painter.lists, painter.groups,
                           batch_size_,   wide ? painter.wide.get() : nullptr};
    const Fragments& f = fragments();
    const shared::CullPush cull{chunk.count(),
                                batch_size_,
                                f.tiles_x,
                                chunk.tiles(),
                                f.blocks,
                                settings_.surfaces ? 1u : 0u,
                                settings_.air ? 1u : 0u,
                                wide ? wide_step_ * wide_step_ : 1u,
                                keeps_visibility(painter) ? kept.now : 0,
                                visibility_ ? visibility_->page_count() : 0,
                                visibility_ ? visibility_->units() : 0,
                                visibility_ ? most_made(painter) : 0,
                                batch_size_ == 1            ? ~0u
                                : settings_.most_groups > 0 ? settings_.most_groups
                                                            : device_.limits().work_groups,
                                indices.empty() ? 0u : static_cast<std::uint32_t>(painter.left.size()) + 1};
    for (std::size_t k = 0; k < indices.size(); ++k) {
        const auto* keeps =
            visibility_ ? reinterpret_cast<const shared::Keep*>(
                              static_cast<const std::uint8_t*>(visibility_->keeps().mapped()) + kept.offset)
                        : nullptr;
        painter.left.push_back({indices[k], lights[k], keeps ? keeps[k].place : 0,
                                painter.left.size() * painter.mark_words(), painter.into == &painter.patch});
    }
    painter.commands.begin_span("cull");
    const std::uint32_t slices = visibility_slices(f, batch_size_);
    painter.commands.write(
        painter.groups, std::vector<shared::TileGroups>(
                            chunk.batches(), {{0, 1, 1, 0}, {0, 1, 1, 0}, {0, slices, 1, 0}, {0, 1, 1, 0}}));
    painter.commands.write(painter.lists, std::vector<std::uint32_t>(std::size_t{4} * chunk.batches()));
    painter.commands.dispatch(
        painter.cull, cull,
        shaders::CullBindings{
            .view = gpu::uniform(f.view),
            .lights = gpu::uniform(painter.lights, offset),
            .tile_bounds = gpu::storage(painter.mended_tiles > 0 ? painter.mending->bounds() : f.tile_bounds),
            .masks = gpu::storage(painter.masks),
            .groups = gpu::storage(painter.groups),
            .lists = gpu::storage(painter.lists),
            .work = gpu::storage(painter.work),
            .keeps = gpu::uniform(visibility_ ? visibility_->keeps() : nothing_, kept.offset),
            .entries = gpu::storage(visibility_ ? visibility_->entries() : nothing_),
            .changed = gpu::storage(visibility_ ? visibility_->changed_at() : nothing_)},
        gpu::groups(chunk.tiles() + f.blocks, 64), chunk.batches());
    painter.commands.barrier();
    if (settings_.air) painter.haze.record(painter.commands, chunk);
    if (!settings_.surfaces) return true;
    if (wants_stop(painter)) return false;
    if (passes_.bounces.bytes() > 0) record_bounces(painter, chunk);
    record_surfaces(painter, chunk, kept.offset, indices.empty());
    return true;
}

void Relighter::record_bounces(LightPainter& painter, const LightChunk& chunk) {
    const Fragments& f = fragments();
    painter.commands.begin_span("bounces");
    painter.commands.dispatch(
        painter.bounce, shared::BouncePush{chunk.count()},
        shaders::BounceBindings{.view = gpu::uniform(f.view),
                                .lights = gpu::uniform(painter.lights, chunk.light_offset),
                                .fragments = gpu::stored(f.places),
                                .bounces = gpu::stored(passes_.bounces),
                                .drawn = gpu::stored(*painter.into)},
        f.tiles_x, f.tiles_y);
    painter.commands.barrier();
}

void Relighter::record_surfaces(LightPainter& painter, const LightChunk& chunk, std::uint64_t keeps_offset,
                                bool listed) {
    const bool direct_too = keeps_visibility(painter) && batch_size_ == 1;
    if (!listed && !direct_too) return; // all are left
    const Fragments& f = fragments();
    std::vector<gpu::Binding> bindings;
    if (g_buffer_)
        bindings = shaders::SurfaceLiveBindings{
            .gobo_stack = gpu::sampled(gobos_),
            .view = gpu::uniform(f.view),
            .lights = gpu::uniform(painter.lights, chunk.light_offset),
            .masks = gpu::storage(painter.masks),
            .lists = gpu::storage(painter.lists),
            .places = gpu::stored(f.places),
            .drawn = gpu::stored(*painter.into),
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
                                            .lights = gpu::uniform(painter.lights, chunk.light_offset),
                                            .masks = gpu::storage(painter.masks),
                                            .lists = gpu::storage(painter.lists),
                                            .fragments = gpu::stored(f.places),
                                            .drawn = gpu::stored(*painter.into),
                                            .passes = gpu::stored(passes_.radiance),
                                            .air = gpu::uniform(air_),
                                            .slides = gpu::sampled(slides_)};
    const bool thin = std::any_of(chunk.lights.begin(), chunk.lights.end(),
                                  [&](const shared::Light& light) { return may_be_thin(light, f); });
    shared::RelightPush push{
        chunk.count(), 0, f.tiles_x, chunk.tiles(), f.blocks, 0, visibility_ ? visibility_->units() : 0, 0};
    for (push.batch = 0; push.batch < chunk.batches(); ++push.batch) {
        if (keeps_visibility(painter)) {
            painter.commands.begin_span("visibility");
            painter.commands.dispatch_indirect(
                painter.visible.get(), push,
                shaders::VisibilityBindings{.view = gpu::uniform(f.view),
                                            .lights = gpu::uniform(painter.lights, chunk.light_offset),
                                            .masks = gpu::storage(painter.masks),
                                            .lists = gpu::storage(painter.lists),
                                            .distance_maps = gpu::sampled(distances_->texture()),
                                            .blockers = gpu::sampled(distances_->blockers()),
                                            .places = gpu::stored(f.places),
                                            .normals = gpu::stored(normals()),
                                            .keeps = gpu::uniform(visibility_->keeps(), keeps_offset),
                                            .entries = gpu::storage(visibility_->entries()),
                                            .pages = gpu::stored(visibility_->pages())},
                painter.groups, chunk.made_groups(push.batch));
            painter.commands.barrier();
        }
        painter.commands.begin_span("surfaces");
        gpu::LateProgram& direct = painter.direct_surface[chunk.beam_class];
        const bool all_direct = distances_ && !keeps_visibility(painter);
        gpu::LateProgram& program =
            all_direct ? direct : (thin ? painter.thin_surface : painter.surface)[chunk.beam_class];
        if (listed)
            painter.commands.dispatch_indirect(program.get(), push, bindings, painter.groups,
                                               chunk.surface_groups(push.batch));
        if (direct_too) {
            // Other tiles than those above.
            push.direct = 1;
            painter.commands.dispatch_indirect(direct.get(), push, bindings, painter.groups,
                                               chunk.direct_groups(push.batch));
            push.direct = 0;
        }
        painter.commands.barrier();
    }
}

} // namespace ghost::render
