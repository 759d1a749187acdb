// SPDX-License-Identifier: Apache-2.0
#include "show_file/private/media_toml.h"

#include "base/suggest.h"
#include "dmx/wire/universes.h"
#include "show_file/scene_toml.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace ghost::scene {
namespace {

constexpr std::array<std::string_view, 4> kCards{"grid", "bars", "ramp", "white"};
constexpr std::array<std::pair<std::string_view, Fit>, 3> kFits{
    {{"contain", Fit::contain}, {"cover", Fit::cover}, {"stretch", Fit::stretch}}};

template <class Value>
void put(float& target, const std::optional<Value>& value) {
    if (value) target = static_cast<float>(*value);
}

std::vector<std::string> names_of(const std::vector<Media>& media) {
    std::vector<std::string> names;
    for (const Media& one : media) names.push_back(one.name);
    return names;
}

int find_media(const std::vector<Media>& media, const std::string& name) {
    const auto found =
        std::find_if(media.begin(), media.end(), [&](const Media& one) { return one.name == name; });
    return found == media.end() ? -1 : static_cast<int>(found - media.begin());
}

// What stands in where a projector has nothing to show.
int test_card(Show& show) {
    const auto found = std::find_if(show.media.begin(), show.media.end(),
                                    [](const Media& one) { return one.kind == MediaKind::card; });
    if (found != show.media.end()) return static_cast<int>(found - show.media.begin());
    Media card;
    card.name = "test card";
    card.kind = MediaKind::card;
    show.media.push_back(std::move(card));
    return static_cast<int>(show.media.size()) - 1;
}

// The media key of what shows a picture; without one the first medium, or a test card.
int read_medium(TableReader& reader, Show& show) {
    int media = show.media.empty() ? -1 : 0;
    if (const auto name = reader.text("media")) {
        media = find_media(show.media, *name);
        if (media < 0)
            reader.problem(Severity::error, "media",
                           "names '" + name->substr(0, 40) + "', which no [[media]] has" +
                               reader.did_you_mean(*name, names_of(show.media)) + "; it shows a test card");
    }
    return media < 0 ? test_card(show) : media;
}

void read_fit(TableReader& reader, Fit& fit) {
    const auto name = reader.text("fit");
    if (!name) return;
    const auto* const found =
        std::find_if(kFits.begin(), kFits.end(), [&](const auto& one) { return one.first == *name; });
    if (found != kFits.end())
        fit = found->second;
    else
        reader.problem(Severity::error, "fit",
                       "is '" + name->substr(0, 40) + "', expected contain, cover or stretch; it is contain");
}

// The channel that chooses the medium.
void read_select(TableReader& reader, const std::string& section, const std::string& file, int& universe_of,
                 int& address_of, Report& report) {
    const toml::table* select = reader.table("select");
    if (!select) return;
    TableReader channel(*select, section + " select", file, report);
    const auto universe = channel.integer("universe", 1, dmx::kMaxUniverse);
    const auto address = channel.integer("address", 1, 512);
    for (const char* key : {"universe", "address"})
        if (!channel.has(key))
            channel.missing(key, "universe and address of the channel that chooses the medium");
    channel.finish();
    if (!universe || !address) return;
    universe_of = *universe;
    address_of = *address;
}

} // namespace

