#pragma once
// SPDX-License-Identifier: Apache-2.0
// The files of baked passes, written by the baker and read by load_passes (docs/guide/baking.md). In
// .ghost/passes/<camera>/: manifest.json, and in the folder that it names: fragments.exr (X Y Z coverage
// pixel), P N albedo depth.exr (pixel centres), ambient.exr, emission.exr, light_<fixture>_<stop>.exr (the
// whole anti-aliased picture under kPictureCandela), beside each picture NAME.extra.exr with the share of the
// extra fragments. Any thread.

#include "base/report.h"
#include "base/result.h"
#include "image/colour.h"
#include "passes/passes.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

struct Show;

// The files of version 1 are the same; their keys were made differently, so that a bake takes none of them.
inline constexpr int kPassesVersion = 2;
// Pictures are lit by this many candela, the others by this many lux: half floats hold that without loss (see
// kRadianceScale).
inline constexpr float kPictureCandela = kRadianceScale;
inline constexpr std::size_t kMaxLightPasses = 2047; // and a dark one: layers of an image, on every device

struct ManifestLight {
    std::string fixture;
    int stop = 0;
    glm::vec3 position_m{0};
    std::string key;
    std::string picture;   // file name without .exr
    bool indirect = false; // picture + "_indirect" is there
};

// A fixture's body that this camera sees: where in the picture (x0 y0 x1 y1, ends excluded), and the hash of
// its shape.
struct ManifestBody {
    std::string fixture;
    std::string key;
    std::array<int, 4> rect{};
};

struct PassManifest {
    int version = kPassesVersion;
    std::string camera;
    glm::mat4 camera_to_world{1.0f};
    float fov_y_deg = 40;
    int width = 0;
    int height = 0;
    int spp = 0;
    int bounces = 0;
    std::string geometry_key; // stage, camera, spp, baker
    std::string layout_key;   // the same and the bodies in sight: which fragments there are
    std::string folder;       // of the pictures
    std::size_t extra_count = 0;
    bool has_emission = false;
    std::vector<ManifestBody> bodies;
    std::vector<ManifestLight> lights;
};

// <show>/.ghost/passes/<camera>, with characters that no file system likes replaced.
std::filesystem::path passes_folder(const Show& show, const std::string& camera);
std::string file_name_of(std::string_view name);

std::string manifest_text(const PassManifest& manifest);
// where is for the messages. Every name in it stays inside its folder, every size has a limit.
Result<PassManifest> parse_manifest(std::string_view text, const std::string& where);
Result<PassManifest> read_manifest(const std::filesystem::path& folder);

// Before any is read, for each is a copy even of one file. texels: of one light. Error: all of them are more
// than is free. free_bytes 0: nobody knows.
Result<void> check_light_memory(std::uint64_t texels, std::size_t lights, const std::filesystem::path& where,
                                std::uint64_t free_bytes);

// Half float, nearest; beyond the range: the largest.
std::uint16_t to_half(float value);

// The fragments of a picture: how many extra ones belong to each pixel, as in Passes.
struct FragmentTable {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> extra_first;
    std::vector<glm::vec4> fragments;
};
Result<void> write_fragments(const std::filesystem::path& folder, const FragmentTable& table);
Result<FragmentTable> read_fragments(const std::filesystem::path& folder, const PassManifest& manifest);

using TextAttributes = std::map<std::string, std::string>; // "ghost.key" must match on reading

// A layer as it lies on disk: the whole picture, and the extra fragments' shares of it.
struct StoredLayer {
    std::vector<glm::vec3> whole; // per pixel
    std::vector<glm::vec3> extra;
};
// From and to one value per fragment: main fragment = picture - extra ones, at least 0.
StoredLayer to_stored(const FragmentTable& table, std::span<const glm::vec3> values);
std::vector<glm::vec3> from_stored(const FragmentTable& table, const StoredLayer& layer);

// Values times scale in the file NAME.exr and NAME.extra.exr. On reading, pixels that are no numbers become
// black and are counted in the report. Error: missing, wrong size, another bake's key (where key is not
// empty).
Result<void> write_layer(const std::filesystem::path& folder, const std::string& name, int width, int height,
                         const StoredLayer& layer, float scale, const TextAttributes& text);
Result<StoredLayer> read_layer(const std::filesystem::path& folder, const std::string& name,
                               const FragmentTable& table, float scale, const std::string& key,
                               Report& report);

// One value per pixel, no fragments.
Result<void> write_picture(const std::filesystem::path& path, int width, int height,
                           std::span<const glm::vec3> values, float scale, const TextAttributes& text);
// assumed: primaries of a picture without a chromaticities attribute; null: Rec.2020, and what the attribute
// says is not looked at.
Result<std::vector<glm::vec3>> read_picture(const std::filesystem::path& path, int width, int height,
                                            float scale, const std::string& key, Report& report,
                                            const image::Chromaticities* assumed = nullptr);

} // namespace ghost::scene
