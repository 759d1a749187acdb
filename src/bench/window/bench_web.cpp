// SPDX-License-Identifier: Apache-2.0
// Viewers of `serve`: how old a picture is when its last byte is there, and what they cost the engine. Short
// turns with them and without them alternate and play the same seconds of the recording, each pair others;
// what is lost is the median of the pairs. Every picture has all its pixels, for the pace of a picture that
// moves would make one turn's coarser than another's.
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
#include <mutex>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

constexpr double kSettle_s = 0.5, kTurn_s = 2;
constexpr double kSlowTurn_s = 8; // of a row with a viewer that falls behind
constexpr int kFewestSlowPairs = 3;
constexpr double kFromShare = 0.2, kToShare = 0.8; // of the recording, where turns begin
constexpr double kOpen_s = 120, kRest_s = 300;
constexpr double kRestingShare = 0.1; // of a processor, by a process that has nothing left to do
constexpr double kSlow_bytes_per_s = 150'000;

double process_cpu_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Turn {
    double per_s = 0;         // pictures
    double engine_cpu_ms = 0; // of a picture
    double server_cpu_ms = 0; // of a picture
    double memory_mb = 0;     // at its end
};

// The engine with the first camera of the show, whose recording plays; in turns with a server.
class Served {
public:
    static Result<std::unique_ptr<Served>> open(const BenchOptions& options);
    ~Served() { engine_.reset(); }

    // Until what is made in the background is made.
    Result<void> come_to_rest();
    Turn alone(double share, double seconds) { return turn(share, seconds, nullptr); }
    Result<Turn> watched(double share, double seconds, int viewers, double slow_bytes_per_s);

    std::vector<double> ages_ms, slow_ms; // of what the viewers of all turns saw, until they are cleared

private:
    // What had been used when a picture came.
    struct Used {
        double at_s, all_s, server_s, viewers_s;
    };
    // share: of the recording, where it begins.
    Turn turn(double share, double seconds, const WebViewers* viewers);
    std::vector<Used> pictures_in(double seconds, const WebViewers* viewers);
    void set_server(std::unique_ptr<web::Server> server) {
        const std::lock_guard lock(mutex_);
        server_ = std::move(server);
    }
    void send() {
        ++request_.number;
        link_.request.put(request_);
        link_.wake.raise();
    }

    ui::Link link_;
    Signal news_;
    ui::ViewRequest request_;
    double recording_s_ = 0;
    std::mutex mutex_; // of server_, which the engine's thread tells of news
    std::unique_ptr<web::Server> server_;
    std::unique_ptr<Engine> engine_; // goes before the server
};

