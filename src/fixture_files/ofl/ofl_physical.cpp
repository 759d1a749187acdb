// SPDX-License-Identifier: Apache-2.0
// Physical data.
#include "fixture_files/ofl/private/ofl_reader.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

float positive(OflReader& reader, const Json& object, const std::string& pointer, const char* key,
               float most) {
    const Json& value = member(object, key);
    if (value.is_null()) return 0.0f;
    const std::optional<float> number = number_in(value);
    if (number && *number >= 0.0f && *number <= most) return *number;
    if (value != Json("infinite"))
        reader.say(Severity::warning, pointer + "/" + key,
                   "expected a number from 0, taking it as not stated");
    return 0.0f;
}
} // namespace

OflPhysical read_ofl_physical(OflReader& reader, const Json& json, const std::string& pointer) {
    OflPhysical physical;
    const Json& size = member(json, "dimensions");
    if (size.is_array() && size.size() == 3) {
        glm::vec3 millimetres(0.0f); // width, height, depth
        bool sound = true;
        for (int k = 0; k < 3; ++k) {
            const float stated = number_in(size[static_cast<std::size_t>(k)]).value_or(-1.0f);
            millimetres[k] = std::clamp(stated, 0.0f, 1e5f);
            sound = sound && millimetres[k] == stated;
        }
        if (!sound)
            reader.say(Severity::warning, pointer + "/dimensions",
                       "expected numbers from 0 to 100000 mm, taking the nearest");
        physical.size_m = glm::vec3(millimetres.x, millimetres.z, millimetres.y) / 1000.0f;
    } else if (!size.is_null()) {
        reader.say(Severity::warning, pointer + "/dimensions", "expected width, height and depth in mm");
    }
    physical.weight_kg = positive(reader, json, pointer, "weight", 1e5f);
    physical.lamp.power_w = positive(reader, json, pointer, "power", 1e6f);
    const Json& bulb = member(json, "bulb");
    physical.lamp.bulb = text_at(bulb, "type");
    physical.lamp.lumens = positive(reader, bulb, pointer + "/bulb", "lumens", 1e7f);
    physical.lamp.color_temperature_k = positive(reader, bulb, pointer + "/bulb", "colorTemperature", 1e5f);
    const Json& lens = member(json, "lens");
    physical.lamp.lens = text_at(lens, "name");
    const Json& degrees = member(lens, "degreesMinMax");
    if (degrees.is_array() && degrees.size() == 2) {
        const float least = number_in(degrees[0]).value_or(-1.0f),
                    most = number_in(degrees[1]).value_or(-1.0f);
        physical.lamp.degrees_min = std::clamp(std::min(least, most), 0.0f, 180.0f);
        physical.lamp.degrees_max = std::clamp(std::max(least, most), 0.0f, 180.0f);
        if (physical.lamp.degrees_min != least || physical.lamp.degrees_max != most)
            reader.say(
                Severity::warning, pointer + "/lens/degreesMinMax",
                "expected two angles from 0 to 180 degrees, the smaller one first; taking the nearest");
    }
    const Json& focus = member(json, "focus");
    physical.focus = text_at(focus, "type");
    physical.pan_max_deg = positive(reader, focus, pointer + "/focus", "panMax", 36000.0f);
    physical.tilt_max_deg = positive(reader, focus, pointer + "/focus", "tiltMax", 36000.0f);
    return physical;
}
} // namespace ghost::fixture
