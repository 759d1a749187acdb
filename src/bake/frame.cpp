// SPDX-License-Identifier: Apache-2.0
#include "bake/frame.h"

#include "bake/fragments.h"
#include "rays/camera_rays.h"
#include "rays/pixel.h"
#include "rays/sampling.h"

#include "base/check.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <tbb/parallel_for.h>

namespace ghost::bake {
namespace {

// Directions to the sky per camera sample.
constexpr int kSkyRays = 4;
// Bounced light takes highlights no sharper than this, or a few samples would sparkle.
constexpr float kBounceAlpha = 0.25f;
// The truss beside a lamp is never in its beam; lit by a bare point source it would sparkle in every bounce.
constexpr float kBounceNearest_m = 3.0f;

// The fragments beyond the first of one row of pixels.
struct RowExtras {
    std::vector<std::uint32_t> count; // per pixel of the row
    std::vector<glm::vec4> fragments;
    Layer ambient;
    Layer emission;
    std::vector<Layer> lights;
};

class FrameJob {
public:
    FrameJob(const Tracer& tracer, const scene::Camera& camera, const FrameRequest& request, Frame& frame)
        : tracer_(tracer), camera_(camera), request_(request), frame_(frame),
          rows_(static_cast<std::size_t>(frame.height)) {}

    void trace_row(int y) {
        const DenormalsOff mode;
        Scratch scratch(static_cast<std::size_t>(request_.spp));
        RowExtras& extras = rows_[static_cast<std::size_t>(y)];
        extras.count.assign(static_cast<std::size_t>(frame_.width), 0);
        extras.lights.resize(request_.lights_m.size());
        for (int x = 0; x < frame_.width; ++x)
            if (wanted(x, y)) trace_one(x, y, extras, scratch);
        rays_ += scratch.rays;
    }

    // Puts the extra fragments of all rows behind the main ones.
    void gather() {
        const std::size_t pixels = frame_.fragments.size();
        frame_.extra_first.assign(pixels + 1, 0);
        std::uint32_t total = 0;
        for (std::size_t y = 0; y < rows_.size(); ++y) {
            const auto width = static_cast<std::size_t>(frame_.width);
            for (std::size_t x = 0; x < width; ++x) {
                frame_.extra_first[y * width + x] = total;
                if (!rows_[y].count.empty()) total += rows_[y].count[x];
            }
            append(frame_.fragments, rows_[y].fragments);
            if (request_.surroundings) {
                append(frame_.ambient, rows_[y].ambient);
                append(frame_.emission, rows_[y].emission);
            }
            for (std::size_t k = 0; k < rows_[y].lights.size(); ++k)
                append(frame_.lights[k], rows_[y].lights[k]);
        }
        frame_.extra_first[pixels] = total;
    }

    std::uint64_t rays() const { return rays_; }

private:
    struct Scratch {
        explicit Scratch(std::size_t spp)
            : samples(spp), bounced(spp), throughput(spp), radiance(spp), part(spp) {}
        std::vector<Surface> samples;
        std::vector<Surface> bounced;
        std::vector<glm::vec3> throughput;
        std::vector<glm::vec3> radiance;
        std::vector<int> part;
        std::uint64_t rays = 0;
    };
    using Parts = std::array<glm::vec3, kMaxFragments>;

    template <class T>
    static void append(std::vector<T>& to, const std::vector<T>& from) {
        to.insert(to.end(), from.begin(), from.end());
    }

    bool wanted(int x, int y) const {
        if (request_.only.empty()) return true;
        return std::any_of(request_.only.begin(), request_.only.end(),
                           [&](const Rect& rect) { return rect.contains(x, y); });
    }

    // Mean per fragment, premultiplied: the sum over all samples of a fragment by the number of samples of
    // the pixel.
    template <class Value>
    Parts per_part(const Scratch& s, Value value) const {
        Parts sums{};
        for (std::size_t k = 0; k < s.samples.size(); ++k)
            if (s.part[k] >= 0) sums[static_cast<std::size_t>(s.part[k])] += value(k);
        for (glm::vec3& sum : sums) sum /= static_cast<float>(s.samples.size());
        return sums;
    }

