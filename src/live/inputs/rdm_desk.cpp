// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/rdm_desk.h"

#include "show/names.h"
#include "show/show.h"

#include <algorithm>
#include <utility>

namespace ghost::app {
namespace {

// E1.20 10.5: texts are ASCII.
bool is_plain(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char letter) { return letter >= 0x20 && letter < 0x7F; });
}

rdm::Node::PortOf port_of(const dmx::ReceiverOptions::PlaceOf& place_of) {
    return [&place_of](std::uint16_t port_address) -> std::optional<rdm::Port> {
        const std::optional<dmx::PollAnswers::Place> place = place_of(port_address);
        if (!place) return std::nullopt;
        return rdm::Port{place->bind_index, place->port};
    };
}

} // namespace

void RdmDesk::listen(dmx::ReceiverOptions& options) {
    options.answer_artnet = [this](const dmx::Datagram& datagram,
                                   const dmx::ReceiverOptions::PlaceOf& place_of) {
        const std::lock_guard lock(mutex_);
        if (access_ == ui::RdmAccess::off) return rdm::Node::Packets{};
        return node_.take(
            datagram.bytes, {datagram.from.ipv4(), datagram.time},
            [this](const rdm::Change& change) { return want(change); }, port_of(place_of));
    };
    options.unasked = [this](std::chrono::nanoseconds now, const dmx::ReceiverOptions::PlaceOf& place_of)
        -> std::optional<dmx::ReceiverOptions::Unasked> {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock) return std::nullopt; // a large show is being told: levels do not wait for that
        std::optional<rdm::Node::News> news = node_.news(now, port_of(place_of));
        if (!news) return std::nullopt;
        return dmx::ReceiverOptions::Unasked{news->to_ipv4, std::move(news->packets)};
    };
    options.knows_rdm = [this] {
        const std::lock_guard lock(mutex_);
        return access_ != ui::RdmAccess::off;
    };
}

void RdmDesk::set_access(ui::RdmAccess access) {
    const std::lock_guard lock(mutex_);
    access_ = access;
    if (access != ui::RdmAccess::off) return;
    node_.update({}); // who asked before is told that nobody is there
    identified_.clear();
    drop_wanted();
}

void RdmDesk::drop_wanted() {
    pending_.clear();
    wanted_.clear();
    answered_ = number_;
}

std::optional<rdm::Nack> RdmDesk::want(const rdm::Change& change) {
    const auto fixture = fixtures_.find(change.uid);
    std::optional<rdm::Nack> why;
    if (fixture == fixtures_.end())
        why = rdm::Nack::write_protect;
    else if (wanted_.size() >= ui::kMostRdmEdits)
        why = rdm::Nack::buffer_full;
    else if (change.what != rdm::Change::What::identify)
        why = edit(change, fixture->second);
    else if (change.number != 0)
        identified_.insert(change.uid);
    else
        identified_.erase(change.uid);
    if (why)
        ++refused_;
    else if (change.what == rdm::Change::What::identify)
        wanted_.push_back({0, fixture->second.fixture, change, fixture->second.name});
    return why;
}

// What is so already is no edit.
std::optional<rdm::Nack> RdmDesk::edit(const rdm::Change& change, const Known& fixture) {
    if (access_ != ui::RdmAccess::edit) return rdm::Nack::write_protect;
    if (number_ - answered_ >= ui::kMostRdmEdits) return rdm::Nack::buffer_full;
    const rdm::Device* const device = node_.find(change.uid);
    if (!device) return rdm::Nack::write_protect;
    const auto waits = pending_.find(change.uid);
    const std::string name =
        waits != pending_.end() && waits->second.label ? *waits->second.label : fixture.name;
    switch (change.what) {
    case rdm::Change::What::start_address:
        if (device->start_address == change.number) return std::nullopt;
        pending_[change.uid].address = change.number;
        break;
    case rdm::Change::What::personality:
        if (device->personality == change.number) return std::nullopt;
        pending_[change.uid].personality = static_cast<std::uint8_t>(change.number);
        break;
    case rdm::Change::What::label:
        if (name == change.label) return std::nullopt;
        if (!is_plain(change.label) || !scene::is_good_name(change.label) || !is_free_name(change.label))
            return rdm::Nack::data_out_of_range;
        pending_[change.uid].label = change.label;
        break;
    case rdm::Change::What::identify:
        return std::nullopt;
    }
    pending_[change.uid].number = ++number_;
    wanted_.push_back({number_, fixture.fixture, change, name});
    return std::nullopt;
}

