#pragma once
// SPDX-License-Identifier: Apache-2.0
// Xchange: a station of MVR-xchange (DIN SPEC 15801, TCP mode) on a thread of its own: finds the stations of
// a group by mDNS, joins them, saves the plots that they commit, and gives out those that we share. Anyone on
// the network can be a station: what they send is bounded, lands in one folder, and never takes the place of
// a file that is there. docs/guide/xchange.md.

#include "base/result.h"
#include "net/mdns.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ghost::app {

struct XchangeOptions {
    std::string group = "Default";
    std::string station;                      // our name; empty: "Ghostlight on HOST"
    std::string interface;                    // name or address of ours; empty: every one
    std::filesystem::path save;               // folder for what comes; empty: nothing is asked for
    std::vector<std::filesystem::path> share; // plots of ours
    std::vector<std::string> peers;           // "10.0.0.5:4568": stations that mDNS does not reach
    std::uint16_t port = 0;                   // TCP, ours; 0: one that is free
    std::uint16_t mdns_port = dmx::kMdnsPort; // another one for tests
    bool finds = true;                        // by mDNS, and is found
    std::uint64_t most_bytes = 16ull << 30;   // that are taken, all plots together
};

struct XchangeEvent {
    enum class Kind { found, joined, left, offered, received, sent, trouble };
    Kind kind = Kind::trouble;
    std::string station; // its name
    std::string text;    // for people
    // received: where it lies, and what they wrote about it.
    std::filesystem::path file;
    std::string comment;
};
const char* name_of(XchangeEvent::Kind kind);

class Xchange {
public:
    // Error: the folder, a file to share or a port.
    static Result<std::unique_ptr<Xchange>> start(const XchangeOptions& options);
    ~Xchange(); // says goodbye; takes up to a second
    Xchange(const Xchange&) = delete;
    Xchange& operator=(const Xchange&) = delete;

    // What happened since the last call; at most 1000, the newest.
    std::vector<XchangeEvent> take();
    std::uint16_t port() const;

    class Loop; // what the thread does (private/xchange_loop.h)

private:
    Xchange();
    std::unique_ptr<Loop> loop_;
};

} // namespace ghost::app
