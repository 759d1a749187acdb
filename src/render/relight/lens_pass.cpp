// SPDX-License-Identifier: Apache-2.0
#include "render/relight/lens_pass.h"

#include "shaders/lens.h"
#include "shared/haze.h"
#include "shared/push.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace ghost::render {
namespace {

using glm::vec2;
using glm::vec3;

// Lenses between two chunks: each begins at a multiple of 256 bytes, where every device lets a uniform buffer
// begin.
constexpr std::size_t kChunkStart = 64;
static_assert(kChunkStart * sizeof(shared::Lens) % 256 == 0);
static_assert(shared::kLensesPerChunk * sizeof(shared::Lens) <= 1u << 16);
constexpr int kCounted_px = 32;      // lenses up to this size are measured pixel by pixel
constexpr float kRimVariance = 0.2f; // of the place of a rim of 1 pixel to both sides, pixels^2
constexpr float kNearest_m = 0.05f;  // from the eye
constexpr float kLeastCosine = 0.02f;

float largest(const vec3& colour) {
    return std::max({colour.x, colour.y, colour.z});
}

// Sum of lens_cover over all pixels, in the picture or not.
float covered_px(const vec2& centre_px, const vec3& spread, const glm::ivec2& low, const glm::ivec2& high) {
    const float determinant = spread.x * spread.z - spread.y * spread.y;
    if (std::max(high.x - low.x, high.y - low.y) > kCounted_px)
        return shared::kPi * (1.0f / std::sqrt(determinant) + kRimVariance);
    float sum = 0;
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
            sum += shared::lens_cover(vec2(x, y) + 0.5f - centre_px, spread);
    return sum;
}

} // namespace

