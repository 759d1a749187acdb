#pragma once
// SPDX-License-Identifier: Apache-2.0
// Link: all that passes between the window and the engine, which draws on a thread of its own. Requests go
// in, news come out; both are plain values, the newest wins, nobody waits. Metres, degrees, seconds.

#include "base/bounded_queue.h"
#include "base/mailbox.h"
#include "base/signal.h"
#include "diagnose/explain.h"
#include "dmx/receive/statistics.h"
#include "fixture/motion.h"
#include "image/false_colour.h"
#include "image/image.h"
#include "image/tone.h"
#include "link/browsers.h"
#include "link/look.h"
#include "link/news.h"
#include "link/rdm.h"
#include "link/surfaces.h"
#include "show/bounce_detail.h"
#include "show/camera.h"
#include "show_folder/hang.h"
#include "stage/stage.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {
struct Show;
} // namespace ghost::scene

namespace ghost::ui {

enum class Input {
    automatic, // a desk as soon as one is heard, until then the show's recording
    desk,
    recording,
};

// The recording of the show as a person plays it.
struct Transport {
    bool playing = true;
    std::uint64_t seeks = 0; // grows with each jump to at_s
    double at_s = 0;
    double loop_from_s = 0; // played again and again; to at or below from: the whole
    double loop_to_s = 0;

