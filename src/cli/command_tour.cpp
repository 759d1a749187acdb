// SPDX-License-Identifier: Apache-2.0
// ghostlight tour: looks of a show for a client: a folder with a page that opens in any browser.
#include "book/book_json.h"
#include "book/tour_html.h"
#include "cli/commands.h"
#include "cli/options/checked_run.h"
#include "cli/options/number_option.h"
#include "cli/options/print_options.h"
#include "cli/options/size_option.h"
#include "cli/options/tone_option.h"
#include "cli/render/book_against.h"
#include "cli/render/book_drawing.h"
#include "cli/render/tour_film.h"
#include "disk/files.h"
#include "disk/whole_folder.h"
#include "dmx/record/player.h"
#include "dmx/record/recording_tasks.h"
#include "live/session/session.h"
#include "show/show.h"

#include "base/interrupt.h"
#include "base/log.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace ghost::app {
namespace {

constexpr const char* kTourFile = "book.json"; // by which it is compared with one
constexpr const char* kFilmFile = "film.mp4";
constexpr double kLongestFilm_s = 600;

struct TourArguments {
    BookOptions book;
    std::string out;
    std::string size = "1280x720";
    std::string against;
    scene::TourPage page;
    PrintOptions print;
    TourFilm film;
    bool cues = false, looks = false;
    bool notes = false;
};

Result<void> check_usage(TourArguments& arguments) {
    TRY(const glm::ivec2 size, size_from(arguments.size, {16, 16}, 4096));
    arguments.book.width = size.x;
    arguments.book.height = size.y;
    if (arguments.film.length_s > 0 && (size.x % 2 != 0 || size.y % 2 != 0))
        return Error{"a film needs even numbers of pixels", "--size"};
    if (arguments.cues) arguments.book.kind = scene::BookKind::cues;
    if (arguments.looks) arguments.book.kind = scene::BookKind::looks;
    arguments.book.is_for_client = true;
    arguments.page.style = arguments.book.style = arguments.print.style();
    return {};
}

// Soon, before other long work.
Result<void> check_film(const TourArguments& arguments) {
    Report report; // is said when the pictures are drawn
    const bool quiet = arguments.book.session.quiet;
    TRY(const scene::Show show, open_show(arguments.book.session.show, false, quiet, report));
    if (show.recording.empty()) return Error{"has no recording for --film", show.file.string()};
    TRY(dmx::Recording recording, dmx::open_recording(show.recording, {}, quiet));
    const double end_s = dmx::Player(std::move(recording)).duration_s();
    if (arguments.film.from_s >= end_s)
        return Error{"the recording ends at " + scene::PrintStyle{}.number(end_s, 2) + " s, --film-from " +
                         scene::PrintStyle{}.number(arguments.film.from_s, 2) + " is behind it",
                     show.recording.string()};
    return {};
}

Result<void> make_tour(TourArguments& arguments) {
    catch_interrupts();
    TRY(WholeFolder folder, WholeFolder::open(arguments.out, "tour"));
    TRY_VOID(folder.make_folder("pictures"));
    if (arguments.film.length_s > 0) TRY_VOID(check_film(arguments));
    std::optional<scene::Book> old;
    if (!arguments.against.empty()) {
        TRY(old, old_book(arguments.against));
    }
    // Under another exposure every picture differs.
    if (old && !arguments.book.session.ev100) arguments.book.session.ev100 = old->ev100;
    TRY(DrawnBook drawn, draw_book(arguments.book, folder.written_to(), nullptr));
    drawn.book = scene::for_client(std::move(drawn.book), arguments.notes);
    std::optional<scene::BookDifference> difference;
    if (!arguments.against.empty()) {
        TRY(difference, compare_books(arguments.book, drawn, arguments.against, old, folder));
    }
    if (arguments.film.length_s > 0) {
        SessionOptions session = arguments.book.session;
        session.width = arguments.book.width;
        session.height = arguments.book.height;
        session.view = drawn.frame.cameras.front().name;
        session.ev100 = drawn.frame.ev100;
        TRY_VOID(draw_tour_film(session, arguments.film, folder.written_to() / kFilmFile));
        arguments.page.film = kFilmFile;
    }
    TRY_VOID(write_file_atomic(folder.written_to() / kTourFile, scene::text_of(drawn.book)));
    TRY_VOID(
        write_file_atomic(folder.written_to() / "index.html",
                          scene::tour_html(drawn.book, difference ? &*difference : nullptr, arguments.page)));
    TRY_VOID(folder.commit());
    log_info("wrote " + arguments.out + ": " + std::to_string(drawn.book.entries.size()) + " looks from " +
             std::to_string(drawn.frame.cameras.size()) + " cameras; open index.html in it");
    return {};
}

} // namespace

void add_tour(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "tour", "looks of a show for a client: a folder that opens in any browser, with a slider between two "
                "looks or two versions, and a short film");
    const auto a = std::make_shared<TourArguments>();
    SessionOptions& session = a->book.session;
    command->add_option("SHOW", session.show, "folder with show.toml, or an .mvr")->required();
    command->add_option("-o,--out", a->out, "the folder to make; an older tour there is replaced")
        ->required();
    CLI::Option* cues = command->add_flag("--cues", a->cues, "show the cues (default, where there are any)");
    command->add_flag("--looks", a->looks, "show the looks (default, where there are no cues)")
        ->excludes(cues);
    command->add_option("--only", a->book.only, "this cue or look (may be repeated; default: all)")
        ->type_name("NAME")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--view", a->book.views, "from this camera (may be repeated; default: all)")
        ->type_name("NAME")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--size", a->size, "WIDTHxHEIGHT of a picture and of the film")
        ->type_name("WxH")
        ->capture_default_str();
    command->add_option("--ev", session.ev100, "EV100 of all pictures (default: that of the first camera)")
        ->check(number_in(-20.0, 40.0));
    command
        ->add_option("--against", a->against,
                     "an older show, plot, book or tour: a slider from its pictures to these")
        ->type_name("OLD")
        ->check(CLI::ExistingPath);
    CLI::Option* film =
        command
            ->add_option("--film", a->film.length_s,
                         "a film of so many seconds of the show's recording, from the first camera")
            ->type_name("SECONDS")
            ->check(number_in(0.1, kLongestFilm_s));
    command->add_option("--film-from", a->film.from_s, "second of the recording at which it begins")
        ->needs(film)
        ->type_name("SECONDS")
        ->check(number_in(0.0, kLongest_s));
    command->add_option("--title", a->page.title, "instead of the show's name");
    command->add_option("--note", a->page.note, "a line below the title");
    command->add_flag("--notes", a->notes,
                      "show the notes of the cues, too, which are the stage manager's (default: none)");
    add_print_options(*command, a->print);
    add_tone_option(*command, session.tone);
    command->add_option("--device", session.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command->add_flag("--quiet", session.quiet, "print warnings and errors only");
    command->footer("Example: ghostlight tour assets/demo -o tour --view house --view close\n"
                    "         ghostlight tour assets/demo -o tour --film 8 --film-from 20 --language de");
    command->callback([a, &exit_code] {
        exit_code = checked_run(
            a->book.session.quiet, [&] { return check_usage(*a); }, [&] { return make_tour(*a); });
    });
}

} // namespace ghost::app
