#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_qxf: the definition as it stands in the file, and the steps from it to a Type: words (what
// a name means), channels (functions of one byte), modes (bytes joined, heads, axes, switching channels).

#include "base/message_list.h"
#include "fixture_files/common/gobo_files.h"
#include "fixture_files/common/loaded_type.h"
#include "fixture_files/common/type_builder.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::fixture {

struct QxfAlias { // while the capability is chosen, 'channel' of 'mode' does what 'with' says
    std::string mode;
    std::string channel;
    std::string with;
};

struct QxfCapability {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::string name;
    std::string words; // the name in lower case
    std::string preset;
    std::string resource;
    std::string resource2;
    std::vector<QxfAlias> aliases;
    std::size_t line = 0;
};

struct QxfChannel {
    std::string name;
    std::string words;
    std::string preset;
    std::string group;
    std::string colour;
    bool fine = false;
    int initial = -1; // -1: not said
    std::vector<QxfCapability> capabilities;
    std::size_t line = 0;
};

struct QxfPhysical {
    LampFacts lamp;
    glm::vec3 size_m{0.0f};
    float weight_kg = 0.0f;
    std::string focus;
    float pan_max_deg = 0.0f;
    float tilt_max_deg = 0.0f;
    glm::ivec2 layout{1, 1};
};

struct QxfHead {
    std::vector<int> numbers; // of the mode's channels
};

struct QxfModeChannel {
    int channel = -1; // QxfReader::channels; -1: a gap
    int acts_on = -1;
};

struct QxfMode {
    std::string name;
    std::vector<QxfModeChannel> channels;
    std::vector<QxfHead> heads;
    std::optional<QxfPhysical> physical;
    std::size_t line = 0;
};

// What a channel is about.
enum class Subject {
    nothing, // no picture shows it
    unknown, // it may well be seen, but nobody knows how
    fixed,   // one attribute over the whole range: Sketch::attribute
    dimmer,
    shutter,
    colour,
    temperature,
    gobo,
    gobo_turn,
    prism,
    prism_turn,
    iris,
    zoom,
    focus,
    frost,
    pan_turn,
    tilt_turn,
    time,
    fog,
};

// The functions of a channel of one byte. Wheels are numbered in a mode: '#' stands for the number.
struct Sketch {
    Subject subject = Subject::nothing;
    std::vector<ChannelFunction> functions;
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        plain;          // colour: ranges without a colour of their own
    bool slots = false; // colour, gobo, prism: it chooses pictures
};

struct QxfReader {
    std::string name;         // of the file, for messages
    std::string fixture_kind; // "Moving Head", "Smoke", ...
    MessageList messages{};
    LoadedType loaded{};
    std::vector<QxfChannel> channels{};
    std::map<std::string, int> channel_names{};
    std::vector<QxfMode> modes{};
    QxfPhysical physical{};
    GoboFiles gobos;
    std::map<int, int> wheels{}; // channel -> Type::wheels
    std::set<int> described{};   // channels whose losses are listed
    bool quiet = false;

    void say(Severity severity, std::size_t line, const std::string& what) {
        if (!quiet) messages.say(severity, name + ":" + std::to_string(line), what);
    }
};

// --- words ---

struct Range {
    float from = 0.0f;
    float to = 0.0f;
};

bool has_word(std::string_view text, std::initializer_list<const char*> words); // any of them, anywhere
bool falls(const std::string& words); // "fast to slow", "100-0%", "wide -> narrow"
Range graded(const std::string& words, float slow, float fast);
// The numbers before a unit: "1-20 Hz" is 1 and 20. At most two.
std::vector<float> numbers_before(const std::string& words, std::initializer_list<const char*> units);
// +1 clockwise, -1 counter-clockwise, 0: nothing said.
int turning(const std::string& words);
bool stops(const std::string& words);
// The number of a gobo: 3 of "gobo 3", "rot. gobo 3 shaking", "gobo shake 3", and of a bare "3".
std::optional<int> gobo_number(const std::string& words);
// The two numbers of "frost from 0-100", which have no unit; nothing else.
std::optional<Range> bare_range(const std::string& words);
std::optional<Subject> subject_of_words(const QxfChannel& channel);

// A preset of a channel: attribute, physical range.
struct ChannelPreset {
    std::string_view name;
    Subject subject;
    std::string_view attribute;
    float from;
    float to;
};
const ChannelPreset* find_preset(std::string_view name); // the fine ones too: with their coarse one's values
bool is_fine_preset(std::string_view name);

// --- channels ---

Sketch sketch_channel(QxfReader& reader, int channel, const QxfPhysical& physical);

// --- modes ---

void convert_modes(QxfReader& reader);

} // namespace ghost::fixture
