#pragma once
// SPDX-License-Identifier: Apache-2.0
// Small Open Fixture Library fixtures for tests, and what they do with given bytes.

#include "fixture/decode.h"
#include "fixture_files/ofl/ofl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ghost::fixture {

inline Result<LoadedType> load(const std::string& text) {
    return load_ofl(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), "thing.json");
}

inline LoadedType loaded(const std::string& text) {
    Result<LoadedType> result = load(text);
    EXPECT_TRUE(result.ok()) << result.error().text();
    return result.ok() ? std::move(*result) : LoadedType{};
}

// Members of the fixture beside its name and categories.
inline std::string fixture(const std::string& members, const std::string& category = "Moving Head") {
    return R"json({"$schema": "https://raw.githubusercontent.com/OpenLightingProject/open-fixture-library/master/schemas/fixture.json",
"name": "Thing", "shortName": "T", "categories": [")json" +
           category + R"json("], "meta": {"authors": ["a"]}, )json" + members + "}";
}

inline const std::string kPhysical =
    R"json("physical": {"dimensions": [300, 400, 280], "weight": 10, "power": 150,
"bulb": {"type": "LED", "lumens": 4000, "colorTemperature": 6500}, "lens": {"degreesMinMax": [10, 40]},
"focus": {"type": "Head", "panMax": 540, "tiltMax": "infinite"}}, )json";

inline bool says(const LoadedType& type, const std::string& words, const std::string& where = "") {
    return std::any_of(type.messages.begin(), type.messages.end(), [&](const Message& message) {
        return message.what.find(words) != std::string::npos &&
               message.where.find(where) != std::string::npos;
    });
}

inline State play(const Type& type, std::vector<std::uint8_t> bytes, int mode = 0) {
    const Patch patch{.name = "test", .type = &type, .mode = mode, .addresses = {{1, 1}}};
    State state = make_state(patch);
    bytes.resize(512);
    Levels levels;
    levels.set(1, bytes);
    step(state, patch, decode(patch, levels), 0.0);
    return state;
}

inline float level_of(const Optics& optics, float x) {
    for (const EmitterLevel& emitter : optics.emitters)
        if (std::abs(emitter.color.x - x) < 0.02f) return emitter.level;
    return -1.0f;
}
inline constexpr float kRed = 0.69f;
inline constexpr float kBlue = 0.14f;

} // namespace ghost::fixture
