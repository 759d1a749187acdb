// SPDX-License-Identifier: Apache-2.0
#include "reference/reference.h"

#include "image/exr.h"
#include "rays/sampling.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>
#include <string>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace ghost::bake {
namespace {

using glm::dvec3;
using std::numbers::pi;

// Part of the model: nearer than this to the apex nothing gets brighter.
constexpr double kNearest_m = 1e-3;
constexpr int kSkyRays = 256;

// Visibility of a light, eight points at a time; what is visible is added up.
class ShadowedSum {
public:
    explicit ShadowedSum(const Tracer* tracer) : tracer_(tracer) {
        for (std::size_t k = 0; k < 8; ++k) pointers_[k] = &points_[k];
    }

    void add(const dvec3& from_m, const glm::vec3& to_m, const dvec3& value) {
        if (tracer_ == nullptr) {
            total_ += value;
            return;
        }
        if (count_ > 0 && to_m != target_) flush();
        target_ = to_m;
        points_[count_].shadow_origin = glm::vec3(from_m);
        values_[count_] = value;
        if (++count_ == 8) flush();
    }

    dvec3 total() {
        flush();
        return total_;
    }

private:
    void flush() {
        if (count_ == 0) return;
        float fractions[8];
        tracer_->visibility(pointers_, static_cast<int>(count_), target_, fractions);
        for (std::size_t k = 0; k < count_; ++k)
            if (fractions[k] > 0.0f) total_ += values_[k] * static_cast<double>(fractions[k]);
        count_ = 0;
    }

    const Tracer* tracer_;
    Surface points_[8];
    const Surface* pointers_[8];
    dvec3 values_[8];
    glm::vec3 target_{0};
    std::size_t count_ = 0;
    dvec3 total_{0.0};
};

// One camera ray up to its surface or the far end.
struct Ray {
    dvec3 eye_m;
    dvec3 way; // unit
    double length_m;
    // Optical depth from the eye at equal steps; empty where the haze is even.
    std::vector<double> depths;

    dvec3 at(double t_m) const { return eye_m + way * t_m; }
};

struct Lamp {
    const shared::Light& light;
    ReferenceBeam beam;
    dvec3 position_m;
    std::vector<glm::vec3> lens_m; // where shadow rays end

    // On the way from the apex, z_m of it along the axis: from here there is haze.
    dvec3 leaves_lens(const dvec3& way_m, double z_m) const {
        const double fraction = z_m > 0.0 ? static_cast<double>(light.lens_m) / z_m : 0.0;
        return position_m + way_m * std::clamp(fraction, 0.0, 1.0);
    }
};

class ReferenceJob {
public:
    ReferenceJob(const Tracer* tracer, const scene::Camera& camera, const std::vector<shared::Light>& lights,
                 const shared::Gobos& gobos, const shared::Haze& haze, float ambient_lux,
                 const ReferenceOptions& options)
        : tracer_(tracer), shadows_(options.shadows ? tracer : nullptr), options_(options),
          medium_(haze, options.density, options.density_samples),
          ambient_lux_(static_cast<double>(ambient_lux)), width_(camera.width), height_(camera.height),
          picture((camera.width + options.every - 1) / options.every,
                  (camera.height + options.every - 1) / options.every, 3) {
        const glm::dmat4 world(scene::camera_to_world(camera));
        const double tan_y = std::tan(glm::radians(static_cast<double>(camera.fov_y_deg)) * 0.5);
        right_ = dvec3(world[0]) * (tan_y * width_ / height_);
        up_ = dvec3(world[1]) * tan_y;
        forward_ = -dvec3(world[2]);
        eye_m_ = dvec3(world[3]);
        lamps_.reserve(lights.size());
        for (const shared::Light& light : lights)
            lamps_.push_back({light, ReferenceBeam(light, gobos, options.beam), dvec3(light.position_m),
                              lens_points(light, options.lens_samples)});
    }

