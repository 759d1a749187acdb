// SPDX-License-Identifier: Apache-2.0
#include "rays/tracer.h"

#include "rays/sampling.h"

#include "base/check.h"
#include "image/finite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <xmmintrin.h>

namespace ghost::bake {
namespace {

constexpr unsigned kStageMask = 1;
constexpr unsigned kBodyMask = 2;
// Light that passes less than this of blended surfaces counts as stopped.
constexpr float kStopped = 1e-3f;
// A stage in a hall sees no sky at all: only what is nearer than this keeps even light away.
constexpr float kSkyReach_m = 4.0f;
constexpr unsigned kFlushAndDenormalsZero = 0x8040;

struct RayContext {
    embree::Context base; // first: Embree hands it back to the filter
    float blend = 0.5f;
    float* fractions = nullptr; // of the rays of a packet; null: looking for a first hit
};

scene::Material checked(scene::Material material, const scene::Stage& stage) {
    for (int* texture : {&material.base_texture, &material.normal_texture, &material.surface_texture,
                         &material.emission_texture}) {
        const bool there = *texture >= 0 && *texture < static_cast<int>(stage.textures.size());
        if (!there || stage.textures[static_cast<std::size_t>(*texture)].pixels.channels != 4 ||
            stage.textures[static_cast<std::size_t>(*texture)].pixels.empty())
            *texture = scene::kNone;
    }
    return material;
}

// That Embree has no memory is no bug of ours.
void check_device(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    CHECK_EQ(static_cast<int>(error), static_cast<int>(RTC_ERROR_NONE));
}

bool usable(const scene::Mesh& mesh) {
    if (mesh.indices.size() < 3 || mesh.normals.size() != mesh.positions.size()) return false;
    const auto largest = *std::max_element(mesh.indices.begin(), mesh.indices.end());
    return largest < mesh.positions.size();
}

} // namespace

struct Tracer::MeshData {
    const Tracer* tracer = nullptr;
    const scene::Mesh* mesh = nullptr;
    const scene::Material* material = nullptr;
    bool textured = false; // uvs are there

    glm::vec2 uv(unsigned triangle, float u, float v) const {
        if (!textured) return glm::vec2(0.0f);
        const std::uint32_t* i = mesh->indices.data() + 3 * static_cast<std::size_t>(triangle);
        return mesh->uvs[i[0]] * (1 - u - v) + mesh->uvs[i[1]] * u + mesh->uvs[i[2]] * v;
    }
    float alpha(unsigned triangle, float u, float v) const {
        float value = material->alpha;
        if (material->base_texture != scene::kNone)
            value *= tracer->textures_.alpha(material->base_texture, uv(triangle, u, v));
        if (material->alpha_mode == scene::AlphaMode::mask)
            return value >= material->alpha_cutoff ? 1.0f : 0.0f;
        return value;
    }
};

DenormalsOff::DenormalsOff() : mode_(_mm_getcsr()) {
    _mm_setcsr(mode_ | kFlushAndDenormalsZero);
}
DenormalsOff::~DenormalsOff() {
    _mm_setcsr(mode_);
}

Tracer::Tracer(const scene::Stage& stage) : stage_(stage), textures_(stage) {
    const DenormalsOff mode;
    for (const scene::Material& material : stage.materials) materials_.push_back(checked(material, stage));
    if (materials_.empty()) materials_.emplace_back();
    device_.reset(rtcNewDevice(nullptr));
    check_device(device_.get());
    top_.reset(rtcNewScene(device_.get()));
    for (const scene::Mesh& mesh : stage.meshes) {
        auto data = std::make_unique<MeshData>();
        data->tracer = this;
        data->mesh = &mesh;
        const auto material = static_cast<std::size_t>(std::max(mesh.material, 0));
        data->material = &materials_[std::min(material, materials_.size() - 1)];
        data->textured = mesh.uvs.size() == mesh.positions.size();
        SceneHandle scene;
        if (usable(mesh)) {
            const GeometryHandle owned(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
            RTCGeometry geometry = owned.get();
            // Copied, not shared: Embree reads 16 bytes at the last vertex.
            void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                     sizeof(glm::vec3), mesh.positions.size());
            void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                    3 * sizeof(std::uint32_t), mesh.indices.size() / 3);
            check_device(device_.get());
            std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<glm::vec3*>(vertices));
            std::copy_n(mesh.indices.begin(), mesh.indices.size() / 3 * 3,
                        static_cast<std::uint32_t*>(indices));
            rtcSetGeometryUserData(geometry, data.get());
            rtcSetGeometryMask(geometry, kStageMask | kBodyMask);
            if (data->material->alpha_mode != scene::AlphaMode::opaque) {
                rtcSetGeometryIntersectFilterFunction(geometry, &Tracer::filter);
                rtcSetGeometryOccludedFilterFunction(geometry, &Tracer::filter);
            }
            rtcCommitGeometry(geometry);
            scene.reset(rtcNewScene(device_.get()));
            rtcAttachGeometry(scene.get(), geometry);
            rtcCommitScene(scene.get());
            check_device(device_.get());
        }
        mesh_scenes_.push_back(std::move(scene));
        meshes_.push_back(std::move(data));
    }
    for (std::size_t k = 0; k < stage.instances.size(); ++k) {
        const scene::Instance& instance = stage.instances[k];
        normal_matrices_.emplace_back(1.0f);
        const bool known = instance.mesh >= 0 && instance.mesh < static_cast<int>(meshes_.size());
        if (!known || mesh_scenes_[static_cast<std::size_t>(instance.mesh)] == nullptr) continue;
        const float volume = glm::determinant(glm::mat3(instance.world));
        if (!image::is_finite(instance.world) || !(std::abs(volume) > 1e-18f)) continue;
        normal_matrices_.back() = glm::transpose(glm::inverse(glm::mat3(instance.world)));
        const GeometryHandle owned(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
        RTCGeometry geometry = owned.get();
        rtcSetGeometryInstancedScene(geometry, mesh_scenes_[static_cast<std::size_t>(instance.mesh)].get());
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &instance.world[0][0]);
        rtcSetGeometryMask(geometry, instance.fixture == scene::kNone ? kStageMask : kBodyMask);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(top_.get(), geometry, static_cast<unsigned>(k));
    }
    rtcCommitScene(top_.get());
    check_device(device_.get());
}

