// SPDX-License-Identifier: Apache-2.0
// ghostlight paper: what a crew prints of a show: a folder of tables, drawings, and a page with all of them.
#include "book/paper_pages.h"
#include "book/pdf.h"
#include "cli/commands.h"
#include "cli/options/number_option.h"
#include "cli/options/print_options.h"
#include "cli/render/rig_moment.h"
#include "disk/files.h"
#include "disk/whole_folder.h"
#include "drawings/drawings.h"
#include "drawings/focus.h"
#include "light/bodies.h"
#include "live/session/session.h"
#include "rays/tracer.h"
#include "show_folder/hang.h"

#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"

#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

// Of all the time, roughly.
constexpr double kOpenedShare = 0.3, kStageShare = 0.4, kFocusShare = 0.6, kTablesShare = 0.8;

struct PaperArguments {
    std::string show;
    std::string out;
    std::string size = "A4";
    PrintOptions print;
    std::optional<double> circuit_w;
    std::string sheet;
    std::string scale = "fit";
    std::optional<double> section_x_m;
    std::string date;
    RigMomentOptions moment;
    bool plan = false;
    bool focus = false;
    bool pdf = false;
    bool quiet = false;
};

// "1:50", "50" or "fit".
Result<std::optional<int>> scale_from(const std::string& text) {
    if (text == "fit") return std::optional<int>();
    const std::string digits = text.starts_with("1:") ? text.substr(2) : text;
    const bool is_number =
        !digits.empty() && digits.size() <= 5 && digits.find_first_not_of("0123456789") == std::string::npos;
    if (!is_number || std::stoi(digits) < 1)
        return Error{"--scale is '" + text + "', expected 1:50, 1:100 or another whole number, or fit", ""};
    return std::optional<int>(std::stoi(digits));
}

scene::PaperSize sheet_of(const PaperArguments& arguments) {
    const std::string usual = arguments.size == "A4" ? "A3" : "Tabloid";
    return scene::paper_named(arguments.sheet.empty() ? usual : arguments.sheet);
}

Result<scene::Drawings> draw_plan(const PaperArguments& arguments, const scene::Show& show,
                                  const scene::Stage& stage) {
    scene::DrawingOptions options;
    options.style = arguments.print.style();
    options.paper = sheet_of(arguments);
    TRY(options.scale, scale_from(arguments.scale));
    options.section_x_m = arguments.section_x_m;
    options.date = arguments.date;
    return scene::drawings_of(show, stage, options);
}

Result<void> write_plan(const Result<scene::Drawings>& drawn, scene::PaperSize paper,
                        const WholeFolder& folder, Report& report) {
    if (!drawn.ok()) return drawn.error();
    if (!drawn->boxes.empty()) report.add(Severity::warning, "plan.pdf", drawn->boxes);
    TRY_VOID(write_file_atomic(folder.written_to() / "plan.pdf", drawn->pdf));
    log_info("plan at 1:" + std::to_string(drawn->plan_scale) +
             ", section at 1:" + std::to_string(drawn->section_scale) + ": " + std::to_string(drawn->sheets) +
             " sheets of " + std::string(scene::format_of(paper).name));
    return {};
}

// As movers have it at that moment. hung: as the show has it; kept: holds another one where it takes one.
const scene::Stage& stage_at(const scene::Show& show, const scene::MoverMotion& movers,
                             const scene::Stage& hung, std::optional<scene::Stage>& kept) {
    if (!movers.has_moved()) return hung;
    kept = hung;
    for (const scene::CarriedObject& object : scene::carried_objects(show, hung))
        kept->instances[object.instance].world = movers.moved(object.mover) * object.home;
    return *kept;
}

bool is_bar(const scene::Stage& stage, const scene::Instance& instance) {
    const scene::Mesh& mesh = stage.meshes[static_cast<std::size_t>(instance.mesh)];
    const auto bar = scene::bar_of(mesh.positions, instance.world);
    return bar && scene::is_slender(*bar);
}

