#pragma once
// SPDX-License-Identifier: Apache-2.0
// ServerLoop: what the server's thread does, again and again: takes who comes in, reads what they and the
// engine say, offers each viewer what it may have. Every wait has an end, every queue a limit. Seconds since
// its beginning.

#include "diagnose/patch_map.h"
#include "link/link.h"
#include "net/tcp.h"
#include "web/private/connection.h"
#include "web/private/picture_packer.h"
#include "web/private/viewer.h"
#include "web/protocol.h"
#include "web/site.h"

#include <chrono>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::web {

class ServerLoop {
public:
    ServerLoop(ui::Link& link, dmx::TcpListener& listener, dmx::StreamWake& wake, Access& access,
               double bytes_per_s);

    // Waits until there is something to do, a moment at most, and does it.
    void round();

private:
    struct Guest {
        Connection connection;
        std::unique_ptr<Viewer> viewer; // null: no WebSocket, or not yet
    };

    double now_s() const;
    void wait();
    void accept();
    // False: it is gone.
    bool serve(Guest& guest);
    void read_request(Guest& guest);
    void begin_live(Guest& guest, const Answer& answer);
    void read_frames(Guest& guest);
    void hear(Guest& guest, const ToServer& message);
    void end_live(Guest& guest, int code, const std::string& why);
    void answer(Guest& guest, const Answer& answer);
    void end_what_is_late(Guest& guest);

    void read_news();
    void take_opened(ui::Opened opened);
    void ask();
    void offer(Guest& guest);
    void offer_news(Guest& guest);
    void offer_picture(Guest& guest);
    const Packed& state();

    ui::Link& link_;
    dmx::TcpListener& listener_;
    dmx::StreamWake& wake_;
    Access& access_;
    Ration ration_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::list<Guest> guests_;
    std::size_t viewers_ = 0;

    // Of the engine, the newest.
    PicturePacker packer_;
    std::optional<ui::Picture> picture_;
    std::optional<ui::Opened> opened_;
    std::optional<ui::RigNow> rig_;
    std::optional<dmx::Statistics> network_;
    scene::PatchMap patch_;
    std::vector<std::string> problems_;
    // Made once for all viewers; null: not since the news changed. Versions begin at 1.
    Packed show_, messages_, levels_, state_;
    std::vector<Message> said_;
    std::uint64_t show_version_ = 0, messages_version_ = 0, levels_version_ = 0;
    double state_s_ = -1e9, levels_s_ = -1e9;

    std::optional<std::size_t> asking_; // the engine, about this fixture
    double asked_s_ = -1e9;
};

} // namespace ghost::web
