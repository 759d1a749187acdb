#pragma once
// SPDX-License-Identifier: Apache-2.0
// BounceLight: the bounced light of a session, on a thread of its own: links are made first (bake/bounce.h),
// then lights are solved as they change, the newest first. Pictures go on meanwhile. Calls from one thread;
// show and stage must outlive it and must not change but for what is shown.

#include "bake/bounce.h"
#include "base/result.h"
#include "bounce/bounce_parts.h"
#include "bounce/bounce_volumes.h"
#include "shared/gobos.h"
#include "shared/types.h"
#include "show/bounce_detail.h"
#include "stage/stage.h"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace ghost::scene {
class Rig;
struct GoboStack;
struct Show;
} // namespace ghost::scene

namespace ghost::app {

class BounceLight {
public:
    // gobos: those of the gates of all lights.
    BounceLight(const scene::Show& show, const scene::Stage& stage, scene::BounceDetail level,
                const shared::Gobos& gobos);
    ~BounceLight();
    BounceLight(const BounceLight&) = delete;
    BounceLight& operator=(const BounceLight&) = delete;

    // Solved since the last call, or null. Slides of the gobos may be others than before. waits: for the
    // solution of these lights, and for the links.
    std::shared_ptr<const scene::BounceVolumes> update(const std::vector<shared::Light>& lights,
                                                       const shared::Gobos& gobos, const shared::Haze& haze,
                                                       const glm::vec3& eye_m, bool waits);
    bool is_making_links() const { return !made_; }
    double made_share() const { return share_; }
    // Until the links are there; nothing: not known yet.
    std::optional<double> left_s() const;
    // Returns when the links are there, or cannot be. on_progress: now and then, with the share.
    void wait_for_links(const std::function<void(double share)>& on_progress);
    void wait_for_links(bool quiet); // with a bar
    // Ends the making of links, and no light bounces; what was made of them the next one takes up. Nothing
    // where they are there.
    void stop_making();
    bool is_stopped() const { return stop_making_; }
    // Why, take_failure says.
    bool has_failed();
    // Whether the newest lights are solved, or will never be.
    bool is_up_to_date();
    // Milliseconds that the thread took for the last solution.
    double solve_ms() const { return solve_ms_; }
    // Once: why there is none, or why its links could not be kept.
    std::optional<Error> take_failure();

private:
    struct Wanted {
        std::vector<shared::Light> lights;
        std::vector<shared::SlidePicture> slides;
        shared::Haze haze{};
        glm::vec3 eye_m{0};
        std::uint64_t number = 0;
    };
    void run();
    Result<void> make_links(const bake::Tracer& tracer);
    std::string key() const;

    const scene::Stage& stage_;
    const std::size_t fixtures_;
    const std::filesystem::path home_, file_; // of the show's caches, of the links
    bake::BounceOptions options_;
    int passes_;
    const std::vector<glm::vec3> lamps_m_; // while nothing travels
    shared::Gobos gobos_;                  // of the thread
    scene::Bounce bounce_;                 // likewise
    Wanted asked_;                         // last
    const double begin_s_;                 // of the steady clock
    std::atomic<bool> stop_{false}, stop_making_{false}, made_{false};
    std::atomic<double> share_{0}, solve_ms_{0};
    std::mutex mutex_; // of all below
    std::condition_variable changed_;
    std::optional<Wanted> wanted_;
    std::shared_ptr<const scene::BounceVolumes> solved_;
    std::uint64_t solved_number_ = 0;
    std::optional<Error> failure_;
    bool failed_ = false;
    std::thread thread_; // the last member: it uses all others
};

// What bounces of the light of a moment, without a device; waits for it. quiet: no bar for the links. Null:
// off. Error: why none bounces.
Result<std::shared_ptr<const scene::BounceVolumes>>
bounced_now(const scene::Show& show, const scene::Stage& stage, scene::BounceDetail level, scene::Rig& rig,
            const scene::GoboStack& gobos, const shared::Haze& haze, bool quiet);

} // namespace ghost::app
