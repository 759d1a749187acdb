// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/live_input.h"

#include "dmx/record/activity.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace ghost::app {
namespace {

double seconds_of(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

constexpr std::size_t kParts = 600; // of a recording, across a screen

// Another reader of the file, so that nobody waits.
std::vector<float> measure_activity(const std::filesystem::path& file, const std::atomic<bool>& stop) {
    auto recording = dmx::read_recording(file);
    if (!recording.ok()) return {};
    dmx::Player player(std::move(*recording));
    return dmx::activity_of(player, kParts, [&] { return stop.load(); });
}

} // namespace

Result<void> LiveInput::load_recording(const std::filesystem::path& file, Report& report) {
    std::optional<dmx::Recording> recording;
    if (!file.empty()) {
        TRY(recording, dmx::read_recording(file)); // else the one before plays on
    }
    stop_measuring_ = true;
    measuring_ = {}; // waits for the one before
    stop_measuring_ = false;
    player_.reset();
    played_ = {};
    at_s_ = 0;
    file_ = file;
    if (!recording) return {};
    for (const Error& problem : recording->problems)
        report.add(Severity::warning, problem.where, problem.what);
    first_frames_s_.clear();
    for (const auto& [universe, time] : recording->first_frames())
        first_frames_s_.emplace_back(universe, seconds_of(time));
    player_ = std::make_unique<dmx::Player>(std::move(*recording));
    measuring_ = std::async(std::launch::async, measure_activity, file, std::cref(stop_measuring_));
    return {};
}

LiveInput::~LiveInput() {
    stop_measuring_ = true; // the future waits
}

std::optional<std::vector<float>> LiveInput::take_activity() {
    if (!measuring_.valid() || measuring_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    return measuring_.get();
}

void LiveInput::step(ui::Input wanted, const ui::Transport& transport, double dt_s) {
    arrival_ = std::chrono::nanoseconds{0};
    listened_s_ += dt_s;
    const bool is_frozen = dt_s <= 0;
    if (receiver_) {
        if (std::optional<dmx::Universes> newest = is_frozen ? std::nullopt : receiver_->take()) {
            // What came while time stood still waited for a hand, not for us.
            arrival_ = newest->first_change;
            if (was_frozen_ && arrival_.count() > 0)
                arrival_ = std::chrono::steady_clock::now().time_since_epoch();
            desk_ = std::move(*newest);
            // The receiver holds looks for whoever was shown them, which is another show than this.
            std::erase_if(desk_.list, [this](const dmx::Universe& universe) {
                return universe.lost && universe.arrival < since_;
            });
        }
        if (std::optional<dmx::Statistics> newest = receiver_->take_statistics()) {
            statistics_ = std::move(*newest);
            statistics_are_new_ = true;
        }
    }
    was_frozen_ = is_frozen;
    shows_desk_ =
        wanted == ui::Input::desk || (wanted == ui::Input::automatic && (!player_ || !desk_.list.empty()));
    if (shows_desk_) return;
    arrival_ = std::chrono::nanoseconds{0};
    if (!player_) return;
    if (transport.playing) at_s_ += dt_s;
    if (transport.seeks != seeks_) at_s_ = transport.at_s;
    seeks_ = transport.seeks;
    const double end_s = std::max(player_->duration_s(), 1e-3);
    at_s_ = std::isfinite(at_s_) ? std::fmod(std::max(at_s_, 0.0), end_s) : 0.0;
    if (const double from_s = transport.loop_from_s, to_s = std::min(transport.loop_to_s, end_s);
        to_s > from_s && at_s_ >= to_s)
        at_s_ = from_s + std::fmod(at_s_ - from_s, to_s - from_s);
    if (const auto wanted_s = timecode_ && !is_frozen ? timecode_->at_s(end_s) : std::nullopt)
        at_s_ = *wanted_s;
    played_ = player_->at(at_s_);
}

bool LiveInput::plays_else_in(double dt_s) const {
    if (shows_desk_ || !player_) return false;
    const dmx::Universes later = player_->at(std::min(at_s_ + dt_s, player_->duration_s()));
    return !std::equal(later.list.begin(), later.list.end(), played_.list.begin(), played_.list.end(),
                       [](const dmx::Universe& a, const dmx::Universe& b) {
                           return a.number == b.number && *a.levels == *b.levels;
                       });
}

void LiveInput::go_on_from(const LiveInput& before) {
    desk_ = before.desk_;
    since_ = before.since_;
    statistics_ = before.statistics_;
    listened_s_ = before.listened_s_;
    at_s_ = before.at_s_;
    seeks_ = before.seeks_;
}

std::optional<dmx::Statistics> LiveInput::take_statistics() {
    if (!std::exchange(statistics_are_new_, false)) return std::nullopt;
    return statistics_;
}

scene::Reception LiveInput::reception(const scene::PatchMap& patch) const {
    scene::Reception reception;
    if (shows_desk_) return receiver_ ? scene::reception_of(statistics_, patch, listened_s_) : reception;
    if (!player_) return reception;
    reception.kind = scene::Reception::Kind::recording;
    reception.recording = file_.string();
    reception.at_s = at_s_;
    reception.end_s = player_->duration_s();
    reception.first_frames_s = first_frames_s_;
    return reception;
}

double LiveInput::now_s() const {
    return shows_desk_ ? seconds_of(std::chrono::steady_clock::now().time_since_epoch()) : at_s_;
}

} // namespace ghost::app
