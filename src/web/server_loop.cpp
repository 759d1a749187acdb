// SPDX-License-Identifier: Apache-2.0
// Who comes in, what they say, and how they leave; what they get: server_offers.cpp.
#include "web/private/server_loop.h"

#include "base/log.h"
#include "net/socket.h"
#include "show/show.h"
#include "web/server.h"

#include <algorithm>
#include <utility>

namespace ghost::web {
namespace {

using namespace std::chrono_literals;

constexpr double kHead_s = 5;       // for a whole request
constexpr double kKeepsPlace_s = 1; // however many come
constexpr double kBytesPerMbit = 1e6 / 8;
constexpr double kAskIfThereEvery_s = 30;
constexpr int kMostAtOnce = 32; // who come in a round: viewers do not wait for a flood
constexpr auto kWatchedRound = 25ms, kIdleRound = 500ms;

std::string_view text_of(const std::vector<std::uint8_t>& bytes, std::size_t from = 0) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).substr(from);
}

// As one household or hall has it: /24 of IPv4, /64 of IPv6. Who has one address there may have others.
bool is_same_network(const dmx::IpAddress& a, const dmx::IpAddress& b) {
    const std::ptrdiff_t bytes = a.is_ipv4() ? 15 : 8;
    return std::equal(a.bytes.begin(), a.bytes.begin() + bytes, b.bytes.begin());
}

// Fit for a frame that closes.
std::string short_reason(std::string text) {
    constexpr std::size_t kMost = 120;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.substr(0, kMost);
}

} // namespace

ServerLoop::ServerLoop(ui::Link& link, dmx::TcpListener& listener, std::shared_ptr<dmx::StreamWake> wake,
                       Gate& gate, const ServerOptions& options, const std::atomic<bool>& stop)
    : link_(link), listener_(listener), wake_(std::move(wake)), gate_(gate), stop_(stop), host_(options.host),
      book_(std::make_shared<BookShelf>(options.book)), encoder_(wake_), reader_(wake_),
      silence_s_(options.silence_s), ration_(options.mbit * kBytesPerMbit) {}

void ServerLoop::round() {
    wait();
    accept();
    look_at_gate();
    read_news();
    std::list<Guest> served; // come last the next time: the ration may have an end before theirs comes
    for (auto guest = guests_.begin(); guest != guests_.end() && !stop_;) {
        const auto next = std::next(guest);
        if (!serve(*guest)) {
            if (guest->viewer) tell_of(*guest, " has left");
            guests_.erase(guest);
        } else if (guest->viewer && std::exchange(guest->viewer->is_served, false)) {
            served.splice(served.end(), guests_, guest);
        }
        guest = next;
    }
    guests_.splice(guests_.end(), served);
    read_book();
    viewers_ = static_cast<std::size_t>(std::count_if(
        guests_.begin(), guests_.end(), [](const Guest& guest) { return guest.viewer != nullptr; }));
    if (viewers_ == 0) {
        const std::lock_guard lock(gate_.mutex);
        gate_.lookers.clear();
    }
    link_.rig.also_for_second(viewers_ > 0);
    link_.wants_small_pictures = std::any_of(guests_.begin(), guests_.end(), [](const Guest& guest) {
        return guest.viewer && guest.viewer->wants_pictures;
    });
    choose_sides();
    ask();
}

void ServerLoop::look_at_gate() {
    const double cpu_s =
        std::chrono::duration<double>(dmx::thread_cpu_time()).count() + encoder_.cpu_s() + reader_.cpu_s();
    const std::lock_guard lock(gate_.mutex);
    gate_.cpu_s = cpu_s;
    if (gate_.sent_away != sent_away_) {
        sent_away_ = gate_.sent_away;
        for (Guest& guest : guests_) {
            if (!guest.viewer || guest.connection.is_ending()) continue;
            guest.connection.put(build_text(bye_text("Everybody was sent away.")));
            end_live(guest, kClosePolicy, "everybody was sent away");
        }
    }
    for (Guest& guest : guests_) {
        if (!guest.viewer || guest.connection.is_ending() || guest.viewer->keys == gate_.keys) continue;
        // Whatever token it came with: the one that controls is another now, or none.
        guest.viewer->keys = gate_.keys;
        if (guest.viewer->right != Right::control) continue;
        guest.viewer->right = Right::view;
        guest.connection.put(build_text(hello_text(Right::view)));
    }
}