Result<void> draw_focus(const PaperArguments& arguments, const scene::Show& show, const scene::Stage& hung,
                        const WholeFolder& folder, Report& report) {
    const scene::PrintStyle style = arguments.print.style();
    TRY(const RigMoment moment, moment_of(show, arguments.moment, style, report));
    std::optional<scene::Stage> kept;
    const scene::Stage& stage = stage_at(show, moment.movers, hung, kept);
    std::vector<glm::mat4> moved;
    for (const scene::PatchedFixture& fixture : show.fixtures)
        moved.push_back(moment.movers.moved(fixture.mover));
    const bake::DenormalsOff denormals;
    const bake::Tracer tracer(stage);
    constexpr float kReach_m = 300;
    std::map<int, bool> are_bars; // by instance
    // Bodies of fixtures are in no ray's way.
    const scene::FindHit find = [&](const glm::vec3& from_m,
                                    const glm::vec3& way) -> std::optional<scene::FocusHit> {
        const bake::Tracer::Meeting met = tracer.meet(from_m, way, kReach_m);
        if (met.instance < 0) return std::nullopt;
        const scene::Instance& instance = stage.instances[static_cast<std::size_t>(met.instance)];
        scene::FocusHit hit{met.distance_m, met.normal, instance.name};
        if (met.distance_m < scene::kAtLens_m) {
            const auto [known, is_new] = are_bars.try_emplace(met.instance);
            if (is_new) known->second = is_bar(stage, instance);
            hit.is_bar = known->second;
        }
        return hit;
    };
    const bool has_stage = !show.stage.instances.empty();
    const scene::FocusChart chart =
        scene::focus_of(show, moment.states, has_stage ? find : scene::FindHit{}, style, moment.said, moved);
    TRY_VOID(write_file_atomic(folder.written_to() / "focus.csv", scene::csv_of(scene::table_of(chart))));
    TRY(const std::string pdf, scene::pdf_of(chart, scene::paper_named(arguments.size), report));
    return write_file_atomic(folder.written_to() / "focus.pdf", pdf);
}

Result<void> make_paper(const PaperArguments& arguments) {
    catch_interrupts();
    TRY(WholeFolder folder, WholeFolder::open(arguments.out, "paperwork"));
    Report report;
    const bool needs_stage = arguments.plan || arguments.focus;
    TRY(scene::Show show, open_show(arguments.show, needs_stage, arguments.quiet, report));
    show.motion = fixture::Motion::as_commanded;
    Progress progress("paperwork", arguments.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    const auto goes_on = [&](double share, const char* what) {
        progress.update(share, steady_now_s(), what);
    };
    goes_on(kOpenedShare, "bodies");
    const scene::PrintStyle style = arguments.print.style();
    std::vector<scene::PaperDrawing> drawings;
    const scene::Stage stage = needs_stage ? scene::stage_with_bodies(show, report) : scene::Stage{};
    const Error interruption{"interrupted: nothing is written", arguments.out};
    if (interrupted()) return interruption;
    // A drawing that cannot be made takes no table with it.
    std::optional<Error> failed;
    const auto add = [&](const Result<void>& done, const char* file, const std::string& title) {
        if (done.ok()) {
            drawings.push_back({file, title});
            return;
        }
        log_error(done.error().text());
        failed = Error{"not all drawings could be made; the rest is written", arguments.out};
    };
    // Beside the rest, which takes as long.
    std::future<Result<scene::Drawings>> plan;
    if (arguments.plan)
        plan = std::async(std::launch::async, [&] { return draw_plan(arguments, show, stage); });
    std::optional<Result<void>> focus;
    if (arguments.focus) {
        goes_on(kStageShare, "focus charts");
        focus = draw_focus(arguments, show, stage, folder, report);
        if (interrupted()) return interruption;
    }
    goes_on(kFocusShare, "tables");
    const scene::Paper paper = scene::paper_of(show, style, arguments.circuit_w);
    for (const scene::PaperTable& table : paper.tables)
        TRY_VOID(write_file_atomic(folder.written_to() / (table.file + ".csv"), scene::csv_of(table)));
    const scene::PaperSize size = scene::paper_named(arguments.size);
    if (arguments.pdf) {
        TRY(const std::string pdf, scene::pdf_of(paper, size, report));
        TRY_VOID(write_file_atomic(folder.written_to() / "paper.pdf", pdf));
        if (interrupted()) return interruption;
    }
    goes_on(kTablesShare, "plan and section");
    if (plan.valid())
        add(write_plan(plan.get(), sheet_of(arguments), folder, report), "plan.pdf",
            style("Plan") + ", " + style("Section"));
    if (focus) add(*focus, "focus.pdf", style("Focus charts"));
    progress.finish();
    print_report(report);
    TRY_VOID(write_file_atomic(folder.written_to() / "index.html", scene::html_of(paper, size, drawings)));
    if (interrupted()) return interruption;
    TRY_VOID(folder.commit());
    log_info("wrote " + arguments.out + ": " + std::to_string(paper.tables.size()) + " tables of " +
             std::to_string(show.fixtures.size()) + " fixtures; open index.html in it");
    if (failed) return *failed;
    return {};
}

} // namespace

