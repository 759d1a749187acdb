#pragma once
// SPDX-License-Identifier: Apache-2.0
// Canned views for the tables about haze: small stages made in code, each with a camera and one light; their
// distance maps, and reference pictures to judge an integrator by. Metres, Z up. Main thread, but for
// trace_distances, which uses all cores.

#include "bench/bench.h"
#include "passes/distance_maps.h"
#include "rays/tracer.h"
#include "render/geometry/g_buffer.h"
#include "render/geometry/stage_model.h"
#include "render/haze/distance_images.h"

#include <memory>

namespace ghost::app {

struct BenchView {
    std::string name;
    scene::Stage stage;
    scene::Camera camera;
    shared::Light light{};
};

// Thirteen, 256x144: from a beam of 3 degrees to a bar right before a large lens.
std::vector<BenchView> bench_views();
// What the thesis shows at 256x256: a spot with a gobo over a floor, a wall, boxes and a ball.
BenchView thesis_view();

// A stage without anything; boxes and balls share one mesh each.
scene::Stage empty_stage();
void add_box(scene::Stage& stage, const glm::vec3& low_m, const glm::vec3& high_m);
void add_ball(scene::Stage& stage, const glm::vec3& centre_m, float radius_m);
// Field angle; hard_edge: a spot, else a wash.
shared::Light aimed_light(const glm::vec3& from_m, const glm::vec3& to_m, float field_deg, bool hard_edge);
// The same beam as it leaves a lens of this radius that stands where the light began: its apex lies behind,
// its distance map, at the pivot of the head, between the two.
void leave_lens(shared::Light& light, float radius_m);

// map_side: texels, a multiple of 8.
scene::DistanceMap trace_distances(const bake::Tracer& tracer, const glm::vec3& position_m, int map_side);

// Views of one size on the device: light n stands in front of distance map n + 1.
class BenchStages {
public:
    BenchStages(const gpu::Device& device, std::vector<BenchView> views, int map_side);

    // Draws the G-buffer of a view, from so far beside its camera; relighters made before must forget().
    void look(std::size_t view, float aside_m = 0);
    const std::vector<BenchView>& views() const { return views_; }
    const bake::Tracer& tracer(std::size_t view) const { return *tracers_[view]; }
    const render::GBuffer& g_buffer() const { return g_buffer_; }
    const render::DistanceImages& distances() const { return *distances_; }

private:
    std::vector<BenchView> views_;
    std::vector<std::unique_ptr<bake::Tracer>> tracers_;
    std::vector<std::unique_ptr<render::StageModel>> models_;
    std::unique_ptr<render::DistanceImages> distances_;
    render::GBuffer g_buffer_;
};

// Haze alone, by brute force. An integrator is judged by the rays that it takes itself: gate through the
// middles of pixels, with shadows in the air; cone and march through the corners, mean of four, without
// shadows, which they do not have. Pixels at silhouettes do not count: which of their surfaces ends the ray
// is the G-buffer's choice, not the integrator's.
struct References {
    image::ImageF gate;
    image::ImageF samples;
    std::vector<std::uint8_t> counts; // per pixel: 1 is compared
};
Result<References> reference_haze(const BenchView& view, const bake::Tracer& tracer, int air_samples);

struct Accuracy {
    double psnr_db = 0; // behind 1 - exp(-L / (2 p75))
    double bias_percent = 0;
    double compared_percent = 0; // of the pixels
};
Result<Accuracy> accuracy_of(image::ImageF picture, const image::ImageF& reference,
                             const std::vector<std::uint8_t>& counts);

} // namespace ghost::app
