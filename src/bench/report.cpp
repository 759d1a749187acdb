// SPDX-License-Identifier: Apache-2.0
#include "bench/report.h"

#include "base/child.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "bench/private/report_page.h"
#include "bench/tables.h"
#include "disk/files.h"
#include "gpu/device_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

struct Part {
    const char* table;
    const char* title;
    Result<void> (*run)(const BenchOptions&, const BenchSink&);
    double share; // of the time, roughly
};

// A show at 320x180 with every use of Vulkan looked at.
Result<void> validation(const BenchOptions& options, const BenchSink& sink) {
    for (const bool live : {true, false}) {
        SessionOptions opening;
        opening.show = options.show;
        opening.device = options.device;
        opening.live = live;
        opening.quiet = true;
        opening.validation = true;
        opening.width = 320;
        opening.height = 180;
        TRY(const std::unique_ptr<Session> session, open_session(opening));
        for (int frame = 0; frame < 4; ++frame) {
            session->rig->step({}, 0.1);
            (void)session->draw(0.1 * frame);
        }
        sink({"validation",
              live ? "a free camera" : "baked passes",
              {{"messages", static_cast<double>(session->device->validation_errors())}},
              "Khronos validation layer"});
    }
    return {};
}

// The programs beside ours that test what draws; on a machine that only has this folder.
Result<void> device_tests(const BenchOptions& options, const BenchSink& sink) {
    const fs::path folder = fs::path(options.program).parent_path() / "tests";
    std::error_code code;
    std::vector<fs::path> programs;
    for (const auto& entry : fs::directory_iterator(folder, code))
        if (entry.path().filename().string().starts_with("test_")) programs.push_back(entry.path());
    if (programs.empty()) return Error{"there are none beside this program", folder.string()};
    std::sort(programs.begin(), programs.end());
    // They look at every use of Vulkan.
    TRY_VOID(gpu::Device::create({.name = options.device, .validation = true}));
    for (const fs::path& program : programs) {
        const double begin_s = steady_now_s();
        const std::string libraries = "LD_LIBRARY_PATH=" + (folder.parent_path() / "lib").string();
        TRY(const ChildResult result, run_child({"env", libraries, program.string()}, "", false));
        std::string last = result.output.substr(0, result.output.find_last_not_of('\n') + 1);
        last = last.substr(last.find_last_of('\n') + 1);
        sink({"tests",
              program.filename().string(),
              {{"exit_code", static_cast<double>(result.exit_code)}, {"s", steady_now_s() - begin_s}},
              last});
    }
    return {};
}

constexpr Part kParts[] = {
    {"pictures", "Stills of the demo, and how near they are to those that lavapipe drew", bench_pictures, 6},
    {"paper", "The paper's scene: five spots with two gobos, five washes, 1024x300", bench_paper, 4},
    {"live", "A film of the free camera, by span", bench_live, 30},
    {"scale", "1 to 1000 moving lights, four picture sizes", bench_scale, 25},
    {"thesis", "The thesis's picture: 256x256, one spot", bench_thesis, 5},
    {"integrators", "gate, cone and march in thirteen views", bench_integrators, 15},
    {"shaders", "What the driver makes of the shaders", bench_shaders, 5},
    {"validation", "What the Khronos validation layer says", validation, 2},
    {"tests", "Tests of what draws", device_tests, 8}};
constexpr std::array<std::string_view, 5> kQuick{"pictures", "paper", "scale", "shaders", "validation"};

std::string time_text() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    ::gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &utc);
    return text;
}

nlohmann::ordered_json json_of(const ReportPage& page) {
    nlohmann::ordered_json json{{"program", page.program}, {"time", page.time}};
    for (const auto& [name, value] : page.facts) json["device"][name] = value;
    for (const ReportTable& table : page.tables) {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const BenchRow& row : table.rows) {
            nlohmann::ordered_json line{{"name", row.name}};
            for (const auto& [name, value] : row.figures) line[name] = value;
            line["note"] = row.note;
            rows.push_back(line);
        }
        json["tables"][table.name] = {{"title", table.title}, {"rows", rows}, {"error", table.error}};
    }
    return json;
}

} // namespace

Result<void> write_report(const ReportOptions& options) {
    catch_interrupts();
    std::error_code code;
    fs::create_directories(options.out, code);
    if (code) return Error{"cannot be made: " + code.message(), options.out.string()};
    ReportPage page;
    page.program = "ghostlight-bench 0.1.0";
    page.time = time_text();
    {
        TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({.name = options.bench.device}));
        page.facts = gpu::facts_of(*device);
    }
    BenchOptions bench = options.bench;
    bench.pictures = options.out.string();
    if (options.quick) {
        bench.frames = std::min(bench.frames, 10);
        bench.row_seconds = std::min(bench.row_seconds, 5.0);
    }
    double all = 0, done = 0;
    const auto skips = [&](const Part& part) {
        if (!options.tables.empty())
            return std::find(options.tables.begin(), options.tables.end(), part.table) ==
                   options.tables.end();
        return options.quick && std::find(kQuick.begin(), kQuick.end(), part.table) == kQuick.end();
    };
    for (const Part& part : kParts) all += skips(part) ? 0 : part.share;
    Progress progress("measuring", Progress::style_for_stderr(), steady_now_s());
    for (const Part& part : kParts) {
        if (skips(part) || interrupted()) continue;
        ReportTable table{part.table, part.title, {}, ""};
        progress.update(done / all, steady_now_s(), part.table);
        const Result<void> run = run_table(part.run, bench, [&](const BenchRow& row) {
            table.rows.push_back(row);
            progress.update(done / all, steady_now_s(), std::string(part.table) + ": " + row.name);
        });
        if (!run.ok()) table.error = run.error().text();
        page.tables.push_back(std::move(table));
        done += part.share;
    }
    progress.finish();
    if (interrupted()) log_warning("interrupted: the report has what was measured until then");
    TRY_VOID(write_file_atomic(options.out / "report.json", json_of(page).dump(1) + "\n"));
    return write_file_atomic(options.out / "report.html", html_of(page));
}

} // namespace ghost::app
