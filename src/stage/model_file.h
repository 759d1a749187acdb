#pragma once
// SPDX-License-Identifier: Apache-2.0
// Model files (GLB, glTF, 3DS, OBJ) into a Stage, through Assimp. Each mesh is stored once, nodes become
// instances, Y up becomes Z up, Rec.709 becomes Rec.2020. Nothing here is for users of the scene: they call
// load_model and load_stage_file, which read in a process apart.

#include "base/byte_reader.h"
#include "base/report.h"
#include "base/result.h"
#include "json_xml_toml/json.h"
#include "stage/stage.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

struct aiMesh;
struct aiScene;

namespace ghost::scene {

// A file that a model refers to, by the name that it uses: pictures, buffers, materials. Called from one
// thread at a time.
using ReadCompanion = std::function<Result<std::vector<std::uint8_t>>(const std::string& name)>;

// In this process, which a fault of Assimp's may end. extension: "glb", "3ds", ... without the dot. name: for
// messages. Opens no file. Error: unreadable, cut short, nothing to draw, over the limits; smaller losses go
// to the report.
Result<Stage> read_model(Bytes bytes, const std::string& extension, const std::string& name, Report& report,
                         const ReadCompanion& read_companion);

// Moves all of a model into the stage; what comes back are its instances there, each placed by `place`, not
// yet part of the stage.
std::vector<Instance> absorb(Stage model, const glm::mat4& place, Stage& stage);

// glTF binary: header and chunk lengths against the size of the file. Error: cut short, or no glTF 2.0
// binary.
Result<void> check_glb(Bytes bytes, const std::string& name);

// Its JSON; empty where the first chunk is none. glb: as check_glb() lets it through.
std::string_view json_of_glb(Bytes glb);

// Exporters nest what they add of their own deeper than others nest their files.
inline constexpr JsonLimits kGltfJson{
    .bytes = std::size_t{1} << 30, .values = 8u << 20, .members = 65536, .depth = 128};

// Primitive modes of glTF 2.0, section 3.7.2.1.
inline constexpr std::size_t kGltfTriangles = 4, kGltfTriangleStrip = 5;

// What a glTF's JSON asks for, before anything is made of it: 4 Mi things 128 deep, 200,000 nodes of a scene
// 256 deep, 1 GiB of unpacked vertices and triangles, each as often as it is used. Error: over one of these,
// or nodes that hold themselves, or sparse
// values that are not there.
Result<void> check_gltf_size(std::string_view json, const std::string& name);

// Exporters write NaN and Infinity, which JSON does not have, and for which a parser gives up the whole file.
// Returns how many there are; where there are any, `repaired` is the file with numbers beyond every float in
// their place, which are found again where they are used. glb: as check_glb() lets it through.
std::size_t replace_non_numbers(Bytes glb, std::vector<std::uint8_t>& repaired);

// The same glTF with lines, fans with indices, and strips and fans of fewer than three points made points,
// which nothing draws: Assimp reads beyond its memory for them. Empty where nothing had to be done. lost:
// primitives with triangles among these. Error: is no JSON.
Result<std::string> without_unsafe_faces(std::string_view json, const std::string& name, std::size_t& lost);

// A glTF binary with another JSON in its first chunk. glb: as check_glb() lets it through.
std::vector<std::uint8_t> glb_with_json(Bytes glb, std::string json);

// Triangles of one mesh; no indices where nothing is left of it.
Mesh mesh_from(const aiMesh& source);

// What Assimp 5.2 does not know of a glTF material.
struct GltfMaterialExtras {
    float emissive_strength = 1.0f; // KHR_materials_emissive_strength
    float specular = 1.0f;          // KHR_materials_specular: specularFactor
};
struct GltfExtras {
    std::vector<GltfMaterialExtras> materials; // in the order of the file
    // Triangles that a mesh should have, by Assimp's name for it; names that are not unique are left out.
    // Assimp drops triangles with wrong indices without a word.
    std::map<std::string, std::size_t> triangles;
};
GltfExtras gltf_extras(Bytes glb);

// Faces with vertices that are no numbers or do not exist are removed, broken normals are thrown away (Assimp
// then makes smooth ones), broken texture coordinates become 0.
void repair_meshes(aiScene& scene, const GltfExtras& extras, const std::string& name, Report& report);

// Materials in the order of the scene's, and the textures they use, each picture once. extras may be shorter.
void add_materials(const aiScene& scene, const std::vector<GltfMaterialExtras>& extras,
                   const std::string& name, const ReadCompanion& read_companion, Stage& stage,
                   Report& report);

} // namespace ghost::scene
