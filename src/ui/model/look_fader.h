#pragma once
// SPDX-License-Identifier: Apache-2.0
// LookFader: a look on its way to the one that is meant, by the clock (ui/model/look_fade.h). Window thread.

#include "link/link.h"

#include <QElapsedTimer>
#include <QTimer>

#include <functional>

namespace ghost::ui {

class LookFader {
public:
    // step: on_the_way is another one now.
    explicit LookFader(std::function<void()> step);

    // What is meant changes next, in so many seconds and not at once.
    void set_next(double seconds);
    // What was meant before becomes what is meant after: the fade begins, or what hands changed is at its
    // end.
    void change(const Look& before, const Look& after);
    // What is meant already is to be there in so many seconds from now, where that is sooner.
    void hurry(double seconds);
    // What is meant counts fixtures otherwise now, or belongs to another show.
    void forget();
    bool is_going() const { return timer_.isActive(); }
    // Where it is now.
    const Look& on_the_way(const Look& meant, const scene::Show* show, const RigNow& now);

private:
    Look from_, shown_;
    double next_s_ = 0, length_s_ = 0;
    QTimer timer_;
    QElapsedTimer clock_;
};

} // namespace ghost::ui
