// SPDX-License-Identifier: Apache-2.0
#include "web/server.h"

#include "base/give_way.h"
#include "base/log.h"
#include "web/private/server_loop.h"

#include <exception>

namespace ghost::web {

Result<std::unique_ptr<Server>> Server::open(ui::Link& link, const ServerOptions& options) {
    TRY(auto listener, dmx::TcpListener::open(options.address, options.port));
    TRY(auto wake, dmx::StreamWake::open());
    return std::unique_ptr<Server>(new Server(link, options, std::move(listener), std::move(wake)));
}

Server::Server(ui::Link& link, const ServerOptions& options, std::unique_ptr<dmx::TcpListener> listener,
               std::unique_ptr<dmx::StreamWake> wake)
    : link_(link), options_(options), listener_(std::move(listener)),
      wake_(std::move(wake)), access_{own_names(listener_->port(), options.host), make_token(), Pairing(0)} {
    link_.opened.also_for_second(true);
    link_.picture.also_for_second(true); // of a show at rest there is no other one
    link_.network.also_for_second(true);
    link_.messages.also_for_second(true);
    thread_ = std::thread([this] { run(); });
}

Server::~Server() {
    stop_ = true;
    wake_->raise();
    thread_.join();
}

void Server::run() {
    constexpr double kBytesPerMbit = 1e6 / 8;
    give_way();
    try {
        ServerLoop loop(link_, *listener_, *wake_, access_, options_.mbit * kBytesPerMbit);
        while (!stop_) loop.round();
    } catch (const std::exception& problem) { // no memory, as a rule
        log_error(std::string("browsers see nothing any more: ") + problem.what());
    }
}

} // namespace ghost::web
