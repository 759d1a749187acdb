// SPDX-License-Identifier: Apache-2.0
#include "render/haze/wide_beams.h"

#include "base/check.h"
#include "shaders/wide_prepare.h"
#include "shaders/wide_spread.h"
#include "shared/wide.h"

#include <algorithm>

namespace ghost::render {
namespace {

constexpr std::uint32_t kFinestStep = 2;
constexpr float kSeenAt_m = 4; // from the lamp
constexpr float kNearestEye_m = 0.5f;

} // namespace

bool is_wide(const shared::Light& light, const glm::vec3& eye_m, float pixels_per_rad) {
    const glm::vec3 place_m = light.position_m + kSeenAt_m * light.axis_w;
    const float distance_m = std::max(glm::distance(place_m, eye_m), kNearestEye_m);
    const float width_m = 2.0f * kSeenAt_m * light.tan_field * light.cut_radius;
    return width_m / distance_m * pixels_per_rad >= kWideBeam_px;
}

WideBeams::WideBeams(const gpu::Device& device, std::uint32_t width, std::uint32_t height)
    : prepare_(device, shaders::kShader_wide_prepare), spread_(device, shaders::kShader_wide_spread),
      rays_(device, {gpu::groups(width, kFinestStep), gpu::groups(height, kFinestStep), 1, 1,
                     VK_FORMAT_R16G16B16A16_SFLOAT, true, false}),
      weights_(device, {width, height, 1, 1, VK_FORMAT_R8G8B8A8_UNORM, true, false}),
      lonely_(device, {gpu::groups(width, shared::kTileWidth) * shared::kTileWidth,
                       gpu::groups(height, shared::kTileHeight) * shared::kTileHeight, 1, 1,
                       VK_FORMAT_R16_UINT, true, false}) {}

void WideBeams::prepare(gpu::Commands& commands, const Fragments& fragments, std::uint32_t step) {
    CHECK(step == 2 || step == 4);
    step_ = step;
    commands.begin_span("lonely");
    commands.dispatch(prepare_, shared::WidePush{step},
                      shaders::WidePrepareBindings{.view = gpu::uniform(fragments.view),
                                                   .places = gpu::stored(fragments.places),
                                                   .weights = gpu::stored(weights_),
                                                   .lonely = gpu::stored(lonely_)},
                      fragments.tiles_x, fragments.tiles_y);
    commands.barrier();
}

void WideBeams::spread(gpu::Commands& commands, const gpu::Texture& drawn) {
    const gpu::TextureShape& shape = weights_.shape();
    commands.begin_span("spread");
    commands.dispatch(
        spread_, shared::WidePush{step_},
        shaders::WideSpreadBindings{
            .weights = gpu::stored(weights_), .rays = gpu::stored(rays_), .drawn = gpu::stored(drawn)},
        gpu::groups(shape.width, shared::kTileWidth), gpu::groups(shape.height, shared::kTileHeight));
    commands.barrier();
}

} // namespace ghost::render
