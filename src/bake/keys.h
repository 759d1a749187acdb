#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a pass depends on, as hashes: a pass whose key did not change is not baked again. 128 bits, not
// cryptographic. Pure.

#include "bake/frame.h"
#include "light/bodies.h"
#include "show/camera.h"
#include "stage/stage.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ghost::bake {

// Raise it when the same input gives another picture than before.
inline constexpr int kBakerVersion = 2;

class Hasher {
public:
    void bytes(const void* data, std::size_t size);
    void text(std::string_view value);
    template <class T>
    void value(const T& item) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        bytes(&item, sizeof item);
    }
    template <class T>
    void list(const std::vector<T>& items) {
        value(items.size());
        bytes(items.data(), items.size() * sizeof(T));
    }
    std::string hex() const; // 32 digits

private:
    void mix(std::uint64_t word);
    std::uint64_t a_ = 0x243f6a8885a308d3u;
    std::uint64_t b_ = 0x13198a2e03707344u;
};

// Keys of the stage without fixture bodies, and of each fixture's body (empty where it has none).
struct StageKeys {
    std::string stage;
    std::vector<std::string> bodies; // per fixture
};
StageKeys stage_keys(const scene::Stage& stage_with_bodies, std::size_t fixture_count);

std::string geometry_key(const StageKeys& keys, const scene::Camera& camera, int spp);
std::string light_key(const std::string& geometry_key, const glm::vec3& position_m, int bounces);

// Where in the picture the bodies of a fixture are; empty where the camera does not see them.
Rect body_rect(const scene::Stage& stage, int fixture, const scene::Camera& camera);

} // namespace ghost::bake
