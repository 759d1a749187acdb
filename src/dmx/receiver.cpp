// SPDX-License-Identifier: Apache-2.0
#include "dmx/receiver.h"

#include "dmx/build.h"
#include "dmx/socket.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <thread>

namespace ghost::dmx {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr int kReceiveBufferBytes = 4 << 20; // a burst of 512 universes from two desks with room to spare
constexpr std::size_t kGroupsPerSocket = 20; // the kernel's limit
constexpr std::size_t kDefaultUniverses = 64;
constexpr nanoseconds kPublishEvery = 1ms; // packets that trickle in share one publication
constexpr nanoseconds kTickEvery = 100ms;
constexpr nanoseconds kStatisticsEvery = 250ms;
constexpr nanoseconds kReplyEvery = 4ms; // pace of ArtPollReply: kRepliesAtOnce each time
constexpr std::size_t kRepliesAtOnce = 8;
constexpr std::size_t kMaxPollers = 16;
constexpr nanoseconds kPollerRest =
    500ms;                             // a poll that soon after the last one of the same address is ignored
constexpr int kMaxBatchesPerTurn = 64; // so that a flood cannot keep one socket's turn for ever

nanoseconds steady_now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

bool is_multicast(std::uint32_t ipv4) {
    return (ipv4 >> 28) == 0xE;
}
bool is_loopback(std::uint32_t ipv4) {
    return (ipv4 >> 24) == 127;
}

// One run of replies, one per announced universe, to one address.
struct ReplyRun {
    std::uint32_t to_ipv4 = 0;
    std::uint32_t our_ipv4 = 0;
    std::size_t next = 0;
    nanoseconds due{0};
    nanoseconds forget{0}; // when the address may ask again
    bool asked = false;    // else the hello at start
};

} // namespace

struct Receiver::Loop {
    Loop(Receiver& receiver, const ReceiverOptions& wanted)
        : owner(receiver), options(wanted), merge(MergeOptions{wanted.show_preview, wanted.slot_status}) {
        std::sort(options.universes.begin(), options.universes.end());
        accept_all = options.universes.empty();
        announced = options.universes;
        for (std::size_t i = 1; accept_all && i <= kDefaultUniverses; ++i)
            announced.push_back(static_cast<std::uint16_t>(i));
    }

    Result<void> open();
    Result<void> open_sacn(const std::vector<NetInterface>& interfaces);
    Result<void> open_artnet();
    Result<void> add_socket(Protocol protocol, std::uint32_t address, bool multicast_only);
    void announce(const std::vector<NetInterface>& interfaces);
    void run();
    void drain(std::size_t index);
    void take(const Datagram& datagram, Protocol protocol, nanoseconds now);
    bool wanted_interface(const Datagram& datagram) const;
    bool own_reply(const Datagram& datagram, const Parsed& parsed) const;
    void answer_poll(const Datagram& datagram, nanoseconds now);
    void send_replies(nanoseconds now);
    void publish_statistics(nanoseconds now);
    nanoseconds time_to_wait(nanoseconds now) const;

    struct Role {
        Protocol protocol;
        bool multicast_only; // unicast and broadcast of the port reach another socket as well
    };

    Receiver& owner;
    ReceiverOptions options;
    bool accept_all = false;
    std::vector<std::uint16_t> announced;
    std::optional<NetInterface> chosen;
    std::vector<std::uint32_t> own_addresses;
    std::vector<std::unique_ptr<UdpSocket>> sockets;
    std::vector<Role> roles;         // of sockets
    UdpSocket* artnet_out = nullptr; // one of sockets
    Merge merge;
    Statistics statistics;
    std::deque<ReplyRun> replies;
    nanoseconds published{0};
    std::atomic<bool> stop{false};
    std::thread thread;
};

Result<void> Receiver::Loop::add_socket(Protocol protocol, std::uint32_t address, bool multicast_only) {
    const std::uint16_t port = protocol == Protocol::sacn ? options.sacn_port : options.artnet_port;
    TRY(auto socket, UdpSocket::open(address, port, kReceiveBufferBytes));
    sockets.push_back(std::move(socket));
    roles.push_back({protocol, multicast_only});
    return {};
}

Result<void> Receiver::Loop::open_sacn(const std::vector<NetInterface>& interfaces) {
    // The socket that was bound last gets the unicast, so the plain one comes last.
    std::size_t joined = kGroupsPerSocket;
    std::size_t failed = 0;
    std::string first_failure;
    for (const std::uint16_t universe : announced) {
        for (const NetInterface& interface : interfaces) {
            if (joined == kGroupsPerSocket) {
                TRY_VOID(add_socket(Protocol::sacn, 0, true));
                joined = 0;
            }
            const Result<void> done = sockets.back()->join(sacn_group(universe), interface);
            if (!done.ok() && failed++ == 0) first_failure = done.error().text();
            ++joined;
        }
    }
    if (failed > 0)
        owner.warnings_.push_back(std::to_string(failed) +
                                  " multicast groups could not be joined, the first: " + first_failure);
    TRY_VOID(add_socket(Protocol::sacn, 0, false));
    if (chosen) TRY_VOID(add_socket(Protocol::sacn, chosen->address, false));
    return {};
}

