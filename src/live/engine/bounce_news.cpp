// SPDX-License-Identifier: Apache-2.0
#include "live/engine/bounce_news.h"

namespace ghost::app {
namespace {

constexpr double kNewsEvery_s = 0.25;

} // namespace

void BounceNews::publish(const Session& session, double drawn_ms, double now_s) {
    ui::BounceNow now;
    now.detail = session.bounce_detail();
    now.is_of_command_line = session.options.bounce.has_value();
    if (session.bounce) {
        BounceLight& bounce = *session.bounce;
        now.state = bounce.is_stopped()        ? ui::BounceNow::State::stopped
                    : bounce.is_making_links() ? ui::BounceNow::State::makes_links
                    : bounce.has_failed()      ? ui::BounceNow::State::failed
                                               : ui::BounceNow::State::bounces;
        if (now.state == ui::BounceNow::State::makes_links) {
            now.made_share = bounce.made_share();
            now.left_s = bounce.left_s();
        }
        if (now.state == ui::BounceNow::State::bounces) {
            now.solve_ms = bounce.solve_ms();
            now.draw_ms = drawn_ms;
        }
    }
    const bool is_other_state = now.state != sent_.state || now.detail != sent_.detail;
    if (now == sent_ || (!is_other_state && now_s - sent_s_ < kNewsEvery_s)) return;
    sent_ = now;
    sent_s_ = now_s;
    link_.bounce.put(std::move(now));
    link_.on_news();
}

} // namespace ghost::app
