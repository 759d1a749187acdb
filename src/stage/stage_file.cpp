// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"
#include "fixture_files/common/mesh_check.h"
#include "image/finite.h"
#include "json_xml_toml/xml_encoding.h"
#include "stage/gltf_pack.h"
#include "stage/model_file.h"
#include "stage/model_reader.h"
#include "stage/private/mtl.h"
#include "stage/stage_checks.h"

#include <assimp/BaseImporter.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxInstances = 1'000'000;

// (x, y, z) with Y up -> (x, -z, y) with Z up.
const glm::mat4 kToZUp({1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1});

glm::mat4 matrix_from(const aiMatrix4x4& m) {
    return {{m.a1, m.b1, m.c1, m.d1},
            {m.a2, m.b2, m.c2, m.d2},
            {m.a3, m.b3, m.c3, m.d3},
            {m.a4, m.b4, m.c4, m.d4}};
}

bool usable(const glm::mat4& matrix) {
    const float determinant = glm::determinant(glm::mat3(matrix));
    return image::is_finite(matrix) && std::isfinite(determinant) && determinant != 0.0f;
}

// Node tree -> instances. kept[mesh of the file] is the mesh of the stage, or kNone.
void add_instances(const aiNode* root, const std::vector<int>& kept, const std::string& name, Stage& stage,
                   Report& report) {
    struct Entry {
        const aiNode* node;
        glm::mat4 parent;
    };
    std::vector<Entry> open{{root, kToZUp}};
    std::vector<std::string> flat;
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        const glm::mat4 world = parent * matrix_from(node->mTransformation);
        for (unsigned k = node->mNumChildren; k > 0; --k) open.push_back({node->mChildren[k - 1], world});
        for (unsigned k = 0; k < node->mNumMeshes; ++k) {
            const int mesh = node->mMeshes[k] < kept.size() ? kept[node->mMeshes[k]] : kNone;
            if (mesh == kNone) continue;
            if (usable(world))
                stage.instances.push_back({node->mName.C_Str(), mesh, world, kNone});
            else
                flat.emplace_back(node->mName.C_Str());
        }
    }
    if (!flat.empty())
        report.add(Severity::error, name,
                   "objects whose placement is not a number or has no volume are left out: " +
                       name_list(flat));
}

Result<Stage> convert(const aiScene& scene, const GltfExtras& extras, const std::string& name,
                      const ReadCompanion& read_companion, Report& report) {
    Stage stage;
    add_materials(scene, extras.materials, name, read_companion, stage, report);
    std::vector<int> kept;
    for (unsigned k = 0; k < scene.mNumMeshes; ++k) {
        Mesh mesh = mesh_from(*scene.mMeshes[k]);
        mesh.material = std::clamp(mesh.material, 0, static_cast<int>(stage.materials.size()) - 1);
        kept.push_back(mesh.indices.empty() ? kNone : static_cast<int>(stage.meshes.size()));
        if (!mesh.indices.empty()) stage.meshes.push_back(std::move(mesh));
    }
    add_instances(scene.mRootNode, kept, name, stage, report);
    if (stage.instances.size() > kMaxInstances || stage.drawn_triangles() > kMaxDrawnTriangles)
        return Error{"draws " + std::to_string(stage.drawn_triangles()) + " triangles in " +
                         std::to_string(stage.instances.size()) +
                         " objects, more than the limit of 20 million in 1 million",
                     name};
    if (stage.instances.empty()) return Error{"has no object with triangles", name};
    check_geometry(stage, name, report);
    return stage;
}

// What Assimp reads: the model, and what it refers to, by way of read_companion. Never a file of the system.
class MemoryFiles : public Assimp::IOSystem {
public:
    MemoryFiles(std::string name, Bytes model, const ReadCompanion& read_companion)
        : name_(std::move(name)), model_(model), read_companion_(read_companion) {}

    Assimp::IOStream* Open(const char* file, const char*) override {
        if (file == name_) return stream(model_);
        if (const auto known = companions_.find(file); known != companions_.end())
            return stream(known->second);
        auto read = read_companion_(file);
        if (!read.ok()) {
            lost_.insert(file);
            return nullptr;
        }
        if (lower(std::filesystem::path(name_).extension().string()) == ".obj")
            *read = mtl_for_assimp(*read); // no other files of an .obj are asked for
        return stream(companions_.emplace(file, std::move(*read)).first->second);
    }
    bool Exists(const char* file) const override { return file == name_ || companions_.contains(file); }
    char getOsSeparator() const override { return '/'; }
    void Close(Assimp::IOStream* file) override { delete file; }
    const std::set<std::string>& lost() const { return lost_; }

private:
    static Assimp::IOStream* stream(Bytes bytes) {
        return new Assimp::MemoryIOStream(bytes.data(), bytes.size());
    }

    std::string name_;
    Bytes model_;
    const ReadCompanion& read_companion_;
    std::map<std::string, std::vector<std::uint8_t>> companions_;
    std::set<std::string> lost_;
};

// Where a file is none of the format that its name says, Assimp looks through all it has, which are dozens
// that nobody here has ever looked at.
void keep_one_loader(Assimp::Importer& importer, const std::string& format) {
    const std::string kept = format == "3ds"   ? "Discreet 3DS Importer"
                             : format == "obj" ? "Wavefront Object Importer"
                                               : "glTF2 Importer";
    for (std::size_t k = importer.GetImporterCount(); k-- > 0;) {
        std::unique_ptr<Assimp::BaseImporter> other(importer.GetImporter(k));
        if (other->GetInfo()->mName == kept)
            (void)other.release();
        else
            importer.UnregisterLoader(other.get());
    }
}

