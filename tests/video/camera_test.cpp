// SPDX-License-Identifier: Apache-2.0
// What is opened as a camera, and when. Pictures of one: tests/scripts/camera_test.py.
#include "video/capture_consent.h"
#include "video/private/camera.h"
#include "video/source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ghost::video {
namespace {

namespace fs = std::filesystem;

struct CameraTest : testing::Test {
    fs::path folder = fs::path(testing::TempDir()) / "ghost_camera";
    std::string config_before = std::getenv("XDG_CONFIG_HOME") ? std::getenv("XDG_CONFIG_HOME") : "";

    CameraTest() {
        fs::remove_all(folder);
        fs::create_directories(folder);
        setenv("XDG_CONFIG_HOME", (folder / "config").c_str(), 1);
    }
    ~CameraTest() override {
        config_before.empty() ? unsetenv("XDG_CONFIG_HOME")
                              : setenv("XDG_CONFIG_HOME", config_before.c_str(), 1);
    }
    std::string said_of(const fs::path& device) {
        SourceSettings settings;
        settings.name = "eye";
        settings.kind = SourceKind::camera;
        settings.path = device;
        Source source(settings);
        for (int k = 0; k < 1000; ++k) {
            for (const std::string& sentence : source.take_messages()) return sentence;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return "";
    }
};

TEST_F(CameraTest, OnlyVideoDevicesAreOpened) {
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::ofstream(folder / "file") << "text";
    // Opening alone does something to many a device.
    const int opened = ::inotify_init1(IN_NONBLOCK);
    ASSERT_GE(opened, 0);
    for (const fs::path& other : {pipe, folder / "file"})
        ASSERT_GE(::inotify_add_watch(opened, other.c_str(), IN_OPEN), 0);
    for (const fs::path& other : {fs::path("/dev/null"), fs::path("/dev/tty"), pipe, folder / "file"}) {
        const auto camera = Camera::open(other);
        ASSERT_FALSE(camera.ok());
        EXPECT_NE(camera.error().what.find("is no video device"), std::string::npos) << camera.error().text();
    }
    char events[1024];
    EXPECT_LT(::read(opened, events, sizeof events), 0) << "one of them was opened";
    std::ifstream(folder / "file").get();
    EXPECT_GT(::read(opened, events, sizeof events), 0) << "which would have been seen";
    ::close(opened);
}

TEST_F(CameraTest, ADeviceIsOpenedWhenTheUserHasAllowedIt) {
    EXPECT_NE(said_of("/dev/null").find("nobody has allowed"), std::string::npos);
    fs::create_symlink("/dev/null", folder / "link"); // by another name it is the same one
    ASSERT_TRUE(allow_capture(folder / "link").ok());
    EXPECT_TRUE(may_capture("/dev/null"));
    EXPECT_FALSE(may_capture("/dev/video0"));
    EXPECT_NE(said_of("/dev/null").find("is no video device"), std::string::npos);
    ASSERT_TRUE(forbid_capture("/dev/null").ok());
    EXPECT_FALSE(may_capture(folder / "link"));
    EXPECT_NE(said_of(folder / "link").find("nobody has allowed"), std::string::npos);
}

} // namespace
} // namespace ghost::video
