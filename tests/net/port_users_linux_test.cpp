// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/receiver.h"
#include "net/port_users.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <arpa/inet.h>
#include <csignal>
#include <cstring>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

int udp_socket(std::uint16_t port, int shared = 0) {
    const int handle = socket(AF_INET, SOCK_DGRAM, 0);
    setsockopt(handle, SOL_SOCKET, SO_REUSEADDR, &shared, sizeof shared);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    EXPECT_EQ(bind(handle, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0) << std::strerror(errno);
    return handle;
}

// Another program that has a port open until it goes.
class OtherProgram {
public:
    explicit OtherProgram(std::uint16_t port, bool shares = false) {
        const int handle = udp_socket(port, shares ? 1 : 0);
        pid_ = fork();
        if (pid_ == 0) {
            execlp("sleep", "sleep", "60", nullptr); // takes the socket along
            _exit(1);
        }
        close(handle);
        while (read_name() != "sleep") std::this_thread::sleep_for(1ms);
    }
    ~OtherProgram() {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;
    int pid() const { return pid_; }

private:
    std::string read_name() const {
        char name[32]{};
        if (FILE* file = std::fopen(("/proc/" + std::to_string(pid_) + "/comm").c_str(), "r")) {
            (void)std::fscanf(file, "%31s", name);
            std::fclose(file);
        }
        return name;
    }
    int pid_ = 0;
};

std::uint16_t free_port() {
    return static_cast<std::uint16_t>(40000 + getpid() % 10000);
}

TEST(PortUsers, names_another_program_and_not_this_one) {
    const std::array<std::uint16_t, 1> ports{free_port()};
    const int ours = udp_socket(ports[0]);
    EXPECT_TRUE(port_users(ports).empty());
    close(ours);
    const OtherProgram other(ports[0]);
    const std::vector<PortUser> users = port_users(ports);
    ASSERT_EQ(users.size(), 1u);
    EXPECT_EQ(users[0], (PortUser{IpAddress(0u), ports[0], other.pid(), "sleep"}));
    EXPECT_EQ(program_text(users[0]), "sleep (pid " + std::to_string(other.pid()) + ")");
    EXPECT_EQ(program_text(PortUser{}), "a program of another user");
}

TEST(PortUsers, are_watched) {
    const std::uint16_t port = free_port();
    PortWatch watch({port});
    const auto within = [&](auto&& holds) {
        for (int i = 0; i < 100 && !holds(); ++i) std::this_thread::sleep_for(50ms);
        return holds();
    };
    {
        const OtherProgram other(port);
        EXPECT_TRUE(within([&] { return watch.users().size() == 1; }));
    }
    EXPECT_TRUE(within([&] { return watch.users().empty(); }));
}

ReceiverOptions on_loopback() {
    ReceiverOptions options;
    options.interface = "127.0.0.1";
    options.sacn_port = free_port();
    options.artnet_port = static_cast<std::uint16_t>(options.sacn_port + 1);
    options.sampling = 0s;
    return options;
}

TEST(PortUsers, a_receiver_says_who_keeps_it_out) {
    const ReceiverOptions options = on_loopback();
    const OtherProgram other(options.artnet_port);
    const auto receiver = Receiver::start(options);
    ASSERT_FALSE(receiver.ok());
    EXPECT_EQ(receiver.error().text(),
              "UDP port " + std::to_string(options.artnet_port) + ": the port is taken by sleep (pid " +
                  std::to_string(other.pid()) + "), which does not share it; close it and try again");
}

TEST(PortUsers, a_receiver_says_who_shares_its_ports) {
    const ReceiverOptions options = on_loopback();
    const OtherProgram other(options.sacn_port, true);
    const auto receiver = Receiver::start(options);
    ASSERT_TRUE(receiver.ok()) << receiver.error().text();
    std::vector<PortUser> users;
    for (int i = 0; i < 100 && users.empty(); ++i) {
        std::this_thread::sleep_for(50ms);
        if (const auto statistics = (*receiver)->take_statistics()) users = statistics->port_users;
    }
    ASSERT_EQ(users.size(), 1u);
    EXPECT_EQ(users[0].program, "sleep");
    EXPECT_EQ(users[0].pid, other.pid());
    EXPECT_EQ(users[0].port, options.sacn_port);
}

} // namespace
} // namespace ghost::dmx