Result<void> Receiver::Loop::open_artnet() {
    TRY_VOID(add_socket(Protocol::artnet, 0, false));
    artnet_out = sockets.back().get();
    // Bound to the very address, so that another Art-Net program on this machine cannot take our unicast.
    if (chosen) {
        TRY_VOID(add_socket(Protocol::artnet, chosen->address, false));
        artnet_out = sockets.back().get();
    }
    return {};
}

Result<void> Receiver::Loop::open() {
    const std::vector<NetInterface> all = list_interfaces();
    for (const NetInterface& interface : all) own_addresses.push_back(interface.address);
    std::vector<NetInterface> interfaces;
    if (!options.interface.empty()) {
        TRY(NetInterface found, find_interface(options.interface));
        own_addresses.push_back(found.address); // of a loopback network it need not be configured
        chosen = found;
        interfaces.push_back(std::move(found));
    } else {
        for (const NetInterface& interface : all) {
            const auto same = [&](const NetInterface& other) { return other.index == interface.index; };
            if (std::none_of(interfaces.begin(), interfaces.end(), same)) interfaces.push_back(interface);
        }
    }
    if (options.sacn) TRY_VOID(open_sacn(interfaces));
    if (options.artnet) TRY_VOID(open_artnet());
    const int granted = sockets.empty() ? kReceiveBufferBytes : sockets.front()->receive_buffer();
    if (granted < kReceiveBufferBytes && announced.size() > 2 * kDefaultUniverses)
        owner.warnings_.push_back(
            "the system grants a receive buffer of " + std::to_string(granted / 1024) +
            " KiB, too little for bursts of " + std::to_string(announced.size()) +
            " universes; as root: sysctl -w net.core.rmem_max=" + std::to_string(kReceiveBufferBytes));
    if (artnet_out && options.answer_polls) announce(interfaces);
    return {};
}

// A node says hello when it comes up, so that desks need not wait for their next poll.
void Receiver::Loop::announce(const std::vector<NetInterface>& interfaces) {
    const nanoseconds now = steady_now();
    for (const NetInterface& interface : interfaces) {
        if (replies.size() >= kMaxPollers || (interface.loopback && !chosen)) continue;
        replies.push_back({interface.broadcast, interface.address, 0, now, now});
    }
}

bool Receiver::Loop::wanted_interface(const Datagram& datagram) const {
    if (!chosen || is_multicast(datagram.to_ipv4)) return true;
    return datagram.interface_index == chosen->index || datagram.to_ipv4 == chosen->address ||
           is_loopback(datagram.to_ipv4);
}

// A broadcast comes back to its sender. Only replies are judged by address and port: a desk on this machine
// may send its levels from the very same ones.
bool Receiver::Loop::own_reply(const Datagram& datagram, const Parsed& parsed) const {
    const Notice* notice = std::get_if<Notice>(&parsed);
    return notice && *notice == Notice::poll_reply && options.answer_polls &&
           datagram.from_port == options.artnet_port &&
           std::find(own_addresses.begin(), own_addresses.end(), datagram.from_ipv4) != own_addresses.end();
}

void Receiver::Loop::answer_poll(const Datagram& datagram, nanoseconds now) {
    if (!artnet_out || !options.answer_polls || replies.size() >= kMaxPollers) return;
    const auto same = [&](const ReplyRun& run) { return run.to_ipv4 == datagram.from_ipv4; };
    if (std::any_of(replies.begin(), replies.end(), same)) return;
    const std::uint32_t ours = chosen ? chosen->address : datagram.local_ipv4;
    // Nodes spread their answers over time; ours depends on our address, so that it is the same every time.
    const nanoseconds delay = std::chrono::milliseconds(ours & 0xFF);
    replies.push_back({datagram.from_ipv4, ours, 0, now + delay, now + kPollerRest, true});
}