    void trace_row(int row) {
        const DenormalsOff mode; // of this thread, for Embree
        for (int column = 0; column < picture.width; ++column) {
            if (stopped()) return;
            const dvec3 value = pixel(column * options_.every, row * options_.every);
            bool finite = true;
            for (int c = 0; c < 3; ++c) {
                const auto stored = static_cast<float>(value[c]);
                finite = finite && std::isfinite(stored);
                picture.at(column, row)[c] = stored;
            }
            if (!finite) mark_bad(static_cast<std::int64_t>(row) * picture.width + column);
        }
        const std::scoped_lock lock(progress_mutex_);
        ++rows_done_;
        if (options_.progress) options_.progress(static_cast<double>(rows_done_) / picture.height);
    }

    bool stopped() {
        if (!stopped_ && options_.stop && options_.stop()) stopped_ = true;
        return stopped_;
    }

    Result<void> verdict() const {
        if (stopped_) return Error{"stopped before the reference picture was finished", ""};
        if (bad_count_ == 0) return {};
        return Error{
            std::to_string(bad_count_) + " of " + std::to_string(picture.width * picture.height) +
                " pixels of the reference picture are not finite; expected finite camera, lights and haze",
            "pixel (" + std::to_string(first_bad_ % picture.width * options_.every) + ", " +
                std::to_string(first_bad_ / picture.width * options_.every) + ")"};
    }

private:
    static std::vector<glm::vec3> lens_points(const shared::Light& light, int count) {
        // Where the light hangs, as its maps and passes have it.
        const glm::vec3 middle_m = light.position_m - light.off_map_m;
        if (count == 1) return {middle_m};
        std::vector<glm::vec3> points;
        for (int k = 0; k < count; ++k) { // Vogel's spiral: even over the disc
            const double radius_m = static_cast<double>(light.disc_radius_m) * std::sqrt((k + 0.5) / count);
            const double angle = k * pi * (3.0 - std::sqrt(5.0));
            points.push_back(middle_m + light.axis_u * static_cast<float>(radius_m * std::cos(angle)) +
                             light.axis_v * static_cast<float>(radius_m * std::sin(angle)));
        }
        return points;
    }

    dvec3 pixel(int x, int y) const {
        const int n = options_.pixel_samples;
        dvec3 sum(0.0);
        for (int k = 0; k < n * n; ++k) {
            const double px = x + (k % n + 0.5) / n;
            const int row = k / n;
            const double py = y + (row + 0.5) / n;
            // A blended surface shows its fraction of the positions; one position alone shows what is half
            // opaque.
            const float blend = n == 1 ? -1.0f : to_unit(reverse_bits(static_cast<std::uint32_t>(k)));
            sum += radiance(px, py, blend);
        }
        return sum / static_cast<double>(n * n);
    }

    dvec3 radiance(double px, double py, float blend) const {
        const dvec3 way =
            glm::normalize(forward_ + right_ * (2.0 * px / width_ - 1.0) + up_ * (1.0 - 2.0 * py / height_));
        Surface surface;
        if (tracer_ != nullptr)
            surface = tracer_->first_hit(glm::vec3(eye_m_), glm::vec3(way), blend, Sees::everything);
        const bool hit = surface.instance >= 0;
        Ray ray{eye_m_, way, hit ? glm::length(dvec3(surface.position) - eye_m_) : options_.far_m, {}};
        if (!medium_.homogeneous()) measure_depths(ray);

        dvec3 sum(0.0);
        if (options_.surfaces && hit) {
            for (const Lamp& lamp : lamps_) sum += on_surface(surface, lamp);
            sum += dvec3(surface.emission) + even_light(surface);
            sum *= seen_through(ray, ray.length_m);
        }
        if (options_.air)
            for (const Lamp& lamp : lamps_) sum += in_air(ray, lamp);
        return sum;
    }

    void measure_depths(Ray& ray) const {
        const int steps = options_.air_samples;
        const double step_m = ray.length_m / steps;
        ray.depths.assign(static_cast<std::size_t>(steps) + 1, 0.0);
        for (int k = 0; k < steps; ++k)
            ray.depths[static_cast<std::size_t>(k) + 1] =
                ray.depths[static_cast<std::size_t>(k)] +
                medium_.density(ray.at((k + 0.5) * step_m)) * medium_.extinction_per_m() * step_m;
    }

