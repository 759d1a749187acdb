#pragma once
// SPDX-License-Identifier: Apache-2.0
// RdmDesk: the fixtures of a show as RDM devices that a lighting desk finds by Art-Net (rdm/node.h): the
// receiver's thread asks for answers, the thread that has the show tells what it is and takes what the desk
// wants to be changed. Start address, personality and label only with leave. Any thread.

#include "dmx/receive/receiver_options.h"
#include "rdm/node.h"
#include "show_folder/rdm_devices.h"

#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ghost::scene {
struct PatchedFixture;
} // namespace ghost::scene

namespace ghost::app {

inline constexpr std::size_t kMostRdmChanges = 4096; // that wait; more are refused

class RdmDesk {
public:
    // may_edit: a desk may change what stands in the show.
    RdmDesk(int artnet_offset, bool may_edit) : node_(artnet_offset), may_edit_(may_edit) {}

    // To be called before the receiver starts; this must outlive it.
    void listen(dmx::ReceiverOptions& options);

    // As the show and the rig are now.
    void update(const scene::Show& show, const std::vector<fixture::State>& states = {});

    struct Wanted {
        std::size_t fixture = 0; // of the show at the last update
        rdm::Change change;
        std::string name; // of the fixture then
    };
    // What a desk wanted since the last call, identify as well.
    std::vector<Wanted> take();
    // Fixtures that identify themselves.
    std::set<std::size_t> identified() const;
    std::size_t devices() const;
    std::uint64_t messages() const;

private:
    std::optional<rdm::Nack> want(const rdm::Change& change);

    mutable std::mutex mutex_;
    rdm::Node node_;
    bool may_edit_;
    std::map<rdm::Uid, Wanted> fixtures_; // without a change
    std::set<rdm::Uid> identified_;
    std::vector<Wanted> wanted_;
};

// "address 1.23", "mode 'Long'", "label 'FOH'", "identify on": what a desk wants, of a fixture with these
// modes.
std::string change_text(const rdm::Change& change, const scene::PatchedFixture& fixture);

} // namespace ghost::app
