// SPDX-License-Identifier: Apache-2.0
#include "scene/model_file.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <cmath>
#include <utility>

namespace ghost::scene {
namespace {

// Beyond this, in whatever unit, it is damage, and its square no float.
constexpr float kFarthest = 1e15f;

bool finite(const aiVector3D& v) {
    return std::abs(v.x) <= kFarthest && std::abs(v.y) <= kFarthest && std::abs(v.z) <= kFarthest;
}

glm::vec3 vec3_from(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

// Returns how many faces were removed.
unsigned remove_broken_faces(aiMesh& mesh) {
    unsigned kept = 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        bool good = face.mNumIndices > 0;
        for (unsigned k = 0; k < face.mNumIndices && good; ++k)
            good = face.mIndices[k] < mesh.mNumVertices && finite(mesh.mVertices[face.mIndices[k]]);
        if (!good) continue;
        if (kept != f) {
            std::swap(mesh.mFaces[kept].mIndices, mesh.mFaces[f].mIndices);
            std::swap(mesh.mFaces[kept].mNumIndices, mesh.mFaces[f].mNumIndices);
        }
        ++kept;
    }
    const unsigned removed = mesh.mNumFaces - kept;
    mesh.mNumFaces = kept;
    return removed;
}

bool has_usable_normals(const aiMesh& mesh) {
    if (!mesh.mNormals) return false;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
        if (!finite(mesh.mNormals[v]) || mesh.mNormals[v].SquareLength() < 1e-12f) return false;
    return true;
}

// Of each mesh the first object that shows it, by which the model's maker knows it; else the mesh's own.
std::vector<std::string> object_names(const aiScene& scene) {
    std::vector<std::string> names(scene.mNumMeshes);
    std::vector<const aiNode*> open{scene.mRootNode};
    while (!open.empty()) {
        const aiNode& node = *open.back();
        open.pop_back();
        for (unsigned k = node.mNumChildren; k > 0; --k) open.push_back(node.mChildren[k - 1]);
        for (unsigned k = 0; k < node.mNumMeshes; ++k)
            if (const unsigned m = node.mMeshes[k]; m < names.size() && names[m].empty())
                names[m] = node.mName.C_Str();
    }
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        if (names[m].empty()) names[m] = scene.mMeshes[m]->mName.C_Str();
    return names;
}

template <class T>
void drop(T*& array) {
    delete[] array;
    array = nullptr;
}

} // namespace

std::string name_list(const std::vector<std::string>& names) {
    constexpr std::size_t kShown = 5;
    std::string text;
    for (std::size_t k = 0; k < names.size() && k < kShown; ++k) {
        if (k > 0) text += ", ";
        text += "'" + names[k].substr(0, 80) + "'";
    }
    if (names.size() > kShown) text += " and " + std::to_string(names.size() - kShown) + " more";
    return text;
}

void repair_meshes(aiScene& scene, const GltfExtras& extras, const std::string& name, Report& report) {
    const std::vector<std::string> objects = object_names(scene);
    std::vector<std::string> without_normals;
    std::vector<std::string> broken_uvs;
    std::vector<std::string> with_lines;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        aiMesh& mesh = *scene.mMeshes[m];
        const std::string& object = objects[m];
        const auto declared = extras.triangles.find(mesh.mName.C_Str());
        const std::size_t dropped = declared != extras.triangles.end() && declared->second > mesh.mNumFaces
                                        ? declared->second - mesh.mNumFaces
                                        : 0;
        if (const std::size_t removed = remove_broken_faces(mesh) + dropped; removed > 0)
            report.add(Severity::error, name,
                       "object '" + object + "': " + std::to_string(removed) +
                           " faces have vertices that do not exist, are not numbers or are farther than "
                           "1e15; they are left out");
        for (unsigned v = 0; v < mesh.mNumVertices;
             ++v) // no face uses them any more, but smoothing sorts them
            if (!finite(mesh.mVertices[v])) mesh.mVertices[v] = aiVector3D();
        if (!has_usable_normals(mesh)) {
            drop(mesh.mNormals);
            drop(mesh.mTangents);
            drop(mesh.mBitangents);
            if (mesh.mNumFaces > 0 && (mesh.mPrimitiveTypes & ~3u)) without_normals.push_back(object);
        }
        bool broken = false;
        for (unsigned v = 0; mesh.mTextureCoords[0] && v < mesh.mNumVertices; ++v) {
            if (finite(mesh.mTextureCoords[0][v])) continue;
            mesh.mTextureCoords[0][v] = aiVector3D();
            broken = true;
        }
        if (broken) broken_uvs.push_back(object);
        if (mesh.mPrimitiveTypes & (aiPrimitiveType_POINT | aiPrimitiveType_LINE))
            with_lines.push_back(object);
    }
    if (!without_normals.empty())
        report.add(Severity::note, name,
                   "objects without normals get smooth ones: " + name_list(without_normals));
    if (!broken_uvs.empty())
        report.add(Severity::warning, name,
                   "objects with texture coordinates that are not numbers: " + name_list(broken_uvs));
    if (!with_lines.empty())
        report.add(Severity::note, name,
                   "points and lines cast no shadow and are left out: " + name_list(with_lines));
}

Mesh mesh_from(const aiMesh& source) {
    Mesh mesh;
    mesh.name = source.mName.C_Str();
    mesh.material = static_cast<int>(source.mMaterialIndex);
    if (!source.mNormals || !(source.mPrimitiveTypes & aiPrimitiveType_TRIANGLE)) return mesh;
    mesh.indices.reserve(std::size_t{3} * source.mNumFaces);
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
        const aiFace& face = source.mFaces[f];
        if (face.mNumIndices != 3) continue;
        mesh.indices.insert(mesh.indices.end(), face.mIndices, face.mIndices + 3);
    }
    const bool has_uvs = source.mTextureCoords[0] != nullptr;
    const bool has_tangents = source.mTangents && source.mBitangents;
    for (unsigned v = 0; v < source.mNumVertices; ++v) {
        mesh.positions.push_back(vec3_from(source.mVertices[v]));
        // A vertex that only degenerate triangles use has no normal; any one will do.
        const glm::vec3 normal = vec3_from(source.mNormals[v]);
        const float length = glm::length(normal);
        mesh.normals.push_back(length > 1e-6f ? normal / length : glm::vec3(0, 1, 0));
        // Assimp's v points up.
        if (has_uvs)
            mesh.uvs.emplace_back(source.mTextureCoords[0][v].x, 1.0f - source.mTextureCoords[0][v].y);
        if (has_tangents) {
            const glm::vec3 tangent = vec3_from(source.mTangents[v]);
            const glm::vec3 bitangent = vec3_from(source.mBitangents[v]);
            const bool usable =
                std::isfinite(glm::dot(tangent, tangent)) && glm::dot(tangent, tangent) > 1e-12f;
            const float hand =
                glm::dot(glm::cross(mesh.normals.back(), tangent), bitangent) < 0.0f ? -1.0f : 1.0f;
            mesh.tangents.push_back(usable ? glm::vec4(glm::normalize(tangent), hand)
                                           : glm::vec4(1, 0, 0, 1));
        }
    }
    return mesh;
}

} // namespace ghost::scene
