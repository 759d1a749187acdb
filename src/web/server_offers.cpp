// SPDX-License-Identifier: Apache-2.0
// What viewers get of what the engine says: each piece made once, and put only where all before it is on its
// way.
#include "web/private/server_loop.h"

#include "diagnose/diagnosis.h"
#include "image/jpeg.h"
#include "show/show.h"

#include <algorithm>
#include <utility>

namespace ghost::web {
namespace {

constexpr image::JpegQuality kSmallQuality{85, true};
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
        folders_.take(opened_ ? opened_->show.get() : nullptr, said_);
        messages_.reset();
        ++messages_version_;
    }
    if (auto news = link_.looks.take_second()) {
        looks_ = std::move(*news);
        looks_text_.reset();
        ++looks_version_;
    }
    if (const auto news = link_.cue.take_second()) cue_label_.call(*news, now_s());
    if (auto news = link_.camera_pictures.take_second()) take_small(SmallKind::camera, *news);
    if (auto news = link_.look_pictures.take_second()) take_small(SmallKind::look, *news);
    if (auto news = link_.side_pictures.take())
        for (const ui::SidePicture& picture : *news) take_side(picture);
    answer_commands();
    encoder_.finish();
    reader_.finish();
    if (auto news = link_.answer.take()) {
        const Packed explained = packed_text(folders_.taken_out(explained_text(*news)));
        for (Guest& guest : guests_) {
            if (!guest.viewer || guest.viewer->asks != news->fixture) continue;
            guest.viewer->asks.reset();
            guest.connection.put(explained);
        }
        asking_.reset();
    }
    if (viewers_ > 0) packer_.go_on(now_s());
    for (Side& side : sides_) side.packer.go_on(now_s());
}

// Of each the newest, each with a version of its own.
void ServerLoop::take_small(SmallKind kind, const std::vector<ui::NamedPicture>& pictures) {
    std::erase_if(small_, [&](const Small& one) {
        return one.kind == kind && std::none_of(pictures.begin(), pictures.end(), [&](const auto& picture) {
                   return picture.name == one.name;
               });
    });
    for (const ui::NamedPicture& picture : pictures) {
        const auto known = std::find_if(small_.begin(), small_.end(), [&](const Small& one) {
            return one.kind == kind && one.name == picture.name;
        });
        if (known != small_.end()) {
            if (known->image == picture.image) continue;
            small_.erase(known);
        }
        small_.push_back({kind, picture.name, picture.image, ++small_version_});
    }
}

void ServerLoop::answer_commands() {
    for (const ui::CommandAnswer& answered : link_.command_answers.take()) {
        const auto asked = std::find_if(asked_.begin(), asked_.end(),
                                        [&](const Asked& one) { return one.number == answered.number; });
        if (asked == asked_.end()) continue;
        for (Guest& guest : guests_)
            if (guest.viewer && guest.viewer->id == asked->viewer)
                guest.connection.put(build_text(
                    answered.refused.empty() ? done_text(asked->n)
                                             : folders_.taken_out(refused_text(asked->n, answered.refused))));
        asked_.erase(asked);
    }
}

void ServerLoop::take_opened(ui::Opened opened) {
    opened_ = std::move(opened);
    folders_.take(opened_->show.get(), said_);
    patch_ = opened_->show ? scene::PatchMap(*opened_->show) : scene::PatchMap();
    rig_.reset();
    asking_.reset();
    if (!opened_->is_edit) small_.clear(); // those of another show
    look_at_sides_anew();
    show_.reset();
    ++show_version_;
}

void ServerLoop::ask() {
    const double now = now_s();
    if (now - asked_s_ < (asking_ ? kAnswerWithin_s : kExplainEvery_s)) return;
    Viewer* next = nullptr; // who was asked for last comes last the next time
    for (const Guest& guest : guests_)
        if (guest.viewer && guest.viewer->asks &&
            (!next || guest.viewer->asked_engine_s < next->asked_engine_s))
            next = guest.viewer.get();
    if (!next) return;
    asking_ = next->asks;
    asked_s_ = next->asked_engine_s = now;
    link_.question.put(*asking_);
}

