#pragma once
// SPDX-License-Identifier: Apache-2.0
// Remote: what a remote control asks of a live picture, by the OSC addresses of docs/reference/inputs.md.
// Knows no socket and no picture: messages in, a request out. It changes what is seen, never a file.

#include "base/result.h"
#include "image/tone.h"
#include "psn_osc/osc.h"
#include "show/cues.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::app {

inline constexpr float kThickestHaze = 20.0f; // times the show's
inline constexpr float kLongestFlight_s = 60.0f;

struct RemoteCamera {
    std::size_t index = 0; // of the show's cameras
    float flight_s = 0;    // 0: a cut
};

struct RemoteLook {
    std::string name;
    double seconds = -1; // of the fade; below 0: those of the look
};

struct RemoteRequest {
    float master = 1; // 0..1, of all lamps
    bool blackout = false;
    float haze = 1;                     // times the show's density
    std::optional<float> ev100;         // instead of the camera's exposure
    std::optional<image::Tone> tone;    // instead of the one that was chosen
    std::optional<RemoteCamera> camera; // the last one asked for
    std::size_t calls = 0;              // of cameras: the same one may be asked for again
    double at_s = 0;                    // of the recording: the last place asked for
    std::size_t jumps = 0;              // to such places
    RemoteLook look;         // the last one asked for; whoever keeps the looks knows whether it is one
    std::size_t recalls = 0; // of looks
    std::string cue;         // the last one asked for
    std::size_t cues = 0;    // asked for

    float light() const { return blackout ? 0.0f : master; }
};

class Remote {
public:
    // cameras: names, in the order of the show.
    explicit Remote(std::vector<std::string> cameras, std::vector<scene::Cue> cues = {})
        : cameras_(std::move(cameras)), cues_(std::move(cues)) {}

    // Error: an address that is none of ours, or a value that it does not take; the request stays as it was.
    Result<void> apply(const dmx::OscMessage& message);
    // The same without "/ghostlight/" before it; where: of the error.
    Result<void> apply(std::string_view what, const std::vector<dmx::OscArgument>& arguments,
                       const std::string& where);
    const RemoteRequest& request() const { return request_; }
    // The cue that the show is in, whoever called it: "go" is the one behind it. "": none.
    void be_in(const std::string& cue);
    // The same show has others now: it is in the cue of that name still, and the request stays.
    void know(std::vector<std::string> cameras, std::vector<scene::Cue> cues);
    // Those of another show, which is in no cue; nothing is held of its light, exposure and tone.
    void begin(std::vector<std::string> cameras, std::vector<scene::Cue> cues);

private:
    struct Asked;
    Result<void> recall_camera(const Asked& asked);
    Result<void> recall_look(const Asked& asked);
    Result<void> call_cue(const Asked& asked, int steps);

    std::vector<std::string> cameras_;
    std::vector<scene::Cue> cues_;
    std::string in_;                 // name of the cue that was called last, which may be of a show to come
    std::optional<std::size_t> cue_; // its place; where it has none, that of the one before it
    RemoteRequest request_;
};

} // namespace ghost::app
