#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests of the server: a stateful peer over loopback, and a server whose news the test puts in the place
// of an engine.
#include "image/ldr.h"
#include "json_xml_toml/json.h"
#include "show/show.h"
#include "support/must.h"
#include "web/server.h"
#include "web/websocket.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <sys/socket.h>
#include <thread>

namespace ghost::web {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Buffer = std::vector<std::uint8_t>;

constexpr auto kLong = 20s; // for what a busy machine may take

// A browser, or somebody who is none.
class Peer {
public:
    explicit Peer(std::uint16_t port) : port_(port) {
        stream_ = must(dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), port));
    }

    void send(Bytes bytes) {
        for (const auto until = Clock::now() + kLong; !bytes.empty() && Clock::now() < until;) {
            const auto sent = stream_->send(bytes);
            if (!sent) return;
            bytes = bytes.subspan(*sent);
            if (*sent == 0) std::this_thread::sleep_for(1ms);
        }
    }
    void send(const std::string& text) {
        send(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    }

    // Reads until it holds. False: it was closed, or never held.
    bool until(const std::function<bool()>& holds, Clock::duration time = kLong) {
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            if (holds()) return true;
            if (is_closed_) return false;
            const dmx::WaitFor wait{stream_->handle()};
            dmx::wait_for_streams({&wait, 1}, 20ms);
            if (const auto came = bytes_per_s_ > 0 ? read_slowly() : stream_->read())
                in_.insert(in_.end(), came->begin(), came->end());
            else
                is_closed_ = true;
        }
        return holds();
    }
    // From now on that much at most.
    void read_at(double bytes_per_s) {
        bytes_per_s_ = bytes_per_s;
        read_until_ = Clock::now();
    }
    // Says that nothing more comes from here, and goes on reading.
    void close_half() { stream_->finish(); }
    bool is_closed(Clock::duration time = kLong) {
        return until([&] { return is_closed_; }, time);
    }

    // Of an answer; 0: none came.
    int status() {
        until([&] { return std::string(in_.begin(), in_.end()).find("\r\n\r\n") != std::string::npos; });
        const std::string text(in_.begin(), in_.end());
        return text.size() > 12 && text.starts_with("HTTP/1.1 ") ? std::stoi(text.substr(9, 3)) : 0;
    }
    std::string text() const { return {in_.begin(), in_.end()}; }

    int get(const std::string& target) {
        send("GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n\r\n");
        return status();
    }

    // By six digits.
    int pair(const std::string& digits) {
        const std::string host = "127.0.0.1:" + std::to_string(port_), body = R"({"code":")" + digits + "\"}";
        send("POST /pair HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
             "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
             "\r\n\r\n" + body);
        return status();
    }

    // Becomes a viewer. Returns the status.
    int look_on(const std::string& token) {
        const std::string host = "127.0.0.1:" + std::to_string(port_);
        send("GET /live HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
             "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: ghostlight.1, t." +
             token + "\r\n\r\n");
        const int code = status();
        const std::string all = text();
        if (code == 101)
            in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(all.find("\r\n\r\n") + 4));
        return code;
    }

    void say(Opcode opcode, const Buffer& payload) {
        Buffer frame{static_cast<std::uint8_t>(0x80 | static_cast<int>(opcode)),
                     static_cast<std::uint8_t>(0x80 | payload.size()),
                     0,
                     0,
                     0,
                     0};
        ASSERT_LT(payload.size(), 126u);
        frame.insert(frame.end(), payload.begin(), payload.end());
        send(frame);
    }
    void say(const std::string& text) { say(Opcode::text, Buffer(text.begin(), text.end())); }
    void paint(std::uint32_t number) {
        say(Opcode::binary,
            {1, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8), 0, 0});
    }

    struct Frame {
        int opcode = 0; // 0: none came
        Buffer payload;
    };
    Frame frame(Clock::duration time = kLong) {
        Frame frame;
        const auto size_at = [&]() -> std::pair<std::size_t, std::size_t> { // of the head, of the payload
            if (in_.size() < 2) return {SIZE_MAX, 0};
            const std::size_t bytes = in_[1] < 126 ? 0 : in_[1] == 126 ? 2 : 8;
            if (in_.size() < 2 + bytes) return {SIZE_MAX, 0};
            std::size_t size = bytes == 0 ? in_[1] : 0;
            for (std::size_t i = 0; i < bytes; ++i) size = size << 8 | in_[2 + i];
            return {2 + bytes, size};
        };
        const auto is_whole = [&] {
            const auto [head, size] = size_at();
            return head != SIZE_MAX && in_.size() >= head + size;
        };
        if (!until(is_whole, time) && !is_whole()) return frame;
        const auto [head, size] = size_at();
        frame.opcode = in_[0] & 15;
        const auto begin = in_.begin() + static_cast<std::ptrdiff_t>(head),
                   end = begin + static_cast<std::ptrdiff_t>(size);
        frame.payload.assign(begin, end);
        in_.erase(in_.begin(), end);
        return frame;
    }
    // The next text of that type; null: none came.
    nlohmann::json hear(const std::string& type) {
        for (const auto end = Clock::now() + kLong; Clock::now() < end;) {
            const Frame next = frame();
            if (next.opcode == 0 || next.opcode == 8) return nullptr;
            if (next.opcode != 1) continue;
            auto json = read_json(std::string(next.payload.begin(), next.payload.end()), "frame");
            if (json.ok() && (*json)["type"] == type) return *json;
        }
        return nullptr;
    }
    // The next message of bytes of that kind; empty: none came.
    Buffer hear_bytes(std::uint8_t kind, Clock::duration time = kLong) {
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            const Frame next = frame(end - Clock::now());
            if (next.opcode == 0 || next.opcode == 8) return {};
            if (next.opcode == 2 && !next.payload.empty() && next.payload[0] == kind) return next.payload;
        }
        return {};
    }
    // Status of the frame that closes; 0: none came.
    int close_code() {
        for (;;) {
            const Frame next = frame();
            if (next.opcode == 0) return 0;
            if (next.opcode == 8) return next.payload[0] << 8 | next.payload[1];
        }
    }

