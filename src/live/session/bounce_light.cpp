// SPDX-License-Identifier: Apache-2.0
#include "live/session/bounce_light.h"

#include "bake/hasher.h"
#include "bake/keys.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "beam_groups/light_places.h"
#include "bounce/bounce_box.h"
#include "bounce/bounce_file.h"
#include "bounce/bounce_solver.h"
#include "disk/files.h"
#include "light/gobos.h"
#include "light/rig.h"
#include "show/show.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <exception>
#include <map>
#include <set>
#include <utility>

namespace ghost::app {
namespace {

constexpr float kBesideLamp_m = 0.5f; // there is air
constexpr int kPasses = 2;
constexpr double kTold = 0.03; // of the work, before what is left can be told
constexpr auto kLookEvery = std::chrono::milliseconds(100);

// Wherever their heads point.
std::vector<glm::vec3> lamps_of(const scene::Show& show) {
    std::vector<glm::vec3> lamps_m;
    for (const scene::PatchedFixture& fixture : show.fixtures)
        for (std::size_t stop = 0; stop < fixture.stops_m().size(); ++stop)
            for (const glm::vec3& place_m : scene::light_places_m(fixture, stop)) lamps_m.push_back(place_m);
    return lamps_m;
}

glm::vec3 place_of(const shared::Light& light) {
    return light.position_m - light.off_map_m;
}

bool same_lights(const std::vector<shared::Light>& a, const std::vector<shared::Light>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

bool same_slides(const std::vector<shared::SlidePicture>& a, const std::vector<shared::SlidePicture>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& one, const auto& other) { return one.levels == other.levels; });
}

bake::BounceOptions options_of(scene::BounceDetail level) {
    bake::BounceOptions options;
    if (level == scene::BounceDetail::room) {
        options.most_surfels /= 4;
        options.most_cells /= 4;
    } else if (level == scene::BounceDetail::fine) {
        options.most_surfels *= 3;
        options.most_cells *= 3;
    }
    return options;
}

// Where the lights of the show look; made when a light is first somewhere.
class Sights {
public:
    Sights(const bake::Tracer& tracer, const scene::Bounce& bounce, const std::vector<glm::vec3>& stay_m)
        : tracer_(tracer), bounce_(bounce), index_(bounce) {
        constexpr std::size_t kMostFine = 128; // 84 MB
        for (std::size_t k = 0; k < std::min(stay_m.size(), kMostFine); ++k) stay_.insert(rounded(stay_m[k]));
    }

    const scene::LampSight* of(const glm::vec3& place_m) {
        constexpr std::size_t kMost = 4096;
        if (known_.size() >= kMost) known_.clear(); // lamps that travel
        auto& sight = known_[{place_m.x, place_m.y, place_m.z}];
        if (!sight)
            sight = std::make_unique<scene::LampSight>(bake::lamp_sight(
                tracer_, bounce_, index_, place_m,
                stay_.contains(rounded(place_m)) ? scene::kLampSightSize : scene::kSmallLampSightSize));
        return sight.get();
    }

private:
    using Millimetres = std::array<int, 3>;
    static Millimetres rounded(const glm::vec3& place_m) {
        const glm::ivec3 mm(glm::round(place_m * 1e3f)); // at most 10 km
        return {mm.x, mm.y, mm.z};
    }

    const bake::Tracer& tracer_;
    const scene::Bounce& bounce_;
    const bake::SurfelIndex index_;
    std::set<Millimetres> stay_; // where lamps hang while nothing travels
    std::map<std::array<float, 3>, std::unique_ptr<scene::LampSight>> known_;
};

} // namespace

BounceLight::BounceLight(const scene::Show& show, const scene::Stage& stage, scene::BounceDetail level,
                         const shared::Gobos& gobos)
    : stage_(stage), fixtures_(show.fixtures.size()), home_(show.cache_home()),
      file_(scene::bounce_file(show, level)), options_(options_of(level)),
      passes_(level == scene::BounceDetail::fine ? kPasses + 1 : kPasses), lamps_m_(lamps_of(show)),
      gobos_(gobos), begin_s_(steady_now_s()) {
    options_.box = scene::bounce_box(stage, lamps_m_);
    options_.stop = [this] { return stop_ || stop_making_ || interrupted(); };
    options_.progress = [this](double share) { share_ = share; };
    for (const glm::vec3& lamp_m : lamps_m_)
        for (const float aside_m : {0.0f, -kBesideLamp_m, kBesideLamp_m}) // whatever stands round its middle
            options_.seeds_m.push_back(lamp_m + glm::vec3(0, 0, aside_m));
    // Not of cameras where there are lamps: one that is added changes no light.
    if (lamps_m_.empty())
        for (const scene::Camera& camera : show.cameras) options_.seeds_m.push_back(camera.position_m);
    thread_ = std::thread([this] { run(); });
}

BounceLight::~BounceLight() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

std::shared_ptr<const scene::BounceVolumes> BounceLight::update(const std::vector<shared::Light>& lights,
                                                                const shared::Gobos& gobos,
                                                                const shared::Haze& haze,
                                                                const glm::vec3& eye_m, bool waits) {
    const bool same = asked_.number > 0 && eye_m == asked_.eye_m && same_lights(lights, asked_.lights) &&
                      std::memcmp(&haze, &asked_.haze, sizeof haze) == 0 &&
                      same_slides(gobos.slides, asked_.slides);
    if (!same) asked_ = {lights, gobos.slides, haze, eye_m, asked_.number + 1};
    std::unique_lock lock(mutex_);
    if (failed_) return nullptr;
    if (!same) {
        wanted_ = asked_;
        changed_.notify_all();
    }
    if (waits) changed_.wait(lock, [&] { return solved_number_ == asked_.number || failed_ || stop_; });
    return std::exchange(solved_, nullptr);
}

