#pragma once
// SPDX-License-Identifier: Apache-2.0
// Server: the page and, by WebSocket, pictures and news of the engine for browsers: plain HTTP on one TCP
// port, a thread of its own that gives way a bit, as others wait for its end, and two that give way to all:
// one encodes pictures, one reads the cue book. It reads what the engine says as the second reader of the
// link and asks it why fixtures are dark; it changes nothing unless control is allowed. Nobody waits for a
// browser. All functions but the destructor: any thread.

#include "base/result.h"
#include "link/link.h"
#include "net/tcp.h"
#include "web/protocol.h"
#include "web/site.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ghost::web {

inline constexpr std::size_t kMostViewers = 20;
inline constexpr std::size_t kMostOthers = 64; // connections beside those of viewers

struct ServerOptions {
    std::uint32_t address = 0x7F000001; // this machine alone; 0: whoever reaches us
    std::uint16_t port = 0;             // 0: one that is free
    std::string host;       // we are called so by who stands before us (a TLS proxy); empty: nobody does
    double mbit = 60;       // of pictures, all viewers together, a second
    std::string book;       // folder of a cue book; empty: there is none
    bool control = false;   // there is a token that may control
    bool digits_now = true; // six digits hold from the beginning
    double silence_s =
        120; // of a viewer, who is gone then; hidden tabs say little, their system answers pings
};

// What lets browsers in now.
struct Keys {
    std::string token;
    std::string control_token; // empty: nobody may control
    std::string digits;        // empty: nobody comes in by them
    double digits_left_s = 0;
};

// What the server's thread and those who command it share.
struct Gate {
    mutable std::mutex mutex; // of all below
    Access access;
    std::uint64_t keys = 1;      // grows with each token
    std::uint64_t sent_away = 0; // times
    std::vector<Looker> lookers;
    double cpu_s = 0; // that the server's threads have used
};

class Server {
public:
    // Tokens and digits are new at each start. The link must outlive it.
    static Result<std::unique_ptr<Server>> open(ui::Link& link, const ServerOptions& options);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    // The engine has put something; any thread.
    void news() { wake_->raise(); }
    std::uint16_t port() const { return listener_->port(); }
    const ServerOptions& options() const { return options_; }
    Keys keys() const;
    std::vector<Looker> lookers() const;
    double cpu_s() const; // of its threads since it began, half a second late at most

    // Each time with a token of its own; who has one before only looks on, until tokens are renewed.
    void allow_control(bool allowed);
    // New digits, or none.
    void show_digits(bool shown);
    // Who is in stays; nobody else comes in with the token before.
    void renew_token();
    // The same, and nobody stays.
    void send_all_away();

private:
    Server(ui::Link& link, const ServerOptions& options, std::unique_ptr<dmx::TcpListener> listener,
           std::shared_ptr<dmx::StreamWake> wake);
    void run();
    void set_news(bool wanted);

    ui::Link& link_;
    const ServerOptions options_;
    std::unique_ptr<dmx::TcpListener> listener_;
    std::shared_ptr<dmx::StreamWake> wake_; // threads that nobody waits for raise it, too
    Gate gate_;
    std::atomic<bool> stop_{false};
    std::thread thread_; // the last member: it uses all others
};

} // namespace ghost::web
