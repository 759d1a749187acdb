// SPDX-License-Identifier: Apache-2.0
#include "web/server.h"

#include "base/give_way.h"
#include "base/log.h"
#include "base/steady_time.h"
#include "web/private/server_loop.h"

#include <algorithm>
#include <exception>

namespace ghost::web {

Result<std::unique_ptr<Server>> Server::open(ui::Link& link, const ServerOptions& options) {
    TRY(auto listener, dmx::TcpListener::open(options.address, options.port));
    TRY(auto wake, dmx::StreamWake::open());
    return std::unique_ptr<Server>(new Server(link, options, std::move(listener), std::move(wake)));
}

Server::Server(ui::Link& link, const ServerOptions& options, std::unique_ptr<dmx::TcpListener> listener,
               std::shared_ptr<dmx::StreamWake> wake)
    : link_(link), options_(options), listener_(std::move(listener)), wake_(std::move(wake)) {
    gate_.access.own = own_names(listener_->port(), options.host);
    gate_.access.token = make_token();
    if (options.digits_now) gate_.access.pairing = Pairing(steady_now_s());
    if (options.control) gate_.access.control_token = make_token();
    set_news(true);
    thread_ = std::thread([this] { run(); });
}

Server::~Server() {
    stop_ = true;
    wake_->raise();
    thread_.join();
    set_news(false);
}

void Server::set_news(bool wanted) {
    link_.opened.also_for_second(wanted);
    link_.picture.also_for_second(wanted); // of a show at rest there is no other one
    link_.network.also_for_second(wanted);
    link_.messages.also_for_second(wanted);
    link_.looks.also_for_second(wanted);
    link_.cue.also_for_second(wanted);
    link_.camera_pictures.also_for_second(wanted);
    link_.look_pictures.also_for_second(wanted);
    if (wanted) return;
    link_.rig.also_for_second(false);
    link_.wants_small_pictures = false;
    link_.side_views.put({});
}

Keys Server::keys() const {
    const std::lock_guard lock(gate_.mutex);
    const Access& access = gate_.access;
    Keys keys{access.token, access.control_token, "", 0};
    const double left_s = access.pairing ? access.pairing->until_s() - steady_now_s() : 0;
    if (left_s > 0) {
        keys.digits = access.pairing->digits();
        keys.digits_left_s = left_s;
    }
    return keys;
}

std::vector<Looker> Server::lookers() const {
    const std::lock_guard lock(gate_.mutex);
    return gate_.lookers;
}

double Server::cpu_s() const {
    const std::lock_guard lock(gate_.mutex);
    return gate_.cpu_s;
}

void Server::allow_control(bool allowed) {
    const std::lock_guard lock(gate_.mutex);
    gate_.access.allow_control(allowed);
    ++gate_.keys;
    wake_->raise();
}

void Server::show_digits(bool shown) {
    const std::lock_guard lock(gate_.mutex);
    gate_.access.pairing.reset();
    if (shown) gate_.access.pairing = Pairing(steady_now_s());
}

void Server::renew_token() {
    const std::lock_guard lock(gate_.mutex);
    gate_.access.renew();
}

void Server::send_all_away() {
    const std::lock_guard lock(gate_.mutex);
    gate_.access.renew();
    ++gate_.keys;
    ++gate_.sent_away;
    wake_->raise();
}

void Server::run() {
    give_way(kGiveWayABit);
    try {
        ServerLoop loop(link_, *listener_, wake_, gate_, options_, stop_);
        while (!stop_) loop.round();
    } catch (const std::exception& problem) { // no memory, as a rule
        log_error(std::string("browsers see nothing any more: ") + problem.what());
    }
}

} // namespace ghost::web
