#pragma once
// SPDX-License-Identifier: Apache-2.0
// XchangePeer: one TCP connection of MVR-xchange, of whoever began it: reads messages and files as they come,
// sends what waits. Never waits itself. What the other end does is bounded: what it may leave unread, and how
// long it may take. Seconds of any steady clock; one thread.

#include "net/tcp.h"
#include "xchange/protocol.h"

#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

namespace ghost::app {

class XchangePeer {
public:
    XchangePeer(std::unique_ptr<dmx::TcpStream> stream, double now_s)
        : stream_(std::move(stream)), heard_s_(now_s), sent_s_(now_s) {}

    void say(const scene::XchangeMessage& message);
    // Error: the file cannot be read, or too many wait already.
    Result<void> send_file(const std::filesystem::path& path);

    struct Sink {
        std::function<void(const scene::XchangeMessage&)> message;
        // A piece of a file that was asked for. Error: ends the connection.
        std::function<Result<void>(Bytes piece, bool last)> file;
    };
    // Sends and reads what goes without waiting. Error: it is over; an empty one is a plain goodbye.
    Result<void> turn(double now_s, const Sink& sink);

    bool has_to_send() const { return !out_.empty() || !files_.empty(); }
    int handle() const { return stream_->handle(); }
    const dmx::IpAddress& address() const { return stream_->peer(); }
    std::size_t waiting_bytes() const { return out_.size() - out_sent_; }
    std::size_t memory_bytes() const { return out_.capacity(); }      // of what waits
    const std::string& problem() const { return stream_->problem(); } // of the connection itself
    double heard_s() const { return heard_s_; }                       // the last bytes

private:
    Result<void> send_what_goes(double now_s);
    void drop_sent();
    Result<void> refill();

    std::unique_ptr<dmx::TcpStream> stream_;
    scene::XchangeReader reader_;
    double heard_s_, sent_s_;
    double inside_since_s_ = -1; // of a package; negative: in none
    std::string out_;            // bytes to be sent
    std::size_t out_sent_ = 0;
    bool overfull_ = false;                   // something was not taken into out_
    std::deque<std::filesystem::path> files_; // behind out_; the first one is open
    std::ifstream file_;
    std::uint64_t file_left_ = 0;
};

} // namespace ghost::app
