#pragma once
// SPDX-License-Identifier: Apache-2.0
// Frame: all pictures of one camera in memory, and the function that traces them. Each pixel has spp
// stratified samples under a one-pixel box; its samples are split by distance into at most kMaxFragments
// fragments (passes/passes.h), and each light's radiance is summed per fragment. Samples and fragments depend
// on camera, geometry and spp alone, so lights baked on different days fit together; the same input gives the
// same bytes whatever the number of threads. Radiance in cd/m^2 per cd (ambient: per lux), linear Rec.2020.

#include "bake/fragments.h"
#include "rays/tracer.h"
#include "show/camera.h"

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::bake {

inline constexpr int kMaxSpp = 1024;
inline constexpr int kMaxBounces = 16;

struct Rect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0; // x1, y1 excluded

    bool empty() const { return x1 <= x0 || y1 <= y0; }
    bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
};

// One value per fragment, in the order of scene::Passes.
using Layer = std::vector<glm::vec3>;

struct Frame {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> extra_first; // pixel count + 1
    std::vector<glm::vec4> fragments;       // xyz, coverage (< 0: nothing there)
    std::vector<glm::vec4> centre_position; // first hit of the pixel's centre, w = 1 on geometry
    std::vector<glm::vec3> centre_normal;
    std::vector<glm::vec3> centre_albedo;
    std::vector<float> centre_distance_m;
    Layer ambient;
    Layer emission;
    std::vector<Layer> lights;                    // per light asked for
    std::vector<std::vector<glm::vec3>> indirect; // per light asked for, per pixel; empty without bounces
};

struct FrameRequest {
    int spp = 16;
    int bounces = 0;
    bool surroundings = true; // centre values, ambient, emission
    std::vector<glm::vec3> lights_m;
    std::vector<Rect>
        only; // empty: the whole picture; else all other pixels stay empty with one fragment each
    std::function<bool()> stop;   // the frame is worthless once it says true; asked from any thread
    std::function<void()> on_row; // after each row, called from any thread
};

// Adds the rays cast to rays.
Frame trace_frame(const Tracer& tracer, const scene::Camera& camera, const FrameRequest& request,
                  std::uint64_t& rays);

} // namespace ghost::bake
