// SPDX-License-Identifier: Apache-2.0
#include "render/present/screen.h"
#include "shaders/present.h"

#include <algorithm>
#include <cmath>

namespace ghost::render {
namespace {

constexpr double kSamePlace_px = 0.01;
constexpr std::uint32_t kMostTaps = 4;
constexpr std::uint32_t kScreenGroupWidth = 16, kScreenGroupHeight = 8; // present.comp

static_assert(static_cast<std::uint32_t>(Encoding::srgb) == shared::kEncodeSrgb &&
              static_cast<std::uint32_t>(Encoding::pq) == shared::kEncodePq &&
              static_cast<std::uint32_t>(Encoding::scrgb) == shared::kEncodeScrgb);

bool is_near(double a, double b) {
    return std::abs(a - b) < kSamePlace_px;
}

} // namespace

PresentPass::PresentPass(const gpu::Device& device)
    : program_(device, shaders::kShader_present),
      nothing_(device, {1, 1, 1, 1, VK_FORMAT_B8G8R8A8_UNORM, false, false}) {}

void PresentPass::record(gpu::Commands& commands, const ScreenPicture& picture, const PicturePlace& place,
                         const gpu::Texture* covers, const SurfaceFormat& format,
                         const gpu::Texture& to) const {
    shared::PresentPush push{};
    push.encoding = static_cast<std::uint32_t>(format.encoding);
    push.swaps = format.swaps ? 1 : 0;
    push.light = picture.is_light ? 1 : 0;
    push.covers = covers ? 1 : 0;
    push.taps = 1;
    if (picture.texture) {
        const gpu::TextureShape& shape = picture.texture->shape();
        push.exact = is_near(place.width, shape.width) && is_near(place.height, shape.height) ? 1 : 0;
        // A picture that fits lies on whole pixels.
        const double x = push.exact ? std::round(place.x) : place.x,
                     y = push.exact ? std::round(place.y) : place.y;
        push.place = {static_cast<float>(x), static_cast<float>(y)};
        push.size = {static_cast<float>(place.width), static_cast<float>(place.height)};
        const double finer = shape.width / std::max(place.width, 1.0);
        push.taps = std::clamp(static_cast<std::uint32_t>(std::ceil(finer / 2)), 1u, kMostTaps);
    }
    const gpu::TextureShape& size = to.shape();
    commands.dispatch(
        program_, push,
        shaders::PresentBindings{.picture = gpu::sampled(picture.texture ? *picture.texture : nothing_),
                                 .overlay = gpu::sampled(covers ? *covers : nothing_),
                                 .surface = gpu::stored(to)},
        gpu::groups(size.width, kScreenGroupWidth), gpu::groups(size.height, kScreenGroupHeight));
    commands.barrier();
}

} // namespace ghost::render
