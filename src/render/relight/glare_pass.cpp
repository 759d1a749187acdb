// SPDX-License-Identifier: Apache-2.0
#include "render/relight/glare_pass.h"

#include "render/pixels/glare.h"
#include "render/relight/planes.h"
#include "shaders/glare_develop.h"
#include "shaders/glare_down.h"
#include "shaders/glare_tail.h"
#include "shaders/glare_up.h"
#include "shared/glare.h"
#include "shared/push.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ghost::render {
namespace {

constexpr std::uint32_t kMostLevels = 8;
constexpr std::uint32_t kCoarsest = 8; // texels of the coarsest level's shorter side, at least

std::uint32_t level_count(std::uint32_t width, std::uint32_t height) {
    std::uint32_t count = 1;
    for (std::uint32_t side = std::min(width, height) / 4; side >= kCoarsest && count < kMostLevels;
         side /= 2)
        ++count;
    return count;
}

float texel_deg(std::size_t level, float pixels_per_rad) {
    return std::exp2(static_cast<float>(level + 1)) / pixels_per_rad * (180.0f / shared::kPi);
}

// Sum of glare_tail over all texels that it reaches.
double tail_sum(float texel) {
    const int reach = static_cast<int>(std::ceil(shared::kGlareReach_deg / texel));
    double sum = 0;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) sum += double{shared::glare_tail(glm::vec2(x, y), texel)};
    return sum;
}

} // namespace

std::vector<float> glare_weights(std::size_t levels, float pixels_per_rad) {
    // Light between two angles: the integral of (10 / a^3 + 5 / a^2) a da, a in degrees.
    const auto light = [](float from, float to) {
        from = std::clamp(from, shared::kGlareInner_deg, shared::kGlareReach_deg);
        to = std::clamp(to, from, shared::kGlareReach_deg);
        return 10.0f / from - 10.0f / to + 5.0f * std::log(to / from);
    };
    const float all = light(0, shared::kGlareReach_deg);
    std::vector<float> weights(levels);
    for (std::size_t k = 0; k < levels; ++k) {
        const float texel = texel_deg(k, pixels_per_rad);
        // A coarsest texel beyond the reach still has what goes that far: its fraction is that of its last
        // octave.
        const float from = k + 1 < levels ? texel : std::min(texel, 0.5f * shared::kGlareReach_deg);
        weights[k] = light(from, k + 1 < levels ? 2.0f * texel : shared::kGlareReach_deg) / all;
    }
    return weights;
}

