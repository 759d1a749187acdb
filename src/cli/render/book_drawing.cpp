// SPDX-License-Identifier: Apache-2.0
#include "cli/render/book_drawing.h"

#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "book/book_values.h"
#include "book/difference.h"
#include "book/rests.h"
#include "cli/render/chosen_cameras.h"
#include "disk/files.h"
#include "dmx/record/player.h"
#include "dmx/record/recording_tasks.h"
#include "image/ldr.h"
#include "live/session/applied_look.h"
#include "live/session/settle.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

using scene::FixtureValues;

Error interruption() {
    return Error{"interrupted: nothing is written", ""};
}

class BookDrawing {
public:
    static Result<std::unique_ptr<BookDrawing>> open(const BookOptions& options);
    Result<DrawnBook> draw(const fs::path& folder, const BookFrame* frame);

private:
    explicit BookDrawing(const BookOptions& options) : options_(options) {}

    Result<void> plan();
    Result<std::vector<scene::Mark>> read_marks();
    Result<void> choose_entries();
    Result<void> leave_out_others();
    void say_what_was_lost(std::vector<std::string>& unknown) const;
    Result<std::vector<double>> find_rests();
    Result<BookFrame> choose_frame(const BookFrame* given);
    Result<float> metered(const scene::Camera& camera);
    std::vector<scene::Camera> cameras_of(const scene::PlannedEntry& planned, const BookFrame& frame) const;
    // The rig anew, so that what one entry shows does not hang on those before it.
    void go_to(const scene::PlannedEntry* planned);
    std::vector<FixtureValues> values() const;
    std::vector<std::vector<float>> mover_values() const;
    Result<void> say_unnamed_change(const std::map<std::string, image::Image8>& before,
                                    const std::string& camera, const image::Image8& picture,
                                    scene::BookEntry& entry) const;
    Progress progress(const std::string& label) const {
        return Progress(label,
                        options_.session.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                        steady_now_s());
    }

    const BookOptions& options_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<AppliedLook> applied_;
    std::optional<dmx::Player> player_;
    std::vector<scene::StoredLook> looks_;
    scene::BookPlan plan_;
    ui::Look look_; // of the entry that the rig does
};

Result<std::unique_ptr<BookDrawing>> BookDrawing::open(const BookOptions& options) {
    auto drawing = std::unique_ptr<BookDrawing>(new BookDrawing(options));
    TRY(drawing->session_, open_session(options.session));
    drawing->session_->show->motion = fixture::Motion::as_commanded;
    drawing->applied_ = std::make_unique<AppliedLook>(*drawing->session_);
    TRY_VOID(drawing->plan());
    return drawing;
}

Result<void> BookDrawing::plan() {
    const scene::Show& show = *session_->show;
    const fs::path file = scene::looks_file(show);
    const std::size_t printed = session_->report.messages.size();
    TRY(looks_, scene::load_looks(file, session_->report));
    for (const scene::StoredLook& look : looks_)
        scene::check_look(look, show, file.string(), session_->report);
    print_report(session_->report, printed);
    if (!show.recording.empty()) {
        TRY(dmx::Recording recording, dmx::open_recording(show.recording, {}, options_.session.quiet));
        player_.emplace(std::move(recording));
    }
    std::vector<double> found_s;
    const bool may_find =
        options_.kind == scene::BookKind::found ||
        (options_.kind == scene::BookKind::by_itself && show.cues.empty() && looks_.empty());
    if (may_find && player_) {
        TRY(found_s, find_rests());
    }
    TRY(const std::vector<scene::Mark> marks, read_marks());
    TRY(plan_, scene::plan_book(show, looks_, options_.kind, found_s, options_.style, marks));
    for (scene::PlannedEntry& planned : plan_.entries) {
        scene::BookEntry& entry = planned.entry;
        if (!player_ || !entry.at_s || *entry.at_s <= player_->duration_s()) continue;
        planned.is_other = true;
        entry.unknown.push_back(options_.style("the recording ends before it: this is its last look"));
    }
    TRY_VOID(choose_entries());
    return options_.is_for_client ? leave_out_others() : Result<void>();
}

