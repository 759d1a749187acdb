// SPDX-License-Identifier: Apache-2.0
// The engine beside a window gives way to it, with all threads that it starts; the window's own does not.
#include "live/engine/engine.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <sys/resource.h>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

std::set<int> threads() {
    std::set<int> all;
    for (const auto& entry : fs::directory_iterator("/proc/self/task"))
        all.insert(std::stoi(entry.path().filename().string()));
    return all;
}

// Of the threads that the engine has started when it has tried to open a show.
std::set<int> priorities_of_engine(bool gives_way) {
    const std::set<int> before = threads();
    ui::Link link;
    link.on_news = [] {};
    EngineOptions options;
    options.listens = false;
    options.gives_way = gives_way;
    const Engine engine(link, options);
    ui::ViewRequest request;
    request.show = "nowhere";
    request.opens = 1;
    link.request.put(request);
    link.wake.raise();
    for (int i = 0; i < 500 && !link.not_opened.take(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::set<int> found;
    for (const int one : threads())
        if (!before.contains(one)) found.insert(getpriority(PRIO_PROCESS, static_cast<id_t>(one)));
    return found;
}

TEST(EngineGivesWay, with_its_threads_and_only_where_it_is_asked_to) {
    const int own = getpriority(PRIO_PROCESS, 0);
    if (own >= 5) GTEST_SKIP() << "this test runs with a priority of " << own << " itself";
    EXPECT_EQ(priorities_of_engine(false), std::set<int>{own});
    EXPECT_EQ(priorities_of_engine(true), std::set<int>{5});
    EXPECT_EQ(getpriority(PRIO_PROCESS, 0), own) << "whoever started it";
}

} // namespace
} // namespace ghost::app