bool lens_in_view(const scene::LensFace& face, const shared::View& view, const LensSettings& settings,
                  LensInView& seen) {
    const shared::Light& light = face.light;
    // On the axis of Lambert's law, per cd of bounce_cd: a few lumens of a lamp, all of what glows.
    const float stray_cd = 4.0f * (face.glows ? 1.0f : settings.stray);
    if (face.of_wall || largest(light.intensity_cd) <= 0) return false;
    const float radius_m = light.disc_radius_m > 0   ? light.disc_radius_m
                           : light.lens_radius_m > 0 ? light.lens_radius_m
                                                     : settings.radius_m;
    const vec3 centre_m = light.position_m + light.lens_m * light.axis_w;
    const vec3 way_m = centre_m - view.eye_m;
    const float depth_m = glm::dot(way_m, view.forward);
    const float distance_m = glm::length(way_m);
    const float cosine = -glm::dot(way_m, light.axis_w) / std::max(distance_m, 1e-6f);
    if (depth_m < kNearest_m || cosine < kLeastCosine) return false;

    // Where the eye is in the beam.
    const vec3 apex_m = view.eye_m - light.position_m;
    const float z = glm::dot(apex_m, light.axis_w);
    const vec2 gate =
        vec2(glm::dot(apex_m, light.axis_u), glm::dot(apex_m, light.axis_v)) / (z * light.tan_field);
    const float before_m = std::max(z - light.lens_radius_m / light.tan_field, 0.0f);
    const float lens_blur = light.lens_radius_m * (before_m * light.focus_per_m - 1.0f) /
                            std::max(light.lens_radius_m + before_m * light.tan_field, 1e-6f);
    const bool in_beam =
        !face.glows && !face.split && glm::length(gate) < light.cut_radius + std::abs(lens_blur);
    if (!in_beam && largest(light.bounce_cd) * stray_cd <= 0) return false;

    // The picture of the disc: an ellipse, by the derivatives of the projection at its centre.
    const vec2 size(view.width, view.height);
    const float right2 = glm::dot(view.right, view.right), up2 = glm::dot(view.up, view.up);
    const vec2 ndc(glm::dot(way_m, view.right) / (right2 * depth_m),
                   glm::dot(way_m, view.up) / (up2 * depth_m));
    const vec2 to_px = vec2(0.5f, -0.5f) * size;
    const vec2 centre_px = 0.5f * size + to_px * ndc;
    const auto moved = [&](const vec3& aside) {
        const vec2 plane(glm::dot(aside, view.right) / right2, glm::dot(aside, view.up) / up2);
        return to_px * (plane - ndc * glm::dot(aside, view.forward)) * (radius_m / depth_m);
    };
    const vec2 u = moved(light.axis_u), v = moved(light.axis_v);
    const float least = shared::kLensRim_px * shared::kLensRim_px;
    const float xx = u.x * u.x + v.x * v.x + least;
    const float xy = u.x * u.y + v.x * v.y;
    const float yy = u.y * u.y + v.y * v.y + least;
    const vec3 spread = vec3(yy, -xy, xx) / (xx * yy - xy * xy);

    const vec2 reach = vec2(std::sqrt(xx), std::sqrt(yy)) + 1.5f * shared::kLensRim_px;
    const vec2 low = glm::clamp(glm::floor(centre_px - reach), -1e6f, 1e6f);
    const vec2 high = glm::clamp(glm::ceil(centre_px + reach), -1e6f, 1e6f);
    if (!(low.x < size.x && low.y < size.y && high.x >= 0 && high.y >= 0)) return false;
    seen.low = glm::max(glm::ivec2(low), glm::ivec2(0));
    seen.high = glm::min(glm::ivec2(high), glm::ivec2(size) - 1);

    // Lux at the eye, spread over the solid angle of the covered pixels, is luminance.
    const float cos_view = depth_m / distance_m;
    const float pixel_sr =
        4.0f * std::sqrt(right2 * up2) / (size.x * size.y) * cos_view * cos_view * cos_view;
    const float transmittance = shared::haze_transmittance(view.haze, distance_m);
    const float light_per_lux =
        transmittance / (pixel_sr * covered_px(centre_px, spread, glm::ivec2(low), glm::ivec2(high)));
    shared::Lens& lens = seen.lens;
    lens.light = light;
    if (!in_beam) lens.light.intensity_cd = vec3(0.0f);
    lens.centre_px = centre_px;
    lens.spread = spread;
    const auto row = [&](const vec2& axis) {
        return vec2(axis.x * spread.x + axis.y * spread.y, axis.x * spread.y + axis.y * spread.z);
    };
    lens.to_lens = glm::vec4(row(u), row(v));
    lens.gate = gate;
    lens.gate_per_lens = lens_blur;
    const float area = std::abs(u.x * v.y - u.y * v.x); // of the ellipse, over pi
    lens.blur = light.edge + std::abs(lens_blur) / std::sqrt(1.0f + 4.0f * area);
    lens.light_per_cd = light_per_lux / glm::dot(apex_m, apex_m);
    lens.stray = light.bounce_cd * (stray_cd * cosine * light_per_lux / (distance_m * distance_m));
    lens.nearest_m = distance_m - radius_m - settings.body_m;
    seen.brightest =
        largest(lens.light.intensity_cd * glm::max(light.colour_b, vec3(1.0f))) * lens.light_per_cd +
        largest(lens.stray);
    return true;
}

LensPass::LensPass(const gpu::Device& device, const LensSettings& settings)
    : device_(device), settings_(settings) {
    if (!settings.on) return;
    for (std::uint32_t kind = 0; kind < shared::kBeamClasses; ++kind) {
        program_[kind] = gpu::LateProgram(device, shaders::kShader_lens, std::vector{kind});
        if (kind < shared::kPlanesClass) (void)program_[kind].get();
        if (shared::may_be_of_wheels(kind)) program_[kind].expect();
    }
}

