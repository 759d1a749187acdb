// SPDX-License-Identifier: Apache-2.0
#include "reference/light_walk.h"

#include "rays/sampling.h"
#include "reference/private/walk_source.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace ghost::bake {
namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr std::int64_t kLeastBatches = 64; // errors of pixels are told from the differences between batches
constexpr std::int64_t kMostOfBatch = 1 << 16;
constexpr std::size_t kMostSteps = 4 * kWalkOrders; // of one particle
constexpr double kFar_m = 1e5;
constexpr double kRouletteBelow = 0.1; // of the weight that a particle began with
// Haze nearer to the eye than this is as bright as there: 1/d^2 is singular in pixels, not in their mean.
constexpr double kNearEye_m = 0.3;
// A place in haze is a ball as large, seen as so many points at most: near the eye it covers many pixels.
constexpr double kBall_m = 0.15;
constexpr int kMostPoints = 64;
constexpr std::size_t kCountedOrders = 5; // by instance

double largest(const dvec3& rgb) {
    return std::max({rgb.x, rgb.y, rgb.z});
}

// PCG32 of O'Neill, a stream for each particle.
class Random {
public:
    Random(std::uint32_t seed, std::uint64_t particle)
        : state_((std::uint64_t{hash_u32(seed, static_cast<std::uint32_t>(particle >> 32))} << 32 |
                  hash_u32(seed + 1, static_cast<std::uint32_t>(particle))) *
                     6364136223846793005ull +
                 1442695040888963407ull) {
        (*this)();
    }
    double operator()() {
        const std::uint64_t before = state_;
        state_ = before * 6364136223846793005ull + 1442695040888963407ull;
        const auto mixed = static_cast<std::uint32_t>(((before >> 18) ^ before) >> 27);
        const auto turn = static_cast<std::uint32_t>(before >> 59);
        return ((mixed >> turn) | (mixed << ((32 - turn) & 31))) * 0x1p-32;
    }

private:
    std::uint64_t state_;
};

// At an angle of this cosine to the axis, turned about it by a fraction of a circle.
dvec3 turned_from(const dvec3& axis, double cosine, double turn) {
    const double sign = axis.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (sign + axis.z), b = axis.x * axis.y * a;
    const dvec3 s(1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
    const dvec3 t(b, sign + axis.y * axis.y * a, -axis.y);
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), angle = 2 * pi * turn;
    return glm::normalize(s * (sine * std::cos(angle)) + t * (sine * std::sin(angle)) + axis * cosine);
}

// Reflection by its two layers, chosen by chance.
struct Bounce {
    dvec3 way;
    dvec3 weight;
};

