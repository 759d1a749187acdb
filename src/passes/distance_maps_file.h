#pragma once
// SPDX-License-Identifier: Apache-2.0
// The files of distance maps, in .ghost/distances/SIZE/ (docs/design/distance-maps.md). Each map says for
// which place and which stage it was made; stage.json says what the present stage consists of and which maps
// of earlier stages are right for it too. Every file is a true statement by itself, so nothing that is
// interrupted between two of them can make a map count for a stage that it does not show. Any thread.

#include "passes/distance_maps.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

// Raise it when the same stage gives other maps than before.
inline constexpr int kDistanceMapVersion = 2;

// One map that a show wants.
struct DistancePlace {
    std::string fixture;
    int stop = 0;
    int place = 0;
    glm::vec3 position_m{0};
    std::filesystem::path file;
};

// In the order of show.fixtures, their stops and places; fixtures without a type, and those that only glow,
// have none.
std::vector<DistancePlace> distance_places(const Show& show, int size);
// Each size has its own, so that who compares two sizes makes each map once.
std::filesystem::path distance_folder(const Show& show, int size);
// Version, size and position, to the last bit.
std::string place_key(const DistancePlace& place, int size);

struct StoredDistanceMap {
    std::vector<std::uint16_t> distance;
    std::string place;             // place_key
    std::string stage;             // DistanceStage::key when it was made
    std::string key;               // of place and stage
    std::vector<std::string> sees; // keys of the instances that it shows, 16 hex digits each
};
Result<void> write_distance_map(const std::filesystem::path& path, int size, const StoredDistanceMap& map);
// No value: there is no such file. Error: damaged, or of another size.
Result<std::optional<StoredDistanceMap>> read_distance_map(const std::filesystem::path& path, int size);

struct StageInstance {
    std::string key;  // 16 hex digits: shape, holes and place
    glm::vec3 low{0}; // bounds in world metres
    glm::vec3 high{0};

    bool operator==(const StageInstance&) const = default;
};
struct DistanceStage {
    std::string key;                      // 32 hex digits: of all instances
    std::vector<StageInstance> instances; // sorted by key
    std::vector<std::string> also_right;  // keys of maps made for another stage, sorted

    bool operator==(const DistanceStage&) const = default;
    // Whether the map shows this stage.
    bool holds_for(const StoredDistanceMap& map) const;
};
std::string distance_stage_text(const DistanceStage& stage);
Result<DistanceStage> parse_distance_stage(std::string_view text, const std::string& where);
// No value: there is no such file.
Result<std::optional<DistanceStage>> read_distance_stage(const std::filesystem::path& folder);
Result<void> write_distance_stage(const Show& show, int size, const DistanceStage& stage);

// The maps that `from` wants and its stage, copied to where `to` has its own of that size. What else lies
// there is not, nor a file that is larger than one of them can be. stop: asked before each.
void copy_distance_maps(const Show& from, const Show& to, int size, const std::function<bool()>& stop);

} // namespace ghost::scene