void LensPass::add_chunk(const std::vector<LensInView>& seen, std::uint32_t beam_class,
                         std::uint32_t blocks_x) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> lenses_of; // of a block
    for (std::uint32_t k = 0; k < seen.size(); ++k) {
        const LensInView& one = seen[k];
        const auto block_of = [](int pixel, std::uint32_t side) {
            return static_cast<std::uint32_t>(pixel) / side;
        };
        for (std::uint32_t y = block_of(one.low.y, shared::kLensBlockHeight);
             y <= block_of(one.high.y, shared::kLensBlockHeight); ++y)
            for (std::uint32_t x = block_of(one.low.x, shared::kLensBlockWidth);
                 x <= block_of(one.high.x, shared::kLensBlockWidth); ++x)
                lenses_of[y * blocks_x + x].push_back(k);
    }
    lens_values_.resize((lens_values_.size() + kChunkStart - 1) / kChunkStart * kChunkStart);
    Chunk chunk{beam_class, static_cast<std::uint32_t>(lens_values_.size()),
                static_cast<std::uint32_t>(list_values_.size()),
                static_cast<std::uint32_t>(lenses_of.size())};
    for (const LensInView& one : seen) lens_values_.push_back(one.lens);
    auto first = static_cast<std::uint32_t>(list_values_.size() + 3 * lenses_of.size());
    for (const auto& [block, lenses] : lenses_of) {
        const auto count = static_cast<std::uint32_t>(lenses.size());
        list_values_.insert(list_values_.end(), {block, first, count});
        first += count;
    }
    for (const auto& [block, lenses] : lenses_of)
        list_values_.insert(list_values_.end(), lenses.begin(), lenses.end());
    chunks_.push_back(chunk);
}

void LensPass::upload() {
    // A chunk is bound as a whole, even where fewer lenses are left. Grown with room, seldom.
    const std::uint64_t lens_bytes = (lens_values_.size() + shared::kLensesPerChunk) * sizeof(shared::Lens);
    const std::uint64_t list_bytes = list_values_.size() * sizeof(std::uint32_t);
    if (lenses_.bytes() < lens_bytes) lenses_ = gpu::Buffer(device_, 2 * lens_bytes, gpu::Access::upload);
    if (list_.bytes() < list_bytes) list_ = gpu::Buffer(device_, 2 * list_bytes, gpu::Access::upload);
    std::memcpy(lenses_.mapped(), lens_values_.data(), lens_values_.size() * sizeof(shared::Lens));
    std::memcpy(list_.mapped(), list_values_.data(), list_bytes);
}

void LensPass::record(gpu::Commands& commands, const Fragments& fragments, const shared::View& view,
                      const std::vector<scene::LensFace>& faces, const gpu::Texture& gobos,
                      const gpu::Texture& slides, const gpu::Texture& frame) {
    lens_values_.clear();
    list_values_.clear();
    chunks_.clear();
    drawn_ = 0;
    brightest_ = 0;
    const std::uint32_t blocks_x = (view.width + shared::kLensBlockWidth - 1) / shared::kLensBlockWidth;
    for (std::uint32_t kind = 0; settings_.on && kind < shared::kBeamClasses; ++kind) {
        std::vector<LensInView> seen;
        for (const scene::LensFace& face : faces) {
            LensInView one;
            if (shared::beam_class(face.light) != kind || !lens_in_view(face, view, settings_, one)) continue;
            brightest_ += one.brightest;
            seen.push_back(one);
            ++drawn_;
            if (seen.size() < shared::kLensesPerChunk) continue;
            add_chunk(seen, kind, blocks_x);
            seen.clear();
        }
        if (!seen.empty()) add_chunk(seen, kind, blocks_x);
    }
    if (chunks_.empty()) return;
    upload();
    commands.begin_span("lenses");
    for (const Chunk& chunk : chunks_) {
        const shared::LensPush push{view.eye_m, blocks_x, view.width, view.height, chunk.first_block};
        commands.dispatch(
            program_[chunk.beam_class].get(), push,
            shaders::LensBindings{.gobo_stack = gpu::sampled(gobos),
                                  .lenses = gpu::uniform(lenses_, chunk.first_lens * sizeof(shared::Lens)),
                                  .list = gpu::storage(list_),
                                  .places = gpu::stored(fragments.places),
                                  .frame = gpu::stored(frame),
                                  .slides = gpu::sampled(slides)},
            chunk.blocks);
        commands.barrier();
    }
}

} // namespace ghost::render
