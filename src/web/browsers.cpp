// SPDX-License-Identifier: Apache-2.0
#include "web/browsers.h"

#include <utility>

namespace ghost::web {

Result<void> Browsers::open(const ServerOptions& options) {
    close();
    options_ = options;
    TRY(auto server, Server::open(link_, options));
    const std::lock_guard lock(mutex_);
    server_ = std::move(server);
    return {};
}

void Browsers::close() {
    std::unique_ptr<Server> gone;
    {
        const std::lock_guard lock(mutex_);
        gone = std::move(server_);
    }
}

void Browsers::news() {
    const std::lock_guard lock(mutex_);
    if (server_) server_->news();
}

} // namespace ghost::web
