// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/receiver.h"

#include "base/steady_time.h"
#include "dmx/merge/catch_up.h"
#include "dmx/receive/intake.h"
#include "dmx/receive/poll_answers.h"
#include "dmx/receive/private/listener.h"
#include "dmx/receive/private/wider.h"
#include "dmx/wire/build.h"
#include "net/reverse_path.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace ghost::dmx {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr std::uint16_t kDefaultUniverses = 64;
constexpr nanoseconds kPublishEvery = 1ms;   // packets that trickle in share one publication
constexpr nanoseconds kPublishAtLast = 20ms; // with a flood that never lets the sockets run dry
constexpr nanoseconds kTickEvery = 100ms;
constexpr nanoseconds kStatisticsEvery = 250ms;
constexpr nanoseconds kLossWindow = 10s;
constexpr nanoseconds kInterfacesEvery = 1s;
// A turn that took longer than this is a pause: what waits in the sockets is old, and of what is newest some
// may have found no room there.
constexpr nanoseconds kPause = 300ms;

std::vector<std::uint16_t> announced_universes(const std::vector<std::uint16_t>& universes) {
    std::vector<std::uint16_t> result = universes;
    for (std::uint16_t i = 1; universes.empty() && i <= kDefaultUniverses; ++i) result.push_back(i);
    return result;
}

std::vector<std::uint16_t> port_addresses(const std::vector<std::uint16_t>& universes, int artnet_offset) {
    std::vector<std::uint16_t> result;
    for (const std::uint16_t universe : announced_universes(universes)) {
        const int port_address = universe - artnet_offset;
        if (port_address >= 0 && port_address <= kMaxPortAddress)
            result.push_back(static_cast<std::uint16_t>(port_address));
    }
    return result;
}

std::vector<std::uint16_t> ports_of(const ReceiverOptions& options) {
    std::vector<std::uint16_t> ports;
    if (options.sacn) ports.push_back(options.sacn_port);
    if (options.artnet) ports.push_back(options.artnet_port);
    return ports;
}

IntakeOptions intake_options(const ReceiverOptions& options) {
    IntakeOptions result;
    result.universes = options.universes;
    result.accept_others = options.accept_others;
    result.artnet_offset = options.artnet_offset;
    result.merge.show_preview = options.show_preview;
    result.merge.preview_universes = options.preview_universes;
    result.merge.asked = asked_universes(options);
    result.merge.slot_status = options.slot_status;
    result.merge.artnet_ltp = options.artnet_ltp;
    result.merge.loss = options.loss;
    result.merge.sampling = options.sampling;
    result.merge.priority_wait = options.priority_wait;
    if (options.midi.empty()) result.on_timecode = options.on_timecode;
    return result;
}

} // namespace

