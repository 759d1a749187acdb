// SPDX-License-Identifier: Apache-2.0
#include "ui/model/app_model.h"

#include "base/text.h"
#include "beam_groups/light_places.h"
#include "link/carried.h"
#include "show/camera_moves.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/look_fade.h"
#include "ui/model/private/undo_ids.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

namespace ghost::ui {
namespace {

// Until the engine says what shines.
RigNow rig_at_home(const scene::Show& show) {
    RigNow rig;
    for (const scene::PatchedFixture& fixture : show.fixtures)
        rig.fixtures.push_back({.light_m = scene::light_position_m(fixture, 0)});
    return rig;
}

// What is said of the fixtures of the show that is drawn, for those of one that is shown already.
RigNow rig_of(const scene::Show& show, const scene::Show& drawn, RigNow rig) {
    rig.fixtures = carried(rig.fixtures, rig_at_home(show).fixtures, drawn, show);
    return rig;
}

// Likewise; nothing is wrong with one that is not drawn yet.
std::vector<Verdict> verdicts_of(const scene::Show& show, const scene::Show& drawn,
                                 const std::vector<Verdict>& verdicts) {
    return carried(verdicts, std::vector<Verdict>(show.fixtures.size()), drawn, show);
}

// Whether a fade goes on: what it mixes by index is the same.
bool is_same_rig(const scene::Show& a, const scene::Show& b) {
    return std::equal(a.fixtures.begin(), a.fixtures.end(), b.fixtures.begin(), b.fixtures.end(),
                      [](const scene::PatchedFixture& x, const scene::PatchedFixture& y) {
                          return scene::is_same_fixture(x, y) && x.name == y.name && x.type == y.type &&
                                 x.mode == y.mode;
                      }) &&
           std::equal(a.movers.begin(), a.movers.end(), b.movers.begin(), b.movers.end(),
                      [](const scene::Mover& x, const scene::Mover& y) {
                          return x.name == y.name && x.axes.size() == y.axes.size();
                      });
}

void leave_out_empty(Look& look) {
    std::erase_if(look.fixtures, [](const auto& entry) { return entry.second.is_empty(); });
    std::erase_if(look.surfaces, [](const auto& entry) { return entry.second.is_empty(); });
}

} // namespace

// From one look to another.
class LookStep : public QUndoCommand {
public:
    LookStep(AppModel& app, Look before, Look after, const QString& text, int kind)
        : QUndoCommand(text), app_(app), before_(std::move(before)), after_(std::move(after)), kind_(kind),
          choices_(app.choices_) {
        age_.start();
    }
    void undo() override { app_.put_look(before_); }
    void redo() override { app_.put_look(after_); }
    int id() const override { return kind_ == 0 ? -1 : kind_; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* later = static_cast<const LookStep*>(next);
        if (age_.elapsed() > kMergeWithin_ms) return false;
        // The same slider of something else, and another one of that kind, are steps of their own.
        if (choices_ != later->choices_ || text() != later->text()) return false;
        after_ = later->after_;
        age_.restart();
        return true;
    }

private:
    AppModel& app_;
    Look before_, after_;
    int kind_;
    std::uint64_t choices_;
    QElapsedTimer age_;
};

AppModel::AppModel(Link& link)
    : link_(link), jobs_(QCoreApplication::applicationFilePath()),
      flight_([this](const FramedCamera& now) { put_camera(now.camera, now.frame); }),
      fader_([this] { show_look(); }) {
    link_.on_news = [this] {
        // One call waits at a time, however fast the engine is.
        if (!news_posted_.exchange(true))
            QMetaObject::invokeMethod(
                this, [this] { read_news(); }, Qt::QueuedConnection);
    };
    request_.camera.width = 0; // nothing is drawn before a show is open
    undo_.setUndoLimit(500);
}

void AppModel::read_news() {
    news_posted_ = false;
    const auto begin = std::chrono::steady_clock::now();
    // Before the picture: one that was put first has come when this has.
    if (auto news = link_.settled.take()) settled_ = *news;
    if (auto news = link_.activity.take()) {
        activity_ = std::move(*news);
        Q_EMIT activity_came();
    }
    if (auto news = link_.not_opened.take()) {
        answered_opens_ = std::max(answered_opens_, news->opens);
        const bool is_awaited = !is_opening(); // else another one was asked for meanwhile
        if (is_awaited) open_error_ = news->error;
        Q_EMIT failed(QString::fromStdString(news->error.text()));
        if (is_awaited) Q_EMIT not_opened();
    }
    if (auto news = link_.failed.take()) Q_EMIT failed(QString::fromStdString(news->text()));
    if (auto news = link_.opened.take()) take_opened(std::move(*news));
    if (auto news = link_.messages.take()) {
        messages_ = std::move(*news);
        Q_EMIT messages_came();
    }
    if (auto news = link_.plot.take()) {
        plot_ = std::move(*news);
        Q_EMIT plot_came();
    }
    if (auto news = link_.activity_of_recording.take()) {
        waveform_ = std::move(*news);
        Q_EMIT waveform_came();
    }
    if (auto news = link_.bounce.take()) {
        bounce_ = *news;
        Q_EMIT bounce_came();
    }
    if (auto news = link_.unseen_stage.take()) {
        unseen_stage_ = std::move(*news);
        Q_EMIT unseen_stage_came();
    }
    if (auto news = link_.rdm.take()) {
        rdm_ = std::move(*news);
        Q_EMIT rdm_came();
    }
    for (const RdmEdit& asked : link_.rdm_edits.take()) Q_EMIT rdm_edit_asked(asked);
    if (auto news = link_.probed.take(); news && request_.probe) {
        probed_ = std::move(*news);
        Q_EMIT probe_came();
    }
    if (auto news = link_.picked.take(); news && news->number == request_.pick.number) {
        picked_ = std::move(*news);
        if (picked_.fixture && drawn_ && show()) // which may be that before an edit
            picked_.fixture = carried(picked_.fixture, *drawn_, *show());
        Q_EMIT picked_came();
    }
    if (auto news = link_.recorded.take()) {
        recorded_ = std::move(*news);
        if (request_.record_to == recorded_.file)
            change_request([](ViewRequest& request) { request.record_to.clear(); });
        Q_EMIT recording_ended();
    }
    if (auto news = link_.saved.take()) {
        saved_ = news->number;
        Q_EMIT picture_saved(news->error ? QString::fromStdString(news->error->text()) : QString());
    }
    if (auto news = link_.camera_call.take()) {
        if (news->flight_s > 0)
            travel_to_stored(news->camera, static_cast<int>(1000 * news->flight_s));
        else
            cut_to(news->camera);
    }
    if (const auto news = link_.look_call.take())
        Q_EMIT look_called(QString::fromStdString(news->name), news->seconds);
    if (const auto news = link_.cue_call.take()) Q_EMIT cue_called(QString::fromStdString(*news));
    if (auto news = link_.camera_pictures.take()) {
        camera_pictures_ = std::move(*news);
        Q_EMIT camera_pictures_came();
    }
    if (auto news = link_.rig.take()) {
        rig_ = drawn_ && show() && drawn_ != show() ? rig_of(*show(), *drawn_, std::move(*news))
                                                    : std::move(*news);
        Q_EMIT rig_came();
    }
    if (auto news = link_.picture.take()) {
        picture_ = std::move(*news);
        Q_EMIT picture_came();
    }
    if (auto news = link_.network.take()) {
        network_ = std::move(*news);
        Q_EMIT network_came();
    }
    if (auto news = link_.verdicts.take(); news && request_.explains_all && drawn_ && show()) {
        verdicts_ = drawn_ == show() ? std::move(*news) : verdicts_of(*show(), *drawn_, *news);
        Q_EMIT verdicts_came();
    }
    if (auto news = shown_place_of(link_.explained.take())) {
        explained_ = std::move(*news);
        Q_EMIT explanation_came();
    }
    if (auto news = shown_place_of(link_.hovered.take()); news && request_.hovered == news->fixture) {
        hovered_ = std::move(*news);
        Q_EMIT hovered_came();
    }
    news_cost_ += std::chrono::steady_clock::now() - begin;
    Q_EMIT news_came();
}

// What is said of a fixture that is drawn, for the place that it has in the show that is shown already.
// Nothing: it has none there, or the show was another one when it was said.
std::optional<Explained> AppModel::shown_place_of(std::optional<Explained> news) const {
    if (!news || !drawn_ || !show() || news->fixture >= drawn_->fixtures.size() ||
        drawn_->fixtures[news->fixture].name != news->explanation.fixture)
        return std::nullopt;
    const auto place = carried(std::optional(news->fixture), *drawn_, *show());
    if (!place) return std::nullopt;
    news->fixture = *place;
    return news;
}

// Of fixtures, by their new numbers.
void AppModel::count_news_anew(const scene::Show& before, const scene::Show& now) {
    rig_ = rig_of(now, before, std::move(rig_));
    if (!verdicts_.empty()) verdicts_ = verdicts_of(now, before, verdicts_);
    const auto place = carried(std::optional(explained_.fixture), before, now);
    if (!place) explained_ = {};
    explained_.fixture = place.value_or(0);
}

void AppModel::publish_looks(LooksNow looks) {
    link_.looks.put(std::move(looks));
    link_.on_news();
}

void AppModel::publish_cue(const std::string& name) {
    link_.cue.put(name);
    link_.on_news();
}

double AppModel::moment_s() const {
    const double asked_s = request_.transport.at_s;
    if (has_jumped() || !std::isfinite(asked_s)) return rig_.at_s;
    const double from_s = std::max(asked_s, 0.0); // as the engine goes there
    return rig_.recording_s > 0 ? std::fmod(from_s, rig_.recording_s) : from_s;
}

std::uint64_t AppModel::pick(const glm::vec3& from_m, const glm::vec3& way, float beside) {
    const std::uint64_t number = request_.pick.number + 1;
    change_request([&](ViewRequest& request) { request.pick = {number, from_m, way, beside}; });
    return number;
}

void AppModel::take_opened(Opened opened) {
    drawn_ = opened.show;
    // An edit later than this one is shown already.
    if (opened.is_edit && opened.text != request_.text) return;
    const Opened before = std::exchange(opened_, std::move(opened));
    const bool are_files_others = std::exchange(are_files_others_, false);
    request_.counted = opened_.show;
    if (opened_.is_edit) {
        go_on_from(before, are_files_others);
        show_edit();
        return;
    }
    // Something else than the request names, which may be asked for again.
    is_elsewhere_ = opened_.again && before.show && opened_.show && before.show->file != opened_.show->file;
    answered_opens_ = std::max(answered_opens_, opened_.opens);
    patch_ = opened_.show ? scene::PatchMap(*opened_.show) : scene::PatchMap();
    latency_ = window_cost_ = {};
    waveform_.clear();
    flight_.stop();
    const bool is_copy =
        std::exchange(copy_, 0) == opened_.opens && opened_.opens > 0 && before.show && opened_.show;
    if (!is_copy) undo_.clear();
    const bool was_made = std::exchange(made_of_plot_, 0) == opened_.opens && opened_.opens > 0;
    const bool keeps_hands = before.show && opened_.show && (was_made || opened_.again);
    if (is_copy) opened_.again = true;
    std::set<std::size_t> selection;
    if (keeps_hands) selection = carried(selection_, *before.show, *opened_.show);
    if (!is_copy) put_selection({});
    put_selection(is_copy ? selection_ : std::move(selection));
    rig_ = opened_.show ? rig_at_home(*opened_.show) : RigNow{};
    explained_ = {};
    hovered_.reset();
    verdicts_.clear();
    camera_pictures_.clear();
    fader_.forget();
    const std::vector<std::string> lost =
        keeps_hands ? lost_of(look_, *before.show, *opened_.show) : std::vector<std::string>{};
    look_ = request_.look = is_copy ? look_ : keeps_hands ? carried(look_, before, opened_) : Look{};
    request_.explained.reset();
    request_.stops_bounce = false;
    request_.hovered.reset();
    if (!opened_.again) {
        request_.transport = {};
        request_.recording.clear();
        request_.input = Input::automatic; // what was chosen for a show before says nothing of this one
        request_.black_out = request_.frozen = false;
        request_.master = 1;
        request_.work_light = WorkLight::automatic;
        request_.motion.reset();
    }
    Q_EMIT opened_show(); // the view says how large it is, and from where it looks
    if (keeps_hands || is_copy) {
        show_look();
        change_request([&](ViewRequest& request) { request.explained = current(); });
    }
    Q_EMIT selection_changed();
    Q_EMIT look_changed();
    tell_lost(lost);
}

// An edit of this window is shown by the fixtures that it has. What other files say is known when they are
// read: then hands, selection and mark stay with what they were on, and steps of before mean nothing any
// more.
void AppModel::go_on_from(const Opened& before, bool are_files_others) {
    if (!before.show || !opened_.show) return;
    if (marked_) marked_ = place_of(*marked_, before.objects, opened_.objects, kIsCalledSo);
    const bool has_other_heads =
        counts_otherwise(before.show->fixtures, opened_.show->fixtures, scene::is_same_fixture) ||
        counts_otherwise(before.show->movers, opened_.show->movers, kIsCalledSo);
    const bool has_another_stage =
        are_files_others && (counts_otherwise(before.objects, opened_.objects, kIsCalledSo) ||
                             counts_otherwise(before.materials, opened_.materials, kIsCalledSo));
    if (!has_other_heads && !has_another_stage) return;
    count_news_anew(*before.show, *opened_.show);
    put_selection(carried(selection_, *before.show, *opened_.show));
    tell_lost(lost_of(look_, *before.show, *opened_.show));
    look_ = has_another_stage ? carried(look_, before, opened_) : carried(look_, *before.show, *opened_.show);
    fader_.forget();
    undo_.clear();
    show_look();
}

void AppModel::tell_lost(const std::vector<std::string>& names) {
    if (!names.empty())
        Q_EMIT failed(translated("Notice", "Not in the show any more, with what hands held of it: %1")
                          .arg(QString::fromStdString(name_list(names))));
}

void AppModel::read_again(std::shared_ptr<const std::string> text) {
    are_files_others_ = true;
    change_request([&](ViewRequest& request) { request.text = std::move(text); });
}

void AppModel::open(const std::string& show) {
    // "tour.mvr" of the working directory gets a folder, in which what lies beside it is found.
    std::error_code code;
    const bool is_bare =
        !std::filesystem::path(show).has_parent_path() && std::filesystem::is_regular_file(show, code);
    const std::string named = is_bare ? "./" + show : show;
    if (named == request_.show && !open_error_ && !is_elsewhere_) return;
    open_error_.reset();
    is_elsewhere_ = false;
    change_request([&](ViewRequest& request) {
        request.text.reset();
        request.show = named;
        ++request.opens;
    });
}

void AppModel::open_made_of_plot(const std::string& show) {
    open(show);
    made_of_plot_ = request_.opens;
}

void AppModel::open_copy(const std::string& show) {
    const double now_s = moment_s();
    const std::uint64_t before = request_.opens;
    open(show);
    if (request_.opens == before) return;
    copy_ = request_.opens;
    change_request([&](ViewRequest& request) {
        ++request.transport.seeks;
        request.transport.at_s = now_s;
    });
}

void AppModel::set_camera(const scene::Camera& camera) {
    flight_.stop();
    change_request([&](ViewRequest& request) { request.camera = camera; });
}

std::optional<std::size_t> AppModel::stored_camera() const {
    if (!show()) return std::nullopt;
    const std::vector<scene::Camera>& cameras = show()->cameras;
    const auto found = std::find_if(cameras.begin(), cameras.end(), [&](const scene::Camera& one) {
        return one.position_m == request_.camera.position_m && one.target_m == request_.camera.target_m;
    });
    return found == cameras.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(found - cameras.begin()));
}