Bounce reflect(const shared::Brdf& brdf, const dvec3& n, const dvec3& v, Random& random) {
    const double a2 = std::pow(static_cast<double>(brdf.alpha), 2.0);
    const double mirror = largest(dvec3(brdf.f0)) + 0.05 * static_cast<double>(brdf.f90);
    const double matt = largest(dvec3(brdf.diffuse));
    const double shiny = mirror > 0.0 ? std::clamp(mirror / (mirror + matt), 0.1, 0.9) : 0.0;
    dvec3 way;
    if (random() < shiny) { // a facet as the distribution of Trowbridge and Reitz has them
        const double u = random();
        const dvec3 h = turned_from(n, std::sqrt((1.0 - u) / (1.0 + (a2 - 1.0) * u)), random());
        way = 2.0 * glm::dot(v, h) * h - v;
    } else {
        way = turned_from(n, std::sqrt(1.0 - random()), random());
    }
    const double nl = glm::dot(n, way);
    if (!(nl > 0.0)) return {way, dvec3(0.0)};
    const dvec3 h = glm::normalize(v + way);
    const double nh = glm::dot(n, h), vh = std::max(glm::dot(v, h), 1e-6);
    const double distribution = a2 / (pi * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
    const double density = (1.0 - shiny) * nl / pi + shiny * distribution * nh / (4.0 * vh);
    return {way, reference_brdf_times_cosine(brdf, n, v, way) / density};
}

struct Pixels {
    std::vector<dvec3> sum, squares; // empty: no picture
};

// What one batch of particles found, or all batches so far.
struct Tally {
    double sent_lm = 0;
    std::array<OrderPower, kWalkOrders> orders{};
    std::vector<std::array<double, kCountedOrders>> by_instance;
    std::vector<dvec3> pixels;
};

// The camera as particles are joined to it.
class Eye {
public:
    explicit Eye(const scene::Camera& camera) : width_(camera.width), height_(camera.height) {
        const glm::dmat4 world(scene::camera_to_world(camera));
        tan_y_ = std::tan(glm::radians(static_cast<double>(camera.fov_y_deg)) * 0.5);
        tan_x_ = tan_y_ * width_ / height_;
        right_ = dvec3(world[0]);
        up_ = dvec3(world[1]);
        forward_ = -dvec3(world[2]);
        place_m = dvec3(world[3]);
    }

    // Of the way from the eye; false: it is not in the picture.
    bool pixel(const dvec3& way, std::size_t& index, double& steradians) const {
        const double z = glm::dot(way, forward_);
        if (!(z > 1e-6)) return false;
        const double x = glm::dot(way, right_) / (z * tan_x_), y = glm::dot(way, up_) / (z * tan_y_);
        if (!(std::abs(x) < 1.0 && std::abs(y) < 1.0)) return false;
        const int column = std::min(static_cast<int>((0.5 + 0.5 * x) * width_), width_ - 1);
        const int row = std::min(static_cast<int>((0.5 - 0.5 * y) * height_), height_ - 1);
        index = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(column);
        steradians = 4.0 * tan_x_ * tan_y_ / (static_cast<double>(width_) * height_) * z * z * z;
        return true;
    }

    dvec3 place_m{0};

private:
    int width_, height_;
    double tan_x_, tan_y_;
    dvec3 right_{0}, up_{0}, forward_{0};
};

class Walker {
public:
    Walker(const Tracer& tracer, const std::vector<shared::Light>& lights, const shared::Gobos& gobos,
           const shared::Haze& haze, const WalkOptions& options)
        : tracer_(tracer), options_(options), source_(lights, gobos, options.beam), medium_(haze, {}, 1),
          haze_(haze) {
        if (options.camera) eye_ = std::make_unique<Eye>(*options.camera);
        batches_ = std::max(kLeastBatches, (options.particles + kMostOfBatch - 1) / kMostOfBatch);
        of_batch_ = (options.particles + batches_ - 1) / batches_;
    }

    std::int64_t batches() const { return batches_; }
    bool is_dark() const { return source_.is_dark(); }

    std::unique_ptr<Tally> batch(std::int64_t index) {
        const DenormalsOff mode; // of this thread, for Embree
        auto tally = std::make_unique<Tally>();
        tally->by_instance.resize(tracer_.stage().instances.size());
        if (eye_)
            tally->pixels.resize(static_cast<std::size_t>(options_.camera->width) *
                                 static_cast<std::size_t>(options_.camera->height));
        for (std::int64_t k = 0; k < of_batch_; ++k) {
            if ((k & 255) == 0 && stopped()) break;
            particle(index, k, *tally);
        }
        return tally;
    }

    bool stopped() {
        if (!stopped_ && options_.stop && options_.stop()) stopped_ = true;
        return stopped_;
    }

private:
    // The part of a ray in haze, from its begin on.
    bool in_air(const dvec3& from_m, const dvec3& way, double& begin_m, double& end_m) const {
        begin_m = 0;
        end_m = kFar_m;
        if (haze_.extinction_per_m <= 0.0f) return false;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = options_.air_low_m[axis], high = options_.air_high_m[axis];
            if (std::abs(way[axis]) < 1e-12) {
                if (from_m[axis] < low || from_m[axis] > high) return false;
                continue;
            }
            const double a = (low - from_m[axis]) / way[axis], b = (high - from_m[axis]) / way[axis];
            begin_m = std::max(begin_m, std::min(a, b));
            end_m = std::min(end_m, std::max(a, b));
        }
        return begin_m < end_m;
    }

    void particle(std::int64_t batch, std::int64_t k, Tally& tally) const {
        Random random(options_.seed, static_cast<std::uint64_t>(batch * of_batch_ + k));
        const double u[3] = {(static_cast<double>(k) + random()) / static_cast<double>(of_batch_), random(),
                             random()};
        const WalkStart start = source_.start(u);
        dvec3 from_m = start.from_m, way = start.way, flux(0.0);
        double first_weight = 0;
        std::size_t order = 0;
        for (std::size_t step = 0; step < kMostSteps && order < kWalkOrders; ++step) {
            const Surface surface = tracer_.first_hit(glm::vec3(from_m), glm::vec3(way),
                                                      static_cast<float>(random()), Sees::no_bodies);
            const bool met = surface.instance >= 0;
            const double wall_m = met ? static_cast<double>(surface.distance_m) : kFar_m;
            double begin_m, end_m, free_m = kFar_m;
            if (in_air(from_m, way, begin_m, end_m)) {
                const double drawn_m =
                    begin_m - std::log(1.0 - random()) / static_cast<double>(haze_.extinction_per_m);
                if (drawn_m < std::min(wall_m, end_m)) free_m = drawn_m;
            }
            const bool scattered = free_m < wall_m;
            const dvec3 place_m = from_m + way * (scattered ? free_m : wall_m);
            if (step == 0) { // what the beam sends there
                flux = source_.candela(start.lamp, place_m - start.apex_m) *
                       (start.per_candela / static_cast<double>(of_batch_ * batches_));
                first_weight = largest(flux);
                tally.sent_lm += luminance(flux);
                if (!(first_weight > 0.0)) return;
            }
            OrderPower& power = tally.orders[order];
            if (scattered) {
                const double fraction = static_cast<double>(haze_.scattering_per_m / haze_.extinction_per_m);
                power.absorbed_in_air += luminance(flux) * (1.0 - fraction);
                flux *= fraction;
                const dvec3 on = scatter(way, random);
                from_m = place_m;
                if (glm::dot(way, on) > options_.straight_cosine) {
                    way = on;
                    continue;
                }
                power.in_air += luminance(flux);
                if (shows(order)) join(place_m, nullptr, way, flux, random, tally);
                way = on;
            } else if (met) {
                power.on_surfaces += luminance(flux);
                if (shows(order)) join(place_m, &surface, way, flux, random, tally);
                const Bounce bounce = reflect(surface.brdf, dvec3(surface.facet_normal), -way, random);
                flux *= bounce.weight;
                const double lumens = luminance(flux);
                power.reflected += lumens;
                if (order < kCountedOrders)
                    tally.by_instance[static_cast<std::size_t>(surface.instance)][order] += lumens;
                from_m = dvec3(surface.shadow_origin);
                way = bounce.way;
            } else {
                power.escaped += luminance(flux);
                return;
            }
            const double left = largest(flux) / first_weight;
            if (left < kRouletteBelow) {
                if (random() * kRouletteBelow >= left) return;
                flux *= kRouletteBelow / left;
            }
            ++order;
        }
    }

    bool shows(std::size_t order) const {
        return eye_ && static_cast<int>(order) >= options_.first_order &&
               static_cast<int>(order) <= options_.last_order;
    }

    dvec3 scatter(const dvec3& way, Random& random) const {
        const double g = random() < static_cast<double>(haze_.back_weight) ? haze_.back_g : haze_.forward_g;
        const double u = random();
        double cosine = 1.0 - 2.0 * u;
        if (std::abs(g) > 1e-3) {
            const double q = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
            cosine = (1.0 + g * g - q * q) / (2.0 * g);
        }
        return turned_from(way, std::clamp(cosine, -1.0, 1.0), random());
    }

    // Light that a place sends into the camera; surface null: haze.
    void join(const dvec3& place_m, const Surface* surface, const dvec3& way, const dvec3& flux,
              Random& random, Tally& tally) const {
        const float blend = static_cast<float>(random());
        const dvec3 from_eye = place_m - eye_->place_m;
        const double distance_m = glm::length(from_eye);
        if (!(distance_m > 1e-4)) return;
        const dvec3 to_eye = -from_eye / distance_m;
        std::size_t pixel = 0;
        double steradians = 0;
        if (!eye_->pixel(-to_eye, pixel, steradians)) return;
        // By reciprocity the cosine is that of the way to the eye.
        const dvec3 sent =
            surface ? reference_brdf_times_cosine(surface->brdf, dvec3(surface->facet_normal), -way, to_eye)
                    : dvec3(medium_.phase(glm::dot(way, to_eye)));
        if (sent == dvec3(0.0)) return;
        const Surface seen =
            tracer_.first_hit(glm::vec3(eye_->place_m), glm::vec3(-to_eye), blend, Sees::everything);
        const double slack_m = 2e-3 + 1e-4 * distance_m;
        if (seen.instance >= 0 && static_cast<double>(seen.distance_m) < distance_m - slack_m) return;
        const double near_m = surface ? distance_m : std::max(distance_m, kNearEye_m);
        const double three_times = surface || distance_m >= kNearEye_m ? 1.0 : 3.0;
        const dvec3 arrives = flux * sent *
                              (three_times / (near_m * near_m) *
                               std::exp(-static_cast<double>(haze_.extinction_per_m) * distance_m));
        const double ball = surface ? 0.0 : kBall_m / near_m; // radians
        const int points = std::clamp(static_cast<int>(pi * ball * ball / steradians), 1, kMostPoints);
        tally.pixels[pixel] += arrives / (steradians * points);
        for (int k = 1; k < points; ++k) {
            const dvec3 beside = turned_from(-to_eye, std::cos(ball * std::sqrt(random())), random());
            if (eye_->pixel(beside, pixel, steradians))
                tally.pixels[pixel] += arrives / (steradians * points);
        }
    }

    const Tracer& tracer_;
    const WalkOptions& options_;
    const WalkSource source_;
    const ReferenceMedium medium_;
    const shared::Haze haze_;
    std::unique_ptr<Eye> eye_;
    std::int64_t batches_ = 0, of_batch_ = 0;
    std::atomic<bool> stopped_{false};
};

