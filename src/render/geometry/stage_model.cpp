// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/stage_model.h"

#include "base/check.h"
#include "base/log.h"
#include "image/finite.h"
#include "render/geometry/private/detail_levels.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <tuple>

namespace ghost::render {
namespace {

constexpr float kMostError_px = 0.15f;     // of a coarser body: less than samples are apart
constexpr std::uint64_t kMostOfLevels = 3; // indices of a mesh with all its levels of detail, by its own
constexpr float kLeastVolume = 1e-18f;     // below, an instance is flat: the baker leaves it out too

// Models differ in its upper half.
std::uint64_t first_revision() {
    static std::atomic<std::uint64_t> models = 0;
    return ++models << 32;
}

bool placeable(const glm::mat4& m) {
    return image::is_finite(m) && std::abs(glm::determinant(glm::mat3(m))) > kLeastVolume;
}

std::array<std::int16_t, 4> to_signed(const glm::vec4& v) {
    std::array<std::int16_t, 4> out{};
    for (int k = 0; k < 4; ++k)
        out[static_cast<std::size_t>(k)] =
            static_cast<std::int16_t>(std::lround(std::clamp(v[k], -1.0f, 1.0f) * 32767.0f));
    return out;
}

float sane(float value, float fallback) {
    return std::isfinite(value) ? value : fallback;
}
glm::vec3 sane(const glm::vec3& value) {
    return {sane(value.x, 0.0f), sane(value.y, 0.0f), sane(value.z, 0.0f)};
}

void set_values(const scene::Material& material, shared::MeshMaterial& values) {
    values.base_colour = sane(material.base_colour);
    values.alpha = sane(material.alpha, 1.0f);
    values.emission = sane(material.emission);
    values.alpha_cutoff = sane(material.alpha_cutoff, 0.5f);
    values.roughness = sane(material.roughness, 1.0f);
    values.metalness = sane(material.metalness, 0.0f);
    values.specular = sane(material.specular, 1.0f);
    values.normal_scale = sane(material.normal_scale, 1.0f);
}

// A tangent for each vertex, from the triangles around it.
std::vector<glm::vec4> make_tangents(const scene::Mesh& mesh) {
    std::vector<glm::vec3> along(mesh.positions.size(), glm::vec3(0.0f));
    std::vector<float> hand(mesh.positions.size(), 0.0f);
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        const std::uint32_t* i = mesh.indices.data() + k;
        const glm::vec3 e1 = mesh.positions[i[1]] - mesh.positions[i[0]];
        const glm::vec3 e2 = mesh.positions[i[2]] - mesh.positions[i[0]];
        const glm::vec2 d1 = mesh.uvs[i[1]] - mesh.uvs[i[0]];
        const glm::vec2 d2 = mesh.uvs[i[2]] - mesh.uvs[i[0]];
        const float sign = d1.x * d2.y - d1.y * d2.x < 0.0f ? -1.0f : 1.0f;
        const glm::vec3 tangent = image::unit_or(sign * (e1 * d2.y - e2 * d1.y), glm::vec3(0.0f));
        const glm::vec3 bitangent = -sign * (e2 * d1.x - e1 * d2.x);
        for (int c = 0; c < 3; ++c) {
            along[i[c]] += tangent;
            hand[i[c]] += glm::dot(glm::cross(mesh.normals[i[c]], tangent), bitangent) < 0.0f ? -1.0f : 1.0f;
        }
    }
    std::vector<glm::vec4> tangents;
    for (std::size_t v = 0; v < along.size(); ++v)
        tangents.emplace_back(image::unit_or(along[v], glm::vec3(0.0f)), hand[v] < 0.0f ? -1.0f : 1.0f);
    return tangents;
}

} // namespace

StageModel::StageModel(const gpu::Device& device, const scene::Stage& stage, Report& report,
                       std::uint64_t texture_bytes, std::uint64_t mesh_bytes)
    : device_(device), still_revision_(first_revision()) {
    add_textures(stage, report, texture_bytes);
    add_surfaces(stage);
    add_meshes(stage, report, mesh_bytes);
    upload_materials();
    add_instances(stage, report);
}