    // Transmittance from the eye.
    double seen_through(const Ray& ray, double t_m) const {
        if (ray.depths.empty()) return std::exp(-medium_.extinction_per_m() * t_m);
        const auto steps = static_cast<double>(ray.depths.size() - 1);
        const double place = std::clamp(t_m / ray.length_m * steps, 0.0, steps);
        const auto below = std::min(static_cast<std::size_t>(place), ray.depths.size() - 2);
        return std::exp(
            -glm::mix(ray.depths[below], ray.depths[below + 1], place - static_cast<double>(below)));
    }

    // 1/m^2 of physics, or what the show has instead.
    double weakened(double d_m) const {
        const double sum = static_cast<double>(options_.attenuation.constant) +
                           static_cast<double>(options_.attenuation.linear) * d_m +
                           static_cast<double>(options_.attenuation.quadratic) * d_m * d_m;
        return 1.0 / std::max(sum, d_m * d_m / static_cast<double>(shared::kAttenuationMost));
    }

    dvec3 on_surface(const Surface& surface, const Lamp& lamp) const {
        const dvec3 place_m(surface.position);
        const dvec3 light_way = place_m - lamp.position_m;
        const dvec3 gate_m = lamp.beam.to_gate(light_way);
        const dvec3 candela = lamp.beam.candela(gate_m);
        if (candela == dvec3(0.0)) return candela;
        const double reaching =
            std::exp(-medium_.optical_depth(lamp.leaves_lens(light_way, gate_m.z), place_m)) *
            weakened(std::max(glm::length(light_way), kNearest_m));
        dvec3 sum(0.0);
        for (const glm::vec3& source_m : lamp.lens_m) {
            const dvec3 to_light = dvec3(source_m) - place_m;
            const dvec3 reflected =
                reference_brdf_times_cosine(surface.brdf, dvec3(surface.normal), dvec3(surface.to_viewer),
                                            to_light / std::max(glm::length(to_light), kNearest_m)) *
                reaching;
            if (reflected == dvec3(0.0)) continue;
            const Surface* from = &surface;
            float fraction = 1.0f;
            if (shadows_ != nullptr) shadows_->visibility(&from, 1, source_m, &fraction);
            sum += reflected * static_cast<double>(fraction);
        }
        return candela * sum / static_cast<double>(lamp.lens_m.size());
    }

    // Under ambient_lux from everywhere that nothing near keeps away.
    dvec3 even_light(const Surface& surface) const {
        if (ambient_lux_ == 0.0) return dvec3(0.0);
        double open = 0.0;
        const Surface* packet[8];
        std::fill(std::begin(packet), std::end(packet), &surface);
        for (std::uint32_t first = 0; first < kSkyRays; first += 8) {
            glm::vec3 ways[8];
            float fractions[8];
            for (std::uint32_t k = 0; k < 8; ++k)
                ways[k] = cosine_direction(surface.normal, sobol_2d(first + k, 11));
            tracer_->open_sky(packet, 8, ways, fractions);
            for (const float fraction : fractions) open += static_cast<double>(fraction);
        }
        const double cosine = std::abs(glm::dot(dvec3(surface.normal), dvec3(surface.to_viewer)));
        return reference_brdf_albedo(surface.brdf, cosine) * (ambient_lux_ * open / (pi * kSkyRays));
    }

