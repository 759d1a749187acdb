#pragma once
// SPDX-License-Identifier: Apache-2.0
// Passes: the paper's input for one camera. One HDR picture per light as an isotropic point source of 1 cd,
// and where in the world each pixel is (Screen Space Re-Rendering, section 2). Baked by us or rendered
// elsewhere. Rec.2020, cd/m^2 per cd.
//
// Silhouettes: an edge pixel shows several surfaces, and one position for it would relight them all as if
// they were one. So a pixel is a list of fragments, each with its own position and its own share of the
// radiance. Fragment p < pixel_count is the main one of pixel p; the extra ones of pixel p are pixel_count +
// [extra_first[p], extra_first[p + 1]). The radiance of a fragment is premultiplied with its coverage: the
// pixel is the plain sum of its fragments.

#include "base/report.h"
#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

// LightPass::radiance is stored times this: cd/m^2 per cd are around 1e-5 in the dark, below the normal range
// of half floats.
inline constexpr float kRadianceScale = 1024.0f;

struct LightPass {
    std::string fixture;     // name in the show
    int stop = 0;            // of its track
    glm::vec3 position_m{0}; // of the point source
    std::filesystem::path file;
    std::string key; // hash of all that it depends on
    // Half floats R, G, B, 0 per fragment, times kRadianceScale: what the GPU reads. Empty where it could not
    // be read.
    std::vector<std::uint16_t> radiance;
    // Bounced light, per pixel, in the same form; empty without `bake --bounces`. A beam's cone must not cut
    // it: multiply it by the beam's flux / (4 pi), which is the isotropic source of the same flux.
    std::vector<std::uint16_t> indirect;
};

// Of a pixel, beside its main one.
inline constexpr std::uint32_t kMostExtraFragments = 3;

struct Passes {
    int width = 0;
    int height = 0;
    glm::mat4 camera_to_world{1.0f};
    float fov_y_deg = 0;
    std::vector<std::uint32_t> extra_first; // pixel_count + 1
    // xyz: where the fragment is, metres; w: coverage 0..1. A fragment that met no surface has coverage < 0
    // (no light).
    std::vector<glm::vec4> fragments;
    std::vector<glm::vec4> ambient;  // radiance under an even light of 1 lux; per fragment
    std::vector<glm::vec4> emission; // cd/m^2 that the surface itself emits; per fragment; may be empty
    std::vector<LightPass> lights;

    std::size_t pixel_count() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    std::size_t fragment_count() const { return fragments.size(); }
    // Index into lights, or -1.
    int find(const std::string& fixture, int stop) const;
};

// folder: .ghost/passes/<camera>/ with manifest.json. Reads everything but the light pictures when
// with_radiance is false. A missing or wrong-sized picture goes to the report and leaves that light's
// radiance empty (it is dark); an error only where nothing can be shown.
Result<Passes> load_passes(const std::filesystem::path& folder, bool with_radiance, Report& report);

// passes.toml of pictures rendered elsewhere (docs/reference/foreign-passes.md): one fragment a pixel.
Result<Passes> load_foreign_passes(const std::filesystem::path& toml, Report& report);

} // namespace ghost::scene
