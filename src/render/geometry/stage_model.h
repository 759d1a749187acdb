#pragma once
// SPDX-License-Identifier: Apache-2.0
// StageModel: a scene::Stage on the device, to be drawn from anywhere. Meshes once, instances as a list that
// may be hidden and moved, textures with mip levels. Instances that move all the time are marked, so that the
// others need not be drawn again (GBuffer::update). World metres. What cannot be drawn (a matrix that is not
// finite, indices without vertices) is left out and reported by name. Main thread; the device must outlive
// it, the stage need not.

#include "base/report.h"
#include "gpu/buffer.h"
#include "gpu/raster.h"
#include "gpu/texture.h"
#include "render/geometry/mip_levels.h"
#include "shared/g_buffer.h"
#include "stage/stage.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

namespace ghost::render {

// As the vertex shader reads it: signed normalised 16 bit for directions.
struct StageVertex {
    glm::vec3 position_m{0};
    std::array<std::int16_t, 4> normal{};
    std::array<std::int16_t, 4> tangent{}; // w: handedness
    glm::vec2 uv{0};
};

class StageModel {
public:
    static constexpr std::uint64_t kTextureBytes = std::uint64_t{1}
                                                   << 30; // at most, or a quarter of the device

    static constexpr std::uint64_t kMeshBytes = std::uint64_t{8} << 30; // far below what indices count

    // texture_bytes: larger textures lose their finest levels until all fit; a line of warning says so.
    // mesh_bytes: of all meshes; those for which there are too few left are left out, and said.
    StageModel(const gpu::Device& device, const scene::Stage& stage, Report& report,
               std::uint64_t texture_bytes = kTextureBytes, std::uint64_t mesh_bytes = kMeshBytes);

    // instance: index into Stage::instances.
    void show(std::size_t instance, bool shown);
    void move(std::size_t instance, const glm::mat4& world);
    // Light that it sends out in every direction, beside its material's.
    void set_glow(std::size_t instance, float cd_m2);
    // material: index into Stage::materials. Its textures and its way of being transparent stay.
    void set_material(std::size_t material, const scene::Material& values);
    // Moving it is cheap from now on.
    void mark_moving(std::size_t instance);
    bool has_moving() const { return !moving_.empty(); }
    // Another number whenever one of the other instances was hidden, shown, moved, lit or marked, or a
    // material changed, and in every model.
    std::uint64_t still_revision() const { return still_revision_; }

    std::uint64_t memory_bytes() const;  // on the device
    std::size_t drawn_triangles() const; // of the instances shown
    std::size_t instance_count() const { return instances_.size(); }

    // An instance that reaches into a view.
    struct Draw {
        std::size_t mesh = 0;
        float near_m = 0;       // of its nearest corner, about
        std::size_t level = 0;  // of detail, see range(); 0: all of it
        glm::mat4 to_eye{1.0f}; // from the mesh to the world, moved so that the eye is the origin
        float glow_cd_m2 = 0;
    };
    // planes: of the view (normal inwards, offset), with the eye as origin. Without the moving ones. Opaque,
    // then masked, then blended; mesh after mesh and each nearest first. most_error_rad: surfaces may be off
    // by that much as seen from there, at a level of detail.
    std::vector<Draw> visible(const glm::vec3& eye_m, const std::vector<glm::vec4>& planes,
                              float most_error_rad = 0) const;

    struct MovingDraw {
        std::size_t instance = 0;
        Draw draw;
        std::array<glm::vec3, 8> corners_m{}; // of its box, with the eye as origin
    };
    // The moving ones, in an order that never changes. Bodies of fixtures at a level of detail that depends
    // on where they are and on nothing else: at rest it is the same one.
    std::vector<MovingDraw> visible_moving(const glm::vec3& eye_m, const std::vector<glm::vec4>& planes,
                                           float pixels_per_rad) const;

    // An instance that stops light: one that is shown and no body of a fixture.
    struct Solid {
        std::size_t mesh = 0;
        glm::mat4 world{1.0f};
        glm::vec3 low_m{0}; // of its box in the world
        glm::vec3 high_m{0};
    };
    std::vector<Solid> solids() const; // mesh after mesh
    const gpu::DrawRange& whole(std::size_t mesh) const { return meshes_[mesh].range; }

    struct Surface {
        std::size_t made_from = 0; // Stage::materials
        shared::MeshMaterial material{};
        std::uint64_t offset = 0; // into materials()
        std::uint32_t alpha = shared::kOpaque;
        std::uint32_t textures = 0;           // bits, see shared/g_buffer.h
        std::array<std::size_t, 4> texture{}; // base, normal, surface, emission: index for texture()
    };
    const Surface& surface_of(std::size_t mesh) const { return surfaces_[meshes_[mesh].surface]; }
    const gpu::Texture& texture(std::size_t index) const { return textures_[index]; }
    const gpu::DrawRange& range(const Draw& draw) const {
        const Mesh& mesh = meshes_[draw.mesh];
        return draw.level == 0 ? mesh.range : mesh.levels[draw.level - 1].range;
    }
    const gpu::Buffer& materials() const { return materials_; }
    const gpu::Buffer& vertices() const { return vertices_; }
    const gpu::Buffer& indices() const { return indices_; }

private:
    struct Level {
        gpu::DrawRange range;
        float error_m = 0;
    };
    struct Mesh {
        gpu::DrawRange range;
        std::vector<Level> levels; // coarser ones, finest first
        glm::vec3 low_m{0};        // of the mesh's own box
        glm::vec3 high_m{0};
        std::size_t surface = 0;
        std::vector<std::size_t> instances; // usable ones
    };
    struct Instance {
        glm::mat4 world{1.0f};
        std::size_t mesh = 0;
        float glow_cd_m2 = 0;
        bool shown = true;
        bool usable = false;
        bool moving = false;
        bool body = false; // of a fixture
    };
    // False: it does not reach into the view.
    bool place(const Instance& instance, const glm::vec3& eye_m, const std::vector<glm::vec4>& planes,
               MovingDraw& placed) const;
    // Of a material: base, normal, surface, emission; negative: none. And how one of these slots is read.
    static std::array<int, 4> textures_of(const scene::Material& material);
    static TextureUse use_of(const scene::Stage& stage, int texture, std::size_t slot);
    void add_textures(const scene::Stage& stage, Report& report, std::uint64_t texture_bytes);
    void add_surfaces(const scene::Stage& stage);
    void add_meshes(const scene::Stage& stage, Report& report, std::uint64_t mesh_bytes);
    // Appends the levels of detail of a mesh that is in the indices; facets: normals for where one is none.
    void add_levels(const scene::Mesh& mesh, const std::vector<glm::vec3>& facets, Mesh& made,
                    std::vector<std::uint32_t>& indices) const;
    std::size_t level_for(const Draw& draw, float most_error_rad) const;
    void upload_materials();
    void add_instances(const scene::Stage& stage, Report& report);

    const gpu::Device& device_;
    std::vector<Mesh> meshes_;
    std::vector<Instance> instances_;
    std::vector<std::size_t> moving_; // by alpha, mesh, instance
    std::uint64_t still_revision_;
    std::vector<Surface> surfaces_;
    std::vector<gpu::Texture> textures_;                           // 0: white
    std::map<std::pair<int, TextureUse>, std::size_t> texture_of_; // by texture of the scene
    gpu::Buffer vertices_, indices_, materials_;
};

} // namespace ghost::render