scene::Camera AppModel::seen_camera() const {
    scene::Camera camera = request_.camera;
    if (request_.frame != glm::ivec2(0)) {
        camera.width = request_.frame.x;
        camera.height = request_.frame.y;
    }
    if (camera.mover != scene::kNoMover && picture_.image) {
        camera.position_m = picture_.camera.position_m;
        camera.target_m = picture_.camera.target_m;
        camera.mover = scene::kNoMover;
    }
    return camera;
}

scene::Camera AppModel::camera_to_move() const {
    scene::Camera camera = seen_camera();
    camera.width = request_.camera.width;
    camera.height = request_.camera.height;
    return camera;
}

void AppModel::cut_to(const scene::Camera& stored) {
    flight_.stop();
    put_camera(stored, {stored.width, stored.height});
}

// The size stays.
void AppModel::put_camera(const scene::Camera& camera, const glm::ivec2& frame) {
    change_request([&](ViewRequest& request) {
        request.frame = frame;
        const int width = request.camera.width, height = request.camera.height;
        request.camera = camera;
        request.camera.width = width;
        request.camera.height = height;
    });
}

void AppModel::set_size(int width, int height) {
    view_size_ = {width, height};
    send_size();
}

void AppModel::set_second_size(const QSize& size) {
    second_size_ = size;
    if (!view_size_.isEmpty()) send_size();
}