void add_up(const Tally& batch, std::int64_t batches, Walk& walk, Pixels& pixels) {
    walk.sent_lm += batch.sent_lm;
    for (std::size_t k = 0; k < kWalkOrders; ++k) {
        OrderPower& to = walk.orders[k];
        const OrderPower& from = batch.orders[k];
        to.on_surfaces += from.on_surfaces;
        to.reflected += from.reflected;
        to.in_air += from.in_air;
        to.absorbed_in_air += from.absorbed_in_air;
        to.escaped += from.escaped;
    }
    for (std::size_t i = 0; i < batch.by_instance.size(); ++i)
        for (std::size_t k = 0; k < kCountedOrders; ++k)
            walk.reflected_by_instance[i][k] += batch.by_instance[i][k];
    for (std::size_t i = 0; i < batch.pixels.size(); ++i) {
        pixels.sum[i] += batch.pixels[i];
        const dvec3 whole = batch.pixels[i] * static_cast<double>(batches); // as if all batches were this one
        pixels.squares[i] += whole * whole;
    }
}

void finish_picture(const Pixels& pixels, std::int64_t batches, Walk& walk) {
    const auto n = static_cast<double>(batches);
    for (std::size_t i = 0; i < pixels.sum.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double mean = pixels.sum[i][c];
            const double variance = std::max(pixels.squares[i][c] / n - mean * mean, 0.0) / (n - 1.0);
            walk.picture.samples[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(mean);
            walk.error.samples[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(std::sqrt(variance));
        }
}

Error out_of_range(const std::string& what) {
    return {what, "walk of light"};
}

} // namespace

Result<Walk> walk_light(const Tracer& tracer, const std::vector<shared::Light>& lights,
                        const shared::Gobos& gobos, const shared::Haze& haze, const WalkOptions& options) {
    constexpr std::int64_t kMostParticles = 1'000'000'000'000;
    constexpr int kMostSide = 16384;
    if (options.particles < 1 || options.particles > kMostParticles)
        return out_of_range(std::to_string(options.particles) + " particles, expected 1 to " +
                            std::to_string(kMostParticles));
    if (options.first_order < 0 || options.last_order < options.first_order)
        return out_of_range("orders " + std::to_string(options.first_order) + " to " +
                            std::to_string(options.last_order) + ", expected a range from 0 on");
    if (options.camera && (options.camera->width < 1 || options.camera->height < 1 ||
                           options.camera->width > kMostSide || options.camera->height > kMostSide))
        return out_of_range("a picture of " + std::to_string(options.camera->width) + "x" +
                            std::to_string(options.camera->height) + " pixels, expected 1 to " +
                            std::to_string(kMostSide) + " a side");
    Walk walk;
    Pixels pixels;
    walk.reflected_by_instance.resize(tracer.stage().instances.size());
    if (options.camera) {
        walk.picture = walk.error = image::ImageF(options.camera->width, options.camera->height, 3);
        pixels.sum.resize(walk.picture.samples.size() / 3);
        pixels.squares = pixels.sum;
    }
    Walker walker(tracer, lights, gobos, haze, options);
    if (walker.is_dark()) return walk;
    // Batches are added in their order, whichever thread was faster.
    std::int64_t next = 0, done = 0;
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] {
        const std::size_t in_flight = 2 * static_cast<std::size_t>(arena.max_concurrency());
        tbb::parallel_pipeline(
            in_flight,
            tbb::make_filter<void, std::int64_t>(tbb::filter_mode::serial_in_order,
                                                 [&](tbb::flow_control& control) {
                                                     if (next == walker.batches() || walker.stopped())
                                                         control.stop();
                                                     return next++;
                                                 }) &
                tbb::make_filter<std::int64_t, std::shared_ptr<Tally>>(
                    tbb::filter_mode::parallel,
                    [&](std::int64_t index) { return std::shared_ptr<Tally>(walker.batch(index)); }) &
                tbb::make_filter<std::shared_ptr<Tally>, void>(
                    tbb::filter_mode::serial_in_order, [&](const std::shared_ptr<Tally>& tally) {
                        add_up(*tally, walker.batches(), walk, pixels);
                        ++done;
                        if (options.progress)
                            options.progress(static_cast<double>(done) /
                                             static_cast<double>(walker.batches()));
                    }));
    });
    if (walker.stopped()) return Error{"stopped before all particles were counted", "walk of light"};
    finish_picture(pixels, walker.batches(), walk);
    return walk;
}

} // namespace ghost::bake
