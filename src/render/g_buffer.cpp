// SPDX-License-Identifier: Apache-2.0
#include "render/g_buffer.h"

#include "base/check.h"
#include "base/log.h"
#include "render/layout.h"
#include "shaders/block_bounds.h"
#include "shaders/g_buffer_cut_frag.h"
#include "shaders/g_buffer_frag.h"
#include "shaders/g_buffer_vert.h"
#include "shaders/gather.h"
#include "shared/g_buffer.h"
#include "shared/push.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>

namespace ghost::render {
namespace {

constexpr VkDescriptorType kUniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType kStorage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType kSampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType kStored = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
constexpr VkFormat kHalves = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat kFloats = VK_FORMAT_R32G32B32A32_SFLOAT;

std::uint32_t groups(std::uint32_t items, std::uint32_t size) {
    return (items + size - 1) / size;
}

gpu::Texture attachment(const gpu::Device& device, std::uint32_t width, std::uint32_t height,
                        VkFormat format) {
    gpu::TextureShape shape{width, height, 1, 1, format};
    shape.attachment = true;
    shape.samples = shared::kSamples;
    return {device, shape};
}

gpu::Texture stored(const gpu::Device& device, std::uint32_t width, std::uint32_t height, VkFormat format) {
    return {device, {width, height, 1, 1, format, true, false}};
}

gpu::RasterShape raster_shape(std::uint32_t alpha, std::uint32_t textures) {
    gpu::RasterShape shape;
    shape.inputs = {
        {VK_FORMAT_R32G32B32_SFLOAT, offsetof(StageVertex, position_m)},
        {VK_FORMAT_R16G16B16A16_SNORM, offsetof(StageVertex, normal)},
        {VK_FORMAT_R16G16B16A16_SNORM, offsetof(StageVertex, tangent)},
        {VK_FORMAT_R32G32_SFLOAT, offsetof(StageVertex, uv)},
    };
    shape.vertex_stride = sizeof(StageVertex);
    shape.bindings = {kSampled, kSampled, kSampled, kSampled, kUniform};
    shape.constants = {alpha, textures};
    shape.colours = {kHalves, kHalves, kHalves, VK_FORMAT_R8_UNORM};
    shape.samples = shared::kSamples;
    return shape;
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

bool finite(const Pose& pose) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(pose.camera_to_world[column][row])) return false;
    return pose.fov_y_deg > 0 && pose.fov_y_deg < 180;
}

} // namespace

GBuffer::GBuffer(const gpu::Device& device, int width, int height)
    : device_(device), gather_(device, shaders::kShader_gather,
                               {kUniform, kSampled, kSampled, kSampled, kSampled, kSampled, kStored, kStored,
                                kStored, kStored, kStored, kStored, kStorage, kStorage}),
      block_bounds_(device, shaders::kShader_block_bounds, {kUniform, kStored, kStorage, kStorage}),
      commands_(device) {
    using gpu::Access;
    using gpu::Buffer;
    CHECK(width > 0 && height > 0);
    const auto w = static_cast<std::uint32_t>(width);
    const auto h = static_cast<std::uint32_t>(height);
    capacity_ = groups(w * h, shared::kTilePixels) * shared::kTilePixels;
    fragments_.width = w;
    fragments_.height = h;
    fragments_.tiles_x = groups(w, shared::kTileWidth);
    fragments_.tiles_y = groups(h, shared::kTileHeight);
    fragments_.view = Buffer(device, sizeof(shared::View), Access::device);
    const std::uint32_t rows = h + groups(capacity_, w);
    fragments_.places = stored(device, w, rows, kFloats);
    fragments_.edges = stored(device, w, h, VK_FORMAT_R32G32_UINT);
    fragments_.base = stored(device, w, h, kFloats);
    const std::uint64_t bounds =
        std::uint64_t{fragments_.tiles_x} * fragments_.tiles_y + capacity_ / shared::kTilePixels;
    fragments_.tile_bounds = Buffer(device, bounds * 2 * sizeof(glm::vec4), Access::device);
    diffuse_ = stored(device, w, rows, kHalves);
    specular_ = stored(device, w, rows, kHalves);
    normals_ = stored(device, w, rows, kHalves);
    sample_depth_ = attachment(device, w, h, VK_FORMAT_D32_SFLOAT);
    sample_base_ = attachment(device, w, h, kHalves);
    sample_normal_ = attachment(device, w, h, kHalves);
    sample_emission_ = attachment(device, w, h, kHalves);
    sample_metalness_ = attachment(device, w, h, VK_FORMAT_R8_UNORM);
    counts_ = Buffer(device, sizeof(shared::GatherCounts), Access::device);
    counts_read_ = Buffer(device, sizeof(shared::GatherCounts), Access::readback);
}

void GBuffer::draw(const StageModel& model, const Pose& pose, const Surroundings& surroundings) {
    CHECK_EQ(static_cast<std::uint32_t>(pose.width), fragments_.width);
    CHECK_EQ(static_cast<std::uint32_t>(pose.height), fragments_.height);
    CHECK(finite(pose));
    const shared::View view =
        make_view(pose.camera_to_world, pose.fov_y_deg, pose.width, pose.height, surroundings.haze);
    fragments_.camera = view;
    fragments_.eye_m = view.eye_m;
    fragments_.pixels_per_rad = pixels_per_rad(view);
    commands_.begin();
    draw_meshes(model, pose);
    gather(view, surroundings.ambient);
    commands_.submit_and_wait();
    spans_ = commands_.spans();

    shared::GatherCounts counts;
    std::memcpy(&counts, counts_read_.mapped(), sizeof counts);
    fragments_.blocks = counts.groups[0];
    fragments_.edge_count = counts.edges;
    extra_count_ = counts.used;
    dropped_pixels_ = counts.dropped;
    if (counts.dropped > 0 && !warned_)
        log_warning(std::to_string(counts.dropped) +
                    " pixels on edges show only their main surface: more than " + std::to_string(capacity_) +
                    " extra fragments");
    warned_ = warned_ || counts.dropped > 0;
}

