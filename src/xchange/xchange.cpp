// SPDX-License-Identifier: Apache-2.0
#include "xchange/xchange.h"

#include "disk/files.h"
#include "mvr/mvr_load.h"
#include "xchange/private/xchange_loop.h"

#include <algorithm>
#include <cstdlib>

namespace ghost::app {

namespace {

constexpr std::size_t kMostEvents = 1000;
constexpr auto kTurn = std::chrono::milliseconds(50); // mDNS is looked at as often

// What tells this machine from others, so that its station is the same one the next time.
std::string machine() {
    const auto id = read_text_file("/etc/machine-id", 256);
    return id.ok() ? *id : dmx::host_name();
}

Result<dmx::IpAddress> split_peer(const std::string& text, std::uint16_t& port) {
    const std::size_t colon = text.rfind(':');
    int number = 0;
    if (colon != std::string::npos) number = std::atoi(text.c_str() + colon + 1);
    std::string address = text.substr(0, colon);
    if (address.starts_with('[') && address.ends_with(']')) address = address.substr(1, address.size() - 2);
    const auto parsed = dmx::parse_address(address);
    if (!parsed.ok() || number < 1 || number > 65535)
        return Error{"'" + text + "', expected an address and a TCP port, like 10.0.0.5:4568", "--peer"};
    port = static_cast<std::uint16_t>(number);
    return *parsed;
}

} // namespace

const char* name_of(XchangeEvent::Kind kind) {
    switch (kind) {
    case XchangeEvent::Kind::found:
        return "found";
    case XchangeEvent::Kind::joined:
        return "joined";
    case XchangeEvent::Kind::left:
        return "left";
    case XchangeEvent::Kind::offered:
        return "offered";
    case XchangeEvent::Kind::received:
        return "received";
    case XchangeEvent::Kind::sent:
        return "sent";
    case XchangeEvent::Kind::trouble:
        break;
    }
    return "trouble";
}

Result<std::unique_ptr<Xchange::Loop>> Xchange::Loop::open(const XchangeOptions& options) {
    std::unique_ptr<Loop> loop(new Loop());
    loop->options_ = options;
    XchangeOptions& own = loop->options_;
    if (own.group.empty() || own.group.size() > 60)
        return Error{"the name of a group has 1 to 60 letters", "--group"};
    if (own.station.empty()) own.station = "Ghostlight on " + dmx::host_name();
    own.station.resize(std::min<std::size_t>(own.station.size(), 60)); // a label of mDNS
    const std::string of_machine = machine();
    const std::string_view identity[] = {of_machine, own.station};
    loop->uuid_ = scene::uuid_of(identity);
    std::error_code code;
    if (!own.save.empty()) std::filesystem::create_directories(own.save, code);
    if (!own.save.empty() && !std::filesystem::is_directory(own.save, code))
        return Error{"is no folder that plots can be saved to", own.save.string()};
    for (const std::filesystem::path& file : own.share) {
        TRY(const auto bytes, read_file(file, scene::kMaxXchangeFileBytes));
        if (const auto plot = scene::load_mvr(file); !plot.ok())
            return Error{"cannot be shared, it is no .mvr: " + plot.error().what, file.string()};
        const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        const std::string_view parts[] = {loop->uuid_, content};
        Commit commit;
        commit.file_uuid = scene::uuid_of(parts);
        commit.station_uuid = loop->uuid_;
        commit.file_name = file.filename().string();
        commit.comment = file.stem().string();
        commit.file_size = bytes.size();
        loop->had_.insert(commit.file_uuid);
        loop->shared_.push_back({std::move(commit), file});
    }
    for (const std::string& peer : own.peers) {
        Known known;
        TRY(known.station.address, split_peer(peer, known.station.port));
        known.station.name = peer;
        known.fixed = true;
        loop->known_[peer] = known;
    }
    std::uint32_t address = 0;
    std::string device;
    if (!own.interface.empty()) {
        TRY(const dmx::NetInterface interface, dmx::find_interface(own.interface));
        address = interface.address;
        device = interface.name;
    }
    TRY(loop->listener_, dmx::TcpListener::open(address, own.port, device));
    if (!own.finds) return loop;
    constexpr int kReceiveBufferBytes = 256 << 10;
    TRY(loop->mdns_, dmx::UdpSocket::open(0, own.mdns_port, kReceiveBufferBytes));
    loop->check_interfaces();
    return loop;
}

Xchange::Loop::~Loop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
}

void Xchange::Loop::tell(XchangeEvent::Kind kind, const std::string& station, const std::string& text,
                         const std::filesystem::path& file, const std::string& comment) {
    const std::lock_guard lock(mutex_);
    if (events_.size() >= kMostEvents) events_.erase(events_.begin());
    events_.push_back({kind, station, text, file, comment});
}

std::vector<XchangeEvent> Xchange::Loop::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(events_, {});
}

void Xchange::Loop::step(std::chrono::milliseconds patience) {
    std::vector<dmx::WaitFor> streams{{listener_->handle(), false}};
    for (const Connection& connection : connections_)
        streams.push_back({connection.peer->handle(), connection.peer->has_to_send()});
    dmx::wait_for_streams(streams, patience);
    if (mdns_) {
        if (now_s() >= next_interfaces_s_) check_interfaces();
        if (now_s() >= next_question_s_) ask_and_announce(false);
        hear();
    }
    accept();
    join_known();
    fetch_wanted();
    for (Connection& connection : connections_) turn(connection);
    std::erase_if(connections_, [](const Connection& connection) { return connection.done; });
}

void Xchange::Loop::run() {
    while (!stop_) step(kTurn);
    leave();
}

Xchange::Xchange() = default;
Xchange::~Xchange() = default;

Result<std::unique_ptr<Xchange>> Xchange::start(const XchangeOptions& options) {
    std::unique_ptr<Xchange> result(new Xchange());
    TRY(result->loop_, Loop::open(options));
    result->loop_->begin();
    return result;
}

std::vector<XchangeEvent> Xchange::take() {
    return loop_->take();
}

std::uint16_t Xchange::port() const {
    return loop_->port();
}

} // namespace ghost::app
