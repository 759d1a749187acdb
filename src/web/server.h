#pragma once
// SPDX-License-Identifier: Apache-2.0
// Server: the page and, by WebSocket, pictures and news of the engine for browsers: plain HTTP on one TCP
// port, one thread of its own that gives way to all others. It reads what the engine says as the second
// reader of the link, asks it why fixtures are dark, and changes nothing. Nobody waits for a browser.

#include "base/result.h"
#include "link/link.h"
#include "net/tcp.h"
#include "web/site.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

namespace ghost::web {

inline constexpr int kMostViewers = 16;
inline constexpr std::size_t kMostConnections = 24;

struct ServerOptions {
    std::uint32_t address = 0x7F000001; // this machine alone; 0: whoever reaches us
    std::uint16_t port = 0;             // 0: one that is free
    std::string host; // we are called so by who stands before us (a TLS proxy); empty: nobody does
    double mbit = 60; // of pictures, all viewers together, a second
};

class Server {
public:
    // Token and digits are new at each start. The link must outlive it.
    static Result<std::unique_ptr<Server>> open(ui::Link& link, const ServerOptions& options);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    // The engine has put something; any thread.
    void news() { wake_->raise(); }
    std::uint16_t port() const { return listener_->port(); }
    const std::string& token() const { return access_.token; }
    const std::string& digits() const { return access_.pairing->digits(); } // good for Pairing::kValid_s

private:
    Server(ui::Link& link, const ServerOptions& options, std::unique_ptr<dmx::TcpListener> listener,
           std::unique_ptr<dmx::StreamWake> wake);
    void run();

    ui::Link& link_;
    const ServerOptions options_;
    std::unique_ptr<dmx::TcpListener> listener_;
    std::unique_ptr<dmx::StreamWake> wake_;
    Access access_; // of the thread, but for the token and the digits, which stay
    std::atomic<bool> stop_{false};
    std::thread thread_; // the last member: it uses all others
};

} // namespace ghost::web
