#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_ofl: the parsed document, and the steps from it to a Type: entities (values with units),
// physical data, wheels and their gobos, matrix (pixels and their groups), capabilities (functions of a
// channel), modes.

#include "base/byte_reader.h"
#include "base/message_list.h"
#include "base/result.h"
#include "fixture_files/common/gobo_files.h"
#include "fixture_files/common/loaded_type.h"
#include "fixture_files/common/type_builder.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::fixture {

using Json = nlohmann::ordered_json; // the order of pixel groups counts

// A slot that is no picture: metal, or what an iris or a frost would do.
struct OflStop {
    std::string attribute; // "Shutter1", "Iris", "Frost1"; empty: an ordinary slot
    float value = 0.0f;
};

struct OflWheel {
    int index = -1;             // Type::wheels
    std::string prefix;         // "Color#", "Gobo#", "Prism#", "AnimationWheel#", "Iris", "Frost1"
    std::vector<OflStop> stops; // per slot; none on a wheel that presets describe
};

struct OflPhysical {
    LampFacts lamp;
    glm::vec3 size_m{0.0f};
    float weight_kg = 0.0f;
    std::string focus;
    float pan_max_deg = 0.0f; // 0: not stated, or endless
    float tilt_max_deg = 0.0f;
};

struct OflMatrix {
    std::vector<std::string> keys;  // of all pixels: x fastest, then y, then z
    std::vector<glm::ivec3> places; // from 0
    glm::ivec3 count{1};
    std::map<std::string, int> index;                             // key -> pixel
    std::vector<std::pair<std::string, std::vector<int>>> groups; // in the order of the file
};

struct OflReader {
    std::string name; // of the file, for messages
    Json document{};
    MessageList messages{};
    LoadedType loaded{};
    GoboFiles gobos;
    std::filesystem::path resources{};          // the library's folder of that name; empty: there is none
    std::map<std::string, Json> gobo_aliases{}; // by the name of their file
    std::map<std::string, OflWheel> wheels{};
    OflPhysical physical{};
    OflMatrix matrix{};
    std::set<std::string> ignored{};            // capability types without a picture
    std::vector<std::string> generic{};         // channels of which the file does not say what they do
    std::map<std::string, int> preset_wheels{}; // place of the channel -> Type::wheels
    std::set<std::string> described{};          // channels whose losses are listed
    bool quiet = false;

    void say(Severity severity, const std::string& pointer, const std::string& what) {
        if (!quiet) messages.say(severity, name + ": " + pointer, what);
    }
};

// --- reading without surprises: a missing or wrong value is the fallback ---

const Json& member(const Json& object, std::string_view key); // null where there is none
std::string text_at(const Json& object, std::string_view key);
std::optional<float> number_in(const Json& value); // finite, at most 1e9
std::string escaped(std::string_view key);         // for JSON pointers

// --- entities ---

// What the numbers of a capability are: how percentages and words become physical values.
enum class Quantity {
    strobe,      // Hz
    rotation,    // degrees per second, clockwise positive
    share,       // 0..1: brightness, percentages, insertion, iris
    angle,       // degrees
    beam_angle,  // degrees
    temperature, // kelvin
    time,        // seconds
    distance,    // 0 near .. 1 far
    plain,       // a number
};

struct EntityScale {
    float slow =
        0.0f; // rotation, strobe: what 1 % and 100 % mean; angle: degrees of 100 %; beam angle: narrow, wide
    float fast = 1.0f;
    float middle = 0.0f; // temperature: of 0 %
};

std::optional<float> entity(const Json& value, Quantity quantity, const EntityScale& scale);

struct OflRange {
    float from = 0.0f;
    float to = 0.0f;
};
// "speed", or "speedStart" and "speedEnd". Nothing where it is missing; wrong is said.
std::optional<OflRange> entity_range(OflReader& reader, const Json& capability, const std::string& pointer,
                                     const std::string& key, Quantity quantity, const EntityScale& scale);

// --- parts ---

// Within the limits of size, depth and counts that hold for all JSON from outside.
Result<Json> parse_ofl_json(Bytes bytes, const std::string& name);
OflPhysical read_ofl_physical(OflReader& reader, const Json& json, const std::string& pointer);
void read_ofl_wheels(OflReader& reader);
// The picture of a gobo's resource into slot: from the file itself, from beside it, or from the library's
// folder of resources. pointer: of the slot, for messages.
void read_ofl_gobo(OflReader& reader, const Json& resource, const std::string& pointer, Slot& slot);
void read_ofl_matrix(OflReader& reader);
// Pixels of a pixel key or group key; empty where it is neither.
std::vector<int> pixels_of(const OflMatrix& matrix, const std::string& key);
std::vector<std::string> repeat_keys(OflReader& reader, const Json& repeat_for, const std::string& pointer);

// --- channels ---

struct OflChannelSketch {
    int bytes = 1; // resolution of its values
    std::vector<ChannelFunction> functions;
    std::uint32_t initial = 0;
    bool preset = false; // colours that an emitter fixture shows by its emitters
    bool gobo = false;
};

struct OflChannel {
    const Json& json;
    const std::string& key; // wheels may go by it
    const std::string& pointer;
};

// What other channels of the mode do for a strobe.
struct OflStrobes {
    bool rate = false; // one sets the rate of effects that state none
    bool kind = false; // one chooses an effect that states no rate
};

OflChannelSketch sketch_ofl_channel(OflReader& reader, const OflChannel& channel, const OflPhysical& physical,
                                    const OflStrobes& strobes);

void convert_ofl_modes(OflReader& reader);

} // namespace ghost::fixture
