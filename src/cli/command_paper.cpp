// SPDX-License-Identifier: Apache-2.0
// ghostlight paper: what a crew prints of a show: a folder of tables, and a page with all of them.
#include "book/paper_pages.h"
#include "book/pdf.h"
#include "cli/commands.h"
#include "disk/files.h"
#include "disk/whole_folder.h"
#include "live/session/session.h"

#include "base/interrupt.h"
#include "base/log.h"

#include <memory>
#include <string>

namespace ghost::app {
namespace {

constexpr const char* kPaperFile = "instruments.csv"; // by which a folder is known as one of these

struct PaperArguments {
    std::string show;
    std::string out;
    std::string size = "A4";
    bool pdf = false;
    bool quiet = false;
};

Result<void> make_paper(const PaperArguments& arguments) {
    TRY(WholeFolder folder, WholeFolder::open(arguments.out, kPaperFile));
    catch_interrupts();
    Report report;
    TRY(const scene::Show show, open_show(arguments.show, false, arguments.quiet, report));
    print_report(report);
    const scene::Paper paper = scene::paper_of(show);
    for (const scene::PaperTable& table : paper.tables)
        TRY_VOID(write_file_atomic(folder.written_to() / (table.file + ".csv"), scene::csv_of(table)));
    const scene::PaperSize size = arguments.size == "A4" ? scene::PaperSize::a4 : scene::PaperSize::letter;
    TRY_VOID(write_file_atomic(folder.written_to() / "index.html", scene::html_of(paper, size)));
    if (arguments.pdf) {
        TRY(const std::string pdf, scene::pdf_of(paper, size));
        TRY_VOID(write_file_atomic(folder.written_to() / "paper.pdf", pdf));
    }
    if (interrupted()) return Error{"interrupted: nothing is written", arguments.out};
    TRY_VOID(folder.commit());
    log_info("wrote " + arguments.out + ": " + std::to_string(paper.tables.size()) + " tables of " +
             std::to_string(show.fixtures.size()) + " fixtures; open index.html in it");
    return {};
}

} // namespace

void add_paper(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "paper",
        "paperwork of a show, .csv and a page to print: instrument schedule, channel hookup, patch with "
        "what is free, gobos and colours, weight and power");
    const auto a = std::make_shared<PaperArguments>();
    command->add_option("SHOW", a->show, "folder with show.toml, or an .mvr")->required();
    command->add_option("-o,--out", a->out, "the folder to make; older paperwork there is replaced")
        ->required();
    command->add_option("--paper", a->size, "A4 or Letter, of the page when it is printed, and of the PDF")
        ->check(CLI::IsMember({"A4", "Letter"}))
        ->capture_default_str();
    command->add_flag("--pdf", a->pdf, "write paper.pdf, too: all tables, landscape");
    command->add_flag("--quiet", a->quiet, "print warnings and errors only");
    command->footer("Example: ghostlight paper assets/demo -o paper");
    command->callback([a, &exit_code] {
        if (a->quiet) set_log_level(LogLevel::warning);
        if (const Result<void> done = make_paper(*a); !done.ok()) {
            log_error(done.error().text());
            exit_code = 1;
        }
    });
}

} // namespace ghost::app