bool RdmDesk::is_free_name(const std::string& name) const {
    return std::none_of(fixtures_.begin(), fixtures_.end(),
                        [&](const auto& one) { return one.second.name == name; }) &&
           std::find(names_.begin(), names_.end(), name) == names_.end() &&
           std::none_of(pending_.begin(), pending_.end(),
                        [&](const auto& one) { return one.second.label == name; });
}

// A fixture that is no plot's is known by its name; one that gets another name stays who it is.
void RdmDesk::keep_uids(const scene::Show& show, std::vector<scene::RdmFixture>& all) {
    std::vector<std::string> names;
    for (const scene::PatchedFixture& fixture : show.fixtures)
        names.push_back(fixture.uuid.empty() ? fixture.name : "");
    const std::set<std::string> before(names_.begin(), names_.end()), now(names.begin(), names.end());
    if (names.size() == names_.size())
        for (std::size_t i = 0; i < names.size(); ++i)
            if (const auto known = by_name_.find(names_[i]);
                known != by_name_.end() && !now.contains(names_[i]) && !before.contains(names[i]))
                kept_[names[i]] = known->second;
    names_ = std::move(names);
    by_name_.clear();
    std::set<rdm::Uid> taken;
    for (const scene::RdmFixture& one : all) taken.insert(one.device.uid);
    for (scene::RdmFixture& one : all) {
        const std::string& name = names_[one.fixture];
        if (name.empty()) continue;
        if (const auto kept = kept_.find(name); kept != kept_.end() && taken.insert(kept->second).second)
            one.device.uid = kept->second;
        by_name_[name] = one.device.uid;
    }
}

void RdmDesk::add_pending(rdm::Device& device) const {
    const auto found = pending_.find(device.uid);
    if (found == pending_.end()) return;
    const Pending& pending = found->second;
    device.start_address = pending.address.value_or(device.start_address);
    device.personality = pending.personality.value_or(device.personality);
    device.label = pending.label.value_or(device.label);
}

void RdmDesk::update(const scene::Show& show, const std::vector<fixture::State>& states,
                     std::uint64_t answered) {
    std::vector<scene::RdmFixture> all = scene::rdm_devices(show, states);
    const std::lock_guard lock(mutex_);
    answered_ = std::max(answered_, answered);
    std::erase_if(pending_, [&](const auto& one) { return one.second.number <= answered_; });
    keep_uids(show, all);
    fixtures_.clear();
    std::vector<rdm::Device> devices;
    for (scene::RdmFixture& one : all) {
        one.device.identifies = identified_.contains(one.device.uid);
        add_pending(one.device);
        fixtures_[one.device.uid] = {one.fixture, show.fixtures[one.fixture].name};
        devices.push_back(std::move(one.device));
    }
    std::erase_if(identified_, [&](const rdm::Uid& uid) { return !fixtures_.contains(uid); });
    node_.update(std::move(devices));
}

void RdmDesk::turn(const scene::Show& show, const std::vector<fixture::State>& states) {
    const std::lock_guard lock(mutex_);
    for (const auto& [uid, known] : fixtures_) {
        if (known.fixture >= std::min(states.size(), show.fixtures.size())) continue;
        const scene::PatchedFixture& fixture = show.fixtures[known.fixture];
        const auto mode = static_cast<std::size_t>(std::max(fixture.mode, 0));
        if (fixture.type && mode < fixture.type->modes.size())
            node_.feel(uid, scene::rdm_angles(fixture.type->modes[mode], states[known.fixture]));
    }
}

void RdmDesk::forget() {
    const std::lock_guard lock(mutex_);
    names_.clear();
    kept_.clear();
    by_name_.clear();
    identified_.clear();
    drop_wanted();
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

ui::RdmNow RdmDesk::now() const {
    const std::lock_guard lock(mutex_);
    ui::RdmNow now{access_, {}, node_.messages(), node_.faults(), refused_};
    if (access_ == ui::RdmAccess::off) return now;
    for (const auto& [uid, known] : fixtures_) {
        const rdm::Node::Heard heard = node_.heard(uid);
        now.heads.push_back(
            {known.fixture, rdm::uid_text(uid), heard.is_found, heard.messages, identified_.contains(uid)});
    }
    std::sort(now.heads.begin(), now.heads.end(),
              [](const ui::RdmHead& a, const ui::RdmHead& b) { return a.fixture < b.fixture; });
    return now;
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
