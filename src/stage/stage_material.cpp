// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"
#include "image/colour.h"
#include "image/ldr.h"
#include "stage/model_file.h"
#include "stage/overrides.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxTextures = 1024;
constexpr std::size_t kMaxTextureBytes = std::size_t{2} << 30; // decoded, all together
constexpr std::size_t kLargeBytes = std::size_t{64} << 20;     // larger ones are decoded one after the other

std::string percent_decoded(const std::string& text) {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    std::string result;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const int high = text[k] == '%' && k + 2 < text.size() ? digit(text[k + 1]) : -1;
        const int low = high >= 0 ? digit(text[k + 2]) : -1;
        result += low >= 0 ? static_cast<char>(high * 16 + low) : text[k];
        k += low >= 0 ? 2 : 0;
    }
    return result;
}

// The textures of one file, each picture of each kind once.
class TextureTable {
public:
    TextureTable(const aiScene& scene, const ReadCompanion& read_companion)
        : scene_(scene), read_companion_(read_companion) {}

    int add(const std::string& path, bool is_colour) {
        const auto [entry, is_new] = index_.try_emplace({path, is_colour}, static_cast<int>(wanted_.size()));
        if (is_new) wanted_.push_back({path, is_colour});
        return entry->second;
    }

    // Decodes all on a few threads. place[index of add] is the texture of the stage, or kNone.
    std::vector<int> decode(const std::string& name, Stage& stage, Report& report) {
        std::vector<Result<image::Image8>> pictures(wanted_.size(), Error{"more than 1024 textures", ""});
        std::vector<std::string> damage(wanted_.size());
        const std::size_t count = std::min(wanted_.size(), kMaxTextures);
        const std::size_t workers = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 16);
        {
            std::vector<std::jthread> threads;
            for (std::size_t w = 0; w < workers; ++w)
                threads.emplace_back([&, w] {
                    for (std::size_t k = w; k < count; k += workers) pictures[k] = decode_one(k, damage[k]);
                });
        }
        std::vector<int> place(wanted_.size(), kNone);
        for (std::size_t k = 0; k < wanted_.size(); ++k) {
            if (!pictures[k].ok()) {
                report.add(Severity::error, name,
                           "texture '" + wanted_[k].first + "' is missing: " + pictures[k].error().text());
                continue;
            }
            if (!damage[k].empty())
                report.add(Severity::warning, name, "texture '" + wanted_[k].first + "': " + damage[k]);
            place[k] = static_cast<int>(stage.textures.size());
            stage.textures.push_back({wanted_[k].first, std::move(*pictures[k]), wanted_[k].second});
        }
        return place;
    }

private:
    Result<image::Image8> decode_one(std::size_t index, std::string& damage) {
        std::vector<std::uint8_t> external;
        const Result<Bytes> packed = packed_bytes(wanted_[index].first, external);
        const std::size_t bytes = packed.ok() ? image::decoded_bytes(*packed) : 0;
        const bool has_room = take_room(index, bytes);
        TRY(const Bytes found, packed);
        if (!has_room) return Error{"the textures need more than 2 GiB", ""};
        std::unique_lock alone(decoding_large_, std::defer_lock);
        if (bytes > kLargeBytes) alone.lock();
        return image::decode_ldr(found, "", {}, &damage);
    }

    Result<Bytes> packed_bytes(const std::string& path, std::vector<std::uint8_t>& external) {
        const aiTexture* embedded = scene_.GetEmbeddedTexture(path.c_str());
        if (embedded && embedded->mHeight == 0)
            return Bytes(reinterpret_cast<const std::uint8_t*>(embedded->pcData), embedded->mWidth);
        if (embedded) return Error{"embedded without compression, expected PNG or JPEG", ""};
        TRY(external, read_external(path));
        return Bytes(external);
    }

    // In the order of the file, so that the same textures have room each time. Waits for those before.
    bool take_room(std::size_t index, std::size_t bytes) {
        for (std::size_t now = next_; now != index; now = next_) next_.wait(now);
        const bool has_room = bytes <= kMaxTextureBytes - taken_bytes_;
        taken_bytes_ += has_room ? bytes : 0;
        next_ = index + 1;
        next_.notify_all();
        return has_room;
    }

    // As it is written; as glTF 2.0 writes it (percent-encoded); as Windows does.
    Result<std::vector<std::uint8_t>> read_external(const std::string& path) {
        std::string slashes = path;
        std::replace(slashes.begin(), slashes.end(), '\\', '/');
        const std::lock_guard lock(reading_);
        auto first = read_companion_(path);
        for (const std::string& name : {percent_decoded(path), slashes}) {
            if (first.ok() || name == path) continue;
            if (auto read = read_companion_(name); read.ok()) return read;
        }
        return first;
    }

    const aiScene& scene_;
    const ReadCompanion& read_companion_;
    std::mutex reading_;
    std::mutex decoding_large_;
    std::atomic<std::size_t> next_ = 0; // index of the texture that takes room next
    std::size_t taken_bytes_ = 0;       // its
    std::map<std::pair<std::string, bool>, int> index_;
    std::vector<std::pair<std::string, bool>> wanted_;
};

