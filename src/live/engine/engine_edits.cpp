// SPDX-License-Identifier: Apache-2.0
// Edits of the show that is drawn: names, addresses and the air with the next frame, anything else by opening
// the show anew beside the one that is drawn until then.
#include "live/engine/engine.h"

#include "disk/files.h"
#include "link/carried.h"
#include "live/session/applied_look.h"
#include "live/session/take_patch.h"
#include "show_file/show_edit.h"

namespace ghost::app {
namespace {

bool differs_in_quick_things_only(const Session& session, const std::shared_ptr<const std::string>& before,
                                  const std::string& now) {
    const Result<std::string> text =
        before ? Result<std::string>(*before) : read_text_file(session.show->file, scene::kMaxShowBytes);
    // The same text is taken because the files that it names are others.
    return text.ok() && *text != now && scene::differ_in_fixtures_air_and_cues_only(*text, now);
}

} // namespace

void Engine::take_edit() {
    if (opening_.is_running()) return; // later
    forget_baked();
    const std::string& path = session_->options.show;
    const bool is_quick = differs_in_quick_things_only(*session_, text_, *request_.text);
    text_ = request_.text;
    if (is_quick) {
        Report report;
        const auto edited = open_show(path, false, true, report, text_);
        if (edited.ok() && take_patch(*session_, *edited, report)) {
            drawn_text_ = text_;
            listen_to_patch();
            rdm_.know_anew();
            take_air(*edited);
            controls_.know(*session_); // other cues
            shown_.lights = {};
            publish_opened(Opening::Kind::edit);
            return;
        }
    }
    link_.activity.put("taking the changes of " + path);
    link_.on_news();
    opening_.begin(Opening::Kind::edit, [options = session_options(path)] { return open_session(options); });
}

// An edit may be read for a minute; until then hands hold the same heads in what is drawn.
const ui::Look& Engine::look_of_drawn() {
    if (request_.text == drawn_text_ || !request_.counted) return request_.look;
    counted_ = counted_as(*session_->show, request_.look, *request_.counted);
    return counted_;
}

std::optional<std::size_t> Engine::fixture_of_drawn(const std::optional<std::size_t>& fixture) const {
    if (request_.text == drawn_text_ || !request_.counted) return fixture;
    return ui::carried(fixture, *request_.counted, *session_->show);
}

void Engine::take_air(const scene::Show& edited) {
    if (!app::take_air(edited, *session_)) return;
    live_.take_air(*session_);
    forget_beside(); // their programs know one air
    last_change_s_ = now_s();
}

void Engine::choose_recording() {
    if (request_.recording == played_) return;
    played_ = request_.recording;
    const std::filesystem::path file =
        played_.empty() ? session_->show->recording : std::filesystem::path(played_);
    if (auto loaded = input_->load_recording(file, session_->report); !loaded.ok()) {
        link_.failed.put(loaded.error());
        link_.on_news();
    }
}

} // namespace ghost::app
