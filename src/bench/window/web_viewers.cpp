// SPDX-License-Identifier: Apache-2.0
#include "bench/window/private/web_viewers.h"

#include "base/give_way.h"
#include "base/steady_time.h"
#include "net/socket.h"

#include <algorithm>
#include <bit>
#include <chrono>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

constexpr double kWait_s = 20;
constexpr std::size_t kPictureHead = 32;
constexpr double kSlowBurst = 20'000; // bytes

Result<void> send_all(dmx::TcpStream& stream, Bytes bytes) {
    for (const double end_s = steady_now_s() + kWait_s; !bytes.empty();) {
        const auto sent = stream.send(bytes);
        if (!sent || steady_now_s() > end_s) return Error{"the server ended the line", "bench web"};
        bytes = bytes.subspan(*sent);
        if (*sent == 0) std::this_thread::sleep_for(1ms);
    }
    return {};
}

Result<void> send_all(dmx::TcpStream& stream, const std::string& text) {
    return send_all(stream, Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

// A frame of ours is masked; by zeros it stays as it is.
std::vector<std::uint8_t> masked(std::uint8_t opcode, Bytes payload) {
    constexpr std::size_t kFrameHead = 6;
    std::vector<std::uint8_t> frame(kFrameHead + payload.size());
    frame[0] = static_cast<std::uint8_t>(0x80 | opcode);
    frame[1] = static_cast<std::uint8_t>(0x80 | payload.size());
    std::copy(payload.begin(), payload.end(), frame.begin() + kFrameHead);
    return frame;
}

Result<void> shake_hands(dmx::TcpStream& stream, std::vector<std::uint8_t>& in, std::uint16_t port,
                         const std::string& token) {
    const std::string host = "127.0.0.1:" + std::to_string(port);
    TRY_VOID(send_all(stream, "GET /live HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
                                  "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13"
                                  "\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                                  "Sec-WebSocket-Protocol: ghostlight.1, t." +
                                  token + "\r\n\r\n"));
    for (const double end_s = steady_now_s() + kWait_s; steady_now_s() < end_s;) {
        const dmx::WaitFor wait{stream.handle()};
        dmx::wait_for_streams({&wait, 1}, 20ms);
        const auto came = stream.read();
        if (!came) break;
        in.insert(in.end(), came->begin(), came->end());
        const std::string text(in.begin(), in.end());
        const std::size_t head = text.find("\r\n\r\n");
        if (head == std::string::npos) continue;
        if (!text.starts_with("HTTP/1.1 101")) break;
        in.erase(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(head + 4));
        return {};
    }
    return Error{"the server let nobody in", "bench web"};
}

template <class T>
T little_endian(const std::uint8_t* bytes) {
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) value |= static_cast<T>(T{bytes[i]} << (8 * i));
    return value;
}

} // namespace

Result<std::unique_ptr<WebViewers>> WebViewers::look_on(std::uint16_t port, const std::string& token,
                                                        int count, double slow_bytes_per_s) {
    auto viewers = std::make_unique<WebViewers>();
    for (int i = 0; i < count; ++i) {
        One one;
        TRY(one.stream, dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), port));
        TRY_VOID(shake_hands(*one.stream, one.in, port, token));
        const std::string watch = R"({"type":"watch","width":1280,"calm":false})";
        TRY_VOID(send_all(*one.stream, masked(1, Bytes(reinterpret_cast<const std::uint8_t*>(watch.data()),
                                                       watch.size()))));
        viewers->all_.push_back(std::move(one));
    }
    viewers->all_.back().bytes_per_s = slow_bytes_per_s;
    viewers->thread_ = std::thread([all = viewers.get()] { all->run(); });
    return viewers;
}

WebViewers::~WebViewers() {
    (void)leave();
}

WebViewers::Ages WebViewers::leave() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    all_.clear();
    for (std::vector<double>* ages : {&ages_.of_most_ms, &ages_.of_slow_ms})
        std::sort(ages->begin(), ages->end());
    return ages_;
}

void WebViewers::run() {
    give_way();
    for (double before_s = steady_now_s(); !stop_;) {
        std::vector<dmx::WaitFor> streams;
        for (const One& one : all_)
            if (one.bytes_per_s <= 0) streams.push_back({one.stream->handle()});
        dmx::wait_for_streams(streams, streams.size() < all_.size() ? 10ms : 50ms);
        const double now_s = steady_now_s();
        for (One& one : all_) {
            one.may_read = std::min(one.may_read + (now_s - before_s) * one.bytes_per_s, kSlowBurst);
            read(one);
        }
        before_s = now_s;
        cpu_s_ = std::chrono::duration<double>(dmx::thread_cpu_time()).count();
    }
}

void WebViewers::read(One& one) {
    const bool is_slow = one.bytes_per_s > 0;
    if (is_slow && one.may_read <= 0) return;
    const auto came = one.stream->read();
    if (!came) return;
    one.may_read -= static_cast<double>(came->size());
    one.in.insert(one.in.end(), came->begin(), came->end());
    while (one.in.size() >= 2) {
        const std::size_t more = one.in[1] < 126 ? 0 : one.in[1] == 126 ? 2 : 8;
        if (one.in.size() < 2 + more) return;
        std::size_t size = more == 0 ? one.in[1] : 0;
        for (std::size_t i = 0; i < more; ++i) size = size << 8 | one.in[2 + i];
        const std::size_t whole = 2 + more + size;
        if (one.in.size() < whole) return;
        const std::uint8_t* payload = one.in.data() + 2 + more;
        if ((one.in[0] & 15) == 2 && size >= kPictureHead && payload[0] == 1) {
            const double drawn_ms = std::bit_cast<double>(little_endian<std::uint64_t>(payload + 8));
            (is_slow ? ages_.of_slow_ms : ages_.of_most_ms).push_back(1e3 * steady_now_s() - drawn_ms);
            const std::uint8_t painted[] = {1, payload[4], payload[5], payload[6], payload[7]};
            (void)send_all(*one.stream, masked(2, painted));
        }
        one.in.erase(one.in.begin(), one.in.begin() + static_cast<std::ptrdiff_t>(whole));
    }
}

} // namespace ghost::app