void StageModel::add_surfaces(const scene::Stage& stage) {
    std::vector<scene::Material> materials = stage.materials;
    if (materials.empty()) materials.emplace_back();
    for (const scene::Material& material : materials) {
        Surface surface;
        surface.made_from = surfaces_.size();
        set_values(material, surface.material);
        surface.material.seed = static_cast<std::uint32_t>(surfaces_.size() + 1) * 0x9e3779b9u;
        surface.alpha = material.alpha_mode == scene::AlphaMode::mask    ? shared::kMask
                        : material.alpha_mode == scene::AlphaMode::blend ? shared::kBlend
                                                                         : shared::kOpaque;
        const std::array<int, 4> wanted = textures_of(material);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const auto found = texture_of_.find({wanted[k], use_of(stage, wanted[k], k)});
            if (found == texture_of_.end()) continue;
            surface.texture[k] = found->second;
            surface.textures |= 1u << k;
        }
        surfaces_.push_back(surface);
    }
}

void StageModel::add_meshes(const scene::Stage& stage, Report& report, std::uint64_t mesh_bytes) {
    const std::uint64_t all_bytes = mesh_bytes;
    std::vector<StageVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const scene::Mesh& mesh : stage.meshes) {
        Mesh& made = meshes_.emplace_back();
        made.surface = std::min(static_cast<std::size_t>(std::max(mesh.material, 0)), surfaces_.size() - 1);
        made.range.first_index = static_cast<std::uint32_t>(indices.size());
        made.range.first_vertex = static_cast<std::int32_t>(vertices.size());
        made.low_m = glm::vec3(std::numeric_limits<float>::max());
        made.high_m = -made.low_m;
        const std::size_t count = mesh.positions.size();
        const bool usable =
            mesh.normals.size() == count && std::all_of(mesh.indices.begin(), mesh.indices.end(),
                                                        [&](std::uint32_t index) { return index < count; });
        if (!usable) {
            report.add(Severity::warning, mesh.name,
                       "the mesh has indices without vertices or vertices without normals: it is not drawn");
            continue;
        }
        const std::uint64_t bytes =
            count * sizeof(StageVertex) + kMostOfLevels * mesh.indices.size() * sizeof(std::uint32_t);
        if (bytes > mesh_bytes) {
            report.add(Severity::error, mesh.name,
                       "the mesh is not drawn: with those before it, it needs more than the " +
                           std::to_string(all_bytes >> 20) + " MiB that all meshes may have");
            continue;
        }
        mesh_bytes -= bytes;
        std::vector<glm::vec3> facets(count, glm::vec3(0, 0, 1)); // where a normal is none
        for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
            const std::uint32_t* i = mesh.indices.data() + k;
            const glm::vec3 cross = glm::cross(mesh.positions[i[1]] - mesh.positions[i[0]],
                                               mesh.positions[i[2]] - mesh.positions[i[0]]);
            // Not finite, or a line: it covers nothing.
            if (!image::is_finite(cross) || glm::dot(cross, cross) == 0.0f) continue;
            const glm::vec3 facet = image::unit_or(cross, glm::vec3(0, 0, 1));
            // Files disagree about winding, so only the normals say which side is the front.
            float facing = 0.0f;
            for (int c = 0; c < 3; ++c) {
                facing += glm::dot(image::unit_or(mesh.normals[i[c]], facet), facet);
                made.low_m = glm::min(made.low_m, mesh.positions[i[c]]);
                made.high_m = glm::max(made.high_m, mesh.positions[i[c]]);
                facets[i[c]] = facet;
            }
            indices.insert(indices.end(), {i[0], facing < 0.0f ? i[2] : i[1], facing < 0.0f ? i[1] : i[2]});
        }
        made.range.index_count = static_cast<std::uint32_t>(indices.size()) - made.range.first_index;
        add_levels(mesh, facets, made, indices);
        const bool textured = mesh.uvs.size() == count;
        if (!textured && (surfaces_[made.surface].textures & shared::kNormalTexture) != 0) {
            // Bumps need a direction along the picture.
            Surface plain = surfaces_[made.surface];
            plain.textures &= ~shared::kNormalTexture;
            made.surface = surfaces_.size();
            surfaces_.push_back(plain);
        }
        const bool bumps = (surfaces_[made.surface].textures & shared::kNormalTexture) != 0;
        const bool has_tangents = mesh.tangents.size() == count;
        const std::vector<glm::vec4> tangents =
            bumps && !has_tangents ? make_tangents(mesh) : std::vector<glm::vec4>();
        for (std::size_t v = 0; v < count; ++v) {
            StageVertex vertex;
            vertex.position_m = sane(mesh.positions[v]);
            vertex.normal = to_signed(glm::vec4(image::unit_or(mesh.normals[v], facets[v]), 0.0f));
            const glm::vec4 tangent = !bumps ? glm::vec4(0) : has_tangents ? mesh.tangents[v] : tangents[v];
            vertex.tangent = to_signed(glm::vec4(image::unit_or(glm::vec3(tangent), glm::vec3(0.0f)),
                                                 tangent.w < 0.0f ? -1.0f : 1.0f));
            if (textured) vertex.uv = {sane(mesh.uvs[v].x, 0.0f), sane(mesh.uvs[v].y, 0.0f)};
            vertices.push_back(vertex);
        }
    }
    CHECK(vertices.size() < std::numeric_limits<std::int32_t>::max() &&
          indices.size() < std::numeric_limits<std::uint32_t>::max());
    vertices_ = gpu::Buffer(device_, vertices.size() * sizeof(StageVertex), gpu::Access::device);
    vertices_.write(vertices);
    indices_ = gpu::Buffer(device_, indices.size() * sizeof(std::uint32_t), gpu::Access::device);
    indices_.write(indices);
}

