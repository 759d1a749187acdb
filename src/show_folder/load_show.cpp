// SPDX-License-Identifier: Apache-2.0
#include "show_folder/load_show.h"

#include "base/text.h"
#include "show_folder/private/extra_models.h"

#include "base/suggest.h"
#include "disk/files.h"
#include "disk/user_cache.h"
#include "fixture/patch.h"
#include "json_xml_toml/toml_reader.h"
#include "plots/plot_changes.h"
#include "plots/plot_show.h"
#include "plots/plot_types.h"
#include "show/default_cameras.h"
#include "show_file/show_edit.h"
#include "show_file/show_toml.h"
#include "show_folder/private/show_types.h"
#include "stage/model_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kListedOverlaps = 20; // of a plot's fixtures
// Shares of the time that loading a plot takes.
constexpr double kPlotShare = 0.15;
constexpr double kFixturesShare = 0.45;

fixture::Type of_channels(int count) {
    fixture::Type made;
    made.modes.emplace_back();
    made.modes.back().footprint = {count};
    return made;
}

// The two channels of a track, seen as a fixture, and the one that chooses a medium.
const fixture::Type& track_type() {
    static const fixture::Type type = of_channels(2);
    return type;
}
const fixture::Type& select_type() {
    static const fixture::Type type = of_channels(1);
    return type;
}

// A zoom channel that a stated throw ratio makes useless.
bool has_idle_zoom(const PatchedFixture& fixture) {
    if (!fixture.projector || !(fixture.projector->throw_ratio > 0) || !fixture.type) return false;
    for (const fixture::Channel& channel :
         fixture.type->modes[static_cast<std::size_t>(fixture.mode)].channels)
        for (const fixture::ChannelFunction& function : channel.functions)
            if (function.meaning.role == fixture::Role::zoom) return true;
    return false;
}

std::string plot_place(const Show& show, const ObjectIndex& index, const PatchedFixture& fixture) {
    const int object = index.find(fixture.uuid);
    if (object < 0) return show.plot_file.string();
    return place_of(*show.plot, show.plot->plot.objects[static_cast<std::size_t>(object)]);
}

// Where a patch is said to be, for messages: by the other one of a pair, and as their place.
struct Patched {
    std::string who;
    std::string where;
    bool of_plot = false;
};

std::string overlap_text(const fixture::Overlap& overlap, const std::string& first, const std::string& where,
                         const std::string& second, bool same) {
    return "'" + second + "' shares universe " + std::to_string(overlap.universe) + " channels " +
           std::to_string(overlap.channel_from) + " to " + std::to_string(overlap.channel_to) + " with '" +
           first + "' (" + where + ")" +
           (same ? "; they will do the same" : ", expected channels of its own");
}

void check_addresses(const ParsedShow& parsed, Report& report) {
    const Show& show = parsed.show;
    const std::string file = show.file.string();
    const Plot none;
    const ObjectIndex index(show.plot ? show.plot->plot : none);
    std::vector<fixture::Patch> patches;
    std::vector<Patched> places;
    for (std::size_t k = 0; k < show.fixtures.size(); ++k) {
        const PatchedFixture& fixture = show.fixtures[k];
        const bool of_plot = k >= parsed.sources.size();
        const int line = of_plot ? 0 : parsed.sources[k].address_line;
        std::string where = of_plot ? plot_place(show, index, fixture) : file_line(file, line);
        const bool is_patched =
            fixture.address > 0 ||
            std::any_of(fixture.more_addresses.begin(), fixture.more_addresses.end(),
                        [](const fixture::Address& address) { return address.channel > 0; });
        if (fixture.type && is_patched) {
            patches.push_back(fixture.patch());
            const std::string who = of_plot ? "fixture '" : "[[fixture]] '";
            for (const std::string& problem : fixture::check_patch(patches.back()))
                // Fixtures of a plot often stand across the end of a universe, or use one break of four.
                report.add(of_plot ? Severity::note : Severity::warning, where,
                           who + fixture.name + "' " + problem);
            places.push_back({of_plot ? where : "line " + std::to_string(line), std::move(where), of_plot});
        }
        if (!of_plot && has_idle_zoom(fixture))
            report.add(
                Severity::warning, file_line(file, parsed.sources[k].line),
                "[[fixture]] '" + fixture.name +
                    "' projector throw_ratio says how wide the picture is: its zoom channel does nothing");
        const int select_universe =
            fixture.projector ? fixture.projector->universe : (fixture.wall ? fixture.wall->universe : 0);
        const int select_address =
            fixture.projector ? fixture.projector->address : (fixture.wall ? fixture.wall->address : 0);
        if (!of_plot && select_address > 0) {
            patches.push_back(
                {fixture.name + "' select '", &select_type(), 0, {{select_universe, select_address}}});
            const int select_line = parsed.sources[k].line;
            places.push_back({"line " + std::to_string(select_line), file_line(file, select_line)});
        }
        if (fixture.track) {
            patches.push_back({fixture.name + "' track '",
                               &track_type(),
                               0,
                               {{fixture.track->universe, fixture.track->address}}});
            const int track_line = parsed.sources[k].track_line;
            places.push_back({"line " + std::to_string(track_line), file_line(file, track_line)});
        }
    }
    std::size_t of_plot = 0;
    for (const fixture::Overlap& overlap : fixture::find_overlaps(patches)) {
        const fixture::Patch& first = patches[overlap.first];
        const fixture::Patch& second = patches[overlap.second];
        const Patched& place = places[overlap.second];
        // Designers patch rigs in parts and use one address for many; a screenful of that says it.
        if (place.of_plot && ++of_plot > kListedOverlaps) continue;
        const bool same = first.type == second.type && first.mode == second.mode &&
                          first.addresses[0].universe == second.addresses[0].universe &&
                          first.addresses[0].channel == second.addresses[0].channel;
        report.add(same || place.of_plot ? Severity::warning : Severity::error, place.where,
                   overlap_text(overlap, first.name, places[overlap.first].who, second.name, same));
    }
    if (of_plot > kListedOverlaps)
        report.add(Severity::warning, show.plot->name,
                   std::to_string(of_plot - kListedOverlaps) + " more pairs of fixtures share channels");
}

