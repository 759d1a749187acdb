#pragma once
// SPDX-License-Identifier: Apache-2.0
// The inside of Xchange: what it knows of the stations of the network, its connections, and what it does
// about them. All but take() on one thread. Seconds since the start.

#include "base/report.h"
#include "net/socket.h"
#include "xchange/private/xchange_peer.h"
#include "xchange/xchange.h"

#include <atomic>
#include <chrono>
#include <fstream>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace ghost::app {

class Xchange::Loop {
public:
    static Result<std::unique_ptr<Loop>> open(const XchangeOptions& options);
    ~Loop();

    std::vector<XchangeEvent> take();
    std::uint16_t port() const { return listener_->port(); }
    // All that there is to do now; waits that long for something. begin() does so again and again.
    void step(std::chrono::milliseconds patience);
    void begin() {
        thread_ = std::thread([this] { run(); });
    }

private:
    using Clock = std::chrono::steady_clock;
    using Message = scene::XchangeMessage;
    using Commit = scene::XchangeCommit;

    // A station of our group.
    struct Known {
        scene::XchangeStation station;
        unsigned interface_index = 0;
        double seen_s = 0;
        double next_join_s = 0; // when it is to be joined, again if need be
        int tries = 0;
        bool fixed = false; // of the options: never forgotten
        bool joined = false;
        bool told = false; // that it cannot be joined, since it was last
    };
    enum class Purpose { serves, joins, fetches };
    struct Fetch {
        Commit commit;
        std::string station; // name
        std::filesystem::path temporary;
        std::ofstream out;
        std::uint64_t bytes = 0;
        bool too_slow = false; // others waited for its place
    };
    struct Connection {
        Purpose purpose = Purpose::serves;
        std::unique_ptr<XchangePeer> peer;
        std::string key;  // of known_, for those we began
        std::string name; // of the station, once it said so
        double begun_s = 0;
        std::optional<Fetch> fetch;
        bool done = false;
    };
    struct Shared {
        Commit commit;
        std::filesystem::path file;
    };
    struct Wanted {
        Commit commit;
        std::string key; // of known_ that has it
        int tries = 0;
        double not_before_s = 0;
    };

    Loop() = default;
    void run();
    double now_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    void tell(XchangeEvent::Kind kind, const std::string& station, const std::string& text,
              const std::filesystem::path& file = {}, const std::string& comment = {});

    // xchange_find.cpp
    void check_interfaces();
    void hear();
    void meet(const scene::XchangeStation& station, const dmx::Datagram& datagram);
    bool is_neighbour(const dmx::Datagram& datagram) const;
    void ask_and_announce(bool leaving);
    void send_by(const dmx::NetInterface& interface, const dmx::DnsPacket& packet);
    scene::XchangeStation us_at(const dmx::NetInterface& interface) const;

    // xchange_talk.cpp
    void accept();
    void join_known();
    void fetch_wanted();
    void end_slowest_fetch();
    void turn(Connection& connection);
    void answer(Connection& connection, const Message& message);
    std::string key_of(const std::string& uuid) const; // of known_; empty: none of them
    void note_commits(const Message& message, const Connection& connection);
    void want(const Commit& commit, const std::string& key);
    Result<void> take_piece(Connection& connection, Bytes piece, bool last);
    Result<void> finish_file(Connection& connection);
    void fetch_failed(Connection& connection, const std::string& why);
    Result<Connection*> begin_connection(const std::string& key, Purpose purpose);
    void join_failed(const std::string& key, const std::string& why);
    Message message_of(const char* type) const;
    void leave();

    XchangeOptions options_;
    std::string uuid_;
    Clock::time_point start_ = Clock::now();
    std::unique_ptr<dmx::TcpListener> listener_;
    std::unique_ptr<dmx::UdpSocket> mdns_; // or null
    std::vector<dmx::NetInterface> interfaces_;
    double next_interfaces_s_ = 0, next_question_s_ = 0, answered_s_ = -10;
    int questions_ = 0;
    std::map<std::string, Known> known_;       // by UUID, or by address and port
    std::map<std::string, std::string> names_; // of stations that spoke, by UUID
    std::set<std::string> spoken_of_;          // things that are said once
    std::vector<Shared> shared_;
    std::vector<Wanted> wanted_;
    std::set<std::string> had_;   // file UUIDs that were asked for
    std::size_t taken_files_ = 0; // or wanted, or being fetched
    std::uint64_t received_bytes_ = 0;
    std::list<Connection> connections_;
    std::mutex mutex_; // of events_
    std::vector<XchangeEvent> events_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

} // namespace ghost::app