Result<std::unique_ptr<Served>> Served::open(const BenchOptions& options) {
    auto served = std::make_unique<Served>();
    served->link_.on_news = [one = served.get()] {
        one->news_.raise();
        const std::lock_guard lock(one->mutex_);
        if (one->server_) one->server_->news();
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
    request.quality.percent = 100;
    served->send();
    for (const double end_s = steady_now_s() + kOpen_s; steady_now_s() < end_s && !interrupted();) {
        (void)served->news_.wait_for(100ms);
        if (const auto problem = served->link_.not_opened.take()) return problem->error;
        const auto opened = served->link_.opened.take();
        if (!opened) continue;
        if (opened->show->cameras.empty()) return Error{"has no camera", options.show};
        if (opened->recording_s <= 0) return Error{"has no recording", options.show};
        request.camera = opened->show->cameras.front();
        request.camera.width = 1280;
        request.camera.height = 720;
        served->recording_s_ = opened->recording_s;
        served->send();
        return served;
    }
    return Error{"was not opened in time", options.show};
}

Result<void> Served::come_to_rest() {
    request_.frozen = true;
    send();
    for (const double end_s = steady_now_s() + kRest_s; steady_now_s() < end_s && !interrupted();) {
        const double cpu_s = process_cpu_s();
        const bool drew = !pictures_in(1, nullptr).empty();
        if (drew || process_cpu_s() - cpu_s > kRestingShare) continue;
        request_.frozen = false;
        send();
        return {};
    }
    return Error{"never came to rest", request_.show};
}

Result<Turn> Served::watched(double share, double seconds, int viewers, double slow_bytes_per_s) {
    TRY(auto server, web::Server::open(link_, {}));
    set_server(std::move(server));
    TRY(const auto looking,
        WebViewers::look_on(server_->port(), server_->keys().token, viewers, slow_bytes_per_s));
    const Turn turn = this->turn(share, seconds, looking.get());
    const WebViewers::Ages ages = looking->leave();
    ages_ms.insert(ages_ms.end(), ages.of_most_ms.begin(), ages.of_most_ms.end());
    slow_ms.insert(slow_ms.end(), ages.of_slow_ms.begin(), ages.of_slow_ms.end());
    set_server(nullptr);
    return turn;
}

Turn Served::turn(double share, double seconds, const WebViewers* viewers) {
    request_.transport.at_s = share * recording_s_;
    ++request_.transport.seeks;
    send();
    (void)pictures_in(kSettle_s, viewers);
    const std::vector<Used> used = pictures_in(seconds, viewers);
    Turn turn;
    if (used.size() > 1) {
        const Used &first = used.front(), &last = used.back();
        const auto pictures = static_cast<double>(used.size() - 1);
        const double server_s = last.server_s - first.server_s;
        turn.per_s = pictures / (last.at_s - first.at_s);
        turn.server_cpu_ms = 1e3 * server_s / pictures;
        turn.engine_cpu_ms =
            1e3 * (last.all_s - first.all_s - server_s - (last.viewers_s - first.viewers_s)) / pictures;
    }
    give_back_free_memory(); // else the turn after has what this one left
    turn.memory_mb = static_cast<double>(used_memory_bytes()) * 1e-6;
    return turn;
}

std::vector<Served::Used> Served::pictures_in(double seconds, const WebViewers* viewers) {
    std::vector<Used> used;
    for (const double end_s = steady_now_s() + seconds; steady_now_s() < end_s && !interrupted();) {
        (void)news_.wait_for(20ms);
        if (!link_.picture.take()) continue;
        used.push_back({steady_now_s(), process_cpu_s(), server_ ? server_->cpu_s() : 0.0,
                        viewers ? viewers->cpu_s() : 0.0});
    }
    return used;
}

double part_of(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

// Of all pairs, and what a quarter of them lies below and above.
void add_lost(BenchRow& row, const std::string& name, const std::vector<double>& lost_percent) {
    row.figures.push_back({name + "_percent", part_of(lost_percent, 0.5)});
    row.figures.push_back({name + "_p25_percent", part_of(lost_percent, 0.25)});
    row.figures.push_back({name + "_p75_percent", part_of(lost_percent, 0.75)});
}

Result<void> measure(Served& served, int viewers, int pairs, double turn_s, double slow_bytes_per_s,
                     const BenchSink& sink) {
    std::vector<double> by_rate, by_cpu, per_s, engine_ms, server_ms, memory_mb;
    served.ages_ms.clear();
    served.slow_ms.clear();
    for (int pair = 0; pair < pairs; ++pair) {
        const double share = kFromShare + (kToShare - kFromShare) * pair / pairs;
        Turn alone, watched;
        // What drifts goes out of it where the one that comes first is another each time.
        if (pair % 2 == 0) alone = served.alone(share, turn_s);
        TRY(watched, served.watched(share, turn_s, viewers, slow_bytes_per_s));
        if (pair % 2 == 1) alone = served.alone(share, turn_s);
        if (interrupted()) return Error{"interrupted", "web"};
        if (alone.per_s <= 0 || watched.per_s <= 0) continue; // not two pictures in a turn
        by_rate.push_back(100 * (1 - watched.per_s / alone.per_s));
        by_cpu.push_back(100 * (1 - alone.engine_cpu_ms / (watched.engine_cpu_ms + watched.server_cpu_ms)));
        per_s.push_back(watched.per_s);
        engine_ms.push_back(watched.engine_cpu_ms);
        server_ms.push_back(watched.server_cpu_ms);
        memory_mb.push_back(watched.memory_mb - alone.memory_mb);
    }
    BenchRow row{"web",
                 std::to_string(viewers) + (viewers == 1 ? " viewer" : " viewers") +
                     (slow_bytes_per_s > 0 ? ", one of them slow" : ""),
                 {},
                 "1280x720, all pixels, loopback, viewers in the same process, medians of " +
                     std::to_string(by_rate.size()) + " pairs of turns of " +
                     std::to_string(static_cast<int>(turn_s)) + " s"};
    add_lost(row, "rate_lost", by_rate);
    add_lost(row, "cpu_lost", by_cpu);
    row.figures.push_back({"engine_per_s", part_of(per_s, 0.5)});
    row.figures.push_back({"engine_cpu_ms_per_picture", part_of(engine_ms, 0.5)});
    row.figures.push_back({"server_cpu_ms_per_picture", part_of(server_ms, 0.5)});
    row.figures.push_back({"memory_added_mb", part_of(memory_mb, 0.5)});
    row.figures.push_back({"memory_added_p75_mb", part_of(memory_mb, 0.75)});
    row.figures.push_back({"pictures", static_cast<double>(served.ages_ms.size())});
    row.figures.push_back({"last_byte_p50_ms", part_of(served.ages_ms, 0.5)});
    row.figures.push_back({"last_byte_p95_ms", part_of(served.ages_ms, 0.95)});
    if (slow_bytes_per_s > 0) {
        row.figures.push_back({"slow_pictures", static_cast<double>(served.slow_ms.size())});
        row.figures.push_back({"slow_last_byte_p50_ms", part_of(served.slow_ms, 0.5)});
        row.figures.push_back({"slow_last_byte_p95_ms", part_of(served.slow_ms, 0.95)});
    }
    sink(row);
    return {};
}

} // namespace

Result<void> bench_web(const BenchOptions& options, const BenchSink& sink) {
    TRY(const std::unique_ptr<Served> served, Served::open(options));
    TRY_VOID(served->come_to_rest());
    (void)served->alone(kFromShare, kTurn_s); // what is made at the first picture that moves
    const int pairs = std::max(options.frames / 2, 1);
    for (const int viewers : {1, 5, static_cast<int>(web::kMostViewers)})
        TRY_VOID(measure(*served, viewers, pairs, kTurn_s, 0, sink));
    // What one of six costs by being slow is the difference of two rows of turns as long.
    const int slow_pairs = std::max(pairs / 4, kFewestSlowPairs);
    TRY_VOID(measure(*served, 6, slow_pairs, kSlowTurn_s, 0, sink));
    return measure(*served, 6, slow_pairs, kSlowTurn_s, kSlow_bytes_per_s, sink);
}

} // namespace ghost::app
