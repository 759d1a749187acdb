#pragma once
// SPDX-License-Identifier: Apache-2.0
// RdmHeads: the fixtures of the engine's show as RDM devices (live/inputs/rdm_desk.h): what the show is goes
// to the desks, what desks want of it to the window, and fixtures that identify themselves flash. Seconds of
// the engine's clock. Engine thread.

#include "link/link.h"
#include "live/inputs/rdm_desk.h"

#include <optional>
#include <set>
#include <vector>

namespace ghost::app {

class RdmHeads {
public:
    RdmHeads(ui::Link& link, int artnet_offset) : link_(link), desk_(artnet_offset) {}

    // Before the receiver starts.
    void listen(dmx::ReceiverOptions& options) { desk_.listen(options); }
    // Another session, in whose picture nothing is lit. is_another: of another show.
    void begin(bool is_another);
    // The show was edited.
    void know_anew() { is_known_ = false; }
    // The show and its rig as they are now; is_up_to_date: with all edits of the request.
    void step(const ui::ViewRequest& request, bool is_up_to_date, const scene::Show& show,
              const std::vector<fixture::State>& states, double now_s);
    // Fixtures whose bodies shine from now on; nothing: the same ones.
    std::optional<std::set<std::size_t>> flash(double now_s);
    bool identifies() const { return !identified_.empty(); }

private:
    void send_edits();

    ui::Link& link_;
    RdmDesk desk_;
    bool is_known_ = false; // the show, to the desk
    ui::RdmAccess access_ = ui::RdmAccess::off;
    std::uint64_t answered_ = 0;
    double turned_s_ = 0;
    ui::RdmNow sent_;
    std::set<std::size_t> identified_, shining_; // fixtures; those whose bodies shine now
};

} // namespace ghost::app
