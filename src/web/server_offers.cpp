// SPDX-License-Identifier: Apache-2.0
// What viewers get of what the engine says: each piece made once, and put only where all before it is on its
// way.
#include "web/private/server_loop.h"

#include "diagnose/diagnosis.h"
#include "show/show.h"

namespace ghost::web {
namespace {

constexpr double kStateEvery_s = 0.25;
constexpr double kLevelsEvery_s = 0.1;
constexpr double kExplainEvery_s = 0.25;           // for all viewers together
constexpr double kAnswerWithin_s = 5;              // an engine that is loading answers nothing
constexpr std::size_t kMostUnsentBytes = 4u << 20; // to one viewer

double milliseconds(std::chrono::steady_clock::time_point time) {
    return std::chrono::duration<double, std::milli>(time.time_since_epoch()).count();
}

Packed packed_text(const std::string& text) {
    return std::make_shared<const std::vector<std::uint8_t>>(build_text(text));
}

} // namespace

void ServerLoop::read_news() {
    if (auto news = link_.opened.take_second()) take_opened(std::move(*news));
    if (auto news = link_.picture.take_second()) {
        picture_ = *news;
        packer_.put(std::move(*news), milliseconds(std::chrono::steady_clock::now()));
    }
    if (auto news = link_.rig.take_second()) {
        rig_ = std::move(*news);
        levels_.reset();
    }
    if (auto news = link_.network.take_second()) {
        network_ = std::move(*news);
        problems_.clear();
        for (const scene::Sentence& sentence : scene::diagnose(*network_, patch_))
            problems_.push_back(sentence.text);
    }
    if (auto news = link_.messages.take_second()) {
        said_ = std::move(*news);
        messages_.reset();
        ++messages_version_;
    }
    if (auto news = link_.answer.take()) {
        const Packed explained = packed_text(explained_text(*news));
        for (Guest& guest : guests_) {
            if (!guest.viewer || guest.viewer->asks != news->fixture) continue;
            guest.viewer->asks.reset();
            guest.connection.put(explained);
        }
        asking_.reset();
    }
    if (viewers_ > 0) packer_.go_on(now_s());
}

void ServerLoop::take_opened(ui::Opened opened) {
    opened_ = std::move(opened);
    patch_ = opened_->show ? scene::PatchMap(*opened_->show) : scene::PatchMap();
    rig_.reset();
    asking_.reset();
    show_.reset();
    ++show_version_;
}

void ServerLoop::ask() {
    const double now = now_s();
    if (now - asked_s_ < (asking_ ? kAnswerWithin_s : kExplainEvery_s)) return;
    // Who was asked for last comes last the next time.
    for (auto guest = guests_.begin(); guest != guests_.end(); ++guest) {
        if (!guest->viewer || !guest->viewer->asks) continue;
        asking_ = guest->viewer->asks;
        asked_s_ = now;
        link_.question.put(*asking_);
        guests_.splice(guests_.end(), guests_, guest);
        return;
    }
}

void ServerLoop::offer(Guest& guest) {
    if (guest.connection.unsent() > kMostUnsentBytes)
        return end_live(guest, kCloseTryLater, "too much is on the way");
    if (guest.connection.unsent() > 0 || guest.connection.is_ending()) return;
    offer_news(guest);
    offer_picture(guest);
}

void ServerLoop::offer_news(Guest& guest) {
    Viewer& viewer = *guest.viewer;
    const double now = now_s();
    if (opened_ && viewer.show != show_version_) {
        if (!show_) show_ = packed_text(show_text(static_cast<std::uint16_t>(show_version_), *opened_));
        guest.connection.put(show_);
        viewer.show = show_version_;
    }
    if (viewer.messages != messages_version_) {
        if (!messages_) messages_ = packed_text(messages_text(said_));
        guest.connection.put(messages_);
        viewer.messages = messages_version_;
    }
    if (now - viewer.state_s >= kStateEvery_s) {
        viewer.state_s = now;
        guest.connection.put(state());
    }
    if (!viewer.wants_levels || !rig_) return;
    if (!levels_ && now - levels_s_ >= kLevelsEvery_s) {
        levels_s_ = now;
        ++levels_version_;
        levels_ = std::make_shared<const std::vector<std::uint8_t>>(build_frame(
            Opcode::binary, levels_message(static_cast<std::uint16_t>(show_version_),
                                           milliseconds(std::chrono::steady_clock::now()), rig_->fixtures)));
    }
    if (!levels_ || viewer.levels == levels_version_) return;
    guest.connection.put(levels_);
    viewer.levels = levels_version_;
}

void ServerLoop::offer_picture(Guest& guest) {
    Viewer& viewer = *guest.viewer;
    const double now = now_s();
    if (packer_.number() == 0 || viewer.flow.newest() == packer_.number() || !viewer.flow.may_send(now) ||
        !ration_.has_some(now))
        return;
    const Packed picture = packer_.packed(viewer.flow.width());
    if (!picture) return;
    ration_.spend(static_cast<double>(picture->size()));
    guest.connection.put(picture);
    viewer.flow.sent(packer_.number(), now);
}

const Packed& ServerLoop::state() {
    const double now = now_s();
    if (state_ && now - state_s_ < kStateEvery_s) return state_;
    state_s_ = now;
    StateNow what;
    what.picture = picture_ ? &*picture_ : nullptr;
    what.rig = rig_ ? &*rig_ : nullptr;
    what.network = network_ ? &*network_ : nullptr;
    what.show = opened_ ? opened_->show.get() : nullptr;
    what.problems = problems_;
    for (Guest& guest : guests_) {
        if (!guest.viewer) continue;
        guest.viewer->forget_painted(now);
        what.lookers.push_back(
            {dmx::address_text(guest.connection.stream().peer()), now - guest.connection.since_s(),
             static_cast<double>(guest.viewer->painted_s.size()), guest.viewer->flow.width()});
    }
    return state_ = packed_text(state_text(what));
}

} // namespace ghost::web