void AppModel::send_size() {
    const auto pixels = [](const QSize& size) { return qint64{size.width()} * size.height(); };
    const QSize size =
        !second_size_.isEmpty() && pixels(second_size_) > pixels(view_size_) ? second_size_ : view_size_;
    change_request([&](ViewRequest& request) {
        request.camera.width = size.width();
        request.camera.height = size.height();
    });
}

void AppModel::count_window(std::chrono::nanoseconds cost) {
    window_cost_.add(cost + std::exchange(news_cost_, std::chrono::nanoseconds{0}));
}

void AppModel::reset_figures() {
    latency_ = {};
    window_cost_ = {};
}

void AppModel::travel_to(const scene::Camera& camera, int travel_ms) {
    flight_.begin({camera_to_move(), request_.frame}, {camera, request_.frame}, travel_ms);
}

void AppModel::travel_to_stored(const scene::Camera& stored, int travel_ms) {
    const glm::ivec2 frame(stored.width, stored.height);
    const bool has_frame = request_.frame != glm::ivec2(0);
    flight_.begin({camera_to_move(), has_frame ? request_.frame : frame}, {stored, frame}, travel_ms);
}

void AppModel::look_at(const glm::vec3& centre_m, float radius_m) {
    travel_to(scene::focused(seen_camera(), centre_m, radius_m));
}

