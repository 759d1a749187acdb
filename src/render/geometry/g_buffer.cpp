// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/g_buffer.h"

#include "base/check.h"
#include "base/log.h"
#include "image/finite.h"
#include "render/geometry/layout.h"
#include "shaders/block_bounds.h"
#include "shaders/g_buffer_cut_frag.h"
#include "shaders/g_buffer_frag.h"
#include "shaders/g_buffer_vert.h"
#include "shaders/gather.h"
#include "shaders/gather_single.h"
#include "shared/g_buffer.h"
#include "shared/push.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace ghost::render {
namespace {

constexpr VkFormat kHalves = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat kFloats = VK_FORMAT_R32G32B32A32_SFLOAT;
// What is drawn between two looks whether something more urgent waits.
constexpr double kPiece_ms = 8;
constexpr std::size_t kFirstPiece_indices = 6000;

gpu::Texture attachment(const gpu::Device& device, const Fragments& fragments, VkFormat format,
                        std::uint32_t samples) {
    gpu::TextureShape shape{fragments.width, fragments.height, 1, 1, format};
    shape.attachment = true;
    shape.samples = samples;
    return {device, shape};
}

gpu::Texture stored(const gpu::Device& device, std::uint32_t width, std::uint32_t height, VkFormat format) {
    return {device, {width, height, 1, 1, format, true, false}};
}

gpu::RasterShape raster_shape(std::uint32_t alpha, std::uint32_t textures, std::uint32_t samples) {
    gpu::RasterShape shape;
    shape.inputs = {
        {VK_FORMAT_R32G32B32_SFLOAT, offsetof(StageVertex, position_m)},
        {VK_FORMAT_R16G16B16A16_SNORM, offsetof(StageVertex, normal)},
        {VK_FORMAT_R16G16B16A16_SNORM, offsetof(StageVertex, tangent)},
        {VK_FORMAT_R32G32_SFLOAT, offsetof(StageVertex, uv)},
    };
    shape.vertex_stride = sizeof(StageVertex);
    shape.constants = {alpha, textures, samples};
    shape.colours = {kHalves, kHalves, kHalves, VK_FORMAT_R8_UNORM};
    shape.samples = samples;
    return shape;
}

std::uint32_t samples_of(const Pose& pose) {
    return pose.single ? 1 : shared::kSamples;
}

struct Axes {
    glm::vec3 eye_m, right, up, forward;
    float tan_x, tan_y;
};

Axes axes_of(const Pose& pose) {
    const glm::mat4& m = pose.camera_to_world;
    const float tan_y = std::tan(pose.fov_y_deg * 0.5f * shared::kPi / 180.0f);
    const float tan_x = tan_y * static_cast<float>(pose.width) / static_cast<float>(pose.height);
    return {glm::vec3(m[3]), glm::vec3(m[0]), glm::vec3(m[1]), -glm::vec3(m[2]), tan_x, tan_y};
}

// From places with the eye as origin.
glm::mat4 to_clip(const Axes& axes) {
    glm::mat4 m(0.0f);
    for (int k = 0; k < 3; ++k)
        m[k] = glm::vec4(axes.right[k] / axes.tan_x, -axes.up[k] / axes.tan_y, 0.0f, axes.forward[k]);
    m[3] = glm::vec4(0.0f, 0.0f, shared::kNear_m, 0.0f);
    return m;
}

// Of the view, normals inwards, the eye as origin.
std::vector<glm::vec4> planes_of(const Axes& axes) {
    return {
        glm::vec4(axes.forward, -shared::kNear_m),
        glm::vec4(axes.forward * axes.tan_x - axes.right, 0.0f),
        glm::vec4(axes.forward * axes.tan_x + axes.right, 0.0f),
        glm::vec4(axes.forward * axes.tan_y - axes.up, 0.0f),
        glm::vec4(axes.forward * axes.tan_y + axes.up, 0.0f),
    };
}

bool usable_pose(const Pose& pose) {
    return image::is_finite(pose.camera_to_world) && pose.fov_y_deg > 0 && pose.fov_y_deg < 180;
}

} // namespace

std::vector<VkRect2D> regions(const TileSet& tiles) {
    std::vector<VkRect2D> all;
    for (const PixelRect& rect : tiles.rects())
        all.push_back(
            {{rect.x0, rect.y0},
             {static_cast<std::uint32_t>(rect.x1 - rect.x0), static_cast<std::uint32_t>(rect.y1 - rect.y0)}});
    return all;
}

