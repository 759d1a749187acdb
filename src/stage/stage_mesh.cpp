// SPDX-License-Identifier: Apache-2.0
#include "base/text.h"
#include "stage/model_file.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
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

// In the surface's plane, where u grows; w: the side on which the picture's top lies.
glm::vec4 tangent_of(const glm::vec3& normal, const glm::vec3& along_u, const glm::vec3& against_v) {
    const glm::vec3 flat = along_u - normal * glm::dot(normal, along_u);
    const float length2 = glm::dot(flat, flat);
    if (!(length2 > 1e-12f) || !std::isfinite(length2)) return glm::vec4(1, 0, 0, 1);
    const float hand = glm::dot(glm::cross(normal, flat), against_v) < 0.0f ? -1.0f : 1.0f;
    return glm::vec4(flat / std::sqrt(length2), hand);
}

// The mean over the triangles at a vertex, larger angles for more. Our own, for the bitangents of Assimp 5.2
// and 5.4 have opposite signs.
void add_tangents(Mesh& mesh) {
    std::vector<glm::vec3> along_u(mesh.positions.size(), glm::vec3(0.0f));
    std::vector<glm::vec3> against_v(mesh.positions.size(), glm::vec3(0.0f));
    const auto unit = [](const glm::dvec3& v) {
        const double length = glm::length(v);
        return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
    };
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        const std::uint32_t* const corner = &mesh.indices[t];
        const glm::dvec3 p[3] = {mesh.positions[corner[0]], mesh.positions[corner[1]],
                                 mesh.positions[corner[2]]};
        const glm::dvec2 uv1(mesh.uvs[corner[1]] - mesh.uvs[corner[0]]);
        const glm::dvec2 uv2(mesh.uvs[corner[2]] - mesh.uvs[corner[0]]);
        const double side = uv1.x * uv2.y - uv1.y * uv2.x < 0 ? -1 : 1;
        const glm::dvec3 u = unit(side * ((p[1] - p[0]) * uv2.y - (p[2] - p[0]) * uv1.y));
        const glm::dvec3 v = unit(side * ((p[1] - p[0]) * uv2.x - (p[2] - p[0]) * uv1.x));
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 one = unit(p[(k + 1) % 3] - p[k]);
            const glm::dvec3 other = unit(p[(k + 2) % 3] - p[k]);
            const double angle_rad = std::acos(std::clamp(glm::dot(one, other), -1.0, 1.0));
            along_u[corner[k]] += glm::vec3(u * angle_rad);
            against_v[corner[k]] += glm::vec3(v * angle_rad);
        }
    }
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        mesh.tangents.push_back(tangent_of(mesh.normals[v], along_u[v], against_v[v]));
}

} // namespace

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
            mesh.tangents.push_back(tangent_of(mesh.normals.back(), tangent, bitangent));
        }
    }
    if (has_uvs && !has_tangents) add_tangents(mesh);
    return mesh;
}

} // namespace ghost::scene