std::optional<double> BounceLight::left_s() const {
    const double share = share_;
    if (share < kTold) return std::nullopt;
    return (steady_now_s() - begin_s_) * (1 - share) / share;
}

void BounceLight::wait_for_links(const std::function<void(double share)>& on_progress) {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, kLookEvery, [&] { return made_ || stop_; })) on_progress(share_);
}

void BounceLight::wait_for_links(bool quiet) {
    Progress progress("links of bounced light",
                      quiet ? Progress::Style::silent : Progress::style_for_stderr(), steady_now_s());
    wait_for_links([&](double share) { progress.update(share, steady_now_s(), ""); });
    progress.finish();
}

void BounceLight::stop_making() {
    if (!made_) stop_making_ = true;
}

bool BounceLight::has_failed() {
    const std::lock_guard lock(mutex_);
    return failed_;
}

bool BounceLight::is_up_to_date() {
    const std::lock_guard lock(mutex_);
    return failed_ || (asked_.number > 0 && solved_number_ == asked_.number && !solved_);
}

std::optional<Error> BounceLight::take_failure() {
    const std::lock_guard lock(mutex_);
    return std::exchange(failure_, std::nullopt);
}

// Raise kVersion when the same stage gives other links than before.
std::string BounceLight::key() const {
    constexpr int kVersion = 1;
    bake::Hasher hash;
    hash.value(kVersion);
    hash.text(bake::stage_keys(stage_, fixtures_).stage);
    hash.bytes(&options_.box, sizeof options_.box);
    hash.list(options_.seeds_m);
    hash.value(options_.most_cells);
    hash.value(options_.most_surfels);
    return hash.hex();
}

Result<void> BounceLight::make_links(const bake::Tracer& tracer) {
    const std::string wanted = key();
    const auto complain = [&](const Error& error) {
        const std::lock_guard lock(mutex_);
        failure_ = error;
    };
    auto kept = scene::read_bounce(file_, wanted);
    if (!kept.ok()) complain(kept.error());
    if (kept.ok() && *kept) {
        bounce_ = std::move(**kept);
        made_ = true;
        return {};
    }
    scene::BounceParts parts(file_, home_, wanted);
    options_.parts = &parts;
    Result<scene::Bounce> made = bake::make_bounce(tracer, options_);
    options_.parts = nullptr;
    if (const auto failure = parts.take_failure()) complain(*failure);
    TRY(bounce_, std::move(made));
    Result<void> written = make_folders(file_.parent_path(), home_);
    if (written.ok()) written = scene::write_bounce(file_, wanted, bounce_);
    if (written.ok())
        parts.remove_all();
    else
        complain({written.error().what + "; the links of bounced light are not kept", written.error().where});
    made_ = true;
    return {};
}

void BounceLight::run() {
    try {
        const bake::Tracer tracer(stage_);
        const Result<void> made = make_links(tracer);
        if (!made.ok()) {
            const std::lock_guard lock(mutex_);
            if (!stop_ && !stop_making_)
                failure_ = Error{made.error().what + "; no light bounces", made.error().where};
            failed_ = true;
            made_ = true;
            changed_.notify_all();
            return;
        }
        changed_.notify_all();
        scene::BounceSolver solver(bounce_);
        Sights sights(tracer, bounce_, lamps_m_);
        for (;;) {
            Wanted wanted;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [&] { return stop_ || wanted_; });
                if (stop_) return;
                wanted = std::move(*std::exchange(wanted_, std::nullopt));
            }
            const double begin_s = steady_now_s();
            solver.set_haze(wanted.haze);
            gobos_.slides = wanted.slides;
            std::vector<const scene::LampSight*> of_lights;
            for (const shared::Light& light : wanted.lights) of_lights.push_back(sights.of(place_of(light)));
            const scene::BounceSolution& solution = solver.solve(wanted.lights, of_lights, gobos_, passes_);
            auto volumes = std::make_shared<scene::BounceVolumes>();
            fill_lux(bounce_, solution, *volumes);
            fill_glow(bounce_, solver.air(), solution, wanted.eye_m, *volumes);
            volumes->extinction_per_m = solver.air().extinction_per_m;
            solve_ms_ = 1e3 * (steady_now_s() - begin_s);
            const std::lock_guard lock(mutex_);
            solved_ = std::move(volumes);
            solved_number_ = wanted.number;
            changed_.notify_all();
        }
    } catch (const std::exception& problem) { // no memory: the picture goes on without
        const std::lock_guard lock(mutex_);
        failure_ = Error{std::string(problem.what()) + "; no light bounces", "bounced light"};
        failed_ = true;
        made_ = true;
        changed_.notify_all();
    }
}

Result<std::shared_ptr<const scene::BounceVolumes>>
bounced_now(const scene::Show& show, const scene::Stage& stage, scene::BounceDetail level, scene::Rig& rig,
            const scene::GoboStack& gobos, const shared::Haze& haze, bool quiet) {
    if (level == scene::BounceDetail::off) return std::shared_ptr<const scene::BounceVolumes>();
    BounceLight light(show, stage, level, gobos.images);
    light.wait_for_links(quiet);
    auto solved =
        light.update(rig.lit(gobos, scene::DistanceMaps{}).lights, gobos.images, haze, glm::vec3(0), true);
    const std::optional<Error> failure = light.take_failure();
    if (!solved) return failure.value_or(Error{"interrupted", ""});
    if (failure) log_warning(failure->text());
    return solved;
}

} // namespace ghost::app
