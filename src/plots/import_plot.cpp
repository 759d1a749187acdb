// SPDX-License-Identifier: Apache-2.0
#include "plots/import_plot.h"

#include "base/print.h"
#include "disk/files.h"
#include "disk/user_file.h"
#include "mvr/mvr_load.h"
#include "plots/plot_changes.h"
#include "plots/private/plot_movers.h"
#include "show_file/show_toml.h"

#include <algorithm>
#include <cstdio>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

constexpr int kMostKept = 99; // older versions of a plot

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        char escape[8];
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            std::snprintf(escape, sizeof escape, "\\u%04x",
                          static_cast<unsigned>(static_cast<unsigned char>(c)));
            result += escape;
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string number(float value, const char* format = "%.2f") {
    char text[48];
    std::snprintf(text, sizeof text, format, static_cast<double>(value));
    return text;
}

std::string point(const glm::vec3& m) {
    return "[" + number(m.x) + ", " + number(m.y) + ", " + number(m.z) + "]";
}

Result<void> copy_whole(const fs::path& from, const fs::path& to) {
    const fs::path temporary = temporary_beside(to);
    std::error_code code;
    fs::copy_file(from, temporary, code);
    if (code) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        return Error{"cannot be copied to " + to.string() + ": " + code.message(), from.string()};
    }
    // A plot on a read-only medium must not make a copy that the next import cannot replace.
    fs::permissions(temporary, fs::perms::owner_read | fs::perms::owner_write, fs::perm_options::add, code);
    return commit_temporary(temporary, to);
}

// The show's plot that gives way stays beside the new one, as "NAME (before 1).mvr".
Result<fs::path> keep_older(const fs::path& plot) {
    const fs::path temporary = temporary_beside(plot);
    std::error_code code;
    fs::create_hard_link(plot, temporary, code);
    if (code) fs::copy_file(plot, temporary, code);
    if (code) return Error{"cannot be kept beside the new one: " + code.message(), plot.string()};
    for (int number = 1; number <= kMostKept; ++number) {
        const fs::path kept = plot.parent_path() / (plot.stem().string() + " (before " +
                                                    std::to_string(number) + ")" + plot.extension().string());
        const auto done = commit_new(temporary, kept);
        if (done.ok() && *done) return kept;
        if (done.ok()) continue;
        fs::remove(temporary, code);
        return done.error();
    }
    fs::remove(temporary, code);
    return Error{std::to_string(kMostKept) + " older versions are kept beside it; move them away",
                 plot.string()};
}

// A show from elsewhere may name any file as its plot, or a link to one.
Result<fs::path> own_plot(const fs::path& plot, const fs::path& show_file) {
    std::error_code code;
    const fs::path folder = fs::canonical(show_file.has_parent_path() ? show_file.parent_path() : ".", code);
    const fs::path target = fs::weakly_canonical(plot, code);
    const fs::path inside = target.lexically_relative(folder);
    if (code || inside.empty() || *inside.begin() == "..")
        return Error{"the plot " + plot.string() + " lies outside of the show's folder and is not replaced",
                     show_file.string()};
    return target;
}

Result<void> merge_into(const fs::path& show_file, const Show& opened, Report& report,
                        ImportedPlot& imported) {
    TRY(const std::string text, read_text_file(show_file, kMaxShowBytes));
    TRY(const ParsedShow parsed, parse_show(text, show_file, report));
    if (parsed.show.plot_file.empty())
        return Error{"is a show without a plot; to add one, write plot = \"name.mvr\" in its [show]",
                     show_file.string()};
    TRY(imported.plot_file, own_plot(parsed.show.plot_file, show_file));
    imported.cameras = std::max(parsed.show.cameras.size(), opened.cameras.size());
    if (!parsed.show.cameras.empty()) imported.cameras = parsed.show.cameras.size();
    std::error_code code;
    if (fs::equivalent(imported.plot_file, opened.plot_file, code))
        return Error{"is the plot of this show itself; import the designer's new file",
                     opened.plot_file.string()};
    Plot old_plot;
    if (fs::exists(imported.plot_file, code)) {
        auto old = load_mvr(imported.plot_file);
        if (old.ok())
            old_plot = std::move(old->plot);
        else
            report.add(Severity::warning, old.error().where,
                       old.error().what + "; the old plot cannot be compared with the new one");
    }
    const auto changes = plot_changes(opened.plot->plot, parsed.changes, opened.plot_origin_m);
    imported.merge = merge_plots(old_plot, opened.plot->plot, changes).report;
    return {};
}

} // namespace

