// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/private/listener.h"

#include "dmx/receive/poll_answers.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

constexpr int kReceiveBufferBytes = 4 << 20; // a burst of 512 universes from two desks with room to spare
// By unicast all universes come to one socket: 1.1 s of 512 at 44 Hz, while others have the processor.
constexpr int kUnicastBufferBytes = 16 << 20;
constexpr std::size_t kManyUniverses = 128; // from here on a small buffer is too small
constexpr int kMaxBatchesPerTurn = 64;      // so that a flood cannot keep one socket's turn for ever

const NetInterface* find_index(const std::vector<NetInterface>& list, unsigned index) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.index == index; });
    return found == list.end() ? nullptr : &*found;
}

} // namespace

Result<std::unique_ptr<Listener>> Listener::open(const ReceiverOptions& options,
                                                 const std::vector<std::uint16_t>& announced) {
    std::unique_ptr<Listener> listener(new Listener(options));
    TRY_VOID(listener->open_all(announced));
    return listener;
}

Result<UdpSocket*> Listener::add(Protocol protocol, std::uint32_t address, bool groups, bool ipv6) {
    const std::uint16_t port = protocol == Protocol::sacn ? options_.sacn_port : options_.artnet_port;
    const int buffer_bytes = groups ? kReceiveBufferBytes : kUnicastBufferBytes;
    auto opened =
        ipv6 ? UdpSocket::open_ipv6(port, buffer_bytes) : UdpSocket::open(address, port, buffer_bytes);
    if (!opened.ok()) return opened.error();
    sockets_.push_back(std::move(*opened));
    std::string name = protocol_name(protocol);
    if (groups) name += " groups";
    if (address) name += " " + ipv4_text(address);
    roles_.push_back({protocol, name, groups});
    return sockets_.back().get();
}

// Bound to the very address, so that another program on this machine cannot take our unicast.
Result<void> Listener::open_chosen() {
    artnet_out_ = artnet_plain_;
    if (!chosen_ || chosen_->address == 0) return {};
    if (options_.sacn) TRY_VOID(add(Protocol::sacn, chosen_->address, false, false));
    if (options_.artnet) {
        TRY(artnet_out_, add(Protocol::artnet, chosen_->address, false, false));
    }
    return {};
}

void Listener::close(UdpSocket* socket) {
    for (std::size_t i = 0; i < sockets_.size(); ++i) {
        if (sockets_[i].get() != socket) continue;
        closed_overflow_ += socket->overflow();
        sockets_.erase(sockets_.begin() + static_cast<std::ptrdiff_t>(i));
        roles_.erase(roles_.begin() + static_cast<std::ptrdiff_t>(i));
        return;
    }
}

void Listener::look_at_interfaces() {
    all_ = list_interfaces();
    interfaces_.clear();
    if (chosen_) {
        interfaces_.push_back(*chosen_);
        return;
    }
    for (const NetInterface& interface : all_)
        if (!find_index(interfaces_, interface.index)) interfaces_.push_back(interface);
}

void Listener::announce(const std::vector<std::uint16_t>& universes, std::chrono::nanoseconds now) {
    announced_ = universes;
    if (options_.sacn) announced_.push_back(kDiscoveryUniverse);
    std::sort(announced_.begin(), announced_.end());
    join_groups(more_);
    if (const std::string failed = failed_joins(); !failed.empty()) note(failed, now);
}

Result<void> Listener::open_all(const std::vector<std::uint16_t>& announced) {
    announced_ = announced;
    if (options_.sacn) announced_.push_back(kDiscoveryUniverse);
    std::sort(announced_.begin(), announced_.end());
    if (!options_.interface.empty()) {
        TRY(chosen_, find_interface(options_.interface));
    }
    look_at_interfaces();
    if (options_.sacn) {
        // The socket that was bound last gets the unicast, so the plain one comes after those for groups.
        groups4_.emplace(false, [this] { return add(Protocol::sacn, 0, true, false); });
        groups6_.emplace(true, [this] { return add(Protocol::sacn, 0, true, true); });
        elsewhere4_.emplace(false, [this] { return add(Protocol::sacn, 0, true, false); });
        join_groups({});
        TRY_VOID(add(Protocol::sacn, 0, false, false));
        // A machine without IPv6 is none the worse.
        if (std::any_of(all_.begin(), all_.end(), [](const NetInterface& one) { return one.ipv6; }))
            (void)add(Protocol::sacn, 0, false, true);
    }
    if (options_.artnet) {
        TRY(artnet_plain_, add(Protocol::artnet, 0, false, false));
    }
    TRY_VOID(open_chosen());
    const int granted = sockets_.empty() ? kReceiveBufferBytes : sockets_.front()->receive_buffer();
    if (granted < kReceiveBufferBytes && announced_.size() > kManyUniverses)
        warnings_.push_back(
            "the system grants a receive buffer of " + std::to_string(granted / 1024) +
            " KiB, too little for bursts of " + std::to_string(announced.size()) +
            " universes; as root: sysctl -w net.core.rmem_max=" + std::to_string(kReceiveBufferBytes));
    return {};
}

// None of loopback: who chose that has no network in mind.
std::vector<NetInterface> Listener::other_interfaces() const {
    std::vector<NetInterface> result;
    if (!chosen_ || chosen_->loopback) return result;
    for (const NetInterface& one : all_)
        if (one.index != chosen_->index && !one.loopback && !find_index(result, one.index))
            result.push_back(one);
    return result;
}