const gpu::Raster& GBuffer::raster_for(const StageModel::Surface& surface) {
    std::unique_ptr<gpu::Raster>& raster = rasters_[surface.alpha << 8 | surface.textures];
    const std::span<const std::uint32_t> opaque = shaders::kShader_g_buffer_frag;
    const std::span<const std::uint32_t> cut = shaders::kShader_g_buffer_cut_frag;
    if (!raster)
        raster = std::make_unique<gpu::Raster>(device_, shaders::kShader_g_buffer_vert,
                                               surface.alpha == shared::kOpaque ? opaque : cut,
                                               raster_shape(surface.alpha, surface.textures));
    return *raster;
}

void GBuffer::draw_meshes(const StageModel& model, const Pose& pose) {
    const Axes axes = axes_of(pose);
    const std::vector<glm::vec4> planes{
        glm::vec4(axes.forward, -shared::kNear_m),
        glm::vec4(axes.forward * axes.tan_x - axes.right, 0.0f),
        glm::vec4(axes.forward * axes.tan_x + axes.right, 0.0f),
        glm::vec4(axes.forward * axes.tan_y - axes.up, 0.0f),
        glm::vec4(axes.forward * axes.tan_y + axes.up, 0.0f),
    };
    glm::mat4 to_clip(0.0f);
    for (int k = 0; k < 3; ++k)
        to_clip[k] = glm::vec4(axes.right[k] / axes.tan_x, -axes.up[k] / axes.tan_y, 0.0f, axes.forward[k]);
    to_clip[3] = glm::vec4(0.0f, 0.0f, shared::kNear_m, 0.0f);

    commands_.begin_span("raster");
    gpu::begin_drawing(commands_, {&sample_base_, &sample_normal_, &sample_emission_, &sample_metalness_},
                       sample_depth_);
    gpu::use_vertices(commands_, model.vertices(), model.indices());
    const StageModel::Surface* used = nullptr;
    const gpu::Raster* raster = nullptr;
    for (const StageModel::Draw& draw : model.visible(axes.eye_m, planes)) {
        const StageModel::Surface& surface = model.surface_of(draw.mesh);
        if (used != &surface) {
            used = &surface;
            raster = &raster_for(surface);
            gpu::use_raster(commands_, *raster);
            gpu::use_bindings(commands_, device_, *raster,
                              {gpu::sampled(model.texture(surface.texture[0])),
                               gpu::sampled(model.texture(surface.texture[1])),
                               gpu::sampled(model.texture(surface.texture[2])),
                               gpu::sampled(model.texture(surface.texture[3])),
                               gpu::uniform(model.materials(), surface.offset)});
        }
        shared::MeshPush push{};
        const glm::mat4 mesh_to_clip = to_clip * draw.to_eye;
        for (int k = 0; k < 4; ++k) push.to_clip[k] = mesh_to_clip[k];
        for (int k = 0; k < 3; ++k) push.axis[k] = glm::vec3(draw.to_eye[k]);
        gpu::push_constants(commands_, *raster, &push, sizeof push);
        gpu::draw_triangles(commands_, model.range(draw.mesh));
    }
    gpu::end_drawing(commands_);
}

void GBuffer::gather(const shared::View& view, const glm::vec3& ambient) {
    const std::uint32_t tiles = fragments_.tiles_x * fragments_.tiles_y;
    const float pixel_m = 2.0f * glm::length(view.up) / static_cast<float>(view.height);
    const shared::GatherPush push{ambient, capacity_, tiles, fragments_.tiles_x, pixel_m};
    commands_.begin_span("gather");
    commands_.write(fragments_.view, std::vector{view});
    commands_.write(counts_, std::vector<shared::GatherCounts>{{{0, 1, 1}, 0, 0, 0, 0, 0}});
    commands_.dispatch(gather_, push,
                       {gpu::uniform(fragments_.view), gpu::sampled(sample_depth_),
                        gpu::sampled(sample_base_), gpu::sampled(sample_normal_),
                        gpu::sampled(sample_emission_), gpu::sampled(sample_metalness_),
                        gpu::stored(fragments_.places), gpu::stored(diffuse_), gpu::stored(specular_),
                        gpu::stored(normals_), gpu::stored(fragments_.base), gpu::stored(fragments_.edges),
                        gpu::storage(fragments_.tile_bounds), gpu::storage(counts_)},
                       fragments_.tiles_x, fragments_.tiles_y);
    commands_.barrier();
    commands_.begin_span("blocks");
    commands_.dispatch_indirect(block_bounds_, push,
                                {gpu::uniform(fragments_.view), gpu::stored(fragments_.places),
                                 gpu::storage(fragments_.tile_bounds), gpu::storage(counts_)},
                                counts_, 0);
    commands_.barrier();
    commands_.copy(counts_, counts_read_, sizeof(shared::GatherCounts));
}

std::uint64_t GBuffer::memory_bytes() const {
    std::uint64_t sum = 0;
    for (const gpu::Buffer* buffer : {&fragments_.view, &fragments_.tile_bounds, &counts_, &counts_read_})
        sum += buffer->bytes();
    for (const gpu::Texture* texture :
         {&fragments_.places, &fragments_.edges, &fragments_.base, &diffuse_, &specular_, &normals_,
          &sample_depth_, &sample_base_, &sample_normal_, &sample_emission_, &sample_metalness_})
        sum += texture->bytes();
    return sum;
}

} // namespace ghost::render
