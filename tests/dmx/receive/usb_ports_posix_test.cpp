// SPDX-License-Identifier: Apache-2.0
// Serial ports that come and go, as pseudo-terminals: the test plays the widget at the other end.
#include "dmx/receive/usb_ports.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Buffer = std::vector<std::uint8_t>;

// One end of a pseudo-terminal, the other one linked to a path.
class FakeWidget {
public:
    explicit FakeWidget(const fs::path& link)
        : handle_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)), link_(link) {
        EXPECT_GE(handle_, 0);
        EXPECT_EQ(grantpt(handle_), 0);
        EXPECT_EQ(unlockpt(handle_), 0);
        fs::create_symlink(ptsname(handle_), link_);
    }
    ~FakeWidget() {
        close(handle_);
        fs::remove(link_);
    }
    void send(const Buffer& bytes) {
        ASSERT_EQ(::write(handle_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    // What the program wrote, at least count bytes of it.
    Buffer heard(std::size_t count) {
        Buffer result;
        for (int i = 0; i < 2000 && result.size() < count; ++i) {
            Buffer part(256);
            const ssize_t size = ::read(handle_, part.data(), part.size());
            if (size > 0) result.insert(result.end(), part.begin(), part.begin() + size);
            if (size <= 0) std::this_thread::sleep_for(5ms);
        }
        return result;
    }

private:
    int handle_;
    fs::path link_;
};

bool has_pseudo_terminals() {
    const int handle = posix_openpt(O_RDWR | O_NOCTTY);
    const char* const name = handle >= 0 && unlockpt(handle) == 0 ? ptsname(handle) : nullptr;
    const int other = name ? open(name, O_RDWR | O_NOCTTY) : -1;
    close(other);
    close(handle);
    return other >= 0;
}

class UsbPortsTest : public testing::Test {
protected:
    void SetUp() override {
        if (!has_pseudo_terminals()) GTEST_SKIP() << "no pseudo-terminals here (/dev/pts)";
        folder_ = fs::path(testing::TempDir()) / ("usb_ports_" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override {
        if (!folder_.empty()) fs::remove_all(folder_);
    }

    // Reads until a packet has come, for ten seconds at most: a pseudo-terminal hands bytes on when it likes.
    static std::vector<Packet> packets_of(UsbPorts& ports, std::chrono::nanoseconds now) {
        std::vector<Packet> result;
        for (int i = 0; i < 2000 && result.empty(); ++i) {
            ports.take(now, [&](const Packet& packet) { result.push_back(packet); });
            if (result.empty()) std::this_thread::sleep_for(5ms);
        }
        return result;
    }

    fs::path folder_;
};

const auto kNobody = [](const Packet&) { ADD_FAILURE() << "a packet from nobody"; };
const Buffer kFrame = build_usb_pro(5, Buffer{0, 0, 10, 20, 30});

TEST_F(UsbPortsTest, a_port_may_come_later_go_and_come_back) {
    const fs::path link = folder_ / "ttyUSB0";
    UsbPorts ports({{link.string(), 4}}, folder_);
    ports.take(0s, kNobody);
    ASSERT_EQ(ports.status().size(), 1u);
    EXPECT_FALSE(ports.status()[0].open);
    EXPECT_EQ(ports.status()[0].problem, "is not plugged in");

    std::optional<FakeWidget> widget(link);
    ports.take(500ms, kNobody);
    EXPECT_FALSE(ports.status()[0].open) << "looked for once a second";
    ports.take(1s, kNobody);
    EXPECT_TRUE(ports.status()[0].open);
    EXPECT_FALSE(ports.status()[0].answered);
    EXPECT_EQ(ports.handles().size(), 1u);
    EXPECT_EQ(widget->heard(18), UsbProWidget::hello());
    ports.take(2900ms, kNobody);
    ports.take(3s, kNobody); // nobody has answered yet: once more
    EXPECT_EQ(widget->heard(18), UsbProWidget::hello());

    widget->send(kFrame);
    const auto packets = packets_of(ports, 3s);
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].universe, 4);
    EXPECT_EQ(packets[0].slots[2], 30);
    EXPECT_TRUE(ports.status()[0].answered);
    EXPECT_EQ(ports.status()[0].counters.frames, 1u);

    widget.reset();
    const auto last = packets_of(ports, 3s);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_TRUE(last[0].terminated);
    EXPECT_EQ(last[0].source, packets[0].source);
    EXPECT_FALSE(ports.status()[0].open);
    EXPECT_EQ(ports.status()[0].problem, "was pulled out");
    EXPECT_TRUE(ports.handles().empty());

    widget.emplace(link);
    ports.take(10s, kNobody);
    EXPECT_TRUE(ports.status()[0].open);
    EXPECT_EQ(ports.status()[0].openings, 2u);
    EXPECT_EQ(widget->heard(18), UsbProWidget::hello());
    widget->send(kFrame);
    EXPECT_EQ(packets_of(ports, 10s).size(), 1u);
}

TEST_F(UsbPortsTest, auto_takes_widgets_by_their_names_and_keeps_their_universes) {
    const fs::path second = folder_ / "usb-ENTTEC_DMX_USB_PRO_EN200000-if00-port0";
    FakeWidget b(second), other(folder_ / "usb-FTDI_FT232R_USB_UART_A1-if00-port0");
    UsbPorts ports({{"auto", 7}}, folder_);
    ports.take(0s, kNobody);
    ASSERT_EQ(ports.status().size(), 1u) << "a converter of somebody else is left alone";
    EXPECT_EQ(ports.status()[0].universe, 7);
    FakeWidget a(folder_ / "usb-DMXking.com_DMX_USB_PRO_6A-if00-port0");
    ports.take(1s, kNobody);
    ASSERT_EQ(ports.status().size(), 2u);
    EXPECT_EQ(ports.status()[0].path, second.string());
    EXPECT_EQ(ports.status()[0].universe, 7);
    EXPECT_EQ(ports.status()[1].universe, 8);
    EXPECT_TRUE(ports.status()[1].open);
}

TEST_F(UsbPortsTest, what_cannot_be_opened_says_why) {
    const fs::path file = folder_ / "file", link = folder_ / "ttyUSB0";
    std::fclose(std::fopen(file.c_str(), "w"));
    EXPECT_EQ(SerialPort::open(file.string()).error().what, "is no serial port");
    FakeWidget widget(link);
    const auto port = SerialPort::open(link.string());
    ASSERT_TRUE(port.ok()) << port.error().text();
    EXPECT_EQ(SerialPort::open(link.string()).error().what,
              "is in use by another program; close it and try again");
}

} // namespace
} // namespace ghost::dmx