Tracer::~Tracer() = default;

void Tracer::move(std::size_t instance, const glm::mat4& world, bool is_there) {
    RTCGeometry geometry = rtcGetGeometry(top_.get(), static_cast<unsigned>(instance));
    if (geometry == nullptr) return; // it has no triangle
    const bool usable =
        is_there && image::is_finite(world) && std::abs(glm::determinant(glm::mat3(world))) > 1e-18f;
    if (!usable) return rtcDisableGeometry(geometry);
    rtcEnableGeometry(geometry);
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &world[0][0]);
    rtcCommitGeometry(geometry);
}

void Tracer::commit() {
    const DenormalsOff mode;
    rtcCommitScene(top_.get());
    check_device(device_.get());
}

void Tracer::filter(const RTCFilterFunctionNArguments* arguments) {
    const auto* data = static_cast<const MeshData*>(arguments->geometryUserPtr);
    const auto* context = reinterpret_cast<const RayContext*>(arguments->context);
    for (unsigned k = 0; k < arguments->N; ++k) {
        if (arguments->valid[k] == 0) continue;
        const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, k);
        const float alpha = data->alpha(triangle, RTCHitN_u(arguments->hit, arguments->N, k),
                                        RTCHitN_v(arguments->hit, arguments->N, k));
        if (context->fractions != nullptr) {
            float& fraction = context->fractions[RTCRayN_id(arguments->ray, arguments->N, k)];
            fraction *= 1.0f - std::clamp(alpha, 0.0f, 1.0f);
            if (fraction > kStopped) arguments->valid[k] = 0;
            continue;
        }
        float threshold = 0.5f;
        if (context->blend >= 0.0f) {
            const unsigned instance = RTCHitN_instID(arguments->hit, arguments->N, k, 0);
            threshold = context->blend + to_unit(hash_u32(triangle, instance));
            threshold -= std::floor(threshold);
        }
        if (!(alpha > threshold)) arguments->valid[k] = 0;
    }
}