void ServerLoop::wait() {
    std::vector<dmx::WaitFor> streams{{wake_->handle()}};
    if (!is_full()) streams.push_back({listener_.handle()});
    for (const Guest& guest : guests_)
        streams.push_back({guest.connection.stream().handle(), guest.connection.unsent() > 0});
    dmx::wait_for_streams(streams, viewers_ > 0 || is_full() ? kWatchedRound : kIdleRound);
    wake_->clear();
}

void ServerLoop::accept() {
    for (int k = 0; k < kMostAtOnce; ++k) {
        const bool full = is_full();
        const auto leaves = full ? who_leaves() : guests_.end();
        if (full && leaves == guests_.end()) return; // the system keeps who comes meanwhile
        std::unique_ptr<dmx::TcpStream> stream = listener_.accept();
        if (!stream) return;
        if (full) {
            leaves->connection.put(answer_text(refusal(503)));
            (void)leaves->connection.send(now_s());
            guests_.erase(leaves);
        }
        guests_.push_back({Connection(std::move(stream), now_s())});
    }
}

// So that who holds places and says nothing does not keep all others out: of those who are no viewers, had
// their second and are not being answered, the oldest from the network that has most of all is refused.
std::list<ServerLoop::Guest>::iterator ServerLoop::who_leaves() {
    const auto count_of = [&](const Guest& guest) {
        return std::count_if(guests_.begin(), guests_.end(), [&](const Guest& other) {
            return !other.viewer &&
                   is_same_network(other.connection.stream().peer(), guest.connection.stream().peer());
        });
    };
    const double now = now_s();
    auto leaves = guests_.end();
    std::ptrdiff_t most = 0;
    for (auto guest = guests_.begin(); guest != guests_.end(); ++guest) {
        if (guest->viewer || guest->book || guest->connection.is_in_answer(now) ||
            now - guest->connection.since_s() < kKeepsPlace_s)
            continue;
        const std::ptrdiff_t count = count_of(*guest);
        if (count <= most) continue;
        most = count;
        leaves = guest;
    }
    return leaves;
}

bool ServerLoop::serve(Guest& guest) {
    if (!guest.connection.read(now_s())) return false;
    if (!guest.connection.is_ending()) {
        if (guest.viewer)
            read_frames(guest);
        else if (!guest.book)
            read_request(guest);
        if (guest.book && guest.connection.unread().size() > kMostHeadBytes) answer(guest, refusal(413));
        end_what_is_late(guest);
        if (guest.viewer) go_to_watch(guest);
        if (guest.viewer) offer(guest);
    }
    return guest.connection.send(now_s()) && !guest.connection.is_over(now_s());
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
    const std::string_view body = text_of(connection.unread(), parsed.bytes).substr(0, body_bytes);
    std::uint64_t keys = 0;                            // that the right is of
    OwnNames own = own_names(listener_.port(), host_); // cables come and go
    const Routed routed = [&] {
        const std::lock_guard lock(gate_.mutex);
        keys = gate_.keys;
        gate_.access.own = std::move(own);
        return route(parsed.head, body, gate_.access, now_s());
    }();
    connection.take(parsed.bytes + body_bytes);
    if (routed.book) {
        guest.book = routed.book;
        return;
    }
    if (!routed.is_live) return answer(guest, routed.answer);
    begin_live(guest, routed, keys);
}

void ServerLoop::answer(Guest& guest, const Answer& answer) {
    guest.connection.put(answer_text(answer));
    guest.connection.end(now_s());
}

void ServerLoop::tell_of(const Guest& guest, const std::string& what) {
    if (!lines_.has_some(now_s())) {
        ++untold_;
        return;
    }
    lines_.spend(1);
    const std::string more = untold_ > 0 ? " (" + std::to_string(untold_) + " times more was left out)" : "";
    untold_ = 0;
    log_info("browsers: " + dmx::address_text(guest.connection.stream().peer()) + what + more);
}

