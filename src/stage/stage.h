#pragma once
// SPDX-License-Identifier: Apache-2.0
// Stage: the geometry of a show, ready for the baker and the renderer. Metres, right-handed, Z up, X right
// seen from the house, Y up-stage. Colours linear Rec.2020. Meshes are stored once and placed by instances.
// Plain values.

#include "image/image.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

inline constexpr int kNone = -1;

struct Texture {
    std::string name;
    image::Image8 pixels;  // RGBA
    bool is_colour = true; // sRGB-encoded Rec.709 (base colour, emission); false: data (normals, roughness)
};

enum class AlphaMode { opaque, mask, blend };

struct Material {
    std::string name;
    glm::vec3 base_colour{0.8f};
    float alpha = 1.0f;
    float roughness = 1.0f;
    float metalness = 0.0f;
    float specular = 1.0f; // strength of the dielectric reflection (KHR_materials_specular); 0: pure Lambert
    glm::vec3 emission{0.0f};    // cd/m^2
    int base_texture = kNone;    // times base_colour; its alpha times alpha
    int normal_texture = kNone;  // tangent space, +Y up (glTF)
    int surface_texture = kNone; // green: roughness, blue: metalness (glTF), times the factors
    int emission_texture = kNone;
    float normal_scale = 1.0f;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = true;
};

struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;     // as many as positions
    std::vector<glm::vec4> tangents;    // as many as positions, or none; w: handedness
    std::vector<glm::vec2> uvs;         // as many as positions, or none; v down (glTF)
    std::vector<std::uint32_t> indices; // triangles
    int material = 0;
};

struct Instance {
    std::string name;
    int mesh = 0;
    glm::mat4 world{1.0f};
    int fixture = kNone; // index into Show::fixtures when it is part of a fixture's body: that fixture's own
                         // light passes
    bool shown = true;   // hidden ones are kept so that they can be shown again; scene::visible drops them
    int part = kNone;    // of a fixture's body: index into fixture::Mode::parts and State::parts
    glm::mat4 to_part{1.0f}; // from the mesh to the frame of that part
    std::string layer;       // of the plot that has it; "": of none
};

struct Stage {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;

    std::size_t stored_triangles() const;
    std::size_t drawn_triangles() const; // instances counted
};

} // namespace ghost::scene
