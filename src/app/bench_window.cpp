// SPDX-License-Identifier: Apache-2.0
// The window under the load of a desk: the show's recording comes by sACN at 44 Hz from a thread of this
// process, the window draws it as fast as it wants, and its own counters say how late a packet is seen and
// what the window itself costs. Without a display it is drawn into memory.
#include "app/bench.h"
#include "app/engine.h"
#include "app/interrupt.h"
#include "ui/open_window.h"

#include "base/files.h"
#include "dmx/player.h"
#include "dmx/sender.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRate_hz = 44;
constexpr double kWarm_s = 4;
constexpr double kSeconds = 15;
constexpr double kFrom_s = 20; // of the recording, where everything moves
constexpr int kWidth = 1280, kHeight = 760;

// A desk that plays the recording until it is told to stop.
class Desk {
public:
    Desk(dmx::Sender sender, dmx::Player player)
        : sender_(std::move(sender)), player_(std::move(player)), thread_([this] { run(); }) {}
    ~Desk() {
        stop_ = true;
        thread_.join();
    }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

private:
    void run() {
        const auto begin = Clock::now();
        const double length_s = std::max(player_.duration_s() - kFrom_s, 1.0);
        for (std::uint64_t tick = 0; !stop_; ++tick) {
            const std::chrono::duration<double> passed(static_cast<double>(tick) / kRate_hz);
            std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(passed));
            (void)sender_.send(player_.at(kFrom_s + std::fmod(passed.count(), length_s)));
        }
    }

    dmx::Sender sender_;
    dmx::Player player_;
    std::atomic<bool> stop_{false};
    std::thread thread_; // the last member: it uses all others
};

double number(const nlohmann::json& state, const char* group, const char* name) {
    return state.contains(group) && state[group].contains(name) && state[group][name].is_number()
               ? state[group][name].get<double>()
               : std::nan("");
}

} // namespace

Result<void> bench_window(const BenchOptions& options, const BenchSink& sink) {
    namespace fs = std::filesystem;
    scene::Report report;
    TRY(const scene::Show show, open_show(options.show, false, true, report));
    if (show.recording.empty()) return Error{"has no recording to send", show.file.string()};
    TRY(dmx::Recording recording, dmx::read_recording(show.recording));
    const auto port = static_cast<std::uint16_t>(30000 + Clock::now().time_since_epoch().count() / 1'000'000 %
                                                             20000); // nobody else's, most likely
    const std::string name = "ghostlight-bench-" + std::to_string(port);
    const fs::path script = fs::temp_directory_path() / (name + ".txt"),
                   outcome = fs::temp_directory_path() / (name + ".json");
    TRY_VOID(write_file_atomic(script, "wait opened\nfigures\nwait " + std::to_string(kWarm_s) +
                                           "\nreset-figures\nwait " + std::to_string(kSeconds) +
                                           "\nstate \"" + outcome.string() + "\"\nquit\n"));
    EngineOptions engine;
    engine.session.quiet = true;
    engine.session.device = options.device;
    engine.receiver.interface = "127.0.0.1";
    engine.receiver.artnet = false;
    engine.receiver.sacn_port = port;
    engine.receiver.sampling = engine.receiver.priority_wait = std::chrono::seconds(0);
    dmx::SenderOptions to;
    to.destination = to.interface = "127.0.0.1";
    to.port = port;
    TRY(dmx::Sender sender, dmx::Sender::open(to));

    ui::Link link;
    ui::WindowOptions window;
    window.show = options.show;
    window.script = script.string();
    window.remembers = false;
    window.width = kWidth;
    window.height = kHeight;
    window.draws_into_memory = !ui::has_display();
    window.should_close = interrupted;
    window.begin = [&] { return std::make_shared<Engine>(link, engine); };
    Result<void> done;
    {
        const Desk desk(std::move(sender), dmx::Player(std::move(recording)));
        done = ui::open_window(link, window);
    }
    const auto text = read_text_file(outcome, 1 << 24);
    std::error_code code;
    fs::remove(script, code);
    fs::remove(outcome, code);
    TRY_VOID(done);
    if (!text.ok()) return text.error();
    const nlohmann::json state = nlohmann::json::parse(*text, nullptr, false);
    if (state.is_discarded()) return Error{"the window wrote no state", outcome.string()};
    const char* const kPackets = "packet_to_window_ms";
    BenchRow row;
    row.table = "window";
    row.name = std::to_string(kWidth) + "x" + std::to_string(kHeight) + ", 44 Hz";
    row.figures = {{"pictures_per_s", number(state, "picture", "pictures_per_s")},
                   {"packets", number(state, kPackets, "count")},
                   {"packet_p50_ms", number(state, kPackets, "p50")},
                   {"packet_p99_ms", number(state, kPackets, "p99")},
                   {"packet_max_ms", number(state, kPackets, "max")},
                   {"window_p50_ms", number(state, "window_ms", "p50")},
                   {"window_p99_ms", number(state, "window_ms", "p99")},
                   {"draw_ms", number(state, "picture", "draw_ms")}};
    row.note = std::string(window.draws_into_memory ? "drawn into memory" : "on the display") +
               ", picture of the last frame " +
               state["picture"]["camera"].value("width", nlohmann::json()).dump() + "x" +
               state["picture"]["camera"].value("height", nlohmann::json()).dump();
    sink(row);
    return {};
}

} // namespace ghost::app