void read_media(TableReader& top, const std::string& file, Show& show, Report& report) {
    for (const toml::table* table : top.tables("media", kMaxMedia - 1)) {
        TableReader reader(*table, "[[media]]", file, report);
        Media media;
        media.where = file_line(file, reader.line());
        const std::string stand_in = "Media " + std::to_string(show.media.size() + 1);
        media.name = reader.text("name").value_or(stand_in);
        if (media.name.empty()) {
            reader.problem(Severity::error, "name",
                           "is empty, expected a name; it is called '" + stand_in + "'");
            media.name = stand_in;
        }
        if (find_media(show.media, media.name) >= 0) {
            reader.problem(Severity::error, "name",
                           "'" + media.name + "' is taken, expected a name of its own; this one is not used");
            media.name += " (2)";
        }
        const auto path = reader.text("file");
        const auto camera = reader.text("camera");
        const auto card = reader.text("card");
        if (path) media.file = show.folder / *path;
        if (camera) {
            media.kind = MediaKind::camera;
            media.file = show.folder / *camera; // a path from the root stays as it is
        }
        if (card || (!path && !camera)) media.kind = MediaKind::card;
        if (card) media.card = *card;
        if (card && std::find(kCards.begin(), kCards.end(), *card) == kCards.end()) {
            reader.problem(Severity::error, "card",
                           "is '" + card->substr(0, 40) +
                               "', expected grid, bars, ramp or white; it is grid");
            media.card = "grid";
        }
        if (!reader.has("file") && !reader.has("camera") && !reader.has("card"))
            reader.missing("file", "a movie or picture (or camera = a device, or card = \"grid\")");
        if ((path ? 1 : 0) + (camera ? 1 : 0) + (card ? 1 : 0) > 1)
            reader.problem(Severity::warning, "file",
                           "file, camera and card say different things, expected one of them");
        if (const auto loop = reader.boolean("loop")) media.loop = *loop;
        media.start_s = reader.number("start_s", 0, 1e6).value_or(0.0);
        reader.finish();
        show.media.push_back(std::move(media));
    }
}

Projector read_projector(const toml::table& table, const std::string& section, const std::string& file,
                         Show& show, std::optional<glm::vec3>& target_m, Report& report) {
    TableReader reader(table, section + " projector", file, report);
    Projector projector;
    projector.media = read_medium(reader, show);
    put(projector.lumens, reader.number("lumens", 1, 1e6));
    put(projector.throw_ratio, reader.number("throw_ratio", 0.1, 100));
    put(projector.aspect, reader.number("aspect", 0.1, 10));
    if (const auto shift = reader.numbers("lens_shift", 2, -2, 2))
        projector.lens_shift = {(*shift)[0], (*shift)[1]};
    if (const auto keystone = reader.numbers("keystone_deg", 2, -60, 60))
        projector.keystone_deg = {(*keystone)[0], (*keystone)[1]};
    put(projector.contrast, reader.number("contrast", 1, 1e7));
    if (const auto blend = reader.numbers("edge_blend", 4, 0, 1))
        for (int k = 0; k < 4; ++k)
            projector.blend[k] = static_cast<float>((*blend)[static_cast<std::size_t>(k)]);
    read_fit(reader, projector.fit);
    put(projector.focus_m, reader.number("focus_m", 0.1, 1000));
    target_m = reader.vec3("target_m", kMaxCoordinate_m);
    read_select(reader, section + " projector", file, projector.universe, projector.address, report);
    reader.finish();
    return projector;
}

LedWall read_wall(TableReader& reader, const std::string& section, const std::string& file, bool of_plot,
                  Show& show, Report& report) {
    LedWall wall;
    wall.media = read_medium(reader, show);
    if (!of_plot) {
        if (const auto size = reader.numbers("size_m", 2, 0.1, 200))
            wall.size_m = {static_cast<float>((*size)[0]), static_cast<float>((*size)[1])};
        else if (!reader.has("size_m"))
            reader.missing("size_m", "width and height, [4, 2.25]; it is that large");
    }
    put(wall.nits, reader.number("nits", 1, 20000));
    if (const auto pitch_mm = reader.number("pitch_mm", 0.5, 500))
        wall.pitch_m = static_cast<float>(*pitch_mm * 1e-3);
    if (const auto cells = reader.integers("cells", 2, 1, kMostWallCells))
        wall.cells = {(*cells)[0], (*cells)[1]};
    read_fit(reader, wall.fit);
    read_select(reader, section, file, wall.universe, wall.address, report);
    reader.finish();
    return wall;
}

std::vector<WallSettings> read_walls(TableReader& top, const std::string& file, Show& show, Report& report) {
    constexpr std::size_t kMostWalls = 1000;
    std::vector<WallSettings> walls;
    for (const toml::table* table : top.tables("wall", kMostWalls)) {
        TableReader reader(*table, "[[wall]]", file, report);
        WallSettings settings;
        settings.where = file_line(file, reader.line());
        const auto name = reader.text("name");
        if (!reader.has("name"))
            reader.missing("name", "that of a screen of the plot, or \"*\" for all of them");
        settings.wall = read_wall(reader, "[[wall]]", file, true, show, report);
        if (!name) continue;
        settings.name = *name;
        walls.push_back(std::move(settings));
    }
    return walls;
}

} // namespace ghost::scene