GBuffer::GBuffer(const gpu::Device& device, int width, int height)
    : device_(device), gather_{gpu::LateProgram(device, shaders::kShader_gather),
                               gpu::LateProgram(device, shaders::kShader_gather_single)},
      block_bounds_(device, shaders::kShader_block_bounds), commands_(device) {
    using gpu::Access;
    using gpu::Buffer;
    CHECK(width > 0 && height > 0);
    const auto w = static_cast<std::uint32_t>(width);
    const auto h = static_cast<std::uint32_t>(height);
    capacity_ = gpu::groups(w * h, shared::kTilePixels) * shared::kTilePixels;
    fragments_.width = w;
    fragments_.height = h;
    fragments_.tiles_x = gpu::groups(w, shared::kTileWidth);
    fragments_.tiles_y = gpu::groups(h, shared::kTileHeight);
    fragments_.view = Buffer(device, sizeof(shared::View), Access::device);
    const std::uint32_t rows = h + gpu::groups(capacity_, w);
    fragments_.places = stored(device, w, rows, kFloats);
    fragments_.edges = stored(device, w, h, VK_FORMAT_R32G32_UINT);
    fragments_.base = stored(device, w, h, kHalves);
    const std::uint64_t bounds =
        std::uint64_t{fragments_.tiles_x} * fragments_.tiles_y + capacity_ / shared::kTilePixels;
    fragments_.tile_bounds = Buffer(device, bounds * 2 * sizeof(glm::vec4), Access::device);
    diffuse_ = stored(device, w, rows, kHalves);
    specular_ = stored(device, w, rows, kHalves);
    normals_ = stored(device, w, rows, kHalves);
    const std::uint64_t tiles = std::uint64_t{fragments_.tiles_x} * fragments_.tiles_y;
    rooms_ = Buffer(device, tiles * sizeof(shared::TileRoom), Access::device);
    tile_list_ = Buffer(device, tiles * sizeof(std::uint32_t), Access::upload);
    // A tile names the blocks of its old room and of its new one.
    constexpr std::uint64_t kBlocksOfTile =
        2 *
        ((shared::kSamples - 1) + (shared::kSpareRoom + shared::kTilePixels - 1) / shared::kTilePixels + 1);
    block_list_ =
        Buffer(device, sizeof(shared::BlockListHead) + tiles * kBlocksOfTile * sizeof(std::uint32_t),
               Access::device);
    counts_ = Buffer(device, sizeof(shared::GatherCounts), Access::device);
    counts_read_ = Buffer(device, sizeof(shared::GatherCounts), Access::readback);
}

GBuffer::Samples GBuffer::make_samples() const {
    const auto made = [&](VkFormat format) {
        return attachment(device_, fragments_, format, samples_of(pose_));
    };
    return {made(VK_FORMAT_D32_SFLOAT), made(kHalves), made(kHalves), made(kHalves),
            made(VK_FORMAT_R8_UNORM)};
}

bool GBuffer::draw(const StageModel& model, const Pose& pose, const Surroundings& surroundings,
                   const std::function<bool()>& stop) {
    CHECK_EQ(static_cast<std::uint32_t>(pose.width), fragments_.width);
    CHECK_EQ(static_cast<std::uint32_t>(pose.height), fragments_.height);
    CHECK(usable_pose(pose));
    const bool same_stage = stands_at(pose) && still_revision_ == model.still_revision();
    if (is_whole_ && same_stage) {
        surround(surroundings);
        update(model);
        commands_.begin();
        gather(nullptr);
        submit();
        changed_ = {{0, 0, pose.width, pose.height}};
        extras_moved_ = true;
        warn_of_dropped();
        return true;
    }
    const bool goes_on = !is_whole_ && drawn_count_ > 0 && same_stage;
    is_whole_ = false;
    pose_ = pose;
    surround(surroundings);
    if (!goes_on) {
        still_revision_ = model.still_revision();
        const Axes axes = axes_of(pose);
        to_draw_ = model.visible(axes.eye_m, planes_of(axes), pose.most_error_px / fragments_.pixels_per_rad);
        drawn_count_ = 0;
    }
    if (!draw_still(model, stop)) return false;
    changed_ = {{0, 0, pose.width, pose.height}};
    saved_ = TileSet(pose.width, pose.height);
    shown_.clear();
    draw_moving(model, plan_moving(model));
    gather(nullptr);
    submit();
    extras_moved_ = is_whole_ = true;
    warn_of_dropped();
    return true;
}

