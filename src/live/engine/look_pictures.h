#pragma once
// SPDX-License-Identifier: Apache-2.0
// LookPictures: a small picture of each look of the show as its first camera would see it, every lamp doing
// what the look says and nothing else: one after the other while the picture rests, and again when the looks
// are others. Seconds. Engine thread.

#include "light/rig.h"
#include "link/link.h"
#include "live/session/small_picture.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ghost::app {

class LookPictures {
public:
    explicit LookPictures(ui::Link& link) : link_(link) {}

    // One at most, a second after the one before. stop: something else is to be shown. The session is as it
    // was when this returns.
    void draw(Session& session, double now_s, const std::function<bool()>& stop);
    // The session is another one.
    void forget();

private:
    // In the session that is as the look has it.
    std::optional<image::Image8> drawn(Session& session, const scene::StoredLook& look,
                                       const std::function<bool()>& stop);

    ui::Link& link_;
    ui::LooksNow now_;
    std::unique_ptr<scene::Rig> rig_;
    std::unique_ptr<SmallPicture> small_;
    scene::SceneLook drawn_in_; // air of small_
    std::vector<ui::NamedPicture> pictures_;
    std::size_t next_ = 0; // of the looks
    double made_s_ = -1;
};

} // namespace ghost::app
