#pragma once
// SPDX-License-Identifier: Apache-2.0
// BounceNews: tells the window how light bounces in the picture: how finely, what it costs, and how far its
// links are made. Engine thread.

#include "link/link.h"
#include "live/session/session.h"

namespace ghost::app {

class BounceNews {
public:
    explicit BounceNews(ui::Link& link) : link_(link) {}

    // Puts news as often as a person can read it. drawn_ms: what bounced light took of the last picture.
    void publish(const Session& session, double drawn_ms, double now_s);

private:
    ui::Link& link_;
    ui::BounceNow sent_;
    double sent_s_ = 0;
};

} // namespace ghost::app
