// SPDX-License-Identifier: Apache-2.0
// What Assimp does not check or know about glTF binaries (Khronos glTF 2.0, section 4.4).
#include "stage/model_file.h"
#include "stage/private/gltf_number.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <string_view>

namespace ghost::scene {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a; // "JSON"
constexpr std::string_view kBeyondFloat = "1e39";

float number_at(const nlohmann::json& json, const char* place, float fallback, float high) {
    const nlohmann::json::json_pointer pointer(place);
    if (!json.is_object() || !json.contains(pointer) || !json[pointer].is_number()) return fallback;
    const float value = json[pointer].get<float>();
    return value >= 0.0f && value <= high ? value : fallback;
}

nlohmann::json list_at(const nlohmann::json& json, const char* key) {
    if (!json.is_object() || !json.contains(key) || !json[key].is_array()) return nlohmann::json::array();
    return json[key];
}

// Length of the word for no number that stands here, or 0.
std::size_t non_number_at(std::string_view text) {
    for (const std::string_view word : {"NaN", "Infinity"})
        if (text.starts_with(word)) return word.size();
    return 0;
}

} // namespace

Result<void> check_glb(Bytes bytes, const std::string& name) {
    ByteReader reader(bytes);
    const std::uint32_t magic = reader.u32_le();
    const std::uint32_t version = reader.u32_le();
    const std::uint32_t length = reader.u32_le();
    if (!reader.ok())
        return Error{"is cut short: " + std::to_string(bytes.size()) + " bytes, no glTF header", name};
    if (magic != kMagic) return Error{"not a glTF binary: it does not begin with 'glTF'", name};
    if (version != 2) return Error{"is glTF version " + std::to_string(version) + ", expected 2", name};
    if (length > bytes.size())
        return Error{"is cut short: the header says " + std::to_string(length) + " bytes, the file has " +
                         std::to_string(bytes.size()),
                     name};
    bool has_json = false;
    while (reader.position() + 8 <= length) {
        const std::uint32_t chunk_length = reader.u32_le();
        has_json |= reader.u32_le() == kJsonChunk;
        if (chunk_length > length - reader.position())
            return Error{"a chunk of " + std::to_string(chunk_length) + " bytes does not fit into the file",
                         name};
        reader.skip(chunk_length);
    }
    if (!has_json) return Error{"has no JSON chunk", name};
    return {};
}

std::string_view json_of_glb(Bytes glb) {
    ByteReader reader(glb);
    reader.skip(12); // header of the file
    const std::uint32_t length = reader.u32_le();
    if (reader.u32_le() != kJsonChunk) return {};
    const Bytes chunk = reader.take(length);
    return {reinterpret_cast<const char*>(chunk.data()), chunk.size()};
}

std::vector<std::uint8_t> glb_with_json(Bytes glb, std::string json) {
    constexpr std::size_t kBeforeText = 20; // header of the file, header of its first chunk
    const std::size_t old_size = json_of_glb(glb).size();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t size = glb.size() - old_size + json.size();
    std::vector<std::uint8_t> made;
    made.reserve(size);
    for (const std::size_t value :
         {std::size_t{kMagic}, std::size_t{2}, size, json.size(), std::size_t{kJsonChunk}})
        for (std::size_t k = 0; k < 4; ++k) made.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
    made.insert(made.end(), json.begin(), json.end());
    const Bytes rest = glb.subspan(kBeforeText + old_size);
    made.insert(made.end(), rest.begin(), rest.end());
    return made;
}

std::size_t replace_non_numbers(Bytes glb, std::vector<std::uint8_t>& repaired) {
    const std::string_view from = json_of_glb(glb);
    std::string text;
    std::size_t count = 0;
    bool in_string = false;
    for (std::size_t k = 0; k < from.size(); ++k) {
        const std::size_t length = in_string ? 0 : non_number_at(from.substr(k, 8));
        if (length > 0) {
            text += kBeyondFloat;
            k += length - 1;
            ++count;
            continue;
        }
        if (in_string && from[k] == '\\' && k + 1 < from.size())
            text += from[k++];
        else if (from[k] == '"')
            in_string = !in_string;
        text += from[k];
    }
    if (count == 0) return 0;
    repaired = glb_with_json(glb, std::move(text));
    return count;
}

GltfExtras gltf_extras(Bytes glb) {
    const std::string_view text = json_of_glb(glb);
    const auto read = read_json(text, "", kGltfJson);
    if (!read.ok() || !read->is_object()) return {};
    const nlohmann::json& json = *read;
    GltfExtras extras;
    for (const auto& material : list_at(json, "materials"))
        extras.materials.push_back(
            {number_at(material, "/extensions/KHR_materials_emissive_strength/emissiveStrength", 1.0f, 1e6f),
             number_at(material, "/extensions/KHR_materials_specular/specularFactor", 1.0f, 1.0f)});

    const nlohmann::json accessors = list_at(json, "accessors");
    std::set<std::string> not_unique;
    for (const auto& mesh : list_at(json, "meshes")) {
        if (!mesh.is_object() || !mesh.contains("name") || !mesh["name"].is_string()) continue;
        const nlohmann::json primitives = list_at(mesh, "primitives");
        for (std::size_t k = 0; k < primitives.size(); ++k) {
            const auto mode = unsigned_at(primitives[k], "mode");
            const auto accessor = unsigned_at(primitives[k], "indices");
            const bool strip = mode == kGltfTriangleStrip;
            if ((!strip && mode.value_or(kGltfTriangles) != kGltfTriangles) || !accessor ||
                *accessor >= accessors.size())
                continue;
            const std::string name =
                mesh["name"].get<std::string>() + (primitives.size() > 1 ? "-" + std::to_string(k) : "");
            const std::size_t points = unsigned_at(accessors[*accessor], "count").value_or(0);
            const std::size_t count = strip ? std::max<std::size_t>(points, 2) - 2 : points / 3;
            if (!extras.triangles.emplace(name, count).second) not_unique.insert(name);
        }
    }
    for (const std::string& name : not_unique) extras.triangles.erase(name);
    return extras;
}

} // namespace ghost::scene
