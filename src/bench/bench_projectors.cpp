// SPDX-License-Identifier: Apache-2.0
// Figure 8 of Screen Space Re-Rendering: ten VL2500S as video projectors. The show, its films and its
// baked passes are made in <show>/.ghost/projectors and stay there: `ghostlight render` draws it as any
// other.
#include "base/interrupt.h"
#include "bench/bench.h"
#include "show_folder/load_show.h"

#include "disk/files.h"
#include "video/files/film.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <sstream>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kProjectors = 10;
constexpr int kFilmWidth = 640;
constexpr int kFilmHeight = 360;
constexpr int kProjectorFps = 25;
constexpr int kProjectorWarmUp = 5;
constexpr int kChannels = 22;

struct ProjectorPlace {
    float x_m, y_m, z_m;
    double pan_deg, tilt_deg;
};

// Five on the front truss, at the backdrop; five above the band, at floor and backdrop.
constexpr std::array<ProjectorPlace, kProjectors> kPlaces{{{-5.2f, 0.255f, 6.56f, 4, 66},
                                                           {-2.6f, 0.255f, 6.56f, 2, 70},
                                                           {0.0f, 0.255f, 6.56f, 0, 64},
                                                           {2.6f, 0.255f, 6.56f, -2, 70},
                                                           {5.2f, 0.255f, 6.56f, -4, 66},
                                                           {-4.4f, 4.155f, 6.76f, 25, -30},
                                                           {-2.2f, 4.155f, 6.76f, 12, -38},
                                                           {0.0f, 4.155f, 6.76f, 0, -30},
                                                           {2.2f, 4.155f, 6.76f, -12, -38},
                                                           {4.4f, 4.155f, 6.76f, -25, -30}}};

using Colour = std::function<std::array<double, 3>(double x, double y, double s)>;

Result<void> make_film(const fs::path& path, double seconds, const Colour& colour) {
    std::error_code code;
    if (fs::exists(path, code)) return {};
    TRY(const std::unique_ptr<video::FilmWriter> film,
        video::FilmWriter::create(path, kFilmWidth, kFilmHeight, kProjectorFps));
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(kFilmWidth) * kFilmHeight * 4, 255);
    for (int frame = 0; frame < static_cast<int>(seconds * kProjectorFps); ++frame) {
        std::size_t to = 0;
        for (int y = 0; y < kFilmHeight; ++y)
            for (int x = 0; x < kFilmWidth; ++x, to += 4) {
                const std::array<double, 3> rgb =
                    colour(static_cast<double>(x) / kFilmHeight, static_cast<double>(y) / kFilmHeight,
                           static_cast<double>(frame) / kProjectorFps);
                for (std::size_t k = 0; k < 3; ++k)
                    rgba[to + k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(rgb[k], 0.0, 1.0)));
            }
        TRY_VOID(film->add(rgba.data()));
    }
    return film->finish();
}

std::array<double, 3> waves(double x, double y, double s) {
    const double a = std::sin(7 * x + 2 * s) + std::sin(9 * y - 1.5 * s) + std::sin(5 * (x + y) + s);
    return {0.5 + 0.5 * std::sin(2 * a), 0.5 + 0.5 * std::sin(2 * a + 2), 0.5 + 0.5 * std::sin(2 * a + 4)};
}

std::array<double, 3> rings(double x, double y, double s) {
    const double u = x - 0.89, v = y - 0.5, turn = std::atan2(v, u) + s, r = std::hypot(u, v);
    const bool on = std::sin(6 * turn + 12 * r) > 0;
    const bool ring = std::sin(30 * r - 6 * s) > 0.6;
    return {on ? 1.0 : 0.05, ring ? 1.0 : 0.25, on ? 0.1 : 0.6};
}

// A face that looks about, for want of a camera.
std::array<double, 3> face(double x, double y, double s) {
    const double u = x - 0.89 - 0.1 * std::sin(s), v = y - 0.5;
    if (std::hypot(u, v) > 0.42) return {0.1, 0.12, 0.2};
    const bool eye = std::hypot(std::abs(u) - 0.15, v + 0.12) < 0.06;
    const bool mouth = std::abs(std::hypot(u, v - 0.05) - 0.22) < 0.025 && v > 0.1;
    if (eye || mouth) return {0.05, 0.05, 0.05};
    return {0.95, 0.8, 0.55};
}

