// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/pass_images.h"

#include "base/check.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "render/geometry/layout.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace ghost::render {
namespace {

gpu::Texture radiance_of(const gpu::Device& device, const scene::Passes& passes, const Layout& layout,
                         std::uint32_t width, std::uint32_t rows) {
    const auto layers = static_cast<std::uint32_t>(passes.lights.size()) + 1;
    gpu::Texture texture(device, {width, rows, layers, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    std::vector<std::uint64_t> radiance(static_cast<std::size_t>(rows) * width); // four half floats each
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        std::fill(radiance.begin(), radiance.end(), std::uint64_t{0});
        if (layer + 1 < layers && !passes.lights[layer].radiance.empty()) {
            const std::vector<std::uint16_t>& from = passes.lights[layer].radiance;
            CHECK_EQ(from.size(), passes.fragment_count() * 4);
            for (std::size_t i = 0; i < layout.order.size(); ++i)
                std::memcpy(&radiance[i], &from[std::size_t{4} * layout.order[i]], sizeof radiance[i]);
        }
        texture.write_layer(layer, radiance.data(), radiance.size() * sizeof(std::uint64_t));
    }
    return texture;
}

gpu::Texture bounces_of(const gpu::Device& device, const scene::Passes& passes) {
    const bool any = std::any_of(passes.lights.begin(), passes.lights.end(),
                                 [](const scene::LightPass& pass) { return !pass.indirect.empty(); });
    if (!any) return {};
    const auto layers = static_cast<std::uint32_t>(passes.lights.size()) + 1;
    gpu::Texture texture(device,
                         {static_cast<std::uint32_t>(passes.width), static_cast<std::uint32_t>(passes.height),
                          layers, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    const std::vector<std::uint16_t> none(passes.pixel_count() * 4, 0);
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        const bool has = layer + 1 < layers && !passes.lights[layer].indirect.empty();
        const std::vector<std::uint16_t>& from = has ? passes.lights[layer].indirect : none;
        CHECK_EQ(from.size(), none.size());
        texture.write_layer(layer, from.data(), from.size() * sizeof(std::uint16_t));
    }
    return texture;
}

SeenBox seen_in(const scene::Passes& passes, const glm::vec3& eye_m) {
    SeenBox box{eye_m, eye_m, true};
    for (const glm::vec4& fragment : passes.fragments) {
        box.closed = box.closed && fragment.w >= 0;
        box.low_m = glm::min(box.low_m, glm::vec3(fragment));
        box.high_m = glm::max(box.high_m, glm::vec3(fragment));
    }
    return box;
}

// Whole blocks, so that the last one needs no bound.
std::uint64_t rows_of(const scene::Passes& passes) {
    const std::uint64_t extra = passes.fragment_count() - passes.pixel_count();
    const auto width = static_cast<std::uint64_t>(passes.width);
    const std::uint64_t texels =
        (extra + shared::kTilePixels - 1) / shared::kTilePixels * shared::kTilePixels;
    return static_cast<std::uint64_t>(passes.height) + (texels + width - 1) / width;
}

} // namespace

std::string beyond_device(const gpu::Device& device, const scene::Passes& passes) {
    return gpu::beyond_limits(device.limits(), static_cast<std::uint64_t>(passes.width), rows_of(passes),
                              passes.lights.size() + 1);
}

PassImages make_pass_images(const gpu::Device& device, const scene::Passes& passes, const glm::vec3& ambient,
                            const shared::Haze& haze) {
    PassImages images;
    Fragments& f = images.fragments;
    f.width = static_cast<std::uint32_t>(passes.width);
    f.height = static_cast<std::uint32_t>(passes.height);
    f.tiles_x = gpu::groups(f.width, shared::kTileWidth);
    f.tiles_y = gpu::groups(f.height, shared::kTileHeight);
    const shared::View view = make_view(passes, haze);
    f.view = gpu::Buffer(device, sizeof view, gpu::Access::device);
    f.view.write(&view, sizeof view);
    f.camera = view;
    f.eye_m = view.eye_m;
    f.pixels_per_rad = pixels_per_rad(view);
    f.seen = seen_in(passes, view.eye_m);
    const Layout layout = make_layout(passes, f.tiles_x, f.tiles_y);
    f.blocks = layout.blocks;
    f.edge_count = static_cast<std::uint32_t>(layout.edges.size());
    f.tile_bounds = gpu::Buffer(device, layout.bounds.size() * sizeof(glm::vec4), gpu::Access::device);
    f.tile_bounds.write(layout.bounds);
    std::vector<std::uint64_t> base; // four half floats each
    for (const glm::vec4& light : base_image(passes, ambient, haze))
        base.push_back(glm::packHalf4x16(glm::min(light, glm::vec4(shared::kMostLight))));
    f.base = gpu::Texture(device, {f.width, f.height, 1, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    f.base.write(0, base.data(), base.size() * sizeof(std::uint64_t));
    std::vector<glm::uvec2> edges = layout.edges;
    const std::uint32_t edge_rows = std::max(gpu::groups(f.edge_count, f.width), 1u);
    edges.resize(static_cast<std::size_t>(edge_rows) * f.width);
    f.edges = gpu::Texture(device, {f.width, edge_rows, 1, 1, VK_FORMAT_R32G32_UINT, true, false});
    f.edges.write(0, edges.data(), edges.size() * sizeof(glm::uvec2));
    const auto rows = static_cast<std::uint32_t>(rows_of(passes)); // what no fragment fills is no surface
    std::vector<glm::vec4> places(static_cast<std::size_t>(rows) * f.width, glm::vec4(0, 0, 0, -1));
    for (std::size_t i = 0; i < layout.order.size(); ++i) places[i] = passes.fragments[layout.order[i]];
    f.places = gpu::Texture(device, {f.width, rows, 1, 1, VK_FORMAT_R32G32B32A32_SFLOAT, true, false});
    f.places.write(0, places.data(), places.size() * sizeof(glm::vec4));

    images.radiance = radiance_of(device, passes, layout, f.width, rows);
    images.bounces = bounces_of(device, passes);
    return images;
}

} // namespace ghost::render
