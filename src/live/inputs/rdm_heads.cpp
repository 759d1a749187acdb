// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/rdm_heads.h"

#include "show/show.h"

#include <cmath>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kTurnEvery_s = 0.25; // angles to desks, and news to the window
constexpr double kFlash_s = 1;        // half of it lit

} // namespace

void RdmHeads::begin(bool is_another) {
    if (is_another) {
        desk_.forget();
        (void)link_.rdm_edits.take(); // of the show before
    }
    shining_.clear();
    is_known_ = false;
}

void RdmHeads::step(const ui::ViewRequest& request, bool is_up_to_date, const scene::Show& show,
                    const std::vector<fixture::State>& states, double now_s) {
    if (request.rdm != access_) {
        access_ = request.rdm;
        desk_.set_access(access_);
        is_known_ = false;
    }
    if (access_ != ui::RdmAccess::off) {
        if (is_up_to_date && answered_ != request.rdm_answered) {
            answered_ = request.rdm_answered;
            is_known_ = false;
        }
        if (!std::exchange(is_known_, true)) desk_.update(show, states, answered_);
        send_edits();
    }
    identified_ = desk_.identified();
    if (now_s - turned_s_ < kTurnEvery_s) return;
    turned_s_ = now_s;
    if (access_ != ui::RdmAccess::off) desk_.turn(show, states);
    ui::RdmNow now = desk_.now();
    if (now == sent_) return;
    sent_ = now;
    link_.rdm.put(std::move(now));
    link_.on_news();
}

void RdmHeads::send_edits() {
    for (const RdmDesk::Wanted& wanted : desk_.take()) {
        if (wanted.number == 0) continue; // identify: the bodies say so
        ui::RdmEdit asked;
        asked.number = wanted.number;
        asked.fixture = wanted.fixture;
        asked.name = wanted.name;
        switch (wanted.change.what) {
        case rdm::Change::What::start_address:
            asked.address = wanted.change.number;
            break;
        case rdm::Change::What::personality:
            asked.mode = wanted.change.number - 1u;
            break;
        case rdm::Change::What::label:
            asked.label = wanted.change.label;
            break;
        case rdm::Change::What::identify:
            break;
        }
        (void)link_.rdm_edits.put(std::move(asked)); // as many as the desk was granted
        link_.on_news();
    }
}

std::optional<std::set<std::size_t>> RdmHeads::flash(double now_s) {
    const bool is_lit = std::fmod(now_s, kFlash_s) < kFlash_s / 2;
    std::set<std::size_t> shining = is_lit ? identified_ : std::set<std::size_t>{};
    if (shining == shining_) return std::nullopt;
    return shining_ = std::move(shining);
}

} // namespace ghost::app
