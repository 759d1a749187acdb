// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/rdm_desk.h"
#include "show/show.h"

#include <utility>

namespace ghost::app {

void RdmDesk::listen(dmx::ReceiverOptions& options) {
    options.answer_artnet = [this](Bytes packet) {
        const std::lock_guard lock(mutex_);
        return node_.take(packet, [this](const rdm::Change& change) { return want(change); });
    };
}

std::optional<rdm::Nack> RdmDesk::want(const rdm::Change& change) {
    const auto fixture = fixtures_.find(change.uid);
    if (fixture == fixtures_.end() || wanted_.size() >= kMostRdmChanges) return rdm::Nack::write_protect;
    const bool identify = change.what == rdm::Change::What::identify;
    if (!identify && !may_edit_) return rdm::Nack::write_protect;
    if (identify && change.number != 0)
        identified_.insert(change.uid);
    else if (identify)
        identified_.erase(change.uid);
    Wanted wanted = fixture->second;
    wanted.change = change;
    wanted_.push_back(std::move(wanted));
    return std::nullopt;
}

void RdmDesk::update(const scene::Show& show, const std::vector<fixture::State>& states) {
    std::vector<scene::RdmFixture> all = scene::rdm_devices(show, states);
    const std::lock_guard lock(mutex_);
    fixtures_.clear();
    std::vector<rdm::Device> devices;
    for (scene::RdmFixture& one : all) {
        one.device.identifies = identified_.contains(one.device.uid);
        fixtures_[one.device.uid] = {one.fixture, {}, show.fixtures[one.fixture].name};
        devices.push_back(std::move(one.device));
    }
    std::erase_if(identified_, [&](const rdm::Uid& uid) { return !fixtures_.contains(uid); });
    node_.update(std::move(devices));
}

std::vector<RdmDesk::Wanted> RdmDesk::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(wanted_, {});
}

std::set<std::size_t> RdmDesk::identified() const {
    const std::lock_guard lock(mutex_);
    std::set<std::size_t> result;
    for (const rdm::Uid& uid : identified_)
        if (const auto found = fixtures_.find(uid); found != fixtures_.end())
            result.insert(found->second.fixture);
    return result;
}

std::size_t RdmDesk::devices() const {
    const std::lock_guard lock(mutex_);
    return node_.devices();
}

std::uint64_t RdmDesk::messages() const {
    const std::lock_guard lock(mutex_);
    return node_.messages();
}

std::string change_text(const rdm::Change& change, const scene::PatchedFixture& fixture) {
    switch (change.what) {
    case rdm::Change::What::start_address:
        return "address " + std::to_string(fixture.universe) + "." + std::to_string(change.number);
    case rdm::Change::What::personality: {
        const std::size_t mode = change.number - 1u;
        const bool known = fixture.type && mode < fixture.type->modes.size();
        return "mode '" + (known ? fixture.type->modes[mode].name : std::to_string(change.number)) + "'";
    }
    case rdm::Change::What::label:
        return "name '" + change.label + "'";
    case rdm::Change::What::identify:
        break;
    }
    return change.number != 0 ? "identify on" : "identify off";
}

} // namespace ghost::app
