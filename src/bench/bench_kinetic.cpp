// SPDX-License-Identifier: Apache-2.0
// Rigs that travel: what a truss of lamps costs while it flies, against the same truss at rest; and how far
// the paper's blend of passes from two places is from a pass of the place between them.
#include "base/interrupt.h"
#include "bench/bench.h"
#include "bench/private/temporary_folder.h"

#include "bake/bake_show.h"
#include "base/steady_time.h"
#include "disk/files.h"
#include "show_folder/load_show.h"

#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <sstream>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr int kLamps = 24;
constexpr int kKineticWarmUp = 4; // frames
constexpr double kKineticFps = 25;
constexpr float kSway_deg = 3; // of the heads, so that their light is drawn anew in each frame
constexpr float kFlight_m = 2; // up and down, of either hoist
constexpr int kTrackAddress = 301;
constexpr int kBakedSamples = 16; // a pixel
constexpr std::array<double, 4> kSpacings_m{0.5, 1, 2, 4};

std::string lamp_text(const fs::path& assets, int number, double x_m, int address) {
    std::ostringstream text;
    const bool is_spot = number % 2 == 0;
    text << "\n[[fixture]]\nname = \"Lamp " << number + 1 << "\"\ngdtf = \""
         << (assets / "fixtures" / (is_spot ? "Vari-Lite@VL2500_Spot.gdtf" : "Vari-Lite@VL2500_Wash.gdtf"))
                .string()
         << "\"\nuniverse = " << 2 + number / 20 << "\naddress = " << address << "\nposition_m = [" << x_m
         << ", 2.0, 5.97]\n";
    return text.str();
}

std::string show_of(const fs::path& stage, const char* air, const char* size) {
    return "[show]\nname = \"Kinetic bench\"\nstage = \"" + stage.string() +
           "\"\nmotion = \"commanded\"\nambient_lux = 2.0\n\n[haze]\n" + air +
           "\n\n[[camera]]\nname = \"house\"\nposition_m = [0.0, -15.0, 4.2]\ntarget_m = [0.0, 2.0, "
           "3.0]\nfov_y_deg = 34.0\nsize = " +
           size + "\nev100 = 4.5\n";
}

std::string truss_text(const fs::path& assets) {
    std::string text = show_of(assets / "kinetic" / "stage.glb", "extinction_per_m = 0.03", "[640, 360]");
    text +=
        "\n[[mover]]\nname = \"Truss\"\nkind = \"hoists\"\nobjects = [\"Truss\"]\nfixtures = [\"Lamp *\"]\n";
    for (const char* const point_m : {"[-5.0, 2.0, 6.0]", "[5.0, 2.0, 6.0]"})
        text += std::string("\n[[mover.axis]]\npoint_m = ") + point_m + "\nrange_m = [0.0, -4.0]\n";
    for (int k = 0; k < kLamps; ++k)
        text += lamp_text(assets, k, -4.9 + 9.8 * k / (kLamps - 1), 1 + 22 * (k % 20));
    return text;
}

// stops: of the track, evenly over length_m.
std::string track_text(const fs::path& assets, double length_m, int stops) {
    std::string text = show_of(assets / "kinetic" / "stage.glb", "preset = \"none\"", "[320, 180]");
    std::string lamp = lamp_text(assets, 0, 0, 1);
    std::ostringstream track;
    track << "track = { stops_m = [";
    for (int k = 0; k < stops; ++k)
        track << (k > 0 ? ", " : "") << "[" << length_m * (static_cast<double>(k) / (stops - 1) - 0.5)
              << ", 2.0, 5.97]";
    track << "], universe = 1, address = " << kTrackAddress << " }\n";
    return text + lamp + track.str();
}

SessionOptions opening_of(const BenchOptions& options, const fs::path& folder) {
    SessionOptions opening;
    opening.show = folder.string();
    opening.device = options.device;
    opening.quiet = true;
    return opening;
}

// All lamps on, tilted to what the camera sees of the stage.
std::map<std::size_t, fixture::Programmer> lit_by_hand(std::size_t count, double seconds) {
    std::map<std::size_t, fixture::Programmer> programmer;
    for (std::size_t k = 0; k < count; ++k) {
        const auto phase = static_cast<float>(seconds * 1.7 + static_cast<double>(k));
        programmer[k].intensity = 1.0f;
        programmer[k].pan_deg = kSway_deg * std::sin(phase);
        programmer[k].tilt_deg = -20 + kSway_deg * std::cos(phase);
    }
    return programmer;
}

// One of those that are drawn in turns.
struct Truss {
    std::unique_ptr<Session> session;
    bool flies = false;
    std::string name;
    MovingMapsBy maps = MovingMapsBy::processor;
    std::vector<double> total_ms, processor_ms;
    std::map<std::string, std::vector<double>> spans = {};