std::vector<std::uint16_t> asked_universes(const ReceiverOptions& options) {
    std::vector<std::uint16_t> result = announced_universes(options.universes);
    for (const UsbPortOptions& port : options.usb) {
        const std::size_t count = port.path == "auto" ? kMostUsbPorts : 1;
        for (std::size_t i = 0; i < count && port.universe + i <= kMaxUniverse; ++i)
            result.push_back(static_cast<std::uint16_t>(port.universe + i));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

struct Receiver::Loop {
    Loop(Receiver& receiver, const ReceiverOptions& wanted, std::unique_ptr<Listener> opened)
        : owner(receiver), options(wanted), listener(std::move(opened)), intake(with_recording(wanted)),
          usb(wanted.usb, wanted.usb_by_id), midi(wanted.midi),
          answers(port_addresses(wanted.universes, wanted.artnet_offset)), port_watch(ports_of(wanted)) {
        statistics.listening = {wanted.sacn,
                                wanted.artnet,
                                wanted.interface,
                                wanted.artnet_offset,
                                wanted.show_preview,
                                steady_now(),
                                "",
                                wanted.artnet_ltp,
                                wanted.answer_polls};
    }

    IntakeOptions with_recording(const ReceiverOptions& wanted) {
        IntakeOptions result = intake_options(wanted);
        if (wanted.on_levels)
            result.before_levels = [this](std::uint16_t universe) { keep(universe, steady_now()); };
        return result;
    }
    void run();
    void keep(std::uint16_t universe, nanoseconds now);
    bool take_all();
    void begin_catch_up();
    bool was_paused();
    std::vector<int> handles() const;
    void take_usb(nanoseconds now);
    void take_midi(nanoseconds now);
    void listen_to(const std::vector<std::uint16_t>& universes, nanoseconds now);
    void take(const Datagram& datagram, Protocol protocol);
    void announce(nanoseconds now);
    void answer(const PollPacket& poll, const Datagram& datagram);
    void answer_others(const Datagram& datagram);
    void begin_answers(nanoseconds now);
    void send_unasked(nanoseconds now);
    void send_replies(nanoseconds now);
    void publish(nanoseconds now);
    void publish_statistics(nanoseconds now);
    nanoseconds time_to_wait(nanoseconds now) const;
    Listener::More more_groups(nanoseconds now);

    Receiver& owner;
    ReceiverOptions options;
    std::unique_ptr<Listener> listener;
    Intake intake;
    UsbPorts usb;
    MidiInput midi;
    PollAnswers answers;
    PortWatch port_watch;
    Wider wider;
    Statistics statistics;
    const std::uint64_t reverse_path_before = reverse_path_drops();
    RecentLoss before, at_last; // totals when the window of Statistics::recent begins, and half way
    nanoseconds next_window{0};
    std::vector<nanoseconds> unpublished; // arrivals of level packets
    nanoseconds published{0};
    std::uint64_t published_revision = 0;
    nanoseconds answers_since{0};
    std::size_t answers_sent = 0; // since then
    bool kept = false;            // for a recording, and not published
    nanoseconds ran{0};           // the last time that we know we did not stand still
    CatchUp catch_up;
    std::uint64_t calm_overflow = 0; // packets that had found no room when no pause was in sight
    std::atomic<bool> stop{false};
    std::thread thread;
};

// Not of loopback networks, unless that is where we were told to listen.
void Receiver::Loop::announce(nanoseconds now) {
    if (!listener->artnet_out() || !options.answer_polls) return;
    for (const NetInterface& interface : listener->interfaces())
        if (interface.address != 0 && (!interface.loopback || listener->chosen()))
            answers.hello(interface.broadcast, interface.address, now);
}

void Receiver::Loop::answer(const PollPacket& poll, const Datagram& datagram) {
    if (!listener->artnet_out() || !options.answer_polls) return;
    const std::uint32_t asker = datagram.from.ipv4();
    const std::uint32_t ours = listener->chosen() ? listener->chosen()->address : datagram.local_ipv4;
    if (!listener->is_local_network(asker) || !answers.asked(poll, asker, ours, datagram.time))
        ++statistics.polls_refused;
}

void Receiver::Loop::answer_others(const Datagram& datagram) {
    if (!options.answer_artnet || !listener->artnet_out() ||
        !listener->is_local_network(datagram.from.ipv4()))
        return;
    begin_answers(datagram.time);
    const auto place_of = [this](std::uint16_t port_address) { return answers.place_of(port_address); };
    for (const std::vector<std::uint8_t>& packet : options.answer_artnet(datagram, place_of)) {
        if (answers_sent++ >= kMaxAnswers) return;
        (void)listener->artnet_out()->send(packet, datagram.from, options.artnet_port);
    }
}

void Receiver::Loop::begin_answers(nanoseconds now) {
    if (now < answers_since + kAnswersEvery) return;
    answers_since = now;
    answers_sent = 0;
}

// Half of what may be sent is left to who asks, and the longest table has room in it.
void Receiver::Loop::send_unasked(nanoseconds now) {
    if (!options.unasked || !listener->artnet_out()) return;
    begin_answers(now);
    const auto place_of = [this](std::uint16_t port_address) { return answers.place_of(port_address); };
    while (answers_sent < kMaxAnswers / 2) {
        const auto next = options.unasked(now, place_of);
        if (!next) return;
        answers_sent += next->packets.size();
        for (const std::vector<std::uint8_t>& packet : next->packets)
            (void)listener->artnet_out()->send(packet, next->to_ipv4, options.artnet_port);
    }
}

void Receiver::Loop::send_replies(nanoseconds now) {
    while (const std::optional<PollAnswers::Reply> due = answers.next(now)) {
        PollReply reply;
        reply.ipv4 = due->our_ipv4;
        for (const std::uint16_t port_address : due->ports) {
            const auto universe = static_cast<std::uint16_t>(port_address + options.artnet_offset);
            const Universe* live = intake.merge().current().find(universe);
            reply.ports.push_back(
                {port_address, live && !live->lost, intake.merge().count(universe, Protocol::artnet) > 1});
        }
        reply.bind_index = due->bind_index;
        reply.rdm = options.knows_rdm && options.knows_rdm();
        reply.ltp = options.artnet_ltp;
        reply.short_name = "Ghostlight";
        reply.long_name =
            "Ghostlight visualiser, universe " + std::to_string(due->ports.front() + options.artnet_offset);
        if (due->ports.size() > 1)
            reply.long_name += " to " + std::to_string(due->ports.back() + options.artnet_offset);
        reply.report = "#0001 [0000] ok";
        // A desk that went away must not stop the others.
        if (listener->artnet_out()->send(build_poll_reply(reply), due->to_ipv4, options.artnet_port).ok())
            ++(due->asked ? statistics.poll_replies_sent : statistics.announcements_sent);
    }
}

void Receiver::Loop::take(const Datagram& datagram, Protocol protocol) {
    Arrival arrival{protocol, datagram.from, datagram.to, datagram.from_port, datagram.interface_index,
                    false,    datagram.time};
    // A broadcast comes back to its sender. Only replies are judged by it: a desk on this machine may send
    // its levels from the very same address and port.
    arrival.own = protocol == Protocol::artnet && options.answer_polls &&
                  datagram.from_port == options.artnet_port && listener->is_own(datagram.from);
    const std::uint64_t others = protocol == Protocol::artnet ? intake.others() : 0;
    if (const auto poll = intake.take(datagram.bytes, arrival)) answer(*poll, datagram);
    if (protocol == Protocol::artnet && intake.others() != others) answer_others(datagram);
    if (intake.merge().pending() && unpublished.size() < 8192) unpublished.push_back(datagram.time);
}

// A recording gets what the next packet would replace, also of the past that waited through a pause.
void Receiver::Loop::keep(std::uint16_t universe, nanoseconds now) {
    if (!options.on_levels || !intake.merge().pending(universe)) return;
    if (now - ran > kPause) begin_catch_up();
    options.on_levels(intake.merge().universes(), now);
    kept = true;
}

void Receiver::Loop::begin_catch_up() {
    catch_up.begin(intake.merge().current(), ran);
}

// Whether we stood still since the last call. Then what waits in the sockets is looked at anew.
bool Receiver::Loop::was_paused() {
    const nanoseconds turn = steady_now() - ran;
    ran += turn;
    if (turn <= kPause) return false;
    ++statistics.pauses;
    intake.merge().resume(turn, ran);
    begin_catch_up();
    listener->wait(handles(), 0s);
    return true;
}

bool Receiver::Loop::take_all() {
    return listener->drain([this](const Datagram& datagram, Protocol protocol) { take(datagram, protocol); },
                           [this](const Datagram& datagram, Protocol protocol) {
                               intake.take_elsewhere(
                                   datagram.bytes, {protocol, datagram.from, datagram.to, datagram.from_port,
                                                    datagram.interface_index, false, datagram.time});
                           });
}

void Receiver::Loop::take_usb(nanoseconds now) {
    usb.take(now, [&](const Packet& packet) {
        keep(packet.universe, now);
        intake.merge().feed(packet, now);
        if (unpublished.size() < 8192) unpublished.push_back(now);
    });
}

void Receiver::Loop::take_midi(nanoseconds now) {
    midi.take(now, [&](const TimeCode& time) {
        if (options.on_timecode) options.on_timecode(time, now);
    });
}

std::vector<int> Receiver::Loop::handles() const {
    std::vector<int> result = usb.handles();
    if (const auto handle = midi.handle()) result.push_back(*handle);
    return result;
}

void Receiver::Loop::listen_to(const std::vector<std::uint16_t>& universes, nanoseconds now) {
    if (universes == options.universes) return;
    options.universes = universes;
    listener->announce(announced_universes(universes), now);
    intake.listen_to(universes);
    intake.merge().ask_for(asked_universes(options));
    answers.announce(port_addresses(universes, options.artnet_offset));
    announce(now);
    publish(now);
}

nanoseconds Receiver::Loop::time_to_wait(nanoseconds now) const {
    nanoseconds wait = kTickEvery / 2;
    if (intake.merge().pending() || kept) wait = std::min(wait, published + kPublishEvery - now);
    if (const auto reply = answers.wait(now)) wait = std::min(wait, *reply);
    return std::max(wait, nanoseconds(0));
}

void Receiver::Loop::publish(nanoseconds now) {
    const Universes& newest = intake.merge().universes();
    Universes levels = catch_up.view(newest, [this](std::uint16_t universe) {
        return intake.merge().all_heard_since(universe, catch_up.since());
    });
    const bool changed = levels.revision != published_revision;
    if (changed) {
        nanoseconds newest_arrival{0};
        for (const Universe& universe : levels.list)
            newest_arrival = std::max(newest_arrival, universe.arrival);
        levels.first_change = newest_arrival;
    }
    published_revision = levels.revision;
    owner.levels_.put(std::move(levels), [](const Universes& unread, Universes& next) {
        if (unread.first_change.count() > 0) next.first_change = unread.first_change;
    });
    if (changed && options.on_change) options.on_change();
    if (options.on_levels) options.on_levels(newest, now);
    published = now;
    kept = false;
    const nanoseconds done = steady_now();
    for (const nanoseconds arrival : unpublished) statistics.latency.add(done - arrival);
    unpublished.clear();
}

void Receiver::Loop::publish_statistics(nanoseconds now) {
    intake.report(statistics, now);
    listener->report(statistics);
    statistics.usb = usb.status();
    statistics.midi = midi.status();
    statistics.port_users = port_watch.users();
    const RecentLoss total{statistics.merge.lost,
                           statistics.overflow,
                           statistics.merge.too_many_universes,
                           statistics.notices[static_cast<std::size_t>(Notice::poll)],
                           statistics.polls_refused,
                           statistics.drops,
                           statistics.drops_sacn,
                           reverse_path_drops() - reverse_path_before};
    if (now >= next_window) {
        before = std::exchange(at_last, total);
        next_window = now + kLossWindow;
    }
    statistics.recent = total - before;
    statistics.cpu = thread_cpu_time();
    owner.statistics_.put(statistics);
}

Listener::More Receiver::Loop::more_groups(nanoseconds now) {
    Listener::More more{intake.merge().sync_universes(), {}};
    if (!options.listen_wider || !options.sacn || options.universes.empty()) return more;
    std::vector<std::uint16_t> silent;
    // One that comes by another's group is heard only as long as we listen wider.
    const auto astray = [&](std::uint16_t universe) {
        return std::any_of(
            statistics.sources.begin(), statistics.sources.end(),
            [&](const SourceStatus& one) { return one.universe == universe && one.wrong_group; });
    };
    for (const std::uint16_t universe : options.universes)
        if (!intake.merge().has_source(universe) || astray(universe)) silent.push_back(universe);
    wider.update(silent, statistics.discovered, now);
    const std::vector<std::uint16_t>& universes = wider.universes();
    statistics.listening.wider = universes.size();
    if (universes.empty()) return more;
    more.elsewhere = universes;
    silent.resize(std::min(silent.size(), kMostWider));
    more.elsewhere.insert(more.elsewhere.end(), silent.begin(), silent.end());
    more.here.insert(more.here.end(), universes.begin(), universes.end());
    for (std::vector<std::uint16_t>* list : {&more.here, &more.elsewhere}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return more;
}

void Receiver::Loop::run() {
    const nanoseconds start = steady_now();
    nanoseconds next_tick{0}, next_statistics{0}, next_interfaces = start + kInterfacesEvery;
    ran = start;
    intake.merge().listen(start);
    announce(start);
    while (!stop.load(std::memory_order_relaxed)) {
        listener->wait(handles(), time_to_wait(steady_now()));
        const bool paused = was_paused();
        bool drained = take_all();
        if (was_paused())
            drained = take_all();
        else if (!paused && !catch_up.active())
            calm_overflow = statistics.overflow;
        const nanoseconds now = ran;
        if (catch_up.reading() && drained) {
            intake.merge().resume(0s, now); // what was lost is no reason to take the next number for late
            catch_up.read_all(listener->overflow() > calm_overflow);
            kept = true;
        }
        kept |= catch_up.expire(now);
        take_usb(now);
        take_midi(now);
        if (const auto universes = owner.wanted_.take()) listen_to(*universes, now);
        if (now >= next_tick) {
            intake.tick(now);
            owner.sampling_.store(intake.merge().sampling(), std::memory_order_relaxed);
            send_unasked(now);
            next_tick = now + kTickEvery;
        }
        const bool due = now >= published + (drained ? kPublishEvery : kPublishAtLast) && !catch_up.reading();
        if ((intake.merge().pending() || kept) && due) publish(now);
        if (now >= next_statistics) {
            publish_statistics(now);
            next_statistics = now + kStatisticsEvery;
        }
        if (now >= next_interfaces) {
            listener->check(more_groups(now), now);
            next_interfaces = now + kInterfacesEvery;
        }
        send_replies(now);
    }
}

RecentLoss RecentLoss::operator-(const RecentLoss& before) const {
    RecentLoss since = *this;
    since.lost -= before.lost;
    since.overflow -= before.overflow;
    since.too_many_universes -= before.too_many_universes;
    since.polls -= before.polls;
    since.polls_refused -= before.polls_refused;
    since.reverse_path -= before.reverse_path;
    for (std::size_t i = 0; i < refused.size(); ++i) {
        since.refused[i] -= before.refused[i];
        since.refused_sacn[i] -= before.refused_sacn[i];
    }
    return since;
}

Receiver::Receiver() = default;

Result<std::unique_ptr<Receiver>> Receiver::start(const ReceiverOptions& options) {
    std::unique_ptr<Receiver> receiver(new Receiver());
    ReceiverOptions sorted = options;
    std::sort(sorted.universes.begin(), sorted.universes.end());
    std::sort(sorted.preview_universes.begin(), sorted.preview_universes.end());
    TRY(auto listener, Listener::open(sorted, announced_universes(sorted.universes)));
    receiver->warnings_ = listener->warnings();
    if (sorted.artnet && sorted.artnet_offset != ReceiverOptions().artnet_offset &&
        port_addresses(sorted.universes, sorted.artnet_offset).empty())
        receiver->warnings_.push_back(
            "with an Art-Net offset of " + std::to_string(sorted.artnet_offset) +
            " none of our universes has a Port-Address (0 to 32767): desks do not find us");
    receiver->sampling_ = sorted.sampling.count() > 0;
    receiver->loop_ = std::make_unique<Loop>(*receiver, sorted, std::move(listener));
    receiver->loop_->take_midi(steady_now());
    if (const MidiStatus midi = receiver->loop_->midi.status(); !midi.problem.empty())
        receiver->warnings_.push_back(midi.path + ": " + midi.problem + "; it is looked for once a second");
    receiver->loop_->thread = std::thread([loop = receiver->loop_.get()] { loop->run(); });
    return receiver;
}

void Receiver::listen_to(std::vector<std::uint16_t> universes) {
    std::sort(universes.begin(), universes.end());
    universes.erase(std::unique(universes.begin(), universes.end()), universes.end());
    wanted_.put(std::move(universes));
}

Receiver::~Receiver() {
    if (!loop_ || !loop_->thread.joinable()) return;
    loop_->stop.store(true, std::memory_order_relaxed);
    loop_->thread.join();
}

} // namespace ghost::dmx
