#pragma once
// SPDX-License-Identifier: Apache-2.0
// AppliedLook: puts the part of a look that is not about fixtures onto a session, and takes it off again:
// air, even light, attenuation, shadows, objects, surfaces. Engine thread; one for each session.

#include "link/link.h"
#include "live/session/session.h"

namespace ghost::app {

// What can be hidden and changed by hand, for the window.
ui::Opened opened_from(const Session& session);

// The look that goes by the indices of one show, by those of another one (link/carried.h), where heads that
// it does not know are dark beside those that shine alone. Of objects and materials, which a show has no list
// of, the indices stay.
ui::Look counted_as(const scene::Show& show, const ui::Look& look, const scene::Show& counted);

// The session's show has the haze, the hazers and the bounced light of that one now. True: the air is
// another, and look_from has to follow.
bool take_air(const scene::Show& edited, Session& session);

class AppliedLook {
public:
    // The session as it was opened: what an empty look means.
    explicit AppliedLook(const Session& session);

    // True: Session::look_from has to follow, for the camera sees something else now. A look's indices that
    // the session does not have are left out.
    bool apply(const ui::Look& look, Session& session);

private:
    bool apply_scene(const ui::SceneLook& look, Session& session);
    bool apply_objects(const ui::Look& look, Session& session);
    bool apply_surfaces(const ui::Look& look, Session& session);

    bool shadows_;
    ui::Look applied_;
};

} // namespace ghost::app
