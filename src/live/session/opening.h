#pragma once
// SPDX-License-Identifier: Apache-2.0
// Opening: a session that is opened on a thread of its own, beside the one that is drawn until then. All
// calls are of one thread; what is begun has its own copy of all that it reads. Errors: those of what is
// begun.

#include "live/session/session.h"

#include <functional>
#include <future>
#include <memory>
#include <optional>

namespace ghost::app {

class Opening {
public:
    // What is opened, to whoever watches the show that is open; the latter two are that show.
    enum class Kind { another, newer_plot, edit };
    using Opened = Result<std::unique_ptr<Session>>;

    ~Opening(); // waits for it

    // Nothing is being opened.
    void begin(Kind kind, std::function<Opened()> open);
    bool is_running() const { return opened_.valid(); } // until it is taken, or would be
    // Once, as soon as it is ready.
    std::optional<Opened> take();
    // What runs is of a show that nobody wants any more: it is never taken.
    void drop() { is_dropped_ = is_running(); }
    Kind kind() const { return kind_; } // of the one that was begun last

private:
    Kind kind_ = Kind::another;
    std::future<Opened> opened_;
    bool is_dropped_ = false;
};

} // namespace ghost::app