float factor(const aiMaterial& source, const char* key, unsigned type, unsigned index, float fallback,
             float low, float high) {
    float value = fallback;
    if (source.Get(key, type, index, value) != AI_SUCCESS || !std::isfinite(value)) return fallback;
    return std::clamp(value, low, high);
}

glm::vec3 colour(const aiColor4D& rgb) {
    const glm::vec3 value(rgb.r, rgb.g, rgb.b);
    for (int k = 0; k < 3; ++k)
        if (!(value[k] >= 0.0f && value[k] < 1e6f)) return glm::vec3(0.0f);
    return image::rec709_to_rec2020(value);
}

int texture_of(const aiMaterial& source, aiTextureType type, bool is_colour, TextureTable& table,
               bool& odd_mapping) {
    aiString path;
    unsigned uv = 0;
    if (source.GetTexture(type, 0, &path, nullptr, &uv) != AI_SUCCESS || path.length == 0) return kNone;
    aiUVTransform transform;
    odd_mapping |= uv != 0 || source.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == AI_SUCCESS;
    return table.add(path.C_Str(), is_colour);
}

Material material_from(const aiMaterial& source, TextureTable& table, bool& odd_mapping) {
    Material material;
    material.name = source.GetName().C_Str();
    aiColor4D rgba(0.8f, 0.8f, 0.8f, 1.0f);
    const bool is_pbr = source.Get(AI_MATKEY_BASE_COLOR, rgba) == AI_SUCCESS;
    if (!is_pbr && source.Get(AI_MATKEY_COLOR_DIFFUSE, rgba) == AI_SUCCESS)
        rgba.a = factor(source, AI_MATKEY_OPACITY, 1.0f, 0.0f, 1.0f);
    material.base_colour = glm::clamp(colour(rgba), 0.0f, 1.0f);
    material.alpha = std::isfinite(rgba.a) ? std::clamp(rgba.a, 0.0f, 1.0f) : 1.0f;
    const float shininess = factor(source, AI_MATKEY_SHININESS, 0.0f, 0.0f, 1e6f);
    material.roughness = factor(source, AI_MATKEY_ROUGHNESS_FACTOR,
                                is_pbr ? 1.0f : roughness_from_shininess(shininess), 0.0f, 1.0f);
    material.metalness = factor(source, AI_MATKEY_METALLIC_FACTOR, is_pbr ? 1.0f : 0.0f, 0.0f, 1.0f);
    aiColor4D emission;
    if (source.Get(AI_MATKEY_COLOR_EMISSIVE, emission) == AI_SUCCESS) material.emission = colour(emission);
    material.normal_scale =
        factor(source, AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), 1.0f, -10.0f, 10.0f);

    int two_sided = 1;
    if (source.Get(AI_MATKEY_TWOSIDED, two_sided) == AI_SUCCESS) material.double_sided = two_sided != 0;
    aiString mode;
    const bool has_mode = source.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == AI_SUCCESS;
    const std::string alpha_mode = mode.C_Str();
    if (alpha_mode == "MASK") material.alpha_mode = AlphaMode::mask;
    if (alpha_mode == "BLEND" || (!has_mode && material.alpha < 1.0f)) material.alpha_mode = AlphaMode::blend;
    material.alpha_cutoff = factor(source, AI_MATKEY_GLTF_ALPHACUTOFF, 0.5f, 0.0f, 1.0f);

    material.base_texture = texture_of(source, aiTextureType_BASE_COLOR, true, table, odd_mapping);
    if (material.base_texture == kNone)
        material.base_texture = texture_of(source, aiTextureType_DIFFUSE, true, table, odd_mapping);
    material.normal_texture = texture_of(source, aiTextureType_NORMALS, false, table, odd_mapping);
    if (is_pbr) // glTF's roughness and metalness picture
        material.surface_texture = texture_of(source, aiTextureType_UNKNOWN, false, table, odd_mapping);
    material.emission_texture = texture_of(source, aiTextureType_EMISSIVE, true, table, odd_mapping);
    return material;
}

} // namespace

void add_materials(const aiScene& scene, const std::vector<GltfMaterialExtras>& extras,
                   const std::string& name, const ReadCompanion& read_companion, Stage& stage,
                   Report& report) {
    TextureTable table(scene, read_companion);
    std::vector<std::string> oddly_mapped;
    for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
        bool odd_mapping = false;
        Material material = material_from(*scene.mMaterials[m], table, odd_mapping);
        if (odd_mapping) oddly_mapped.push_back(material.name);
        if (m < extras.size()) {
            material.emission *= extras[m].emissive_strength;
            material.specular = extras[m].specular;
        }
        stage.materials.push_back(std::move(material));
    }
    if (stage.materials.empty()) stage.materials.push_back({});
    if (!oddly_mapped.empty())
        report.add(Severity::warning, name,
                   "materials with a texture transform or a second set of texture coordinates show their "
                   "textures by "
                   "the first set, untransformed: " +
                       name_list(oddly_mapped));

    const std::vector<int> place = table.decode(name, stage, report);
    const auto put = [&](int& texture) {
        if (texture != kNone) texture = place[static_cast<std::size_t>(texture)];
    };
    for (Material& material : stage.materials) {
        put(material.base_texture);
        put(material.normal_texture);
        put(material.surface_texture);
        put(material.emission_texture);
    }
}

} // namespace ghost::scene