std::string show_text(const Show& show, const std::string& plot_name) {
    std::string text =
        "# Made from the plot " + one_line(plot_name) +
        ". Yours to change: importing a newer version of the plot leaves it as it is.\n"
        "# What every key means: docs/reference/show-file.md and docs/reference/mvr.md.\n\n[show]\nname = " +
        quoted(one_line(show.name)) + "\nplot = " + quoted(plot_name) +
        "\nambient_lux = " + number(show.ambient_lux, "%g") +
        "\n\n[haze]\nextinction_per_m = " + number(show.haze.extinction_per_m, "%.4f") + "\n";
    for (const Camera& camera : show.cameras)
        text += "\n[[camera]]\nname = " + quoted(camera.name) + "\nposition_m = " + point(camera.position_m) +
                "\ntarget_m = " + point(camera.target_m) + "\nfov_y_deg = " + number(camera.fov_y_deg, "%g") +
                "\nsize = [" + std::to_string(camera.width) + ", " + std::to_string(camera.height) +
                "]\nexposure = \"auto\"\n";
    if (show.fixtures.empty()) return text;
    const PatchedFixture& first = show.fixtures.front();
    text +=
        "\n# A fixture of the plot is changed by its UUID (address, mode, position_m, rotation_deg, name, "
        "hidden):\n# [[change]]\n# uuid = " +
        quoted(first.uuid) + " # " + one_line(first.name) + "\n# universe = 1\n# address = 1\n";
    return text;
}

Result<ImportedPlot> import_plot(const Show& opened, const fs::path& folder, Report& report) {
    if (opened.file != opened.plot_file)
        return Error{"is no plot, expected an .mvr file", opened.file.string()};
    const fs::path& plot = opened.plot_file;
    ImportedPlot imported;
    imported.show_file = folder / "show.toml";
    imported.plot_file = folder / one_line(plot.filename().string()); // a show file has no others
    imported.objects = opened.plot->plot.objects.size();
    imported.fixtures = opened.fixtures.size();
    imported.dark =
        static_cast<std::size_t>(std::count_if(opened.fixtures.begin(), opened.fixtures.end(),
                                               [](const PatchedFixture& fixture) { return !fixture.type; }));
    imported.cameras = opened.cameras.size();
    std::error_code code;
    const bool is_new = !fs::exists(imported.show_file, code);
    TRY(const std::string movers, is_new ? imported_movers(opened, plot, report) : std::string());
    if (!is_new) {
        TRY_VOID(merge_into(imported.show_file, opened, report, imported));
    }
    fs::create_directories(folder, code);
    if (!fs::is_directory(folder, code))
        return Error{"cannot be made a folder" + (code ? ": " + code.message() : ""), folder.string()};
    const bool in_place = is_new && fs::equivalent(imported.plot_file, plot, code);
    if (is_new && !in_place && fs::exists(imported.plot_file, code))
        return Error{"is there already and belongs to no show; move it away, or import it itself",
                     imported.plot_file.string()};
    if (!is_new && fs::exists(imported.plot_file, code)) {
        TRY(const fs::path kept, keep_older(imported.plot_file));
        report.add(Severity::note, imported.plot_file.string(),
                   "the plot that was here is kept as '" + kept.filename().string() + "'");
    }
    if (!in_place) {
        TRY_VOID(copy_whole(plot, imported.plot_file));
    }
    if (is_new) {
        TRY_VOID(write_file_atomic(
            imported.show_file,
            std::string_view(show_text(opened, imported.plot_file.filename().string()) + movers)));
    }
    return imported;
}

} // namespace ghost::scene