// As a glTF binary that Assimp reads without harm; nothing where it already is one. lost: see
// without_unsafe_faces().
Result<std::vector<std::uint8_t>> made_safe(Bytes gltf, bool is_binary, const std::string& name,
                                            const ReadCompanion& read_companion, std::size_t& lost) {
    const std::string_view json =
        is_binary ? json_of_glb(gltf)
                  : std::string_view(reinterpret_cast<const char*>(gltf.data()), gltf.size());
    // What is looked at here must be what Assimp reads, which does not look at encodings.
    std::vector<std::uint8_t> letters(json.begin(), json.end());
    const bool was_utf8 = !fixture::repair_utf8(letters);
    std::string text(letters.begin(), letters.end());
    TRY_VOID(check_gltf_size(text, name));
    TRY(std::string safe, without_unsafe_faces(text, name, lost));
    if (safe.empty() && was_utf8 && is_binary) return std::vector<std::uint8_t>{};
    if (safe.empty()) safe = std::move(text);
    if (is_binary) return glb_with_json(gltf, std::move(safe));
    return glb_from_gltf(Bytes(reinterpret_cast<const std::uint8_t*>(safe.data()), safe.size()), name,
                         read_companion);
}

// Materials of an .obj are looked for under its own name, too.
std::string name_for_assimp(const std::string& format, const std::string& name) {
    return format == "obj" ? std::filesystem::path(name).stem().string() + ".obj" : "the file." + format;
}

} // namespace

Result<Stage> read_model(Bytes bytes, const std::string& extension, const std::string& name, Report& report,
                         const ReadCompanion& read_companion) {
    std::string format = lower(extension);
    const bool is_gltf = format == "glb" || format == "gltf";
    std::vector<std::uint8_t> repaired;
    if (format == "glb") {
        TRY_VOID(check_glb(bytes, name));
        if (const std::size_t count = replace_non_numbers(bytes, repaired)) {
            bytes = repaired;
            report.add(Severity::error, name,
                       std::to_string(count) +
                           " numbers in it are NaN or Infinity; what needs them is left out");
        }
    }
    if (is_gltf) {
        std::size_t lost = 0;
        TRY(std::vector<std::uint8_t> safe, made_safe(bytes, format == "glb", name, read_companion, lost));
        if (lost > 0)
            report.add(
                Severity::error, name,
                std::to_string(lost) +
                    " of its primitives are fans of triangles with indices, or have too few points for one "
                    "triangle: they are left out");
        if (!safe.empty()) {
            repaired = std::move(safe);
            bytes = repaired;
            format = "glb";
        }
    }
    if (format == "3ds") {
        if (std::string fault = fixture::fault_of_mesh(bytes, format); !fault.empty())
            return Error{std::move(fault), name};
        if (const std::size_t beyond = fixture::count_triangles_beyond_3ds(bytes))
            report.add(
                Severity::warning, name,
                std::to_string(beyond) +
                    " triangles name vertices that their mesh does not have; its last vertex is taken");
    }
    try {
        Assimp::Importer importer;
        keep_one_loader(importer, format);
        const std::string own_name = name_for_assimp(format, name);
        auto* const files = new MemoryFiles(own_name, bytes, read_companion); // the importer's from here on
        importer.SetIOHandler(files);
        importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
        const aiScene* scene = importer.ReadFile(own_name, 0);
        for (const std::string& lost : files->lost())
            report.add(Severity::error, name,
                       "refers to " + lost + ", which is no plain file: what it says is lost");
        if (!scene || !scene->mRootNode)
            return Error{"not a readable " + format + " model: " + importer.GetErrorString(), name};
        const GltfExtras extras = format == "glb" ? gltf_extras(bytes) : GltfExtras{};
        // The importer owns the scene and hands it out const, but post-processing must not see broken
        // numbers.
        repair_meshes(const_cast<aiScene&>(*scene), extras, name, report);
        // glTF is indexed by nature; joining its vertices again costs half of the loading time.
        const unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                               (is_gltf ? 0u : aiProcess_JoinIdenticalVertices);
        scene = importer.ApplyPostProcessing(steps);
        if (!scene) return Error{std::string("cannot prepare the model: ") + importer.GetErrorString(), name};
        return convert(*scene, extras, name, read_companion, report);
    } catch (const std::exception& problem) {
        return Error{std::string("cannot read the model: ") + problem.what(), name};
    }
}

std::vector<Instance> absorb(Stage model, const glm::mat4& place, Stage& stage) {
    const auto textures = static_cast<int>(stage.textures.size());
    const auto materials = static_cast<int>(stage.materials.size());
    const auto meshes = static_cast<int>(stage.meshes.size());
    const auto shift = [&](int& texture) {
        if (texture != kNone) texture += textures;
    };
    for (Material& material : model.materials) {
        shift(material.base_texture);
        shift(material.normal_texture);
        shift(material.surface_texture);
        shift(material.emission_texture);
        stage.materials.push_back(std::move(material));
    }
    for (Mesh& mesh : model.meshes) {
        mesh.material += materials;
        stage.meshes.push_back(std::move(mesh));
    }
    for (Texture& texture : model.textures) stage.textures.push_back(std::move(texture));
    std::vector<Instance> parts;
    for (const Instance& instance : model.instances)
        parts.push_back({instance.name, instance.mesh + meshes, place * instance.world, kNone});
    return parts;
}

} // namespace ghost::scene