Result<void> BookDrawing::leave_out_others() {
    const std::string file = session_->show->file.string();
    for (const scene::PlannedEntry& planned : plan_.entries) {
        if (!planned.is_other) continue;
        std::string why;
        for (const std::string& sentence : planned.entry.unknown) why += (why.empty() ? "" : "; ") + sentence;
        log_warning(file + ": '" + planned.entry.name + "' is left out: " + why);
    }
    std::erase_if(plan_.entries, [](const scene::PlannedEntry& planned) { return planned.is_other; });
    if (plan_.entries.empty()) return Error{"has none of its " + plan_.kind + " to show", file};
    return {};
}

Result<std::vector<scene::Mark>> BookDrawing::read_marks() {
    if (options_.kind != scene::BookKind::marks) return std::vector<scene::Mark>{};
    TRY(const std::string text, read_text_file(options_.marks, scene::kMostMarksBytes));
    const std::size_t printed = session_->report.messages.size();
    auto marks = scene::read_marks(text, options_.marks, options_.mark_fps, session_->report);
    print_report(session_->report, printed);
    const double end_s = player_ ? player_->duration_s() : 0;
    const auto behind =
        std::count_if(marks.begin(), marks.end(), [&](const scene::Mark& mark) { return mark.at_s > end_s; });
    if (player_ && behind > 0)
        log_warning(options_.marks + ": " + std::to_string(behind) +
                    " marks lie behind the end of the recording");
    return marks;
}

Result<void> BookDrawing::choose_entries() {
    if (options_.only.empty()) return {};
    std::vector<scene::PlannedEntry> chosen;
    for (const std::string& name : options_.only) {
        const auto found =
            std::find_if(plan_.entries.begin(), plan_.entries.end(),
                         [&](const scene::PlannedEntry& planned) { return planned.entry.name == name; });
        if (found == plan_.entries.end())
            return Error{"has no entry '" + name + "' among its " + plan_.kind + "; the first one is '" +
                             plan_.entries.front().entry.name + "'",
                         session_->show->file.string()};
        chosen.push_back(*found);
    }
    plan_.entries = std::move(chosen);
    return {};
}

Result<std::vector<double>> BookDrawing::find_rests() {
    Progress progress = this->progress("finding cues");
    scene::RestFinder finder;
    const double end_s = player_->duration_s();
    for (std::optional<double> at_s = 0.0; at_s; at_s = player_->next_after(*at_s)) {
        if (interrupted()) return interruption();
        finder.feed(*at_s, player_->at(*at_s));
        progress.update(*at_s / std::max(end_s, 1e-3), steady_now_s(), clock_text(*at_s));
    }
    progress.finish();
    return finder.finish(end_s);
}

std::vector<scene::Camera> BookDrawing::cameras_of(const scene::PlannedEntry& planned,
                                                   const BookFrame& frame) const {
    if (!options_.views.empty() || options_.is_for_client) return frame.cameras;
    const auto named = std::find_if(frame.cameras.begin(), frame.cameras.end(),
                                    [&](const scene::Camera& one) { return one.name == planned.camera; });
    return {named == frame.cameras.end() ? frame.cameras.front() : *named};
}

void BookDrawing::go_to(const scene::PlannedEntry* planned) {
    session_->rig = std::make_unique<scene::Rig>(*session_->show);
    look_ = {};
    if (planned && planned->look) {
        look_.fixtures = scene::programmer_of(looks_[*planned->look], *session_->show);
        look_.movers = scene::movers_of(looks_[*planned->look], *session_->show);
        look_.scene = looks_[*planned->look].scene;
    }
    session_->rig->movers().drive(look_.movers);
    session_->rig->set_time(planned ? planned->entry.at_s : std::nullopt);
    const bool is_sent = planned && player_ && planned->entry.at_s;
    settle(*session_->rig, is_sent ? player_->at(*planned->entry.at_s) : dmx::Universes{}, look_.fixtures);
    applied_->apply(look_, *session_);
    session_->media_s = planned ? planned->entry.at_s : std::nullopt;
    session_->media_waits = true;
}

