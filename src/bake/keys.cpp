// SPDX-License-Identifier: Apache-2.0
#include "bake/keys.h"

#include "bake/hasher.h"
#include "rays/camera_rays.h"

#include <algorithm>
#include <limits>

namespace ghost::bake {
namespace {

std::string texture_key(const scene::Texture& texture) {
    Hasher hash;
    hash.value(texture.is_colour);
    hash.value(texture.pixels.width);
    hash.value(texture.pixels.height);
    hash.value(texture.pixels.channels);
    hash.list(texture.pixels.samples);
    return hash.hex();
}

std::string material_key(const scene::Material& m, const std::vector<std::string>& textures) {
    Hasher hash;
    for (const float number :
         {m.base_colour.x, m.base_colour.y, m.base_colour.z, m.alpha, m.roughness, m.metalness, m.specular,
          m.emission.x, m.emission.y, m.emission.z, m.normal_scale, m.alpha_cutoff})
        hash.value(number);
    hash.value(m.alpha_mode);
    for (const int texture : {m.base_texture, m.normal_texture, m.surface_texture, m.emission_texture})
        hash.text(texture >= 0 && texture < static_cast<int>(textures.size())
                      ? textures[static_cast<std::size_t>(texture)]
                      : std::string());
    return hash.hex();
}

std::string mesh_key(const scene::Mesh& mesh, const std::vector<std::string>& materials) {
    Hasher hash;
    hash.list(mesh.positions);
    hash.list(mesh.normals);
    hash.list(mesh.tangents);
    hash.list(mesh.uvs);
    hash.list(mesh.indices);
    hash.text(mesh.material >= 0 && mesh.material < static_cast<int>(materials.size())
                  ? materials[static_cast<std::size_t>(mesh.material)]
                  : std::string());
    return hash.hex();
}

} // namespace

StageKeys stage_keys(const scene::Stage& stage, std::size_t fixture_count) {
    std::vector<std::string> textures;
    std::vector<std::string> materials;
    std::vector<std::string> meshes;
    for (const scene::Texture& texture : stage.textures) textures.push_back(texture_key(texture));
    for (const scene::Material& material : stage.materials)
        materials.push_back(material_key(material, textures));
    for (const scene::Mesh& mesh : stage.meshes) meshes.push_back(mesh_key(mesh, materials));

    Hasher all;
    std::vector<Hasher> bodies(fixture_count);
    std::vector<bool> has_body(fixture_count, false);
    for (const scene::Instance& instance : stage.instances) {
        if (instance.mesh < 0 || instance.mesh >= static_cast<int>(meshes.size())) continue;
        const auto owner = static_cast<std::size_t>(std::max(instance.fixture, 0));
        const bool body = instance.fixture != scene::kNone && owner < fixture_count;
        Hasher& hash = body ? bodies[owner] : all;
        if (body) has_body[owner] = true;
        hash.value(instance.fixture != scene::kNone);
        hash.text(meshes[static_cast<std::size_t>(instance.mesh)]);
        hash.bytes(&instance.world, sizeof instance.world);
    }
    StageKeys keys;
    keys.stage = all.hex();
    for (std::size_t k = 0; k < fixture_count; ++k) keys.bodies.push_back(has_body[k] ? bodies[k].hex() : "");
    return keys;
}

std::string geometry_key(const StageKeys& keys, const scene::Camera& camera, int spp) {
    Hasher hash;
    hash.value(kBakerVersion);
    hash.text(keys.stage);
    const glm::mat4 world = scene::camera_to_world(camera);
    hash.bytes(&world, sizeof world);
    hash.value(camera.fov_y_deg);
    hash.value(camera.width);
    hash.value(camera.height);
    hash.value(spp);
    return hash.hex();
}

std::string light_key(const std::string& geometry_key, const glm::vec3& position_m, int bounces) {
    Hasher hash;
    hash.text(geometry_key);
    hash.bytes(&position_m, sizeof position_m);
    hash.value(bounces);
    return hash.hex();
}

Rect body_rect(const scene::Stage& stage, int fixture, const scene::Camera& camera) {
    constexpr float kNear_m = 0.05f;
    constexpr int kMargin = 2;
    const glm::mat4 to_camera = glm::inverse(scene::camera_to_world(camera));
    const float scale =
        0.5f * static_cast<float>(camera.height) / std::tan(glm::radians(camera.fov_y_deg) * 0.5f);
    const Rect whole{0, 0, camera.width, camera.height};
    glm::vec2 low(std::numeric_limits<float>::max());
    glm::vec2 high(std::numeric_limits<float>::lowest());
    for (const scene::Instance& instance : stage.instances) {
        if (instance.fixture != fixture || instance.mesh < 0 ||
            instance.mesh >= static_cast<int>(stage.meshes.size()))
            continue;
        const glm::mat4 place = to_camera * instance.world;
        bool behind = false;
        bool in_front = false;
        for (const glm::vec3& vertex : stage.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            const glm::vec3 at(place * glm::vec4(vertex, 1.0f));
            if (at.z > -kNear_m) {
                behind = true;
                continue;
            }
            in_front = true;
            const glm::vec2 pixel =
                glm::vec2(at.x, -at.y) * (scale / -at.z) +
                0.5f * glm::vec2(static_cast<float>(camera.width), static_cast<float>(camera.height));
            low = glm::min(low, pixel);
            high = glm::max(high, pixel);
        }
        if (behind && in_front) return whole;
    }
    const auto clamped = [](float value, int limit) {
        return static_cast<int>(std::clamp(value, 0.0f, static_cast<float>(limit)));
    };
    if (low.x > high.x) return {};
    const float margin = static_cast<float>(kMargin);
    return {clamped(low.x - margin, whole.x1), clamped(low.y - margin, whole.y1),
            clamped(high.x + margin + 1, whole.x1), clamped(high.y + margin + 1, whole.y1)};
}

} // namespace ghost::bake
