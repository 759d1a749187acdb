// SPDX-License-Identifier: Apache-2.0
#include "web/private/worker.h"

#include "support/must.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <sys/resource.h>
#include <thread>

namespace ghost::web {
namespace {

using namespace std::chrono_literals;

struct Works : ::testing::Test {
    std::shared_ptr<dmx::StreamWake> wake = must(dmx::StreamWake::open());
    Worker worker{wake};

    // Finishes until it holds.
    template <class Holds>
    bool until(Holds holds) {
        for (int tries = 0; tries < 4000 && !holds(); ++tries) {
            const dmx::WaitFor raised{wake->handle()};
            dmx::wait_for_streams({&raised, 1}, 5ms);
            wake->clear(); // else the next waits are none, and all tries are over before the next piece
            worker.finish();
        }
        return holds();
    }
};

TEST_F(Works, results_come_in_order_on_the_thread_that_asks) {
    std::string order;
    std::atomic<int> nice = 0;
    const auto own = std::this_thread::get_id();
    for (const char name : {'a', 'b', 'c'})
        worker.put([&, name]() -> Worker::Done {
            nice = getpriority(PRIO_PROCESS, 0);
            std::this_thread::sleep_for(30ms); // a piece that takes long
            EXPECT_NE(std::this_thread::get_id(), own);
            return [&, name] {
                EXPECT_EQ(std::this_thread::get_id(), own);
                order += name;
            };
        });
    EXPECT_TRUE(until([&] { return order == "abc"; })) << order;
    EXPECT_EQ(nice, 19);
}

TEST_F(Works, what_a_piece_throws_comes_to_who_asks) {
    worker.put([]() -> Worker::Done { throw std::runtime_error("no memory"); });
    bool was_thrown = false;
    try {
        until([] { return false; });
    } catch (const std::runtime_error&) {
        was_thrown = true;
    }
    EXPECT_TRUE(was_thrown);
}

TEST(Worker, is_not_waited_for_at_its_end) {
    auto goes_on = std::make_shared<std::atomic<bool>>(false),
         is_over = std::make_shared<std::atomic<bool>>(false);
    {
        Worker worker(must(dmx::StreamWake::open()));
        worker.put([goes_on, is_over]() -> Worker::Done {
            while (!*goes_on) std::this_thread::sleep_for(1ms);
            *is_over = true;
            return [] { ADD_FAILURE() << "nobody asks any more"; };
        });
        std::this_thread::sleep_for(50ms);
    }
    EXPECT_FALSE(*is_over);
    *goes_on = true;
    for (int tries = 0; tries < 4000 && !*is_over; ++tries) std::this_thread::sleep_for(5ms);
    EXPECT_TRUE(*is_over);
}

} // namespace
} // namespace ghost::web
