// SPDX-License-Identifier: Apache-2.0
// The pictures of a bake: distance maps, pictures and layers of passes, fragments. Input that starts as an
// EXR file does is taken as it is; of other input one is made, whose size, channels, texts and values it
// says. As text it is a list of what a stage consists of.
#include "fuzz_folder.h"

#include "image/exr.h"
#include "passes/distance_maps_file.h"
#include "passes/passes_file.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <string_view>

using namespace ghost;
using namespace ghost::scene;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

// Two bytes: sizes; two: which channels; one: which texts; then texts of one byte of length, then values.
image::ExrFile exr_of(ByteReader& reader) {
    image::ExrFile file;
    const int width = 1 + reader.u8() % 8, height = 1 + reader.u8() % 8;
    const std::uint16_t which = reader.u16_be();
    const char* const names[] = {"R", "G", "B", "A", "X", "Y", "Z", "coverage", "pixel"};
    for (std::size_t k = 0; k < std::size(names); ++k)
        if (which >> k & 1) file.channels.push_back(names[k]);
    if (file.channels.empty()) file.channels.push_back("Z");
    const std::uint8_t texts = reader.u8();
    const char* const keys[] = {"ghost.place", "ghost.stage", "ghost.key", "ghost.sees"};
    for (std::size_t k = 0; k < std::size(keys); ++k) {
        if (!(texts >> k & 1)) continue;
        const Bytes words = reader.take(std::min<std::size_t>(reader.u8(), reader.left()));
        std::string text(words.begin(), words.end());
        if (texts >> (k + 4) & 1) text = std::string(k == 3 ? 16 : 32, 'a'); // as it should be
        text.erase(std::remove(text.begin(), text.end(), '\0'), text.end());
        file.text[keys[k]] = text;
    }
    file.pixels = image::ImageF(width, height, static_cast<int>(file.channels.size()));
    for (float& sample : file.pixels.samples)
        sample = texts & 128 ? static_cast<float>(reader.u8()) : std::bit_cast<float>(reader.u32_be());
    return file;
}

void look(const std::filesystem::path& path, int width, int height) {
    Report report;
    if (const auto map = read_distance_map(path, width); map.ok() && *map) {
        const StoredDistanceMap& stored = **map;
        require(stored.distance.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(width));
        const std::filesystem::path copy = fuzz_folder() / "again.exr";
        require(write_distance_map(copy, width, stored).ok());
        const auto again = read_distance_map(copy, width);
        require(again.ok() && *again && (*again)->distance == stored.distance &&
                (*again)->sees == stored.sees);
    }
    PassManifest manifest;
    manifest.width = width;
    manifest.height = std::max(1, height / 2); // the other half are extra fragments
    const auto pixels = static_cast<std::size_t>(manifest.width) * static_cast<std::size_t>(manifest.height);
    manifest.extra_count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) - pixels;
    for (const image::Chromaticities* assumed :
         {static_cast<const image::Chromaticities*>(nullptr), &image::kRec709})
        if (const auto picture = read_picture(path, width, height, 2, "", report, assumed); picture.ok())
            require(picture->size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto table = read_fragments(path.parent_path(), manifest);
    if (!table.ok()) return;
    require(table->extra_first.size() == pixels + 1 && table->extra_first.back() == manifest.extra_count);
    require(std::is_sorted(table->extra_first.begin(), table->extra_first.end()));
    require(table->fragments.size() == pixels + manifest.extra_count);
    require(write_fragments(fuzz_folder(), *table).ok());
    const auto again = read_fragments(fuzz_folder(), manifest);
    require(again.ok() && again->fragments == table->fragments && again->extra_first == table->extra_first);
    StoredLayer layer{std::vector<glm::vec3>(pixels, glm::vec3(2)),
                      std::vector<glm::vec3>(manifest.extra_count, glm::vec3(1))};
    require(from_stored(*table, layer).size() == table->fragments.size());
    require(
        write_layer(fuzz_folder(), "light", manifest.width, manifest.height, layer, 2, {{"ghost.key", "a"}})
            .ok());
    require(read_layer(fuzz_folder(), "light", *table, 2, "a", report).ok());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (const auto stage = parse_distance_stage(text, "fuzz"); stage.ok()) {
        const auto again = parse_distance_stage(distance_stage_text(*stage), "again");
        require(again.ok() && *again == *stage);
    }
    int width = 4, height = 4;
    if (text.starts_with("\x76\x2f\x31\x01")) {
        const auto file = image::read_exr(fuzz_file("fragments.exr", {data, size}));
        if (!file.ok()) return 0;
        width = file->pixels.width;
        height = file->pixels.height;
        if (width > 64 || height > 64) return 0; // larger ones go the same way
    } else {
        ByteReader reader(Bytes(data, size));
        const image::ExrFile file = exr_of(reader);
        width = file.pixels.width;
        height = file.pixels.height;
        require(image::write_exr(fuzz_folder() / "fragments.exr", file, image::ExrSample::full).ok());
    }
    look(fuzz_folder() / "fragments.exr", width, height);
    return 0;
}