std::string show_text(const fs::path& demo) {
    std::ostringstream text;
    text << "[show]\nname = \"Ten projectors\"\nstage = \"" << (demo / "stage.glb").string()
         << "\"\nrecording = \"look.show\"\nmotion = \"commanded\"\nambient_lux = 1.0\n\n"
            "[haze]\nextinction_per_m = 0.016\n\n"
            "[[camera]]\nname = \"house\"\nposition_m = [0.0, -15.5, 4.2]\ntarget_m = [0.0, 3.0, 3.76]\n"
            "fov_y_deg = 23.4\nsize = [1024, 300]\nev100 = 6.0\n\n"
            "[[media]]\nname = \"waves\"\nfile = \"waves.mp4\"\n\n[[media]]\nname = \"rings\"\nfile = "
            "\"rings.mp4\"\n\n"
            "[[media]]\nname = \"camera\"\ncamera = \"camera.mp4\"\n";
    constexpr std::array<const char*, 3> kMedia{"waves", "rings", "camera"};
    for (int k = 0; k < kProjectors; ++k) {
        const ProjectorPlace& place = kPlaces[static_cast<std::size_t>(k)];
        text << "\n[[fixture]]\nname = \"Projector " << k + 1 << "\"\ngdtf = \""
             << (demo / "../fixtures/Vari-Lite@VL2500_Spot.gdtf").string()
             << "\"\nmode = \"Standard 22 channels\"\naddress = " << 1 + kChannels * k << "\nposition_m = ["
             << place.x_m << ", " << place.y_m << ", " << place.z_m << "]\nhome_deg = [" << place.pan_deg
             << ", " << place.tilt_deg << "]\nprojector = { media = \""
             << kMedia[static_cast<std::size_t>(k) % 3]
             << "\", lumens = 12000, focus_m = " << (k < 5 ? 9.5 : 7.0) << " }\n";
    }
    return text.str();
}

void put_16_bit(dmx::Levels& levels, int address, double share) {
    const int value = static_cast<int>(std::lround(65535 * std::clamp(share, 0.0, 1.0)));
    levels[static_cast<std::size_t>(address - 1)] = static_cast<std::uint8_t>(value >> 8);
    levels[static_cast<std::size_t>(address)] = static_cast<std::uint8_t>(value & 255);
}

// All ten on; sway: degrees that the heads swing.
dmx::Levels levels_at(const fixture::Type& type, double seconds, double sway_deg) {
    dmx::Levels levels{};
    const fixture::Mode& mode = type.modes.front();
    double pan_deg = 540, tilt_deg = 270; // whole ranges
    for (const fixture::Channel& channel : mode.channels)
        for (const fixture::ChannelFunction& function : channel.functions) {
            const double range = std::abs(static_cast<double>(function.physical_to - function.physical_from));
            if (function.attribute == "Pan") pan_deg = range;
            if (function.attribute == "Tilt") tilt_deg = range;
        }
    for (int k = 0; k < kProjectors; ++k) {
        const ProjectorPlace& place = kPlaces[static_cast<std::size_t>(k)];
        const int address = 1 + kChannels * k;
        const auto at = [&](int channel) -> std::uint8_t& {
            return levels[static_cast<std::size_t>(address + channel - 2)];
        };
        at(1) = 255;
        put_16_bit(levels, address + 1,
                   0.5 + (place.pan_deg + sway_deg * std::sin(0.9 * seconds + k)) / pan_deg);
        put_16_bit(levels, address + 3,
                   0.5 + (place.tilt_deg + sway_deg * std::cos(0.7 * seconds + k)) / tilt_deg);
        at(12) = 128;
        at(17) = 255;
    }
    return levels;
}

dmx::Universes universes_of(dmx::Levels levels) {
    dmx::Universes universes;
    universes.at(1).levels = std::make_shared<dmx::Levels>(levels);
    return universes;
}