void Listener::join_groups(const More& more) {
    more_ = more;
    if (!groups4_) return;
    std::vector<std::uint16_t> universes = announced_;
    universes.insert(universes.end(), more.here.begin(), more.here.end());
    if (!more.here.empty()) universes.push_back(0); // there is none, but for desks that count from 0
    std::sort(universes.begin(), universes.end());
    universes.erase(std::unique(universes.begin(), universes.end()), universes.end());
    groups4_->update(universes, interfaces_);
    groups6_->update(universes, interfaces_); // where it has no room or no IPv6, SocketStatus shows no groups
    elsewhere4_->update(more.elsewhere, other_interfaces()); // only to say what is there
    if (const std::string failed = failed_joins(); !failed.empty() && warnings_.empty())
        warnings_.push_back(failed);
}

std::string Listener::failed_joins() const {
    if (!groups4_ || groups4_->failures().empty()) return "";
    const std::vector<std::string>& failures = groups4_->failures();
    return std::to_string(failures.size()) +
           " multicast groups could not be joined, the first: " + failures.front();
}

void Listener::note(const std::string& text, std::chrono::nanoseconds now, bool is_loss,
                    unsigned interface_index) {
    const std::uint64_t number = link_changes_.empty() ? 1 : link_changes_.back().number + 1;
    if (link_changes_.size() >= kMaxRemembered) link_changes_.erase(link_changes_.begin());
    link_changes_.push_back({number, text, now, is_loss, interface_index});
}

void Listener::check(const More& more, std::chrono::nanoseconds now) {
    const std::vector<NetInterface> before = all_;
    const std::optional<NetInterface> before_chosen = chosen_;
    if (!options_.interface.empty()) {
        const auto found = find_interface(options_.interface);
        if (found.ok()) chosen_ = *found;
    }
    look_at_interfaces();
    const bool changed = before != all_;
    for (const NetInterface& interface : before)
        if (changed && !find_index(all_, interface.index))
            note(interface.name + ": gone", now, true, interface.index);
    for (const NetInterface& interface : all_) {
        if (!changed) break;
        const NetInterface* old = find_index(before, interface.index);
        if (!old)
            note(interface.name + ": came up", now);
        else if (old->running != interface.running)
            note(interface.name + (interface.running ? ": cable plugged in" : ": cable pulled"), now,
                 !interface.running, interface.index);
        else if (std::find(before.begin(), before.end(), interface) == before.end())
            note(interface.name + ": its address changed", now);
    }
    if (chosen_ && before_chosen && chosen_->address != before_chosen->address) {
        for (std::size_t i = sockets_.size(); i-- > 0;)
            if (!roles_[i].groups && roles_[i].name.ends_with(ipv4_text(before_chosen->address)))
                close(sockets_[i].get());
        const auto opened = open_chosen();
        if (!opened.ok()) note(opened.error().text(), now);
    }
    if (changed || more != more_) join_groups(more);
}

bool Listener::is_own(const IpAddress& address) const {
    if (chosen_ && address == IpAddress(chosen_->address))
        return true; // of a loopback network not configured
    return std::any_of(all_.begin(), all_.end(), [&](const NetInterface& one) {
        return one.address != 0 && address == IpAddress(one.address);
    });
}

bool Listener::is_local_network(std::uint32_t ipv4) const {
    return is_local(ipv4, all_);
}

// A broadcast reaches every socket of the port, a group those that joined it, unicast the one that was bound
// to its address or, of several, bound last.
Listener::Way Listener::way_of(const Datagram& datagram, const Role& role) const {
    const bool group = datagram.to.is_multicast();
    const bool unicast = !group && (!datagram.to.is_ipv4() || datagram.to == IpAddress(datagram.local_ipv4));
    if (role.groups && !group && !unicast) return Way::twice;
    if (!chosen_ || datagram.interface_index == chosen_->index) return Way::ours;
    const bool to_us = !group && (datagram.to == IpAddress(chosen_->address) || datagram.to.is_loopback());
    return to_us ? Way::ours : Way::elsewhere;
}

bool Listener::drain(const Take& take, const Take& elsewhere) {
    bool empty = true;
    for (std::size_t i = 0; i < std::min(sockets_.size(), ready_.size()); ++i) {
        if (!ready_[i]) continue;
        int turn = 0;
        for (; turn < kMaxBatchesPerTurn; ++turn) {
            const std::span<const Datagram> batch = sockets_[i]->receive();
            if (batch.empty()) break;
            for (const Datagram& datagram : batch) {
                const Way way = way_of(datagram, roles_[i]);
                if (way == Way::ours) take(datagram, roles_[i].protocol);
                if (way == Way::elsewhere) elsewhere(datagram, roles_[i].protocol);
            }
        }
        empty &= turn < kMaxBatchesPerTurn;
    }
    return empty;
}

std::uint64_t Listener::overflow() const {
    std::uint64_t sum = closed_overflow_;
    for (const auto& socket : sockets_) sum += socket->overflow();
    return sum;
}

void Listener::report(Statistics& statistics) const {
    statistics.overflow = overflow();
    statistics.sockets.clear();
    for (std::size_t i = 0; i < sockets_.size(); ++i) {
        UdpSocket& socket = *sockets_[i];
        const bool ipv6 = socket.version() == IpVersion::v6;
        const auto& groups = ipv6 ? groups6_ : groups4_;
        const Protocol protocol = roles_[i].protocol;
        const std::uint16_t port = protocol == Protocol::sacn ? options_.sacn_port : options_.artnet_port;
        statistics.sockets.push_back(
            {roles_[i].name, protocol, port, ipv6,
             groups ? groups->joined_by(&socket) + elsewhere4_->joined_by(&socket) : 0,
             socket.receive_buffer(), socket.packets(), socket.overflow()});
    }
    statistics.link_changes = link_changes_;
    statistics.interfaces = all_;
}

} // namespace ghost::dmx
