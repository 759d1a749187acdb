#pragma once
// SPDX-License-Identifier: Apache-2.0
// RdmDesk: the fixtures of a show as RDM devices that a lighting desk finds by Art-Net (rdm/node.h): the
// receiver's thread asks for answers, the thread that has the show tells what it is and takes what the desk
// wants to be changed. What was granted counts for the desk from then on, until the show has it. Any thread.

#include "dmx/receive/receiver_options.h"
#include "link/rdm.h"
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

class RdmDesk {
public:
    explicit RdmDesk(int artnet_offset, ui::RdmAccess access = ui::RdmAccess::off)
        : node_(artnet_offset), access_(access) {}

    // To be called before the receiver starts; this must outlive it.
    void listen(dmx::ReceiverOptions& options);
    // Off: desks hear that nobody is there, nothing identifies itself any more, and nothing is wanted. After
    // it update() says anew who is there.
    void set_access(ui::RdmAccess access);

    // As the show and the rig are now. answered: what was wanted with that number or a lower one is in the
    // show, or was refused.
    void update(const scene::Show& show, const std::vector<fixture::State>& states = {},
                std::uint64_t answered = 0);
    // As the rig has turned since.
    void turn(const scene::Show& show, const std::vector<fixture::State>& states);
    // Another show: what it has has nothing to do with what was there.
    void forget();

    struct Wanted {
        std::uint64_t number = 0; // of changes of the show; 0: identify
        std::size_t fixture = 0;  // of the show at the last update
        rdm::Change change;
        std::string name; // of the fixture, with what was wanted before
    };
    // What a desk wanted since the last call, identify as well.
    std::vector<Wanted> take();
    // Fixtures that identify themselves.
    std::set<std::size_t> identified() const;
    std::size_t devices() const;
    ui::RdmNow now() const;

private:
    // What was granted and is not in the show yet.
    struct Pending {
        std::uint64_t number = 0;
        std::optional<std::uint16_t> address;
        std::optional<std::uint8_t> personality;
        std::optional<std::string> label;
    };
    struct Known {
        std::size_t fixture = 0;
        std::string name;
    };
    std::optional<rdm::Nack> want(const rdm::Change& change);
    std::optional<rdm::Nack> edit(const rdm::Change& change, const Known& fixture);
    void drop_wanted();
    bool is_free_name(const std::string& name) const;
    void keep_uids(const scene::Show& show, std::vector<scene::RdmFixture>& all);
    void add_pending(rdm::Device& device) const;

    mutable std::mutex mutex_;
    rdm::Node node_;
    ui::RdmAccess access_;
    std::map<rdm::Uid, Known> fixtures_;
    std::vector<std::string> names_;          // of the show's fixtures; empty: of the plot, which has ids
    std::map<std::string, rdm::Uid> kept_;    // by name: whoever had another one when desks met it
    std::map<std::string, rdm::Uid> by_name_; // at the last update
    std::set<rdm::Uid> identified_;
    std::map<rdm::Uid, Pending> pending_;
    std::vector<Wanted> wanted_;
    std::uint64_t number_ = 0, answered_ = 0, refused_ = 0;
};

// "address 1.23", "mode 'Long'", "label 'FOH'", "identify on": what a desk wants, of a fixture with these
// modes.
std::string change_text(const rdm::Change& change, const scene::PatchedFixture& fixture);

} // namespace ghost::app