std::string recording_of(const fixture::Type& type) {
    std::ostringstream text;
    text << "OLA Show\n";
    for (int frame = 0; frame < 10 * kProjectorFps; ++frame) {
        const dmx::Levels levels = levels_at(type, static_cast<double>(frame) / kProjectorFps, 3);
        text << "1 ";
        for (std::size_t k = 0; k < levels.size(); ++k) text << (k ? "," : "") << int{levels[k]};
        text << "\n" << 1000 / kProjectorFps << "\n";
    }
    return text.str();
}

Result<fs::path> make_show(const fs::path& demo) {
    const fs::path folder = fs::absolute(demo) / ".ghost" / "projectors";
    TRY_VOID(make_folders(folder, fs::absolute(demo)));
    TRY_VOID(make_film(folder / "waves.mp4", 6, waves));
    TRY_VOID(make_film(folder / "rings.mp4", 4, rings));
    TRY_VOID(make_film(folder / "camera.mp4", 60, face));
    TRY_VOID(write_file_atomic(folder / "show.toml", show_text(fs::absolute(demo))));
    Report unheard;
    TRY(const scene::Show show, scene::load_show(folder, false, unheard));
    if (show.fixtures.empty() || !show.fixtures.front().type)
        return Error{"the projectors' fixture file cannot be read", demo.string()};
    TRY_VOID(write_file_atomic(folder / "look.show", recording_of(*show.fixtures.front().type)));
    return folder;
}

} // namespace

Result<void> bench_projectors(const BenchOptions& options, const BenchSink& sink) {
    TRY(const fs::path folder, make_show(options.show));
    SessionOptions opening;
    opening.show = folder.string();
    opening.device = options.device;
    opening.quiet = true;
    opening.workers = true;
    TRY(const std::unique_ptr<Session> session, open_session(opening));
    const fixture::Type& type = *session->show->fixtures.front().type;
    struct Row {
        const char* name;
        double sway_deg;
        bool films;
    };
    for (const Row& row :
         {Row{"films and camera, heads move", 3, true}, Row{"films and camera, heads rest", 0, true},
          Row{"pictures rest, heads move", 3, false}}) {
        if (interrupted()) return {};
        std::vector<double> total, tables, rays, surfaces, uploads, late;
        const Clock::time_point begin = Clock::now();
        std::clock_t processor = 0; // decoding included
        for (int frame = 0; frame < options.frames + kProjectorWarmUp; ++frame) {
            if (frame == kProjectorWarmUp) processor = std::clock();
            const Clock::time_point start = Clock::now();
            const double seconds = std::chrono::duration<double>(start - begin).count();
            session->rig->step(universes_of(levels_at(type, seconds, row.sway_deg)), 1.0 / kProjectorFps);
            // From the beginning on, whatever the row; a medium that rests is asked for the same moment.
            session->media_s = row.films ? seconds : 1.0;
            const render::FrameStatistics drawn = session->draw(seconds);
            if (frame < kProjectorWarmUp) continue;
            total.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
            tables.push_back(span_ms(drawn, "fan"));
            rays.push_back(span_ms(drawn, "gate"));
            surfaces.push_back(span_ms(drawn, "surfaces"));
            uploads.push_back(span_ms(drawn, "slides"));
            // A picture of a film is due from its time stamp on, until the next one's.
            if (row.films) late.push_back(1e3 * session->media->behind_s(seconds));
        }
        const double processor_ms =
            1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC / options.frames;
        sink({"projectors",
              row.name,
              {{"lights", static_cast<double>(session->rig->lights(session->gobos, session->passes).size())},
               {"ms", median(total)},
               {"best_ms", *std::min_element(total.begin(), total.end())},
               {"worst_ms", *std::max_element(total.begin(), total.end())},
               {"processor_ms", processor_ms},
               {"tables_ms", median(tables)},
               {"rays_ms", median(rays)},
               {"surfaces_ms", median(surfaces)},
               {"uploads_ms", median(uploads)},
               {"picture_age_ms", late.empty() ? std::nan("") : median(late)},
               {"oldest_ms", late.empty() ? std::nan("") : *std::max_element(late.begin(), late.end())}},
              "1024x300, films of " + std::to_string(kFilmWidth) + "x" + std::to_string(kFilmHeight) +
                  " at " + std::to_string(kProjectorFps) + " a second"});
    }
    return {};
}

} // namespace ghost::app