void AppModel::set_exposure(float ev100, bool automatic) {
    flight_.set_exposure(ev100, automatic);
    change_request([&](ViewRequest& request) {
        request.camera.ev100 = ev100;
        request.camera.auto_exposure = automatic;
    });
}

void AppModel::set_look(Look look, const QString& text, int kind) {
    leave_out_empty(look);
    if (look == look_) return;
    undo_.push(new LookStep(*this, look_, std::move(look), text, kind));
}

void AppModel::fade_to(Look look, const QString& text, double seconds) {
    leave_out_empty(look);
    if (look == look_) {
        if (!fades()) return;
        fader_.hurry(seconds);
        show_look();
        return;
    }
    fader_.set_next(seconds);
    set_look(std::move(look), text);
    fader_.set_next(0);
}

void AppModel::put_look(const Look& look) {
    fader_.change(look_, look);
    look_ = look;
    show_look();
    Q_EMIT look_changed();
}

// The look as it is meant, or on its way there, with what solo leaves.
void AppModel::show_look() {
    Look shown = fader_.on_the_way(look_, show().get(), rig_);
    if (show()) leave_solo(shown, show()->fixtures.size());
    change_request([&](ViewRequest& request) { request.look = std::move(shown); });
}

void AppModel::put_edit(std::shared_ptr<const std::string> text, scene::Show preview, const Look& look,
                        std::set<std::size_t> selection) {
    const bool is_same = show() && is_same_rig(*show(), preview);
    if (show()) count_news_anew(*show(), preview);
    opened_.show = std::make_shared<const scene::Show>(std::move(preview));
    opened_.is_edit = true;
    put_selection(std::move(selection));
    if (is_same)
        fader_.change(look_, look);
    else
        fader_.forget(); // it counts fixtures as they were
    // At once with the look, which counts them as this text does.
    request_.text = std::move(text);
    request_.counted = show();
    look_ = look;
    show_look();
    show_edit();
}