// Leaves the last piece to be submitted with what follows.
bool GBuffer::draw_still(const StageModel& model, const std::function<bool()>& stop) {
    std::size_t piece_indices = kFirstPiece_indices;
    for (;;) {
        const std::size_t first = drawn_count_;
        std::size_t indices = 0;
        while (drawn_count_ < to_draw_.size() && (!stop || indices < piece_indices))
            indices += model.range(to_draw_[drawn_count_++]).index_count;
        commands_.begin();
        commands_.begin_span("raster");
        draw_meshes(model, std::span(to_draw_).subspan(first, drawn_count_ - first),
                    first == 0 ? gpu::Before::cleared : gpu::Before::kept);
        if (drawn_count_ == to_draw_.size()) {
            to_draw_ = {};
            drawn_count_ = 0;
            return true;
        }
        const auto begin = std::chrono::steady_clock::now();
        commands_.submit_and_wait();
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
        piece_indices = static_cast<std::size_t>(static_cast<double>(piece_indices) *
                                                 std::clamp(kPiece_ms / took.count(), 0.5, 2.0)) +
                        1;
        if (stop()) return false;
    }
}

bool GBuffer::stands_at(const Pose& pose) const {
    return pose_.width > 0 && pose.camera_to_world == pose_.camera_to_world &&
           pose.fov_y_deg == pose_.fov_y_deg && pose.most_error_px == pose_.most_error_px &&
           pose.single == pose_.single;
}

bool GBuffer::is_surrounded_by(const Surroundings& surroundings) const {
    return surroundings.ambient == surroundings_.ambient && surroundings.work_lux == surroundings_.work_lux &&
           std::memcmp(&surroundings.haze, &surroundings_.haze, sizeof surroundings.haze) == 0;
}

void GBuffer::surround(const Surroundings& surroundings) {
    surroundings_ = surroundings;
    fragments_.camera =
        make_view(pose_.camera_to_world, pose_.fov_y_deg, pose_.width, pose_.height, surroundings.haze);
    fragments_.eye_m = fragments_.camera.eye_m;
    fragments_.pixels_per_rad = pixels_per_rad(fragments_.camera);
}

bool GBuffer::shows(const Pose& pose, const Surroundings& surroundings) const {
    return is_whole_ && stands_at(pose) && is_surrounded_by(surroundings);
}

bool GBuffer::update(const StageModel& model) {
    CHECK(is_whole_);
    if (model.still_revision() != still_revision_) {
        draw(model, pose_, surroundings_);
        return true;
    }
    const MovingPlan moving = plan_moving(model);
    changed_ = moving.tiles.rects();
    if (moving.tiles.empty()) return false;
    const std::uint32_t dropped = dropped_pixels_;
    commands_.begin();
    draw_moving(model, moving);
    gather(&moving.tiles);
    submit();
    extras_moved_ = dropped_pixels_ > dropped;
    if (extras_moved_) {
        // All fragments move together again; what they are does not change.
        commands_.begin();
        gather(nullptr);
        submit();
    }
    warn_of_dropped();
    return true;
}

void GBuffer::warn_of_dropped() {
    if (dropped_pixels_ == 0 || std::exchange(warned_, true)) return;
    log_warning(std::to_string(dropped_pixels_) +
                " pixels on edges show only their main surface: more than " + std::to_string(capacity_) +
                " extra fragments");
}

void GBuffer::submit() {
    commands_.submit_and_wait();
    spans_ = commands_.spans();
    shared::GatherCounts counts;
    std::memcpy(&counts, counts_read_.mapped(), sizeof counts);
    fragments_.blocks = counts.groups[0];
    fragments_.edge_count = std::min(counts.edges, fragments_.width * fragments_.height);
    extra_count_ = counts.used;
    dropped_pixels_ = counts.dropped;
}

