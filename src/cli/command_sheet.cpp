// SPDX-License-Identifier: Apache-2.0
// ghostlight sheet: all looks of a show from all of its cameras, small, on one picture; or all channels of a
// fixture file.
#include "base/interrupt.h"
#include "cli/commands.h"
#include "cli/options/number_option.h"
#include "cli/options/size_option.h"
#include "cli/options/tone_option.h"
#include "cli/render/channel_sheet.h"
#include "cli/render/chosen_cameras.h"
#include "dmx/record/player.h"
#include "dmx/record/recording_tasks.h"
#include "fixture_files/load_type.h"
#include "image/ldr.h"
#include "live/session/applied_look.h"
#include "live/session/caption.h"
#include "live/session/session.h"
#include "live/session/settle.h"

#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"

#include <algorithm>
#include <filesystem>
#include <memory>

namespace ghost::app {
namespace {

struct SheetArguments {
    SessionOptions session;
    std::string out;
    std::string size;
    std::string mode;               // of a fixture file
    std::vector<std::string> views; // empty: all
    double at_s = -1;
    int width = 0, height = 0; // of one picture
};

struct Row {
    std::string name;
    ui::Look look;
    double at_s = -1; // of the recording; below 0: without one
};

bool is_of_fixture(const SheetArguments& arguments) {
    return fixture::has_type_extension(arguments.session.show);
}

Result<void> check_usage(SheetArguments& arguments) {
    if (arguments.size.empty()) arguments.size = is_of_fixture(arguments) ? "160x120" : "480x270";
    TRY(const glm::ivec2 size, size_from(arguments.size, {16, 16}, 4096));
    arguments.width = size.x;
    arguments.height = size.y;
    if (std::filesystem::path(arguments.out).extension() != ".png")
        return Error{"a contact sheet is a .png", arguments.out};
    if (is_of_fixture(arguments) && arguments.views.size() > 1)
        return Error{"of a fixture's channels there is one view: side, wall or face", "--view"};
    if (is_of_fixture(arguments) && arguments.at_s >= 0)
        return Error{"a fixture file has no recording", "--at"};
    if (!is_of_fixture(arguments) && !arguments.mode.empty())
        return Error{"only a fixture file has modes to choose from", "--mode"};
    return {};
}

// The looks of the show; where it has none its cues, else one moment of its recording.
Result<std::vector<Row>> rows_of(const Session& session, const SheetArguments& arguments, Report& report) {
    const scene::Show& show = *session.show;
    const std::filesystem::path file = scene::looks_file(show);
    TRY(const std::vector<scene::StoredLook> looks, scene::load_looks(file, report));
    std::vector<Row> rows;
    for (const scene::StoredLook& look : looks) {
        scene::check_look(look, show, file.string(), report);
        Row& row = rows.emplace_back();
        row.name = look.name;
        row.look.fixtures = scene::programmer_of(look, show);
        row.look.scene = look.scene;
        row.at_s = arguments.at_s;
    }
    if (rows.empty() && arguments.at_s < 0)
        for (const scene::Cue& cue : show.cues)
            if (cue.at_s) rows.push_back({cue.name, {}, *cue.at_s});
    if (rows.empty()) rows.push_back({"", {}, std::max(arguments.at_s, 0.0)});
    return rows;
}

void put(const image::Image8& picture, int x, int y, image::Image8& sheet) {
    for (int row = 0; row < picture.height; ++row)
        std::copy_n(picture.at(0, row), 4 * picture.width, sheet.at(x, y + row));
}

Result<void> draw_sheet(SheetArguments& arguments) {
    TRY(const std::unique_ptr<Session> session, open_session(arguments.session));
    TRY(const std::vector<Row> rows, rows_of(*session, arguments, session->report));
    TRY(const std::vector<scene::Camera> cameras,
        chosen_cameras(*session->show, arguments.views, arguments.width, arguments.height));
    std::optional<dmx::Player> player;
    if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.at_s >= 0; }) &&
        !session->show->recording.empty()) {
        TRY(dmx::Recording recording,
            dmx::open_recording(session->show->recording, {}, arguments.session.quiet));
        player.emplace(std::move(recording));
    }
    const auto columns = static_cast<int>(cameras.size()), lines = static_cast<int>(rows.size());
    const std::int64_t width = kSheetGap_px + std::int64_t{columns} * (arguments.width + kSheetGap_px);
    const std::int64_t height = kSheetGap_px + std::int64_t{lines} * (arguments.height + kSheetGap_px);
    if (width * height > kMostSheetPixels)
        return Error{std::to_string(lines) + " looks of " + std::to_string(columns) + " cameras at " +
                         arguments.size + " are " + std::to_string(width) + "x" + std::to_string(height) +
                         " pixels, at most " + std::to_string(kMostSheetPixels) + " are possible",
                     "--size"};
    image::Image8 sheet(static_cast<int>(width), static_cast<int>(height), 4);
    std::fill(sheet.samples.begin(), sheet.samples.end(), kSheetGround);
    for (std::size_t i = 3; i < sheet.samples.size(); i += 4) sheet.samples[i] = 255;

    catch_interrupts();
    Progress progress("contact sheet",
                      arguments.session.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    session->show->motion = fixture::Motion::as_commanded;
    AppliedLook applied(*session);
    int drawn = 0;
    for (int line = 0; line < lines; ++line) {
        const Row& row = rows[static_cast<std::size_t>(line)];
        const dmx::Universes levels = player && row.at_s >= 0 ? player->at(row.at_s) : dmx::Universes{};
        settle(*session->rig, levels, row.look.fixtures);
        applied.apply(row.look, *session);
        for (int column = 0; column < columns; ++column) {
            if (interrupted()) return Error{"interrupted: nothing is written", arguments.out};
            const scene::Camera& camera = cameras[static_cast<std::size_t>(column)];
            session->look_from(camera);
            session->draw();
            image::Image8 picture = session->relighter->picture();
            draw_caption(picture, row.name.empty() ? camera.name : row.name + " - " + camera.name);
            put(picture, kSheetGap_px + column * (arguments.width + kSheetGap_px),
                kSheetGap_px + line * (arguments.height + kSheetGap_px), sheet);
            progress.update(static_cast<double>(++drawn) / (lines * columns), steady_now_s(), row.name);
        }
    }
    progress.finish();
    TRY_VOID(image::write_png(arguments.out, sheet));
    log_info("wrote " + arguments.out + ": " + std::to_string(lines) + " looks, " + std::to_string(columns) +
             " cameras");
    return {};
}

} // namespace

