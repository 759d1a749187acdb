// SPDX-License-Identifier: Apache-2.0
#include "render/relight/room_light.h"

#include "render/relight/planes.h"
#include "shaders/glow.h"
#include "shaders/room_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace ghost::render {
namespace {

constexpr std::uint32_t kRoomGroup = 8; // pixels or rays a side
constexpr float kSliceOfCell = 0.75f;   // as long as slices are
constexpr std::uint32_t kLeastSlices = 8;

std::size_t layers_of(const scene::BounceVolume& volume) {
    const std::size_t layer =
        static_cast<std::size_t>(volume.size.x) * static_cast<std::size_t>(volume.size.y);
    return volume.texels.size() / std::max<std::size_t>(layer, 1);
}

} // namespace

RoomLight::RoomLight(const gpu::Device& device)
    : device_(device), glow_program_(device, shaders::kShader_glow),
      program_(device, shaders::kShader_room_light), uploads_(device) {}

std::string RoomLight::beyond_device(const gpu::Device& device, const scene::BounceVolumes& volumes) {
    for (const scene::BounceVolume* volume : {&volumes.surfaces, &volumes.air, &volumes.glow}) {
        const std::string beyond =
            gpu::beyond_limits(device.limits(), static_cast<std::uint64_t>(volume->size.x),
                               static_cast<std::uint64_t>(volume->size.y), layers_of(*volume));
        if (!beyond.empty()) return beyond;
    }
    return "";
}

void RoomLight::make(const scene::BounceVolume& volume, gpu::Texture& texture) const {
    const auto width = static_cast<std::uint32_t>(volume.size.x),
               height = static_cast<std::uint32_t>(volume.size.y);
    const auto layers = static_cast<std::uint32_t>(layers_of(volume));
    const gpu::TextureShape& before = texture.shape();
    if (texture.bytes() == 0 || before.width != width || before.height != height || before.layers != layers)
        texture =
            gpu::Texture(device_, {width, height, layers, 1, VK_FORMAT_R16G16B16A16_SFLOAT, false, true});
}

void RoomLight::upload(const scene::BounceVolume& volume, const gpu::Texture& texture) {
    const gpu::TextureShape& shape = texture.shape();
    const std::size_t layer_texels = std::size_t{shape.width} * shape.height;
    for (std::uint32_t layer = 0; layer < shape.layers; ++layer)
        uploads_.add(texture, layer, 0, &volume.texels[layer * layer_texels], sizeof volume.texels[0]);
}

void RoomLight::set(std::shared_ptr<const scene::BounceVolumes> volumes, bool on_processor) {
    volumes_ = std::move(volumes);
    if (on_processor) return;
    const std::array<std::pair<const scene::BounceVolume&, gpu::Texture&>, 3> all{
        {{volumes_->surfaces, surfaces_}, {volumes_->air, air_}, {volumes_->glow, glow_}}};
    // All of them before anything waits to be copied: memory may end at each.
    for (const auto& [volume, texture] : all) make(volume, texture);
    for (const auto& [volume, texture] : all) upload(volume, texture);
    uploads_.finish();
}

shared::RoomLightPush RoomLight::push_of(const Fragments& f, bool as_lux) const {
    shared::RoomLightPush push{};
    push.low_m = volumes_->low_m;
    push.surfel_m = volumes_->surfel_m;
    push.surfels = glm::vec3(volumes_->surfaces.size);
    push.cell_m = volumes_->cell_m;
    push.cells = glm::vec3(volumes_->air.size);
    const glm::vec3 high_m = push.low_m + push.cells * push.cell_m;
    const glm::vec3 outside = glm::max(glm::max(push.low_m - f.eye_m, f.eye_m - high_m), glm::vec3(0));
    push.near_m = glm::length(outside);
    const float far_m = glm::length(glm::max(glm::abs(high_m - f.eye_m), glm::abs(push.low_m - f.eye_m)));
    const float wanted = std::ceil((far_m - push.near_m) / (kSliceOfCell * push.cell_m));
    push.slices =
        std::clamp(static_cast<std::uint32_t>(wanted), kLeastSlices, shared::kMostGlowSlices - 1) + 1;
    push.slice_m = (far_m - push.near_m) / static_cast<float>(push.slices - 1);
    push.glow_width = (f.width + shared::kGlowStep - 1) / shared::kGlowStep + 1;
    push.glow_height = (f.height + shared::kGlowStep - 1) / shared::kGlowStep + 1;
    push.as_lux = as_lux ? 1 : 0;
    return push;
}

RoomPlanes RoomLight::planes(const GBuffer& g_buffer, bool as_lux) const {
    const Fragments& f = g_buffer.fragments();
    RoomPlanes planes{.view = f.camera,
                      .room = push_of(f, as_lux),
                      .volumes = volumes_.get(),
                      .places = plane_of(f.places),
                      .normals = plane_of(g_buffer.normals()),
                      .diffuse = plane_of(g_buffer.diffuse()),
                      .specular = plane_of(g_buffer.specular()),
                      .edges = plane_of(f.edges)};
    planes.room.edges = f.edge_count;
    return planes;
}

void RoomLight::record(gpu::Commands& commands, const GBuffer& g_buffer, bool as_lux,
                       const gpu::Texture& frame) {
    const Fragments& f = g_buffer.fragments();
    shared::RoomLightPush push = push_of(f, as_lux);
    const gpu::TextureShape& before = slices_.shape();
    if (slices_.bytes() == 0 || before.width != push.glow_width || before.height != push.glow_height)
        slices_ = gpu::Texture(device_, {push.glow_width, push.glow_height, shared::kMostGlowSlices, 1,
                                         VK_FORMAT_R16G16B16A16_SFLOAT, true, true});
    if (!as_lux) {
        commands.begin_span("glow");
        commands.dispatch(
            glow_program_.get(), push,
            shaders::GlowBindings{
                .view = gpu::uniform(f.view), .glow = gpu::sampled(glow_), .slices = gpu::stored(slices_)},
            gpu::groups(push.glow_width, kRoomGroup), gpu::groups(push.glow_height, kRoomGroup));
        commands.barrier();
    }
    commands.begin_span("room light");
    const shaders::RoomLightBindings bindings{.view = gpu::uniform(f.view),
                                              .places = gpu::stored(f.places),
                                              .normals = gpu::stored(g_buffer.normals()),
                                              .diffuse = gpu::stored(g_buffer.diffuse()),
                                              .specular = gpu::stored(g_buffer.specular()),
                                              .edges = gpu::sampled(f.edges),
                                              .surfaces = gpu::sampled(surfaces_),
                                              .air = gpu::sampled(air_),
                                              .slices = gpu::sampled(slices_),
                                              .frame = gpu::stored(frame)};
    commands.dispatch(program_.get(), push, bindings, gpu::groups(f.width, kRoomGroup),
                      gpu::groups(f.height, kRoomGroup));
    commands.barrier();
    if (f.edge_count == 0) return;
    push.edges = f.edge_count;
    commands.dispatch(program_.get(), push, bindings, gpu::groups(f.edge_count, kRoomGroup * kRoomGroup));
    commands.barrier();
}

std::uint64_t RoomLight::memory_bytes() const {
    std::size_t texels = glow_slices_.capacity();
    if (volumes_)
        texels +=
            volumes_->surfaces.texels.size() + volumes_->air.texels.size() + volumes_->glow.texels.size();
    return surfaces_.bytes() + air_.bytes() + glow_.bytes() + slices_.bytes() +
           sizeof glow_slices_[0] * texels;
}

} // namespace ghost::render
