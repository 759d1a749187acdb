#pragma once
// SPDX-License-Identifier: Apache-2.0
// A black picture with a wall, and the passes for lenses and glare run on it alone.

#include "render/geometry/layout.h"
#include "render/relight/glare_pass.h"
#include "render/relight/lens_pass.h"
#include "support/test_view.h"

namespace ghost::render {

constexpr VkFormat kHalves = VK_FORMAT_R16G16B16A16_SFLOAT;

inline gpu::Texture picture_of(const image::ImageF& pixels) {
    std::vector<std::uint16_t> halves;
    for (std::size_t i = 0; i < pixels.samples.size(); i += 3) {
        for (std::size_t c = 0; c < 3; ++c) halves.push_back(glm::packHalf1x16(pixels.samples[i + c]));
        halves.push_back(0);
    }
    gpu::Texture texture(device(), {static_cast<std::uint32_t>(pixels.width),
                                    static_cast<std::uint32_t>(pixels.height), 1, 1, kHalves, true, false});
    texture.write(0, halves.data(), halves.size() * 2);
    return texture;
}

inline image::ImageF read_back(const gpu::Texture& texture, std::size_t channels = 3) {
    image::ImageF pixels(static_cast<int>(texture.shape().width), static_cast<int>(texture.shape().height),
                         static_cast<int>(channels));
    const gpu::Buffer buffer(device(), pixels.samples.size() / channels * 8, gpu::Access::readback);
    gpu::Commands commands(device());
    commands.begin();
    commands.copy(texture, buffer);
    commands.submit_and_wait();
    const auto* halves = static_cast<const std::uint16_t*>(buffer.mapped());
    for (std::size_t i = 0; i < pixels.samples.size(); ++i)
        pixels.samples[i] = glm::unpackHalf1x16(halves[i / channels * 4 + i % channels]);
    return pixels;
}

inline double sum_of(const image::ImageF& pixels, int channel = 1) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(channel); i < pixels.samples.size(); i += 3)
        sum += pixels.samples[i];
    return sum;
}

inline const gpu::Texture& gobo_texture() {
    static const gpu::Texture& texture = kOneDevice->keep([] {
        const shared::Gobos& gobos = test_gobos();
        gpu::Texture made(device(),
                          {shared::kGoboSize, shared::kGoboSize, static_cast<std::uint32_t>(gobos.layers),
                           shared::kGoboLevels, VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, false, true});
        for (std::uint32_t level = 0; level < shared::kGoboLevels; ++level)
            made.write(level, gobos.texels[level].data(), gobos.texels[level].size() * sizeof(std::uint32_t));
        return made;
    }());
    return texture;
}

// The eye at the origin looks along +y.
class DarkHall {
public:
    DarkHall(int width, int height, float fov_y_deg, float wall_y, const shared::Haze& haze = {},
             const LensSettings& lenses = {}, const GlareSettings& glare = {})
        : passes_(wall_passes(camera_at({0, 0, 0}, {0, 1, 0}, fov_y_deg, width, height), wall_y)),
          view_(make_view(passes_, haze)), images_(make_pass_images(device(), passes_, {}, haze)),
          frame_(picture_of(image::ImageF(width, height, 3))), lenses_(device(), lenses),
          glare_(device(), view_.width, view_.height, glare) {}

    void draw(const std::vector<shared::Light>& lights) {
        std::vector<scene::LensFace> faces;
        for (const shared::Light& light : lights) faces.push_back({light});
        draw(faces);
    }
    void draw(const std::vector<scene::LensFace>& faces) {
        gpu::Commands commands(device());
        commands.begin();
        commands.clear(frame_);
        lenses_.record(commands, images_.fragments, view_, faces, gobo_texture(), gobo_texture(), frame_);
        glare_.record(commands, frame_, lenses_.brightest(), pixels_per_rad(view_));
        glare_.see(commands, frame_);
        commands.submit_and_wait();
    }
    image::ImageF frame() const { return read_back(frame_); }
    image::ImageF seen() const { return read_back(glare_.seen(frame_)); }
    // All light in the picture, times pixels, with what did not fit into the frame.
    double light(std::size_t channel = 1) const {
        const image::ImageF pixels = read_back(frame_, 4);
        double sum = 0;
        for (std::size_t i = 0; i < pixels.samples.size(); i += 4)
            sum += double{pixels.samples[i + channel]} * (1.0 + double{pixels.samples[i + 3]});
        return sum;
    }
    const shared::View& view() const { return view_; }
    const LensPass& lenses() const { return lenses_; }

    // Solid angle of the pixel at an image point.
    double pixel_sr(const glm::vec2& at_px) const {
        const glm::vec2 ndc = at_px / glm::vec2(view_.width, view_.height) * 2.0f - 1.0f;
        const glm::vec3 ray = view_.forward + view_.right * ndc.x - view_.up * ndc.y;
        const double plane = 4.0 * double{glm::length(view_.right)} * double{glm::length(view_.up)} /
                             (static_cast<double>(view_.width) * static_cast<double>(view_.height));
        return plane / std::pow(double{glm::length(ray)}, 3);
    }
    // Where a point of the world is in the picture, pixels.
    glm::vec2 pixel_of(const glm::vec3& point_m) const {
        const float depth = glm::dot(point_m, view_.forward);
        const glm::vec2 ndc(glm::dot(point_m, view_.right) / glm::dot(view_.right, view_.right) / depth,
                            -glm::dot(point_m, view_.up) / glm::dot(view_.up, view_.up) / depth);
        return (ndc + 1.0f) * 0.5f * glm::vec2(view_.width, view_.height);
    }

private:
    scene::Passes passes_;
    shared::View view_;
    PassImages images_;
    gpu::Texture frame_;
    LensPass lenses_;
    GlarePass glare_;
};

inline glm::vec3 lens_of(const shared::Light& light) {
    return light.position_m + light.lens_m * light.axis_w;
}

} // namespace ghost::render
