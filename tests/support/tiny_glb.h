#pragma once
// SPDX-License-Identifier: Apache-2.0
// GLB files made by hand for the tests: one triangle (or what the JSON says) and any nodes.

#include "base/byte_reader.h"
#include "disk/files.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace ghost::scene {

inline void append_u32(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

inline std::vector<std::uint8_t> glb_of(std::string json, std::vector<std::uint8_t> binary) {
    while (json.size() % 4) json += ' ';
    while (binary.size() % 4) binary.push_back(0);
    std::vector<std::uint8_t> bytes;
    append_u32(bytes, 0x46546c67);
    append_u32(bytes, 2);
    append_u32(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    append_u32(bytes, static_cast<std::uint32_t>(json.size()));
    append_u32(bytes, 0x4e4f534a);
    bytes.insert(bytes.end(), json.begin(), json.end());
    append_u32(bytes, static_cast<std::uint32_t>(binary.size()));
    append_u32(bytes, 0x004e4942);
    bytes.insert(bytes.end(), binary.begin(), binary.end());
    return bytes;
}

inline void append_floats(std::vector<std::uint8_t>& bytes, const std::vector<float>& values) {
    const std::size_t at = bytes.size();
    bytes.resize(at + 4 * values.size());
    std::memcpy(bytes.data() + at, values.data(), 4 * values.size());
}

// What varies from test to test; each goes into the JSON as it is.
struct TinyGlb {
    std::string nodes = R"([{"name":"left","mesh":0}])";
    std::string roots = "[0]";
    std::string materials = R"([{"name":"paint"}])";
    std::string more; // e.g. "textures":[...],
    std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::vector<float> uvs{0, 0, 1, 0, 0, 0.25f};
    std::vector<std::uint32_t> indices{0, 1, 2};
    bool with_normals = true;

    std::vector<std::uint8_t> bytes() const {
        const std::size_t vertices = positions.size() / 3;
        std::vector<std::uint8_t> binary;
        append_floats(binary, positions);
        for (std::size_t v = 0; v < vertices; ++v) append_floats(binary, {0, 0, 1});
        append_floats(binary, uvs);
        for (const std::uint32_t index : indices) append_u32(binary, index);
        const auto n = [](std::size_t value) { return std::to_string(value); };
        const std::size_t p = positions.size() * 4;
        const std::size_t t = uvs.size() * 4;
        const std::size_t i = indices.size() * 4;
        const std::string json =
            R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + roots + R"(}],"nodes":)" + nodes +
            R"(,"materials":)" + materials + "," + more +
            R"("meshes":[{"name":"sail","primitives":[{"attributes":{"POSITION":0)" +
            (with_normals ? R"(,"NORMAL":1)" : "") +
            R"(,"TEXCOORD_0":2},"indices":3,"material":0}]}],"buffers":[{"byteLength":)" + n(2 * p + t + i) +
            R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" + n(p) +
            R"(},{"buffer":0,"byteOffset":)" + n(p) + R"(,"byteLength":)" + n(p) +
            R"(},{"buffer":0,"byteOffset":)" + n(2 * p) + R"(,"byteLength":)" + n(t) +
            R"(},{"buffer":0,"byteOffset":)" + n(2 * p + t) + R"(,"byteLength":)" + n(i) +
            R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" + n(vertices) +
            R"(,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},{"bufferView":1,"componentType":5126,"count":)" +
            n(vertices) + R"(,"type":"VEC3"},{"bufferView":2,"componentType":5126,"count":)" +
            n(uvs.size() / 2) + R"(,"type":"VEC2"},{"bufferView":3,"componentType":5125,"count":)" +
            n(indices.size()) + R"(,"type":"SCALAR"}]})";
        return glb_of(json, binary);
    }
};

inline std::filesystem::path scratch_folder(const std::string& name) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "ghost_scene" / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

inline std::filesystem::path written(const std::filesystem::path& path, Bytes bytes) {
    EXPECT_TRUE(write_file_atomic(path, bytes).ok());
    return path;
}

inline std::filesystem::path written(const std::filesystem::path& path, std::string_view text) {
    EXPECT_TRUE(write_file_atomic(path, text).ok());
    return path;
}

} // namespace ghost::scene
