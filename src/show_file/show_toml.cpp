// SPDX-License-Identifier: Apache-2.0
#include "show_file/show_toml.h"

#include "dmx/wire/universes.h"
#include "json_xml_toml/toml_problem.h"
#include "json_xml_toml/toml_reader.h"
#include "show/limits.h"
#include "show/names.h"
#include "show_file/private/laser_toml.h"
#include "show_file/private/media_toml.h"
#include "show_file/scene_toml.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace ghost::scene {
namespace {

constexpr float kSamePlace_m = 1e-4f;
constexpr std::size_t kMaxCameras = 256;
constexpr std::size_t kMaxStops = 64;
constexpr std::size_t kMaxHidden = 1000;
constexpr std::size_t kMaxChanges = 100'000;
constexpr int kMaxPictureSide = 16384;
constexpr double kLongestOffset_s = 86'400;

template <class Target, class Value>
void put_value(Target& target, const std::optional<Value>& value) {
    if (value) target = static_cast<Target>(*value);
}

// Those that are as written.
std::set<std::string> good_names_of(std::span<const toml::table* const> tables) {
    std::set<std::string> names;
    for (const toml::table* table : tables)
        if (const auto text = (*table)["name"].value<std::string>(); text && is_good_name(*text))
            names.insert(*text);
    return names;
}

// The entry's name, made usable and unique. as_written: of all entries; these keep theirs.
std::string name_of(TableReader& reader, const std::string& kind, std::size_t number,
                    std::map<std::string, int>& line_of_name, const std::set<std::string>& as_written) {
    std::string name = kind + " " + std::to_string(number);
    if (const auto text = reader.text("name")) {
        const bool is_good = is_good_name(*text);
        const std::string near = good_name(*text);
        if (!near.empty()) name = near;
        const std::string alone = name;
        for (int copy = 2; !is_good && (line_of_name.count(name) || as_written.count(name)); ++copy)
            name = alone + " (" + std::to_string(copy) + ")";
        if (!is_good)
            reader.problem(Severity::warning, "name",
                           "'" + text->substr(0, 40) +
                               "' cannot name a file (1 to 100 bytes, no leading dot, none of "
                               "/\\:*?\"<>|); it is called '" +
                               name + "'");
    } else if (!reader.has("name")) {
        reader.problem(Severity::note, "name", "is missing; it is called '" + name + "'");
    }
    const std::string wanted = name;
    for (int copy = 2; line_of_name.count(name); ++copy) name = wanted + " (" + std::to_string(copy) + ")";
    if (name != wanted)
        reader.problem(Severity::error, "name",
                       "'" + wanted + "' is taken by line " + std::to_string(line_of_name[wanted]) +
                           ", expected a name of its own; it is called '" + name + "'");
    line_of_name[name] = reader.line_of("name");
    return name;
}

Camera read_camera(TableReader& reader, const std::filesystem::path& folder) {
    Camera camera;
    const auto position = reader.vec3("position_m", kMaxCoordinate_m);
    const auto target = reader.vec3("target_m", kMaxCoordinate_m);
    if (!reader.has("position_m")) reader.missing("position_m", "where the eye is, [x, y, z]");
    if (!reader.has("target_m"))
        reader.missing("target_m", "a point in the middle of the picture, [x, y, z]");
    put_value(camera.position_m, position);
    put_value(camera.target_m, target);
    if (glm::distance(camera.position_m, camera.target_m) < 1e-4f) {
        reader.problem(Severity::error, "target_m",
                       "is where the camera is, expected another point; it looks up-stage");
        camera.target_m = camera.position_m + glm::vec3(0, 1, 0);
    }
    put_value(camera.fov_y_deg, reader.number("fov_y_deg", 0.1, 170));
    if (const auto size = reader.integers("size", 2, 1, kMaxPictureSide)) {
        camera.width = (*size)[0];
        camera.height = (*size)[1];
    }
    const auto ev100 = reader.number("ev100", -20, 30);
    put_value(camera.ev100, ev100);
    if (const auto exposure = reader.text("exposure")) {
        camera.auto_exposure = *exposure == "auto";
        if (*exposure != "auto")
            reader.problem(Severity::error, "exposure",
                           "is '" + exposure->substr(0, 40) +
                               "', expected \"auto\" (or ev100 = a number instead)");
        else if (ev100)
            reader.problem(Severity::warning, "ev100", "is not used: exposure is \"auto\"");
    }
    if (const auto passes = reader.text("foreign_passes")) camera.foreign_passes = folder / *passes;
    return camera;
}

std::optional<Track> read_track(const toml::table& table, const std::string& section, const std::string& file,
                                Report& report) {
    TableReader reader(table, section + " track", file, report);
    Track track;
    const auto stops = reader.vec3_list("stops_m", 2, kMaxStops, kMaxCoordinate_m);
    const auto universe = reader.integer("universe", 1, dmx::kMaxUniverse);
    const auto address = reader.integer("address", 1, 511);
    for (const char* key : {"stops_m", "universe", "address"})
        if (!reader.has(key)) reader.missing(key, "stops_m, universe and address of the travel (16 bit)");
    reader.finish();
    if (!stops || !universe || !address) return std::nullopt;
    return Track{*stops, *universe, *address};
}

PatchedFixture read_fixture(TableReader& reader, const std::string& name, const std::string& file,
                            FixtureSource& source, Show& show, Report& report) {
    const std::string section = "[[fixture]] '" + name + "'";
    PatchedFixture fixture;
    fixture.name = name;
    source.line = reader.line();
    if (const auto gdtf = reader.text("gdtf")) fixture.gdtf = *gdtf;
    if (!reader.has("gdtf") && !reader.has("projector") && !reader.has("wall") && !reader.has("laser"))
        reader.missing("gdtf", "the name of a .gdtf file; the fixture stays dark");
    source.gdtf_line = reader.line_of("gdtf");
    source.mode = reader.text("mode").value_or("");
    source.mode_line = reader.line_of("mode");
    source.photometry = reader.text("photometry").value_or("");
    source.photometry_line = reader.line_of("photometry");

    if (fixture.gdtf.empty() && reader.has("mode"))
        reader.problem(Severity::warning, "mode", "is not used: without a gdtf there is one mode only");
    const auto universe = reader.integer("universe", 1, dmx::kMaxUniverse);
    put_value(fixture.universe, universe);
    const auto address = reader.integer("address", 0, 512); // 0: nowhere
    const bool is_universe_known = universe || !reader.has("universe");
    // In a universe that nobody names it would have the light of another fixture.
    fixture.address = is_universe_known ? address.value_or(0) : 0;
    fixture.is_address_known = is_universe_known && (address || !reader.has("address"));
    if (address == 0)
        reader.problem(Severity::warning, "address",
                       "is 0: the fixture is not patched and keeps its defaults");
    source.address_line = reader.line_of("address");
    if (!reader.has("address") && !reader.has("projector") && !reader.has("wall") && !reader.has("laser"))
        reader.problem(Severity::warning, "address",
                       "is missing: the fixture is not patched and keeps its defaults");

    if (const auto more = reader.pairs("more_addresses", kMaxBreaks, {1, 0}, {dmx::kMaxUniverse, 512}))
        for (const glm::ivec2& place : *more) fixture.more_addresses.push_back({place.x, place.y});
    else if (reader.has("more_addresses"))
        fixture.is_address_known = false;
    fixture.circuit = reader.text("circuit").value_or("");
    fixture.invert_pan = reader.boolean("invert_pan").value_or(false);
    fixture.invert_tilt = reader.boolean("invert_tilt").value_or(false);

    if (const toml::table* track = reader.table("track")) {
        fixture.track = read_track(*track, section, file, report);
        source.track_line = reader.line_of("track");
    }
    const auto position = reader.vec3("position_m", kMaxCoordinate_m);
    put_value(fixture.position_m, position);
    fixture.is_place_known = position || fixture.track;
    if (fixture.track) {
        fixture.position_m = fixture.track->stops_m.front();
        if (position)
            reader.problem(Severity::warning, "position_m", "is not used: the track says where it hangs");
    } else if (!reader.has("position_m")) {
        reader.missing("position_m", "where it hangs, [x, y, z]; it is at the origin");
    }
    const auto rotation = reader.vec3("rotation_deg", 360);
    put_value(fixture.rotation_deg, rotation);
    fixture.is_rotation_known = rotation || !reader.has("rotation_deg");
    if (const toml::table* table = reader.table("projector")) {
        std::optional<glm::vec3> target_m;
        fixture.projector = read_projector(*table, section, file, show, target_m, report);
        if (target_m) {
            fixture.rotation_deg = rotation_towards(fixture.position_m, *target_m);
            fixture.is_rotation_known = true;
        }
        if (target_m && glm::distance(*target_m, fixture.position_m) < kSamePlace_m)
            reader.problem(
                Severity::error, "projector",
                "target_m is where the projector itself is, expected another point; it shines straight down");
        if (target_m && rotation)
            reader.problem(Severity::warning, "rotation_deg",
                           "is not used: target_m of the projector says it");
    }
    if (const toml::table* table = reader.table("laser")) {
        fixture.laser = read_laser(*table, section, file, report);
        if (fixture.projector) {
            reader.problem(Severity::warning, "laser", "is not used: the fixture is a projector");
            fixture.laser.reset();
        }
    }
    if (const toml::table* table = reader.table("wall")) {
        TableReader wall(*table, section + " wall", file, report);
        fixture.wall = read_wall(wall, section + " wall", file, false, show, report);
        const auto leave_out = [&](const char* key, bool is_there) {
            if (is_there)
                reader.problem(Severity::warning, key,
                               "is not used: a wall is of its own type and does not travel");
        };
        leave_out("gdtf", reader.has("gdtf"));
        leave_out("projector", fixture.projector.has_value());
        leave_out("laser", fixture.laser.has_value());
        leave_out("track", fixture.track.has_value());
        fixture.gdtf.clear();
        fixture.projector.reset();
        fixture.laser.reset();
        fixture.track.reset();
    }
    if (const auto home = reader.numbers("home_deg", 2, -720, 720)) {
        fixture.home_pan_deg = static_cast<float>((*home)[0]);
        fixture.home_tilt_deg = static_cast<float>((*home)[1]);
    }
    return fixture;
}

void read_sections(const toml::table& root, const std::string& file, ParsedShow& parsed, Report& report) {
    Show& show = parsed.show;
    TableReader top(root, "show file:", file, report);
    std::string ambient_where; // file:line, where it is given
    if (const toml::table* table = top.table("show")) {
        TableReader reader(*table, "[show]", file, report);
        put_value(show.name, reader.text("name"));
        if (const auto stage = reader.text("stage")) show.stage_file = show.folder / *stage;
        if (const auto plot = reader.text("plot")) show.plot_file = show.folder / *plot;
        parsed.plot_line = reader.line_of("plot");
        if (!reader.has("stage") && !reader.has("plot"))
            reader.missing("stage", "the name of a model file (.glb), or plot = that of an .mvr");
        show.hidden_layers = reader.texts("hide_layers", kMaxHidden).value_or(std::vector<std::string>{});
        show.hidden_classes = reader.texts("hide_classes", kMaxHidden).value_or(std::vector<std::string>{});
        parsed.hidden_layers_line = reader.line_of("hide_layers");
        parsed.hidden_classes_line = reader.line_of("hide_classes");
        parsed.stage_line = reader.line_of("stage");
        if (const auto recording = reader.text("recording")) show.recording = show.folder / *recording;
        parsed.recording_line = reader.line_of("recording");
        put_value(show.begin_s, reader.number("begin_s", 0, kLongestOffset_s));
        if (reader.has("begin_s") && !reader.has("recording"))
            reader.problem(Severity::warning, "begin_s",
                           "is not used: there is no recording (recording = the name of a file)");
        if (const auto sound = reader.text("sound")) show.sound.file = show.folder / *sound;
        put_value(show.sound.offset_s, reader.number("sound_offset_s", -kLongestOffset_s, kLongestOffset_s));
        show.sound.where = reader.where("sound");
        if (reader.has("sound_offset_s") && !reader.has("sound"))
            reader.problem(Severity::warning, "sound_offset_s",
                           "is not used: there is no sound (sound = the name of a file)");
        if (const auto motion = reader.text("motion")) {
            if (const auto chosen = fixture::motion_from(*motion))
                show.motion = *chosen;
            else
                reader.problem(Severity::error, "motion",
                               "is '" + motion->substr(0, 40) +
                                   "', expected \"machine\" (speed and inertia of the fixtures) or "
                                   "\"commanded\" (at once); it is \"machine\"");
        }
        put_value(show.shutter_deg, reader.number("shutter_deg", 1, 360));
        if (const auto side = reader.integer("media_px", 128, 2048)) {
            if (std::has_single_bit(static_cast<unsigned>(*side)))
                show.media_side = *side;
            else
                reader.problem(Severity::error, "media_px",
                               "is " + std::to_string(*side) +
                                   ", expected 128, 256, 512, 1024 or 2048; it is " +
                                   std::to_string(show.media_side));
        }
        const auto ambient = reader.number("ambient_lux", 0, kMaxAmbient_lux);
        put_value(show.ambient_lux, ambient);
        if (ambient) ambient_where = reader.where("ambient_lux");
        reader.finish();
    } else if (!top.has("show")) {
        top.missing("show", "a section [show] with name and stage");
    }
    read_scene_sections(top, file, ambient_where, show, report);

    show.tracking = read_tracking(top, file, report);
    show.movers = read_movers(top, file, report);
    show.circuits = read_circuits(top, file, report);
    show.cues = read_cues(top, file, report);
    show.palettes = read_palettes(top, file, report);
    read_media(top, file, show, report);
    read_models(top, file, show, report);
    parsed.walls = read_walls(top, file, show, report);
    if (!parsed.walls.empty() && show.plot_file.empty())
        report.add(Severity::error, parsed.walls.front().where,
                   "[[wall]] is about screens of a plot, and [show] has none (plot = \"name.mvr\"); a wall "
                   "of its own is a "
                   "[[fixture]] with wall = { ... }");
    std::map<std::string, int> cameras;
    const std::vector<const toml::table*> camera_tables = top.tables("camera", kMaxCameras);
    const std::set<std::string> good_cameras = good_names_of(camera_tables);
    for (const toml::table* table : camera_tables) {
        TableReader reader(*table, "[[camera]]", file, report);
        const std::string name = name_of(reader, "Camera", show.cameras.size() + 1, cameras, good_cameras);
        show.cameras.push_back(read_camera(reader, show.folder));
        show.cameras.back().name = name;
        parsed.passes_lines.push_back(reader.line_of("foreign_passes"));
        reader.finish();
    }
    std::map<std::string, int> fixtures;
    const std::vector<const toml::table*> fixture_tables = top.tables("fixture", kMaxFixtures);
    const std::set<std::string> good_fixtures = good_names_of(fixture_tables);
    for (const toml::table* table : fixture_tables) {
        TableReader reader(*table, "[[fixture]]", file, report);
        const std::string name =
            name_of(reader, "Fixture", show.fixtures.size() + 1, fixtures, good_fixtures);
        parsed.sources.emplace_back();
        show.fixtures.push_back(read_fixture(reader, name, file, parsed.sources.back(), show, report));
        if (const auto text = (*table)["name"].value<std::string>(); text && !is_good_name(*text))
            show.fixtures.back().written_name = *text;
        reader.finish();
    }
    for (const toml::table* table : top.tables("change", kMaxChanges)) {
        TableReader reader(*table, "[[change]]", file, report);
        parsed.changes.push_back(read_change(reader));
    }
    for (const toml::table* table : top.tables("substitute", kMaxHidden)) {
        TableReader reader(*table, "[[substitute]]", file, report);
        SubstituteEntry entry = read_substitute(reader);
        if (!entry.spec.empty() && !entry.gdtf.empty()) parsed.substitutes.push_back(std::move(entry));
    }
    for (const toml::table* table : top.tables("photometry", kMaxHidden)) {
        TableReader reader(*table, "[[photometry]]", file, report);
        PhotometryEntry entry = read_photometry(reader);
        if (!entry.spec.empty() && !entry.file.empty()) parsed.photometry.push_back(std::move(entry));
    }
    if (!parsed.changes.empty() && show.plot_file.empty())
        report.add(Severity::error, parsed.changes.front().where,
                   "[[change]] changes a plot, and [show] has none (plot = \"name.mvr\")");
    top.finish();
}

} // namespace

Result<ParsedShow> parse_show(std::string_view text, const std::filesystem::path& file, Report& report) {
    ParsedShow parsed;
    parsed.show.file = file;
    parsed.show.folder = file.parent_path();
    parsed.show.name = file.parent_path().filename().string();
    try {
        const toml::table root = toml::parse(text, file.string());
        read_sections(root, file.string(), parsed, report);
    } catch (const toml::parse_error& problem) {
        const TomlProblem found = toml_problem(problem);
        return Error{found.what, file_line(file.string(), found.line)};
    }
    if (parsed.show.cameras.empty() && parsed.show.plot_file.empty())
        report.add(Severity::warning, file.string(),
                   "has no [[camera]]: three are made from where the fixtures hang; a camera that is kept in "
                   "the window (Ctrl+K), or written here, takes their place");
    return parsed;
}

} // namespace ghost::scene