    bool operator==(const Transport&) const = default;
};

struct PictureQuality {
    int fps = 25;    // the picture gets coarser while it moves, to hold this
    int percent = 0; // of the window's pixels; 0: as many as fps allows
    bool operator==(const PictureQuality&) const = default;
};

// What the picture shows: what the camera sees, or a quantity as false colours.
enum class Measure {
    none,
    lux,       // on the surfaces, whatever they are made of
    luminance, // cd/m^2, with haze and glare
};
struct FalseColour {
    Measure measure = Measure::none;
    image::Scale scale;
    bool operator==(const FalseColour&) const = default;
};

// Light to see the stage by where no fixture shines. automatic: as long as the show has no recording and no
// desk was heard.
enum class WorkLight { automatic, on, off };

// The picture as it is, in linear values, into an .exr, or developed into a .png.
struct SaveFrame {
    std::uint64_t number = 0; // grows with every request
    std::string file;
};

// What is met first on the way of a line of sight.
struct Pick {
    std::uint64_t number = 0; // grows with every request; 0: none yet
    glm::vec3 from_m{0};
    glm::vec3 way{0, 1, 0}; // unit vector
    float beside = 0; // tangent of an angle: a set piece so near the way, before what is met there, is met
};

// What the window wants to see, whole.
struct ViewRequest {
    std::uint64_t number = 0;                // grows with every change
    std::string show;                        // path; another one is opened
    std::uint64_t opens = 0;                 // grows when it is to be opened, perhaps once more
    std::shared_ptr<const std::string> text; // of show.toml as it is edited; null: as the file has it
    scene::Camera camera;                    // size: pixels of the window; exposure, too
    glm::ivec2 frame{0}; // of the camera's field of view, all of which is shown whatever the window's shape;
                         // 0: the window itself
    Look look;
    std::shared_ptr<const scene::Show>
        counted; // by whose indices the look goes, that of the text; null: unknown
    bool black_out = false;
    bool frozen = false; // time stands still: nothing turns, strobes or drifts; hands act at once
    std::optional<fixture::Motion> motion; // of heads and movers; nothing: the show's
    float master = 1;
    Input input = Input::automatic;
    Transport transport;
    std::string recording; // that is played; empty: the show's own
    std::string record_to; // what the desk sends is recorded there; empty: it is not
    PictureQuality quality;
    std::optional<std::size_t> explained; // fixture
    std::optional<std::size_t> hovered;   // likewise, one that the mouse rests on
    bool explains_all = false;            // all of them, in short, every few seconds
    image::Tone tone = image::Tone::agx;
    FalseColour false_colour;
    WorkLight work_light = WorkLight::automatic;
    std::optional<glm::vec2> probe; // what is measured there; (0, 0) is the top left corner of the picture
    Pick pick;
    bool wants_camera_pictures = false; // small ones of the show's cameras, while the picture rests
    bool takes_baked = true;            // where the camera stands as one whose passes are fresh
    bool stops_bounce = false;          // the links of bounced light are not made, for they are not there yet
    SaveFrame save_frame;
    std::uint64_t take_plot = 0; // number of the received plot to be merged into the show; 0: none
    RdmAccess rdm = RdmAccess::off;
    std::uint64_t rdm_answered = 0; // RdmEdit
};

// An instance of the stage that can be hidden.
struct Object {
    std::string name;
    std::size_t instance = 0;
    std::size_t material = 0;
    bool shown = true;
    glm::vec3 centre_m{0};
    float radius_m = 1;
    std::optional<scene::Bar> bar; // where it lies, so that things can hang under it
    glm::vec3 half_size_m{0};      // of its upright box about centre_m
    int mover = -1;                // that carries it (show/movers.h); -1: none
    std::string layer;             // of the plot that has it; "": of none
};

struct Opened {
    std::shared_ptr<const scene::Show> show; // without the triangles of its stage
    std::vector<Object> objects;
    std::vector<scene::Material> materials;
    glm::vec3 centre_m{0}; // of the rig
    float radius_m = 10;
    scene::Camera overview; // all of it
    std::string device;
    double recording_s = 0;  // 0: the show has none
    std::uint64_t opens = 0; // of the request that asked for it
    bool is_edit = false;    // the show that was open, edited: camera, look and undo list stay
    std::shared_ptr<const std::string> text; // of show.toml, where the request had one
    bool again = false;                      // a newer version of the show that was open: the camera stays
};

// The show of a request could not be; what was open stays.
struct NotOpened {
    Error error;
    std::uint64_t opens = 0; // of the request
};

// A plot that came from the network (MVR-xchange), to be taken or left.
struct ReceivedPlot {
    std::uint64_t number = 0; // grows
    std::string file;         // where it was saved
    std::string from;         // name of the station
    std::string comment;      // what they wrote about it
};

// A remote control wants the picture from there.
struct CameraCall {
    scene::Camera camera;
    float flight_s = 0; // 0: a cut
};

// Where a frame lies in a picture: in its middle, with that share of its height. Without pixels: the picture
// is its own.
struct Framed {
    glm::ivec2 frame{0};
    float share = 1;
};

struct Picture {
    std::shared_ptr<const image::Image8> image;
    scene::Camera camera; // it was drawn from; its size is that of the image
    Framed framed;        // what of it the frame of the request has
    float ev100 = 0;
    double draw_ms = 0;
    int lights_drawn = 0;
    std::uint64_t device_bytes = 0;  // that stage and pictures have, those that are kept counted in
    bool is_coarse = false;          // drawn with fewer pixels than asked for, because it moves
    std::size_t missing_maps = 0;    // of lights, that are being made
    std::size_t missing_shadows = 0; // lights that shine and throw none until then
    std::size_t left_dark = 0; // heads that would shine at home, and nobody asks (Rig::leave_unasked_dark)
    FalseColour false_colour;  // what the image shows
    bool has_work_light = false;
    bool is_baked = false; // from passes; its size is theirs
    std::string supply;    // in words: which passes, or why it is drawn live
    std::chrono::nanoseconds arrival{
        0}; // steady: of the first packet that changed something since the picture before; 0: none did
};

// A fixture as it shines now.
struct FixtureNow {
    glm::vec3 light_m{0};
    glm::vec3 direction{0, 0, -1};
    glm::mat3 turned{1}; // by what carries it, from where the show hangs it
    glm::vec3 colour{0}; // of its brightest beam, largest component 1; black: dark
    float candela = 0;   // on the axis, all beams together
    float pan_deg = 0;
    float tilt_deg = 0;
    float dimmer = 0; // of the brightest beam, shutter included
    float zoom_deg = 0;
    std::optional<int> gobo;            // slot of the first wheel; nothing: it has none, or it turns
    fixture::Programmer asked;          // what desk or recording ask for, as values that a hand could set
    bool is_dark_without_hands = false; // as long as none asks for its light (Rig::leave_unasked_dark)
};

// Values of the axes of a mover, metres or degrees.
struct MoverNow {
    std::vector<float> values; // where it is
    std::vector<float> goals;  // where it goes, between its end stops
    std::vector<float> asked;  // likewise, if no hand held it
};

// What a remote control (OSC, a browser) asks for beside the request of the window, until it lets go of it or
// another show is opened.
struct RemoteNow {
    float master = 1; // times that of the window
    bool black_out = false;
    float haze = 1;                  // times the show's density
    std::optional<float> ev100;      // instead of the camera's
    std::optional<image::Tone> tone; // instead of the one that was chosen
};

struct RigNow {
    std::vector<FixtureNow> fixtures;
    dmx::Universes universes;
    bool from_desk = false;
    double at_s = 0;         // of the recording
    std::uint64_t seeks = 0; // of the transport: the newest jump that at_s knows of
    double recording_s = 0;  // its length; 0: there is none
    double recorded_s = -1;  // of the recording that is made; below 0: none is
    std::string timecode;    // what is to be said of the time code that is followed; "": nothing
    std::vector<MoverNow> movers;
    RemoteNow remote;
};

struct Explained {
    std::size_t fixture = 0; // of the show that is drawn
    scene::Explanation explanation;
    std::string words;
};

// Why a fixture shines or does not, in short.
struct Verdict {
    scene::Visibility visibility = scene::Visibility::lit;
    scene::Cause cause = scene::Cause::none;
    std::string group; // the reason, in words that are the same for all fixtures with that trouble
};

// Light that bounces in the picture.
struct BounceNow {
    enum class State { off, makes_links, stopped, failed, bounces };
    State state = State::off;
    scene::BounceDetail detail = scene::BounceDetail::off;
    bool is_of_command_line = false; // whatever the show says
    double made_share = 0;           // of the links
    std::optional<double> left_s;    // until they are made; nothing: not known yet
    double solve_ms = 0;             // of the last solution, on a thread of its own
    double draw_ms = 0;              // of the last picture
    bool operator==(const BounceNow&) const = default;
};

// The camera, at rest, sees nothing of the stage.
struct UnseenStage {
    bool is_so = false;
    std::string body; // that is before all of it; empty: nothing is in the picture
    bool operator==(const UnseenStage&) const = default;
};

// What the probe meets.
struct Probed {
    glm::vec2 place{0}; // as in the request
    float cd_m2 = 0;    // that the camera sees there
    bool hit = false;   // a surface; what follows is of it
    float lux = 0;
    std::optional<float> bounced_lux; // of them; nothing: no light bounces
    glm::vec3 at_m{0};
    float distance_m = 0; // from the camera
    std::string object;
};

struct Picked {
    std::uint64_t number = 0; // of the request
    bool hit = false;         // a surface; what follows is of it
    glm::vec3 at_m{0};
    std::optional<std::size_t> fixture; // whose body it is
    std::string object;
};

// A recording that was made, or could not be.
struct Recorded {
    std::string file;
    double seconds = 0;
    std::optional<Error> error;
};

struct Saved {
    std::uint64_t number = 0; // of the request
    std::optional<Error> error;
};

struct Link {
    Mailbox<ViewRequest> request;
    Signal wake; // of the engine: after a request was put