void check_files(const ParsedShow& parsed, Report& report) {
    const Show& show = parsed.show;
    const std::string file = show.file.string();
    if (!show.recording.empty() && !is_file(show.recording))
        report.add(Severity::error, file_line(file, parsed.recording_line),
                   "[show] recording: " + missing_file(show.recording));
    if (!show.sound.file.empty() && !is_file(show.sound.file))
        report.add(Severity::error, show.sound.where,
                   "[show] sound: " + missing_file(show.sound.file) + " Films are silent.");
    for (const Media& media : show.media)
        if (media.kind == MediaKind::file && !is_file(media.file))
            report.add(Severity::error, media.where,
                       "[[media]] '" + media.name + "' file: " + missing_file(media.file) +
                           " A striped card is shown.");
    if (!show.plot_file.empty() && !is_file(show.plot_file))
        report.add(Severity::error, file_line(file, parsed.plot_line),
                   "[show] plot: " + missing_file(show.plot_file) + " Its fixtures and stage are missing.");
    if (!show.stage_file.empty() && !is_file(show.stage_file))
        report.add(Severity::error, file_line(file, parsed.stage_line),
                   "[show] stage: " + missing_file(show.stage_file) + " The stage is empty.");
    check_models(show, report);
    for (std::size_t k = 0; k < show.cameras.size(); ++k)
        if (const Camera& camera = show.cameras[k];
            !camera.foreign_passes.empty() && !is_file(camera.foreign_passes))
            report.add(Severity::error, file_line(file, parsed.passes_lines[k]),
                       "[[camera]] '" + camera.name +
                           "' foreign_passes: " + missing_file(camera.foreign_passes));
}

// A part of the whole way, for the bar.
ShowLoading part_of(const ShowLoading& loading, double from, double to) {
    ShowLoading part{{}, loading.stop};
    if (loading.progress)
        part.progress = [&loading, from, to](double share, const std::string& what) {
            loading.progress(from + share * (to - from), what);
        };
    return part;
}

void check_hidden(const Show& show, const std::vector<std::string>& hidden, bool layers,
                  const std::string& where, Report& report) {
    std::vector<std::string> names;
    for (const PlotLayer& layer : show.plot->plot.layers)
        if (layers) names.push_back(layer.name);
    for (const PlotName& plot_class : show.plot->plot.classes)
        if (!layers) names.push_back(plot_class.name);
    std::set<std::string> known;
    for (const std::string& name : names) known.insert(lower(name));
    Suggestions suggestions;
    for (const std::string& name : hidden) {
        if (!known.contains(lower(name)))
            report.add(Severity::warning, where,
                       std::string(layers ? "[show] hide_layers: the plot has no layer '"
                                          : "[show] hide_classes: the plot has no class '") +
                           name.substr(0, 60) + "'" + suggestions.did_you_mean(name, names));
    }
}

// Fixtures of the plot, with the changes of the show file. Error: stopped.
Result<void> open_plot(ParsedShow& parsed, Report& report, const ShowLoading& loading) {
    Show& show = parsed.show;
    auto loaded = load_plot(show.plot_file, report, part_of(loading, 0.0, kPlotShare));
    if (!loaded.ok()) {
        if (loading.stop && loading.stop()) return loaded.error();
        report.add(Severity::error, loaded.error().where,
                   loaded.error().what + "; its fixtures and stage are missing");
        return {};
    }
    show.plot = std::move(*loaded);
    show.plot_origin_m = origin_of(show.plot->plot);
    if (show.plot_origin_m != glm::dvec3(0.0))
        report.add(Severity::note, show.plot->name,
                   "lies far from its origin; it is moved there by " +
                       std::to_string(std::lround(show.plot_origin_m.x / 1000)) + ", " +
                       std::to_string(std::lround(show.plot_origin_m.y / 1000)) + ", " +
                       std::to_string(std::lround(show.plot_origin_m.z / 1000)) + " km (x, y, z)");
    if (!parsed.changes.empty()) show.plot->unchanged = std::make_shared<const Plot>(show.plot->plot);
    apply_changes(show.plot->plot, parsed.changes, show.plot_origin_m, report);
    const std::string file = show.file.string();
    check_hidden(show, show.hidden_layers, true, file_line(file, parsed.hidden_layers_line), report);
    check_hidden(show, show.hidden_classes, false, file_line(file, parsed.hidden_classes_line), report);
    const std::vector<bool> shown = shown_objects(show.plot->plot, show.hidden_layers, show.hidden_classes);
    TRY_VOID(add_plot_fixtures(show, shown, parsed.substitutes, parsed.walls, report,
                               part_of(loading, kPlotShare, kFixturesShare)));
    apply_circuits(show, parsed.changes);
    return {};
}