GBuffer::MovingPlan GBuffer::plan_moving(const StageModel& model) {
    MovingPlan plan{TileSet(pose_.width, pose_.height), {}};
    if (!model.has_moving()) return plan;
    const Axes axes = axes_of(pose_);
    const std::vector<StageModel::MovingDraw> placed =
        model.visible_moving(axes.eye_m, planes_of(axes), fragments_.pixels_per_rad);
    std::map<std::size_t, Shown> shown;
    for (const StageModel::MovingDraw& one : placed) {
        const PixelRect rect = pixels_of(one.corners_m, to_clip(axes), pose_.width, pose_.height);
        if (rect.empty()) continue;
        const Shown& fresh = shown[one.instance] = {one.draw.to_eye, one.draw.glow_cd_m2, rect};
        const auto before = shown_.find(one.instance);
        if (before == shown_.end() || !before->second.looks_as(fresh)) plan.tiles.add(rect);
    }
    for (const auto& [instance, before] : shown_) {
        const auto now = shown.find(instance);
        if (now == shown.end() || !now->second.looks_as(before)) plan.tiles.add(before.rect);
    }
    shown_ = std::move(shown);
    for (const StageModel::MovingDraw& one : placed) {
        const auto now = shown_.find(one.instance);
        if (now != shown_.end() && plan.tiles.meets(now->second.rect)) plan.draws.push_back(one.draw);
    }
    return plan;
}

void GBuffer::draw_moving(const StageModel& model, const MovingPlan& plan) {
    if (plan.tiles.empty()) return;
    const Samples& shown = target().shown;
    Samples& hidden = target().hidden;
    if (!hidden.depth.image()) hidden = make_samples();
    TileSet fresh = plan.tiles;
    fresh.remove(saved_);
    TileSet known = plan.tiles;
    known.remove(fresh);
    saved_.add(fresh);
    const std::vector<VkRect2D> to_save = regions(fresh), to_restore = regions(known);
    commands_.begin_span("restore");
    for (std::size_t k = 0; k < shown.all().size(); ++k) {
        commands_.copy(*shown.all()[k], *hidden.all()[k], to_save);
        commands_.copy(*hidden.all()[k], *shown.all()[k], to_restore);
    }
    commands_.begin_span("moving");
    // Without a scissor: beyond these tiles they stand already, at the same depth, and do not win again.
    draw_meshes(model, plan.draws, gpu::Before::kept);
}

const gpu::Raster& GBuffer::raster_for(const StageModel::Surface& surface) {
    const std::uint32_t samples = samples_of(pose_);
    std::unique_ptr<gpu::Raster>& raster = rasters_[samples << 16 | surface.alpha << 8 | surface.textures];
    const gpu::Shader& opaque = shaders::kShader_g_buffer_frag;
    const gpu::Shader& cut = shaders::kShader_g_buffer_cut_frag;
    if (!raster)
        raster = std::make_unique<gpu::Raster>(device_, shaders::kShader_g_buffer_vert,
                                               surface.alpha == shared::kOpaque ? opaque : cut,
                                               raster_shape(surface.alpha, surface.textures, samples));
    return *raster;
}

void GBuffer::draw_meshes(const StageModel& model, std::span<const StageModel::Draw> draws,
                          gpu::Before before) {
    const glm::mat4 eye_to_clip = to_clip(axes_of(pose_));
    Samples& shown = target().shown;
    if (!shown.depth.image()) shown = make_samples();
    gpu::begin_drawing(commands_, {&shown.base, &shown.normal, &shown.emission, &shown.metalness},
                       shown.depth, before);
    gpu::use_vertices(commands_, model.vertices(), model.indices());
    const StageModel::Surface* used = nullptr;
    const gpu::Raster* raster = nullptr;
    for (const StageModel::Draw& draw : draws) {
        const StageModel::Surface& surface = model.surface_of(draw.mesh);
        if (used != &surface) {
            used = &surface;
            raster = &raster_for(surface);
            gpu::use_raster(commands_, *raster);
            gpu::use_bindings(commands_, device_, *raster,
                              shaders::GBufferFragBindings{
                                  .base_texture = gpu::sampled(model.texture(surface.texture[0])),
                                  .normal_texture = gpu::sampled(model.texture(surface.texture[1])),
                                  .surface_texture = gpu::sampled(model.texture(surface.texture[2])),
                                  .emission_texture = gpu::sampled(model.texture(surface.texture[3])),
                                  .material = gpu::uniform(model.materials(), surface.offset)});
        }
        shared::MeshPush push{};
        const glm::mat4 mesh_to_clip = eye_to_clip * draw.to_eye;
        for (int k = 0; k < 4; ++k) push.to_clip[k] = mesh_to_clip[k];
        for (int k = 0; k < 3; ++k) push.axis[k] = glm::vec3(draw.to_eye[k]);
        push.glow = draw.glow_cd_m2;
        gpu::push_constants(commands_, *raster, &push, sizeof push);
        gpu::draw_triangles(commands_, model.range(draw));
    }
    gpu::end_drawing(commands_);
}