    News<Opened> opened;
    Mailbox<NotOpened> not_opened;
    Mailbox<Error> failed; // something else that the window asked for
    News<Picture> picture;
    News<RigNow, Late::waits> rig;
    News<dmx::Statistics> network;
    Mailbox<Explained> explained;
    Mailbox<Explained> hovered;
    Mailbox<std::vector<Verdict>> verdicts; // of all fixtures, where the request wants them
    News<std::vector<Message>> messages;    // all of the show that is open
    // Number of the request whose picture is there, at rest: nothing moves, all pixels, all shadows.
    Mailbox<std::uint64_t> settled;
    Mailbox<std::string> activity; // what takes long now; empty: nothing
    Mailbox<ReceivedPlot> plot;
    // How much changes in equal parts of the recording: 0 nothing .. 1 most. Comes some time after the show.
    Mailbox<std::vector<float>> activity_of_recording;
    Mailbox<BounceNow> bounce;
    Mailbox<UnseenStage> unseen_stage;
    Mailbox<Probed> probed;
    Mailbox<Picked> picked;
    Mailbox<Saved> saved;
    Mailbox<Recorded> recorded;
    Mailbox<CameraCall> camera_call;
    News<std::vector<NamedPicture>> camera_pictures; // all there are
    Mailbox<LookCall> look_call;
    Mailbox<std::string> cue_call; // by a remote control, which has called its camera and its look, too
    Mailbox<RdmNow> rdm;
    BoundedQueue<RdmEdit, kMostRdmEdits> rdm_edits;

    // Of the second reader of the news: browsers.
    Mailbox<std::size_t> question; // the fixture that is to be explained, once
    Mailbox<Explained> answer;
    BoundedQueue<Command, kMostCommands> commands;
    BoundedQueue<CommandAnswer, kMostCommands> command_answers;
    std::atomic<bool> wants_small_pictures{false}; // of cameras and looks, for browsers
    News<LooksNow> looks;                          // of whoever keeps them: to the engine and to browsers
    News<std::string> cue; // likewise: name of the one that was called last; "": none was
    News<std::vector<NamedPicture>> look_pictures;   // all there are; for browsers alone
    Mailbox<std::vector<SideView>> side_views;       // that are wanted from now on
    Mailbox<std::vector<SidePicture>> side_pictures; // of them, all there are

    // The engine calls it after it put something, on its own thread. Set before the engine starts.
    std::function<void()> on_news;

    // Pictures that the graphics device shows itself (link/surfaces.h).
    Mailbox<SurfaceOffer> surface_offer;
    Mailbox<std::vector<Surface>> surfaces; // all there are, after each change
    Mailbox<ShowerNow> shower;
};

} // namespace ghost::ui