Result<ParsedShow> parse_file(const fs::path& path, Report& report) {
    std::error_code code;
    if (lower(path.extension().string()) == ".mvr" && !fs::is_directory(path, code)) {
        if (!is_file(path)) return Error{missing_file(path), path.string()};
        ParsedShow parsed;
        parsed.show.file = parsed.show.plot_file = path;
        parsed.show.folder = path.parent_path();
        parsed.show.name = path.stem().string();
        parsed.show.cache_name = path.filename().string();
        parsed.show.ambient_lux = kDefaultAmbient_lux;
        return parsed;
    }
    const fs::path file = fs::is_directory(path, code) ? path / "show.toml" : path;
    const Result<std::string> text = read_text_file(file, kMaxShowBytes);
    // A song, a picture, a drawing: where nothing looks like a show, no line of it is to be mended.
    const bool looks_like_one = file != path || lower(path.extension().string()) == ".toml" ||
                                !is_file(path) || (text.ok() && text->find("[show]") != std::string::npos);
    const Error no_show{"is no show: a folder with a show.toml, a show.toml, or a plot (.mvr) can be opened",
                        path.string()};
    if (!text.ok() && looks_like_one) return text.error();
    if (!looks_like_one) return no_show;
    // A disk that was full, or a machine that went off, left it so; what is open is worth more.
    if (text->find_first_not_of(" \t\r\n") == std::string::npos)
        return Error{"is empty: there is no show in it", file.string()};
    return parse_show(*text, file, report);
}

} // namespace

Result<Stage> read_stage(const Show& show, Report& report, const ShowLoading& loading) {
    Stage stage;
    if (!show.stage_file.empty() && is_file(show.stage_file)) {
        auto loaded = load_stage_file(show.stage_file, show.folder, report);
        if (loaded.ok())
            stage = std::move(*loaded);
        else
            report.add(Severity::error, loaded.error().where,
                       loaded.error().what + "; the stage is without it");
    }
    if (show.plot) {
        const std::vector<bool> shown =
            shown_objects(show.plot->plot, show.hidden_layers, show.hidden_classes);
        TRY_VOID(add_plot_stage(*show.plot, shown, show.plot_origin_m, stage, report, loading));
    }
    add_models(show, stage, report);
    check_moved_objects(show, stage, report);
    return stage;
}

namespace {

Result<Show> load_parsed(ParsedShow parsed, bool load_stage, Report& report, const ShowLoading& loading) {
    Show& show = parsed.show;
    show.user_cache = user_cache_for(show.folder);
    load_types(parsed, {}, report);
    if (is_file(show.plot_file)) {
        TRY_VOID(open_plot(parsed, report, loading));
        // A plot that is opened as it is and cannot be read leaves nothing to draw.
        if (!show.plot && show.file == show.plot_file) {
            const Message last = report.messages.back();
            report.messages.pop_back();
            return Error{last.what, last.where};
        }
    }
    load_shapes(parsed, report);
    check_addresses(parsed, report);
    check_files(parsed, report);
    check_tracking(show, report);
    check_movers(show, report);
    check_cues(show, report);
    check_circuits(show, report);
    check_palettes(show, report);
    const bool needs_cameras = show.cameras.empty();
    if (load_stage || needs_cameras) {
        TRY(show.stage, read_stage(show, report, part_of(loading, kFixturesShare, 1.0)));
    }
    if (needs_cameras) {
        show.cameras = default_cameras(show);
        if (show.file == show.plot_file) show.haze.extinction_per_m = default_extinction_per_m(show.cameras);
    }
    return std::move(parsed.show);
}

} // namespace

Result<Show> load_show(const fs::path& path, bool load_stage, Report& report, const ShowLoading& loading) {
    TRY(ParsedShow parsed, parse_file(path, report));
    return load_parsed(std::move(parsed), load_stage, report, loading);
}

Result<Show> load_show_text(const fs::path& file, const std::string& text, bool load_stage, Report& report,
                            const ShowLoading& loading) {
    TRY(ParsedShow parsed, parse_show(text, file, report));
    return load_parsed(std::move(parsed), load_stage, report, loading);
}

} // namespace ghost::scene