void GBuffer::gather(const TileSet* tiles) {
    const shared::View& view = fragments_.camera;
    const std::uint32_t tile_count = fragments_.tiles_x * fragments_.tiles_y;
    const float pixel_m = 2.0f * glm::length(view.up) / static_cast<float>(view.height);
    const shared::GatherPush push{surroundings_.ambient, capacity_, tile_count,
                                  fragments_.tiles_x,    pixel_m,   tiles ? 1u : 0u,
                                  surroundings_.work_lux};
    commands_.begin_span("gather");
    std::uint32_t groups_x = fragments_.tiles_x, groups_y = fragments_.tiles_y;
    if (tiles) {
        const std::vector<std::uint32_t> list = tiles->list();
        std::memcpy(tile_list_.mapped(), list.data(), list.size() * sizeof list[0]);
        groups_x = static_cast<std::uint32_t>(list.size());
        groups_y = 1;
        commands_.write(block_list_, std::vector<shared::BlockListHead>{{{0, 1, 1}, 0}});
    } else {
        commands_.write(fragments_.view, std::vector{view});
        commands_.write(counts_, std::vector<shared::GatherCounts>{{{0, 1, 1}, 0, 0, 0, 0, 0}});
    }
    const Samples& shown = target().shown;
    commands_.dispatch(gather_[pose_.single ? 1 : 0].get(), push,
                       shaders::GatherBindings{.view = gpu::uniform(fragments_.view),
                                               .depths = gpu::sampled(shown.depth),
                                               .bases = gpu::sampled(shown.base),
                                               .normals = gpu::sampled(shown.normal),
                                               .emissions = gpu::sampled(shown.emission),
                                               .metals = gpu::sampled(shown.metalness),
                                               .places = gpu::stored(fragments_.places),
                                               .diffuse = gpu::stored(diffuse_),
                                               .specular = gpu::stored(specular_),
                                               .shown_normals = gpu::stored(normals_),
                                               .base = gpu::stored(fragments_.base),
                                               .tile_bounds = gpu::storage(fragments_.tile_bounds),
                                               .rooms = gpu::storage(rooms_),
                                               .tile_list = gpu::storage(tile_list_),
                                               .edges = gpu::stored(fragments_.edges),
                                               .counts = gpu::storage(counts_),
                                               .block_list = gpu::storage(block_list_)},
                       groups_x, groups_y);
    commands_.barrier();
    commands_.begin_span("blocks");
    commands_.dispatch_indirect(
        block_bounds_, push,
        shaders::BlockBoundsBindings{.view = gpu::uniform(fragments_.view),
                                     .places = gpu::stored(fragments_.places),
                                     .tile_bounds = gpu::storage(fragments_.tile_bounds),
                                     .counts = gpu::storage(counts_),
                                     .block_list = gpu::storage(block_list_)},
        tiles ? block_list_ : counts_, 0);
    commands_.barrier();
    commands_.copy(counts_, counts_read_, sizeof(shared::GatherCounts));
}

std::uint64_t GBuffer::memory_bytes() const {
    std::uint64_t sum = 0;
    for (const gpu::Buffer* buffer : {&fragments_.view, &fragments_.tile_bounds, &counts_, &counts_read_,
                                      &rooms_, &tile_list_, &block_list_})
        sum += buffer->bytes();
    for (const gpu::Texture* texture :
         {&fragments_.places, &fragments_.edges, &fragments_.base, &diffuse_, &specular_, &normals_})
        sum += texture->bytes();
    for (const Target& target : targets_)
        for (const Samples* samples : {&target.shown, &target.hidden})
            for (const gpu::Texture* texture : samples->all()) sum += texture->bytes();
    return sum;
}

} // namespace ghost::render
