#pragma once
// SPDX-License-Identifier: Apache-2.0
// DeskListener: the receiver of a desk, as soon as its port is free, and the time code that it hears. What a
// person should know of the network goes to the messages, what the desk sends to the recorder. Engine thread.

#include "diagnose/patch_map.h"
#include "dmx/receive/receiver.h"
#include "link/link.h"
#include "live/engine/desk_recorder.h"
#include "live/engine/message_board.h"
#include "live/inputs/rdm_heads.h"
#include "live/inputs/timecode_input.h"

#include <memory>
#include <string>
#include <utility>

namespace ghost::app {

class DeskListener {
public:
    DeskListener(dmx::ReceiverOptions options, DeskRecorder& recorder, MessageBoard& messages, ui::Link& link)
        : options_(std::move(options)), recorder_(recorder), messages_(messages), link_(link) {}
    DeskListener(const DeskListener&) = delete;
    DeskListener& operator=(const DeskListener&) = delete;

    // What desks are told of the show, before it listens.
    void answer(RdmHeads& heads) { heads.listen(options_); }
    // What recordings follow, before it listens.
    void follow(const TimeCodeOptions& timecode);
    // Tries to, every few seconds. True: it has begun to.
    bool listen(double now_s);
    // Universes of a show, beside those of the options.
    void listen_to(const scene::PatchMap& patch);

    dmx::Receiver* receiver() const { return receiver_.get(); }       // null: it does not listen
    const TimeCodeInput* timecode() const { return timecode_.get(); } // null: none
    const dmx::ReceiverOptions& options() const { return options_; }

private:
    dmx::ReceiverOptions options_;
    DeskRecorder& recorder_;
    MessageBoard& messages_;
    ui::Link& link_;
    std::unique_ptr<TimeCodeInput> timecode_; // the receiver feeds it, and goes first
    std::unique_ptr<dmx::Receiver> receiver_;
    double again_s_ = 0; // where a port was taken
};

} // namespace ghost::app
