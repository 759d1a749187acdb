// SPDX-License-Identifier: Apache-2.0
#include "net/port_users.h"

#include "net/private/listed_sockets.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>

namespace ghost::dmx {

namespace {

constexpr std::chrono::seconds kEvery{2};
constexpr std::size_t kMostSockets = 64;

template <class T>
bool read_hex(std::string_view text, T& value) {
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    return failed == std::errc() && end == text.data() + text.size();
}

// Words of a line, at most count.
std::vector<std::string_view> words_of(std::string_view line, std::size_t count) {
    std::vector<std::string_view> words;
    while (words.size() < count) {
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos) break;
        line.remove_prefix(begin);
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

// 32-bit words in the byte order of the machine: little-endian on all that we run on.
std::optional<IpAddress> read_address(std::string_view hex) {
    if (hex.size() != 8 && hex.size() != 32) return std::nullopt;
    std::array<std::uint8_t, 16> bytes{};
    for (std::size_t word = 0; word < hex.size() / 8; ++word) {
        std::uint32_t value = 0;
        if (!read_hex(hex.substr(8 * word, 8), value)) return std::nullopt;
        for (std::size_t i = 0; i < 4; ++i) bytes[4 * word + i] = static_cast<std::uint8_t>(value >> (8 * i));
    }
    if (hex.size() == 32) return IpAddress(bytes);
    return IpAddress(static_cast<std::uint32_t>(bytes[0]) << 24 | static_cast<std::uint32_t>(bytes[1]) << 16 |
                     static_cast<std::uint32_t>(bytes[2]) << 8 | bytes[3]);
}

} // namespace

std::string program_text(const PortUser& user) {
    if (user.pid == 0) return "a program of another user";
    return (user.program.empty() ? "a program" : user.program) + " (pid " + std::to_string(user.pid) + ")";
}

std::vector<ListedSocket> parse_listed_sockets(std::string_view text, std::span<const std::uint16_t> ports) {
    std::vector<ListedSocket> result;
    while (!text.empty() && result.size() < kMostSockets) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::vector<std::string_view> words = words_of(text.substr(0, end), 10);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (words.size() < 10) continue;
        const std::size_t colon = words[1].find(':');
        if (colon == std::string_view::npos) continue;
        const auto address = read_address(words[1].substr(0, colon));
        ListedSocket socket;
        if (!address || !read_hex(words[1].substr(colon + 1), socket.port)) continue;
        const auto [last, failed] =
            std::from_chars(words[9].data(), words[9].data() + words[9].size(), socket.inode);
        const bool wanted = std::find(ports.begin(), ports.end(), socket.port) != ports.end();
        if (failed != std::errc() || socket.inode == 0 || !wanted) continue;
        socket.address = *address;
        result.push_back(socket);
    }
    return result;
}

std::vector<PortUser> port_users(std::span<const std::uint16_t> ports) {
    return named_users(listed_elsewhere(ports));
}

PortWatch::PortWatch(std::vector<std::uint16_t> ports)
    : ports_(std::move(ports)), thread_([this] { run(); }) {}

PortWatch::~PortWatch() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

std::vector<PortUser> PortWatch::users() const {
    const std::lock_guard lock(mutex_);
    return users_;
}

void PortWatch::run() {
    std::vector<ListedSocket> known;
    std::unique_lock lock(mutex_);
    while (!stop_) {
        lock.unlock();
        std::vector<ListedSocket> now = listed_elsewhere(ports_);
        std::optional<std::vector<PortUser>> users;
        if (now != known) users = named_users(now);
        known = std::move(now);
        lock.lock();
        if (users) users_ = std::move(*users);
        wake_.wait_for(lock, kEvery, [this] { return stop_; });
    }
}

} // namespace ghost::dmx