private:
    std::optional<Bytes> read_slowly() {
        constexpr double kLeastBytes = 200;
        const double may_read =
            bytes_per_s_ * std::chrono::duration<double>(Clock::now() - read_until_).count();
        if (may_read < kLeastBytes) {
            std::this_thread::sleep_for(5ms);
            return Bytes{};
        }
        piece_.resize(static_cast<std::size_t>(std::min(may_read, 0.1 * bytes_per_s_)));
        const auto came = ::recv(stream_->handle(), piece_.data(), piece_.size(), MSG_DONTWAIT);
        if (came == 0) return std::nullopt;
        read_until_ = Clock::now();
        piece_.resize(static_cast<std::size_t>(std::max<ssize_t>(came, 0)));
        return Bytes(piece_);
    }

    std::uint16_t port_;
    std::unique_ptr<dmx::TcpStream> stream_;
    Buffer in_, piece_;
    double bytes_per_s_ = 0;       // 0: as it comes
    Clock::time_point read_until_; // at that rate
    bool is_closed_ = false;
};

inline std::uint32_t number_of(const Buffer& picture) {
    return picture.size() < 32 ? 0
                               : static_cast<std::uint32_t>(picture[4] | picture[5] << 8 | picture[6] << 16);
}

class WebServer : public ::testing::Test {
protected:
    WebServer() { server = must(Server::open(link, options)); }

    void open_show(std::size_t fixtures) {
        auto show = std::make_shared<scene::Show>();
        show->name = "tour";
        show->fixtures.resize(fixtures);
        ui::Opened opened;
        opened.show = show;
        link.opened.put(opened);
        server->news();
    }
    void put_picture(int width = 64, std::uint8_t red = 200) {
        image::Image8 image(width, width / 2, 4);
        for (std::size_t i = 0; i < image.samples.size(); i += 4) image.samples[i] = red;
        ui::Picture picture;
        picture.image = std::make_shared<const image::Image8>(std::move(image));
        link.picture.put(std::move(picture));
        server->news();
    }

    ui::Link link;
    ServerOptions options;
    std::unique_ptr<Server> server;
};

} // namespace ghost::web
