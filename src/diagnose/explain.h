#pragma once
// SPDX-License-Identifier: Apache-2.0
// Explainer: why a fixture of a rig shines or does not: the chain from the packet to what the beam hits, as
// plain data. Words and JSON (explain_print.h) are two printers of it. How much of the light each part lets
// through is measured on the light that is drawn (light_from), one part at a time. Metres, Z up, lumens, lux
// without haze, degrees. Pure; refers to its input, which must outlive it. What DMX channel means what: GDTF
// (DIN SPEC 15800).

#include "base/report.h"
#include "diagnose/diagnosis.h"
#include "light/rig.h"
#include "stage/stage.h"

#include <array>
#include <functional>
#include <optional>

namespace ghost::scene {

// Why there is no light, in the order in which one would look.
enum class Cause {
    none,
    no_type,        // the fixture's file cannot be read
    no_mode,        // the mode does not exist, another one is taken
    no_place,       // nobody says where it hangs, or how it is turned
    no_address,     // it is written, and cannot be read
    not_patched,    // no address
    no_input,       // neither a recording nor a desk
    unasked,        // no hand either, and the rig leaves such heads dark
    never_received, // no packet of the universe
    lost,           // nobody sends the universe any more; its last look is held
    not_sent,       // the universe comes with fewer channels
    overridden,     // a source of higher priority sends something else
    two_desks,      // sources of equal priority send different things
    same_address,   // another fixture has the address
    overlap,        // a fixture begins inside of another one: a mode of the wrong length
    dimmer,
    shutter,
    strobe,
    iris,
    blades,    // framing shutters
    colour,    // flags or colour wheels
    gobo,      // gobo wheels
    animation, // the animation wheel
    picture,   // what a projector shows
    zoom,      // no angle that a beam has
    emitters,  // colours of an LED
    lamp,      // off, or a lamp of 0 lumens
    no_beam,   // no geometry that shines
    several,   // no part alone
    hidden,    // inside of an object, or right behind one
    away,      // hits nothing
    faint,     // next to the brightest fixture
};
const char* cause_name(Cause cause); // "same_address"

enum class Visibility { lit, unseen, nearly_dark, dark };
const char* visibility_name(Visibility visibility); // "nearly_dark"

struct Reason {
    Cause cause = Cause::none;
    bool blocks = false;       // it is why there is no light; else only worth knowing
    std::string text;          // "the shutter function 'Closed' (DMX 3-5) is active on channel 11 (1.055)"
    std::string group;         // the same for all fixtures with that trouble: "the shutter is closed"
    std::vector<int> channels; // ChannelFacts that are to blame
    float fraction = 0;        // of the light that passes all the same, where it is a part of the beam
};

// How levels came here.
struct Reception {
    enum class Kind { none, recording, desk } kind = Kind::none;
    std::string recording; // file
    double at_s = 0;
    double end_s = 0;
    std::vector<std::pair<int, double>> first_frames_s; // of every universe of the recording
    double listened_s = 0;
    std::vector<dmx::SourceStatus> sources; // with slots
    std::uint64_t packets = 0, preview = 0, unlisted = 0, not_understood = 0;
    bool artnet_ltp = false;         // of two Art-Net sources the one that changed a slot last has it
    std::vector<Sentence> diagnosis; // of a desk: what is wrong between it and the patch
};
Reception reception_of(const dmx::Statistics& statistics, const PatchMap& patch, double listened_s);

struct UniverseFacts {
    int universe = 0;
    bool received = false;
    bool lost = false;
    bool black = false;       // lost, and its look was taken away
    int slot_count = 0;       // that it comes with
    int most_slots = 0;       // in some packets of late
    double age_s = 0;         // of the newest packet or frame
    double first_frame_s = 0; // of a recording; below 0: it has none
    struct Sender {
        std::string protocol, name, from; // name: sACN; Art-Net: its address
        int priority = 0;
        bool per_address_priority = false;
        double rate_hz = 0, age_s = 0;
        int channels_held = 0; // of this fixture
        int channels = 0;      // of this fixture, sent at all
    };
    std::vector<Sender> senders;
};

struct ChannelFacts {
    int number = 0; // 1-based place in the break, of the coarse byte; 0: virtual
    int dmx_break = 1;
    std::string numbers;                  // "2-3"
    std::string addresses;                // "1.46-1.47"; "" where there is none
    std::vector<fixture::Address> places; // of each byte
    std::string name;                     // of the geometry and attribute: "Head_Tilt"
    fixture::ChannelReading reading;
    std::string value;                           // "128.0" coarse.fine
    std::string attribute, function, set, range; // range: DMX of set or function, "0-7"
    std::string why;                             // of the choice
    std::string meaning;                         // "100 %", "1.05 deg", "slot 3 'Blue'"
    std::string unit; // of reading.physical: "share", "deg", "Hz", ...; "" where it has none
    int slot = 0;     // of a wheel, 1-based; 0: none
    fixture::Role role = fixture::Role::none;
};

struct WheelFacts {
    bool colour = false;
    int number = 1;
    std::string name;
    float position = 0;     // slots, 0-based; 2.5 is half of the third and half of the fourth
    std::string slot, next; // next: the other slot in the gate, or ""
    bool spinning = false;
    float fraction = 1; // of the light that passes
};

struct HitFacts {
    std::string object;
    float distance_m = 0; // from the lens; below 0: between the head's pivot and the lens
    glm::vec3 position_m{0};
    float facing_lx = 0;             // on something that faces the lamp
    float illuminance_lx = 0;        // on the surface as it lies
    std::optional<float> bounced_lx; // beside that, of all lights; nothing: no light bounces
    bool lens_inside = false;        // of that object
};

// One beam; the parts are fractions of light, each of what the parts before it leave (of an open beam, where
// those leave nothing): asked * lamp * dimmer * master * shutter * strobe * mix * emitters * correction *
// colour * picture * animation * gobo * iris * blades * rest = output_lm / full_lm.
struct BeamFacts {
    std::string name;
    bool glows = false; // lights nothing, is only seen (BeamType None, Glow)
    int grouped = 1;    // beams that are drawn as one light with it, itself included
    float full_lm = 0;  // all open
    float output_lm = 0;
    float asked = 1;  // 0: nobody asks for it, and it is left dark
    float lamp = 1;   // off, on, or on its way
    float dimmer = 1; // the nearest to the beam
    float master = 1; // all dimmers above it
    float shutter = 1;
    float strobe = 1; // at this moment
    float strobe_hz = 0;
    float mix = 1; // HSB, CIE, RGB, colour macro
    float emitters = 1;
    float correction = 1; // CTO, CTC, CTB, tint
    float colour = 1;     // flags and wheels
    float picture = 1;    // what a projector shows, of a white panel
    float animation = 1;  // the animation wheel
    float gobo = 1;
    float iris = 1;
    float blades = 1;
    float rest = 1;                  // what else there is
    std::vector<std::string> optics; // what else is in the light: prisms, frost, blades ..., in words
    bool projects = false;
    std::string medium;                // what it projects
    float axis_cd = 0;                 // in the middle of what is lit
    float beam_deg = 0, field_deg = 0; // full angles, 50 % and 10 %, iris and frost included
    glm::vec2 lit_deg{0};              // across and up: of the field, what blades leave of it, the picture
    bool is_cut = false;               // by blades
    std::vector<WheelFacts> wheels;
    glm::vec3 lens_m{0};
    glm::vec3 direction{0, 0, -1};
    std::optional<HitFacts> hit; // along the middle of what is lit
    std::string edge_object;     // what the rest of the beam meets where the middle meets nothing
    std::vector<Reason> findings;
};

struct Explanation {
    std::string fixture;
    Visibility visibility = Visibility::dark;
    Cause cause = Cause::none;
    std::string verdict;          // "dark because ..."
    std::vector<Reason> findings; // the first one that blocks is the verdict
    std::string file, maker, type, mode;
    // False: what stands there has been put in the place of what nobody says (PatchedFixture).
    bool is_mode_known = true, is_place_known = true, is_rotation_known = true, is_address_known = true;
    std::vector<fixture::Address> addresses; // per break; channel 0: none
    std::vector<int> footprint;              // bytes per break
    std::vector<UniverseFacts> universes;
    std::vector<ChannelFacts> channels;
    std::vector<BeamFacts> beams;
    int main_beam = -1; // the brightest, or the one asked about; the words are about it
    bool asked_beam = false;
    bool looked = false; // the stage was there to be hit