GlarePass::GlarePass(const gpu::Device& device, std::uint32_t width, std::uint32_t height,
                     const GlareSettings& settings)
    : settings_(settings) {
    settings_.strength = std::clamp(settings.strength, 0.0f, 1.0f);
    if (!on()) return;
    for (std::uint32_t frame = 0; frame < down_.size(); ++frame)
        down_[frame] = gpu::LateProgram(device, shaders::kShader_glare_down, {frame});
    up_ = gpu::LateProgram(device, shaders::kShader_glare_up);
    tail_ = gpu::LateProgram(device, shaders::kShader_glare_tail);
    for (std::uint32_t tone = 0; tone < develop_.size(); ++tone)
        develop_[tone] = gpu::LateProgram(device, shaders::kShader_glare_develop, std::vector{tone});
    // Every level is exactly half the one before: no light is counted twice at the far border.
    const std::uint32_t count = level_count(width, height);
    const std::uint32_t unit = 1u << (count - 1);
    std::uint32_t level_width = gpu::groups(gpu::groups(width, 2), unit) * unit;
    std::uint32_t level_height = gpu::groups(gpu::groups(height, 2), unit) * unit;
    for (std::uint32_t k = 0; k < count; ++k, level_width /= 2, level_height /= 2)
        levels_.emplace_back(device, gpu::TextureShape{level_width, level_height, 1, 1,
                                                       VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    far_ = gpu::Texture(device, levels_.back().shape());
    seen_ = gpu::Texture(device, {width, height, 1, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
}

void GlarePass::record(gpu::Commands& commands, const gpu::Texture& frame, float brightest,
                       float pixels_per_rad) {
    if (!on()) return;
    const float scale = prepare(brightest, pixels_per_rad);
    // A program's invocation makes 2x2 texels.
    const auto over = [&](const gpu::Program& program, const auto& push,
                          const std::vector<gpu::Binding>& bindings, std::uint32_t width,
                          std::uint32_t height) {
        commands.dispatch(program, push, bindings, gpu::groups(width, 2 * shared::kTileWidth),
                          gpu::groups(height, 2 * shared::kTileHeight));
        commands.barrier();
    };
    const auto down = [&](const gpu::Program& program, const gpu::Texture& fine, const gpu::Texture& coarse,
                          float by) {
        over(program, shared::GlareDownPush{fine.shape().width, fine.shape().height, by},
             shaders::GlareDownBindings{.fine = gpu::stored(fine), .coarse = gpu::stored(coarse)},
             coarse.shape().width, coarse.shape().height);
    };
    const auto up = [&](const gpu::Texture& coarse, const gpu::Texture& fine, const gpu::Texture& sum,
                        float fine_weight, float coarse_weight) {
        const gpu::TextureShape& shape = sum.shape();
        over(up_.get(), shared::GlareUpPush{shape.width, shape.height, fine_weight, coarse_weight},
             shaders::GlareUpBindings{
                 .coarse = gpu::stored(coarse), .fine = gpu::stored(fine), .sum = gpu::stored(sum)},
             shape.width, shape.height);
    };
    commands.begin_span("glare");
    down(down_[1].get(), frame, levels_[0], scale);
    for (std::size_t k = 1; k < levels_.size(); ++k) down(down_[0].get(), levels_[k - 1], levels_[k], 1.0f);
    const gpu::TextureShape& shape = far_.shape();
    commands.dispatch(
        tail_.get(), shared::GlareTailPush{texel_deg(levels_.size() - 1, pixels_per_rad), tail_weight_},
        shaders::GlareTailBindings{.from = gpu::stored(levels_.back()), .to = gpu::stored(far_)},
        gpu::groups(shape.width, 8), gpu::groups(shape.height, 4));
    commands.barrier();
    for (std::size_t k = levels_.size() - 1; k > 0; --k)
        up(scattered(k), levels_[k - 1], levels_[k - 1], weights_[k - 1], scattered_weight(k));
}

// Returns what the frame is to be multiplied with.
float GlarePass::prepare(float brightest, float pixels_per_rad) {
    // A power of two that brings the brightest light, twice, below the limit: exact, so it changes nothing
    // else.
    const float scale =
        std::exp2(-std::ceil(std::log2(std::max(2.0f * brightest / shared::kMostLight, 1.0f))));
    if (pixels_per_rad != pixels_per_rad_) {
        pixels_per_rad_ = pixels_per_rad;
        weights_ = glare_weights(levels_.size(), pixels_per_rad);
        const double sum = tail_sum(texel_deg(levels_.size() - 1, pixels_per_rad));
        tail_weight_ = sum > 0 ? static_cast<float>(1.0 / sum) : 0.0f;
    }
    // What is scattered less far than a texel stays in its pixel.
    const float all = std::accumulate(weights_.begin(), weights_.end(), 0.0f);
    last_up_ = {seen_.shape().width, seen_.shape().height, 1.0f - settings_.strength * all,
                scattered_weight(0) * settings_.strength / scale};
    return scale;
}

SeenFrame GlarePass::on_processor(const Plane& frame, float brightest, float pixels_per_rad) {
    if (!on()) return {.frame = frame, .finest = {}};
    const float scale = prepare(brightest, pixels_per_rad);
    std::vector<Plane> levels;
    for (const gpu::Texture& level : levels_) levels.push_back(plane_of(level));
    glare_down(frame, levels[0], scale, true);
    for (std::size_t k = 1; k < levels.size(); ++k) glare_down(levels[k - 1], levels[k], 1.0f, false);
    glare_tail(levels.back(), plane_of(far_), texel_deg(levels.size() - 1, pixels_per_rad), tail_weight_);
    for (std::size_t k = levels.size() - 1; k > 0; --k)
        glare_up(plane_of(scattered(k)), levels[k - 1], weights_[k - 1], scattered_weight(k));
    return {.frame = frame,
            .finest = plane_of(scattered(0)),
            .frame_weight = last_up_.fine_weight,
            .glare_weight = last_up_.coarse_weight};
}

void GlarePass::see(gpu::Commands& commands, const gpu::Texture& frame) {
    if (!on()) return;
    commands.dispatch(up_.get(), last_up_,
                      shaders::GlareUpBindings{.coarse = gpu::stored(scattered(0)),
                                               .fine = gpu::stored(frame),
                                               .sum = gpu::stored(seen_)},
                      gpu::groups(last_up_.width, 2 * shared::kTileWidth),
                      gpu::groups(last_up_.height, 2 * shared::kTileHeight));
    commands.barrier();
}

void GlarePass::develop(gpu::Commands& commands, const gpu::Texture& frame, const gpu::Buffer& exposure,
                        const gpu::Texture& picture, std::uint32_t tone) {
    commands.dispatch(develop_[tone].get(), last_up_,
                      shaders::GlareDevelopBindings{.coarse = gpu::stored(scattered(0)),
                                                    .fine = gpu::stored(frame),
                                                    .exposure = gpu::uniform(exposure),
                                                    .picture = gpu::stored(picture)},
                      gpu::groups(last_up_.width, 2 * shared::kTileWidth),
                      gpu::groups(last_up_.height, 2 * shared::kTileHeight));
    commands.barrier();
}

std::uint64_t GlarePass::memory_bytes() const {
    std::uint64_t sum = seen_.bytes() + far_.bytes();
    for (const gpu::Texture& level : levels_) sum += level.bytes();
    return sum;
}

} // namespace ghost::render
