#pragma once
// SPDX-License-Identifier: Apache-2.0
// Browsers: a server that a window switches on and off while the engine goes on. news: any thread; all else:
// one thread, the window's.

#include "web/server.h"

#include <memory>
#include <mutex>

namespace ghost::web {

class Browsers {
public:
    // The link must outlive it.
    explicit Browsers(ui::Link& link) : link_(link) {}

    // Instead of the one before. Error: the port is taken; nothing listens then.
    Result<void> open(const ServerOptions& options);
    void close();
    // Null: nothing listens.
    Server* server() { return server_.get(); }
    // As it listens, or did last.
    const ServerOptions& options() const { return options_; }
    // The engine has put something.
    void news();

private:
    ui::Link& link_;
    ServerOptions options_;
    std::mutex mutex_; // of which server there is
    std::unique_ptr<Server> server_;
};

} // namespace ghost::web
