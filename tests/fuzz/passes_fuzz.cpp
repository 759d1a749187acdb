// SPDX-License-Identifier: Apache-2.0
// passes.toml and manifest.json from anybody: never a crash, and whatever is accepted stays inside its folder
// and its limits.
#include "base/check.h"
#include "passes/passes_file.h"
#include "passes/passes_foreign.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    ghost::Report report;
    if (const auto foreign = ghost::scene::parse_foreign_passes(text, "fuzz/passes.toml", report);
        foreign.ok()) {
        CHECK(!foreign->position.empty() && foreign->lights.size() <= ghost::scene::kMaxLightPasses);
        for (int k = 0; k < 4; ++k) CHECK(std::isfinite(glm::length(foreign->camera_to_world[k])));
        for (const auto& light : foreign->lights)
            CHECK(light.intensity_cd > 0 && std::isfinite(glm::length(light.position_m)));
    }
    const auto manifest = ghost::scene::parse_manifest(text, "fuzz/manifest.json");
    if (!manifest.ok()) return 0;
    CHECK(manifest->width >= 1 && manifest->width <= 16384 && manifest->height >= 1 &&
          manifest->height <= 16384);
    CHECK(!manifest->folder.empty() && manifest->folder.find('/') == std::string::npos &&
          manifest->folder[0] != '.');
    for (const auto& light : manifest->lights)
        CHECK(!light.picture.empty() && light.picture.find('/') == std::string::npos &&
              light.picture[0] != '.');
    CHECK(ghost::scene::parse_manifest(ghost::scene::manifest_text(*manifest), "again").ok());
    return 0;
}