void AppModel::show_edit() {
    patch_ = scene::PatchMap(*show());
    put_selection(selection_);
    change_request([&](ViewRequest& request) { request.explained = current(); });
    Q_EMIT opened_show();
    Q_EMIT selection_changed();
    Q_EMIT look_changed();
}

void AppModel::select(std::set<std::size_t> fixtures) {
    const std::set<std::size_t> before = selection_;
    put_selection(std::move(fixtures));
    if (selection_ == before) return;
    change_request([&](ViewRequest& request) { request.explained = current(); });
    Q_EMIT selection_changed();
}

void AppModel::select_in_order(std::vector<std::size_t> fixtures) {
    selected_in_order_ = std::move(fixtures);
    select({selected_in_order_.begin(), selected_in_order_.end()});
}

// Those that the show has.
void AppModel::put_selection(std::set<std::size_t> fixtures) {
    const std::size_t count = show() ? show()->fixtures.size() : 0;
    std::erase_if(fixtures, [&](std::size_t index) { return index >= count; });
    if (fixtures != selection_) ++choices_;
    selection_ = std::move(fixtures);
    std::erase_if(selected_in_order_, [&](std::size_t one) { return !selection_.contains(one); });
    const std::set<std::size_t> known(selected_in_order_.begin(), selected_in_order_.end());
    std::set_difference(selection_.begin(), selection_.end(), known.begin(), known.end(),
                        std::back_inserter(selected_in_order_));
}

void AppModel::hover(std::optional<std::size_t> fixture) {
    if (fixture == request_.hovered) return;
    hovered_.reset();
    change_request([&](ViewRequest& request) { request.hovered = fixture; });
}

void AppModel::mark(std::optional<std::size_t> object) {
    if (object == marked_) return;
    marked_ = object;
    ++choices_;
    Q_EMIT marked_changed();
}

std::optional<std::size_t> AppModel::marked() const {
    return marked_ && *marked_ < opened_.objects.size() ? marked_ : std::nullopt;
}

std::optional<std::size_t> AppModel::current() const {
    return selected_in_order_.empty() ? std::nullopt : std::optional(selected_in_order_.front());
}

void AppModel::send() {
    ++request_.number;
    link_.request.put(request_);
    link_.wake.raise();
    Q_EMIT request_changed();
}

} // namespace ghost::ui
