// SPDX-License-Identifier: Apache-2.0
#include "render/relight/led_wall_pass.h"

#include "shaders/led_wall.h"

#include <algorithm>
#include <cmath>

namespace ghost::render {
namespace {

using glm::vec2;
using glm::vec3;

constexpr float kNearestWall_m = 0.05f;
constexpr std::uint32_t kWallGroup = 8; // pixels a side

} // namespace

bool wall_in_view(const shared::LedWall& wall, const shared::View& view, glm::uvec2& low, glm::uvec2& high) {
    if (wall.radiance == vec3(0.0f) || glm::dot(view.eye_m - wall.centre_m, wall.normal) <= 0.0f)
        return false;
    const vec2 size(view.width, view.height);
    const float right2 = glm::dot(view.right, view.right), up2 = glm::dot(view.up, view.up);
    const vec3 across = wall.right / glm::dot(wall.right, wall.right),
               along = wall.up / glm::dot(wall.up, wall.up);
    vec2 least = size, most(0.0f);
    int behind = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 at = wall.centre_m + (corner % 2 ? across : -across) + (corner / 2 % 2 ? along : -along) +
                        (corner / 4 ? wall.depth_m : -wall.depth_m) * wall.normal;
        const vec3 way = at - view.eye_m;
        const float depth_m = glm::dot(way, view.forward);
        behind += depth_m < kNearestWall_m ? 1 : 0;
        const vec2 ndc = vec2(glm::dot(way, view.right) / right2, glm::dot(way, view.up) / up2) /
                         std::max(depth_m, kNearestWall_m);
        const vec2 px = 0.5f * size * (vec2(1.0f) + vec2(ndc.x, -ndc.y));
        least = glm::min(least, px);
        most = glm::max(most, px);
    }
    if (behind == 8) return false;
    if (behind > 0) { // it passes the eye
        least = vec2(0.0f);
        most = size;
    }
    least = glm::floor(least) - 1.0f;
    most = glm::ceil(most) + 1.0f;
    if (!(least.x < size.x && least.y < size.y && most.x >= 0 && most.y >= 0)) return false;
    low = glm::uvec2(glm::max(least, vec2(0.0f)));
    high = glm::uvec2(glm::min(most, size - 1.0f));
    return true;
}

LedWallPass::LedWallPass(const gpu::Device& device) : program_(device, shaders::kShader_led_wall) {}

void LedWallPass::record(gpu::Commands& commands, const Fragments& fragments,
                         const std::vector<shared::LedWall>& walls, const gpu::Texture& gobos,
                         const gpu::Texture& slides, const gpu::Texture& frame) {
    brightest_ = 0;
    const shaders::LedWallBindings bindings{.gobo_stack = gpu::sampled(gobos),
                                            .view = gpu::uniform(fragments.view),
                                            .places = gpu::stored(fragments.places),
                                            .frame = gpu::stored(frame),
                                            .edges = gpu::sampled(fragments.edges),
                                            .slides = gpu::sampled(slides)};
    for (const shared::LedWall& wall : walls) {
        glm::uvec2 low(0), high(0);
        if (!wall_in_view(wall, fragments.camera, low, high)) continue;
        brightest_ += std::max({wall.radiance.x, wall.radiance.y, wall.radiance.z});
        commands.dispatch(program_.get(), shared::LedWallPush{wall, low.x, low.y, high.x, high.y, 0},
                          bindings, gpu::groups(high.x - low.x + 1, kWallGroup),
                          gpu::groups(high.y - low.y + 1, kWallGroup));
        commands.barrier();
        if (fragments.edge_count == 0) continue;
        commands.dispatch(program_.get(), shared::LedWallPush{wall, 0, 0, 0, 0, fragments.edge_count},
                          bindings, gpu::groups(fragments.edge_count, kWallGroup * kWallGroup));
        commands.barrier();
    }
}

} // namespace ghost::render
