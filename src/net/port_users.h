#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which other programs of this machine have our UDP ports open: of two programs on one port Linux gives
// unicast to the one that was bound last, and a program that does not share a port keeps us out. From
// /proc/net/udp and /proc/*/fd; of programs of other users only root learns the name. Elsewhere: nobody.

#include "net/address.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace ghost::dmx {

// A UDP socket as the kernel lists it.
struct ListedSocket {
    IpAddress address; // that it is bound to; 0.0.0.0 or ::: every one
    std::uint16_t port = 0;
    std::uint64_t inode = 0;

    auto operator<=>(const ListedSocket&) const = default;
};

struct PortUser {
    IpAddress address;
    std::uint16_t port = 0;
    int pid = 0;         // 0: another user's, which the system does not tell
    std::string program; // "olad"; empty with pid 0

    bool operator==(const PortUser&) const = default;
};

// "olad (pid 123)", "a program of another user".
std::string program_text(const PortUser& user);

// The text of /proc/net/udp or udp6: sockets on these ports. Lines that are none are passed over.
std::vector<ListedSocket> parse_listed_sockets(std::string_view text, std::span<const std::uint16_t> ports);

// Everyone but this process, each program once a port. Reads the open files of all processes: a tenth of a
// second on a machine with thousands.
std::vector<PortUser> port_users(std::span<const std::uint16_t> ports);

// Looks every two seconds, on a thread of its own, and for names only when the sockets changed.
class PortWatch {
public:
    explicit PortWatch(std::vector<std::uint16_t> ports);
    ~PortWatch();
    PortWatch(const PortWatch&) = delete;
    PortWatch& operator=(const PortWatch&) = delete;

    std::vector<PortUser> users() const;

private:
    void run();

    std::vector<std::uint16_t> ports_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    bool stop_ = false;
    std::vector<PortUser> users_;
    std::thread thread_; // the last member: it uses all others
};

} // namespace ghost::dmx
