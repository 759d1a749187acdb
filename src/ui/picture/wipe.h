#pragma once
// SPDX-License-Identifier: Apache-2.0
// Wipe: a picture that was kept, left of an upright line, over the one that is shown, right of it: two looks,
// or the desk and a look, side by side in one frame. Pixels of the widget; window thread.

#include "link/link.h"

#include <QPainter>

#include <optional>

namespace ghost::ui {

class Wipe {
public:
    bool is_on() const { return before_.has_value(); }
    // Needs a picture with an image.
    void keep(const Picture& picture) { before_ = picture; }
    void end() { before_.reset(); }

    // Where the line is, as a share of the widget's width; held between 0 and 1.
    double share() const { return share_; }
    void set_share(double share);
    // Near enough to take hold of it.
    bool is_near(const QSizeF& widget, double x) const;
    // Nothing while it is off.
    void paint(QPainter& painter, const QSizeF& widget) const;

private:
    std::optional<Picture> before_;
    double share_ = 0.5;
};

} // namespace ghost::ui