    static void store(const Parts& parts, int count, std::size_t pixel, Layer& main, Layer& extra) {
        main[pixel] = parts[0];
        for (int k = 1; k < count; ++k) extra.push_back(parts[static_cast<std::size_t>(k)]);
    }

    void trace_one(int x, int y, RowExtras& extras, Scratch& s) {
        const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) +
                                  static_cast<std::size_t>(x);
        trace_pixel(tracer_, camera_, x, y, 0, s.samples, s.rays);
        const int count = split_into_fragments(s.samples, camera_.pixel_m(1.0f), s.part);
        if (request_.surroundings) centre(x, y, pixel, s);
        if (count == 0) return;
        extras.count[static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(count - 1);

        const auto spp = static_cast<float>(s.samples.size());
        std::array<glm::vec4, kMaxFragments> places{};
        for (std::size_t k = 0; k < s.samples.size(); ++k)
            if (s.part[k] >= 0)
                places[static_cast<std::size_t>(s.part[k])] += glm::vec4(s.samples[k].position, 1.0f);
        for (int k = 0; k < count; ++k) {
            const glm::vec4& sum = places[static_cast<std::size_t>(k)];
            const glm::vec4 fragment(glm::vec3(sum) / sum.w, sum.w / spp);
            if (k == 0)
                frame_.fragments[pixel] = fragment;
            else
                extras.fragments.push_back(fragment);
        }
        if (request_.surroundings) {
            store(per_part(s, [&](std::size_t k) { return s.samples[k].emission; }), count, pixel,
                  frame_.emission, extras.emission);
            sky(x, y, s);
            store(per_part(s, [&](std::size_t k) { return s.radiance[k]; }), count, pixel, frame_.ambient,
                  extras.ambient);
        }
        for (std::size_t light = 0; light < request_.lights_m.size(); ++light) {
            light_samples(tracer_, s.samples, request_.lights_m[light], s.radiance, s.rays);
            store(per_part(s, [&](std::size_t k) { return s.radiance[k]; }), count, pixel,
                  frame_.lights[light], extras.lights[light]);
        }
        if (request_.bounces > 0 && !request_.lights_m.empty()) bounce(x, y, pixel, s);
    }

    void centre(int x, int y, std::size_t pixel, Scratch& s) {
        const glm::vec3 direction =
            camera_.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const Surface hit = tracer_.first_hit(camera_.eye, direction, -1.0f, Sees::everything);
        ++s.rays;
        if (hit.instance < 0) return;
        frame_.centre_position[pixel] = glm::vec4(hit.position, 1.0f);
        frame_.centre_normal[pixel] = hit.normal;
        frame_.centre_albedo[pixel] = hit.base_colour;
        frame_.centre_distance_m[pixel] = hit.distance_m;
    }

    // s.radiance: of each sample under an even light of 1 lux (radiance 1 / pi from everywhere).
    void sky(int x, int y, Scratch& s) {
        const std::uint32_t seed = pixel_seed(x, y, 11);
        const Surface* packet[8];
        glm::vec3 ways[8];
        std::size_t owner[8];
        int count = 0;
        const auto flush = [&] {
            float fractions[8];
            tracer_.open_sky(packet, count, ways, fractions);
            s.rays += static_cast<std::uint64_t>(count);
            for (int k = 0; k < count; ++k) s.radiance[owner[k]] += glm::vec3(fractions[k]);
            count = 0;
        };
        for (std::size_t k = 0; k < s.samples.size(); ++k) {
            s.radiance[k] = glm::vec3(0.0f);
            if (s.samples[k].instance < 0) continue;
            for (std::size_t ray = 0; ray < kSkyRays; ++ray) {
                packet[count] = &s.samples[k];
                owner[count] = k;
                ways[count] = cosine_direction(
                    s.samples[k].normal, sobol_2d(static_cast<std::uint32_t>(k * kSkyRays + ray), seed));
                if (++count == 8) flush();
            }
        }
        if (count > 0) flush();
        for (std::size_t k = 0; k < s.samples.size(); ++k) {
            const Surface& surface = s.samples[k];
            if (surface.instance < 0) continue;
            const float cosine = std::abs(glm::dot(surface.normal, surface.to_viewer));
            s.radiance[k] *= shared::brdf_albedo(surface.brdf, cosine) * (1.0f / (shared::kPi * kSkyRays));
        }
    }

