#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a plot draws besides its fixtures: the meshes of scene objects, trusses, supports, screens and
// projectors as instances of a Stage. A mesh file is read once, however many objects use it; symbols are
// taken apart by the plot (MVR 1.6, Geometry3D and Symbol). Hidden objects are left out with all that hangs
// on them. World metres, less the plot's origin. What is lost goes to the report. One thread per LoadedPlot.

#include "base/report.h"
#include "base/result.h"
#include "mvr/mvr_load.h"
#include "show/loading.h"
#include "show/show.h"
#include "stage/stage.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

// Per object: drawn, as neither it nor what it hangs on is hidden, by itself, its layer or its class (names,
// case does not count).
std::vector<bool> shown_objects(const Plot& plot, std::span<const std::string> hidden_layers,
                                std::span<const std::string> hidden_classes);

// Plots in survey coordinates lie hundreds of kilometres from their origin, where floats count in
// centimetres: whole kilometres to take off all places. Zero for a plot within 5 km.
glm::dvec3 origin_of(const Plot& plot);

// As far from most of the plot as nothing that show.toml places may be: one such thing, and no camera holds
// the others.
inline bool is_far(const glm::vec3& place_m) {
    const auto most_m = static_cast<float>(kMaxCoordinate_m);
    return glm::any(glm::greaterThan(glm::abs(place_m), glm::vec3(most_m)));
}

// Vertices and triangles of all meshes of a plot, in memory: more than 20 million triangles, which are drawn,
// ever need.
inline constexpr std::uint64_t kMostMeshBytes = std::uint64_t{4} << 30;

// shown: per object, of shown_objects. Error: stopped by loading.stop.
Result<void> add_plot_stage(LoadedPlot& loaded, const std::vector<bool>& shown, const glm::dvec3& origin_m,
                            Stage& stage, Report& report, const ShowLoading& loading,
                            std::uint64_t most_mesh_bytes = kMostMeshBytes);

// The rectangle that the mesh of a screen is: its shortest side is taken as its depth, its front looks to
// where more of its faces look, or, where that is even, down its frame's shortest axis.
struct ScreenPlane {
    glm::dmat4 to_world{1.0}; // from a frame whose X and Z are its right and up, and whose -Y is its front;
                              // middle of the front
    glm::vec2 size_m{0.0f};
    float depth_m = 0.0f;
};

// Of an object with meshes; nothing where they hold no surface. Messages about its files come with
// add_plot_stage.
std::optional<ScreenPlane> screen_plane(LoadedPlot& loaded, int object, const glm::dvec3& origin_m);

} // namespace ghost::scene
