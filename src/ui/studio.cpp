// SPDX-License-Identifier: Apache-2.0
#include "ui/studio.h"

#include "scene/camera_moves.h"

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr int kTravelStep_ms = 16;
constexpr int kMergeWithin_ms = 1500; // changes of a slider

} // namespace

// From one look to another.
class LookStep : public QUndoCommand {
public:
    LookStep(Studio& studio, Look before, Look after, const QString& text, int kind)
        : QUndoCommand(text), studio_(studio), before_(std::move(before)), after_(std::move(after)),
          kind_(kind) {
        age_.start();
    }
    void undo() override { studio_.put_look(before_); }
    void redo() override { studio_.put_look(after_); }
    int id() const override { return kind_ == 0 ? -1 : kind_; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* later = static_cast<const LookStep*>(next);
        if (age_.elapsed() > kMergeWithin_ms) return false;
        after_ = later->after_;
        age_.restart();
        return true;
    }

private:
    Studio& studio_;
    Look before_, after_;
    int kind_;
    QElapsedTimer age_;
};

Studio::Studio(Link& link) : link_(link) {
    link_.on_news = [this] {
        // One call waits at a time, however fast the engine is.
        if (!news_posted_.exchange(true))
            QMetaObject::invokeMethod(
                this, [this] { read_news(); }, Qt::QueuedConnection);
    };
    wishes_.camera.width = 0; // nothing is drawn before a show is open
    undo_.setUndoLimit(500);
    travel_timer_.setInterval(kTravelStep_ms);
    connect(&travel_timer_, &QTimer::timeout, this, &Studio::step_travel);
}

void Studio::read_news() {
    news_posted_ = false;
    // Before the picture: one that was put first has come when this has.
    if (auto news = link_.settled.take()) settled_ = *news;
    if (auto news = link_.activity.take()) {
        activity_ = std::move(*news);
        Q_EMIT activity_came();
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
    if (auto news = link_.camera_call.take()) {
        if (news->flight_s > 0) {
            travel_to(news->camera, static_cast<int>(1000 * news->flight_s));
        } else {
            news->camera.width = wishes_.camera.width;
            news->camera.height = wishes_.camera.height;
            set_camera(news->camera);
        }
    }
    if (auto news = link_.rig.take()) {
        rig_ = std::move(*news);
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
    if (auto news = link_.explained.take()) {
        explained_ = std::move(*news);
        Q_EMIT explanation_came();
    }
}

void Studio::take_opened(Opened opened) {
    // An edit later than this one is shown already.
    if (opened.is_edit && opened.text != wishes_.text) return;
    opened_ = std::move(opened);
    if (opened_.is_edit) {
        show_edit();
        return;
    }
    patch_ = opened_.show ? scene::PatchMap(*opened_.show) : scene::PatchMap();
    latency_ = {};
    travel_timer_.stop();
    undo_.clear();
    selection_.clear();
    rig_ = {};
    explained_ = {};
    wishes_.look = {};
    wishes_.explained.reset();
    if (!opened_.again) {
        wishes_.transport = {};
        wishes_.black_out = wishes_.frozen = false;
    }
    Q_EMIT opened_show(); // the view says how large it is, and from where it looks
    Q_EMIT selection_changed();
    Q_EMIT look_changed();
}

void Studio::open(const std::string& show) {
    wish([&](Wishes& wishes) {
        if (wishes.show != show) wishes.text.reset();
        wishes.show = show;
    });
}

void Studio::set_camera(const scene::Camera& camera) {
    travel_timer_.stop();
    wish([&](Wishes& wishes) { wishes.camera = camera; });
}

void Studio::set_size(int width, int height) {
    travel_to_.width = width;
    travel_to_.height = height;
    wish([&](Wishes& wishes) {
        wishes.camera.width = width;
        wishes.camera.height = height;
    });
}

void Studio::travel_to(const scene::Camera& camera, int travel_ms) {
    travel_ms_ = std::max(travel_ms, 1);
    travel_from_ = wishes_.camera;
    travel_to_ = camera;
    travel_to_.width = travel_from_.width;
    travel_to_.height = travel_from_.height;
    travel_clock_.start();
    travel_timer_.start();
}

void Studio::step_travel() {
    const float share =
        std::min(static_cast<float>(travel_clock_.elapsed()) / static_cast<float>(travel_ms_), 1.0f);
    scene::Camera camera = share < 1 ? scene::camera_between(travel_from_, travel_to_, share) : travel_to_;
    camera.width = wishes_.camera.width;
    camera.height = wishes_.camera.height;
    if (share >= 1) travel_timer_.stop();
    wish([&](Wishes& wishes) { wishes.camera = camera; });
}

void Studio::set_look(Look look, const QString& text, int kind) {
    std::erase_if(look.fixtures, [](const auto& entry) { return entry.second.is_empty(); });
    std::erase_if(look.surfaces, [](const auto& entry) { return entry.second.is_empty(); });
    if (look == wishes_.look) return;
    undo_.push(new LookStep(*this, wishes_.look, std::move(look), text, kind));
}

void Studio::put_look(const Look& look) {
    wish([&](Wishes& wishes) { wishes.look = look; });
    Q_EMIT look_changed();
}

void Studio::put_edit(std::shared_ptr<const std::string> text, scene::Show preview, const Look& look,
                      std::set<std::size_t> selection) {
    opened_.show = std::make_shared<const scene::Show>(std::move(preview));
    opened_.is_edit = true;
    selection_ = std::move(selection);
    wish([&](Wishes& wishes) {
        wishes.text = std::move(text);
        wishes.look = look;
    });
    show_edit();
}

void Studio::show_edit() {
    patch_ = scene::PatchMap(*show());
    std::erase_if(selection_, [&](std::size_t index) { return index >= show()->fixtures.size(); });
    wish([&](Wishes& wishes) { wishes.explained = current(); });
    Q_EMIT opened_show();
    Q_EMIT selection_changed();
    Q_EMIT look_changed();
}

void Studio::select(std::set<std::size_t> fixtures) {
    const std::size_t count = show() ? show()->fixtures.size() : 0;
    std::erase_if(fixtures, [&](std::size_t index) { return index >= count; });
    if (fixtures == selection_) return;
    selection_ = std::move(fixtures);
    wish([&](Wishes& wishes) { wishes.explained = current(); });
    Q_EMIT selection_changed();
}

std::optional<std::size_t> Studio::current() const {
    return selection_.empty() ? std::nullopt : std::optional(*selection_.begin());
}

void Studio::send() {
    ++wishes_.number;
    link_.wishes.put(wishes_);
    Q_EMIT wishes_changed();
}

} // namespace ghost::ui