    dvec3 in_air(const Ray& ray, const Lamp& lamp) const {
        const dvec3 eye = lamp.beam.to_gate(ray.eye_m - lamp.position_m);
        const dvec3 way = lamp.beam.to_gate(ray.way);
        const double lens_m = lamp.light.lens_m;
        // Light leaves from the plane of the lens: an edge that no sample should straddle.
        double begin_m = 0.0;
        double end_m = ray.length_m;
        const double cross_m = (lens_m - eye.z) / way.z;
        if (way.z > 0.0) begin_m = std::max(begin_m, cross_m);
        if (way.z < 0.0) end_m = std::min(end_m, cross_m);
        if (way.z == 0.0 && eye.z <= lens_m) return dvec3(0.0);
        if (begin_m >= end_m) return dvec3(0.0);

        // Equi-angular about the apex, as wide as a panel is; a ray through it keeps a scale above zero and
        // stays finite.
        const double closest_m = glm::dot(lamp.position_m - ray.eye_m, ray.way);
        const double passes_m = glm::length(ray.at(closest_m) - lamp.position_m);
        const double panel_m = lamp.light.panel_m;
        const double scale_m = std::max(std::hypot(passes_m, panel_m), kNearest_m);
        const double first = std::atan((begin_m - closest_m) / scale_m);
        const double step = (std::atan((end_m - closest_m) / scale_m) - first) / options_.air_samples;

        ShadowedSum sum(shadows_);
        for (int k = 0; k < options_.air_samples; ++k) {
            const double tangent = std::tan(first + (k + 0.5) * step);
            const double t_m = std::clamp(closest_m + scale_m * tangent, begin_m, end_m);
            const dvec3 gate_m = eye + way * t_m;
            if (gate_m.z <= lens_m) continue;
            const dvec3 candela = lamp.beam.candela(gate_m);
            if (candela == dvec3(0.0)) continue;
            const dvec3 place_m = ray.at(t_m);
            const dvec3 light_way = place_m - lamp.position_m;
            const double distance_m = std::max(glm::length(light_way), kNearest_m);
            const double dt_m = scale_m * (1.0 + tangent * tangent) * step;
            const double weight =
                seen_through(ray, t_m) *
                std::exp(-medium_.optical_depth(lamp.leaves_lens(light_way, gate_m.z), place_m)) *
                medium_.phase(-glm::dot(light_way, ray.way) / distance_m,
                              distance_m / std::hypot(distance_m, panel_m)) *
                medium_.density(place_m) * dt_m * weakened(distance_m);
            sum.add(place_m, lamp.lens_m[static_cast<std::size_t>(k) % lamp.lens_m.size()], candela * weight);
        }
        return sum.total() * medium_.scattering_per_m();
    }

    void mark_bad(std::int64_t index) {
        const std::scoped_lock lock(progress_mutex_);
        first_bad_ = bad_count_ == 0 ? index : std::min(first_bad_, index);
        ++bad_count_;
    }

    const Tracer* tracer_;
    const Tracer* shadows_; // null: everything is visible
    const ReferenceOptions& options_;
    const ReferenceMedium medium_;
    double ambient_lux_;
    double width_;
    double height_;
    dvec3 right_{0.0};
    dvec3 up_{0.0};
    dvec3 forward_{0.0};
    dvec3 eye_m_{0.0};
    std::vector<Lamp> lamps_;
    std::atomic<bool> stopped_{false};
    std::mutex progress_mutex_;
    int rows_done_ = 0;
    std::int64_t first_bad_ = 0;
    std::int64_t bad_count_ = 0;

public:
    image::ImageF picture;
};

Result<void> check_range(const char* name, int value, int least, int most) {
    if (value >= least && value <= most) return {};
    return Error{std::string(name) + " is " + std::to_string(value) + ", expected " + std::to_string(least) +
                     " to " + std::to_string(most),
                 "reference picture"};
}

} // namespace

Result<image::ImageF> reference_picture(const Tracer* tracer, const scene::Camera& camera,
                                        const std::vector<shared::Light>& lights, const shared::Gobos& gobos,
                                        const shared::Haze& haze, float ambient_lux,
                                        const ReferenceOptions& options) {
    TRY_VOID(check_range("width", camera.width, 1, image::kMaxSide));
    TRY_VOID(check_range("height", camera.height, 1, image::kMaxSide));
    TRY_VOID(check_range("air_samples", options.air_samples, 1, 1 << 20));
    TRY_VOID(check_range("pixel_samples", options.pixel_samples, 1, 64));
    TRY_VOID(check_range("lens_samples", options.lens_samples, 1, 4096));
    TRY_VOID(check_range("density_samples", options.density_samples, 1, 1 << 20));
    TRY_VOID(check_range("every", options.every, 1, image::kMaxSide));
    TRY_VOID(check_range("threads", options.threads, 0, 4096));
    if (!(options.far_m > 0.0f) || !std::isfinite(options.far_m))
        return Error{"far_m is " + std::to_string(options.far_m) + ", expected metres above zero",
                     "reference picture"};

    ReferenceJob job(tracer, camera, lights, gobos, haze, ambient_lux, options);
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(0, job.picture.height, [&](int row) { job.trace_row(row); }); });
    TRY_VOID(job.verdict());
    return std::move(job.picture);
}

} // namespace ghost::bake
