// SPDX-License-Identifier: Apache-2.0
// The desk of a show: what one held that was silent before the show was opened counts for nothing. On the
// loopback interface, on ports of its own.
#include "live/inputs/live_input.h"

#include "dmx/send/sender.h"

#include <gtest/gtest.h>

#include <thread>
#include <unistd.h>

namespace ghost::app {
namespace {

constexpr int kMostSteps = 1000;

class DeskOfOurs {
public:
    DeskOfOurs() {
        dmx::ReceiverOptions options;
        options.interface = "127.0.0.1";
        options.sacn_port = static_cast<std::uint16_t>(20000 + (getpid() % 10000) * 2);
        options.artnet = false;
        options.sampling = std::chrono::nanoseconds{0};
        options.universes = {1, 2};
        auto started = dmx::Receiver::start(options);
        EXPECT_TRUE(started.ok()) << started.error().text();
        receiver = std::move(*started);
        dmx::SenderOptions wanted;
        wanted.destination = wanted.interface = "127.0.0.1";
        wanted.port = options.sacn_port;
        auto opened = dmx::Sender::open(wanted);
        EXPECT_TRUE(opened.ok()) << opened.error().text();
        sender_ = std::make_unique<dmx::Sender>(std::move(*opened));
    }
    void send(std::uint16_t universe) {
        dmx::Universes look;
        auto levels = std::make_shared<dmx::Levels>();
        levels->fill(200);
        look.at(universe).levels = levels;
        ASSERT_TRUE(sender_->send(look).ok());
    }
    void end() { sender_->terminate(); }

    std::unique_ptr<dmx::Receiver> receiver;

private:
    std::unique_ptr<dmx::Sender> sender_;
};

// Until it has that universe, lost or not.
testing::AssertionResult comes(LiveInput& input, std::uint16_t universe, bool is_lost) {
    for (int i = 0; i < kMostSteps; ++i) {
        input.step(ui::Input::automatic, {}, 0.01);
        const dmx::Universe* const one = input.desk().find(universe);
        if (one && one->lost == is_lost) return testing::AssertionSuccess();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return testing::AssertionFailure() << "universe " << universe << " does not come";
}

TEST(LiveInput, what_a_desk_held_that_is_gone_is_nothing_to_a_show_opened_later) {
    DeskOfOurs desk;
    LiveInput before(desk.receiver.get());
    desk.send(1);
    ASSERT_TRUE(comes(before, 1, false));
    desk.end();
    ASSERT_TRUE(comes(before, 1, true));
    EXPECT_EQ(before.universes().level(1, 1), 200) << "it is held while the show is open";

    LiveInput another(desk.receiver.get());
    desk.send(2); // all that is known is told anew, what is lost as well
    ASSERT_TRUE(comes(another, 2, false));
    EXPECT_EQ(another.desk().find(1), nullptr);
    desk.send(1);
    ASSERT_TRUE(comes(another, 1, false));
    EXPECT_EQ(another.desk().level(1, 1), 200);

    // Of an edited show it goes on.
    LiveInput edited(desk.receiver.get());
    edited.go_on_from(another);
    desk.end();
    ASSERT_TRUE(comes(edited, 1, true));
    EXPECT_EQ(edited.desk().level(1, 1), 200);
}

} // namespace
} // namespace ghost::app
