// SPDX-License-Identifier: Apache-2.0
#include "stage/gltf_pack.h"

#include "base/base64.h"
#include "stage/model_file.h"
#include "stage/private/gltf_number.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace ghost::scene {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxBufferBytes = std::size_t{512} << 20;
constexpr std::size_t kMaxBuffers = 1024;

// "my%20mesh.bin"
std::string unescaped(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const std::string_view digits = uri.substr(i + 1 < uri.size() ? i + 1 : uri.size(), 2);
        const auto is_hex = [](char c) {
            return std::string_view("0123456789abcdefABCDEF").find(c) != std::string_view::npos;
        };
        if (uri[i] == '%' && digits.size() == 2 && is_hex(digits[0]) && is_hex(digits[1])) {
            text += static_cast<char>(std::stoi(std::string(digits), nullptr, 16));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

void put(std::vector<std::uint8_t>& out, std::size_t value) {
    for (int k = 0; k < 4; ++k) out.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
}

void pad(std::vector<std::uint8_t>& out, std::uint8_t filling) {
    while (out.size() % 4 != 0) out.push_back(filling);
}

} // namespace

Result<std::vector<std::uint8_t>>
glb_from_gltf(Bytes gltf, const std::string& name,
              const std::function<Result<std::vector<std::uint8_t>>(const std::string& file)>& read) {
    const std::string_view given(reinterpret_cast<const char*>(gltf.data()), gltf.size());
    TRY_VOID(check_gltf_size(given, name));
    TRY(Json file, read_json(given, name, kGltfJson));
    if (!file.is_object()) return Error{"is no JSON, which a .gltf should be", name};
    const Json buffers =
        file.contains("buffers") && file["buffers"].is_array() ? file["buffers"] : Json::array();
    if (buffers.size() > kMaxBuffers) return Error{"names more than 1024 buffers", name};
    std::vector<std::uint8_t> binary;
    std::vector<std::size_t> starts;
    for (const Json& buffer : buffers) {
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string())
            return Error{"has a buffer without a uri", name};
        const std::string& uri = buffer["uri"].get_ref<const std::string&>();
        std::vector<std::uint8_t> bytes;
        if (uri.starts_with("data:")) {
            const std::size_t comma = uri.find(";base64,");
            auto decoded = comma == std::string::npos ? std::nullopt
                                                      : from_base64(std::string_view(uri).substr(comma + 8));
            if (!decoded) return Error{"has a buffer that is no base64", name};
            bytes = std::move(*decoded);
        } else {
            auto found = read(unescaped(uri));
            if (!found.ok())
                return Error{"needs the buffer '" + uri.substr(0, 128) + "': " + found.error().what, name};
            bytes = std::move(*found);
        }
        if (bytes.size() > kMaxBufferBytes - binary.size())
            return Error{"has buffers of more than 512 MiB", name};
        starts.push_back(binary.size());
        binary.insert(binary.end(), bytes.begin(), bytes.end());
        pad(binary, 0);
    }
    if (file.contains("bufferViews") && file["bufferViews"].is_array())
        for (Json& view : file["bufferViews"]) {
            const auto index = unsigned_at(view, "buffer");
            const auto offset = unsigned_at(view, "byteOffset").value_or(0);
            if (!index || *index >= starts.size() || offset > kMaxBufferBytes)
                return Error{"has a buffer view of a buffer that does not exist", name};
            view["buffer"] = 0;
            view["byteOffset"] = starts[*index] + offset;
        }
    file["buffers"] = Json::array({{{"byteLength", binary.size()}}});
    const std::string text = file.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::vector<std::uint8_t> chunk(text.begin(), text.end());
    pad(chunk, ' ');
    std::vector<std::uint8_t> glb;
    glb.reserve(28 + chunk.size() + binary.size());
    for (const std::size_t value : std::array<std::size_t, 5>{
             0x46546c67, 2, 28 + chunk.size() + binary.size(), chunk.size(), 0x4e4f534a})
        put(glb, value);
    glb.insert(glb.end(), chunk.begin(), chunk.end());
    put(glb, binary.size());
    put(glb, 0x004e4942);
    glb.insert(glb.end(), binary.begin(), binary.end());
    return glb;
}

} // namespace ghost::scene
