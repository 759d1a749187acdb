// SPDX-License-Identifier: Apache-2.0
// Which camera's passes are read, and what is said where none are shown.
#include "live/engine/baked_supply.h"

#include "passes/passes_file.h"
#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace ghost::app {
namespace {

class BakedSupplyTest : public testing::Test {
protected:
    void SetUp() override {
        SessionOptions options;
        options.show = DemoCopy::show().string();
        options.view = "high";
        options.live = options.quiet = true;
        options.shadows = false;
        options.width = 64;
        options.height = 36;
        session_ = must(open_session(options));
    }
    void TearDown() override { supply_.forget(); }

    // What is said when nothing is read any more.
    std::string said_of(const char* name, int width, int height) {
        scene::Camera camera;
        for (const scene::Camera& one : session_->show->cameras)
            if (one.name == name) camera = one;
        const float fov_y_deg = camera.fov_y_deg;
        camera.width = width;
        camera.height = height;
        do {
            EXPECT_FALSE(supply_.choose(*session_, {camera, fov_y_deg, nullptr, ""}, now_s_ += 2));
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        } while (supply_.is_reading());
        EXPECT_FALSE(supply_.choose(*session_, {camera, fov_y_deg, nullptr, ""}, now_s_));
        return supply_.words();
    }

    std::unique_ptr<Session> session_;
    BakedSupply supply_;
    double now_s_ = 0;
};

TEST_F(BakedSupplyTest, what_is_too_coarse_is_not_read_and_hides_nothing) {
    EXPECT_EQ(said_of("close", 4000, 2250), "live: close, because it is not baked") << "whatever the size";
    EXPECT_EQ(said_of("house", 640, 188), "live: house, because it is not baked");
    const auto passes = scene::passes_folder(*session_->show, "close");
    std::filesystem::create_directories(passes);
    std::ofstream(passes / "manifest.json") << "{";
    EXPECT_EQ(said_of("close", 4000, 2250),
              "live: close, because its passes have 1280x720 pixels, and the window shows it with 4000x2250");
    EXPECT_FALSE(supply_.is_reading());
    EXPECT_EQ(said_of("house", 640, 188), "live: house, because it is not baked") << "looked at anew";
    EXPECT_EQ(said_of("close", 640, 360).find("1280x720"), std::string::npos) << "it is fine enough";
    std::filesystem::remove_all(passes);
}

} // namespace
} // namespace ghost::app