    void draw(int frame) {
        const double seconds = frame / kKineticFps;
        if (flies) {
            const auto phase = static_cast<float>(seconds);
            session->rig->movers().drive(0, {-kFlight_m + kFlight_m * std::cos(phase),
                                             -kFlight_m + kFlight_m * std::cos(1.3f * phase)});
        }
        session->rig->step({}, 1.0 / kKineticFps, lit_by_hand(kLamps, seconds));
        const double begin_s = steady_now_s();
        const std::clock_t begin = std::clock();
        const render::FrameStatistics drawn = session->draw(seconds);
        if (frame < kKineticWarmUp) return;
        processor_ms.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        total_ms.push_back(1e3 * (steady_now_s() - begin_s));
        std::map<std::string, double> of_frame;
        for (const gpu::Span& span : drawn.spans) of_frame[span.name] += span.ms;
        for (const auto& [span, ms] : of_frame) spans[span].push_back(ms);
        const LiveView::MapWork& work = session->live->map_work();
        if (session->live->draws_maps()) {
            spans["maps made"].push_back(work.draw_ms);
        } else {
            spans["maps traced"].push_back(work.trace_ms);
            spans["maps uploaded"].push_back(work.upload_ms);
        }
    }
};

Result<void> truss_rows(const BenchOptions& options, const fs::path& assets, const BenchSink& sink) {
    const TemporaryFolder folder;
    TRY_VOID(folder.made());
    TRY_VOID(write_file_atomic(folder.path / "show.toml", truss_text(assets)));
    SessionOptions opening = opening_of(options, folder.path);
    opening.live = true;
    opening.workers = true;
    opening.beams.grid = true;
    // The truss, with maps by the processor and by the device; at rest each has the way that it would choose.
    std::array<Truss, 3> trusses;
    trusses[0] = {.name = "rests", .maps = MovingMapsBy::choice};
    trusses[1] = {.flies = true, .name = "flies, maps by the processor"};
    trusses[2] = {.flies = true, .name = "flies, maps by the device", .maps = MovingMapsBy::device};
    for (Truss& one : trusses) {
        opening.moving_maps = one.maps;
        TRY(one.session, open_session(opening));
    }
    for (int frame = 0; frame < options.frames + kKineticWarmUp; ++frame) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        for (Truss& one : trusses) one.draw(frame);
    }
    const double at_rest_ms = median(trusses[0].total_ms);
    for (Truss& truss : trusses) {
        Truss* const one = &truss;
        BenchRow row{"kinetic",
                     "truss of 24 lamps, " + one->name,
                     {{"ms", median(one->total_ms)}, {"processor_ms", median(one->processor_ms)}},
                     "640x360, heads turn in all; frames in turns, medians of " +
                         std::to_string(options.frames)};
        if (one->maps == MovingMapsBy::device && !one->session->live->draws_maps())
            row.note += "; this device cannot, so the processor did";
        if (one->flies) row.figures.emplace_back("of_rest", median(one->total_ms) / at_rest_ms);
        for (const auto& [name, ms] : one->spans) row.figures.emplace_back(name + "_ms", median(ms));
        sink(row);
    }
    return {};
}

// A lamp on a track with passes at some places, drawn as if it were at a share of its way.
Result<std::vector<image::ImageF>> along_track(const BenchOptions& options, const std::string& text,
                                               std::span<const double> shares) {
    const TemporaryFolder folder;
    TRY_VOID(folder.made());
    TRY_VOID(write_file_atomic(folder.path / "show.toml", text));
    Report report;
    TRY(const scene::Show show, scene::load_show(folder.path, true, report));
    bake::BakeOptions baking;
    baking.spp = kBakedSamples;
    baking.now_s = steady_now_s;
    TRY_VOID(bake::bake_show(show, baking, report));
    TRY(const std::unique_ptr<Session> session, open_session(opening_of(options, folder.path)));
    std::vector<image::ImageF> pictures;
    for (const double share : shares) {
        auto levels = std::make_shared<dmx::Levels>();
        const auto value = static_cast<int>(std::lround(65535 * share));
        (*levels)[kTrackAddress - 1] = static_cast<std::uint8_t>(value >> 8);
        (*levels)[kTrackAddress] = static_cast<std::uint8_t>(value & 255);
        dmx::Universes universes;
        universes.at(1).levels = levels;
        session->rig->step(universes, 1.0 / kKineticFps, lit_by_hand(1, 0));
        (void)session->draw(0);
        pictures.push_back(session->relighter->frame());
    }
    return pictures;
}

Result<void> track_row(const BenchOptions& options, const fs::path& assets, double spacing_m,
                       const BenchSink& sink) {
    constexpr std::array<double, 3> kShares{0, 0.25, 0.5};
    TRY(const std::vector<image::ImageF> blended,
        along_track(options, track_text(assets, spacing_m, 2), kShares));
    TRY(const std::vector<image::ImageF> there,
        along_track(options, track_text(assets, spacing_m, 5), kShares));
    char name[64];
    std::snprintf(name, sizeof name, "passes %g m apart", spacing_m);
    sink({"kinetic",
          name,
          {{"at_a_place_db", display_db(blended[0], there[0])},
           {"at_a_quarter_db", display_db(blended[1], there[1])},
           {"in_the_middle_db", display_db(blended[2], there[2])}},
          "a lamp on a track, 4 m above what it lights, no haze; against a pass of where it is"});
    return {};
}

} // namespace

Result<void> bench_kinetic(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    const fs::path assets = fs::absolute(fs::path(options.show)).parent_path();
    TRY_VOID(truss_rows(options, assets, sink));
    for (const double spacing_m : kSpacings_m) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        TRY_VOID(track_row(options, assets, spacing_m, sink));
    }
    return {};
}

} // namespace ghost::app
