// SPDX-License-Identifier: Apache-2.0
#include "bench/window/private/loaded_window.h"

#include "base/interrupt.h"
#include "live/engine/engine.h"
#include "ui/window/open_window.h"

#include "disk/files.h"
#include "dmx/record/player.h"
#include "dmx/send/sender.h"
#include "json_xml_toml/json.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kFrom_s = 20; // of the recording, where everything moves
constexpr std::uintmax_t kMostStateBytes = 1 << 24;

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
            const std::chrono::duration<double> passed(static_cast<double>(tick) / LoadedWindow::kRate_hz);
            std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(passed));
            (void)sender_.send(player_.at(kFrom_s + std::fmod(passed.count(), length_s)));
        }
    }

    dmx::Sender sender_;
    dmx::Player player_;
    std::atomic<bool> stop_{false};
    std::thread thread_; // the last member: it uses all others
};

// Nobody else's, most likely.
std::uint16_t own_port() {
    static const auto port =
        static_cast<std::uint16_t>(30000 + Clock::now().time_since_epoch().count() / 1'000'000 % 20000);
    return port;
}

} // namespace

Result<bool> run_loaded_window(const BenchOptions& options, const LoadedWindow& load) {
    Report report;
    TRY(const scene::Show show, open_show(options.show, false, true, report));
    std::optional<dmx::Recording> recording;
    if (load.has_desk) {
        if (show.recording.empty()) return Error{"has no recording to send", show.file.string()};
        TRY(recording, dmx::read_recording(show.recording));
    }
    const fs::path script = bench_file(".txt");
    TRY_VOID(write_file_atomic(script, load.script));
    EngineOptions engine;
    engine.session.quiet = true;
    engine.session.device = options.device;
    engine.session.bounce = load.bounce;
    engine.receiver.interface = "127.0.0.1";
    engine.receiver.artnet = false;
    engine.receiver.sacn_port = own_port();
    engine.receiver.sampling = engine.receiver.priority_wait = std::chrono::seconds(0);
    dmx::SenderOptions to;
    to.destination = to.interface = "127.0.0.1";
    to.port = own_port();
    TRY(dmx::Sender sender, dmx::Sender::open(to));

    ui::Link link;
    ui::WindowOptions window;
    window.show = options.show;
    window.script = script.string();
    window.remembers = false;
    window.width = LoadedWindow::kWidth;
    window.height = LoadedWindow::kHeight;
    window.draws_into_memory = !ui::has_display();
    window.should_close = [&] {
        if (load.on_tick) load.on_tick();
        return interrupted();
    };
    window.begin = [&] { return std::make_shared<Engine>(link, engine); };
    Result<void> done;
    {
        std::optional<Desk> desk;
        if (recording) desk.emplace(std::move(sender), dmx::Player(std::move(*recording)));
        done = ui::open_window(link, window);
    }
    std::error_code code;
    fs::remove(script, code);
    TRY_VOID(done);
    return window.draws_into_memory;
}

Result<nlohmann::json> take_state(const fs::path& file) {
    TRY(const std::string text, read_text_file(file, kMostStateBytes));
    std::error_code code;
    fs::remove(file, code);
    return read_json(text, file.string(), {.bytes = kMostStateBytes, .values = kMostStateBytes});
}

double picture_share(const nlohmann::json& state) {
    const nlohmann::json view = state.value("view", nlohmann::json::array());
    if (view.size() != 4) return std::nan("");
    return view[2].get<double>() * view[3].get<double>() / (LoadedWindow::kWidth * LoadedWindow::kHeight);
}

double state_number(const nlohmann::json& state, const char* group, const char* name) {
    return state.contains(group) && state[group].contains(name) && state[group][name].is_number()
               ? state[group][name].get<double>()
               : std::nan("");
}

} // namespace ghost::app
