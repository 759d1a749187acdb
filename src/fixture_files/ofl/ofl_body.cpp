// SPDX-License-Identifier: Apache-2.0
// Pixels, heads and the body of a mode.
#include "base/text.h"
#include "fixture_files/ofl/private/ofl_mode_maker.h"
#include "fixture_files/ofl/private/ofl_words.h"

#include <algorithm>

namespace ghost::fixture {

void OflModeMaker::find_cells() {
    Body& body = draft_.body;
    const Json& categories = member(reader_.document, "categories");
    bool light = true;
    if (categories.is_array() && !categories.empty())
        for (const char* dark : {"Smoke", "Hazer", "Fan"}) light &= categories[0] != Json(dark);
    if (!light) return;
    const OflMatrix& matrix = reader_.matrix;
    for (std::size_t place = 0; place < places_.size() && !has_pixels_ && !matrix.keys.empty(); ++place)
        has_pixels_ = names_pixel(place);
    if (!has_pixels_) {
        body.cells.push_back({0, 0});
        return;
    }
    body.grid = {matrix.count.x, matrix.count.y * matrix.count.z};
    for (const glm::ivec3& place : matrix.places)
        body.cells.push_back({place.x, place.y + place.z * matrix.count.y});
    body.cell_names = matrix.keys;
}

bool OflModeMaker::names_pixel(std::size_t place) const {
    const OflKeys::Found& found = places_[place].found;
    if (!found.entry || !found.pixel.empty()) return found.entry != nullptr;
    if (!is_switching(place)) return false;
    const Json& capabilities = member(*found.entry->channel, "capabilities");
    std::string wanted;
    return capabilities.is_array() &&
           std::any_of(capabilities.begin(), capabilities.end(), [&](const Json& capability) {
               return !target_of(place, capability, wanted).pixel.empty();
           });
}

std::vector<int> OflModeMaker::cells_of(const std::string& pixel) const {
    if (pixel.empty() || draft_.body.cells.size() < 2) return {};
    return pixels_of(reader_.matrix, pixel);
}

void OflModeMaker::find_groups() {
    Body& body = draft_.body;
    std::vector<std::size_t> pans;
    std::vector<std::size_t> tilts;
    for (std::size_t i = 0; i < draft_.channels.size(); ++i) {
        bool pan = false;
        bool tilt = false;
        for (const ChannelFunction& function : draft_.channels[i].channel.functions) {
            const Role role = function.meaning.role;
            body.pan |= role == Role::pan || role == Role::pan_rotate;
            body.tilt |= role == Role::tilt || role == Role::tilt_rotate;
            pan |= role == Role::pan;
            tilt |= role == Role::tilt;
        }
        if (pan) pans.push_back(i);
        if (tilt) tilts.push_back(i);
    }
    // A master for all heads beside one channel for each stays with all of them.
    for (std::vector<std::size_t>* axis : {&pans, &tilts})
        if (std::any_of(axis->begin(), axis->end(),
                        [&](std::size_t i) { return !draft_.channels[i].cells.empty(); }))
            std::erase_if(*axis, [&](std::size_t i) { return draft_.channels[i].cells.empty(); });
        else
            split_masters(*axis);
    const std::size_t groups = std::clamp<std::size_t>(std::max(pans.size(), tilts.size()), 1, 64);
    body.groups = static_cast<int>(groups);
    if (body.cells.size() < groups && !body.cells.empty()) {
        body.cells.clear();
        body.cell_names.clear();
        body.grid = {static_cast<int>(groups), 1};
        for (int i = 0; i < static_cast<int>(groups); ++i) body.cells.push_back({i, 0});
        for (ChannelDraft& draft : draft_.channels) draft.cells.clear();
    }
    body.cell_groups.resize(body.cells.size(), 0);
    for (std::size_t cell = 0; cell < body.cells.size(); ++cell)
        body.cell_groups[cell] = static_cast<int>(cell * groups / body.cells.size());
    for (const std::vector<std::size_t>& axis : {pans, tilts})
        for (std::size_t k = 0; k < axis.size() && axis.size() > 1; ++k) {
            ChannelDraft& draft = draft_.channels[axis[k]];
            draft.group = static_cast<int>(std::min(k, groups - 1));
            for (const int cell : draft.cells) body.cell_groups[static_cast<std::size_t>(cell)] = draft.group;
        }
}

// "Tilt All" beside "Tilt 1" and "Tilt 2": no head of its own. Where it can rest it has the last word.
void OflModeMaker::split_masters(std::vector<std::size_t>& axis) {
    const auto is_master = [&](std::size_t i) { return ofl_is_master(names_[i]); };
    if (axis.size() < 2 + static_cast<std::size_t>(std::count_if(axis.begin(), axis.end(), is_master)))
        return;
    for (const std::size_t i : axis) {
        if (!is_master(i)) continue;
        ChannelDraft& draft = draft_.channels[i];
        draft.last = std::any_of(draft.channel.functions.begin(), draft.channel.functions.end(),
                                 [](const ChannelFunction& function) { return !is_shown(function); });
        if (!draft.last)
            reader_.say(Severity::error, pointer_,
                        "'" + names_[i].substr(0, 80) +
                            "' has no value at which it rests: the channels of the single heads count");
    }
    std::erase_if(axis, is_master);
}

void OflModeMaker::make_body() {
    Body& body = draft_.body;
    const std::string focus = lower(physical_.focus);
    body.size_m = physical_.size_m;
    if (focus == "mirror" && (body.pan || body.tilt))
        body.carriage = Carriage::mirror;
    else if (body.pan || body.tilt || focus == "head")
        body.carriage = Carriage::head;
    LampFacts facts = physical_.lamp;
    facts.has_gobos = has_gobos_;
    const BeamGuess guess = beam_from(facts, body.carriage);
    body.beam = guess.beam;
    if (body.cells.empty()) return;
    for (const std::string& sentence : guess.assumed) reader_.say(Severity::note, "/physical", sentence);
}

} // namespace ghost::fixture
