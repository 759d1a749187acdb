#pragma once
// SPDX-License-Identifier: Apache-2.0
// LiveControls: what moves a picture besides DMX: remote controls (OSC, browsers) and trackers
// (PosiStageNet). All are heard before the rig's step: the haze that is asked for goes into the session,
// heads and objects follow. Light, cameras, looks, exposure and tone are of whoever draws. The thread that
// draws. Errors: ports that are taken.

#include "link/browsers.h"
#include "live/engine/followers.h"
#include "live/inputs/remote_input.h"
#include "live/inputs/tracker_input.h"
#include "live/session/session.h"

#include <memory>
#include <string>

namespace ghost::app {

struct LiveControlOptions {
    std::string osc;  // "9000", "0.0.0.0:9000"; empty: none
    bool psn = false; // what the show's [[tracker]] entries follow
};

Result<void> check_live_controls(const LiveControlOptions& options);

// What a remote control has asked for since it was heard the last time.
struct RemoteNews {
    bool camera = false; // the same one, perhaps
    bool jump = false;
    bool haze = false; // a live picture has it from the next look_from on
    bool look = false; // the same one, perhaps
    bool cue = false;  // likewise
};

class LiveControls {
public:
    // osc: as LiveControlOptions has it.
    Result<void> open_remote(const std::string& osc, const scene::Show& show);
    // Of browsers, from the next hear_remote on. Error: none of ours, as Remote::apply says it.
    Result<void> command(const ui::Command& command);
    // interface: where they are heard, as ReceiverOptions has it.
    Result<void> open_trackers(const std::string& interface);
    bool has_remote() const { return remote_input_ != nullptr; }
    bool has_trackers() const { return trackers_ != nullptr; }

    // Another session: what follows starts anew. Faders stay where they are, but for another show.
    enum class Of { the_same_show, another_show };
    void begin(Session& session, Of of);
    // The cue that was called last, by whoever keeps their list; "": none.
    void be_in(const std::string& cue) { remote_.be_in(cue); }
    // Its show has other cameras or cues.
    void know(Session& session);

    RemoteNews hear_remote(Session& session, double now_s);
    const dmx::Trackers* hear_trackers(Session& session); // null: they are not listened to
    // The same with what was heard, for tests.
    RemoteNews take(const RemoteRequest& request, Session& session);
    void take(const dmx::Trackers& trackers, Session& session) { followers_.apply(session, trackers); }

    // What the remote control asks for.
    const RemoteRequest& remote() const { return request_; }

private:
    bool is_heard() const { return remote_input_ || was_commanded_; }

    Remote remote_{{}};
    bool was_commanded_ = false;                // by a browser, ever
    std::unique_ptr<RemoteInput> remote_input_; // or null
    std::unique_ptr<TrackerInput> trackers_;    // or null
    Followers followers_;
    RemoteRequest request_;
};

} // namespace ghost::app
