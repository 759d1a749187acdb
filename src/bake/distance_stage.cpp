// SPDX-License-Identifier: Apache-2.0
#include "bake/private/distance_stage.h"

#include "bake/hasher.h"
#include "image/finite.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tbb/parallel_for.h>

namespace ghost::bake {
namespace {

const scene::Material* material_of(const scene::Stage& stage, const scene::Mesh& mesh) {
    // As the tracer resolves it.
    if (stage.materials.empty()) return nullptr;
    return &stage.materials[std::min(static_cast<std::size_t>(std::max(mesh.material, 0)),
                                     stage.materials.size() - 1)];
}

std::string alpha_key(const scene::Texture& texture) {
    Hasher hash;
    const image::Image8& pixels = texture.pixels;
    hash.value(pixels.width);
    hash.value(pixels.height);
    std::vector<std::uint8_t> alpha;
    if (pixels.channels == 4)
        for (std::size_t k = 3; k < pixels.samples.size(); k += 4) alpha.push_back(pixels.samples[k]);
    hash.list(alpha);
    return hash.hex();
}

std::string shape_key(const scene::Stage& stage, const scene::Mesh& mesh,
                      const std::vector<std::string>& alphas) {
    Hasher hash;
    hash.list(mesh.positions);
    hash.list(mesh.indices);
    const scene::Material* material = material_of(stage, mesh);
    if (material == nullptr || material->alpha_mode == scene::AlphaMode::opaque) return hash.hex();
    hash.value(material->alpha_mode);
    hash.value(material->alpha);
    hash.value(material->alpha_cutoff);
    const int texture = material->base_texture;
    if (texture < 0 || texture >= static_cast<int>(alphas.size())) return hash.hex();
    hash.text(alphas[static_cast<std::size_t>(texture)]);
    hash.list(mesh.uvs);
    return hash.hex();
}

// Bounds of all vertices that are numbers: the ray tracer leaves out triangles with others.
bool bounds_of(const scene::Mesh& mesh, const glm::mat4& world, scene::StageInstance& instance) {
    instance.low = glm::vec3(std::numeric_limits<float>::max());
    instance.high = -instance.low;
    for (const glm::vec3& vertex : mesh.positions) {
        if (!image::is_finite(vertex)) continue;
        const glm::vec3 at(world * glm::vec4(vertex, 1.0f));
        if (!image::is_finite(at)) return false;
        instance.low = glm::min(instance.low, at);
        instance.high = glm::max(instance.high, at);
    }
    return true;
}

} // namespace

StageForDistances stage_for_distances(const scene::Stage& stage, Report& report) {
    std::vector<char> cut(stage.textures.size(), 0); // textures whose alpha matters
    for (const scene::Material& material : stage.materials)
        if (material.alpha_mode != scene::AlphaMode::opaque && material.base_texture >= 0 &&
            material.base_texture < static_cast<int>(cut.size()))
            cut[static_cast<std::size_t>(material.base_texture)] = 1;
    std::vector<std::string> alphas(stage.textures.size());
    tbb::parallel_for(std::size_t{0}, alphas.size(), [&](std::size_t k) {
        if (cut[k] != 0) alphas[k] = alpha_key(stage.textures[k]);
    });
    std::vector<std::string> shapes(stage.meshes.size());
    tbb::parallel_for(std::size_t{0}, shapes.size(),
                      [&](std::size_t k) { shapes[k] = shape_key(stage, stage.meshes[k], alphas); });

    StageForDistances result;
    result.keys.resize(stage.instances.size());
    std::vector<scene::StageInstance> placed(stage.instances.size());
    std::vector<char> lost(stage.instances.size(), 0);
    tbb::parallel_for(std::size_t{0}, placed.size(), [&](std::size_t k) {
        const scene::Instance& instance = stage.instances[k];
        if (instance.fixture != scene::kNone || instance.mesh < 0 ||
            instance.mesh >= static_cast<int>(stage.meshes.size()))
            return;
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        if (!image::is_finite(instance.world) || !bounds_of(stage.meshes[mesh], instance.world, placed[k])) {
            lost[k] = 1;
            return;
        }
        if (placed[k].low.x > placed[k].high.x) return; // no vertex at all
        Hasher hash;
        hash.text(shapes[mesh]);
        hash.bytes(&instance.world, sizeof instance.world);
        placed[k].key = result.keys[k] = hash.hex().substr(0, 16);
    });
    for (std::size_t k = 0; k < placed.size(); ++k) {
        if (lost[k] != 0)
            report.add(Severity::warning, "stage",
                       "object '" + stage.instances[k].name +
                           "' has a place that is not made of finite numbers; it is left out of the distance "
                           "maps");
        if (!placed[k].key.empty()) result.stage.instances.push_back(std::move(placed[k]));
    }
    std::sort(result.stage.instances.begin(), result.stage.instances.end(),
              [](const scene::StageInstance& a, const scene::StageInstance& b) { return a.key < b.key; });
    Hasher all;
    for (const scene::StageInstance& instance : result.stage.instances) all.text(instance.key);
    result.stage.key = all.hex();
    return result;
}

} // namespace ghost::bake
