// SPDX-License-Identifier: Apache-2.0
#include "passes/distance_maps_file.h"

#include "base/check.h"
#include "beam_groups/light_places.h"
#include "disk/files.h"
#include "disk/own_folder.h"
#include "image/exr.h"
#include "json_xml_toml/json.h"
#include "passes/passes_file.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace ghost::scene {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMaxStageBytes = std::uintmax_t{256} << 20;
constexpr std::uintmax_t kMostMapBytes = std::uintmax_t{32} << 20; // of a map's file, beside its texels
constexpr std::size_t kMaxInstances = 1000000;
constexpr std::size_t kInstanceKeyDigits = 16;
constexpr std::size_t kKeyDigits = 32;
constexpr char kStageFile[] = "stage.json";
constexpr char kMadeAgain[] = "; the map is made again";

bool is_key(std::string_view text, std::size_t digits) {
    return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string attribute(const image::ExrFile& file, const char* name) {
    const auto found = file.text.find(name);
    return found == file.text.end() ? std::string() : found->second;
}

bool is_missing(const fs::path& path) {
    std::error_code code;
    return fs::status(path, code).type() == fs::file_type::not_found;
}

// Key, then the six numbers of the bounds.
bool read_instance(const json& entry, StageInstance& instance) {
    if (!entry.is_array() || entry.size() != 7 || !entry[0].is_string()) return false;
    instance.key = entry[0].get<std::string>();
    for (int k = 0; k < 6; ++k) {
        const json& number = entry[static_cast<std::size_t>(k) + 1];
        if (!number.is_number() || !std::isfinite(number.get<float>())) return false;
        (k < 3 ? instance.low : instance.high)[k % 3] = number.get<float>();
    }
    return is_key(instance.key, kInstanceKeyDigits);
}

} // namespace

fs::path distance_folder(const Show& show, int size) {
    return show.cache_folder() / "distances" / std::to_string(size);
}

std::vector<DistancePlace> distance_places(const Show& show, int size) {
    std::vector<DistancePlace> places;
    std::set<std::string> names;
    for (const PatchedFixture& fixture : show.fixtures) {
        if (fixture.type == nullptr) continue;
        for (std::size_t stop = 0; stop < fixture.stops_m().size(); ++stop) {
            const std::vector<glm::vec3> lights_m = light_places_m(fixture, stop);
            for (std::size_t place = 0; place < lights_m.size(); ++place) {
                std::string name = file_name_of(fixture.name) + "_" + std::to_string(stop);
                if (place > 0) name += "_" + std::to_string(place);
                while (!names.insert(name).second) name += "_";
                places.push_back({fixture.name, static_cast<int>(stop), static_cast<int>(place),
                                  lights_m[place], distance_folder(show, size) / (name + ".exr")});
            }
        }
    }
    return places;
}

std::string place_key(const DistancePlace& place, int size) {
    char text[160];
    std::snprintf(text, sizeof text, "version %d size %d at %a %a %a", kDistanceMapVersion, size,
                  static_cast<double>(place.position_m.x), static_cast<double>(place.position_m.y),
                  static_cast<double>(place.position_m.z));
    return text;
}

Result<void> write_distance_map(const fs::path& path, int size, const StoredDistanceMap& map) {
    image::ExrFile file;
    file.pixels = image::ImageF(size, size, 1);
    CHECK_EQ(file.pixels.samples.size(), map.distance.size());
    file.channels = {"Z"};
    std::transform(map.distance.begin(), map.distance.end(), file.pixels.samples.begin(),
                   [](std::uint16_t half) { return glm::unpackHalf1x16(half); });
    std::string sees;
    for (const std::string& key : map.sees) sees += (sees.empty() ? "" : " ") + key;
    file.text = {
        {"ghost.place", map.place}, {"ghost.stage", map.stage}, {"ghost.key", map.key}, {"ghost.sees", sees}};
    return image::write_exr(path, file, image::ExrSample::half);
}

Result<std::optional<StoredDistanceMap>> read_distance_map(const fs::path& path, int size) {
    if (is_missing(path)) return std::optional<StoredDistanceMap>();
    auto file = image::read_exr(path, {size, size, 1});
    if (!file.ok()) return Error{file.error().what + kMadeAgain, file.error().where};
    const image::ImageF& pixels = file->pixels;
    const auto wrong = [&](const std::string& what) { return Error{what + kMadeAgain, path.string()}; };
    StoredDistanceMap map;
    map.place = attribute(*file, "ghost.place");
    map.stage = attribute(*file, "ghost.stage");
    map.key = attribute(*file, "ghost.key");
    if (!is_key(map.stage, kKeyDigits) || !is_key(map.key, kKeyDigits))
        return wrong("does not say which stage it shows");
    const std::string sees = attribute(*file, "ghost.sees");
    for (std::size_t at = 0; at < sees.size(); at += kInstanceKeyDigits + 1) {
        map.sees.push_back(sees.substr(at, kInstanceKeyDigits));
        if (!is_key(map.sees.back(), kInstanceKeyDigits)) return wrong("has a broken list of what it shows");
    }
    map.distance.reserve(pixels.samples.size());
    for (const float value : pixels.samples) {
        if (!(value >= 0.0f && value <= kNoSurface_m))
            return wrong("holds a distance that is not between 0 and " +
                         std::to_string(static_cast<int>(kNoSurface_m)) + " m");
        map.distance.push_back(to_half(value));
    }
    return std::optional(std::move(map));
}