    bool is_aim_known() const { return is_place_known && is_rotation_known; }
};

struct HazeMedium;

struct ExplainInput {
    const Show& show;
    const Report& report; // of load_show
    Rig& rig;             // stepped with these universes; its lights are asked for
    const GoboStack& gobos;
    const dmx::Universes& universes;
    const Reception& reception;
    double now_s = 0;                 // the clock of Universe::arrival
    const HazeMedium* haze = nullptr; // what hangs in the air now; null: the show's

    struct Seen {
        int instance = kNone;
        float distance_m = 0;
        glm::vec3 normal{0};
    };
    const Stage* stage = nullptr; // null: what beams hit is not known
    std::function<Seen(const glm::vec3& origin, const glm::vec3& direction)> first_hit;
    // Null: no light bounces.
    std::function<float(const glm::vec3& place_m, const glm::vec3& normal)> bounced_lx;
};

class Explainer {
public:
    explicit Explainer(const ExplainInput& input);
    // beam: the one that it is about; below 0: the brightest.
    Explanation explain(std::size_t fixture, int beam = -1) const;

private:
    const ExplainInput& input_;
    fixture::Levels levels_;
    std::vector<LensFace> faces_;
    std::vector<std::size_t> first_face_; // per fixture, and one past the end
    std::vector<fixture::Patch> patches_; // of fixtures with a type; type null else
    std::vector<fixture::Overlap> overlaps_;
    float brightest_lm_ = 0, brightest_cd_ = 0;
};

// "12 of 40 dark: 8 because universe 3 never arrived, 4 because the dimmer is at 0; 2 not seen: ...".
std::string summary_of(const std::vector<Explanation>& explanations);

} // namespace ghost::scene
