#pragma once
// SPDX-License-Identifier: Apache-2.0
// An engine without a desk that has opened the demo's copy, and what is asked of it next.
#include "live/engine/engine.h"
#include "support/demo_copy.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>

namespace ghost::app {

template <class F>
bool comes_within(double seconds, F&& holds) {
    for (int i = 0; i < static_cast<int>(seconds * 50); ++i) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

inline EngineOptions quiet_engine() {
    EngineOptions options;
    options.listens = false;
    options.session.quiet = true;
    return options;
}

struct OpenedEngine {
    explicit OpenedEngine(const EngineOptions& options = quiet_engine()) : engine(link, options) {
        request.show = DemoCopy::show().string();
        request.camera.width = 0;
        send();
        EXPECT_TRUE(comes_within(60, [&] { return (opened = link.opened.take()).has_value(); }));
    }
    void send() {
        ++request.number;
        link.request.put(request);
        link.wake.raise();
    }
    void look_from_first_camera(int width, int height) {
        request.camera = opened->show->cameras.front();
        request.camera.width = width;
        request.camera.height = height;
    }

    struct HeardLink : ui::Link {
        HeardLink() {
            on_news = [] {};
        }
    } link;
    ui::ViewRequest request;
    std::optional<ui::Opened> opened;
    Engine engine; // the last member: its thread uses the others
};

} // namespace ghost::app
