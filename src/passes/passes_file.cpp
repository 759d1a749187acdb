// SPDX-License-Identifier: Apache-2.0
#include "passes/passes_file.h"

#include "image/exr.h"
#include "image/finite.h"

#include "base/check.h"
#include "show/show.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <glm/gtc/packing.hpp>

namespace ghost::scene {
namespace fs = std::filesystem;
namespace {

constexpr char kKeyAttribute[] = "ghost.key";

// Rows that hold count values in pictures of this width.
int rows_for(std::size_t count, int width) {
    return static_cast<int>((count + static_cast<std::size_t>(width) - 1) / static_cast<std::size_t>(width));
}

image::ExrFile rgb_file(int width, int height) {
    image::ExrFile file;
    file.pixels = image::ImageF(width, height, 3);
    file.channels = {"R", "G", "B"};
    file.chromaticities = image::kRec2020;
    return file;
}

void put(image::ImageF& pixels, std::size_t at, const glm::vec3& value) {
    std::copy_n(&value.x, 3, pixels.samples.data() + 3 * at);
}

fs::path exr_path(const fs::path& folder, const std::string& name) {
    return folder / (name + ".exr");
}
std::string extra_name(const std::string& name) {
    return name + ".extra";
}

} // namespace

fs::path passes_folder(const Show& show, const std::string& camera) {
    return show.cache_folder() / "passes" / file_name_of(camera);
}

std::string file_name_of(std::string_view name) {
    std::string result;
    for (const char c : name.substr(0, 100)) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                           c == '-' || c == ' ' || static_cast<unsigned char>(c) >= 0x80;
        result += plain ? c : '_';
    }
    if (result == name) return result.empty() ? "_" : result;
    // Names that differ only in what a file name cannot have must not share a file (FNV-1a).
    std::uint32_t hash = 2166136261u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    char text[16];
    std::snprintf(text, sizeof text, "-%08x", static_cast<unsigned>(hash));
    return result + text;
}

std::uint16_t to_half(float value) {
    constexpr float kLeastNormal = 6.103515625e-5f, kLargest = 65504.0f;
    // Without branches for each exponent: distance maps of what moves are made of millions in each picture.
    if (const float size = std::abs(value); size >= kLeastNormal && size <= kLargest) {
        const auto bits = std::bit_cast<std::uint32_t>(size);
        constexpr std::uint32_t kHalfOfLast = 1u << 12, kOtherBias = (127u - 15u) << 10;
        const std::uint32_t half = ((bits + kHalfOfLast) >> 13) - kOtherBias;
        return static_cast<std::uint16_t>(half | (std::signbit(value) ? 0x8000u : 0u));
    }
    return glm::packHalf1x16(std::isfinite(value) ? std::clamp(value, -kLargest, kLargest) : 0.0f);
}

Result<void> write_picture(const fs::path& path, int width, int height, std::span<const glm::vec3> values,
                           float scale, const TextAttributes& text) {
    image::ExrFile file = rgb_file(width, height);
    for (std::size_t k = 0; k < values.size(); ++k) put(file.pixels, k, values[k] * scale);
    file.text = text;
    return image::write_exr(path, file, image::ExrSample::half);
}

Result<std::vector<glm::vec3>> read_picture(const fs::path& path, int width, int height, float scale,
                                            const std::string& key, Report& report,
                                            const image::Chromaticities* assumed) {
    TRY(const image::ExrFile file, image::read_exr(path, {width, height, 0}));
    if (const auto found = file.text.find(kKeyAttribute);
        !key.empty() && (found == file.text.end() || found->second != key))
        return Error{"belongs to another bake than manifest.json says; run `ghostlight bake` again",
                     path.string()};
    int channel[3];
    for (int k = 0; k < 3; ++k) {
        const std::string name(1, "RGB"[k]);
        channel[k] = file.find_channel(name);
        if (channel[k] < 0) return Error{"has no channel " + name + ", expected R, G, B", path.string()};
    }
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto stride = static_cast<std::size_t>(file.pixels.channels);
    std::vector<glm::vec3> values(count);
    std::size_t bad = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const float* pixel = file.pixels.samples.data() + k * stride;
        const glm::vec3 value(pixel[channel[0]], pixel[channel[1]], pixel[channel[2]]);
        if (image::is_finite(value))
            values[k] = value / scale;
        else
            ++bad;
    }
    if (assumed != nullptr) {
        const glm::mat3 to_working = image::rgb_to_rec2020(file.chromaticities.value_or(*assumed));
        for (glm::vec3& value : values) value = to_working * value;
    }
    if (bad > 0)
        report.add(Severity::warning, path.string(),
                   std::to_string(bad) + " pixels are not finite numbers; they are black");
    return values;
}

StoredLayer to_stored(const FragmentTable& table, std::span<const glm::vec3> values) {
    CHECK_EQ(values.size(), table.fragments.size());
    const std::size_t pixels = table.extra_first.size() - 1;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(pixels);
    StoredLayer layer{{values.begin(), middle}, {middle, values.end()}};
    for (std::size_t p = 0; p < pixels; ++p)
        for (std::uint32_t k = table.extra_first[p]; k < table.extra_first[p + 1]; ++k)
            layer.whole[p] += layer.extra[k];
    return layer;
}