void ServerLoop::begin_live(Guest& guest, const Routed& routed, std::uint64_t keys) {
    if (viewers_ >= kMostViewers) return answer(guest, refusal(503));
    ++viewers_;
    guest.connection.put(answer_text(routed.answer));
    guest.connection.put(build_text(hello_text(routed.right)));
    guest.viewer = std::make_unique<Viewer>();
    guest.viewer->id = ++ids_;
    guest.viewer->right = routed.right;
    guest.viewer->keys = keys;
    guest.viewer->asked_if_there_s = now_s();
    tell_of(guest, routed.right == Right::control ? " looks on and may control" : " looks on");
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
            const Result<ToServer> message =
                read_message(frame.opcode, frame.payload, guest.viewer->right == Right::control);
            if (!message.ok()) return end_live(guest, kClosePolicy, message.error().what);
            hear(guest, *message);
        }
    }
}

void ServerLoop::hear(Guest& guest, const ToServer& message) {
    Viewer& viewer = *guest.viewer;
    if (const auto* painted = std::get_if<Painted>(&message)) {
        viewer.hear_painted(painted->number, now_s());
    } else if (const auto* wanted = std::get_if<Watch>(&message)) {
        watch(guest, *wanted);
    } else if (const auto* what = std::get_if<Do>(&message)) {
        command(guest, *what);
    } else if (const auto* pictures = std::get_if<WantPictures>(&message)) {
        viewer.wants_pictures = pictures->on;
    } else if (const auto* levels = std::get_if<WantLevels>(&message)) {
        viewer.wants_levels = levels->on;
        viewer.levels = 0;
    } else if (const auto* ping = std::get_if<Ping>(&message)) {
        const double now_ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
                .count();
        guest.connection.put(build_text(pong_text(ping->t, now_ms)));
    } else if (const auto* asked = std::get_if<Explain>(&message)) {
        explain(guest, asked->fixture);
    }
}

void ServerLoop::explain(Guest& guest, std::size_t fixture) {
    if (opened_ && opened_->show && fixture < opened_->show->fixtures.size()) {
        guest.viewer->asks = fixture;
        return;
    }
    ui::Explained none;
    none.fixture = fixture;
    none.explanation.verdict = none.words = "the show has no such fixture";
    guest.connection.put(build_text(explained_text(none)));
}

// To the engine, whose answer goes back; what is known to be wrong does not wait for it.
void ServerLoop::command(Guest& guest, const Do& what) {
    const auto refuse = [&](const std::string& why) {
        guest.connection.put(build_text(refused_text(what.n, why)));
    };
    if (!opened_ || !opened_->show) return refuse("no show is open");
    if (what.command.what == "look") {
        const auto* const name =
            what.command.arguments.empty() ? nullptr : std::get_if<std::string>(&what.command.arguments[0]);
        if (!name || !looks_.looks || !scene::find_look(*looks_.looks, *name).ok())
            return refuse("the show has no such look");
    }
    ui::Command command = what.command;
    command.number = ++commands_;
    if (asked_.size() >= ui::kMostCommands || !link_.commands.put(command))
        return refuse("too much is asked for already");
    asked_.push_back({command.number, guest.viewer->id, what.n});
    link_.wake.raise();
}

void ServerLoop::end_live(Guest& guest, int code, const std::string& why) {
    guest.connection.put(build_close(code, short_reason(why)));
    guest.connection.end(now_s());
}

void ServerLoop::end_what_is_late(Guest& guest) {
    if (guest.connection.is_ending()) return;
    const double now = now_s();
    if (!guest.viewer) {
        if (!guest.book && now - guest.connection.since_s() > kHead_s) answer(guest, refusal(408));
        return;
    }
    if (now - guest.connection.heard_s() > silence_s_)
        return end_live(guest, kCloseGoingAway, "nothing was heard");
    if (now - guest.viewer->asked_if_there_s < kAskIfThereEvery_s) return;
    guest.viewer->asked_if_there_s = now;
    guest.connection.put(build_frame(Opcode::ping, {}));
}

} // namespace ghost::web