void add_paper(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "paper",
        "paperwork of a show, .csv and a page to print: instrument schedule, channel hookup, patch with "
        "what is free, gobos and colours, weight and power; plan and section to scale");
    const auto a = std::make_shared<PaperArguments>();
    command->add_option("SHOW", a->show, "folder with show.toml, or an .mvr")->required();
    command->add_option("-o,--out", a->out, "the folder to make; older paperwork there is replaced")
        ->required();
    command
        ->add_option("--paper", a->size,
                     "A4 or Letter, of the page when it is printed, and of the PDF of tables")
        ->check(CLI::IsMember({"A4", "Letter"}))
        ->capture_default_str();
    add_print_options(*command, a->print);
    command->add_flag("--pdf", a->pdf, "write paper.pdf, too: all tables, landscape");
    command
        ->add_option("--circuit", a->circuit_w,
                     "watts of a circuit in the proposal of phases (default: 3680, which is 16 A at 230 V; "
                     "with imperial units 2400, 20 A at 120 V)")
        ->type_name("WATTS")
        ->check(number_in(1.0, 1e6));
    CLI::Option* plan =
        command->add_flag("--plan", a->plan, "write plan.pdf, too: plan and section to scale, with symbols");
    command
        ->add_option("--scale", a->scale,
                     "1:25 to 1:200 or another one, or fit: the largest that fits a sheet")
        ->needs(plan)
        ->capture_default_str();
    std::vector<std::string> sheets;
    for (const scene::PaperFormat& format : scene::kPaperFormats) sheets.emplace_back(format.name);
    command
        ->add_option("--sheet", a->sheet, "paper of plan and section (default: A3, or Tabloid with Letter)")
        ->needs(plan)
        ->check(CLI::IsMember(sheets));
    command
        ->add_option("--section", a->section_x_m,
                     "cut the section there: metres right of the centre line, seen from the house")
        ->needs(plan)
        ->type_name("X")
        ->check(number_in(-10'000.0, 10'000.0));
    command->add_option("--date", a->date, "a date for the title block, printed as it is")->needs(plan);
    CLI::Option* focus = command->add_flag("--focus", a->focus,
                                           "write focus.pdf and focus.csv, too: where each lamp is aimed, "
                                           "what it hits, its pool with distances");
    CLI::Option* cue =
        command->add_option("--cue", a->moment.cue, "focus charts as in this cue (default: nothing is sent)")
            ->needs(focus)
            ->type_name("NAME");
    CLI::Option* look = command->add_option("--look", a->moment.look, "focus charts as in this look")
                            ->needs(focus)
                            ->excludes(cue)
                            ->type_name("NAME");
    command->add_option("--at", a->moment.at_s, "focus charts as at this second of the show's recording")
        ->needs(focus)
        ->excludes(cue)
        ->excludes(look)
        ->type_name("SECONDS")
        ->check(number_in(0.0, kLongest_s));
    command->add_flag("--quiet", a->quiet, "print warnings and errors only");
    command->footer("Example: ghostlight paper assets/demo -o paper\n"
                    "         ghostlight paper assets/demo -o paper --plan --scale 1:50 --sheet A3\n"
                    "         ghostlight paper assets/demo -o paper --focus --units imperial --paper Letter");
    command->callback([a, &exit_code] {
        if (a->quiet) set_log_level(LogLevel::warning);
        a->moment.quiet = a->quiet;
        if (const auto scale = scale_from(a->scale); !scale.ok()) {
            log_error(scale.error().text());
            exit_code = 2;
            return;
        }
        if (const Result<void> done = make_paper(*a); !done.ok()) {
            log_error(done.error().text());
            exit_code = 1;
        }
    });
}

} // namespace ghost::app
