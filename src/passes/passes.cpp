// SPDX-License-Identifier: Apache-2.0
#include "passes/passes.h"

#include "base/memory.h"
#include "passes/passes_file.h"

#include <algorithm>

namespace ghost::scene {
namespace {

std::vector<std::uint16_t> halves(const std::vector<glm::vec3>& values) {
    std::vector<std::uint16_t> result(values.size() * 4, 0);
    for (std::size_t k = 0; k < values.size(); ++k)
        for (int c = 0; c < 3; ++c)
            result[4 * k + static_cast<std::size_t>(c)] = to_half(values[k][c] * kRadianceScale);
    return result;
}

std::vector<glm::vec4> with_zero(const std::vector<glm::vec3>& values) {
    std::vector<glm::vec4> result;
    result.reserve(values.size());
    for (const glm::vec3& value : values) result.emplace_back(value, 0.0f);
    return result;
}

void report_lost(Report& report, const Error& error, const std::string& consequence) {
    report.add(Severity::error, error.where, error.what + "; " + consequence);
}

} // namespace

int Passes::find(const std::string& fixture, int stop) const {
    for (std::size_t k = 0; k < lights.size(); ++k)
        if (lights[k].stop == stop && lights[k].fixture == fixture) return static_cast<int>(k);
    return -1;
}

Result<void> check_light_memory(std::uint64_t texels, std::size_t lights, const std::filesystem::path& where,
                                std::uint64_t free_bytes) {
    constexpr std::uint64_t kBytesPerTexel = 4 * sizeof(std::uint16_t);
    const std::uint64_t bytes = texels * lights * kBytesPerTexel;
    if (free_bytes == 0 || bytes <= free_bytes) return {};
    return Error{"the pictures of its " + std::to_string(lights) + " lights need " +
                     std::to_string(bytes >> 20) + " MB of memory, and " + std::to_string(free_bytes >> 20) +
                     " are free: fewer lights or a smaller picture need less",
                 where.string()};
}

Result<Passes> load_passes(const std::filesystem::path& folder, bool with_radiance, Report& report) {
    TRY(const PassManifest manifest, read_manifest(folder));
    if (with_radiance) {
        const auto pixels =
            static_cast<std::uint64_t>(manifest.width) * static_cast<std::uint64_t>(manifest.height);
        const bool any_indirect = std::any_of(manifest.lights.begin(), manifest.lights.end(),
                                              [](const ManifestLight& light) { return light.indirect; });
        TRY_VOID(check_light_memory(pixels * (any_indirect ? 2 : 1) + manifest.extra_count,
                                    manifest.lights.size(), folder, free_memory_bytes()));
    }
    const std::filesystem::path pictures = folder / manifest.folder;
    TRY(FragmentTable table, read_fragments(pictures, manifest));

    Passes passes;
    passes.width = manifest.width;
    passes.height = manifest.height;
    passes.camera_to_world = manifest.camera_to_world;
    passes.fov_y_deg = manifest.fov_y_deg;
    if (auto ambient = read_layer(pictures, "ambient", table, kPictureCandela, manifest.layout_key, report);
        ambient.ok()) {
        passes.ambient = with_zero(from_stored(table, *ambient));
    } else {
        report_lost(report, ambient.error(), "there is no ambient light");
        passes.ambient.assign(table.fragments.size(), glm::vec4(0.0f));
    }
    if (manifest.has_emission) {
        if (auto emission = read_layer(pictures, "emission", table, 1.0f, manifest.layout_key, report);
            emission.ok())
            passes.emission = with_zero(from_stored(table, *emission));
        else
            report_lost(report, emission.error(), "surfaces that glow are dark");
    }
    for (const ManifestLight& entry : manifest.lights) {
        LightPass light;
        light.fixture = entry.fixture;
        light.stop = entry.stop;
        light.position_m = entry.position_m;
        light.file = pictures / (entry.picture + ".exr");
        light.key = entry.key;
        if (with_radiance) {
            const std::string lost = "fixture '" + entry.fixture + "' is dark";
            if (auto values = read_layer(pictures, entry.picture, table, kPictureCandela, entry.key, report);
                values.ok())
                light.radiance = halves(from_stored(table, *values));
            else
                report_lost(report, values.error(), lost);
            if (entry.indirect) {
                const auto path = pictures / (entry.picture + "_indirect.exr");
                if (auto values =
                        read_picture(path, table.width, table.height, kPictureCandela, entry.key, report);
                    values.ok())
                    light.indirect = halves(*values);
                else
                    report_lost(report, values.error(),
                                "fixture '" + entry.fixture + "' throws no bounced light");
            }
        }
        passes.lights.push_back(std::move(light));
    }
    passes.extra_first = std::move(table.extra_first);
    passes.fragments = std::move(table.fragments);
    return passes;
}

} // namespace ghost::scene
