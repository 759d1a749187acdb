#pragma once
// SPDX-License-Identifier: Apache-2.0
// BakedSupply: where the camera stands as one of the show whose passes are fresh, these are shown instead of
// the live picture; else it knows why not. Reads passes in the background. Engine thread; refers to the
// session until forget().

#include "live/session/baked_view.h"
#include "live/session/session.h"

#include <future>
#include <memory>
#include <string>

namespace ghost::app {

class BakedSupply {
public:
    ~BakedSupply() { forget(); }

    struct Wanted {
        const scene::Camera& camera; // of the window, as wide as its frame asks for
        float fov_y_deg;             // without that
        const std::shared_ptr<const std::string>&
            text;               // of the show, where it may be another than the file's
        std::string needs_live; // why nothing baked will do; empty: it will
    };
    // Whether view() is to be shown.
    bool choose(const Session& session, const Wanted& wanted, double now_s);
    // Of the camera that it was chosen for last.
    BakedView& view() { return *view_; }
    const BakedView& view() const { return *view_; }
    // What is shown, for a person: "live: a free camera".
    const std::string& words() const { return words_; }
    bool is_reading() const { return reading_.valid(); }
    // The session goes or is another one; waits for what is being read.
    void forget();

private:
    void look(const Session& session, const scene::Camera& stands, const Wanted& wanted);
    void take(const Session& session);

    std::future<BakedPasses> reading_;
    std::unique_ptr<BakedView> view_;
    std::string camera_, stamp_; // its name, and which bake of it
    std::string why_not_, words_;
    double looked_s_ = 0;
    bool is_unsaved_ = false;
};

} // namespace ghost::app
