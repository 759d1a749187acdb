#pragma once
// SPDX-License-Identifier: Apache-2.0
// ServerLoop: what the server's thread does, again and again: takes who comes in, reads what they and the
// engine say, offers each viewer what it may have. Every wait has an end, every queue a limit. Steady
// seconds.

#include "base/steady_time.h"
#include "diagnose/patch_map.h"
#include "link/link.h"
#include "net/tcp.h"
#include "web/private/book_shelf.h"
#include "web/private/connection.h"
#include "web/private/cue_label.h"
#include "web/private/own_folders.h"
#include "web/private/picture_packer.h"
#include "web/private/viewer.h"
#include "web/private/worker.h"
#include "web/protocol.h"
#include "web/server.h"
#include "web/site.h"

#include <atomic>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::web {

class ServerLoop {
public:
    ServerLoop(ui::Link& link, dmx::TcpListener& listener, std::shared_ptr<dmx::StreamWake> wake, Gate& gate,
               const ServerOptions& options, const std::atomic<bool>& stop);

    // Waits until there is something to do, a moment at most, and does it, or a part of it once it is to
    // stop.
    void round();

private:
    struct Guest {
        Connection connection;
        std::unique_ptr<Viewer> viewer = nullptr; // null: no WebSocket, or not yet
        std::optional<std::string> book = {};     // a file of it, that is waited for
        std::uint64_t reading = 0;                // its number, once it is being read
        SharedText file = nullptr;                // that is on its way
    };

    static double now_s() { return steady_now_s(); }
    void wait();
    void accept();
    bool is_full() const { return guests_.size() >= kMostViewers + kMostOthers; }
    // Whoever makes room for who comes; none: all have come just now, or are being answered.
    std::list<Guest>::iterator who_leaves();
    // False: it is gone.
    bool serve(Guest& guest);
    void read_request(Guest& guest);
    void begin_live(Guest& guest, const Routed& routed, std::uint64_t keys);
    void read_book();
    void answer_book(std::uint64_t reading, const Result<BookShelf::File>& file);
    std::size_t book_bytes() const; // in memory, that are on their way
    void tell_of(const Guest& guest, const std::string& what);
    void read_frames(Guest& guest);
    void hear(Guest& guest, const ToServer& message);
    void watch(Guest& guest, const Watch& watch);
    void go_to_watch(Guest& guest);
    void command(Guest& guest, const Do& what);
    void explain(Guest& guest, std::size_t fixture);
    // Of the tokens as they are now, and of who is to go.
    void look_at_gate();
    void end_live(Guest& guest, int code, const std::string& why);
    void answer(Guest& guest, const Answer& answer);
    void end_what_is_late(Guest& guest);

    void read_news();
    void take_encoded(const Encoded& encoded);
    void take_opened(ui::Opened opened);
    void take_small(SmallKind kind, const std::vector<ui::NamedPicture>& pictures);
    void take_side(const ui::SidePicture& picture);
    void answer_commands();
    void ask();
    // server_sides.cpp: which side views are wanted now.
    void choose_sides();
    void look_at_sides_anew(); // the show is another one
    std::optional<ui::SideView> side_of(const Watch& watch) const;
    struct Side;
    Side* side_for(const Viewer& viewer);
    void offer(Guest& guest);
    void offer_news(Guest& guest);
    void offer_small(Guest& guest);
    void offer_picture(Guest& guest);
    const Packed& state();

    ui::Link& link_;
    dmx::TcpListener& listener_;
    std::shared_ptr<dmx::StreamWake> wake_;
    Gate& gate_;
    const std::atomic<bool>& stop_;
    const std::string host_; // by which who stands before us calls us
    std::shared_ptr<BookShelf> book_;
    std::uint64_t readings_ = 0; // of files of the book
    bool is_reading_ = false;
    Worker encoder_, reader_;
    const double silence_s_;
    Ration ration_;
    Ration lines_{1, 20}; // of the log, about who comes and leaves
    std::size_t untold_ = 0;
    std::list<Guest> guests_;
    std::size_t viewers_ = 0;
    std::uint64_t ids_ = 0; // of viewers
    std::uint64_t sent_away_ = 0;

    // Of the engine, the newest.
    std::uint32_t numbers_ = 0; // of pictures
    PicturePacker packer_{numbers_, 0, encoder_, [this](const Encoded& one) { take_encoded(one); }};
    std::optional<ui::Picture> picture_;
    std::optional<ui::Opened> opened_;
    OwnFolders folders_;
    std::optional<ui::RigNow> rig_;
    std::optional<dmx::Statistics> network_;
    scene::PatchMap patch_;
    std::vector<std::string> problems_;
    // Made once for all viewers; null: not since the news changed. Versions begin at 1.
    Packed show_, messages_, levels_, state_, looks_text_;
    std::vector<Message> said_;
    std::uint64_t show_version_ = 0, messages_version_ = 0, levels_version_ = 0, looks_version_ = 0;
    ui::LooksNow looks_;
    CueLabel cue_label_;

    struct Small {
        SmallKind kind = SmallKind::camera;
        std::string name;
        std::shared_ptr<const image::Image8> image;
        std::uint64_t version = 0;
        Packed packed = nullptr; // null: not yet
        bool is_encoding = false;
    };
    void encode_small(const Small& small);
    std::vector<Small> small_; // versions grow
    std::uint64_t small_version_ = 0;

    struct Side {
        Watch watch; // that it is for; its width and calm count nothing
        ui::SideView view;
        PicturePacker packer;
        Packed measure;                                       // null: none
        std::shared_ptr<const image::Image8> image = nullptr; // that came last
        bool is_stale = false;                                // of the show before
    };
    std::list<Side> sides_;
    std::uint64_t side_numbers_ = 0;

    struct Asked {
        std::uint64_t number = 0, viewer = 0;
        std::uint32_t n = 0;
    };
    std::vector<Asked> asked_; // commands that are not answered
    std::uint64_t commands_ = 0;
    double state_s_ = -1e9, levels_s_ = -1e9;

    std::optional<std::size_t> asking_; // the engine, about this fixture
    double asked_s_ = -1e9;
};

} // namespace ghost::web
