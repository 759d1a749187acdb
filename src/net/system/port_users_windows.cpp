// SPDX-License-Identifier: Apache-2.0
// In place of the inode of a socket: the number of its process.
#include "net/private/listed_sockets.h"
#include "net/private/winsock.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace ghost::dmx {

namespace {

constexpr int kTries = 4; // where sockets are opened meanwhile

// The kernel's table of this family, which it says the size of.
std::vector<std::uint8_t> udp_table(ULONG family) {
    std::vector<std::uint8_t> table;
    DWORD size = 0;
    for (int tries = 0; tries < kTries; ++tries) {
        const DWORD code = ::GetExtendedUdpTable(table.empty() ? nullptr : table.data(), &size, FALSE, family,
                                                 UDP_TABLE_OWNER_PID, 0);
        if (code == NO_ERROR && !table.empty()) return table;
        if (code != ERROR_INSUFFICIENT_BUFFER) return {};
        table.resize(size);
    }
    return {};
}

template <class Table, class Row, class Add>
void each_row(const std::vector<std::uint8_t>& bytes, const Add& add) {
    if (bytes.size() < sizeof(Table)) return;
    const auto& table = *reinterpret_cast<const Table*>(bytes.data());
    for (DWORD k = 0; k < table.dwNumEntries; ++k) add(table.table[k]);
}

std::uint16_t host_port(DWORD port) {
    return ntohs(static_cast<std::uint16_t>(port));
}

} // namespace

std::vector<ListedSocket> listed_elsewhere(std::span<const std::uint16_t> ports) {
    std::vector<ListedSocket> all;
    const auto add = [&](const IpAddress& address, std::uint16_t port, DWORD process) {
        const bool wanted = std::find(ports.begin(), ports.end(), port) != ports.end();
        if (wanted && process != ::GetCurrentProcessId()) all.push_back({address, port, process});
    };
    each_row<MIB_UDPTABLE_OWNER_PID, MIB_UDPROW_OWNER_PID>(
        udp_table(AF_INET), [&](const MIB_UDPROW_OWNER_PID& row) {
            add(IpAddress(ntohl(row.dwLocalAddr)), host_port(row.dwLocalPort), row.dwOwningPid);
        });
    each_row<MIB_UDP6TABLE_OWNER_PID, MIB_UDP6ROW_OWNER_PID>(
        udp_table(AF_INET6), [&](const MIB_UDP6ROW_OWNER_PID& row) {
            IpAddress address;
            std::memcpy(address.bytes.data(), row.ucLocalAddr, address.bytes.size());
            add(address, host_port(row.dwLocalPort), row.dwOwningPid);
        });
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<PortUser> named_users(std::vector<ListedSocket> sockets) {
    std::vector<PortUser> users;
    for (const ListedSocket& socket : sockets) {
        PortUser user{socket.address, socket.port, 0, ""};
        const auto number = static_cast<DWORD>(socket.inode);
        if (const HANDLE process = ::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, number)) {
            std::wstring file(32768, L'\0');
            auto size = static_cast<DWORD>(file.size());
            if (::QueryFullProcessImageNameW(process, 0, file.data(), &size)) {
                user.pid = static_cast<int>(number);
                user.program = std::filesystem::path(file.substr(0, size)).stem().string();
            }
            ::CloseHandle(process);
        }
        const auto same = [&](const PortUser& u) {
            return u.port == user.port && u.pid == user.pid && u.program == user.program;
        };
        if (std::none_of(users.begin(), users.end(), same)) users.push_back(std::move(user));
    }
    return users;
}

} // namespace ghost::dmx
