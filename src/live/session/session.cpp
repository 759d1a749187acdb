// SPDX-License-Identifier: Apache-2.0
#include "live/session/session.h"

#include "bake/bake_show.h"
#include "base/interrupt.h"
#include "beam_groups/light_places.h"
#include "beam_groups/prism.h"
#include "gpu/device_memory.h"
#include "live/session/made_session.h"
#include "live/session/passes_sources.h"
#include "live/session/picture_room.h"
#include "passes/passes_file.h"
#include "render/geometry/pass_images.h"
#include "render/relight/room_light.h"
#include "show_file/show_edit.h"
#include "show_folder/load_show.h"
#include "show_folder/place_checks.h"

#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "disk/user_cache.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSpareToPark = std::uint64_t{256} << 20;
constexpr float kSamePlace_m = 0.05f;
constexpr int kMostPixelsAcross = 16384; // what every device of today takes

// What drivers made of shaders (gpu/pipeline_cache.h); empty: this user has no place for it.
std::string folder_of_pipelines() {
    const fs::path cache = user_cache();
    return cache.empty() ? "" : (cache / "pipelines").string();
}

Result<void> bake_view(const scene::Show& show, const std::string& view, const fs::path& folder, bool quiet,
                       Report& report) {
    catch_interrupts();
    Progress progress("baking", quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    bake::BakeOptions options;
    options.views = {view};
    options.stop = interrupted;
    options.progress = [&](double share, const std::string& note) {
        progress.update(share, steady_now_s(), note);
    };
    // As it was baked before: a long bake is not replaced by a short one.
    if (const auto manifest = scene::read_manifest(folder); manifest.ok() && manifest->spp > 0) {
        options.spp = manifest->spp;
        options.bounces = manifest->bounces;
    }
    const Result<bake::BakeStats> stats = bake::bake_show(show, options, report);
    progress.finish();
    if (!stats.ok()) return stats.error();
    if (stats->interrupted)
        return Error{
            "interrupted while baking; finished passes are kept, the same command goes on from there", ""};
    return {};
}

// A pass rendered elsewhere says where its light stood; where that is not where the show hangs it, the
// picture is right for the pass and wrong for the show.
void compare_positions(const scene::Show& show, const scene::Passes& passes, const std::string& file,
                       Report& report) {
    for (const scene::PatchedFixture& fixture : show.fixtures) {
        const int pass = passes.find(fixture.name, 0);
        if (pass < 0 || !fixture.type) continue;
        const glm::vec3 there = passes.lights[static_cast<std::size_t>(pass)].position_m;
        const glm::vec3 here = scene::light_position_m(fixture, 0);
        if (glm::length(there - here) < kSamePlace_m) continue;
        const auto text = [](const glm::vec3& m) {
            char buffer[64];
            std::snprintf(buffer, sizeof buffer, "[%.2f, %.2f, %.2f]", static_cast<double>(m.x),
                          static_cast<double>(m.y), static_cast<double>(m.z));
            return std::string(buffer);
        };
        report.add(Severity::warning, file,
                   "the light of '" + fixture.name + "' stands at " + text(there) + ", the show has it at " +
                       text(here) + "; the passes are believed");
    }
}

Result<void> take_look(const SessionOptions& options, scene::Show& show, Session& session, Report& report) {
    const fs::path file = options.looks_file.empty() ? scene::looks_file(show) : fs::path(options.looks_file);
    std::error_code unreadable; // then reading it says why
    if (!options.looks_file.empty() && !fs::exists(file, unreadable))
        return Error{"no such file", file.string()};
    TRY(const std::vector<scene::StoredLook> looks, scene::load_looks(file, report));
    const Result<std::size_t> index = scene::find_look(looks, options.look);
    if (!index.ok()) return Error{index.error().what, file.string()};
    scene::check_look(looks[*index], show, file.string(), report);
    session.programmer = scene::programmer_of(looks[*index], show);
    session.movers = scene::movers_of(looks[*index], show);
    session.scene_look = looks[*index].scene;
    session.shadows = session.scene_look.shadows.value_or(session.shadows);
    return {};
}

Result<scene::Passes> get_passes(scene::Show& show, const scene::Camera& camera,
                                 const SessionOptions& options, Report& report) {
    if (!camera.foreign_passes.empty()) {
        if (options.width > 0)
            return Error{"the passes of camera '" + camera.name +
                             "' were rendered elsewhere and have one size only",
                         "--size"};
        TRY(scene::Passes passes, scene::load_foreign_passes(camera.foreign_passes, report));
        compare_positions(show, passes, camera.foreign_passes.string(), report);
        return passes;
    }
    const fs::path folder = scene::passes_folder(show, camera.name);
    const std::string wanted = passes_fingerprint(show);
    const auto remember = [&] {
        if (const Result<void> written = remember_sources(show, camera.name, wanted); !written.ok())
            report.add(Severity::warning, written.error().where, written.error().what);
    };
    if (options.bake && !passes_are_of(show, camera.name, wanted)) {
        std::error_code code;
        const bool baked_before = fs::exists(folder / "manifest.json", code);
        Report of_stage;
        const bool has_stage = load_stage(show, of_stage);
        report.messages.insert(report.messages.end(), of_stage.messages.begin(), of_stage.messages.end());
        if (has_stage || !baked_before) TRY_VOID(bake_view(show, camera.name, folder, options.quiet, report));
        // What is lost is said again at every render, until it is there.
        if (has_stage && !of_stage.lost_anything())
            remember();
        else if (!has_stage && baked_before)
            report.add(Severity::warning, folder.string(),
                       "the stage cannot be read: these older passes are shown");
    }
    Report found;
    Result<scene::Passes> passes = scene::load_passes(folder, true, found);
    if (options.bake && (!passes.ok() || found.lost_anything()) && load_stage(show, report)) {
        for (const Message& message : found.messages)
            report.add(Severity::warning, message.where, message.what + "; it is baked again");
        if (!passes.ok())
            report.add(Severity::warning, passes.error().where, passes.error().what + "; it is baked again");
        TRY_VOID(bake_view(show, camera.name, folder, options.quiet, report));
        remember();
        found = {};
        passes = scene::load_passes(folder, true, found);
    }
    report.messages.insert(report.messages.end(), found.messages.begin(), found.messages.end());
    return passes;
}

bool has_size(const std::unique_ptr<render::Relighter>& one, const scene::Camera& camera) {
    return one && one->width() == camera.width && one->height() == camera.height;
}

} // namespace

