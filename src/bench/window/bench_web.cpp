// SPDX-License-Identifier: Apache-2.0
// Viewers of `serve`: how old a picture is when its last byte is there, and what they cost the engine: by
// processor time of a picture, with them and without them in turns, which other work on the machine disturbs
// less than a rate.
#include "base/interrupt.h"
#include "base/memory.h"
#include "base/signal.h"
#include "base/steady_time.h"
#include "bench/window/private/web_viewers.h"
#include "bench/window/window_tables.h"
#include "live/engine/engine.h"
#include "show/show.h"
#include "web/server.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

constexpr double kWarmUp_s = 3;
constexpr double kSettle_s = 1;
constexpr double kCounted_s = 8;
constexpr double kBeginShare = 0.5; // of the recording
constexpr double kOpen_s = 120;
constexpr int kTurns = 3;
constexpr int kMostMeasured = 20;
constexpr double kSlow_bytes_per_s = 150'000;

double process_cpu_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The engine with the first camera of the show, whose recording plays; its server.
class Served {
public:
    static Result<std::unique_ptr<Served>> open(const BenchOptions& options) {
        auto served = std::make_unique<Served>();
        web::ServerOptions server;
        server.most_viewers = kMostMeasured;
        TRY(served->server, web::Server::open(served->link_, server));
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

    // Of the same seconds of the recording, whenever it is asked. viewers: whose work is not the engine's.
    struct Counted {
        double per_s = 0;         // pictures
        double engine_cpu_ms = 0; // of a picture
        double server_cpu_ms = 0; // of a picture
    };
    Counted counted(const WebViewers* viewers) {
        request_.transport.at_s = begin_s_;
        ++request_.transport.seeks;
        send();
        (void)pictures_in(kSettle_s);
        const auto others_s = [&] { return viewers ? viewers->cpu_s() : 0.0; };
        const double begin_s = steady_now_s(), all_s = process_cpu_s(), server_s = server->cpu_s(),
                     viewers_s = others_s();
        const int pictures = pictures_in(kCounted_s);
        const double served_s = server->cpu_s() - server_s;
        const double engine_s = process_cpu_s() - all_s - served_s - (others_s() - viewers_s);
        Counted counted;
        counted.per_s = pictures / (steady_now_s() - begin_s);
        counted.engine_cpu_ms = 1e3 * engine_s / std::max(pictures, 1);
        counted.server_cpu_ms = 1e3 * served_s / std::max(pictures, 1);
        return counted;
    }
    int pictures_in(double seconds) {
        int pictures = 0;
        const double begin_s = steady_now_s();
        while (steady_now_s() - begin_s < seconds && !interrupted()) {
            (void)news_.wait_for(20ms);
            if (link_.picture.take()) ++pictures;
        }
        return pictures;
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

double part_of(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double median_of(const std::vector<Served::Counted>& all, double Served::Counted::*figure) {
    std::vector<double> values;
    for (const Served::Counted& one : all) values.push_back(one.*figure);
    return part_of(values, 0.5);
}

Result<void> measure(Served& served, int count, double slow_bytes_per_s, const BenchSink& sink) {
    std::vector<Served::Counted> alone, watched;
    std::vector<double> ages_ms, slow_ms;
    for (int turn = 0; turn < kTurns; ++turn) {
        alone.push_back(served.counted(nullptr));
        TRY(const auto viewers,
            WebViewers::look_on(served.server->port(), served.server->keys().token, count, slow_bytes_per_s));
        watched.push_back(served.counted(viewers.get()));
        const WebViewers::Ages ages = viewers->leave();
        ages_ms.insert(ages_ms.end(), ages.of_most_ms.begin(), ages.of_most_ms.end());
        slow_ms.insert(slow_ms.end(), ages.of_slow_ms.begin(), ages.of_slow_ms.end());
        if (interrupted()) return Error{"interrupted", "web"};
    }
    const double engine_alone_ms = median_of(alone, &Served::Counted::engine_cpu_ms),
                 engine_ms = median_of(watched, &Served::Counted::engine_cpu_ms),
                 server_ms = median_of(watched, &Served::Counted::server_cpu_ms);
    BenchRow row{"web",
                 std::to_string(count) + (count == 1 ? " viewer" : " viewers") +
                     (slow_bytes_per_s > 0 ? ", one of them slow" : ""),
                 {{"engine_cpu_ms_per_picture", engine_ms},
                  {"alone_cpu_ms_per_picture", engine_alone_ms},
                  {"server_cpu_ms_per_picture", server_ms},
                  {"lost_by_cpu_percent", 100 * (1 - engine_alone_ms / (engine_ms + server_ms))},
                  {"engine_per_s", median_of(watched, &Served::Counted::per_s)},
                  {"engine_alone_per_s", median_of(alone, &Served::Counted::per_s)},
                  {"pictures", static_cast<double>(ages_ms.size())},
                  {"last_byte_p50_ms", part_of(ages_ms, 0.5)},
                  {"last_byte_p95_ms", part_of(ages_ms, 0.95)},
                  {"memory_mb", static_cast<double>(used_memory_bytes()) * 1e-6}},
                 "1280x720 asked for, loopback, viewers in the same process, medians of " +
                     std::to_string(kTurns) + " turns with and without them"};
    if (slow_bytes_per_s > 0) {
        row.figures.push_back({"slow_pictures", static_cast<double>(slow_ms.size())});
        row.figures.push_back({"slow_last_byte_p50_ms", part_of(slow_ms, 0.5)});
        row.figures.push_back({"slow_last_byte_p95_ms", part_of(slow_ms, 0.95)});
    }
    sink(row);
    return {};
}

} // namespace

Result<void> bench_web(const BenchOptions& options, const BenchSink& sink) {
    TRY(const std::unique_ptr<Served> served, Served::open(options));
    (void)served->pictures_in(kWarmUp_s);
    for (const int count : {1, 5, kMostMeasured}) TRY_VOID(measure(*served, count, 0, sink));
    return measure(*served, 6, kSlow_bytes_per_s, sink);
}

} // namespace ghost::app
