// SPDX-License-Identifier: Apache-2.0
#include "net/port_users.h"

#include "net/private/listed_sockets.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace ghost::dmx {

namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Inode of an entry of /proc/*/fd that is a socket, else 0.
std::uint64_t socket_inode(const fs::path& entry) {
    std::error_code code;
    const std::string target = fs::read_symlink(entry, code).string();
    constexpr std::string_view kBegin = "socket:[";
    std::uint64_t inode = 0;
    if (code || !target.starts_with(kBegin)) return 0;
    const auto [end, failed] =
        std::from_chars(target.data() + kBegin.size(), target.data() + target.size(), inode);
    return failed == std::errc() && *end == ']' ? inode : 0;
}

std::set<std::uint64_t> sockets_of(const fs::path& process) {
    std::set<std::uint64_t> inodes;
    std::error_code code;
    for (fs::directory_iterator entry(process / "fd", code), end; !code && entry != end;
         entry.increment(code))
        if (const std::uint64_t inode = socket_inode(entry->path())) inodes.insert(inode);
    return inodes;
}

} // namespace

std::vector<ListedSocket> listed_elsewhere(std::span<const std::uint16_t> ports) {
    std::vector<ListedSocket> all = parse_listed_sockets(read_text("/proc/net/udp"), ports);
    const auto v6 = parse_listed_sockets(read_text("/proc/net/udp6"), ports);
    all.insert(all.end(), v6.begin(), v6.end());
    if (all.empty()) return all;
    const std::set<std::uint64_t> ours = sockets_of("/proc/self");
    std::erase_if(all, [&](const ListedSocket& one) { return ours.contains(one.inode); });
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<PortUser> named_users(std::vector<ListedSocket> sockets) {
    std::vector<PortUser> users;
    const auto add = [&](const ListedSocket& socket, int pid, const std::string& program) {
        const auto same = [&](const PortUser& u) {
            return u.port == socket.port && u.pid == pid && u.program == program;
        };
        if (std::none_of(users.begin(), users.end(), same))
            users.push_back({socket.address, socket.port, pid, program});
    };
    std::error_code code;
    for (fs::directory_iterator entry("/proc", code), end; !sockets.empty() && !code && entry != end;
         entry.increment(code)) {
        int pid = 0;
        const std::string name = entry->path().filename().string();
        const auto [last, failed] = std::from_chars(name.data(), name.data() + name.size(), pid);
        if (failed != std::errc() || last != name.data() + name.size()) continue;
        const std::set<std::uint64_t> inodes = sockets_of(entry->path());
        const auto theirs = [&](const ListedSocket& socket) { return inodes.contains(socket.inode); };
        if (std::none_of(sockets.begin(), sockets.end(), theirs)) continue;
        std::string program = read_text(entry->path() / "comm");
        std::replace_if(
            program.begin(), program.end(), [](unsigned char c) { return c < 0x20 && c != '\n'; }, '?');
        program.resize(std::min(program.find('\n'), program.size()));
        for (const ListedSocket& socket : sockets)
            if (theirs(socket)) add(socket, pid, program);
        std::erase_if(sockets, theirs);
    }
    for (const ListedSocket& socket : sockets) add(socket, 0, "");
    return users;
}

} // namespace ghost::dmx