bool DistanceStage::holds_for(const StoredDistanceMap& map) const {
    return map.stage == key || std::binary_search(also_right.begin(), also_right.end(), map.key);
}

std::string distance_stage_text(const DistanceStage& stage) {
    // One line for each instance.
    std::string text = "{\"version\": " + std::to_string(kDistanceMapVersion) + ",\n\"stage\": \"" +
                       stage.key + "\",\n\"also_right\": " + json(stage.also_right).dump() +
                       ",\n\"instances\": [";
    for (std::size_t k = 0; k < stage.instances.size(); ++k) {
        const StageInstance& i = stage.instances[k];
        text += k == 0 ? "\n" : ",\n";
        text += json::array({i.key, i.low.x, i.low.y, i.low.z, i.high.x, i.high.y, i.high.z}).dump();
    }
    return text + "]}\n";
}

Result<DistanceStage> parse_distance_stage(std::string_view text, const std::string& where) {
    const auto wrong = [&](const std::string& what) {
        return Error{what + "; all maps are made again", where};
    };
    const auto read = read_json(text, where, {.bytes = kMaxStageBytes, .values = 10 * kMaxInstances});
    if (!read.ok()) return wrong(read.error().what);
    const json& all = *read;
    if (!all.is_object()) return wrong("is not a JSON object");
    const auto entry = [&](const char* name) { return all.contains(name) ? all.at(name) : json(); };
    if (entry("version") != kDistanceMapVersion)
        return Error{"is of another version of Ghostlight; all maps are made again, once", where};
    DistanceStage stage;
    if (const json key = entry("stage"); key.is_string()) stage.key = key.get<std::string>();
    if (!is_key(stage.key, kKeyDigits)) return wrong("stage must be 32 hexadecimal digits");
    const json also = entry("also_right");
    const json instances = entry("instances");
    if (!also.is_array() || !instances.is_array() || also.size() > kMaxInstances ||
        instances.size() > kMaxInstances)
        return wrong("also_right and instances must be lists of at most a million entries");
    for (const json& key : also) {
        if (!key.is_string() || !is_key(key.get<std::string>(), kKeyDigits))
            return wrong("also_right must be keys of 32 hexadecimal digits");
        stage.also_right.push_back(key.get<std::string>());
    }
    std::sort(stage.also_right.begin(), stage.also_right.end());
    for (const json& instance : instances) {
        stage.instances.emplace_back();
        if (!read_instance(instance, stage.instances.back()))
            return wrong("instances[" + std::to_string(stage.instances.size() - 1) +
                         "] must be a key of 16 hexadecimal digits and six numbers");
    }
    std::sort(stage.instances.begin(), stage.instances.end(),
              [](const StageInstance& a, const StageInstance& b) { return a.key < b.key; });
    return stage;
}

Result<std::optional<DistanceStage>> read_distance_stage(const fs::path& folder) {
    const fs::path path = folder / kStageFile;
    if (is_missing(path)) return std::optional<DistanceStage>();
    TRY(const std::string text, read_text_file(path, kMaxStageBytes));
    TRY(DistanceStage stage, parse_distance_stage(text, path.string()));
    return std::optional(std::move(stage));
}

Result<void> write_distance_stage(const Show& show, int size, const DistanceStage& stage) {
    const fs::path folder = distance_folder(show, size);
    TRY_VOID(make_folders(folder, show.cache_home()));
    return write_file_atomic(folder / kStageFile, distance_stage_text(stage));
}

void copy_distance_maps(const Show& from, const Show& to, int size, const std::function<bool()>& stop) {
    const fs::path here = distance_folder(from, size), there = distance_folder(to, size);
    const auto maps = OwnFolder::open(here, from.cache_home());
    if (!maps.ok() || !make_folders(there, to.cache_home()).ok()) return;
    std::set<std::string> wanted;
    for (const DistancePlace& place : distance_places(from, size))
        wanted.insert(place.file.filename().string());
    const std::uintmax_t texels = static_cast<std::uintmax_t>(size) * static_cast<std::uintmax_t>(size);
    for (const OwnFolder::File& file : maps->entries().files) {
        if (stop()) return;
        const bool is_stage = file.name == kStageFile;
        if (!is_stage && !wanted.contains(file.name)) continue;
        std::error_code code;
        const std::uintmax_t bytes = fs::file_size(here / file.name, code);
        if (code || bytes > (is_stage ? kMaxStageBytes : kMostMapBytes + sizeof(float) * texels)) continue;
        fs::remove(there / file.name, code); // a link would be written through
        fs::copy_file(here / file.name, there / file.name, code);
    }
}

} // namespace ghost::scene
