// SPDX-License-Identifier: Apache-2.0
// A .gltf with buffers of its own is the same model as the .glb that it was made from.
#include "stage/gltf_pack.h"

#include "stage/model_reader.h"
#include "support/tiny_glb.h"

#include <map>
#include <nlohmann/json.hpp>

namespace ghost::scene {
namespace {

using Json = nlohmann::json;
using Files = std::map<std::string, std::vector<std::uint8_t>>;

struct Parts {
    Json file;
    std::vector<std::uint8_t> binary;
};

Parts parts_of(const std::vector<std::uint8_t>& glb) {
    const auto u32 = [&](std::size_t at) {
        return static_cast<std::size_t>(glb[at]) | static_cast<std::size_t>(glb[at + 1]) << 8 |
               static_cast<std::size_t>(glb[at + 2]) << 16 | static_cast<std::size_t>(glb[at + 3]) << 24;
    };
    const std::size_t length = u32(12);
    const auto begin = glb.begin() + 20;
    return {Json::parse(begin, begin + static_cast<std::ptrdiff_t>(length)),
            {begin + static_cast<std::ptrdiff_t>(length) + 8, glb.end()}};
}

std::vector<std::uint8_t> json_text(const Json& file) {
    const std::string text = file.dump();
    return {text.begin(), text.end()};
}

Result<std::vector<std::uint8_t>> packed(const Json& file, const Files& files = {}) {
    return glb_from_gltf(json_text(file), "test.gltf",
                         [&](const std::string& name) -> Result<std::vector<std::uint8_t>> {
                             const auto found = files.find(name);
                             if (found == files.end()) return Error{"is not in the archive", name};
                             return found->second;
                         });
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

void expect_same_model(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    Report report;
    const auto first = load_model(a, "glb", "a", ModelSource::archive, report);
    const auto second = load_model(b, "glb", "b", ModelSource::archive, report);
    ASSERT_TRUE(first.ok() && second.ok()) << (first.ok() ? second.error().text() : first.error().text());
    ASSERT_EQ(first->meshes.size(), second->meshes.size());
    EXPECT_EQ(first->meshes.at(0).positions, second->meshes.at(0).positions);
    EXPECT_EQ(first->meshes.at(0).uvs, second->meshes.at(0).uvs);
    EXPECT_EQ(first->meshes.at(0).indices, second->meshes.at(0).indices);
}

TEST(gltf_pack, buffers_in_files_and_in_the_text) {
    const std::vector<std::uint8_t> glb = TinyGlb{}.bytes();
    const Parts parts = parts_of(glb);
    Json file = parts.file;
    file["buffers"][0]["uri"] = "my%20part.bin";
    const auto from_file = packed(file, {{"my part.bin", parts.binary}});
    ASSERT_TRUE(from_file.ok()) << from_file.error().text();
    expect_same_model(glb, *from_file);
    file["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(parts.binary);
    const auto from_text = packed(file);
    ASSERT_TRUE(from_text.ok()) << from_text.error().text();
    expect_same_model(glb, *from_text);
    // Two buffers, the first of an odd length.
    file["buffers"] = {{{"uri", "odd"}, {"byteLength", 3}},
                       {{"uri", "part"}, {"byteLength", parts.binary.size()}}};
    for (Json& view : file["bufferViews"]) view["buffer"] = 1;
    const auto from_two = packed(file, {{"odd", {1, 2, 3}}, {"part", parts.binary}});
    ASSERT_TRUE(from_two.ok()) << from_two.error().text();
    expect_same_model(glb, *from_two);
}

TEST(gltf_pack, what_is_wrong_is_said) {
    const Parts parts = parts_of(TinyGlb{}.bytes());
    Json file = parts.file;
    const auto fault = [&] {
        const auto result = packed(file);
        return result.ok() ? std::string() : result.error().text();
    };
    EXPECT_NE(fault().find("buffer without a uri"), std::string::npos);
    file["buffers"][0]["uri"] = "gone.bin";
    EXPECT_NE(fault().find("needs the buffer 'gone.bin': is not in the archive"), std::string::npos);
    file["buffers"][0]["uri"] = "data:x;base64,!!";
    EXPECT_NE(fault().find("no base64"), std::string::npos);
    file["buffers"][0]["uri"] = "data:x;base64,AAAA";
    file["bufferViews"][0]["buffer"] = 7;
    EXPECT_NE(fault().find("a buffer that does not exist"), std::string::npos);
    file = Json::array();
    EXPECT_NE(fault().find("no JSON"), std::string::npos);
    EXPECT_TRUE(packed(Json::object()).ok()) << "the loader says what is missing";
}

} // namespace
} // namespace ghost::scene