void StageModel::add_levels(const scene::Mesh& mesh, const std::vector<glm::vec3>& facets, Mesh& made,
                            std::vector<std::uint32_t>& indices) const {
    std::vector<glm::vec3> positions_m, normals;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        positions_m.push_back(sane(mesh.positions[v]));
        normals.push_back(image::unit_or(mesh.normals[v], facets[v]));
    }
    const bool is_textured =
        surfaces_[made.surface].textures != 0 && mesh.uvs.size() == mesh.positions.size();
    std::vector<glm::vec2> uvs;
    if (is_textured)
        for (const glm::vec2& uv : mesh.uvs) uvs.emplace_back(sane(uv.x, 0.0f), sane(uv.y, 0.0f));
    const std::span whole(indices.data() + made.range.first_index, made.range.index_count);
    for (const DetailLevel& level : detail_levels(positions_m, normals, uvs, whole)) {
        const auto first = static_cast<std::uint32_t>(indices.size());
        made.levels.push_back(
            {{first, static_cast<std::uint32_t>(level.indices.size()), made.range.first_vertex},
             level.error_m});
        indices.insert(indices.end(), level.indices.begin(), level.indices.end());
    }
}

void StageModel::add_instances(const scene::Stage& stage, Report& report) {
    for (const scene::Instance& instance : stage.instances) {
        Instance made;
        made.body = instance.fixture != scene::kNone;
        const bool known = instance.mesh >= 0 && instance.mesh < static_cast<int>(meshes_.size());
        if (known && placeable(instance.world)) {
            made.world = instance.world;
            made.usable = true;
        } else {
            report.add(Severity::warning, instance.name,
                       known ? "the matrix of this instance is flat or not finite: it is not drawn"
                             : "the instance has no mesh: it is not drawn");
        }
        if (known) {
            made.mesh = static_cast<std::size_t>(instance.mesh);
            meshes_[made.mesh].instances.push_back(instances_.size());
        }
        instances_.push_back(made);
    }
}