Surface Tracer::first_hit(const glm::vec3& origin, const glm::vec3& direction, float blend, Sees sees) const {
    RayContext context;
    embree::begin(context.base);
    context.blend = blend;
    RTCRayHit hit{};
    hit.ray = {origin.x,    origin.y,
               origin.z,    0.0f,
               direction.x, direction.y,
               direction.z, 0.0f,
               1e6f,        sees == Sees::everything ? kStageMask | kBodyMask : kStageMask,
               0,           0};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect1(top_.get(), context.base, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return surface_at(hit, direction);
}

Tracer::Meeting Tracer::meet(const glm::vec3& origin, const glm::vec3& direction, float reach_m) const {
    RayContext context;
    embree::begin(context.base);
    context.blend = -1.0f;
    RTCRayHit hit{};
    hit.ray = {origin.x,    origin.y, origin.z, 0.0f,       direction.x, direction.y,
               direction.z, 0.0f,     reach_m,  kStageMask, 0,           0};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect1(top_.get(), context.base, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {reach_m, glm::vec3(0), -1};
    Meeting meeting;
    meeting.distance_m = hit.ray.tfar;
    meeting.instance = static_cast<int>(hit.hit.instID[0]);
    meeting.normal = image::unit_or(normal_matrices_[static_cast<std::size_t>(meeting.instance)] *
                                        glm::vec3(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z),
                                    -direction);
    if (glm::dot(meeting.normal, direction) > 0.0f) meeting.normal = -meeting.normal;
    return meeting;
}

Surface Tracer::surface_at(const RTCRayHit& hit, const glm::vec3& direction) const {
    Surface s;
    s.instance = static_cast<int>(hit.hit.instID[0]);
    s.distance_m = hit.ray.tfar;
    s.to_viewer = -direction;
    const auto index = static_cast<std::size_t>(s.instance);
    const scene::Instance& instance = stage_.instances[index];
    const MeshData& data = *meshes_[static_cast<std::size_t>(instance.mesh)];
    const scene::Mesh& mesh = *data.mesh;
    const glm::mat3& to_normal = normal_matrices_[index];
    const glm::mat3 to_world(instance.world);
    const glm::vec3 shift(instance.world[3]);

    const std::uint32_t* i = mesh.indices.data() + 3 * static_cast<std::size_t>(hit.hit.primID);
    const float b[3] = {1 - hit.hit.u - hit.hit.v, hit.hit.u, hit.hit.v};
    glm::vec3 vertex[3];
    for (int k = 0; k < 3; ++k) vertex[k] = to_world * mesh.positions[i[k]] + shift;
    s.position = vertex[0] * b[0] + vertex[1] * b[1] + vertex[2] * b[2];
    s.facet_normal = image::unit_or(glm::cross(vertex[1] - vertex[0], vertex[2] - vertex[0]), -direction);
    if (glm::dot(s.facet_normal, direction) > 0.0f) s.facet_normal = -s.facet_normal;

    glm::vec3 smooth(0.0f);
    glm::vec3 lift(0.0f);
    float facing = 0.0f;
    for (int k = 0; k < 3; ++k) {
        glm::vec3 n = image::unit_or(to_normal * mesh.normals[i[k]], s.facet_normal);
        // Files disagree about winding, so only the normals say which side is the front.
        const float towards = glm::dot(n, s.facet_normal);
        facing += towards * b[k];
        if (towards < 0.0f) n = -n;
        smooth += n * b[k];
        lift -= n * (b[k] * std::min(0.0f, glm::dot(s.position - vertex[k], n)));
    }
    s.normal = image::unit_or(smooth, s.facet_normal);
    const bool seen_from_behind = facing < 0.0f;
    const glm::vec3 size = glm::abs(s.position);
    const float skin_m = 1e-4f + 1e-5f * std::max({size.x, size.y, size.z});
    s.shadow_origin = s.position + lift + s.facet_normal * skin_m;

    const scene::Material& material = *data.material;
    const glm::vec2 uv = data.uv(hit.hit.primID, hit.hit.u, hit.hit.v);
    s.base_colour = material.base_colour;
    if (material.base_texture != scene::kNone)
        s.base_colour *= glm::vec3(textures_.colour(material.base_texture, uv));
    s.base_colour = glm::max(s.base_colour, glm::vec3(0.0f));
    float roughness = material.roughness;
    float metalness = material.metalness;
    if (material.surface_texture != scene::kNone) {
        const glm::vec4 value = textures_.data(material.surface_texture, uv);
        roughness *= value.y;
        metalness *= value.z;
    }
    s.emission = material.emission;
    if (material.emission_texture != scene::kNone)
        s.emission *= glm::vec3(textures_.colour(material.emission_texture, uv));
    s.brdf = shared::brdf_of(s.base_colour, std::clamp(roughness, 0.0f, 1.0f),
                             std::clamp(metalness, 0.0f, 1.0f), material.specular);

    if (material.normal_texture != scene::kNone && data.textured) {
        // Tangent along +u, bitangent up the picture (against v); both as seen from the front.
        glm::vec3 tangent(0.0f);
        glm::vec3 bitangent(0.0f);
        const glm::vec3 front = seen_from_behind ? -s.normal : s.normal;
        if (mesh.tangents.size() == mesh.positions.size()) {
            for (int k = 0; k < 3; ++k) tangent += to_world * glm::vec3(mesh.tangents[i[k]]) * b[k];
            const float mirrored = glm::determinant(to_world) < 0.0f ? -1.0f : 1.0f;
            bitangent = glm::cross(front, tangent) * (mesh.tangents[i[0]].w < 0.0f ? -mirrored : mirrored);
        } else {
            const glm::vec2 d1 = mesh.uvs[i[1]] - mesh.uvs[i[0]];
            const glm::vec2 d2 = mesh.uvs[i[2]] - mesh.uvs[i[0]];
            const float sign = d1.x * d2.y - d1.y * d2.x < 0.0f ? -1.0f : 1.0f;
            tangent = sign * ((vertex[1] - vertex[0]) * d2.y - (vertex[2] - vertex[0]) * d1.y);
            bitangent = -sign * ((vertex[2] - vertex[0]) * d1.x - (vertex[1] - vertex[0]) * d2.x);
        }
        tangent = image::unit_or(tangent - front * glm::dot(front, tangent), glm::vec3(0.0f));
        bitangent = image::unit_or(bitangent - front * glm::dot(front, bitangent), glm::vec3(0.0f));
        const glm::vec3 map = glm::vec3(textures_.data(material.normal_texture, uv)) * 2.0f - 1.0f;
        const glm::vec3 bent =
            (tangent * map.x + bitangent * map.y) * material.normal_scale + front * std::max(map.z, 0.01f);
        s.normal = image::unit_or(seen_from_behind ? -bent : bent, s.normal);
    }
    return s;
}

void Tracer::occluded8(RTCRay8& rays, int count, float* fractions) const {
    alignas(32) int valid[8];
    for (int k = 0; k < 8; ++k) {
        valid[k] = k < count ? -1 : 0;
        rays.tnear[k] = 0.0f;
        rays.time[k] = 0.0f;
        rays.mask[k] = kStageMask;
        rays.id[k] = static_cast<unsigned>(k);
        rays.flags[k] = 0;
        if (k < count) {
            fractions[k] = 1.0f;
            continue;
        }
        // Debian's Embree asserts on huge values in lanes that are switched off.
        rays.org_x[k] = rays.org_y[k] = rays.org_z[k] = 0.0f;
        rays.dir_x[k] = rays.dir_y[k] = 0.0f;
        rays.dir_z[k] = 1.0f;
        rays.tfar[k] = 1.0f;
    }
    RayContext context;
    embree::begin(context.base);
    context.fractions = fractions;
    embree::occluded8(valid, top_.get(), context.base, rays);
    for (int k = 0; k < count; ++k)
        if (rays.tfar[k] < 0.0f) fractions[k] = 0.0f;
}

void Tracer::visibility(const Surface* const* surfaces, int count, const glm::vec3& point,
                        float* fractions) const {
    RTCRay8 rays;
    for (int k = 0; k < count; ++k) {
        const glm::vec3& origin = surfaces[k]->shadow_origin;
        const glm::vec3 way = point - origin;
        rays.org_x[k] = origin.x;
        rays.org_y[k] = origin.y;
        rays.org_z[k] = origin.z;
        rays.dir_x[k] = way.x;
        rays.dir_y[k] = way.y;
        rays.dir_z[k] = way.z;
        rays.tfar[k] = 1.0f;
    }
    occluded8(rays, count, fractions);
}

void Tracer::open_sky(const Surface* const* surfaces, int count, const glm::vec3* directions,
                      float* fractions) const {
    RTCRay8 rays;
    for (int k = 0; k < count; ++k) {
        const glm::vec3& origin = surfaces[k]->shadow_origin;
        rays.org_x[k] = origin.x;
        rays.org_y[k] = origin.y;
        rays.org_z[k] = origin.z;
        rays.dir_x[k] = directions[k].x;
        rays.dir_y[k] = directions[k].y;
        rays.dir_z[k] = directions[k].z;
        rays.tfar[k] = kSkyReach_m;
    }
    occluded8(rays, count, fractions);
}

void Tracer::distances(const glm::vec3& origin, const glm::vec3* directions, int count, float reach_m,
                       float* distances_m, int* instances) const {
    alignas(32) int valid[8];
    RTCRayHit8 hit;
    for (int k = 0; k < 8; ++k) {
        // Lanes that are switched off repeat the first: Debian's Embree asserts on what is in them.
        const glm::vec3& way = directions[k < count ? k : 0];
        valid[k] = k < count ? -1 : 0;
        hit.ray.org_x[k] = origin.x;
        hit.ray.org_y[k] = origin.y;
        hit.ray.org_z[k] = origin.z;
        hit.ray.dir_x[k] = way.x;
        hit.ray.dir_y[k] = way.y;
        hit.ray.dir_z[k] = way.z;
        hit.ray.tnear[k] = 0.0f;
        hit.ray.tfar[k] = reach_m;
        hit.ray.time[k] = 0.0f;
        hit.ray.mask[k] = kStageMask;
        hit.ray.id[k] = static_cast<unsigned>(k);
        hit.ray.flags[k] = 0;
        hit.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        hit.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    RayContext context;
    embree::begin(context.base);
    context.blend = -1.0f;
    embree::intersect8(valid, top_.get(), context.base, hit);
    for (int k = 0; k < count; ++k) {
        const bool met = hit.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        distances_m[k] = met ? hit.ray.tfar[k] : reach_m;
        instances[k] = met ? static_cast<int>(hit.hit.instID[0][k]) : -1;
    }
}

} // namespace ghost::bake
