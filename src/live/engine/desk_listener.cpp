// SPDX-License-Identifier: Apache-2.0
#include "live/engine/desk_listener.h"

#include "live/inputs/joined_universes.h"

#include "base/log.h"

#include <utility>
#include <vector>

namespace ghost::app {
namespace {

constexpr double kListenAgain_s = 3;

} // namespace

void DeskListener::follow(const TimeCodeOptions& timecode) {
    auto input = open_timecode(timecode);
    if (!input.ok() || !*input) return; // checked before
    timecode_ = std::move(*input);
    timecode_->listen(options_);
}

// A port that is taken may be free again when whoever has it is closed.
bool DeskListener::listen(double now_s) {
    if (receiver_ || now_s < again_s_) return false;
    again_s_ = now_s + kListenAgain_s;
    options_.on_levels = [this](const dmx::Universes& universes, std::chrono::nanoseconds now) {
        recorder_.put(universes, now);
    };
    options_.on_change = [this] { link_.wake.raise(); };
    std::vector<Message> said;
    auto receiver = dmx::Receiver::start(options_);
    if (receiver.ok()) {
        receiver_ = std::move(*receiver);
        if (messages_.has_network()) log_info("the port is free: listening");
        for (const std::string& warning : receiver_->warnings())
            said.push_back({Severity::warning, "network", warning});
    } else {
        dmx::Statistics none;
        none.listening.problem = receiver.error().text();
        link_.network.put(std::move(none));
        link_.on_news();
        said.push_back({Severity::error, receiver.error().where, receiver.error().what});
        if (!messages_.has_network()) log_warning(receiver.error().text());
    }
    messages_.set_network(std::move(said));
    return receiver_ != nullptr;
}

void DeskListener::listen_to(const scene::PatchMap& patch) {
    if (receiver_) receiver_->listen_to(joined_universes(options_.universes, patch));
}

} // namespace ghost::app
