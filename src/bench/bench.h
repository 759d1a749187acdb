#pragma once
// SPDX-License-Identifier: Apache-2.0
// The published tables, measured. Each function fills one table; rows are printed as they come. Main thread;
// a table may take a minute on a machine without a GPU.

#include "live/session/session.h"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ghost::app {

// Named figures of one line, in order. Numbers are printed with 4 significant digits; not a number stands for
// what does not apply or was never reached ("-", in JSON null).
struct BenchRow {
    std::string table;
    std::string name;
    std::vector<std::pair<std::string, double>> figures; // name with unit, value
    std::string note;
};

struct BenchOptions {
    std::string show = "assets/demo";
    std::string device;
    int frames = 40;         // measured, after a few that are not
    double row_seconds = 20; // of the table scale: rows that would take longer are skipped, by name
    std::string program;     // our own file, for the start-up table
    // Of the tables network and window: an even load for so long, instead of the table.
    double soak_seconds = 0;
    double desk_seconds = 0; // of the table network: two desks for so long, instead of the ladder
    // Of the tables pictures and moments: a folder that they are written into; empty: nowhere.
    std::string pictures;
    std::string
        against;      // of the table pictures: a folder of what they are compared with; empty: with nothing
    std::string only; // of the table scale: rows with this in their names
    std::string shaders; // likewise: gpu::DeviceOptions
    // Of the table shaders: a device that they are compiled for, where that is not the one that draws.
    std::string compile_for;
    std::uint32_t lights_per_dispatch = 0; // likewise, render::Settings
    std::string plot;                      // of the table window: a plot that is opened, too; empty: none
    bool power = false; // of the table bounce: light by order, against particles, instead of the table
};

using BenchSink = std::function<void(const BenchRow&)>;

// Table 1 of Screen Space Re-Rendering: cost of a sample of a simple and of a gobo light.
Result<void> bench_samples(const BenchOptions& options, const BenchSink& sink);
// Ten moving beams of a profile, with one optic after the other in the gate.
Result<void> bench_optics(const BenchOptions& options, const BenchSink& sink);
// The scene of the paper: 1024x300, five spots with two gobos and five washes, DMX to image.
Result<void> bench_paper(const BenchOptions& options, const BenchSink& sink);
// A film of the free camera by span, and how near a picture that moves is to the same one at rest.
Result<void> bench_live(const BenchOptions& options, const BenchSink& sink);
// Moments of the demo and of a festival as they are drawn while all moves, against the same at rest.
Result<void> bench_moments(const BenchOptions& options, const BenchSink& sink);
// The paper's figure 8: ten projectors with two movies and a camera on the stage of the show.
Result<void> bench_projectors(const BenchOptions& options, const BenchSink& sink);
// The thesis's picture: 256x256, one spot with a gobo, its numbers of steps beside cone and gate.
Result<void> bench_thesis(const BenchOptions& options, const BenchSink& sink);
// Twelve views: the three integrators at their defaults, at gate's error and in gate's time.
Result<void> bench_integrators(const BenchOptions& options, const BenchSink& sink);
// 1 to 1000 moving lights over a festival's stage, four picture sizes.
Result<void> bench_scale(const BenchOptions& options, const BenchSink& sink);
// 1 to 512 lights, one changing.
Result<void> bench_tree(const BenchOptions& options, const BenchSink& sink);
// 10 thousand to a million triangles at one picture size.
Result<void> bench_triangles(const BenchOptions& options, const BenchSink& sink);
// Stills of the demo, against those that another device drew.
Result<void> bench_pictures(const BenchOptions& options, const BenchSink& sink);
// What the driver's compiler makes of the shaders of a live picture.
Result<void> bench_shaders(const BenchOptions& options, const BenchSink& sink);
// Baking the first camera of the show.
Result<void> bench_bake(const BenchOptions& options, const BenchSink& sink);
// Five moments of the show: relit passes of its first camera against the same beams traced directly.
Result<void> bench_quality(const BenchOptions& options, const BenchSink& sink);
// The receiver on the loopback interface under the load of 256 to 1024 universes.
Result<void> bench_network(const BenchOptions& options, const BenchSink& sink);
// An even load for so long instead, one row a minute. Error: a packet was lost, or memory grew.
Result<void> network_soak(double seconds, std::uint16_t port, const BenchSink& sink);
// Recordings: bytes for an hour of a universe, time to open and to seek.
Result<void> bench_recording(const BenchOptions& options, const BenchSink& sink);
// Rigs that travel: a truss that flies against one at rest, passes of two places against one between them.
Result<void> bench_kinetic(const BenchOptions& options, const BenchSink& sink);
// Bounced light: what it takes, and how near it is to particles.
Result<void> bench_bounce(const BenchOptions& options, const BenchSink& sink);
// From nothing to the first picture, and the memory it takes.
Result<void> bench_start(const BenchOptions& options, const BenchSink& sink);

// Shared by the tables.
// In the folder for temporary files, of a name that no other process has.
std::filesystem::path bench_file(const std::string& ending);
inline constexpr int kPaperPictureWidth = 1024, kPaperPictureHeight = 300; // pixels
double median(std::vector<double> values);
// As displays show them whose white is near what three quarters of the reference stay below.
double display_db(const image::ImageF& test, const image::ImageF& reference);
// GPU time of the passes of a name.
double span_ms(const render::FrameStatistics& frame, const std::string& name);
// Of the passes for haze, whichever integrator.
double haze_ms(const render::FrameStatistics& frame);
// A picture of a floor and a wall, without baking: every pass is an even grey.
scene::Passes bench_passes(int width, int height, int light_count);
// A light over that stage; seconds moves it. wheels: 0 a wash, 2 a spot with two gobos.
shared::Light bench_light(int index, std::uint32_t wheels, double seconds);
shared::Gobos bench_gobos();
render::Settings bench_settings();

} // namespace ghost::app
