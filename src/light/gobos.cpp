// SPDX-License-Identifier: Apache-2.0
#include "light/gobos.h"

#include "base/check.h"
#include "image/colour.h"
#include "light/beam_shape.h"
#include "show/show.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::scene {
namespace {

using glm::vec3;

constexpr int kMaxLayers = 2048;
// A blur disc is drawn at this many pixels; larger ones are drawn on a smaller picture.
constexpr int kDiscPixels = 8;

struct Plane {
    int side = 0;
    std::vector<vec3> pixels;

    explicit Plane(int side_px)
        : side(side_px), pixels(static_cast<std::size_t>(side_px) * static_cast<std::size_t>(side_px)) {}
    vec3& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                      static_cast<std::size_t>(x)];
    }
    const vec3& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                      static_cast<std::size_t>(x)];
    }
};

// Box-filtered to kGoboSize, linear, premultiplied with alpha (outside the disc nothing passes).
Plane resample(const std::uint8_t* rgba, int width, int height) {
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i)
        linear[i] = image::srgb_to_linear(static_cast<float>(i) / 255.0f);
    Plane result(shared::kGoboSize);
    for (int y = 0; y < result.side; ++y)
        for (int x = 0; x < result.side; ++x) {
            const int x0 = x * width / result.side;
            const int x1 = std::max(x0 + 1, (x + 1) * width / result.side);
            const int y0 = y * height / result.side;
            const int y1 = std::max(y0 + 1, (y + 1) * height / result.side);
            vec3 sum(0.0f);
            for (int sy = y0; sy < y1; ++sy)
                for (int sx = x0; sx < x1; ++sx) {
                    const std::uint8_t* t =
                        rgba + (static_cast<std::size_t>(sy) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(sx)) *
                                   4;
                    sum +=
                        vec3(linear[t[0]], linear[t[1]], linear[t[2]]) * (static_cast<float>(t[3]) / 255.0f);
                }
            result.at(x, y) = sum / static_cast<float>((x1 - x0) * (y1 - y0));
        }
    return result;
}

float gate_radius(const Plane& plane, int x, int y) {
    const float half = static_cast<float>(plane.side) * 0.5f;
    return std::hypot((static_cast<float>(x) + 0.5f - half) / half,
                      (static_cast<float>(y) + 0.5f - half) / half);
}

// Beyond the rim the picture goes on as at the rim, so that the blurred aperture has something to show.
void extend_rim(Plane& plane) {
    const float half = static_cast<float>(plane.side) * 0.5f;
    const float rim = 1.0f - 1.5f / half;
    const Plane inside = plane;
    for (int y = 0; y < plane.side; ++y)
        for (int x = 0; x < plane.side; ++x) {
            const float r = gate_radius(plane, x, y);
            if (r <= rim) continue;
            const auto pull = [&](int c) {
                return std::clamp(static_cast<int>((static_cast<float>(c) + 0.5f - half) * rim / r + half), 0,
                                  plane.side - 1);
            };
            plane.at(x, y) = inside.at(pull(x), pull(y));
        }
}

Plane halved(const Plane& plane) {
    Plane result(plane.side / 2);
    for (int y = 0; y < result.side; ++y)
        for (int x = 0; x < result.side; ++x)
            result.at(x, y) = (plane.at(2 * x, 2 * y) + plane.at(2 * x + 1, 2 * y) +
                               plane.at(2 * x, 2 * y + 1) + plane.at(2 * x + 1, 2 * y + 1)) *
                              0.25f;
    return result;
}

// By rows.
std::vector<bool> pixels_in_gate(const Plane& plane) {
    std::vector<bool> inside;
    inside.reserve(plane.pixels.size());
    for (int y = 0; y < plane.side; ++y)
        for (int x = 0; x < plane.side; ++x) inside.push_back(gate_radius(plane, x, y) <= 1.0f);
    return inside;
}

// Mean over a disc, counting only what lies in the gate. Each row of the disc is a difference of running
// sums.
Plane disc_blurred(const Plane& plane, int radius, const std::vector<bool>& in_gate) {
    const int side = plane.side;
    const auto stride = static_cast<std::size_t>(side) + 1;
    std::vector<glm::vec4> sums(stride * static_cast<std::size_t>(side),
                                glm::vec4(0.0f)); // w: pixels counted
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x);
            const bool inside = in_gate[static_cast<std::size_t>(y * side + x)];
            sums[at + 1] = sums[at] + (inside ? glm::vec4(plane.at(x, y), 1.0f) : glm::vec4(0.0f));
        }
    std::array<int, 2 * kDiscPixels + 1> half{}; // of the rows of the disc
    for (int dy = -radius; dy <= radius; ++dy)
        half[static_cast<std::size_t>(dy + radius)] =
            static_cast<int>(std::sqrt(static_cast<float>(radius * radius - dy * dy)));
    Plane result(side);
    for (int y = 0; y < side; ++y) {
        const int first = std::max(-radius, -y), last = std::min(radius, side - 1 - y);
        for (int x = 0; x < side; ++x) {
            glm::vec4 sum(0.0f);
            for (int dy = first; dy <= last; ++dy) {
                const int across = half[static_cast<std::size_t>(dy + radius)];
                const std::size_t row = static_cast<std::size_t>(y + dy) * stride;
                sum += sums[row + static_cast<std::size_t>(std::min(x + across + 1, side))] -
                       sums[row + static_cast<std::size_t>(std::max(x - across, 0))];
            }
            // Too far outside for any: the picture goes on as at the rim.
            result.at(x, y) = sum.w > 0.5f ? vec3(sum) / sum.w : plane.at(x, y);
        }
    }
    return result;
}