std::vector<FixtureValues> BookDrawing::values() const {
    std::vector<FixtureValues> all(session_->show->fixtures.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto by_hand = look_.fixtures.find(i);
        if (const auto& type = session_->show->fixtures[i].type)
            all[i] = scene::values_of(*type, session_->rig->states()[i],
                                      by_hand == look_.fixtures.end() ? nullptr : &by_hand->second,
                                      options_.style);
    }
    return all;
}

std::vector<std::vector<float>> BookDrawing::mover_values() const {
    std::vector<std::vector<float>> all(session_->show->movers.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = session_->rig->movers().values(i);
    return all;
}

// Films, and whatever else has no words: nobody is told that nothing is seen where the picture is another.
Result<void> BookDrawing::say_unnamed_change(const std::map<std::string, image::Image8>& before,
                                             const std::string& camera, const image::Image8& picture,
                                             scene::BookEntry& entry) const {
    const auto known = before.find(camera);
    if (!entry.changes.empty() || known == before.end()) return {};
    image::Image8 map;
    TRY(const scene::PictureDifference difference, scene::compare_pictures(known->second, picture, map));
    if (difference.seen >= scene::PictureDifference::Seen::seen)
        entry.changes.push_back({{}, options_.style("the picture changes by what is not named here")});
    return {};
}

// Of the entry with the most light, from its first camera: nothing of the book is too bright.
Result<float> BookDrawing::metered(const scene::Camera& camera) {
    const scene::PlannedEntry* brightest = &plan_.entries.front();
    double most_lm = -1;
    for (const scene::PlannedEntry& planned : plan_.entries) {
        if (interrupted()) return interruption();
        go_to(&planned);
        double lumens = 0;
        const std::vector<FixtureValues> now = values();
        for (std::size_t i = 0; i < now.size(); ++i)
            if (const scene::PatchedFixture& fixture = session_->show->fixtures[i]; fixture.type)
                lumens += static_cast<double>(now[i].light_percent *
                                              scene::full_lm(*fixture.type, fixture.patch().mode_of()));
        if (lumens > most_lm) brightest = &planned;
        most_lm = std::max(most_lm, lumens);
    }
    go_to(brightest);
    session_->look_from(camera);
    session_->draw();
    if (interrupted()) return interruption();
    return session_->relighter->ev100_used();
}

Result<BookFrame> BookDrawing::choose_frame(const BookFrame* given) {
    if (given) return *given;
    BookFrame frame;
    TRY(frame.cameras, chosen_cameras(*session_->show, options_.views, options_.width, options_.height));
    const scene::Camera first = cameras_of(plan_.entries.front(), frame).front();
    frame.ev100 = options_.session.ev100.value_or(first.ev100);
    if (!options_.session.ev100 && first.auto_exposure) {
        TRY(frame.ev100, metered(first));
    }
    return frame;
}

// Cues, marks, looks and fixtures that could not be read: the book has not all that its files say.
void BookDrawing::say_what_was_lost(std::vector<std::string>& unknown) const {
    constexpr std::size_t kMostSaid = 20;
    const std::string folder = session_->show->file.parent_path().string() + "/";
    std::size_t lost = 0;
    const std::string looks = scene::looks_file(*session_->show).string();
    for (const Message& message : session_->report.messages) {
        // A look's warnings name lamps that it leaves as they are.
        const bool is_of_look = message.severity == Severity::warning && message.where.starts_with(looks);
        if ((message.severity != Severity::error && !is_of_look) || ++lost > kMostSaid) continue;
        const std::string where =
            message.where.starts_with(folder) ? message.where.substr(folder.size()) : message.where;
        const std::string said = where + ": " + message.what;
        unknown.push_back(is_of_look ? said : options_.style("could not be read: %1", {said}));
    }
    if (lost > kMostSaid)
        unknown.push_back(options_.style("%1 more could not be read, which the terminal names",
                                         {std::to_string(lost - kMostSaid)}));
}

Result<DrawnBook> BookDrawing::draw(const fs::path& folder, const BookFrame* given) {
    DrawnBook drawn;
    scene::Book& book = drawn.book;
    TRY(drawn.frame, choose_frame(given));
    session_->options.ev100 = drawn.frame.ev100;
    book = scene::book_of(*session_->show, options_.style, options_.is_for_client);
    book.kind = plan_.kind;
    book.width = options_.width;
    book.height = options_.height;
    book.ev100 = drawn.frame.ev100;
    book.device = session_->device->name();
    book.unknown.insert(book.unknown.end(), plan_.unknown.begin(), plan_.unknown.end());
    if (!options_.is_for_client) say_what_was_lost(book.unknown);

    Progress progress = this->progress("cue book");
    scene::BookValues all_values;
    go_to(nullptr);
    std::vector<FixtureValues> before = values();
    std::vector<std::vector<float>> movers_before = mover_values();
    ui::SceneLook scene_before;
    std::map<std::string, image::Image8> pictures_before; // by camera
    for (std::size_t i = 0; i < plan_.entries.size(); ++i) {
        const scene::PlannedEntry& planned = plan_.entries[i];
        scene::BookEntry& entry = book.entries.emplace_back(planned.entry);
        go_to(&planned);
        std::vector<FixtureValues> now = values();
        all_values.add(entry, *session_->show, now);
        entry.changes = scene::changes_of(*session_->show, before, now, options_.style);
        const auto of_air = scene::changes_of(*session_->show, scene_before, look_.scene, options_.style);
        entry.changes.insert(entry.changes.end(), of_air.begin(), of_air.end());
        std::vector<std::vector<float>> movers_now = mover_values();
        const auto of_movers = scene::changes_of(*session_->show, movers_before, movers_now, options_.style);
        entry.changes.insert(entry.changes.end(), of_movers.begin(), of_movers.end());
        before = std::move(now);
        movers_before = std::move(movers_now);
        scene_before = look_.scene;
        const std::vector<scene::Camera> cameras = cameras_of(planned, drawn.frame);
        for (std::size_t k = 0; k < cameras.size(); ++k) {
            if (interrupted()) return interruption();
            session_->look_from(cameras[k]);
            session_->draw();
            if (interrupted()) return interruption();
            char name[64];
            std::snprintf(name, sizeof name, "pictures/%04zu-%zu.png", i + 1, k + 1);
            image::Image8 picture = session_->relighter->picture();
            TRY_VOID(image::write_png(folder / name, picture));
            TRY_VOID(say_unnamed_change(pictures_before, cameras[k].name, picture, entry));
            pictures_before.insert_or_assign(cameras[k].name, std::move(picture));
            entry.pictures.push_back({cameras[k].name, name});
            progress.update(
                (static_cast<double>(i) + static_cast<double>(k + 1) / static_cast<double>(cameras.size())) /
                    static_cast<double>(plan_.entries.size()),
                steady_now_s(), entry.name);
        }
    }
    progress.finish();
    drawn.values_csv = all_values.csv();
    if (all_values.left_out() > 0)
        book.unknown.push_back(options_.style("values.csv is full: it has not the lamps of %1 entries",
                                              {std::to_string(all_values.left_out())}));
    if (player_ && dmx::log_damage(*player_))
        book.unknown.push_back(
            options_.style("the recording is damaged: where it is, the look before is drawn"));
    return drawn;
}

} // namespace

Result<DrawnBook> draw_book(const BookOptions& options, const fs::path& folder, const BookFrame* frame) {
    catch_interrupts();
    BookOptions asked = options;
    asked.session.live = asked.session.repeatable = true;
    asked.session.width = options.width;
    asked.session.height = options.height;
    TRY(const std::unique_ptr<BookDrawing> drawing, BookDrawing::open(asked));
    return drawing->draw(folder, frame);
}

} // namespace ghost::app
