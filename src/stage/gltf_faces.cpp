// SPDX-License-Identifier: Apache-2.0
// glTF 2.0, section 3.7.2.1. Assimp 5.2 makes each face of a line or of a fan from the one before, which is
// not there where an index was wrong, and counts the faces of what is too short for one from below zero.
#include "stage/model_file.h"
#include "stage/private/gltf_number.h"

#include <nlohmann/json.hpp>

#include <string_view>

namespace ghost::scene {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kPoints = 0, kLineLoop = 2, kLineStrip = 3, kTriangleFan = 6; // primitive modes

std::size_t occurrences(std::string_view text, std::string_view words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + words.size()))
        ++count;
    return count;
}

std::size_t points_of(const Json& document, const Json& primitive) {
    const bool indexed = primitive.contains("indices");
    const Json empty = Json::object();
    const Json& attributes = primitive.contains("attributes") ? primitive["attributes"] : empty;
    const auto accessor = indexed ? unsigned_at(primitive, "indices") : unsigned_at(attributes, "POSITION");
    if (!accessor || !document.contains("accessors") || !document["accessors"].is_array() ||
        *accessor >= document["accessors"].size())
        return 0;
    return unsigned_at(document["accessors"][*accessor], "count").value_or(0);
}

} // namespace

Result<std::string> without_unsafe_faces(std::string_view json, const std::string& name, std::size_t& lost) {
    lost = 0;
    TRY(Json document, read_json(json, name, kGltfJson));
    if (!document.is_object() || !document.contains("meshes") || !document["meshes"].is_array())
        return std::string();
    std::size_t modes = 0;
    bool changed = false;
    for (Json& mesh : document["meshes"]) {
        if (!mesh.is_object() || !mesh.contains("primitives") || !mesh["primitives"].is_array()) continue;
        for (Json& primitive : mesh["primitives"]) {
            if (!primitive.is_object()) continue;
            modes += primitive.contains("mode") ? 1 : 0;
            const std::size_t mode = unsigned_at(primitive, "mode").value_or(kGltfTriangles);
            const bool line = mode == kLineLoop || mode == kLineStrip;
            const bool fan = mode == kTriangleFan, strip = mode == kGltfTriangleStrip;
            const bool unsafe = line || (fan && primitive.contains("indices")) ||
                                ((fan || strip) && points_of(document, primitive) < 3);
            if (!unsafe) continue;
            primitive["mode"] = kPoints;
            changed = true;
            lost += line ? 0 : 1;
        }
    }
    // Of a key that is there twice, or written with escapes, Assimp may take another one than was looked at
    // here.
    const bool plain = occurrences(json, "\"mode\"") == modes && json.find("\\u") == json.npos;
    return changed || !plain ? document.dump(-1, ' ', false, Json::error_handler_t::replace) : std::string();
}

} // namespace ghost::scene