Result<scene::Show> open_show(const std::string& path, bool load_stage, bool quiet, Report& report,
                              const std::shared_ptr<const std::string>& text) {
    const InterruptScope scope;
    Progress progress("opening", quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    const scene::ShowLoading loading{
        [&](double share, const std::string& what) { progress.update(share, steady_now_s(), what); },
        interrupted};
    std::error_code code;
    const fs::path file = fs::is_directory(path, code) ? fs::path(path) / "show.toml" : fs::path(path);
    auto show = text ? scene::load_show_text(file, *text, load_stage, report, loading)
                     : scene::load_show(path, load_stage, report, loading);
    progress.finish();
    return show;
}

bool load_stage(scene::Show& show, Report& report) {
    if ((show.stage_file.empty() && !show.plot) || !show.stage.instances.empty()) return true;
    const InterruptScope scope;
    Progress progress("reading the stage", Progress::style_for_stderr(), steady_now_s());
    const scene::ShowLoading loading{
        [&](double share, const std::string& what) { progress.update(share, steady_now_s(), what); },
        interrupted};
    Result<scene::Stage> stage = scene::read_stage(show, report, loading);
    progress.finish();
    if (!stage.ok()) {
        report.add(Severity::error, stage.error().where, stage.error().what);
        return false;
    }
    show.stage = std::move(*stage);
    // A plot may hold fixtures only.
    return !show.stage.instances.empty() || show.stage_file.empty();
}

void print_report(const Report& report, std::size_t skip) {
    for (std::size_t i = skip; i < report.messages.size(); ++i) {
        const Message& message = report.messages[i];
        const std::string line = message.where.empty() ? message.what : message.where + ": " + message.what;
        if (message.severity == Severity::note)
            log_debug(line);
        else if (message.severity == Severity::warning)
            log_warning(line);
        else
            log_error(line);
    }
}

render::Settings draw_settings(const Atmosphere& air, const scene::Camera& camera,
                               const SessionOptions& options) {
    render::Settings settings;
    settings.haze = air.medium();
    settings.beams = options.beams;
    settings.ambient = air.ambient;
    settings.lights_per_dispatch = options.lights_per_dispatch;
    // Who works on shaders wants to see them.
    settings.pixels_on_processor = options.pixels_on_processor && options.shaders.empty();
    settings.lens.on = options.glare > 0;
    settings.glare.strength = options.glare;
    settings.air_field = air.field();
    settings.beams.uneven = air.is_uneven();
    settings.ev100 = options.ev100.value_or(camera.ev100);
    settings.auto_exposure = camera.auto_exposure && !options.ev100;
    settings.tone = options.tone;
    settings.image_memory_bytes = options.image_memory_bytes;
    if (options.repeatable) settings.visibility_bytes = 0;
    settings.workers = options.workers;
    return settings;
}

scene::FrameLights Session::lit() const {
    scene::FrameLights lit = live ? rig->lit(gobos, live->maps()) : rig->lit(gobos, passes);
    for (shared::Light& light : lit.lights) {
        light.intensity_cd *= master;
        light.bounce_cd *= master;
        if (live && !shadows) light.map = 0;
    }
    for (scene::LensFace& face : lit.faces) {
        face.light.intensity_cd *= master;
        face.light.bounce_cd *= master;
    }
    for (shared::LedWall& wall : lit.walls) wall.radiance *= master;
    return lit;
}

std::unique_ptr<render::Relighter> Session::make_relighter(const scene::Camera& from, bool coarse) const {
    render::Settings settings = draw_settings(atmosphere(), from, options);
    settings.coarse = coarse;
    auto made =
        std::make_unique<render::Relighter>(*device, live->g_buffer(), live->distances(), gobos.images,
                                            static_cast<int>(lit().lights.size()), settings);
    made->set_tone(options.tone);
    return made;
}

void Session::on_lights(const std::function<void(render::Relighter&)>& what) const {
    for (const auto& one : {relighter.get(), other_light.get(), lux_light.get()})
        if (one) what(*one);
}

void Session::take_bounced() {
    on_lights([&](render::Relighter& one) { one.set_room_light(bounced); });
}

// Memory holds both pictures, and what a relighter has whatever its picture's size.
bool Session::parks(const scene::Camera& from) const {
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(from.width) * static_cast<std::uint64_t>(from.height);
    return options.parks && device->memory().left_bytes() > 2 * kPictureBytesPerPixel * pixels + kSpareToPark;
}

bool Session::is_another(const scene::Camera& from, bool goes_on) const {
    return !has_size(relighter, from) || (options.parks && splits_flights && flies != goes_on);
}

bool Session::prepare(const scene::Camera& from, const std::function<bool()>& stop) {
    if (!live || !relighter || !is_another(from, false)) return true;
    if (!has_size(parked, from) || parked_flies) {
        parked.reset();
        parked_other_light.reset();
        splits_flights = parks(from);
        if (!splits_flights) return true;
    }
    live->set_atmosphere(atmosphere());
    return live->prepare(from, stop);
}

void Session::look_from(const scene::Camera& from, bool goes_on) {
    look_from(from, goes_on, relighter && relighter->is_coarse());
}

void Session::look_from(const scene::Camera& from, bool goes_on, bool coarse) {
    const bool stays = !is_another(from, goes_on);
    bool keeps = options.parks;
    if (!stays) {
        lux_light.reset();
        std::swap(relighter, parked);
        std::swap(other_light, parked_other_light);
        std::swap(flies, parked_flies);
        keeps = parked && parks(from);
        if (is_another(from, goes_on)) {
            relighter.reset();
            other_light.reset();
        }
        if (!keeps) { // they refer to the picture that goes
            parked.reset();
            parked_other_light.reset();
        }
    }
    flies = goes_on;
    const bool has_other_maps = !stays && std::exchange(maps_changed_since_parked, false);
    live->set_atmosphere(atmosphere());
    const bool is_anew =
        live->look_from(from, keeps, flies, options.parks && splits_flights) == LiveView::Seen::anew ||
        has_other_maps;
    if (!relighter) relighter = make_relighter(from, coarse);
    on_lights([&](render::Relighter& one) {
        if (is_anew)
            one.forget();
        else
            one.touch();
        one.set_flies(flies);
        if (!stays) one.set_room_light(bounced);
    });
    use_coarse_light(coarse);
    relighter->set_tone(options.tone);
    relighter->set_exposure(options.ev100.value_or(from.ev100), from.auto_exposure && !options.ev100);
}

void Session::use_coarse_light(bool coarse) {
    if (!live || relighter->is_coarse() == coarse) return;
    std::swap(relighter, other_light);
    if (!relighter) {
        // The only one, where memory is short.
        const std::uint64_t pixels = static_cast<std::uint64_t>(other_light->width()) *
                                     static_cast<std::uint64_t>(other_light->height());
        if (device->memory().left_bytes() < kPictureBytesPerPixel * pixels + kSpareToPark)
            other_light.reset();
        relighter = make_relighter(live->camera(), coarse);
    }
    relighter->set_tone(options.tone);
    relighter->set_flies(flies);
    if (bounced) relighter->set_room_light(bounced);
}

void Session::drop_parked() {
    parked.reset();
    parked_other_light.reset();
    live->drop_parked();
}

void Session::stop_drawing() {
    parked.reset();
    parked_other_light.reset();
    other_light.reset();
    lux_light.reset();
    relighter.reset();
    bounce.reset();
    live.reset();
}

Session::~Session() = default;

void Session::show_media(double time_s) {
    if (!media) return;
    const std::size_t before = report.messages.size();
    media->show(media_s.value_or(time_s), media_waits, gobos, report);
    print_report(report, before);
    relighter->set_slides(gobos.images.slides);
}

void Session::set_bounce(scene::BounceDetail level) {
    if (!live || level == bounce_detail_) return;
    bounce_detail_ = level;
    bounce.reset();
    bounced.reset();
    if (level != scene::BounceDetail::off)
        bounce = std::make_unique<BounceLight>(*show, live->solid(), level, gobos.images);
    take_bounced();
    if (live->set_forward_per_m(0)) look_from(live->camera(), flies);
}

void Session::stop_bounce(bool stops) {
    if (!bounce) return;
    if (stops)
        bounce->stop_making();
    else if (bounce->is_stopped())
        set_bounce(std::exchange(bounce_detail_, scene::BounceDetail::off));
}

void Session::update_bounce(const scene::FrameLights& lit) {
    if (!bounce) return;
    const bool waits = !options.maps_in_background;
    if (waits && bounce->is_making_links()) bounce->wait_for_links(options.quiet);
    const shared::Haze haze = live->haze();
    const auto solved = bounce->update(lit.lights, gobos.images, haze, live->camera().position_m, waits);
    if (const auto failure = bounce->take_failure()) {
        const std::size_t before = report.messages.size();
        report.add(Severity::warning, failure->where, failure->what);
        print_report(report, before);
    }
    if (!solved) return;
    if (const std::string beyond = render::RoomLight::beyond_device(*device, *solved); !beyond.empty()) {
        const std::size_t before = report.messages.size();
        report.add(Severity::warning, "bounced light",
                   "it needs " + beyond +
                       "; no light bounces. Lamps and objects far from all others make the room so large");
        print_report(report, before);
        bounce.reset(); // the same room would come again
        return;
    }
    bounced = solved;
    take_bounced();
    if (live->set_forward_per_m(haze.extinction_per_m - bounced->extinction_per_m))
        look_from(live->camera(), flies);
}

render::FrameStatistics Session::draw(double time_s, const std::function<bool()>& stop) {
    relighter->set_air(atmosphere().field(time_s));
    show_media(time_s);
    const double start_s = steady_now_s();
    std::vector<gpu::Span> spans;
    if (live) {
        const std::size_t printed = report.messages.size();
        for (Message& message : rig->movers().take_messages()) report.messages.push_back(std::move(message));
        if (live->take_maps(report)) {
            on_lights([](render::Relighter& one) { one.forget(); });
            maps_changed_since_parked = true;
        }
        print_report(report, printed);
        // Where there is no time for all lights, heads turn as often as their beams do. What movers carry is
        // where its light and shadow are.
        const bool may_lag = is_short_ && show->movers.empty();
        behind_ = may_lag ? (behind_ + 1) % render::LightBudget::kOldest : 0;
        if (behind_ == 0 && live->follow(*rig)) {
            on_lights([](render::Relighter& one) { one.touch(); });
            spans = live->g_buffer().spans();
        }
    }
    const scene::FrameLights shining = lit();
    if (live && live->update_maps(shining.lights)) {
        on_lights([](render::Relighter& one) { one.forget(); });
        maps_changed_since_parked = true;
    }
    if (live && live->draws_maps()) {
        const std::vector<gpu::Span> drawn = live->distances()->drawing_spans();
        spans.insert(spans.end(), drawn.begin(), drawn.end());
    }
    update_bounce(shining);
    const double before_ms = 1e3 * (steady_now_s() - start_s);
    render::FrameStatistics statistics = relighter->draw(shining, stop);
    is_short_ = statistics.is_short;
    statistics.draw_ms += before_ms;
    statistics.spans.insert(statistics.spans.begin(), spans.begin(), spans.end());
    return statistics;
}

Result<std::unique_ptr<Session>> open_session(const SessionOptions& options) {
    Report report;
    TRY(scene::Show show, open_show(options.show, false, options.quiet, report, options.text));
    return open_session(options, std::move(show), std::move(report));
}

Result<std::unique_ptr<Session>> open_session(const SessionOptions& asked, scene::Show show, Report read) {
    auto session = std::make_unique<Session>();
    SessionOptions& options = session->options = asked;
    session->report = std::move(read);
    Report& report = session->report;
    session->of_show_file = report.messages.size();
    show.motion = options.motion.value_or(show.motion);
    if (!options.look.empty()) TRY_VOID(take_look(options, show, *session, report));
    session->show = std::make_unique<scene::Show>(std::move(show));
    print_report(report);
    std::size_t printed = report.messages.size();

    if (options.plays_recording && session->show->recording.empty())
        return Error{"has no recording; name one with --replay FILE, or listen to a desk with --live-input",
                     session->show->file.string()};
    if (options.plays_recording)
        if (std::error_code code; !fs::exists(session->show->recording, code))
            return Error{"no such file", session->show->recording.string()};
    TRY(session->camera, session->show->find_camera(options.view));
    if (!options.travel.empty()) {
        TRY(const std::size_t end, session->show->find_camera(options.travel));
        session->travel_to = session->show->cameras[end];
    }
    scene::Camera camera = options.eye.value_or(session->show->cameras[session->camera]);
    const scene::BounceDetail bounce = options.bounce.value_or(session->show->bounce);
    if (bounce != scene::BounceDetail::off && camera.foreign_passes.empty() && !options.live) {
        log_info("light bounces: drawn live, whatever is baked");
        options.live = true;
    }
    if (!session->show->movers.empty() && camera.foreign_passes.empty() && !options.live) {
        log_info("the show has movers: drawn live, whatever is baked");
        options.live = true;
    }
    if (options.width > 0) {
        camera.width = options.width;
        camera.height = options.height;
        if (!options.live)
            camera.name += "@" + std::to_string(options.width) + "x" + std::to_string(options.height);
    }
    if (std::max(camera.width, camera.height) * options.supersample > kMostPixelsAcross)
        return Error{"a picture " + std::to_string(options.supersample) + " times as large as " +
                         std::to_string(camera.width) + "x" + std::to_string(camera.height) +
                         " is more than " + std::to_string(kMostPixelsAcross) + " pixels across",
                     "--supersample"};
    camera.width *= options.supersample;
    camera.height *= options.supersample;
    if (options.map_size > 0) session->show->distance_map_size = options.map_size;
    if (options.width > 0 || options.eye || options.supersample > 1) {
        session->camera = session->show->cameras.size();
        session->show->cameras.push_back(camera);
    }

    if (!options.live) {
        TRY(session->passes, get_passes(*session->show, camera, options, report));
    }
    session->gobos = scene::build_gobos(*session->show, report);
    scene::check_prisms(*session->show, report);
    if (!session->show->media.empty())
        session->media = std::make_unique<MediaPlayer>(*session->show, session->gobos);
    print_report(report, printed);
    printed = report.messages.size();

    const auto ends = [&] {
        return options.stop ? options.stop() : !options.maps_in_background && interrupted();
    };
    const Error interruption{"interrupted: nothing is drawn", ""};
    if (ends()) return interruption;
    TRY(session->device,
        gpu::Device::create({options.device, options.validation, options.memory_limit_bytes, options.shaders,
                             options.pipeline_statistics, options.lowered_limits, options.workers,
                             folder_of_pipelines(), options.presents}));
    log_info("drawing on " + session->device->name());
    session->rig = std::make_unique<scene::Rig>(*session->show);
    session->rig->movers().drive(session->movers);
    const render::Settings settings = draw_settings(session->atmosphere(), camera, options);
    if (options.live) {
        const LiveOptions live{options.shadows && session->show->shadows,
                               options.maps_in_background,
                               options.quiet,
                               options.keep_hidden,
                               session->atmosphere(),
                               ends,
                               options.moving_maps};
        TRY(session->live, LiveView::open(*session->device, *session->show, camera, live, report));
        scene::check_places(*session->show, session->live->stage(), {&camera, 1}, report);
        print_report(report, printed);
    }
    const std::string beyond = options.live ? "" : render::beyond_device(*session->device, session->passes);
    if (!beyond.empty())
        return Error{"the passes of camera '" + camera.name + "' need " + beyond +
                         ": a smaller picture (--size) needs less, and --live needs none",
                     session->show->file.string()};
    if (options.stop && options.stop()) return interruption;
    const auto light_count = static_cast<int>(session->lit().lights.size());
    session->relighter =
        options.live ? std::make_unique<render::Relighter>(*session->device, session->live->g_buffer(),
                                                           session->live->distances(), session->gobos.images,
                                                           light_count, settings)
                     : std::make_unique<render::Relighter>(*session->device, session->passes,
                                                           session->gobos.images, light_count, settings);
    for (scene::LightPass& pass : session->passes.lights) {
        pass.radiance = {};
        pass.indirect = {};
    }
    session->set_bounce(bounce);
    return session;
}

} // namespace ghost::app
