// SPDX-License-Identifier: Apache-2.0
// Who comes in, what they say, and how they leave; what they get: server_offers.cpp.
#include "web/private/server_loop.h"

#include "base/log.h"
#include "show/show.h"
#include "web/server.h"

#include <algorithm>

namespace ghost::web {
namespace {

using namespace std::chrono_literals;

constexpr double kHead_s = 5; // for a whole request
constexpr double kSilence_s =
    120; // of a viewer; hidden tabs say little, and the system answers pings for them
constexpr double kAskIfThereEvery_s = 30;
constexpr auto kWatchedRound = 25ms, kIdleRound = 500ms;

std::string_view text_of(const std::vector<std::uint8_t>& bytes, std::size_t from = 0) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).substr(from);
}

// Fit for a frame that closes.
std::string short_reason(std::string text) {
    constexpr std::size_t kMost = 120;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.substr(0, kMost);
}

} // namespace

ServerLoop::ServerLoop(ui::Link& link, dmx::TcpListener& listener, dmx::StreamWake& wake, Access& access,
                       double bytes_per_s)
    : link_(link), listener_(listener), wake_(wake), access_(access), ration_(bytes_per_s) {}

double ServerLoop::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void ServerLoop::round() {
    wait();
    accept();
    read_news();
    for (auto guest = guests_.begin(); guest != guests_.end();) {
        if (serve(*guest)) {
            ++guest;
            continue;
        }
        if (guest->viewer)
            log_info("browsers: " + dmx::address_text(guest->connection.stream().peer()) + " has left");
        guest = guests_.erase(guest);
    }
    viewers_ = static_cast<std::size_t>(std::count_if(
        guests_.begin(), guests_.end(), [](const Guest& guest) { return guest.viewer != nullptr; }));
    link_.rig.also_for_second(viewers_ > 0);
    ask();
}

void ServerLoop::wait() {
    std::vector<dmx::WaitFor> streams{{listener_.handle()}, {wake_.handle()}};
    for (const Guest& guest : guests_)
        streams.push_back({guest.connection.stream().handle(), guest.connection.unsent() > 0});
    dmx::wait_for_streams(streams, viewers_ > 0 ? kWatchedRound : kIdleRound);
    wake_.clear();
}

void ServerLoop::accept() {
    while (std::unique_ptr<dmx::TcpStream> stream = listener_.accept()) {
        Connection connection(std::move(stream), now_s());
        if (guests_.size() < kMostConnections) {
            guests_.push_back({std::move(connection), nullptr});
            continue;
        }
        connection.put(answer_text(refusal(503)));
        (void)connection.send();
    }
}

bool ServerLoop::serve(Guest& guest) {
    if (!guest.connection.read(now_s())) return false;
    if (!guest.connection.is_ending()) {
        if (guest.viewer)
            read_frames(guest);
        else
            read_request(guest);
        end_what_is_late(guest);
        if (guest.viewer) offer(guest);
    }
    return guest.connection.send() && !guest.connection.is_over(now_s());
}

void ServerLoop::read_request(Guest& guest) {
    Connection& connection = guest.connection;
    if (connection.unread().empty()) return;
    const ParsedHead parsed = parse_head(text_of(connection.unread()));
    if (parsed.status == 0) return;
    if (parsed.status != 200) return answer(guest, refusal(parsed.status));
    std::size_t body_bytes = 0;
    if (const int status = body_status(parsed.head, body_bytes); status != 200)
        return answer(guest, refusal(status));
    if (connection.unread().size() < parsed.bytes + body_bytes) return;
    access_.own = own_names(access_.own.port, access_.own.proxied); // cables come and go
    const std::string_view body = text_of(connection.unread(), parsed.bytes).substr(0, body_bytes);
    const Routed routed = route(parsed.head, body, access_, now_s());
    if (!routed.is_live) return answer(guest, routed.answer);
    connection.take(parsed.bytes + body_bytes);
    begin_live(guest, routed.answer);
}

void ServerLoop::answer(Guest& guest, const Answer& answer) {
    guest.connection.put(answer_text(answer));
    guest.connection.end(now_s());
}

void ServerLoop::begin_live(Guest& guest, const Answer& answer) {
    if (viewers_ >= static_cast<std::size_t>(kMostViewers)) return this->answer(guest, refusal(503));
    ++viewers_;
    guest.connection.put(answer_text(answer));
    guest.connection.put(build_text(hello_text()));
    guest.viewer = std::make_unique<Viewer>();
    guest.viewer->asked_if_there_s = now_s();
    log_info("browsers: " + dmx::address_text(guest.connection.stream().peer()) + " looks on");
    read_frames(guest);
}

void ServerLoop::read_frames(Guest& guest) {
    Connection& connection = guest.connection;
    while (!connection.is_ending() && !connection.unread().empty()) {
        const ParsedFrame frame = parse_frame(connection.unread());
        if (frame.close != 0) return end_live(guest, frame.close, "the frame is malformed, or too long");
        if (frame.bytes == 0) return;
        connection.take(frame.bytes);
        if (!guest.viewer->may_say(now_s())) return end_live(guest, kClosePolicy, "too many messages");
        switch (frame.opcode) {
        case Opcode::close:
            return end_live(guest, 1000, "");
        case Opcode::ping:
            connection.put(build_frame(Opcode::pong, frame.payload));
            break;
        case Opcode::pong:
            break;
        case Opcode::text:
        case Opcode::binary:
            const Result<ToServer> message = read_message(frame.opcode, frame.payload);
            if (!message.ok()) return end_live(guest, kClosePolicy, message.error().what);
            hear(guest, *message);
        }
    }
}

void ServerLoop::hear(Guest& guest, const ToServer& message) {
    Viewer& viewer = *guest.viewer;
    if (const auto* painted = std::get_if<Painted>(&message)) {
        viewer.flow.painted(painted->number, now_s());
        viewer.count_painted(now_s());
    } else if (const auto* watch = std::get_if<Watch>(&message)) {
        viewer.flow.want(watch->width, watch->calm);
    } else if (const auto* levels = std::get_if<WantLevels>(&message)) {
        viewer.wants_levels = levels->on;
        viewer.levels = 0;
    } else if (const auto* ping = std::get_if<Ping>(&message)) {
        const double now_ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
                .count();
        guest.connection.put(build_text(pong_text(ping->t, now_ms)));
    } else if (const auto* explain = std::get_if<Explain>(&message)) {
        if (opened_ && opened_->show && explain->fixture < opened_->show->fixtures.size()) {
            viewer.asks = explain->fixture;
        } else {
            ui::Explained none;
            none.fixture = explain->fixture;
            none.explanation.verdict = none.words = "the show has no such fixture";
            guest.connection.put(build_text(explained_text(none)));
        }
    }
}

void ServerLoop::end_live(Guest& guest, int code, const std::string& why) {
    guest.connection.put(build_close(code, short_reason(why)));
    guest.connection.end(now_s());
}

void ServerLoop::end_what_is_late(Guest& guest) {
    if (guest.connection.is_ending()) return;
    const double now = now_s();
    if (!guest.viewer) {
        if (now - guest.connection.since_s() > kHead_s) answer(guest, refusal(408));
        return;
    }
    if (now - guest.connection.heard_s() > kSilence_s)
        return end_live(guest, kCloseGoingAway, "nothing was heard");
    if (now - guest.viewer->asked_if_there_s < kAskIfThereEvery_s) return;
    guest.viewer->asked_if_there_s = now;
    guest.connection.put(build_frame(Opcode::ping, {}));
}

} // namespace ghost::web
