#pragma once
// SPDX-License-Identifier: Apache-2.0
// AppliedLook: puts the part of a look that is not about fixtures onto a session, and takes it off again:
// air, even light, attenuation, shadows, objects, surfaces. Engine thread; one for each session.

#include "link/link.h"
#include "live/session/session.h"

namespace ghost::app {

// What can be hidden and changed by hand, for the window.
ui::Opened opened_from(const Session& session);

class AppliedLook {
public:
    // The session as it was opened: what an empty look means.
    explicit AppliedLook(const Session& session);

    // True: Session::look_from has to follow, for the camera sees something else now. A look's indices that
    // the session does not have are left out.
    bool apply(const ui::Look& look, Session& session);
    // The show has the haze and the hazers of that one now. True: they are others, and look_from has to
    // follow the next apply.
    bool take_air(const scene::Show& edited, Session& session);
    // Takes what looks changed off a copy of the session's show.
    void take_off(scene::Show& show) const;

private:
    bool apply_scene(const ui::SceneLook& look, Session& session);
    bool apply_objects(const ui::Look& look, Session& session);
    bool apply_surfaces(const ui::Look& look, Session& session);

    scene::HazeMedium haze_;
    scene::Attenuation attenuation_;
    float ambient_lux_;
    glm::vec3 ambient_colour_;
    bool shadows_;
    ui::Look applied_;
    bool is_stale_ = false; // the air is another one than that which applied_ was applied to
};

} // namespace ghost::app
