// SPDX-License-Identifier: Apache-2.0
// ghostlight book: the cue book of a show, a folder with pictures and a page that opens in any browser.
#include "book/book_html.h"
#include "book/book_json.h"
#include "book/pdf.h"
#include "cli/commands.h"
#include "cli/options/checked_run.h"
#include "cli/options/number_option.h"
#include "cli/options/print_options.h"
#include "cli/options/size_option.h"
#include "cli/options/tone_option.h"
#include "cli/render/book_against.h"
#include "cli/render/book_drawing.h"
#include "disk/files.h"
#include "disk/whole_folder.h"

#include "base/interrupt.h"
#include "base/log.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace ghost::app {
namespace {

constexpr const char* kBookFile = "book.json";

struct BookArguments {
    BookOptions book;
    PrintOptions print;
    std::string out;
    std::string size = "640x360";
    std::string against;
    std::string paper = "A4";
    std::string layout = "list";
    bool cues = false, looks = false, find = false;
    bool pdf = false;
};

Result<void> check_usage(BookArguments& arguments) {
    TRY(const glm::ivec2 size, size_from(arguments.size, {16, 16}, 4096));
    arguments.book.width = size.x;
    arguments.book.height = size.y;
    arguments.book.style = arguments.print.style();
    if (arguments.cues) arguments.book.kind = scene::BookKind::cues;
    if (arguments.looks) arguments.book.kind = scene::BookKind::looks;
    if (arguments.find) arguments.book.kind = scene::BookKind::found;
    if (!arguments.book.marks.empty()) arguments.book.kind = scene::BookKind::marks;
    return {};
}

Result<void> make_book(BookArguments& arguments) {
    catch_interrupts();
    TRY(WholeFolder folder, WholeFolder::open(arguments.out, "cue book"));
    TRY_VOID(folder.make_folder("pictures"));
    std::optional<scene::Book> old;
    if (!arguments.against.empty()) {
        TRY(old, old_book(arguments.against));
    }
    // Under another exposure every picture differs.
    if (old && !arguments.book.session.ev100) arguments.book.session.ev100 = old->ev100;
    TRY(const DrawnBook drawn, draw_book(arguments.book, folder.written_to(), nullptr));
    std::optional<scene::BookDifference> difference;
    if (!arguments.against.empty()) {
        TRY(difference, compare_books(arguments.book, drawn, arguments.against, old, folder));
    }
    const scene::PaperSize paper = scene::paper_named(arguments.paper);
    const scene::BookLayout layout =
        arguments.layout == "grid" ? scene::BookLayout::grid : scene::BookLayout::list;
    TRY_VOID(write_file_atomic(folder.written_to() / kBookFile, scene::text_of(drawn.book)));
    TRY_VOID(write_file_atomic(folder.written_to() / "values.csv", drawn.values_csv));
    if (difference)
        TRY_VOID(write_file_atomic(folder.written_to() / "difference.json", scene::text_of(*difference)));
    TRY_VOID(write_file_atomic(folder.written_to() / "index.html",
                               scene::html_of(drawn.book, difference ? &*difference : nullptr, paper,
                                              arguments.book.style, layout)));
    if (arguments.pdf) {
        Report report;
        TRY(const std::string pdf,
            scene::pdf_of(drawn.book, difference ? &*difference : nullptr, folder.written_to(), paper, report,
                          arguments.book.style, layout));
        print_report(report);
        TRY_VOID(write_file_atomic(folder.written_to() / "book.pdf", pdf));
    }
    TRY_VOID(folder.commit());
    std::size_t pictures = 0;
    for (const scene::BookEntry& entry : drawn.book.entries) pictures += entry.pictures.size();
    log_info("wrote " + arguments.out + ": " + std::to_string(drawn.book.entries.size()) + " entries (" +
             drawn.book.kind + "), " + std::to_string(pictures) + " pictures; open index.html in it");
    return {};
}

} // namespace

void add_book(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "book", "the cue book: a folder with a picture of each cue and what changes in words, to read in a "
                "browser and to print");
    const auto a = std::make_shared<BookArguments>();
    SessionOptions& session = a->book.session;
    command->add_option("SHOW", session.show, "folder with show.toml, or an .mvr")->required();
    command->add_option("-o,--out", a->out, "the folder to make; an older book there is replaced")
        ->required();
    CLI::Option* cues =
        command->add_flag("--cues", a->cues, "an entry for each [[cue]] (default, where there are any)");
    CLI::Option* looks =
        command->add_flag("--looks", a->looks, "an entry for each look (default, where there are no cues)");
    CLI::Option* find =
        command->add_flag("--find", a->find, "an entry wherever the show's recording comes to rest");
    CLI::Option* marks =
        command
            ->add_option("--marks", a->book.marks,
                         "an entry for each line of a CSV file: time (seconds or H:MM:SS) of the show's "
                         "recording, number, name, note")
            ->type_name("FILE")
            ->check(CLI::ExistingFile);
    command
        ->add_option("--mark-fps", a->book.mark_fps, "frames a second of time code (H:MM:SS:FF) in --marks")
        ->needs(marks)
        ->check(CLI::IsMember({"24", "25", "30"}));
    cues->excludes(looks)->excludes(find)->excludes(marks);
    looks->excludes(find)->excludes(marks);
    find->excludes(marks);
    command
        ->add_option("--view", a->book.views,
                     "from this camera (may be repeated; default: where the cues have put the picture)")
        ->type_name("NAME")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--size", a->size, "WIDTHxHEIGHT of a picture")
        ->type_name("WxH")
        ->capture_default_str();
    command->add_option("--ev", session.ev100, "EV100 of all pictures (default: that of the first camera)")
        ->check(number_in(-20.0, 40.0));
    command
        ->add_option("--against", a->against,
                     "an older show, plot or book: what is new, gone, moved, patched elsewhere, and how far "
                     "the pictures differ")
        ->type_name("OLD")
        ->check(CLI::ExistingPath);
    command->add_option("--paper", a->paper, "A4 or Letter, of the page when it is printed, and of the PDF")
        ->check(CLI::IsMember({"A4", "Letter"}))
        ->capture_default_str();
    command->add_flag("--pdf", a->pdf, "write book.pdf, too");
    command
        ->add_option("--layout", a->layout,
                     "list: four entries on a page, with what changes in words; grid: twelve, each with its "
                     "first picture")
        ->check(CLI::IsMember({"list", "grid"}))
        ->capture_default_str();
    add_print_options(*command, a->print);
    add_tone_option(*command, session.tone);
    command->add_option("--device", session.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command->add_flag("--quiet", session.quiet, "print warnings and errors only");
    command->footer("Example: ghostlight book assets/demo -o book --view house --view close\n"
                    "         ghostlight book assets/demo -o book_2 --against book\n"
                    "         ghostlight book assets/demo -o book_3 --marks cues.csv");
    command->callback([a, &exit_code] {
        exit_code = checked_run(
            a->book.session.quiet, [&] { return check_usage(*a); }, [&] { return make_book(*a); });
    });
}

} // namespace ghost::app