void StageModel::show(std::size_t instance, bool shown) {
    CHECK(instance < instances_.size());
    if (!instances_[instance].moving && instances_[instance].shown != shown) ++still_revision_;
    instances_[instance].shown = shown;
}

void StageModel::move(std::size_t instance, const glm::mat4& world) {
    CHECK(instance < instances_.size());
    Instance& moved = instances_[instance];
    const bool usable = placeable(world);
    if (!usable && moved.usable)
        log_warning("instance " + std::to_string(instance) +
                    " was moved by a matrix that is flat or not finite: it is not drawn");
    if (!moved.moving && (moved.usable != usable || moved.world != world)) ++still_revision_;
    moved.usable = usable;
    if (usable) moved.world = world;
}

void StageModel::set_glow(std::size_t instance, float cd_m2) {
    CHECK(instance < instances_.size());
    if (std::exchange(instances_[instance].glow_cd_m2, cd_m2) != cd_m2 && !instances_[instance].moving)
        ++still_revision_;
}

void StageModel::set_material(std::size_t material, const scene::Material& values) {
    for (Surface& surface : surfaces_)
        if (surface.made_from == material) set_values(values, surface.material);
    ++still_revision_;
    upload_materials();
}

void StageModel::mark_moving(std::size_t instance) {
    CHECK(instance < instances_.size());
    if (std::exchange(instances_[instance].moving, true)) return;
    ++still_revision_;
    moving_.push_back(instance);
    std::sort(moving_.begin(), moving_.end(), [&](std::size_t a, std::size_t b) {
        const std::size_t mesh_a = instances_[a].mesh, mesh_b = instances_[b].mesh;
        return std::tuple(surface_of(mesh_a).alpha, mesh_a, a) <
               std::tuple(surface_of(mesh_b).alpha, mesh_b, b);
    });
}

void StageModel::upload_materials() {
    constexpr std::uint64_t kAlign = 256; // of a uniform buffer's offset, at most, on every device
    static_assert(sizeof(shared::MeshMaterial) <= kAlign);
    std::vector<std::uint8_t> bytes(surfaces_.size() * kAlign);
    for (std::size_t k = 0; k < surfaces_.size(); ++k) {
        surfaces_[k].offset = k * kAlign;
        std::memcpy(bytes.data() + surfaces_[k].offset, &surfaces_[k].material, sizeof(shared::MeshMaterial));
    }
    materials_ = gpu::Buffer(device_, bytes.size(), gpu::Access::device);
    materials_.write(bytes);
}

bool StageModel::place(const Instance& instance, const glm::vec3& eye_m, const std::vector<glm::vec4>& planes,
                       MovingDraw& placed) const {
    if (!instance.shown || !instance.usable) return false;
    const Mesh& mesh = meshes_[instance.mesh];
    if (mesh.range.index_count == 0) return false;
    placed.draw = {instance.mesh, 0.0f, 0, instance.world, instance.glow_cd_m2};
    placed.draw.to_eye[3] -= glm::vec4(eye_m, 0.0f);
    std::array<glm::vec3, 8>& corners = placed.corners_m;
    glm::vec3 centre(0.0f);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::vec3 corner((k & 1) ? mesh.high_m.x : mesh.low_m.x, (k & 2) ? mesh.high_m.y : mesh.low_m.y,
                               (k & 4) ? mesh.high_m.z : mesh.low_m.z);
        corners[k] = glm::vec3(placed.draw.to_eye * glm::vec4(corner, 1.0f));
        centre += corners[k] * 0.125f;
    }
    const bool outside = std::any_of(planes.begin(), planes.end(), [&](const glm::vec4& plane) {
        return std::all_of(corners.begin(), corners.end(), [&](const glm::vec3& corner) {
            return glm::dot(glm::vec3(plane), corner) + plane.w < 0.0f;
        });
    });
    placed.draw.near_m = sane(glm::length(centre) - glm::length(corners[0] - corners[7]) * 0.5f, 0.0f);
    return !outside;
}