void ServerLoop::offer(Guest& guest) {
    // A show may be larger than that; it is sent once, and all viewers share it.
    const std::size_t most = kMostUnsentBytes + (show_ ? show_->size() : 0);
    if (guest.connection.unsent() > most) return end_live(guest, kCloseTryLater, "too much is on the way");
    if (guest.connection.unsent() > 0 || guest.connection.is_ending()) return;
    offer_news(guest);
    offer_picture(guest);
    if (guest.viewer->wants_pictures && !guest.viewer->flow.is_full(now_s())) offer_small(guest);
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
        if (!messages_) messages_ = packed_text(folders_.taken_out(messages_text(said_)));
        guest.connection.put(messages_);
        viewer.messages = messages_version_;
    }
    if (viewer.looks != looks_version_) {
        if (!looks_text_) looks_text_ = packed_text(looks_text(looks_));
        guest.connection.put(looks_text_);
        viewer.looks = looks_version_;
    }
    // What comes again and again would wait in line behind pictures that he has not painted, and the next
    // picture behind it.
    if (viewer.flow.is_full(now)) return;
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
    Side* const side = side_for(viewer);
    PicturePacker& packer = side ? side->packer : packer_;
    if (packer.number() == 0 || viewer.flow.newest() == packer.number() || !viewer.flow.may_send(now) ||
        !ration_.has_some(now))
        return;
    const Packed picture = packer.packed(viewer.flow.width());
    if (!picture) return;
    ration_.spend(static_cast<double>(picture->size()));
    viewer.is_served = true;
    guest.connection.put(picture);
    viewer.flow.sent(packer.number(), now);
    if (!side || !side->measure || viewer.measure == side->view.number) return;
    viewer.measure = side->view.number;
    guest.connection.put(side->measure);
}

// One at a time: what moves comes first.
void ServerLoop::offer_small(Guest& guest) {
    const auto next = std::find_if(small_.begin(), small_.end(),
                                   [&](const Small& one) { return one.version > guest.viewer->small; });
    if (next == small_.end() || !ration_.has_some(now_s())) return;
    if (!next->packed) {
        if (!std::exchange(next->is_encoding, true)) encode_small(*next);
        return;
    }
    guest.viewer->small = next->version;
    guest.viewer->is_served = true;
    ration_.spend(static_cast<double>(next->packed->size()));
    guest.connection.put(next->packed);
}

void ServerLoop::encode_small(const Small& small) {
    encoder_.put([this, version = small.version, kind = small.kind, name = small.name,
                  image = small.image]() -> Worker::Done {
        const auto jpeg = image::encode_jpeg(*image, kSmallQuality);
        const std::vector<std::uint8_t> frame =
            jpeg.ok() ? build_frame(Opcode::binary, small_message(kind, name, *jpeg))
                      : std::vector<std::uint8_t>();
        return [this, version, packed = std::make_shared<const std::vector<std::uint8_t>>(frame)] {
            for (Small& one : small_)
                if (one.version == version) one.packed = packed;
        };
    });
}

void ServerLoop::take_encoded(const Encoded& encoded) {
    packer_.take(encoded);
    for (Side& side : sides_) side.packer.take(encoded);
}

const Packed& ServerLoop::state() {
    const double now = now_s();
    if (state_ && now - state_s_ < kStateEvery_s) return state_;
    state_s_ = now;
    StateNow what;
    what.picture = picture_ ? &*picture_ : nullptr;
    what.rig = rig_ ? &*rig_ : nullptr;
    what.network = network_ ? &*network_ : nullptr;
    if (opened_ && rig_) {
        const bool plays = !rig_->from_desk && rig_->recording_s > 0;
        what.cue = cue_label_.name(*opened_->show, plays ? std::optional(rig_->at_s) : std::nullopt, now);
    }
    what.problems = problems_;
    for (Guest& guest : guests_) {
        if (!guest.viewer) continue;
        guest.viewer->forget_painted(now);
        what.lookers.push_back({dmx::address_text(guest.connection.stream().peer()),
                                now - guest.connection.since_s(),
                                static_cast<double>(guest.viewer->painted_s.size()),
                                guest.viewer->flow.width(), guest.viewer->right == Right::control});
    }
    {
        const std::lock_guard lock(gate_.mutex);
        gate_.lookers = what.lookers;
    }
    return state_ = packed_text(folders_.taken_out(state_text(what)));
}

} // namespace ghost::web