    // Light after one to request_.bounces diffuse or glossy bounces.
    void bounce(int x, int y, std::size_t pixel, Scratch& s) {
        const auto spp = static_cast<float>(s.samples.size());
        s.bounced = s.samples;
        std::fill(s.throughput.begin(), s.throughput.end(), glm::vec3(1.0f));
        for (int depth = 0; depth < request_.bounces; ++depth) {
            const std::uint32_t seed = pixel_seed(x, y, 23u + static_cast<std::uint32_t>(depth));
            for (std::size_t k = 0; k < s.bounced.size(); ++k) {
                if (s.bounced[k].instance < 0) continue;
                const Surface from = s.bounced[k];
                const auto index = static_cast<std::uint32_t>(k);
                const glm::vec3 way = cosine_direction(from.normal, sobol_2d(index, seed));
                const float cosine = glm::dot(from.normal, way);
                if (cosine <= 1e-4f) {
                    s.bounced[k].instance = -1;
                    continue;
                }
                shared::Brdf brdf = from.brdf;
                brdf.alpha = std::max(brdf.alpha, kBounceAlpha);
                s.throughput[k] *= shared::brdf_times_cosine(brdf, from.normal, from.to_viewer, way) *
                                   (shared::kPi / cosine);
                const float blend = to_unit(owen_scramble(reverse_bits(index), hash_u32(seed, 3)));
                s.bounced[k] = tracer_.first_hit(from.shadow_origin, way, blend, Sees::no_bodies);
                s.bounced[k].brdf.alpha = std::max(s.bounced[k].brdf.alpha, kBounceAlpha);
                ++s.rays;
            }
            for (std::size_t light = 0; light < request_.lights_m.size(); ++light) {
                light_samples(tracer_, s.bounced, request_.lights_m[light], s.radiance, s.rays,
                              kBounceNearest_m);
                glm::vec3 sum(0.0f);
                for (std::size_t k = 0; k < s.bounced.size(); ++k) sum += s.throughput[k] * s.radiance[k];
                frame_.indirect[light][pixel] += sum / spp;
            }
        }
    }

    const Tracer& tracer_;
    const CameraRays camera_;
    const FrameRequest& request_;
    Frame& frame_;
    std::vector<RowExtras> rows_;
    std::atomic<std::uint64_t> rays_{0};
};

} // namespace

Frame trace_frame(const Tracer& tracer, const scene::Camera& camera, const FrameRequest& request,
                  std::uint64_t& rays) {
    CHECK(request.spp >= 1 && request.spp <= kMaxSpp);
    Frame frame;
    frame.width = camera.width;
    frame.height = camera.height;
    const std::size_t pixels =
        static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    frame.fragments.assign(pixels, glm::vec4(0, 0, 0, -1));
    if (request.surroundings) {
        frame.centre_position.assign(pixels, glm::vec4(0));
        frame.centre_normal.assign(pixels, glm::vec3(0));
        frame.centre_albedo.assign(pixels, glm::vec3(0));
        frame.centre_distance_m.assign(pixels, 0.0f);
        frame.ambient.assign(pixels, glm::vec3(0));
        frame.emission.assign(pixels, glm::vec3(0));
    }
    frame.lights.assign(request.lights_m.size(), Layer(pixels, glm::vec3(0)));
    if (request.bounces > 0) frame.indirect.assign(request.lights_m.size(), Layer(pixels, glm::vec3(0)));

    FrameJob job(tracer, camera, request, frame);
    tbb::parallel_for(0, frame.height, [&](int y) {
        if (request.stop && request.stop()) return;
        job.trace_row(y);
        if (request.on_row) request.on_row();
    });
    job.gather();
    rays += job.rays();
    return frame;
}

} // namespace ghost::bake