std::size_t StageModel::level_for(const Draw& draw, float most_error_rad) const {
    const glm::mat3 axes(draw.to_eye);
    const float scale = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
    const std::vector<Level>& levels = meshes_[draw.mesh].levels;
    std::size_t level = 0;
    while (level < levels.size() && levels[level].error_m * scale < most_error_rad * draw.near_m) ++level;
    return level;
}

std::vector<StageModel::MovingDraw> StageModel::visible_moving(const glm::vec3& eye_m,
                                                               const std::vector<glm::vec4>& planes,
                                                               float pixels_per_rad) const {
    std::vector<MovingDraw> draws;
    for (const std::size_t index : moving_) {
        MovingDraw placed;
        placed.instance = index;
        if (!place(instances_[index], eye_m, planes, placed)) continue;
        // Those whose textures cover them stay as they are: these would slide at rest.
        if (surface_of(placed.draw.mesh).textures == 0)
            placed.draw.level = level_for(placed.draw, kMostError_px / pixels_per_rad);
        draws.push_back(placed);
    }
    return draws;
}

std::vector<StageModel::Draw> StageModel::visible(const glm::vec3& eye_m,
                                                  const std::vector<glm::vec4>& planes,
                                                  float most_error_rad) const {
    std::vector<std::vector<Draw>> groups;
    for (const Mesh& mesh : meshes_) {
        std::vector<Draw> group;
        for (const std::size_t index : mesh.instances) {
            MovingDraw placed;
            if (instances_[index].moving || !place(instances_[index], eye_m, planes, placed)) continue;
            if (most_error_rad > 0) placed.draw.level = level_for(placed.draw, most_error_rad);
            group.push_back(placed.draw);
        }
        if (group.empty()) continue;
        std::stable_sort(group.begin(), group.end(),
                         [](const Draw& a, const Draw& b) { return a.near_m < b.near_m; });
        groups.push_back(std::move(group));
    }
    std::stable_sort(groups.begin(), groups.end(), [&](const auto& a, const auto& b) {
        const std::uint32_t alpha_a = surface_of(a[0].mesh).alpha;
        const std::uint32_t alpha_b = surface_of(b[0].mesh).alpha;
        return alpha_a != alpha_b ? alpha_a < alpha_b : a[0].near_m < b[0].near_m;
    });
    std::vector<Draw> draws;
    for (const std::vector<Draw>& group : groups) draws.insert(draws.end(), group.begin(), group.end());
    return draws;
}

std::vector<StageModel::Solid> StageModel::solids() const {
    std::vector<Solid> solids;
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
        const Mesh& mesh = meshes_[m];
        if (mesh.range.index_count == 0) continue;
        const glm::vec3 middle_m = 0.5f * (mesh.low_m + mesh.high_m), half_m = mesh.high_m - middle_m;
        for (const std::size_t index : mesh.instances) {
            const Instance& instance = instances_[index];
            if (instance.body || !instance.shown || !instance.usable) continue;
            const glm::mat4& world = instance.world;
            const glm::vec3 at_m(world * glm::vec4(middle_m, 1.0f));
            const glm::vec3 reach_m = glm::abs(glm::vec3(world[0])) * half_m.x +
                                      glm::abs(glm::vec3(world[1])) * half_m.y +
                                      glm::abs(glm::vec3(world[2])) * half_m.z;
            solids.push_back({m, world, at_m - reach_m, at_m + reach_m});
        }
    }
    return solids;
}

std::uint64_t StageModel::memory_bytes() const {
    std::uint64_t sum = vertices_.bytes() + indices_.bytes() + materials_.bytes();
    for (const gpu::Texture& texture : textures_) sum += texture.bytes();
    return sum;
}

std::size_t StageModel::drawn_triangles() const {
    std::size_t sum = 0;
    for (const Mesh& mesh : meshes_)
        for (const std::size_t index : mesh.instances)
            if (instances_[index].shown && instances_[index].usable) sum += mesh.range.index_count / 3;
    return sum;
}

} // namespace ghost::render