void append_level(std::vector<std::uint32_t>& texels, const Plane& plane) {
    for (const vec3& pixel : plane.pixels) texels.push_back(shared::gobo_code(pixel));
}

void append_open_layer(shared::Gobos& gobos) {
    for (int level = 0; level < shared::kGoboLevels; ++level) {
        const auto side = static_cast<std::size_t>(shared::kGoboSize >> level);
        gobos.texels[level].insert(gobos.texels[level].end(), side * side, shared::gobo_code(vec3(1.0f)));
    }
    gobos.layers = 1;
}

void append_plane(shared::Gobos& gobos, const Plane& source) {
    append_level(gobos.texels[0], source);
    Plane drawn = source;
    std::vector<bool> in_gate = pixels_in_gate(drawn);
    for (int level = 1; level < shared::kGoboLevels; ++level) {
        // Level k is blurred over 2^k pixels of the full picture, drawn where that is kDiscPixels at most.
        int radius = 1 << level;
        if (radius > kDiscPixels) {
            radius = kDiscPixels;
            drawn = halved(drawn);
            in_gate = pixels_in_gate(drawn);
        }
        Plane plane = disc_blurred(drawn, radius, in_gate);
        while (plane.side > (shared::kGoboSize >> level)) plane = halved(plane);
        append_level(gobos.texels[level], plane);
    }
    ++gobos.layers;
}

} // namespace

void append_gobo(shared::Gobos& gobos, const std::uint8_t* rgba, int width, int height) {
    CHECK(width > 0 && height > 0);
    if (gobos.layers == 0) append_open_layer(gobos);
    Plane source = resample(rgba, width, height);
    extend_rim(source);
    append_plane(gobos, source);
}

void append_shape(shared::Gobos& gobos, const BeamShape& shape) {
    if (gobos.layers == 0) append_open_layer(gobos);
    Plane source(shared::kGoboSize);
    CHECK_EQ(shape.texels.size(), source.pixels.size());
    for (std::size_t k = 0; k < source.pixels.size(); ++k)
        source.pixels[k] = vec3(static_cast<float>(shape.texels[k]) / 255.0f);
    append_plane(gobos, source);
}

std::uint32_t GoboStack::layer(const fixture::Type* type, int media) const {
    const auto found = layers.find({type, media});
    return found == layers.end() ? 0u : found->second;
}

GoboStack build_gobos(const Show& show, Report& report) {
    GoboStack stack;
    append_open_layer(stack.images);
    for (const PatchedFixture& fixture : show.fixtures) {
        if (!fixture.type) continue;
        if (fixture.shape && !stack.shapes.contains(fixture.shape.get())) {
            if (stack.images.layers >= kMaxLayers) {
                report.add(Severity::error, fixture.shape->file,
                           "more than " + std::to_string(kMaxLayers) +
                               " gobos and photometric files in one show; not used");
            } else {
                stack.shapes[fixture.shape.get()] = static_cast<std::uint32_t>(stack.images.layers);
                append_shape(stack.images, *fixture.shape);
            }
        }
        for (const fixture::Wheel& wheel : fixture.type->wheels)
            for (const fixture::Slot& slot : wheel.slots) {
                if (slot.media < 0) continue;
                const std::pair<const fixture::Type*, int> key{fixture.type.get(), slot.media};
                const fixture::Media& media = fixture.type->media[static_cast<std::size_t>(slot.media)];
                if (media.rgba.empty() || stack.layers.contains(key)) continue;
                if (stack.images.layers >= kMaxLayers) {
                    report.add(Severity::error, fixture.gdtf.string() + ": " + media.file,
                               "more than " + std::to_string(kMaxLayers) +
                                   " gobos in one show; this one stays open");
                    continue;
                }
                stack.layers[key] = static_cast<std::uint32_t>(stack.images.layers);
                append_gobo(stack.images, media.rgba.data(), media.width, media.height);
            }
    }
    return stack;
}

} // namespace ghost::scene
