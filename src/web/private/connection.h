#pragma once
// SPDX-License-Identifier: Apache-2.0
// Connection: bytes of one TCP connection in and out: what was not understood yet, what was not sent yet, and
// a polite end, in which the other side still reads the answer. Seconds of the server's clock. The server's
// thread.

#include "net/tcp.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::web {

using Packed = std::shared_ptr<const std::vector<std::uint8_t>>; // shared by all who get the same
using SharedText = std::shared_ptr<const std::string>;

class Connection {
public:
    Connection(std::unique_ptr<dmx::TcpStream> stream, double now_s)
        : stream_(std::move(stream)), since_s_(now_s), heard_s_(now_s) {}

    // What has arrived goes behind unread(). False: the other end is gone.
    bool read(double now_s);
    const std::vector<std::uint8_t>& unread() const { return unread_; }
    void take(std::size_t bytes) {
        unread_.erase(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(bytes));
    }

    void put(Packed bytes);
    void put(SharedText text);
    void put(std::string_view text);
    void put(std::vector<std::uint8_t> bytes) {
        put(std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes)));
    }
    std::size_t unsent() const { return unsent_; }
    // As much as goes. False: the other end is gone.
    bool send(double now_s);

    // Ends when all is sent; what still comes is not read any more.
    void end(double now_s);
    bool is_ending() const { return ends_s_ >= 0; }
    // Whether there is nothing left to wait for.
    bool is_over(double now_s);
    // An answer is on its way, and the other end reads it.
    bool is_in_answer(double now_s) const {
        return is_ending() && unsent_ > 0 && now_s - moved_s_ < kStands_s;
    }

    double since_s() const { return since_s_; }
    double heard_s() const { return heard_s_; }
    const dmx::TcpStream& stream() const { return *stream_; }

private:
    static constexpr double kEnd_s = 1;   // for the other end to read what was sent last
    static constexpr double kSend_s = 60; // for all of an answer, however slow the line
    static constexpr double kStands_s = 3;

    struct Piece {
        std::shared_ptr<const void> owner;
        Bytes bytes;
    };
    void put(Piece piece);

    std::unique_ptr<dmx::TcpStream> stream_;
    double since_s_, heard_s_;
    double moved_s_ = -1e9; // when something was sent last
    double ends_s_ = -1;    // since when; below 0: it goes on
    double sent_s_ = -1;    // since when all is sent; below 0: it is not
    bool finished_ = false;
    std::vector<std::uint8_t> unread_;
    std::deque<Piece> out_;
    std::size_t sent_of_first_ = 0;
    std::size_t unsent_ = 0;
};

} // namespace ghost::web