void Receiver::Loop::send_replies(nanoseconds now) {
    for (ReplyRun& run : replies) {
        for (std::size_t sent = 0; sent < kRepliesAtOnce && run.due <= now && run.next < announced.size();
             ++run.next) {
            const std::uint16_t universe = announced[run.next];
            const int port_address = universe - options.artnet_offset;
            if (port_address < 0 || port_address > 0x7FFF) continue;
            const Universe* live = merge.current().find(universe);
            PollReply reply;
            reply.ipv4 = run.our_ipv4;
            reply.port_address = static_cast<std::uint16_t>(port_address);
            reply.bind_index = static_cast<std::uint8_t>(std::min<std::size_t>(run.next + 1, 255));
            reply.receiving = live && !live->lost;
            reply.short_name = "Ghostlight";
            reply.long_name = "Ghostlight visualiser, universe " + std::to_string(universe);
            reply.report = "#0001 [0000] ok";
            const auto bytes = build_poll_reply(reply);
            // A desk that went away must not stop the others.
            if (artnet_out->send(bytes, run.to_ipv4, options.artnet_port).ok())
                ++(run.asked ? statistics.poll_replies_sent : statistics.announcements_sent);
            ++sent;
        }
        if (run.due <= now) run.due = now + kReplyEvery;
    }
    std::erase_if(replies,
                  [&](const ReplyRun& run) { return run.next >= announced.size() && run.forget <= now; });
}

void Receiver::Loop::take(const Datagram& datagram, Protocol protocol, nanoseconds now) {
    const bool sacn = protocol == Protocol::sacn;
    const Parsed parsed = sacn ? parse_sacn(datagram.bytes, datagram.from_ipv4)
                               : parse_artnet(datagram.bytes, datagram.from_ipv4, options.artnet_offset);
    if (!sacn && own_reply(datagram, parsed)) return;
    ++(sacn ? statistics.packets_sacn : statistics.packets_artnet);
    if (const Drop* drop = std::get_if<Drop>(&parsed)) {
        ++statistics.drops[static_cast<std::size_t>(*drop)];
    } else if (const Notice* notice = std::get_if<Notice>(&parsed)) {
        ++statistics.notices[static_cast<std::size_t>(*notice)];
        if (*notice == Notice::poll) answer_poll(datagram, now);
    } else {
        const Packet& packet = std::get<Packet>(parsed);
        if (accept_all ||
            std::binary_search(options.universes.begin(), options.universes.end(), packet.universe))
            merge.feed(packet, now);
        else
            ++statistics.unlisted;
    }
}

void Receiver::Loop::drain(std::size_t index) {
    for (int turn = 0; turn < kMaxBatchesPerTurn; ++turn) {
        const std::span<const Datagram> batch = sockets[index]->receive();
        if (batch.empty()) return;
        const nanoseconds now = steady_now();
        for (const Datagram& datagram : batch) {
            if (roles[index].multicast_only && !is_multicast(datagram.to_ipv4)) continue;
            if (wanted_interface(datagram)) take(datagram, roles[index].protocol, now);
        }
    }
}

nanoseconds Receiver::Loop::time_to_wait(nanoseconds now) const {
    nanoseconds wait = kTickEvery / 2;
    if (merge.pending()) wait = std::min(wait, published + kPublishEvery - now);
    for (const ReplyRun& run : replies)
        if (run.next < announced.size()) wait = std::min(wait, run.due - now);
    return std::max(wait, nanoseconds(0));
}

void Receiver::Loop::publish_statistics(nanoseconds now) {
    statistics.time = now;
    statistics.merge = merge.counters();
    statistics.sources = merge.sources(now);
    statistics.overflow = 0;
    for (const auto& socket : sockets) statistics.overflow += socket->overflow();
    owner.statistics_.put(statistics);
}

void Receiver::Loop::run() {
    nanoseconds next_tick{0}, next_statistics{0};
    while (!stop.load(std::memory_order_relaxed)) {
        wait_for_packets(sockets, time_to_wait(steady_now()));
        for (std::size_t i = 0; i < sockets.size(); ++i) drain(i);
        const nanoseconds now = steady_now();
        if (now >= next_tick) {
            merge.tick(now);
            next_tick = now + kTickEvery;
        }
        if (merge.pending() && now >= published + kPublishEvery) {
            owner.levels_.put(merge.universes());
            published = now;
        }
        if (now >= next_statistics) {
            publish_statistics(now);
            next_statistics = now + kStatisticsEvery;
        }
        send_replies(now);
    }
}

Receiver::Receiver() = default;

Result<std::unique_ptr<Receiver>> Receiver::start(const ReceiverOptions& options) {
    std::unique_ptr<Receiver> receiver(new Receiver());
    receiver->loop_ = std::make_unique<Loop>(*receiver, options);
    TRY_VOID(receiver->loop_->open());
    receiver->loop_->thread = std::thread([loop = receiver->loop_.get()] { loop->run(); });
    return receiver;
}

Receiver::~Receiver() {
    if (!loop_ || !loop_->thread.joinable()) return;
    loop_->stop.store(true, std::memory_order_relaxed);
    loop_->thread.join();
}

} // namespace ghost::dmx