void add_sheet(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "sheet", "a contact sheet, one .png: all looks of a show (or its cues) from all of its cameras; of a "
                 "fixture file what each channel does");
    const auto a = std::make_shared<SheetArguments>();
    command->add_option("SHOW", a->session.show, "folder with show.toml, or an .mvr; or a .gdtf, .qxf, .json")
        ->required();
    command->add_option("-o,--out", a->out, "the .png")->required();
    command->add_option("--size", a->size, "WIDTHxHEIGHT of one picture (480x270; of a fixture file 160x120)")
        ->type_name("WxH");
    command
        ->add_option("--view", a->views,
                     "only this camera (may be repeated); of a fixture file side, wall or face (the lenses)")
        ->type_name("NAME");
    command->add_option("--mode", a->mode, "DMX mode of a fixture file (default: the first)")
        ->type_name("NAME");
    command->add_option("--at", a->at_s, "second of the recording that lights what a look leaves alone")
        ->check(number_in(0.0, kLongest_s));
    add_tone_option(*command, a->session.tone);
    command->add_option("--device", a->session.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command->add_flag("--quiet", a->session.quiet, "print warnings and errors only");
    command->footer(
        "Example: ghostlight sheet assets/demo -o looks.png --view house --view close\n"
        "         ghostlight sheet assets/fixtures/Ghostlight@Optics_Profile.gdtf -o channels.png");
    command->callback([a, &exit_code] {
        if (a->session.quiet) set_log_level(LogLevel::warning);
        if (const Result<void> usage = check_usage(*a); !usage.ok()) {
            log_error(usage.error().text());
            exit_code = 2;
            return;
        }
        if (is_of_fixture(*a)) {
            const ChannelSheetOptions options{a->session.show,
                                              a->mode,
                                              a->out,
                                              a->views.empty() ? "" : a->views.front(),
                                              a->width,
                                              a->height,
                                              a->session.device,
                                              a->session.quiet,
                                              a->session.tone};
            if (const Result<void> done = draw_channel_sheet(options); !done.ok()) {
                log_error(done.error().text());
                exit_code = 1;
            }
            return;
        }
        a->session.live = a->session.repeatable = true;
        a->session.width = a->width;
        a->session.height = a->height;
        if (const Result<void> done = draw_sheet(*a); !done.ok()) {
            log_error(done.error().text());
            exit_code = 1;
        }
    });
}

} // namespace ghost::app
