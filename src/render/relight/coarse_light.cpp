// SPDX-License-Identifier: Apache-2.0
#include "render/relight/coarse_light.h"

#include "render/geometry/layout.h"
#include "render/relight/planes.h"
#include "shaders/coarse_cells.h"
#include "shaders/coarse_extras.h"
#include "shaders/coarse_fold.h"
#include "shaders/coarse_points.h"
#include "shaders/coarse_spread.h"
#include "shared/coarse.h"
#include "shared/g_buffer.h"
#include "shared/push.h"

#include <algorithm>
#include <cstring>

namespace ghost::render {
namespace {

constexpr VkFormat kHalves = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat kWords = VK_FORMAT_R32G32B32A32_UINT;
constexpr std::uint32_t kEdgesPerGroup = 64;               // coarse_extras.comp, coarse_fold.comp
constexpr std::uint32_t kSpreadSide = 8;                   // coarse_spread.comp
constexpr std::uint32_t kPointLayers = 2, kCellLayers = 3; // shared/coarse.h

gpu::Texture stored(const gpu::Device& device, std::uint32_t width, std::uint32_t height, VkFormat format,
                    std::uint32_t layers = 1) {
    return {device, {width, height, layers, 1, format, true, false}};
}

std::uint32_t tiles_over(std::uint32_t width, std::uint32_t height) {
    return gpu::groups(width, shared::kTileWidth) * gpu::groups(height, shared::kTileHeight);
}

gpu::Buffer list_of(const gpu::Device& device, std::uint32_t tiles) {
    return {device, std::uint64_t{tiles} * sizeof(std::uint32_t), gpu::Access::upload};
}

// Returns how many there are.
std::uint32_t write_list(const gpu::Buffer& to, const TileSet& tiles) {
    const std::vector<std::uint32_t> list = tiles.list();
    std::memcpy(to.mapped(), list.data(), list.size() * sizeof list[0]);
    return static_cast<std::uint32_t>(list.size());
}

} // namespace

CoarseLight::CoarseLight(const gpu::Device& device, const GBuffer& g_buffer)
    : g_buffer_(g_buffer), make_points_(device, shaders::kShader_coarse_points),
      make_cells_(device, shaders::kShader_coarse_cells),
      make_extras_(device, shaders::kShader_coarse_extras), spread_(device, shaders::kShader_coarse_spread),
      fold_(device, shaders::kShader_coarse_fold) {
    const Fragments& f = g_buffer.fragments();
    const std::uint32_t w = (f.width + 1) / 2, h = (f.height + 1) / 2;
    points_.width = w;
    points_.height = h;
    points_.tiles_x = gpu::groups(w, shared::kTileWidth);
    points_.tiles_y = gpu::groups(h, shared::kTileHeight);
    points_.view = gpu::Buffer(device, sizeof(shared::View), gpu::Access::device);
    points_.places = stored(device, w, h, VK_FORMAT_R32G32B32A32_SFLOAT);
    points_.edges = stored(device, 1, 1, VK_FORMAT_R32G32_UINT);
    points_.base = stored(device, 1, 1, kHalves);
    const std::uint32_t tiles = tiles_over(w, h), cell_tiles = tiles_over(w + 1, h + 1);
    points_.tile_bounds =
        gpu::Buffer(device, (std::uint64_t{tiles} + 1) * 2 * sizeof(glm::vec4), gpu::Access::device);
    rooms_ = gpu::Buffer(device, std::uint64_t{tiles} * sizeof(shared::TileRoom), gpu::Access::upload);
    std::memset(rooms_.mapped(), 0, rooms_.bytes());
    point_list_ = list_of(device, tiles);
    cell_list_ = list_of(device, cell_tiles);
    tile_list_ = list_of(device, tiles_over(f.width, f.height));
    diffuse_ = stored(device, w, h, kHalves);
    specular_ = stored(device, w, h, kHalves);
    normals_ = stored(device, w, h, kHalves);
    sums_ = stored(device, w, h, kWords, kPointLayers);
    cells_ = stored(device, w + 1, h + 1, kWords, kCellLayers);
    extras_ = stored(device, f.width, f.places.shape().height - f.height, kWords);
    forget();
}

void CoarseLight::forget() {
    const Fragments& f = g_buffer_.fragments();
    forgotten_ = true;
    points_.camera = f.camera;
    points_.camera.width = points_.width;
    points_.camera.height = points_.height;
    points_.eye_m = f.eye_m;
    points_.pixels_per_rad = f.pixels_per_rad / 2;
}

std::vector<PixelRect> CoarseLight::touch(const std::vector<PixelRect>& rects) {
    extras_moved_ = extras_moved_ || g_buffer_.extras_moved();
    const Fragments& f = g_buffer_.fragments();
    const auto set = [](TileSet& tiles, std::uint32_t width, std::uint32_t height) {
        if (tiles.empty()) tiles = TileSet(static_cast<int>(width), static_cast<int>(height));
    };
    set(stale_points_, points_.width, points_.height);
    set(stale_cells_, points_.width + 1, points_.height + 1);
    set(stale_tiles_, f.width, f.height);
    std::vector<PixelRect> points;
    for (const PixelRect& rect : rects) {
        const PixelRect one{rect.x0 / 2, rect.y0 / 2, (rect.x1 + 1) / 2, (rect.y1 + 1) / 2};
        points.push_back(one);
        stale_points_.add(one);
        // A point is a corner of four cells, and a cell has pixels beside it.
        stale_cells_.add({one.x0, one.y0, one.x1 + 1, one.y1 + 1});
        stale_tiles_.add({rect.x0 - 2, rect.y0 - 2, rect.x1 + 2, rect.y1 + 2});
    }
    return points;
}

void CoarseLight::update(gpu::Commands& commands) {
    const bool some = !stale_points_.empty();
    if (!forgotten_ && !some) return;
    commands.begin_span("points");
    const bool listed = !forgotten_;
    if (forgotten_) commands.write(points_.view, std::vector{points_.camera});
    record_points(commands, listed);
    record_cells(commands, listed);
    record_extras(commands, listed && !extras_moved_);
    forgotten_ = extras_moved_ = false;
    stale_points_ = stale_cells_ = stale_tiles_ = {};
}

shared::CoarsePush CoarseLight::push_of(std::uint32_t tiles_x, bool listed, std::uint32_t count) const {
    const Fragments& f = g_buffer_.fragments();
    return {tiles_x, listed ? 1u : 0u, count, f.width, f.height};
}

void CoarseLight::record_points(gpu::Commands& commands, bool listed) {
    const std::uint32_t count = listed ? write_list(point_list_, stale_points_) : 0;
    commands.dispatch(make_points_, push_of(points_.tiles_x, listed, count),
                      shaders::CoarsePointsBindings{.view = gpu::uniform(points_.view),
                                                    .places = gpu::stored(g_buffer_.fragments().places),
                                                    .diffuse = gpu::stored(g_buffer_.diffuse()),
                                                    .specular = gpu::stored(g_buffer_.specular()),
                                                    .normals = gpu::stored(g_buffer_.normals()),
                                                    .point_places = gpu::stored(points_.places),
                                                    .point_diffuse = gpu::stored(diffuse_),
                                                    .point_specular = gpu::stored(specular_),
                                                    .point_normals = gpu::stored(normals_),
                                                    .sums = gpu::stored(sums_),
                                                    .tile_bounds = gpu::storage(points_.tile_bounds),
                                                    .tile_list = gpu::storage(point_list_)},
                      listed ? count : points_.tiles_x, listed ? 1 : points_.tiles_y);
    commands.barrier();
}

void CoarseLight::record_cells(gpu::Commands& commands, bool listed) {
    const std::uint32_t tiles_x = gpu::groups(points_.width + 1, shared::kTileWidth),
                        tiles_y = gpu::groups(points_.height + 1, shared::kTileHeight);
    const std::uint32_t count = listed ? write_list(cell_list_, stale_cells_) : 0;
    commands.dispatch(make_cells_, push_of(tiles_x, listed, count),
                      shaders::CoarseCellsBindings{.view = gpu::uniform(g_buffer_.fragments().view),
                                                   .places = gpu::stored(g_buffer_.fragments().places),
                                                   .diffuse = gpu::stored(g_buffer_.diffuse()),
                                                   .specular = gpu::stored(g_buffer_.specular()),
                                                   .normals = gpu::stored(g_buffer_.normals()),
                                                   .point_places = gpu::stored(points_.places),
                                                   .point_normals = gpu::stored(normals_),
                                                   .cells = gpu::stored(cells_),
                                                   .tile_list = gpu::storage(cell_list_)},
                      listed ? count : tiles_x, listed ? 1 : tiles_y);
    commands.barrier();
}

void CoarseLight::record_extras(gpu::Commands& commands, bool listed) {
    const Fragments& f = g_buffer_.fragments();
    if (f.edge_count == 0) return;
    const std::uint32_t count = listed ? write_list(tile_list_, stale_tiles_) : f.edge_count;
    commands.dispatch(make_extras_, push_of(f.tiles_x, listed, count),
                      shaders::CoarseExtrasBindings{.view = gpu::uniform(f.view),
                                                    .places = gpu::stored(f.places),
                                                    .diffuse = gpu::stored(g_buffer_.diffuse()),
                                                    .specular = gpu::stored(g_buffer_.specular()),
                                                    .normals = gpu::stored(g_buffer_.normals()),
                                                    .point_places = gpu::stored(points_.places),
                                                    .point_normals = gpu::stored(normals_),
                                                    .edges = gpu::sampled(f.edges),
                                                    .extras = gpu::stored(extras_),
                                                    .tile_list = gpu::storage(tile_list_),
                                                    .rooms = gpu::storage(g_buffer_.rooms())},
                      listed ? count : gpu::groups(count, kEdgesPerGroup));
    commands.barrier();
}

void CoarseLight::spread(gpu::Commands& commands, const gpu::Texture& frame) {
    const Fragments& f = g_buffer_.fragments();
    commands.begin_span("light spread");
    commands.dispatch(spread_.get(), 0u,
                      shaders::CoarseSpreadBindings{.sums = gpu::stored(sums_),
                                                    .cells = gpu::stored(cells_),
                                                    .base = gpu::stored(f.base),
                                                    .frame = gpu::stored(frame)},
                      gpu::groups(points_.width + 1, kSpreadSide),
                      gpu::groups(points_.height + 1, kSpreadSide));
    commands.barrier();
    if (f.edge_count == 0) return;
    commands.begin_span("fold");
    commands.dispatch(fold_.get(), push_of(f.tiles_x, false, f.edge_count),
                      shaders::CoarseFoldBindings{.sums = gpu::stored(sums_),
                                                  .cells = gpu::stored(cells_),
                                                  .edges = gpu::sampled(f.edges),
                                                  .extras = gpu::stored(extras_),
                                                  .frame = gpu::stored(frame)},
                      gpu::groups(f.edge_count, kEdgesPerGroup));
    commands.barrier();
}

CoarsePlanes CoarseLight::planes() const {
    const Fragments& f = g_buffer_.fragments();
    return {.points = plane_of(sums_, shared::kCoarseLight),
            .surfaces = plane_of(cells_, shared::kCellSurfaces),
            .hazes = plane_of(cells_, shared::kCellHaze),
            .reflects = plane_of(cells_, shared::kCellReflects),
            .edges = plane_of(f.edges),
            .extras = plane_of(extras_),
            .edge_count = f.edge_count};
}

std::uint64_t CoarseLight::memory_bytes() const {
    std::uint64_t sum = 0;
    for (const gpu::Buffer* buffer :
         {&rooms_, &point_list_, &cell_list_, &tile_list_, &points_.view, &points_.tile_bounds})
        sum += buffer->bytes();
    for (const gpu::Texture* texture :
         {&diffuse_, &specular_, &normals_, &sums_, &cells_, &extras_, &points_.places})
        sum += texture->bytes();
    return sum;
}

} // namespace ghost::render
