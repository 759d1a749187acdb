// SPDX-License-Identifier: Apache-2.0
// Viewers of `serve`: how old a picture is when its last byte is there, and what they cost the engine: its
// pictures a second with them, and without them before and after.
#include "base/interrupt.h"
#include "base/memory.h"
#include "base/signal.h"
#include "base/steady_time.h"
#include "bench/window/private/web_viewers.h"
#include "bench/window/window_tables.h"
#include "live/engine/engine.h"
#include "show/show.h"
#include "web/server.h"

#include <cmath>
#include <limits>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

constexpr double kWarmUp_s = 3;
constexpr double kSettle_s = 1;
constexpr double kCounted_s = 8;
constexpr double kBeginShare = 0.5; // of the recording
constexpr double kOpen_s = 120;

// The engine with the first camera of the show, whose recording plays; its server.
class Served {
public:
    static Result<std::unique_ptr<Served>> open(const BenchOptions& options) {
        auto served = std::make_unique<Served>();
        TRY(served->server, web::Server::open(served->link_, {}));
        served->link_.on_news = [one = served.get()] {
            one->news_.raise();
            one->server->news();
        };
        EngineOptions engine;
        engine.listens = false;
        engine.session.device = options.device;
        engine.session.quiet = true;
        served->engine_ = std::make_unique<Engine>(served->link_, engine);
        ui::ViewRequest& request = served->request_;
        request.show = options.show;
        request.camera.width = 0;
        request.takes_baked = false;
        served->send();
        for (const double end_s = steady_now_s() + kOpen_s; steady_now_s() < end_s && !interrupted();) {
            (void)served->news_.wait_for(100ms);
            if (const auto problem = served->link_.not_opened.take()) return *problem;
            const auto opened = served->link_.opened.take();
            if (!opened) continue;
            if (opened->show->cameras.empty()) return Error{"has no camera", options.show};
            request.camera = opened->show->cameras.front();
            request.camera.width = 1280;
            request.camera.height = 720;
            served->begin_s_ = kBeginShare * opened->recording_s;
            served->send();
            return served;
        }
        return Error{"was not opened in time", options.show};
    }
    ~Served() { engine_.reset(); }

    // Pictures a second of the same seconds of the recording, whenever it is asked.
    double counted_rate() {
        request_.transport.at_s = begin_s_;
        ++request_.transport.seeks;
        send();
        (void)rate(kSettle_s);
        return rate(kCounted_s);
    }
    double rate(double seconds) {
        int pictures = 0;
        const double begin_s = steady_now_s();
        while (steady_now_s() - begin_s < seconds && !interrupted()) {
            (void)news_.wait_for(20ms);
            if (link_.picture.take()) ++pictures;
        }
        return pictures / (steady_now_s() - begin_s);
    }

    std::unique_ptr<web::Server> server;

private:
    void send() {
        ++request_.number;
        link_.request.put(request_);
        link_.wake.raise();
    }

    ui::Link link_;
    Signal news_;
    ui::ViewRequest request_;
    double begin_s_ = 0;             // of the recording
    std::unique_ptr<Engine> engine_; // goes before the server
};

double part_of(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

} // namespace

Result<void> bench_web(const BenchOptions& options, const BenchSink& sink) {
    TRY(const std::unique_ptr<Served> served, Served::open(options));
    (void)served->rate(kWarmUp_s);
    double alone = served->counted_rate();
    for (const int count : {1, 5, web::kMostViewers}) {
        TRY(const auto viewers,
            WebViewers::look_on(served->server->port(), served->server->keys().token, count));
        const double cpu_s = served->server->cpu_s(), begin_s = steady_now_s();
        const double watched = served->counted_rate();
        const double core_share = (served->server->cpu_s() - cpu_s) / (steady_now_s() - begin_s);
        const std::vector<double> ages_ms = viewers->leave();
        const double after = served->counted_rate();
        if (interrupted()) return Error{"interrupted", "web"};
        const double without = 0.5 * (alone + after);
        alone = after;
        sink({"web",
              std::to_string(count) + (count == 1 ? " viewer" : " viewers"),
              {{"engine_per_s", watched},
               {"engine_alone_per_s", without},
               {"engine_lost_percent", 100 * (1 - watched / without)},
               {"server_percent_of_core", 100 * core_share},
               {"pictures", static_cast<double>(ages_ms.size())},
               {"last_byte_p50_ms", part_of(ages_ms, 0.5)},
               {"last_byte_p95_ms", part_of(ages_ms, 0.95)},
               {"memory_mb", static_cast<double>(used_memory_bytes()) * 1e-6}},
              "1280x720 asked for, loopback, viewers in the same process"});
    }
    return {};
}

} // namespace ghost::app
