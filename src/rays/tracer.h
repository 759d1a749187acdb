#pragma once
// SPDX-License-Identifier: Apache-2.0
// Tracer: Embree over a Stage. First hits with the material evaluated, and how much light passes between
// points (alpha masks cut, blended surfaces attenuate). Meshes are stored once and instanced. World metres.
// Const calls from any thread; each tracing thread holds a DenormalsOff. The stage must outlive it. Where
// Embree has no memory: std::bad_alloc.
//
// Fixture bodies (Instance::fixture) are seen by cameras and lit, but throw no shadow and no bounce: a
// fixture that is moved changes its own pass and the pixels that show its body, not the light of all others.

#include "rays/embree.h"
#include "rays/textures.h"
#include "shared/brdf.h"
#include "stage/stage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <type_traits>
#include <vector>

namespace ghost::bake {

// Denormals are zero while it lives (Embree asks for it); the thread's mode comes back after.
class DenormalsOff {
public:
    DenormalsOff();
    ~DenormalsOff();
    DenormalsOff(const DenormalsOff&) = delete;
    DenormalsOff& operator=(const DenormalsOff&) = delete;

private:
    unsigned mode_;
};

struct Surface {
    glm::vec3 position{0};
    glm::vec3 shadow_origin{0}; // position, moved off the facets of a smooth surface (Hanika 2021)
    glm::vec3 facet_normal{0};  // of the triangle, towards the viewer
    glm::vec3 normal{0};        // for shading, towards the viewer
    glm::vec3 to_viewer{0};
    glm::vec3 base_colour{0};
    glm::vec3 emission{0};
    shared::Brdf brdf{};
    float distance_m = 0;
    int instance = -1; // -1: nothing was hit
};

enum class Sees { everything, no_bodies };

class Tracer {
public:
    explicit Tracer(const scene::Stage& stage);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    // First surface along the unit direction. blend: threshold 0..1 that an alpha must pass on blended
    // surfaces; sequences of it over the samples of a pixel give each surface its fraction.
    Surface first_hit(const glm::vec3& origin, const glm::vec3& direction, float blend, Sees sees) const;

    // The same without its material and without fixture bodies: how far, and the normal of the facet towards
    // the origin. Nothing within reach_m: instance -1. What is half opaque is there.
    struct Meeting {
        float distance_m = 0;
        glm::vec3 normal{0};
        int instance = -1;
    };
    Meeting meet(const glm::vec3& origin, const glm::vec3& direction, float reach_m) const;

    // Fraction of light that passes from each surface (its shadow_origin) to the point, for count <= 8
    // surfaces.
    void visibility(const Surface* const* surfaces, int count, const glm::vec3& point,
                    float* fractions) const;

    // The same along unit directions, as far as even light is kept away (4 m).
    void open_sky(const Surface* const* surfaces, int count, const glm::vec3* directions,
                  float* fractions) const;

    // How far it is along count <= 8 unit directions, near each other, to what stops light, and which
    // instance that is; nothing within reach_m: reach_m and -1. Holes and surfaces that cover at most half
    // let through, fixture bodies too.
    void distances(const glm::vec3& origin, const glm::vec3* directions, int count, float reach_m,
                   float* distances_m, int* instances) const;

    // For distances alone: an instance is elsewhere, or not there, from the next commit on. Not while others
    // trace. A matrix that is flat or not finite: it is not there.
    void move(std::size_t instance, const glm::mat4& world, bool is_there);
    void commit();

    const scene::Stage& stage() const { return stage_; }

private:
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
        void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    };
    template <class Embree>
    using Handle = std::unique_ptr<std::remove_pointer_t<Embree>, Release>;
    using SceneHandle = Handle<RTCScene>;
    using GeometryHandle = Handle<RTCGeometry>;

    struct MeshData;
    void occluded8(RTCRay8& rays, int count, float* fractions) const;
    Surface surface_at(const RTCRayHit& hit, const glm::vec3& direction) const;
    static void filter(const RTCFilterFunctionNArguments* arguments);

    const scene::Stage& stage_;
    Textures textures_;
    std::vector<scene::Material> materials_; // without references to textures that are not there
    Handle<RTCDevice> device_;               // before its scenes, which go first
    SceneHandle top_;
    std::vector<std::unique_ptr<MeshData>> meshes_;
    std::vector<SceneHandle> mesh_scenes_;
    std::vector<glm::mat3> normal_matrices_; // per instance
};

} // namespace ghost::bake