std::vector<glm::vec3> from_stored(const FragmentTable& table, const StoredLayer& layer) {
    std::vector<glm::vec3> values = layer.whole;
    values.insert(values.end(), layer.extra.begin(), layer.extra.end());
    for (std::size_t p = 0; p < layer.whole.size(); ++p) {
        const std::uint32_t end = table.extra_first[p + 1];
        for (std::uint32_t k = table.extra_first[p]; k < end; ++k) values[p] -= layer.extra[k];
        if (table.extra_first[p] < end) values[p] = glm::max(values[p], glm::vec3(0.0f));
    }
    return values;
}

Result<void> write_layer(const fs::path& folder, const std::string& name, int width, int height,
                         const StoredLayer& layer, float scale, const TextAttributes& text) {
    if (!layer.extra.empty())
        TRY_VOID(write_picture(exr_path(folder, extra_name(name)), width, rows_for(layer.extra.size(), width),
                               layer.extra, scale, text));
    return write_picture(exr_path(folder, name), width, height, layer.whole, scale, text);
}

Result<StoredLayer> read_layer(const fs::path& folder, const std::string& name, const FragmentTable& table,
                               float scale, const std::string& key, Report& report) {
    StoredLayer layer;
    TRY(layer.whole, read_picture(exr_path(folder, name), table.width, table.height, scale, key, report));
    const std::size_t extras = table.fragments.size() - layer.whole.size();
    if (extras == 0) return layer;
    TRY(layer.extra, read_picture(exr_path(folder, extra_name(name)), table.width,
                                  rows_for(extras, table.width), scale, key, report));
    layer.extra.resize(extras); // the rest of the last row
    return layer;
}

Result<void> write_fragments(const fs::path& folder, const FragmentTable& table) {
    const std::size_t pixels = table.extra_first.size() - 1;
    image::ExrFile file;
    file.channels = {"X", "Y", "Z", "coverage", "pixel"};
    file.pixels = image::ImageF(table.width, rows_for(table.fragments.size(), table.width), 5);
    const auto put_fragment = [&](std::size_t at, std::size_t pixel) {
        float* to = file.pixels.samples.data() + 5 * at;
        std::copy_n(&table.fragments[at].x, 4, to);
        to[4] = static_cast<float>(pixel);
    };
    for (std::size_t p = 0; p < pixels; ++p) {
        put_fragment(p, p);
        for (std::uint32_t k = table.extra_first[p]; k < table.extra_first[p + 1]; ++k)
            put_fragment(pixels + k, p);
    }
    return image::write_exr(exr_path(folder, "fragments"), file, image::ExrSample::full);
}

Result<FragmentTable> read_fragments(const fs::path& folder, const PassManifest& manifest) {
    const fs::path path = exr_path(folder, "fragments");
    const std::size_t pixels =
        static_cast<std::size_t>(manifest.width) * static_cast<std::size_t>(manifest.height);
    const int rows = rows_for(pixels + manifest.extra_count, manifest.width);
    TRY(const image::ExrFile file, image::read_exr(path, {manifest.width, rows, 0}));
    int channel[5];
    const char* names[5] = {"X", "Y", "Z", "coverage", "pixel"};
    for (int k = 0; k < 5; ++k) {
        channel[k] = file.find_channel(names[k]);
        if (channel[k] < 0) return Error{std::string("has no channel ") + names[k], path.string()};
    }
    FragmentTable table;
    table.width = manifest.width;
    table.height = manifest.height;
    table.fragments.resize(pixels + manifest.extra_count);
    std::vector<std::uint32_t> count(pixels, 0);
    const auto stride = static_cast<std::size_t>(file.pixels.channels);
    std::size_t last = 0;
    for (std::size_t k = 0; k < table.fragments.size(); ++k) {
        const float* from = file.pixels.samples.data() + k * stride;
        for (int c = 0; c < 4; ++c) {
            const float value = from[channel[c]];
            if (!std::isfinite(value))
                return Error{"fragment " + std::to_string(k) + " is not a finite number", path.string()};
            table.fragments[k][c] = value;
        }
        if (k < pixels) continue;
        const float owner = from[channel[4]];
        if (!(owner >= static_cast<float>(last)) || !(owner < static_cast<float>(pixels)))
            return Error{"fragment " + std::to_string(k) + " belongs to no pixel or is out of order",
                         path.string()};
        last = static_cast<std::size_t>(owner);
        if (++count[last] > kMostExtraFragments)
            return Error{"pixel " + std::to_string(last) + " has more than " +
                             std::to_string(kMostExtraFragments) + " extra fragments",
                         path.string()};
    }
    table.extra_first.assign(pixels + 1, 0);
    for (std::size_t p = 0; p < pixels; ++p) table.extra_first[p + 1] = table.extra_first[p] + count[p];
    return table;
}

} // namespace ghost::scene
