// SPDX-License-Identifier: Apache-2.0
#include "bench/tables.h"

#include "base/print.h"
#include "gpu/workers.h"

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace ghost::app {
namespace {

constexpr BenchTable kTables[] = {
    {"samples", "Cost of a sample (Screen Space Re-Rendering, table 1)", bench_samples},
    {"optics", "Each optic of a profile, ten moving beams", bench_optics},
    {"paper", "The paper's scene: five spots with two gobos, five washes", bench_paper},
    {"live", "A film of the free camera, by span", bench_live},
    {"moments", "Moving against resting", bench_moments},
    {"kinetic", "Rigs that travel", bench_kinetic},
    {"projectors", "The paper's figure 8: ten video projectors, two movies and a camera", bench_projectors},
    {"thesis", "The thesis's picture: 256x256, one spot", bench_thesis},
    {"integrators", "gate, cone and march in thirteen views", bench_integrators},
    {"scale", "1 to 1000 moving lights, four picture sizes", bench_scale},
    {"pictures", "Stills of the demo, against another device's", bench_pictures},
    {"shaders", "What the driver makes of the shaders", bench_shaders},
    {"tree", "One light of n changes", bench_tree},
    {"triangles", "Triangles do not matter", bench_triangles},
    {"bake", "Baking", bench_bake},
    {"quality", "Relit on the device against traced directly", bench_quality},
    {"network", "sACN on the loopback interface, each refresh in one burst", bench_network},
    {"recording", "Recordings: bytes for an hour of a universe, time to seek", bench_recording},
    {"bounce", "Light that bounces", bench_bounce},
};

} // namespace

std::span<const BenchTable> tables() {
    return kTables;
}

Result<void> run_table(Result<void> (*run)(const BenchOptions&, const BenchSink&),
                       const BenchOptions& options, const BenchSink& sink) {
    if (!options.pictures.empty()) {
        std::error_code code;
        std::filesystem::create_directories(options.pictures, code);
        if (code) return Error{"cannot be made: " + code.message(), options.pictures};
    }
    gpu::prepare_workers(); // of the first table: there are no other threads yet
    try {
        return run(options, sink);
    } catch (const std::exception& failure) {
        return Error{failure.what(), ""};
    }
}

void print_row(const BenchRow& row, bool json) {
    if (json) {
        nlohmann::ordered_json line{{"table", row.table}, {"name", row.name}};
        for (const auto& [name, value] : row.figures) line[name] = value;
        line["note"] = row.note;
        print_text("%s\n", line.dump().c_str());
    } else {
        print_text("%-28s", row.name.c_str());
        for (const auto& [name, value] : row.figures)
            std::isnan(value) ? print_text("  %s -", name.c_str())
                              : print_text("  %s %.4g", name.c_str(), value);
        print_text("  (%s)\n", row.note.c_str());
    }
    std::fflush(stdout);
}

} // namespace ghost::app
